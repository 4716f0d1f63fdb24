#include "methods/antiradiance/fixed_point.h"

#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/finite_elements/bounce_series.h"

namespace gibench::antiradiance {

/// I − M as a matrix without entries.
class MatrixFree;

}  // namespace gibench::antiradiance

namespace Eigen::internal {
template <>
struct traits<gibench::antiradiance::MatrixFree> : traits<SparseMatrix<float>> {};
}  // namespace Eigen::internal

namespace gibench::antiradiance {

class MatrixFree : public Eigen::EigenBase<MatrixFree> {
 public:
  using Scalar = float;
  using RealScalar = float;
  using StorageIndex = int;
  static constexpr int ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic;
  static constexpr bool IsRowMajor = false;

  MatrixFree(const LinearMap& map, Eigen::Index size) : map_(map), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }

  template <class Right>
  Eigen::Product<MatrixFree, Right, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Right>& right) const {
    return {*this, right.derived()};
  }

  void apply(const Vector& in, Vector& out) const {
    map_(in, out);
    out = in - out;
    ++applications;
  }

  mutable int applications = 0;

 private:
  const LinearMap& map_;
  Eigen::Index size_;
};

}  // namespace gibench::antiradiance

namespace Eigen::internal {
template <class Right>
struct generic_product_impl<gibench::antiradiance::MatrixFree, Right, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<gibench::antiradiance::MatrixFree, Right,
                                generic_product_impl<gibench::antiradiance::MatrixFree, Right>> {
  template <class Destination>
  static void scaleAndAddTo(Destination& destination, const gibench::antiradiance::MatrixFree& matrix, const Right& right,
                            const float& alpha) {
    gibench::antiradiance::Vector product(destination.size());
    matrix.apply(right, product);
    destination.noalias() += alpha * product;
  }
};
}  // namespace Eigen::internal

namespace gibench::antiradiance {

namespace {

constexpr std::size_t patience_with_steps = 8;  // that are damped
constexpr double hopeless = 1e6;                // a residual at which no series comes back
constexpr int krylov_starts = 8, series_starts = 6;

/// What a series of residuals says about what is to come.
class Trend {
 public:
  explicit Trend(std::size_t patience) : patience_(patience) {}
  void add(double residual) { residuals_.push_back(residual); }
  bool grows() const {
    if (!std::isfinite(residuals_.back()) || residuals_.back() > hopeless) return true;
    return residuals_.size() > patience_ && residuals_.back() > residuals_[residuals_.size() - 1 - patience_];
  }
  /// Steps still to go at the rate of the last ones; 0 while that is not known.
  double steps_left(double goal) const {
    if (residuals_.size() <= patience_) return 0.0;
    const double rate =
        std::log(residuals_.back() / residuals_[residuals_.size() - 1 - patience_]) / static_cast<double>(patience_);
    return rate < 0.0 ? std::log(goal / residuals_.back()) / rate : 1e9;
  }

 private:
  std::size_t patience_;
  std::vector<double> residuals_;
};

class Solver {
 public:
  Solver(const Vector& b, const LinearMap& map, const FixedPointRule& rule, Vector& x, Task& task)
      : b_(b), map_(map), rule_(rule), x_(x), task_(task), size_of_b_(static_cast<double>(b.norm())) {}

  FixedPointOutcome run() {
    x_ = b_;
    if (!(size_of_b_ > 0.0)) return outcome_;
    if (rule_.exactly > 0) return terms(rule_.exactly);
    if (series()) return outcome_;
    if (rule_.series_only) {
      outcome_.termination = Termination::not_converged;
      return outcome_;
    }
    const std::string first = outcome_.message;
    if (damped()) {
      outcome_.message = fmt::format("{}; damped steps converged", first);
      return outcome_;
    }
    const std::string second = outcome_.message;
    krylov(first + "; " + second);
    return outcome_;
  }

 private:
  FixedPointOutcome terms(int count) {
    Vector term = b_, next(b_.size());
    for (int k = 1; k < count && !task_.cancelled(); ++k) {
      step(term, next, k);
      term.swap(next);
      x_ += term;
    }
    outcome_.termination = Termination::bound_reached;
    outcome_.message = fmt::format("stopped after {} iterations as asked, residual {:.2e}", count, outcome_.residual);
    return outcome_;
  }

  /// One more term; its size over that of the solution is the residual.
  void step(const Vector& term, Vector& next, int number) {
    map_(term, next);
    ++outcome_.applications;
    tell("iteration", number, static_cast<double>(next.norm()) / std::max(1e-30, static_cast<double>(x_.norm())));
  }

  void tell(const char* what, int number, double residual) {
    outcome_.residual = residual;
    task_.progress(fmt::format("{} {}", what, number), progress_of(residual, rule_.residual), residual);
  }

