#pragma once

#include "jobs/identify/identification.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::testing_support {

/// What the primary resonance of `duffing` tells of a campaign in memory.
inline Identification identified_primary(const SimulatedCampaign& made) {
  IdentificationRequest request;
  request.model = "duffing";
  request.resonances = {"primary"};
  return identify_by_modulation(request, made.campaign, [&](std::size_t r) { return made.samples[r]; });
}

}  // namespace secular::testing_support
