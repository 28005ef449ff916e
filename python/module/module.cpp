// The extension module secular._core: the jobs of the library for Python.
#include <pybind11/pybind11.h>

#include <filesystem>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "input/stop_request.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "python/module/bindings.hpp"
#include "report/html_report.hpp"

namespace py = pybind11;

namespace {

// Exceptions of the package, which is being imported: raised with the parts of the message as arguments.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const secular::InputError& error) {
    const py::object type = py::module_::import("secular._errors").attr("InputError");
    const py::object value = type(error.what(), error.file(), error.place(), error.wrong(), error.right());
    PyErr_SetObject(type.ptr(), value.ptr());
  } catch (const secular::NumericalFailure& failure) {
    const py::object type = py::module_::import("secular._errors").attr("NumericalFailure");
    PyErr_SetObject(type.ptr(), type(failure.what()).ptr());
  } catch (const secular::Stopped&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The jobs of secular on plain data; see the package secular.";
  module.attr("version") = secular::report::program_version;
  py::register_exception_translator(translate);
  module.def(
      "set_folder",
      [](const std::string& folder) {
        // A wheel holds what else is installed beside the program.
        const std::filesystem::path package = folder;
        const bool in_wheel = std::filesystem::exists(package / "share/secular/models");
        secular::set_program_folder(in_wheel ? package / "bin" : package / SECULAR_PROGRAM_FROM_PACKAGE);
      },
      py::arg("folder"), "Says where the package is installed: the models and headers are found from there.");
  secular::python::add_campaign(module);
  secular::python::add_model(module);
  secular::python::add_identify(module);
  secular::python::add_diagnose(module);
  secular::python::add_outcome(module);
  secular::python::add_predict(module);
  secular::python::add_plan(module);
  secular::python::add_surveys(module);
}
