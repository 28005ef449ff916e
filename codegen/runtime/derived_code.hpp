#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/cpp/emit_cpp.hpp"
#include "codegen/runtime/model_cache.hpp"
#include "perturb/effect_catalogue.hpp"

namespace secular {

/// A model file's text with the cases that are wanted of it (nothing: all) and effects added to its equations of
/// motion (see with_effects).
struct ModelRequest {
  std::string file, text;
  std::optional<std::vector<std::string>> cases;
  std::vector<EffectTerm> effects;
  EffectCatalogue catalogue = effect_catalogue();
};

/// The canonical model of a request, without cases that no code can be made of; these are named in `notes`. A case
/// that was asked for by name and cannot be emitted is an InputError, one whose certificate does not hold a
/// NumericalFailure.
CanonicalModel derive_for_code(const ModelRequest& request, std::vector<std::string>& notes);

/// The same for interpretation: from the cache, or derived and put there; see canonical_json for what is kept.
CanonicalModel cached_model(const ModelRequest& request, const ModelCache& cache, std::vector<std::string>& notes);

/// Code of a model (emit_cpp_units), as it is kept in the cache.
struct DerivedCode {
  std::string model_name;
  std::vector<GeneratedUnit> units;
  std::vector<std::string> notes;
};

/// From the cache, or derived, emitted and put there.
DerivedCode derived_code(const ModelRequest& request, const ModelCache& cache);

}  // namespace secular
