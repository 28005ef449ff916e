#include "codegen/runtime/derived_code.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "codegen/runtime/canonical_json.hpp"
#include "codegen/runtime/content_hash.hpp"
#include "codegen/runtime/program_identity.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "perturb/model.hpp"
#include "perturb/with_effects.hpp"

namespace secular {
namespace {

std::string key_of(const char* what, const ModelRequest& request) {
  std::string cases = request.cases ? "some:" : "all";
  for (const std::string& name : request.cases.value_or(std::vector<std::string>())) cases += name + ",";
  std::string effects;
  for (const EffectTerm& term : request.effects) {
    effects += term.effect + " " + std::to_string(term.mode) + " " + std::to_string(term.other) + " " +
               std::to_string(term.form);
    if (const EffectForm* form = request.catalogue.find_form(term.effect, term.form))
      effects += " " + form->parameters + " " + form->term + " " + form->other_term + " " +
                 std::to_string(form->degree) + " " + std::to_string(static_cast<int>(form->order)) + " " +
                 std::to_string(static_cast<int>(form->law.kind));
    effects += ",";
  }
  return content_hash({what, program_identity(), request.text, cases, effects});
}

std::optional<DerivedCode> parsed(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  DerivedCode code;
  code.model_name = json.at("model").get<std::string>();
  code.notes = json.at("notes").get<std::vector<std::string>>();
  for (const nlohmann::json& unit : json.at("units"))
    code.units.push_back({{unit.at("name").get<std::string>(), unit.at("text").get<std::string>()},
                          unit.at("often_called").get<bool>()});
  return code;
}

std::string serialised(const DerivedCode& code) {
  nlohmann::json units = nlohmann::json::array();
  for (const GeneratedUnit& unit : code.units)
    units.push_back({{"name", unit.file.name}, {"text", unit.file.text}, {"often_called", unit.often_called}});
  return nlohmann::json{{"model", code.model_name}, {"notes", code.notes}, {"units", units}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

CanonicalModel derive_for_code(const ModelRequest& request, std::vector<std::string>& notes) {
  Model model = read_model_text(request.text, request.file);
  if (request.cases) {
    for (const std::string& name : *request.cases) model.find_case(name);
    std::erase_if(model.cases, [&](const ResonanceCase& resonance) {
      return std::find(request.cases->begin(), request.cases->end(), resonance.name) == request.cases->end();
    });
  }
  if (!request.effects.empty()) model = with_effects(model, request.effects, request.catalogue).model;
  CanonicalModel canonical = canonical_model(model, {}, CanonicalContent::code);
  for (const CanonicalCase& resonance : canonical.cases)
    if (!resonance.certificate.holds)
      throw NumericalFailure(Ending::out_of_range, request.file + ", case " + resonance.name +
                                                       ": its certificate does not hold; see `secular derive`: no "
                                                       "code is made from an expansion that is not certified");
  std::erase_if(canonical.cases, [&](const CanonicalCase& resonance) {
    try {
      refuse_unsupported(canonical, resonance);
      return false;
    } catch (const InputError& error) {
      if (request.cases) throw;
      notes.push_back("case " + resonance.name + " is left out: " + error.wrong());
      return true;
    }
  });
  return canonical;
}

CanonicalModel cached_model(const ModelRequest& request, const ModelCache& cache, std::vector<std::string>& notes) {
  static const std::string suffix = ".model";
  const std::string key = key_of("derived model", request);
  if (const auto stored = cache.read(key, suffix)) {
    const nlohmann::json entry = nlohmann::json::parse(*stored, nullptr, false);
    if (entry.is_object() && entry.contains("notes") && entry.contains("model"))
      if (auto model = canonical_from_json(entry["model"].get<std::string>())) {
        for (const nlohmann::json& note : entry["notes"]) notes.push_back(note.get<std::string>());
        return std::move(*model);
      }
  }
  std::vector<std::string> found;
  CanonicalModel model = derive_for_code(request, found);
  cache.store(key, suffix,
              nlohmann::json{{"notes", found}, {"model", canonical_json(model)}}.dump(
                  -1, ' ', false, nlohmann::json::error_handler_t::replace));
  notes.insert(notes.end(), found.begin(), found.end());
  return model;
}

DerivedCode derived_code(const ModelRequest& request, const ModelCache& cache) {
  static const std::string suffix = ".json";
  const std::string key = key_of("derived code", request);
  if (const auto stored = cache.read(key, suffix))
    if (std::optional<DerivedCode> code = parsed(*stored)) return std::move(*code);
  DerivedCode code;
  const CanonicalModel model = derive_for_code(request, code.notes);
  code.model_name = model.name;
  code.units = emit_cpp_units(model);
  cache.store(key, suffix, serialised(code));
  return code;
}

}  // namespace secular
