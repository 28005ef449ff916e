#include "jobs/derive/evaluation_run.hpp"

#include <functional>
#include <set>

#include "codegen/canonical/evaluation.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/number_file.hpp"
#include "perturb/model.hpp"
#include "perturb/rest_position.hpp"

namespace secular {

Evaluation evaluate(const EvaluationRequest& request) {
  const ModelText text = model_text(request.model);
  const Model model = read_model_text(text.text, text.name);
  const Derivation derivation = derive(model, model.find_case(request.resonance),
                                       request.omega_kept ? OmegaPolicy::kept : OmegaPolicy::nominal);
  std::map<std::string, double> values = request.values;
  const std::string rest = take_rest_position(model, values, request.values_name);
  std::map<std::string, double> at = values;
  add_values_at_rest(model, at);
  Evaluation found;
  if (!rest.empty()) found.warnings.push_back(rest);
  found.json = evaluation_json(derivation, at, request.values_name);
  std::set<std::string, std::less<>> known;
  for (const auto& [name, value] : values)
    if (model.symbols.contains(name)) known.insert(name);
  if (std::string unused = unused_numbers(request.values_name, values, known); !unused.empty())
    found.warnings.push_back(std::move(unused));
  return found;
}

}  // namespace secular
