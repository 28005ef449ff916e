#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jobs/identify/estimate_json.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/identify/identification_report.hpp"
#include "jobs/shared/left_out.hpp"
#include "python/module/bindings.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

struct IdentifyOutcome {
  Identification found;
  std::vector<std::string> notices;
};

IdentificationRequest request_of(const std::string& model, const py::dict& options) {
  IdentificationRequest request;
  request.model = model;
  request.resonances = options["cases"].cast<std::vector<std::string>>();
  request.fixed = options["fix"].cast<std::map<std::string, double>>();
  request.threads = options["threads"].cast<unsigned>();
  request.bootstrap = options["bootstrap"].cast<int>();
  request.seed = options["seed"].cast<std::uint64_t>();
  request.refine = options["refine"].cast<bool>();
  request.interpret = options["interpret"].cast<bool>();
  request.window = window_of(options);
  if (const auto by = options["by"].cast<std::optional<std::string>>())
    request.by = equations_named(*by);
  return request;
}

std::shared_ptr<IdentifyOutcome> identified(const Campaign& campaign, const std::string& model,
                                            const py::dict& options) {
  auto outcome = std::make_shared<IdentifyOutcome>();
  IdentificationRequest request = request_of(model, options);
  request.note = [&](const std::string& note) { outcome->notices.push_back(note); };
  run_without_lock([&] { outcome->found = identify(request, campaign); });
  for (std::string& warning : folded(outcome->found.estimate.warnings, outcome->found.campaign))
    outcome->notices.push_back(std::move(warning));
  if (outcome->found.mostly_left_out) outcome->notices.push_back(*outcome->found.mostly_left_out);
  return outcome;
}

}  // namespace

void add_identify(py::module_& module) {
  py::class_<IdentifyOutcome, std::shared_ptr<IdentifyOutcome>>(module, "Identification")
      .def("json", [](const IdentifyOutcome& o) { return computed([&] { return estimate_json(o.found); }); })
      .def(
          "report",
          [](const IdentifyOutcome& o, const std::string& command) {
            return computed([&] { return identification_report(o.found, response_figure(o.found), command); });
          },
          "command"_a)
      .def("figure",
           [](const IdentifyOutcome& o) { return figure_dict(computed([&] { return response_figure(o.found); })); })
      .def_property_readonly("mostly_left_out", [](const IdentifyOutcome& o) { return o.found.mostly_left_out; })
      .def_readonly("notices", &IdentifyOutcome::notices);
  module.def("identify", &identified, "campaign"_a, "model"_a, "options"_a);
}

}  // namespace secular::python
