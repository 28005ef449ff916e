#include "jobs/shared/model_loading.hpp"

#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/expansion_sizes.hpp"
#include "codegen/runtime/runtime_model.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "jobs/shared/install_layout.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "perturb/model.hpp"
#include "perturb/rest_position.hpp"
#include "perturb/with_effects.hpp"

namespace secular {

namespace fs = std::filesystem;

std::vector<fs::path> header_folders() {
  std::vector<fs::path> folders;
  if (const fs::path program = program_folder(); !program.empty())
    folders.push_back((program / headers_from_program_folder).lexically_normal());
  folders.emplace_back(headers_in_source_tree);
  return folders;
}

ModelText model_text(const std::string& model) {
  if (model.find('\n') != std::string::npos) return {"the model", model};
  const fs::path file = resolve_model(model);
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(file.string(), "", "cannot be opened for reading", "check the path and its permissions");
  return {file.string(), {std::istreambuf_iterator<char>(stream), {}}};
}

ModelSource::ModelSource(const std::string& model, bool interpret, NoteSink note, const EffectCatalogue& catalogue)
    : interpret_(interpret), note_(std::move(note)), catalogue_(catalogue) {
  if (!interpret) compiled_in_ = generated::find_compiled_model(model);
  if (compiled_in_) {
    outline(*compiled_in_);
    return;
  }
  text_ = model_text(model);
  outline_text();
}

void ModelSource::outline(const CompiledModel& model) {
  name_ = model.name;
  modes_ = model.modes();
  const std::size_t columns = modes_ + model.excitations.size();
  nominal_frequencies_.assign(model.nominal.begin(), model.nominal.begin() + static_cast<std::ptrdiff_t>(modes_));
  nominal_frequencies_.resize(columns, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < modes_; ++k) frequency_names_.emplace_back(model.symbols[k].name);
  for (const CompiledCase& resonance : model.cases) {
    CaseOutline outline{std::string(resonance.name), resonance.excited, 0, {}};
    for (const bool rest : resonance.mode_at_rest) outline.active_modes += rest ? 0 : 1;
    for (std::size_t r = 0; r < resonance.relations.size(); r += columns) {
      const auto row = resonance.relations.subspan(r, columns);
      outline.relations.emplace_back(row.begin(), row.end());
    }
    cases_.push_back(std::move(outline));
  }
}

void ModelSource::outline_text() {
  const Model model = read_model_text(text_->text, text_->name);
  const CompiledModel* const namesake = interpret_ ? nullptr : generated::find_compiled_model(model.name);
  if (namesake && namesake->fingerprint == canonical_model(model, {}, CanonicalContent::code).fingerprint) {
    compiled_in_ = namesake;
    outline(*namesake);
    return;
  }
  name_ = model.name;
  about_rest_ = model.rest != nullptr;
  modes_ = model.modes.size();
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    const auto value = model.nominal.find(model.frequency_name(i));
    nominal_frequencies_.push_back(value == model.nominal.end() ? std::numeric_limits<double>::quiet_NaN()
                                                                : value->second);
  }
  for (std::size_t k = 0; k < modes_; ++k) frequency_names_.push_back(model.frequency_name(k));
  for (const ResonanceCase& resonance : model.cases) {
    CaseOutline outline{resonance.name, resonance.excited, 0, {}};
    for (std::size_t k = 0; k < modes_; ++k)
      outline.active_modes += k < resonance.mode_at_rest.size() && resonance.mode_at_rest[k] ? 0U : 1U;
    for (const ResonanceRelation& relation : resonance.relations) {
      outline.relations.push_back(relation.multiples);
      outline.relations.back().resize(model.frequency_count(), 0);
    }
    cases_.push_back(std::move(outline));
  }
}

const std::string& ModelSource::case_named(const std::string& wanted) const {
  if (wanted.empty() && cases_.size() == 1) return cases_.front().name;
  std::vector<std::string> names;
  for (const CaseOutline& outline : cases_) {
    if (outline.name == wanted) return outline.name;
    names.push_back(outline.name);
  }
  const std::string known = fmt::format("its cases are {}", fmt::join(names, ", "));
  if (wanted.empty()) throw InputError("--case", "", "is missing: model " + name_ + " has several", known);
  throw InputError("--case " + wanted, "", "is no case of model " + name_, remedy_for_word(known, wanted, names));
}

LoadedCase ModelSource::load_case(const std::string& wanted) const {
  const std::string& name = case_named(wanted);
  LoadedCase loaded{load({name}), nullptr};
  loaded.resonance = &secular::case_named(*loaded.model, name);
  return loaded;
}

std::shared_ptr<const CompiledModel> ModelSource::load(const std::vector<std::string>& cases) const {
  if (compiled_in_) return {std::shared_ptr<void>(), compiled_in_};
  return load_text(*text_, cases, {});
}

std::vector<std::string> ModelSource::following_names() const {
  std::vector<std::string> names;
  if (!about_rest_) return names;
  const Model read = model();
  for (const HeldCoefficient& held : read.rest->held) names.push_back(held.name);
  return names;
}

void ModelSource::take_rest_position(std::map<std::string, double>& values, const std::string& where) const {
  if (!about_rest_) return;
  const std::string found = secular::take_rest_position(model(), values, where);
  if (!found.empty() && note_) note_(found);
}

std::vector<FollowingCoefficient> ModelSource::following_coefficients(
    const std::map<std::string, double>& values) const {
  if (!about_rest_) return {};
  return secular::following_coefficients(model(), values);
}

ExpansionSizes ModelSource::expansion_sizes(const std::string& resonance) const {
  const CanonicalModel derived = canonical_model(model(), resonance);
  return {derived, derived.cases.at(0)};
}

AugmentedCompiledModel ModelSource::load_with_effects(std::span<const EffectTerm> effects,
                                                      const std::vector<std::string>& cases) const {
  if (effects.empty()) return {load(cases), {}};
  const ModelText read = text();
  std::vector<AddedEffect> added = with_effects(read_model_text(read.text, read.name), effects, catalogue_).effects;
  return {load_text(read, cases, effects), std::move(added)};
}

std::vector<EffectTerm> ModelSource::applicable_effects() const {
  return secular::applicable_effects(model(), catalogue_);
}

std::vector<EffectTerm> ModelSource::open_law_terms() const {
  return secular::open_law_terms(model(), catalogue_);
}

EffectTerm ModelSource::effect_term(const std::string& text) const {
  return parse_effect_term(text, model(), catalogue_);
}

ModelText ModelSource::text() const {
  return text_ ? *text_ : model_text(name_);
}

Model ModelSource::model() const {
  const ModelText read = text();
  return read_model_text(read.text, read.name);
}

std::shared_ptr<const CompiledModel> ModelSource::load_text(const ModelText& text,
                                                            const std::vector<std::string>& cases,
                                                            std::span<const EffectTerm> effects) const {
  RuntimeModelOptions options;
  options.cases = cases;
  options.effects.assign(effects.begin(), effects.end());
  options.catalogue = catalogue_;
  options.interpret = interpret_;
  options.header_folders = header_folders();
  RuntimeModel loaded = load_runtime_model_text(text.text, text.name, options);
  for (const std::string& note : loaded.notes)
    if (note_) note_(note);
  return std::move(loaded.model);
}

}  // namespace secular
