#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jobs/derive/derivation.hpp"
#include "jobs/derive/evaluation_run.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

// {"name", "cases", "natural_frequencies", "nominal"}
py::dict outline(const std::string& model) {
  const ModelSource source = computed([&] { return ModelSource(model, false, {}); });
  std::vector<std::string> cases;
  for (const CaseOutline& one : source.cases()) cases.push_back(one.name);
  std::vector<double> nominal = source.nominal_frequencies();
  nominal.resize(source.modes());
  return py::dict("name"_a = source.name(), "cases"_a = cases, "natural_frequencies"_a = source.frequency_names(),
                  "nominal"_a = nominal);
}

std::shared_ptr<CanonicalModel> derived(const std::string& model, const std::string& resonance,
                                        const std::vector<std::string>& effects) {
  DerivationRequest request;
  request.model = model;
  request.resonance = resonance;
  request.effects = effects;
  return std::make_shared<CanonicalModel>(computed([&] { return derive(request); }));
}

// `values`: (what messages call it, symbol to number) or (file, None).
std::shared_ptr<JobOutcome> evaluated(
    const std::string& model, const std::string& resonance,
    const std::pair<std::string, std::optional<std::map<std::string, double>>>& values, bool omega_kept) {
  EvaluationRequest request;
  request.model = model;
  request.resonance = resonance;
  request.values_name = values.first;
  request.values = values.second ? *values.second : read_numbers(values.first);
  request.omega_kept = omega_kept;
  const Evaluation found = computed([&] { return evaluate(request); });
  auto outcome = std::make_shared<JobOutcome>();
  outcome->json = found.json;
  outcome->notices = found.warnings;
  return outcome;
}

std::vector<std::string> warnings_of(const CanonicalModel& model) {
  std::vector<std::string> all;
  for (const CanonicalCase& resonance : model.cases)
    all.insert(all.end(), resonance.warnings.begin(), resonance.warnings.end());
  return all;
}

}  // namespace

void add_model(py::module_& module) {
  module.def("shipped_models", &shipped_models);
  module.def("outline", &outline, "model"_a);
  py::class_<CanonicalModel, std::shared_ptr<CanonicalModel>>(module, "Derivation")
      .def(
          "document",
          [](const CanonicalModel& model, const std::string& format) {
            return computed([&] { return derivation_document(model, format); });
          },
          "format"_a)
      .def_property_readonly("certified", &is_certified)
      .def_property_readonly("warnings", &warnings_of);
  module.def("derive", &derived, "model"_a, "case"_a, "effects"_a);
  module.def("evaluate", &evaluated, "model"_a, "case"_a, "values"_a, "omega_kept"_a);
}

}  // namespace secular::python
