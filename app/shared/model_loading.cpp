#include "app/shared/model_loading.hpp"

#include <fmt/format.h>

#include <limits>
#include <system_error>

#include "app/shared/install_layout.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/shipped_models.hpp"
#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/expansion_sizes.hpp"
#include "codegen/runtime/runtime_model.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "perturb/model.hpp"
#include "perturb/with_effects.hpp"

namespace secular::app {

namespace fs = std::filesystem;

std::vector<fs::path> header_folders() {
  std::vector<fs::path> folders;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back((program.parent_path() / headers_from_program_folder).lexically_normal());
  folders.emplace_back(headers_in_source_tree);
  return folders;
}

ModelSource::ModelSource(const std::string& name_or_path, bool interpret, const EffectCatalogue& catalogue)
    : interpret_(interpret), catalogue_(catalogue) {
  if (!interpret) compiled_in_ = generated::find_compiled_model(name_or_path);
  if (compiled_in_) {
    outline(*compiled_in_);
    return;
  }
  file_ = resolve_model(name_or_path);
  outline_file();
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

void ModelSource::outline_file() {
  const Model model = read_model(file_);
  const CompiledModel* const namesake = interpret_ ? nullptr : generated::find_compiled_model(model.name);
  if (namesake && namesake->fingerprint == canonical_model(model, {}, CanonicalContent::code).fingerprint) {
    compiled_in_ = namesake;
    outline(*namesake);
    return;
  }
  name_ = model.name;
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
  std::string known;
  for (const CaseOutline& outline : cases_) {
    if (outline.name == wanted) return outline.name;
    known += (known.empty() ? "" : ", ") + outline.name;
  }
  throw InputError("--case " + wanted, "", "is no case of model " + name_, "its cases are " + known);
}

LoadedCase ModelSource::load_case(const std::string& wanted) const {
  const std::string& name = case_named(wanted);
  LoadedCase loaded{load({name}), nullptr};
  loaded.resonance = &secular::case_named(*loaded.model, name);
  return loaded;
}

std::shared_ptr<const CompiledModel> ModelSource::load(const std::vector<std::string>& cases) const {
  if (compiled_in_) return {std::shared_ptr<void>(), compiled_in_};
  return load_file(file_, cases, {});
}

ExpansionSizes ModelSource::expansion_sizes(const std::string& resonance) const {
  const CanonicalModel model = canonical_model(read_model(model_file()), resonance);
  return {model, model.cases.at(0)};
}

AugmentedCompiledModel ModelSource::load_with_effects(std::span<const EffectTerm> effects,
                                                      const std::vector<std::string>& cases) const {
  if (effects.empty()) return {load(cases), {}};
  const fs::path file = model_file();
  std::vector<AddedEffect> added = with_effects(read_model(file), effects, catalogue_).effects;
  return {load_file(file, cases, effects), std::move(added)};
}

std::vector<EffectTerm> ModelSource::applicable_effects() const {
  return secular::applicable_effects(read_model(model_file()), catalogue_);
}

std::vector<EffectTerm> ModelSource::open_law_terms() const {
  return secular::open_law_terms(read_model(model_file()), catalogue_);
}

EffectTerm ModelSource::effect_term(const std::string& text) const {
  return parse_effect_term(text, read_model(model_file()), catalogue_);
}

fs::path ModelSource::model_file() const {
  return file_.empty() ? resolve_model(name_) : file_;
}

std::shared_ptr<const CompiledModel> ModelSource::load_file(const fs::path& file,
                                                            const std::vector<std::string>& cases,
                                                            std::span<const EffectTerm> effects) const {
  RuntimeModelOptions options;
  options.cases = cases;
  options.effects.assign(effects.begin(), effects.end());
  options.catalogue = catalogue_;
  options.interpret = interpret_;
  options.header_folders = header_folders();
  RuntimeModel loaded = load_runtime_model(file, options);
  for (const std::string& note : loaded.notes)
    if (!is_quiet()) fmt::print(stderr, "secular: note: {}\n", note);
  return std::move(loaded.model);
}

}  // namespace secular::app
