#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// `wanted`, with underscores appended until nothing in the model and nothing in its derivation has that name.
std::string free_name(const CanonicalModel& model, std::string wanted);

/// Name of the frequency at which a mode is observed: omega_obs, omega_obs_v among several modes.
std::string observed_frequency_name(const CanonicalModel& model, std::size_t mode);

}  // namespace secular
