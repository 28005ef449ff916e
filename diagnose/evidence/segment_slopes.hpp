#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/segment_rows.hpp"

namespace secular {

/// Slopes of segments' rows, as Evidence::slopes(): by offsets of response channels, which no motion depends on, in
/// closed form; by the others by differences of motions that are integrated side by side.
Eigen::MatrixXd segment_slopes(const SegmentRows& rows, const Eigen::VectorXd& unknowns,
                               const std::vector<std::size_t>& which, const Eigen::VectorXd& scale,
                               unsigned threads);

}  // namespace secular
