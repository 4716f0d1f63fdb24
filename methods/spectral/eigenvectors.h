/// The smallest eigenpairs of a symmetric matrix, checked, by one way or another.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>

namespace gibench::spectral {

struct Eigenpairs {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< orthonormal columns
  bool dense = false;       ///< by the dense solver
  int failed_attempts = 0;  ///< of the Lanczos solver before
};

/// The `count` smallest eigenpairs of a positive semidefinite matrix, multiplicities included. Small matrices and large
/// shares of the spectrum go to Eigen's dense solver. Else Spectra's shift-invert Lanczos; its answer counts when the
/// vectors are orthonormal, the residuals vanish, and the inertia of the shifted matrix (Sylvester) says that no
/// eigenvalue was passed over. Where it does not: another shift and a larger subspace, twice; then the dense solver
/// for up to `most_dense` rows; then nothing.
std::optional<Eigenpairs> smallest_eigenpairs(const Eigen::SparseMatrix<double>& matrix, std::uint32_t count);

inline constexpr Eigen::Index most_dense = 4096;

}  // namespace gibench::spectral
