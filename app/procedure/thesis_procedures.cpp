#include "app/procedure/thesis_procedures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/procedure/exact_resonance.hpp"
#include "app/procedure/one_mode.hpp"
#include "app/procedure/procedure_bias.hpp"
#include "app/procedure/procedure_data.hpp"
#include "app/procedure/two_modes.hpp"
#include "app/procedure/variance.hpp"
#include "app/shared/notices.hpp"
#include "estimator/model/by_name.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/observe/modal_projection.hpp"
#include "thesis/procedures/combination_dwells.hpp"
#include "thesis/procedures/engine_lumps.hpp"

namespace secular::app {
namespace {

// Omega = 2 omega0 of a model with one mode.
bool is_principal_parametric(const CompiledModel& model, const CompiledCase& resonance) {
  return model.modes() == 1 && model.excitations.size() == 1 && resonance.relations.size() == 2 &&
         std::abs(resonance.relations[0]) == 2 && resonance.relations[1] == -resonance.relations[0] / 2;
}

bool is_covered(const ModelSource& source, const CaseOutline& outline) {
  if (!outline.excited || outline.relations.size() != 1) return false;
  const std::vector<int>& r = outline.relations[0];
  const bool one = source.modes() == 1 && r.size() == 2 && std::abs(r[0]) == 2 && r[1] == -r[0] / 2;
  const bool two = source.modes() == 2 && r.size() == 3 && std::abs(r[0]) == 1 && r[1] == r[0] && r[2] == -r[0];
  return one || two;
}

bool is_variance_alone(const ProcedureRequest& request) {
  return request.methods == std::vector<std::string>{"anova"};
}

// The case that was asked for, or the first one that the procedures cover. Generated equations have an analysis of
// variance in every case of dwells.
std::string covered_case(const ModelSource& source, const ProcedureRequest& request) {
  if (!request.resonance.empty()) source.case_named(request.resonance);
  std::vector<std::string> excited;
  for (const CaseOutline& outline : source.cases()) {
    if (!request.resonance.empty() && outline.name != request.resonance) continue;
    if (outline.excited) excited.push_back(outline.name);
    if (is_covered(source, outline)) return outline.name;
  }
  const std::string place = request.resonance.empty() ? "--model " + source.name() : "--case " + request.resonance;
  if (!is_variance_alone(request))
    throw InputError(
        place, "", "is no case that these procedures cover",
        "Omega = 2 omega0 of one mode, or Omega = omega1 + omega2 of two (--method anova takes any case of "
        "dwells)");
  if (excited.empty()) throw InputError(place, "", "has no dwells", "an excited case");
  if (excited.size() > 1)
    throw InputError(place, "", "has several cases of dwells",
                     fmt::format("name one: --case {}", fmt::join(excited, " or --case ")));
  return excited.front();
}

// Adds the sections of every method that was asked for.
void run_methods(const ProcedureRequest& request, const KnownTruth& truth, ProcedureRun& run, bool values_only) {
  const bool one = is_principal_parametric(*run.model, *run.resonance),
             two = is_additive_combination(*run.model, *run.resonance);
  ProcedureData test{request,    run,
                     truth,      dwell_means(run.campaign, run.measured),
                     0,          modal_projection(run.campaign, *run.model).unit,
                     values_only};
  if (one || two) test.centre = exact_resonance(test, one ? 2 : 1);
  if (one) one_mode_procedures(test);
  if (two) two_mode_procedures(test);
  if (test.wants("anova") && !values_only) generated_variance(test);
}

void find_bias(const ProcedureRequest& request, const RecordReader& read, ProcedureRun& run) {
  if (std::all_of(run.sections.begin(), run.sections.end(),
                  [](const auto& section) { return section.rows.empty(); }))
    return;
  IdentificationRequest everything;
  everything.model = request.model;
  everything.resonances = {std::string(run.resonance->name)};
  everything.interpret = request.interpret;
  everything.window = request.window;
  everything.threads = request.threads;
  everything.note = print_note;
  const MethodsOn methods = [&](const ObservationSet& seen, const Eigen::VectorXd& parameters) {
    ProcedureRun again{run.campaign, run.model, run.resonance, seen, {}, {}};
    run_methods(request, KnownTruth(parameters, *run.model, *run.resonance), again, true);
    return std::move(again.sections);
  };
  try {
    const Identification identification = identify_by_modulation(everything, run.campaign, read);
    add_bias(run, methods, identification.estimate, request.threads);
    const auto& values = identification.estimate.parameters;
    if (std::any_of(values.begin(), values.end(), [](const EstimatedValue& v) { return v.doubtful; }))
      run.warnings.push_back(
          "the bias of the methods is that of a model that `secular identify` doubts for this campaign");
  } catch (const InputError& error) {  // the methods ask less of a campaign
    run.warnings.push_back(std::string("the bias of the methods is not known: ") + error.what());
  } catch (const NumericalFailure& failure) {
    run.warnings.push_back(std::string("the bias of the methods is not known: ") + failure.what());
  }
}

}  // namespace

ProcedureRun run_procedures(const ProcedureRequest& request) {
  const Campaign campaign = read_campaign(request.campaign);
  SelectedRecords reader(campaign, request.window);
  reader.leave_clipped_out();
  ProcedureRun run = run_procedures(request, campaign, [&](std::size_t r) { return reader.read(r); });
  for (std::string& warning : reader.warnings()) run.warnings.push_back(std::move(warning));
  return run;
}

ProcedureRun run_procedures(const ProcedureRequest& request, const Campaign& measured, const RecordReader& read) {
  const ModelSource source(request.model, request.interpret, print_note);
  const std::string name = covered_case(source, request);
  ProcedureRun run;
  run.campaign = measured;
  run.model = source.load({name});
  run.resonance = &case_named(*run.model, name);
  run.measured = is_additive_combination(*run.model, *run.resonance)
                     ? observe_combination_dwells(run.campaign, read, *run.model, *run.resonance, request.window)
                     : observe_dwells(run.campaign, read, *run.model, *run.resonance, request.window);
  run.warnings = run.measured.warnings;
  if (run.measured.observations.empty())
    throw InputError(request.campaign, "", "no dwell of it responds in case " + name,
                     "dwells with a response near this resonance were expected");
  run_methods(request, KnownTruth(request.truth, *run.model, *run.resonance), run, false);
  if (request.bias && !is_variance_alone(request)) find_bias(request, read, run);
  return run;
}

}  // namespace secular::app
