#include "measure/data/converted_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/line_names.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

/// One line of one row of a table, with all that says what its numbers mean.
struct TableCell {
  const LoadedTable& table;
  std::size_t row;
  const LineColumns& line;
  const TableRequest& request;
  bool per_excitation;

  const TableChannel& channel() const { return request.channels[line.channel]; }
  bool drives() const { return channel().role == ChannelRole::excitation; }
  std::string name() const { return channel().name + line_suffix(line.number); }
  double at(const std::string& column) const { return table.at(column, row); }
};

// Of a column of phases, or of their sd.
double radians_in(const TableCell& cell, const std::string& column) {
  const DataFile& data = cell.table.data;
  const DataVariable& variable = data.vector(column);
  if (variable.quantity == Quantity::angle) return 1;  // stated by the file, and converted
  if (const auto meaning = unit_meaning(usual_spelling(variable.stated_unit));
      meaning && meaning->quantity == Quantity::angle)
    return meaning->si_factor;
  const std::string stated =
      variable.stated_unit.empty() ? bracketed_unit(variable.name).unit : variable.stated_unit;
  if (!stated.empty() && stated != "deg" && stated != "rad")
    throw InputError(data.file, "variable " + column,
                     fmt::format("has the unit '{}', which is none of the phases of {}", stated, cell.name()),
                     "deg or rad");
  const std::optional<bool> degrees = cell.request.convention.degrees;
  if (!degrees)
    throw InputError(data.file, "variable " + column,
                     fmt::format("whether the phases of {} are degrees or radians is not known", cell.name()),
                     cell.request.words.phases);
  return *degrees ? std::numbers::pi / 180 : 1;
}

// Of the numbers of a column to SI units, peak.
double factor_of(const TableCell& cell, const std::string& column) {
  const double unit = cell.table.data.vector(column).unit.empty() ? cell.channel().si_factor : 1;
  const bool as_it_is = cell.line.number.is_mean() || (cell.per_excitation && !cell.drives());
  return unit * (as_it_is ? 1 : peak_of(cell.request.convention.amplitude));
}

// Nothing where the row has no such number.
std::optional<std::complex<double>> amplitude_of(const TableCell& cell) {
  const LineColumns& line = cell.line;
  const bool mean = line.number.is_mean();
  std::complex<double> amplitude;
  if (!line.real.empty()) {
    amplitude = {cell.at(line.real) * factor_of(cell, line.real),
                 cell.at(line.imaginary) * factor_of(cell, line.imaginary)};
  } else {
    const double phase = line.phase.empty() ? 0 : cell.at(line.phase) * radians_in(cell, line.phase);
    const double size = cell.at(line.amplitude) * factor_of(cell, line.amplitude);
    if (!std::isfinite(phase) || !std::isfinite(size)) return std::nullopt;
    amplitude = mean ? std::complex<double>(size) : std::polar(std::max(0.0, size), phase);
  }
  if (!std::isfinite(amplitude.real()) || !std::isfinite(amplitude.imag())) return std::nullopt;
  if (cell.request.convention.lags) amplitude = std::conj(amplitude);
  if (!cell.drives() && !mean) amplitude *= std::polar(1.0, cell.request.convention.phase_offset_rad);
  return amplitude;
}

// Of the real and of the imaginary part, each, from those of amplitude and phase; a negative one as it is.
std::optional<double> sd_of_cell(const TableCell& cell, double amplitude) {
  const LineColumns& line = cell.line;
  for (const std::string* sd : {&line.sd, &line.phase_sd})
    if (!sd->empty() && cell.at(*sd) < 0) return cell.at(*sd);
  double squares = 0, count = 0;
  if (!line.sd.empty()) {
    squares += std::pow(cell.at(line.sd) * factor_of(cell, line.sd), 2);
    ++count;
  }
  if (!line.phase_sd.empty()) {
    squares += std::pow(amplitude * cell.at(line.phase_sd) * radians_in(cell, line.phase_sd), 2);
    ++count;
  }
  return count > 0 && std::isfinite(squares) ? std::optional(std::sqrt(squares / count)) : std::nullopt;
}

// Why the lines of a row cannot be used, or empty.
std::string add_lines(const LoadedTable& table, std::size_t i, const FoundColumns& columns,
                      const TableRequest& request, LineRow& row) {
  for (const LineColumns& line : columns.lines) {
    const TableCell cell{table, i, line, request, columns.per_excitation};
    const auto amplitude = amplitude_of(cell);
    if (!amplitude) {
      if (line.number == LineNumber{}) return cell.name() + " is no number";
      continue;
    }
    const auto sd = sd_of_cell(cell, std::abs(*amplitude));
    if (sd && !(*sd > 0)) return fmt::format("the standard deviation of {} is {}", cell.name(), *sd);
    row.lines.push_back({line.channel, line.number, *amplitude, sd});
  }
  return "";
}

// Lines of response functions, times the excitation's.
void times_excitation(std::complex<double> force, std::size_t excitation, LineRow& row) {
  for (TableLine& line : row.lines) {
    if (line.channel == excitation) continue;
    const double turns = static_cast<double>(line.number.numerator) / line.number.divisor;
    line.amplitude *= std::polar(std::abs(force), turns * std::arg(force));
    if (line.sd) *line.sd *= std::abs(force);
  }
}

}  // namespace

ConvertedRow converted_row(const LoadedTable& table, std::size_t i, const FoundColumns& columns,
                           const TableRequest& request) {
  LineRow row;
  row.place = table.data.place.of(i);
  const auto damaged = [&](std::string why) { return ConvertedRow{row, std::move(why)}; };
  const double frequency = table.at(columns.frequency, i);
  row.frequency_hz = frequency * table.hertz;
  if (!std::isfinite(row.frequency_hz)) return damaged(columns.frequency + " is no number");
  if (!(row.frequency_hz > 0)) return damaged(fmt::format("the frequency is {}", frequency));
  if (!columns.condition.empty()) {
    const double label = table.at(columns.condition, i);
    if (!(label == std::round(label)) || !(std::abs(label) < 1e15))
      return damaged(fmt::format("condition is {}, no whole number", label));
    row.condition = static_cast<long long>(label);
  }
  if (const std::string why = add_lines(table, i, columns, request, row); !why.empty()) return damaged(why);
  if (row.find(columns.excitation, {}) == nullptr) {
    const double level = request.convention.level.value_or(0) * peak_of(request.convention.amplitude);
    row.lines.push_back({columns.excitation, {}, level, std::nullopt});
  }
  const std::complex<double> force = row.find(columns.excitation, {})->amplitude;
  if (!(std::abs(force) > 0)) return damaged(request.channels[columns.excitation].name + " is zero");
  if (columns.per_excitation) times_excitation(force, columns.excitation, row);
  std::sort(row.lines.begin(), row.lines.end(), [](const TableLine& a, const TableLine& b) {
    return std::pair(a.channel, a.number) < std::pair(b.channel, b.number);
  });
  return {std::move(row), ""};
}

}  // namespace secular
