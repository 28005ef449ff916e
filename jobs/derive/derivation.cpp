#include "jobs/derive/derivation.hpp"

#include <algorithm>

#include "codegen/document/print_html.hpp"
#include "codegen/document/print_json.hpp"
#include "codegen/document/print_latex.hpp"
#include "codegen/document/print_text.hpp"
#include "jobs/shared/model_loading.hpp"
#include "perturb/model.hpp"
#include "perturb/with_effects.hpp"

namespace secular {

CanonicalModel derive(const DerivationRequest& request) {
  const ModelText read = model_text(request.model);
  const Model model = read_model_text(read.text, read.name);
  std::vector<EffectTerm> terms;
  for (const std::string& effect : request.effects) terms.push_back(parse_effect_term(effect, model));
  return canonical_model(with_effects(model, terms).model, request.resonance, CanonicalContent::all,
                         request.progress);
}

std::string derivation_document(const CanonicalModel& model, const std::string& format) {
  if (format == "json") return derivation_json(model);
  if (format == "latex") return derivation_latex(model);
  if (format == "html") return derivation_html(model);
  return derivation_text(model);
}

bool is_certified(const CanonicalModel& model) {
  return std::all_of(model.cases.begin(), model.cases.end(),
                     [](const CanonicalCase& resonance) { return resonance.certificate.holds; });
}

}  // namespace secular
