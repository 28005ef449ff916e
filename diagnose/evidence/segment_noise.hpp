#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "diagnose/evidence/left_of_segment.hpp"
#include "diagnose/evidence/noise_bands.hpp"

namespace secular {

/// What a segment repeats to, in units of its channels' noise. Over a long decay the first rows follow a smooth law
/// of the amplitude, whatever the model lacks: how rough they are from segment to segment is their repeatability (a
/// clock that is not even, a knock), where that is more than the noise explains. That of the other rows is what a
/// quarter of the segments stays below: what a model lacks grows and falls with the amplitude. Where they come and
/// go from segment to segment by no law of the amplitude, the record is disturbed, and no segment's other rows
/// count for more than they hold.
struct SegmentNoise {
  Eigen::VectorXd change_sd;                            ///< of the first rows
  double rest_sd = 1;                                   ///< of the others where they are white
  std::shared_ptr<const NoiseInCosines> coloured = {};  ///< else
  double disturbance = 0;  ///< of a disturbed record what the other rows hold, in units of noise; else 0

  double white_sd() const { return coloured ? coloured->least : rest_sd; }
  /// Errors beside the first rows in units of noise.
  void whiten(const Eigen::VectorXd& error, Eigen::Ref<Eigen::VectorXd> rest) const;
};

/// Of the segments of one record. `coloured`: noise_of_decays().
SegmentNoise noise_of_record(std::span<const FrozenSegment> segments, std::span<const LeftOfSegment> left,
                             std::shared_ptr<const NoiseInCosines> coloured);

/// By segment of one record: what its other rows hold, in units of its noise, where the record is disturbed; else
/// 0.
std::vector<double> disturbances(std::span<const LeftOfSegment> left, const SegmentNoise& noise);

/// Of all segments, by what unknowns leave of them: no trial before them has a part in it. Only how the first rows
/// repeat from segment to segment, which a few segments tell roughly, is the largest since errors were wide: an
/// explanation that fits better does not take it back. `before`: of the segments since then; empty: none.
std::vector<SegmentNoise> noise_of_segments(std::span<const FrozenSegment> segments,
                                            std::span<const LeftOfSegment> left,
                                            const Eigen::VectorXd& natural_frequency,
                                            std::span<const SegmentNoise> before);

/// Of decays in one piece, whose numbers are told by what is at the motion's frequencies: white noise is what noise
/// beside these is (docs/inference.md (66)), where that is more.
void widen_to_noise_beside_motion(std::span<const FrozenSegment> segments, std::span<const LeftOfSegment> left,
                                  const Eigen::VectorXd& natural_frequency, std::vector<SegmentNoise>& noise);

}  // namespace secular
