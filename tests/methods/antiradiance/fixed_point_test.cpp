/// The solver of x = b + M x on matrices whose behaviour is known: none may fail unnoticed.
#include "methods/antiradiance/fixed_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gibench::antiradiance {
namespace {

struct Solved {
  FixedPointOutcome outcome;
  Vector x;
};

/// M has these eigenvalues.
Solved solve(const Vector& eigenvalues, const FixedPointRule& rule = {}) {
  Task task;
  Solved solved;
  const Vector b = Vector::Ones(eigenvalues.size());
  const LinearMap map = [&](const Vector& in, Vector& out) { out = eigenvalues.cwiseProduct(in); };
  solved.outcome = solve_fixed_point(b, map, rule, solved.x, task);
  return solved;
}

void expect_solution(const Solved& solved, const Vector& eigenvalues, float tolerance) {
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
    const float expected = 1.0F / (1.0F - eigenvalues[i]);
    EXPECT_NEAR(solved.x[i], expected, tolerance * std::abs(expected)) << solved.outcome.message;
  }
}

TEST(FixedPoint, SeriesThatFadesIsSummed) {
  const Vector eigenvalues = Vector::LinSpaced(50, -0.6F, 0.6F);
  const Solved solved = solve(eigenvalues);
  EXPECT_EQ(solved.outcome.termination, Termination::converged);
  EXPECT_EQ(solved.outcome.ended_with, Iteration::neumann);
  expect_solution(solved, eigenvalues, 1e-3F);
}

/// Surfaces in line, each of which takes from all behind it what arrives there, in so many units: the terms are (−1)^k C(n, k).
/// Patience lets them swell and fade; what rounding took from their sum is summed anew.
TEST(FixedPoint, SurfacesInLineEndTheSeries) {
  constexpr Eigen::Index surfaces = 20;
  constexpr float units = 32767.0F;
  const LinearMap map = [&](const Vector& in, Vector& out) {
    float sum = 0.0F;
    const float unit = std::max(1e-30F, in.cwiseAbs().maxCoeff()) / units;
    for (Eigen::Index i = 0; i < surfaces; ++i) out[i] = -std::round(sum / unit) * unit, sum += in[i];
  };
  Task task;
  const Vector b = Vector::Ones(surfaces), first_alone = Vector::Unit(surfaces, 0);
  Vector x;
  EXPECT_NE(solve_fixed_point(b, map, {}, x, task).ended_with, Iteration::neumann);
  FixedPointRule rule;
  rule.patience = 64;
  solve_fixed_point(b, map, rule, x, task);
  EXPECT_GT((x - first_alone).cwiseAbs().maxCoeff(), 1.0F);
  rule.rounding = 0.5 / static_cast<double>(units);
  const FixedPointOutcome outcome = solve_fixed_point(b, map, rule, x, task);
  EXPECT_EQ(outcome.termination, Termination::converged) << outcome.message;
  EXPECT_EQ(outcome.ended_with, Iteration::neumann);
  EXPECT_LT((x - first_alone).cwiseAbs().maxCoeff(), 1e-3F);
}

TEST(FixedPoint, NegativeLightThatGrowsIsDamped) {
  const Vector eigenvalues = Vector::LinSpaced(50, -1.8F, 0.3F);
  const Solved solved = solve(eigenvalues);
  EXPECT_EQ(solved.outcome.termination, Termination::converged) << solved.outcome.message;
  EXPECT_EQ(solved.outcome.ended_with, Iteration::damped);
  EXPECT_FALSE(solved.outcome.message.empty());
  expect_solution(solved, eigenvalues, 1e-3F);
}

TEST(FixedPoint, WhatNoSeriesSolvesGoesToKrylov) {
  Vector eigenvalues = Vector::LinSpaced(40, -12.0F, 0.5F);
  eigenvalues[0] = 4.0F;
  const Solved solved = solve(eigenvalues);
  EXPECT_EQ(solved.outcome.termination, Termination::converged) << solved.outcome.message;
  EXPECT_EQ(solved.outcome.ended_with, Iteration::krylov);
  expect_solution(solved, eigenvalues, 2e-2F);
}

TEST(FixedPoint, SlowSeriesGoesToKrylov) {
  const Vector eigenvalues = Vector::LinSpaced(40, 0.0F, 0.995F);
  const Solved solved = solve(eigenvalues);
  EXPECT_EQ(solved.outcome.termination, Termination::converged) << solved.outcome.message;
  EXPECT_EQ(solved.outcome.ended_with, Iteration::krylov);
  expect_solution(solved, eigenvalues, 2e-2F);
}

TEST(FixedPoint, SingularSystemIsReported) {
  const Solved solved = solve(Vector::Ones(4));
  EXPECT_EQ(solved.outcome.termination, Termination::not_converged);
  EXPECT_NE(solved.outcome.message.find("BiCGSTAB"), std::string::npos);
}

/// Wherever a solver is stopped: what it calls converged has the residual that was asked for.
TEST(FixedPoint, ConvergedMeansTheResidualAskedFor) {
  Vector eigenvalues = Vector::LinSpaced(40, -12.0F, 0.9F);
  eigenvalues[0] = 4.0F;
  const Vector b = Vector::Ones(eigenvalues.size());
  int converged = 0, ended = 0;
  for (const double asked : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
    for (int most = 1; most <= 60; ++most) {
      const Solved solved = solve(eigenvalues, {asked, most, 0});
      const Vector left = b + eigenvalues.cwiseProduct(solved.x) - solved.x;
      const double residual = static_cast<double>(left.norm()) / static_cast<double>(solved.x.norm());
      if (solved.outcome.termination == Termination::converged) {
        ++converged;
        EXPECT_LT(residual, 1.01 * asked) << solved.outcome.message;
      } else {
        ++ended;
      }
    }
  EXPECT_GT(converged, 50);
  EXPECT_GT(ended, 50);
}

TEST(FixedPoint, KrylovReachesASmallResidual) {
  const Vector eigenvalues = Vector::LinSpaced(40, 0.0F, 0.995F);
  const Solved solved = solve(eigenvalues, {1e-5, 400, 0});
  EXPECT_EQ(solved.outcome.termination, Termination::converged) << solved.outcome.message;
  expect_solution(solved, eigenvalues, 1e-3F);
}

TEST(FixedPoint, NoLightNeedsNoIteration) {
  Task task;
  Vector x;
  const FixedPointOutcome outcome = solve_fixed_point(
      Vector::Zero(5), [](const Vector&, Vector&) { FAIL(); }, {}, x, task);
  EXPECT_EQ(outcome.termination, Termination::converged);
  EXPECT_EQ(x, Vector::Zero(5));
}

TEST(FixedPoint, TermsAskedForAreCountedOut) {
  const Solved solved = solve(Vector::Constant(3, -1.5F), {1e-4, 200, 3});
  EXPECT_EQ(solved.outcome.termination, Termination::bound_reached);
  EXPECT_FLOAT_EQ(solved.x[0], 1.0F - 1.5F + 2.25F);
}

}  // namespace
}  // namespace gibench::antiradiance
