#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <tuple>

#include "jobs/predict/prediction.hpp"
#include "jobs/predict/prediction_files.hpp"
#include "jobs/predict/prediction_report.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

using Range = std::optional<std::tuple<std::string, double, double>>;

std::optional<VariedParameter> varied(const py::object& given) {
  const auto range = given.cast<Range>();
  if (!range) return {};
  const auto& [name, from, to] = *range;
  return VariedParameter{name, from, to};
}

PredictionRequest prediction_request(const std::string& model, const ParameterArgument& parameters,
                                     const py::dict& options) {
  PredictionRequest request;
  request.model = model;
  request.parameters = parameters.first;
  request.given = given_parameters(parameters);
  request.resonance = options["case"].cast<std::string>();
  request.at = options["at"].cast<std::map<std::string, double>>();
  request.hz = options["hz"].cast<bool>();
  request.vary = varied(options["vary"]);
  request.against = varied(options["against"]);
  request.curve = options["curve"].cast<std::string>();
  request.largest = options["largest"].cast<double>();
  for (const std::string& direction : options["sweep"].cast<std::vector<std::string>>())
    (direction == "up" ? request.sweep_up : request.sweep_down) = true;
  request.sweep_steps = options["sweep_steps"].cast<int>();
  request.threads = options["threads"].cast<unsigned>();
  request.window = window_of(options);
  return request;
}

std::shared_ptr<JobOutcome> predicted(const std::string& model, const ParameterArgument& parameters,
                                      const Campaign* measured, const py::dict& options) {
  auto outcome = std::make_shared<JobOutcome>();
  PredictionRequest request = prediction_request(model, parameters, options);
  if (measured) {
    request.measured = measured->name;
    request.campaign = *measured;
  }
  request.note = [&](const std::string& note) { outcome->notices.push_back(note); };
  auto found = std::make_shared<Prediction>();
  run_without_lock([&] {
    *found = predict(request);
    outcome->json = prediction_json(*found);
    outcome->texts["prediction.csv"] = prediction_csv(*found);
    outcome->figures = prediction_figures(*found);
  });
  outcome->report = [found, figures = outcome->figures](const std::string& command) {
    return prediction_report(*found, figures, command);
  };
  outcome->notices.insert(outcome->notices.end(), found->warnings.begin(), found->warnings.end());
  return outcome;
}

}  // namespace

void add_predict(py::module_& module) {
  module.def("predict", &predicted, "model"_a, "parameters"_a, "measured"_a, "options"_a);
}

}  // namespace secular::python
