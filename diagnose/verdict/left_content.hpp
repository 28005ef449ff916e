#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

/// Kinds of disturbances that it may be.
inline constexpr std::string_view wander_kind = "offset_wander", tone_kind = "foreign_tone",
                                  ring_kind = "neighbour_mode", colour_kind = "coloured_noise";

/// What was found beside the motion of records that are compared sample by sample.
struct ForeignContent {
  std::vector<Disturbance> found;  ///< in the records themselves, then in what the model left of them
  ForeignTones ringing;            ///< of modes that the model does not have
  ColouredNoises coloured;
};

/// What the fit allows for from now on: zeros that wander, tones, rings and coloured noise.
void allow_for(const ForeignContent& content, const Campaign& campaign, DiagnosisOptions& options);

/// Adds what no missing term of the equations makes of what the model leaves (docs/inference.md (36)); how much was
/// found. `compared`: in the samples that are compared; `records`: in those one behind the other, in which lines
/// are looked for (left_of_records()).
std::size_t find_left_content(const std::vector<SegmentEvidence::Left>& compared,
                              const std::vector<SegmentEvidence::Left>& records, const Campaign& campaign,
                              ForeignContent& content);

}  // namespace secular
