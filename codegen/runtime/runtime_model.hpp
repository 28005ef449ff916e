#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "perturb/effect_catalogue.hpp"

namespace secular {

/// How a model file that is not compiled into the program becomes a CompiledModel.
struct RuntimeModelOptions {
  /// Cases to derive, by name; nothing: all that can be emitted. Empty: equations of motion alone.
  std::optional<std::vector<std::string>> cases;
  std::vector<EffectTerm> effects;                 ///< added to the equations of motion, see with_effects
  EffectCatalogue catalogue = effect_catalogue();  ///< holds them
  bool interpret = false;                          ///< never start a compiler
  /// First one that holds estimator/model/compiled_model.hpp is used.
  std::vector<std::filesystem::path> header_folders;
  std::optional<std::filesystem::path> cache_folder;  ///< instead of the user's
};

struct RuntimeModel {
  enum class Origin { cached, compiled, interpreted };
  std::shared_ptr<const CompiledModel> model;
  Origin origin = Origin::interpreted;
  std::vector<std::string> notes;  ///< one line each, for standard error: cases left out, why it is interpreted
};

/// Derives, emits, compiles and loads the model, each step only if the cache does not hold its result: the
/// derivation is keyed by the model's text, the cases and this program's build, the shared object by the code, the
/// headers it includes, the compiler, its options and compiled_model_abi(). Without a compiler, or where its result
/// cannot be loaded, the model is interpreted, from a derivation that is cached likewise. Throws InputError for
/// what is wrong with the model, a case named in `options.cases` that cannot be emitted included; among all cases
/// such a one is left out with a note. Throws NumericalFailure where a certificate does not hold.
RuntimeModel load_runtime_model(const std::filesystem::path& file, const RuntimeModelOptions& options);
/// The same of a text that is in no file; `name`: what messages call it.
RuntimeModel load_runtime_model_text(const std::string& text, const std::string& name,
                                     const RuntimeModelOptions& options);

}  // namespace secular
