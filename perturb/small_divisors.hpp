#pragma once

#include <string>
#include <vector>

#include "perturb/derivation.hpp"

namespace secular {

/// Terms of the response that are nearly resonant at the model's nominal frequencies, |1 - |phase.f|/omega_k| < 5
/// %, one sentence each with the relation that the case lacks. Nothing for frequencies without a nominal value.
std::vector<std::string> small_divisor_warnings(const Derivation& derivation);

}  // namespace secular
