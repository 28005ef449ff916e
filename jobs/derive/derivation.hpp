#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

struct DerivationRequest {
  std::string model;      ///< as ModelSource takes it
  std::string resonance;  ///< one case; empty: all
  /// NAME[:MODE[:OTHER[:FORM]]]: effects of the catalogue that are added to the equations of motion.
  std::vector<std::string> effects;
  std::function<void(std::size_t done, std::size_t total)> progress = {};  ///< steps
};

/// The job `derive`. Throws InputError.
CanonicalModel derive(const DerivationRequest& request);

/// A derivation as it is read: format is text, json, latex (a document that needs amsmath only) or html.
std::string derivation_document(const CanonicalModel& model, const std::string& format);

/// Whether every certificate holds.
bool is_certified(const CanonicalModel& model);

}  // namespace secular
