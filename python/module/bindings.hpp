#pragma once

#include <pybind11/pybind11.h>

#include "measure/observe/observation_set.hpp"
#include "report/figure.hpp"

namespace secular::python {

/// The parts of the module `secular._core`. What they hand to Python is plain: text of JSON, arrays, dictionaries;
/// the package in python/secular makes the types of it that users see.
void add_campaign(pybind11::module_& module);
void add_model(pybind11::module_& module);
void add_identify(pybind11::module_& module);
void add_diagnose(pybind11::module_& module);
void add_outcome(pybind11::module_& module);
void add_predict(pybind11::module_& module);
void add_plan(pybind11::module_& module);
void add_surveys(pybind11::module_& module);

/// {"title", "x": axis, "panels": [{"title", "y": axis, "series": [...]}]}, an axis being {"label", "unit",
/// "logarithmic"} and a series {"name", "style", "role", "x", "y", "y_error"}.
pybind11::dict figure_dict(const report::Figure& figure);

/// {"records", "band_hz", "from_s", "to_s"}: each may be missing or None, which takes all.
Window window_of(const pybind11::dict& selection);

}  // namespace secular::python