  /// Of terms that swell before they fade M rounds off more than the sum may lack: what the sum leaves of the equation is summed
  /// in turn.
  bool series() {
    x_.setZero();
    Vector left = b_;
    double before = std::numeric_limits<double>::infinity();
    for (int start = 0; start < series_starts; ++start) {
      double largest = 0.0;
      if (!sum_terms(left, largest)) return false;
      const auto size = static_cast<double>(x_.norm());
      if (rule_.rounding * largest <= rule_.residual * size || task_.cancelled()) return true;
      map_(x_, left);
      ++outcome_.applications;
      left += b_ - x_;
      const double residual = static_cast<double>(left.norm()) / std::max(1e-30, size);
      tell("series anew", start + 1, residual);
      if (residual < rule_.residual) return true;
      if (!(residual < 0.5 * before)) break;
      before = residual;
    }
    outcome_.message = fmt::format("the series' terms swell until rounding leaves a residual of {:.2e}", outcome_.residual);
    return false;
  }

  /// Adds the series of `first` to the solution; `largest`: norm of a term.
  bool sum_terms(const Vector& first, double& largest) {
    Vector term = first, next(b_.size());
    x_ += term;
    largest = static_cast<double>(term.norm());
    Trend trend(rule_.patience);
    for (int k = 1; k <= rule_.most_iterations; ++k) {
      if (task_.cancelled()) return true;
      step(term, next, k);
      term.swap(next);
      x_ += term;
      largest = std::max(largest, static_cast<double>(term.norm()));
      if (outcome_.residual < rule_.residual) return true;
      trend.add(outcome_.residual);
      const bool grows = trend.grows() || rule_.rounding * largest > size_of_b_;
      if (grows || trend.steps_left(rule_.residual) > 0.5 * rule_.most_iterations) {
        outcome_.message =
            fmt::format("the series {} after {} iterations (residual {:.2e})", grows ? "grew" : "was slow", k, outcome_.residual);
        return false;
      }
    }
    outcome_.message = fmt::format("the series did not end in {} iterations", rule_.most_iterations);
    return false;
  }

  bool damped() {
    outcome_.ended_with = Iteration::damped;
    x_ = b_;
    Vector image(b_.size());
    Trend trend(patience_with_steps);
    for (int k = 1; k <= rule_.most_iterations; ++k) {
      if (task_.cancelled()) return true;
      map_(x_, image);
      ++outcome_.applications;
      image += b_ - x_;
      tell("damped iteration", k, static_cast<double>(image.norm()) / std::max(1e-30, static_cast<double>(x_.norm())));
      if (outcome_.residual < rule_.residual) return true;
      x_ += 0.5F * image;
      trend.add(outcome_.residual);
      if (trend.grows() || trend.steps_left(rule_.residual) > 0.25 * rule_.most_iterations) {
        outcome_.message =
            fmt::format("damped steps {} after {} (residual {:.2e})", trend.grows() ? "grew" : "were slow", k, outcome_.residual);
        return false;
      }
    }
    outcome_.message = fmt::format("damped steps did not end in {} iterations", rule_.most_iterations);
    return false;
  }

  /// In single precision the residual that BiCGSTAB carries along parts from that of the equation: it starts again on what is
  /// left of that, for as long as it becomes less.
  void krylov(const std::string& tried) {
    outcome_.ended_with = Iteration::krylov;
    const MatrixFree matrix(map_, b_.size());
    Eigen::BiCGSTAB<MatrixFree, Eigen::IdentityPreconditioner> solver;
    solver.compute(matrix);
    x_.setZero();
    Vector left = b_;  // b + M x − x
    double size = size_of_b_, residual = std::numeric_limits<double>::infinity();
    int steps = 0;
    for (int start = 0; start < krylov_starts && steps < rule_.most_iterations && !task_.cancelled(); ++start) {
      const double goal = rule_.residual * (start == 0 ? size_of_b_ : smaller_size());
      solver.setTolerance(static_cast<float>(std::min(0.5, 0.5 * goal / size)));
      solver.setMaxIterations(rule_.most_iterations - steps);
      const Vector correction = solver.solve(left);
      steps += std::max(1, static_cast<int>(solver.iterations()));
      if (!correction.allFinite()) break;
      x_ += correction;
      map_(x_, left);
      ++outcome_.applications;
      left += b_ - x_;
      size = static_cast<double>(left.norm());
      const double now = size / std::max(1e-30, smaller_size());
      if (!(now < residual)) {
        x_ -= correction;
        break;
      }
      residual = now;
      tell("Krylov iteration", steps, residual);
      if (residual < rule_.residual) break;
    }
    outcome_.applications += matrix.applications;
    if (residual < rule_.residual) {
      outcome_.message = fmt::format("{}; BiCGSTAB converged in {} iterations", tried, steps);
      return;
    }
    outcome_.termination = Termination::not_converged;
    outcome_.message = fmt::format("{}; BiCGSTAB ended with residual {:.2e} after {} iterations", tried, residual, steps);
  }

  double smaller_size() const { return std::min(size_of_b_, static_cast<double>(x_.norm())); }

  const Vector& b_;
  const LinearMap& map_;
  const FixedPointRule& rule_;
  Vector& x_;
  Task& task_;
  double size_of_b_;
  FixedPointOutcome outcome_;
};

}  // namespace

FixedPointOutcome solve_fixed_point(const Vector& b, const LinearMap& map, const FixedPointRule& rule, Vector& x, Task& task) {
  return Solver(b, map, rule, x, task).run();
}

}  // namespace gibench::antiradiance
