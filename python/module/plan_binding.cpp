#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "jobs/plan/planning.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

PlanRequest plan_request(const std::string& model, const ParameterArgument& parameters, const py::dict& options) {
  static const std::map<std::string, DesignCriterion> criteria = {
      {"D", DesignCriterion::d}, {"A", DesignCriterion::a}, {"c", DesignCriterion::c}};
  PlanRequest request;
  request.model = model;
  request.parameters = parameters.first;
  request.given = given_parameters(parameters);
  request.resonance = options["case"].cast<std::string>();
  request.wanted = options["wanted"].cast<std::vector<std::string>>();
  request.fixed = options["fix"].cast<std::vector<std::string>>();
  request.criterion = criteria.at(options["criterion"].cast<std::string>());
  using Range = std::pair<double, double>;
  std::tie(request.lowest_hz, request.highest_hz) = options["frequency_hz"].cast<Range>();
  std::tie(request.lowest_amplitude, request.highest_amplitude) = options["amplitude"].cast<Range>();
  request.budget_s = options["budget_s"].cast<std::optional<double>>();
  request.against = options["against"].cast<std::string>();
  request.noise = options["noise"].cast<double>();
  request.excitation_noise = options["excitation_noise"].cast<double>();
  request.dwell_scatter = options["dwell_scatter"].cast<double>();
  request.ensembles = options["ensembles"].cast<std::vector<int>>();
  request.ensemble_s = options["ensemble_s"].cast<double>();
  request.sample_rate_hz = options["sample_rate_hz"].cast<double>();
  request.least = options["least"].cast<std::optional<int>>();
  request.settled = options["settled"].cast<double>();
  request.settle_limit_s = options["settle_limit_s"].cast<double>();
  request.frequencies = options["frequencies"].cast<int>();
  request.levels = options["levels"].cast<int>();
  request.limit_s = options["limit_s"].cast<double>();
  request.against_records = window_of(options);
  return request;
}

std::shared_ptr<JobOutcome> planned(const std::string& model, const ParameterArgument& parameters,
                                    const Campaign* against, const py::dict& options) {
  auto outcome = std::make_shared<JobOutcome>();
  auto request = std::make_shared<PlanRequest>(plan_request(model, parameters, options));
  if (against) {
    request->against = against->name;
    request->campaign = *against;
  }
  request->note = [&](const std::string& note) { outcome->notices.push_back(note); };
  auto found = std::make_shared<PlanResult>();
  run_without_lock([&] {
    *found = plan_test(*request);
    outcome->json = plan_json(*request, *found);
    outcome->texts["plan.toml"] = plan_experiment(*request, *found);
    outcome->figures = {{"dwells", plan_figure(*found), ""}};
  });
  request->note = {};
  outcome->report = [request, found](const std::string& command) { return plan_report(*request, *found, command); };
  outcome->notices.insert(outcome->notices.end(), found->warnings.begin(), found->warnings.end());
  return outcome;
}

}  // namespace

void add_plan(py::module_& module) {
  module.def("plan", &planned, "model"_a, "parameters"_a, "against"_a, "options"_a);
}

}  // namespace secular::python
