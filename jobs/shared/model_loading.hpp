#pragma once

#include <complex>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codegen/runtime/expansion_sizes.hpp"
#include "estimator/model/compiled_model.hpp"
#include "perturb/effect_catalogue.hpp"
#include "perturb/following_coefficient.hpp"

namespace secular {

struct Model;

/// The text of a model file, and what messages call it.
struct ModelText {
  std::string name, text;
};

/// `model`: as ModelSource takes it. Throws InputError.
ModelText model_text(const std::string& model);

/// What tells a case's resonance, known before anything is derived.
struct CaseOutline {
  std::string name;
  bool excited = true;
  std::size_t active_modes = 0;  ///< not in modes_at_rest
  /// Integer relations over the natural frequencies and then the excitations' frequencies.
  std::vector<std::vector<int>> relations;
};

/// A model with effects added to its equations of motion: code, and what each effect brought.
struct AugmentedCompiledModel {
  std::shared_ptr<const CompiledModel> model;
  std::vector<AddedEffect> effects;
};

/// A model with one of its cases, which it holds.
struct LoadedCase {
  std::shared_ptr<const CompiledModel> model;
  const CompiledCase* resonance = nullptr;
};

/// Takes a line that a user should know of, as soon as it is known.
using NoteSink = std::function<void(const std::string&)>;

/// A model by name, file or text, and how to get code for it: a model that is compiled into this program as it is,
/// any other derived, compiled and loaded at run time (see codegen/runtime/runtime_model.hpp).
class ModelSource {
 public:
  /// `model`: a path, the name of a shipped model, or the text of a model file, which has several lines.
  /// `interpret`: never use compiled code. `note`: gets what there is to say of the loading. `catalogue`: of all
  /// effects that are asked for. Throws InputError.
  ModelSource(const std::string& model, bool interpret, NoteSink note,
              const EffectCatalogue& catalogue = effect_catalogue());

  const std::string& name() const { return name_; }
  const std::vector<CaseOutline>& cases() const { return cases_; }
  /// By mode and then by excitation frequency; NaN where the model gives none.
  const std::vector<double>& nominal_frequencies() const { return nominal_frequencies_; }
  std::size_t modes() const { return modes_; }
  /// Of the natural frequencies, by mode.
  const std::vector<std::string>& frequency_names() const { return frequency_names_; }

  /// The name of a case: `wanted`, without it that of the only one. Throws InputError that lists the cases.
  const std::string& case_named(const std::string& wanted) const;

  /// The model with the named cases (at least).
  std::shared_ptr<const CompiledModel> load(const std::vector<std::string>& cases) const;
  /// The model with case_named(wanted).
  LoadedCase load_case(const std::string& wanted) const;

  /// Of a model about its rest position: the coefficients that its file states in place of some of its symbols.
  std::vector<std::string> following_names() const;
  /// See secular::take_rest_position, and a note of what it found; nothing for a model whose coordinates count from
  /// zero.
  void take_rest_position(std::map<std::string, double>& values, const std::string& where) const;
  /// See secular::following_coefficients.
  std::vector<FollowingCoefficient> following_coefficients(const std::map<std::string, double>& values) const;

  /// Of one case, which is derived from the model's file.
  ExpansionSizes expansion_sizes(const std::string& resonance) const;

  /// The model with effects of the catalogue (see with_effects) and the named cases; none: equations of motion
  /// alone, which compile fast. Always derived at run time from the model's file.
  AugmentedCompiledModel load_with_effects(std::span<const EffectTerm> effects,
                                           const std::vector<std::string>& cases) const;
  /// See secular::applicable_effects and secular::open_law_terms; they read the model's file.
  std::vector<EffectTerm> applicable_effects() const;
  std::vector<EffectTerm> open_law_terms() const;
  /// NAME[:MODE[:OTHER[:FORM]]], see parse_effect_term.
  EffectTerm effect_term(const std::string& text) const;

 private:
  void outline(const CompiledModel& model);
  void outline_text();
  std::shared_ptr<const CompiledModel> load_text(const ModelText& text, const std::vector<std::string>& cases,
                                                 std::span<const EffectTerm> effects) const;
  ModelText text() const;
  Model model() const;

  std::string name_;
  std::optional<ModelText> text_;
  const CompiledModel* compiled_in_ = nullptr;
  bool interpret_ = false;
  bool about_rest_ = false;
  NoteSink note_;
  EffectCatalogue catalogue_;
  std::size_t modes_ = 0;
  std::vector<CaseOutline> cases_;
  std::vector<double> nominal_frequencies_;
  std::vector<std::string> frequency_names_;
};

/// Folders that may hold the headers of generated code: beside the installed program, in the source tree.
std::vector<std::filesystem::path> header_folders();

}  // namespace secular
