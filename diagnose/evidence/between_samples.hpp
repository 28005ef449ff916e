#pragma once

#include <Eigen/Core>

#include "diagnose/evidence/segment_rows.hpp"

namespace secular {

/// As it would be if its excitation were stronger by this share of itself, or later by this time, all of it halfway
/// between the samples: readings at the samples are what they are (docs/inference.md (42)).
Segment stronger_between_samples(Segment segment, double share);
Segment later_between_samples(Segment segment, double late_s);

/// Columns by which the rows of blows move with one standard deviation of either, as Evidence::between_samples().
Eigen::MatrixXd between_samples_columns(const SegmentRows& rows, const Eigen::VectorXd& unknowns,
                                        const BetweenSamples& of_blows);

}  // namespace secular
