#include "methods/spectral/eigenvectors.h"

#include <Spectra/SymEigsShiftSolver.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gibench::spectral {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<Sparse>;

constexpr Eigen::Index small = 128;           // rows up to which the dense solver is the faster one
constexpr Eigen::Index dense_share = 3;       // the dense solver for more than a third of the spectrum
constexpr double tolerance = 1e-8;            // of orthonormality and of residuals over the largest eigenvalue
constexpr Eigen::Index largest_subspace = 4;  // of Lanczos vectors over eigenpairs

Sparse shifted(const Sparse& matrix, double shift) {
  Sparse identity(matrix.rows(), matrix.cols());
  identity.setIdentity();
  return matrix - shift * identity;
}

/// (A − σ)⁻¹ for Spectra.
class ShiftInvert {
 public:
  using Scalar = double;
  explicit ShiftInvert(const Sparse& matrix) : matrix_(matrix) {}
  Eigen::Index rows() const { return matrix_.rows(); }
  Eigen::Index cols() const { return matrix_.cols(); }
  void set_shift(double shift) { factors_.compute(shifted(matrix_, shift)); }
  bool factored() const { return factors_.info() == Eigen::Success; }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = factors_.solve(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  const Sparse& matrix_;
  Factors factors_;
};

/// How many eigenvalues lie below: the negative pivots of A − τ. Nothing where it cannot be factored.
std::optional<Eigen::Index> eigenvalues_below(const Sparse& matrix, double value) {
  const Factors factors(shifted(matrix, value));
  if (factors.info() != Eigen::Success) return std::nullopt;
  return (factors.vectorD().array() < 0.0).count();
}

/// Whether no eigenvalue below the widest gap in the upper half of those found was passed over.
bool complete(const Sparse& matrix, const Eigen::VectorXd& values) {
  const Eigen::Index count = values.size();
  if (count < 2) return true;
  Eigen::Index upper = count - 1;
  for (Eigen::Index i = count - 1; i > count / 2; --i)
    if (values[i] - values[i - 1] > values[upper] - values[upper - 1]) upper = i;
  const double gap = values[upper] - values[upper - 1];
  if (!(gap > 1e-12 * values[count - 1])) return false;
  const auto below = eigenvalues_below(matrix, values[upper] - 0.5 * gap);
  return below && *below == upper;
}

/// In absolute value; unlike coeffs() also of a matrix that is not compressed.
double largest_value(const Sparse& matrix) {
  double largest = 0.0;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator entry(matrix, column); entry; ++entry) largest = std::max(largest, std::abs(entry.value()));
  return largest;
}

bool sound(const Sparse& matrix, const Eigenpairs& pairs) {
  const Eigen::Index count = pairs.values.size();
  if (!pairs.values.allFinite() || !pairs.vectors.allFinite()) return false;
  const double apart =
      (pairs.vectors.transpose() * pairs.vectors - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff();
  const double residual = (matrix * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).cwiseAbs().maxCoeff();
  return apart <= tolerance && residual <= tolerance * largest_value(matrix);
}

std::optional<Eigenpairs> by_lanczos(const Sparse& matrix, Eigen::Index count, double shift, Eigen::Index subspace) try {
  ShiftInvert inverse(matrix);
  Spectra::SymEigsShiftSolver<ShiftInvert> solver(inverse, count, std::min(matrix.rows(), subspace), shift);
  if (!inverse.factored()) return std::nullopt;
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-11, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) return std::nullopt;
  Eigenpairs pairs{solver.eigenvalues(), solver.eigenvectors()};
  if (pairs.values.size() != count || !sound(matrix, pairs) || !complete(matrix, pairs.values)) return std::nullopt;
  return pairs;
} catch (const std::runtime_error&) {  // Spectra's word for a small eigenproblem that did not converge
  return std::nullopt;
}

std::optional<Eigenpairs> by_dense_solver(const Sparse& matrix, Eigen::Index count) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(matrix)};
  if (solver.info() != Eigen::Success) return std::nullopt;
  Eigenpairs pairs{solver.eigenvalues().head(count), solver.eigenvectors().leftCols(count), true};
  if (!sound(matrix, pairs)) return std::nullopt;
  return pairs;
}

}  // namespace

std::optional<Eigenpairs> smallest_eigenpairs(const Sparse& matrix, std::uint32_t count) {
  const auto wanted = static_cast<Eigen::Index>(count);
  const Eigen::Index rows = matrix.rows();
  if (rows <= most_dense && (rows <= small || dense_share * wanted > rows)) return by_dense_solver(matrix, wanted);
  // Just below the spectrum, which begins at zero; in units of its mean.
  const double unit = matrix.diagonal().mean();
  int failed = 0;
  for (const double shift : {-1e-3, -1e-2, -1e-4}) {
    const Eigen::Index subspace = std::min(largest_subspace, Eigen::Index{2} + failed) * wanted + 20;
    if (auto pairs = by_lanczos(matrix, wanted, shift * unit, subspace)) {
      pairs->failed_attempts = failed;
      return pairs;
    }
    ++failed;
  }
  if (rows > most_dense) return std::nullopt;
  auto pairs = by_dense_solver(matrix, wanted);
  if (pairs) pairs->failed_attempts = failed;
  return pairs;
}

}  // namespace gibench::spectral
