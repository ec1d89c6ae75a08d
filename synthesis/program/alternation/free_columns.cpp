#include "synthesis/program/alternation/free_columns.h"

#include <Eigen/QR>

namespace mechwright {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd by_free_dimensions(const Problem& problem, const Reads& reads, const MatrixXd& slopes) {
    MatrixXd by_dimension = MatrixXd::Zero(slopes.rows(), static_cast<Index>(problem.dimensions.size()));
    for (std::size_t i = 0; i < reads.size(); ++i) {
        const DimensionRange& range = problem.dimensions[reads[i]];
        const auto slope = slopes.col(static_cast<Index>(i));
        for (const auto& [other, times] : range.tie.terms)
            by_dimension.col(static_cast<Index>(other)) += times * slope;
        if (!range.fixed() && !range.tied()) by_dimension.col(static_cast<Index>(reads[i])) += slope;
    }
    for (Index k = 0; k < by_dimension.cols(); ++k)
        if (problem.dimensions[static_cast<std::size_t>(k)].fixed()) by_dimension.col(k).setZero();
    return by_dimension;
}

void scale_columns(MatrixXd& slopes) {
    for (Index k = 0; k < slopes.cols(); ++k) {
        const double norm = slopes.col(k).norm();
        if (norm > 0) slopes.col(k) /= norm;
    }
}

int independent_columns(MatrixXd slopes) {
    constexpr double independent_beyond = 1e-7;
    scale_columns(slopes);
    Eigen::ColPivHouseholderQR<MatrixXd> columns(slopes);
    columns.setThreshold(independent_beyond);
    return static_cast<int>(columns.rank());
}

}  // namespace mechwright
