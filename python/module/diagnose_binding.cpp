#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jobs/diagnose/diagnosis_json.hpp"
#include "jobs/diagnose/diagnosis_report.hpp"
#include "jobs/diagnose/diagnosis_run.hpp"
#include "jobs/shared/left_out.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

struct DiagnoseOutcome {
  DiagnosisRun found;
  std::vector<std::string> notices;
};

std::shared_ptr<DiagnoseOutcome> diagnosed(const Campaign& campaign, const std::string& model,
                                           const std::optional<ParameterArgument>& parameters,
                                           const py::dict& options) {
  auto outcome = std::make_shared<DiagnoseOutcome>();
  DiagnosisRequest request;
  request.model = model;
  if (parameters) {
    request.parameters_name = parameters->first;
    request.parameters = given_parameters(*parameters);
  }
  request.without = options["without"].cast<std::vector<std::string>>();
  request.threads = options["threads"].cast<unsigned>();
  request.interpret = options["interpret"].cast<bool>();
  request.window = window_of(options);
  request.note = [&](const std::string& note) { outcome->notices.push_back(note); };
  run_without_lock([&] { outcome->found = run_diagnosis(request, campaign); });
  for (std::string& warning : folded(outcome->found.diagnosis.warnings, outcome->found.campaign))
    outcome->notices.push_back(std::move(warning));
  if (outcome->found.mostly_left_out) outcome->notices.push_back(*outcome->found.mostly_left_out);
  return outcome;
}

}  // namespace

void add_diagnose(py::module_& module) {
  py::class_<DiagnoseOutcome, std::shared_ptr<DiagnoseOutcome>>(module, "Diagnosis")
      .def("json", [](const DiagnoseOutcome& o) { return computed([&] { return diagnosis_json(o.found); }); })
      .def(
          "report",
          [](const DiagnoseOutcome& o, const std::string& command) {
            return computed([&] { return diagnosis_report(o.found, command); });
          },
          "command"_a)
      .def("figure",
           [](const DiagnoseOutcome& o) { return figure_dict(computed([&] { return gap_figure(o.found); })); })
      .def_property_readonly("mostly_left_out", [](const DiagnoseOutcome& o) { return o.found.mostly_left_out; })
      .def_readonly("notices", &DiagnoseOutcome::notices);
  module.def("diagnose", &diagnosed, "campaign"_a, "model"_a, "parameters"_a, "options"_a);
}

}  // namespace secular::python
