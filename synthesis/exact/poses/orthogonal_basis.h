#pragma once
/// \file
/// The orthogonal factor of small decompositions.

#include <Eigen/QR>

namespace mechwright {

/// The whole of Q, rows x rows: its last columns are a basis of what is square to the decomposed columns. Reflection by
/// reflection (Golub and Van Loan, Matrix Computations, 5.1.6), as `householderQ` does for matrices of this size; that
/// also brings the arithmetic of large ones, in blocks, which takes far longer to compile than all who call this.
template <int rows, int columns>
Eigen::Matrix<double, rows, rows> orthogonal_basis(
    const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, rows, columns>>& qr) {
    Eigen::Matrix<double, rows, rows> basis = Eigen::Matrix<double, rows, rows>::Identity();
    Eigen::Matrix<double, rows, 1> workspace;
    for (Eigen::Index k = columns - 1; k >= 0; --k) {
        const Eigen::Index left = rows - k;
        basis.bottomRightCorner(left, left)
            .applyHouseholderOnTheLeft(qr.matrixQR().col(k).tail(left - 1), qr.hCoeffs()[k], workspace.data());
    }
    return basis;
}

}  // namespace mechwright
