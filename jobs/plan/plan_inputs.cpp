#include "jobs/plan/plan_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "estimator/identification/symbol_units.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "measure/observe/modal_projection.hpp"

namespace secular {
namespace {

using Eigen::Index;

void load_case(const ModelSource& source, const PlanRequest& request, PlanResult& plan) {
  LoadedCase loaded = source.load_case(request.resonance);
  plan.model = std::move(loaded.model);
  plan.resonance = loaded.resonance;
  if (!plan.resonance->excited || plan.model->excitations.size() != 1)
    throw InputError("--case " + std::string(plan.resonance->name), "", "has no excitation, or several",
                     "dwells are planned for a case with one excitation");
}

// Returns what is given.
GivenParameters read_parameters(const ModelSource& source, const PlanRequest& request, PlanResult& plan) {
  GivenParameters file = request.given ? *request.given : read_parameter_file(request.parameters);
  std::map<std::string, double>& given = file.values;
  source.take_rest_position(given, request.parameters);
  given.merge(file.representative);
  const CompiledModel& model = *plan.model;
  const auto count = static_cast<Index>(model.symbols.size());
  if (std::string unused = unused_numbers(request.parameters, file.values, model); !unused.empty())
    plan.warnings.push_back(std::move(unused));
  plan.parameters.resize(count);
  std::string missing;
  for (Index s = 0; s < count; ++s) {
    const std::string name(model.symbols[static_cast<std::size_t>(s)].name);
    const auto at = given.find(name);
    plan.parameters(s) = at != given.end() ? at->second : model.nominal[static_cast<std::size_t>(s)];
    if (!std::isfinite(plan.parameters(s))) missing += (missing.empty() ? "" : ", ") + name;
  }
  if (!missing.empty())
    throw InputError(request.parameters, "", "gives no value for " + missing, "rough values are enough");
  return file;
}

bool against_is_experiment(const PlanRequest& request) {
  return !request.campaign && (request.against.starts_with("experiments/") ||
                               std::filesystem::path(request.against).extension() == ".toml");
}

Campaign channels_of(const Experiment& experiment) {
  Campaign campaign;
  campaign.folder = experiment.file;
  for (const SimulatedChannel& excitation : experiment.excitations) campaign.channels.push_back(excitation.channel);
  for (const SimulatedChannel& response : experiment.responses) campaign.channels.push_back(response.channel);
  campaign.modal_basis = experiment.modal_basis;
  return campaign;
}

// Noise as the request says, or as that of the sensors of an experiment.
void read_sensors(const PlanRequest& request, PlanResult& plan) {
  const std::size_t modes = plan.model->modes();
  PlanningNoise& noise = plan.noise;
  noise.response_sd.assign(modes, request.noise);
  noise.excitation_sd = request.excitation_noise;
  noise.sample_rate_hz = request.sample_rate_hz;
  noise.ensemble_s = request.ensemble_s;
  noise.dwell_scatter = request.dwell_scatter;
  if (request.against.empty()) return;
  if (!against_is_experiment(request)) {
    plan.channels = request.campaign ? *request.campaign : read_campaign(request.against);
    plan.channels->records.clear();
    return;
  }
  if (request.against_records.records != Window{}.records)
    throw InputError("--records " + request.against_records.records, "",
                     request.against + " is an experiment, which has no records", "--against a campaign folder");
  plan.sensors = read_experiment(resolve_model(request.against), *plan.model);
  const Experiment& experiment = *plan.sensors;
  plan.channels = channels_of(experiment);
  const ModalProjection projection = modal_projection(*plan.channels, *plan.model);
  const std::size_t first = experiment.excitations.size();
  for (std::size_t k = 0; k < modes; ++k) {
    double variance = 0;
    for (std::size_t c = 0; c < projection.channels.size(); ++c)
      variance += std::pow(projection.matrix(static_cast<Index>(k), static_cast<Index>(c)) *
                               experiment.responses[projection.channels[c] - first].noise_sd,
                           2);
    noise.response_sd[k] = std::sqrt(variance);
  }
  noise.derivatives = projection.derivatives;
  noise.excitation_sd = experiment.excitations.empty() ? 0 : experiment.excitations.front().noise_sd;
  noise.sample_rate_hz = experiment.sample_rate_hz;
  if (!experiment.dwells.empty()) noise.ensemble_s = experiment.dwells.front().ensemble_s;
  if (*std::min_element(noise.response_sd.begin(), noise.response_sd.end()) <= 0)
    throw InputError(experiment.file, "noise_sd", "is zero",
                     "a plan weighs dwells by their noise: give the sensors some");
}

void find_unknowns(const PlanRequest& request, PlanResult& plan) {
  for (const std::string& name : request.fixed)
    if (!is_lump_or_frequency(*plan.model, *plan.resonance, name))
      throw InputError(
          "--fix", "", "'" + name + "' is no lump and no natural frequency",
          fmt::format("the case's unknowns are {}",
                      fmt::join(plan_unknowns(*plan.model, *plan.resonance, plan.parameters, {}).names, ", ")));
  plan.unknowns = plan_unknowns(*plan.model, *plan.resonance, plan.parameters, request.fixed);
  const std::vector<std::string>& names = plan.unknowns.names;
  for (const std::string& name : request.wanted) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError("--for " + name, "",
                       "is nothing that case " + std::string(plan.resonance->name) + " sees by itself",
                       fmt::format("dwells there determine {}", fmt::join(names, ", ")));
    plan.wanted.push_back(found - names.begin());
  }
  if (request.criterion == DesignCriterion::c && plan.wanted.size() != 1)
    throw InputError("--criterion c", "", "is for one parameter", "name one with --for");
}

// An estimate knows the units of its campaign, an experiment or a campaign in use has its own; without either
// coordinates are modal ones.
void find_units(const GivenParameters& given, PlanResult& plan) {
  const SymbolUnits units = plan.channels ? SymbolUnits(*plan.channels, *plan.model) : SymbolUnits(*plan.model);
  plan.coordinate_unit = units.coordinate();
  const auto known = given.lump_units.find(std::string(plan.resonance->name));
  for (std::size_t u = 0; u < plan.unknowns.names.size(); ++u) {
    const std::string& name = plan.unknowns.names[u];
    const int lump = plan.unknowns.lump[u];
    if (lump < 0)
      plan.units.emplace_back("rad/s");
    else if (known != given.lump_units.end() && known->second.contains(name))
      plan.units.push_back(known->second.at(name));
    else
      plan.units.push_back(units.of(plan.resonance->lumps[static_cast<std::size_t>(lump)].dimension));
  }
}

}  // namespace

PlanResult plan_inputs(const PlanRequest& request) {
  PlanResult plan;
  const ModelSource source(request.model, false, request.note);
  load_case(source, request, plan);
  const GivenParameters given = read_parameters(source, request, plan);
  read_sensors(request, plan);
  find_unknowns(request, plan);
  find_units(given, plan);
  return plan;
}

}  // namespace secular
