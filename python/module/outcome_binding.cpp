#include <pybind11/stl.h>

#include <memory>

#include "input/input_error.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

const std::vector<report::NamedFigure>& figures_of(JobOutcome& outcome) {
  if (outcome.draw) {
    outcome.figures = computed([&] { return outcome.draw(); });
    outcome.draw = {};
  }
  return outcome.figures;
}

const report::NamedFigure& figure_named(JobOutcome& outcome, const std::string& name) {
  std::string all;
  for (const report::NamedFigure& figure : figures_of(outcome)) {
    if (figure.name == name) return figure;
    all += (all.empty() ? "" : ", ") + figure.name;
  }
  throw InputError("name", "", "there is no figure '" + name + "'",
                   all.empty() ? "there is none" : "give one of " + all);
}

}  // namespace

GivenParameters given_parameters(const ParameterArgument& argument) {
  const auto& [name, text] = argument;
  return text ? parameters_of(*text, name) : read_parameter_file(name);
}

void add_outcome(py::module_& module) {
  py::class_<JobOutcome, std::shared_ptr<JobOutcome>>(module, "Outcome")
      .def("json", [](const JobOutcome& outcome) { return outcome.json; })
      .def(
          "report",
          [](const JobOutcome& outcome, const std::string& command) {
            return computed([&] { return outcome.report(command); });
          },
          "command"_a)
      .def_property_readonly("figures",
                             [](JobOutcome& outcome) {
                               std::vector<std::string> names;
                               for (const report::NamedFigure& figure : figures_of(outcome))
                                 names.push_back(figure.name);
                               return names;
                             })
      .def(
          "figure",
          [](JobOutcome& outcome, const std::string& name) {
            return figure_dict(figure_named(outcome, name).figure);
          },
          "name"_a)
      .def_readonly("texts", &JobOutcome::texts)
      .def_readonly("notices", &JobOutcome::notices);
}

}  // namespace secular::python
