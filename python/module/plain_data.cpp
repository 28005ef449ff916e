#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "python/module/bindings.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

py::dict axis_dict(const report::Axis& axis) {
  return py::dict("label"_a = axis.label, "unit"_a = axis.unit, "logarithmic"_a = axis.logarithmic);
}

const char* name_of(report::SeriesStyle style) {
  switch (style) {
    case report::SeriesStyle::points:
      return "points";
    case report::SeriesStyle::line:
      return "line";
    case report::SeriesStyle::line_and_points:
      return "line_and_points";
    case report::SeriesStyle::error_bars:
      return "error_bars";
    case report::SeriesStyle::band:
      return "band";
    case report::SeriesStyle::region:
      return "region";
  }
  return "line";
}

const char* name_of(report::SeriesRole role) {
  switch (role) {
    case report::SeriesRole::data:
      return "data";
    case report::SeriesRole::held_out:
      return "held_out";
    case report::SeriesRole::model:
      return "model";
    case report::SeriesRole::unstable:
      return "unstable";
    case report::SeriesRole::hopf:
      return "hopf";
    case report::SeriesRole::alternative:
      return "alternative";
    case report::SeriesRole::reference:
      return "reference";
  }
  return "model";
}

}  // namespace

py::dict figure_dict(const report::Figure& figure) {
  py::list panels;
  for (const report::Panel& panel : figure.panels) {
    py::list series;
    for (const report::Series& one : panel.series)
      series.append(py::dict("name"_a = one.name, "style"_a = name_of(one.style), "role"_a = name_of(one.role),
                             "x"_a = one.x, "y"_a = one.y, "y_error"_a = one.y_error, "group"_a = one.group));
    panels.append(py::dict("title"_a = panel.title, "y"_a = axis_dict(panel.y), "series"_a = series,
                           "zero_line"_a = panel.zero_line));
  }
  return py::dict("title"_a = figure.title, "x"_a = axis_dict(figure.x), "panels"_a = panels);
}

Window window_of(const py::dict& selection) {
  Window window;
  const auto given = [&](const char* key) { return selection.contains(key) && !selection[key].is_none(); };
  if (given("records")) window.records = selection["records"].cast<std::string>();
  if (given("from_s")) window.from_s = selection["from_s"].cast<double>();
  if (given("to_s")) window.to_s = selection["to_s"].cast<double>();
  if (!(window.from_s < window.to_s))
    throw InputError("from_s, to_s", "", "the window is empty", "from_s must be before to_s");
  if (!given("band_hz")) return window;
  const auto [low, high] = selection["band_hz"].cast<std::pair<double, double>>();
  if (!(low >= 0 && low < high && std::isfinite(high)))
    throw InputError("band_hz", "", "is no band", "give (low, high), for example (20, 300)");
  window.band = Band{low, high};
  return window;
}

}  // namespace secular::python
