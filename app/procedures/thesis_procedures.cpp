#include "app/procedures/thesis_procedures.hpp"

#include <cmath>
#include <cstdlib>

#include "app/model_loading.hpp"
#include "app/procedures/exact_resonance.hpp"
#include "app/procedures/one_mode.hpp"
#include "app/procedures/procedure_data.hpp"
#include "app/procedures/two_modes.hpp"
#include "app/procedures/variance.hpp"
#include "estimator/identification/modal_projection.hpp"
#include "estimator/procedures/combination_dwells.hpp"
#include "input/input_error.hpp"

namespace secular::app {
namespace {

// Omega = 2 omega0 of a model with one mode.
bool is_principal_parametric(const CompiledModel& model, const CompiledCase& resonance) {
  return model.modes() == 1 && model.excitations.size() == 1 && resonance.relations.size() == 2 &&
         std::abs(resonance.relations[0]) == 2 && resonance.relations[1] == -resonance.relations[0] / 2;
}

std::string covered_case(const ModelSource& source, const std::string& wanted) {
  for (const CaseOutline& outline : source.cases()) {
    if (!wanted.empty() && outline.name != wanted) continue;
    if (!outline.excited || outline.relations.size() != 1) continue;
    const std::vector<int>& r = outline.relations[0];
    const bool one = source.modes() == 1 && r.size() == 2 && std::abs(r[0]) == 2 && r[1] == -r[0] / 2;
    const bool two = source.modes() == 2 && r.size() == 3 && std::abs(r[0]) == 1 && r[1] == r[0] && r[2] == -r[0];
    if (one || two) return outline.name;
  }
  throw InputError(wanted.empty() ? "--model " + source.name() : "--case " + wanted, "",
                   "is no case that these procedures cover",
                   "Omega = 2 omega0 of one mode, or Omega = omega1 + omega2 of two");
}

}  // namespace

ProcedureRun run_procedures(const ProcedureRequest& request) {
  const ModelSource source(request.model, request.interpret);
  const std::string name = covered_case(source, request.resonance);
  ProcedureRun run;
  run.campaign = read_campaign(request.campaign);
  run.model = source.load({name});
  for (const CompiledCase& resonance : run.model->cases)
    if (resonance.name == name) run.resonance = &resonance;
  ProcedureData test{request, run, KnownTruth(request.truth, *run.model, *run.resonance),
                     {},      0,   modal_projection(run.campaign, *run.model).unit};
  const RecordReader read = [&](std::size_t r) { return read_record(run.campaign, run.campaign.records[r]); };
  const bool one = is_principal_parametric(*run.model, *run.resonance);
  run.measured = one ? observe_dwells(run.campaign, read, *run.model, *run.resonance, request.window)
                     : observe_combination_dwells(run.campaign, read, *run.model, *run.resonance, request.window);
  run.warnings = run.measured.warnings;
  if (run.measured.observations.empty())
    throw InputError(request.campaign, "", "no dwell of it responds in case " + name,
                     "dwells with a response near this resonance were expected");
  test.dwells = dwell_means(run.campaign, run.measured);
  test.centre = exact_resonance(test, one ? 2 : 1);
  if (one)
    one_mode_procedures(test);
  else
    two_mode_procedures(test);
  if (test.wants("anova")) generated_variance(test);
  return run;
}

}  // namespace secular::app
