#include "measure/data/loaded_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/number_range.hpp"
#include "measure/formats/number_table.hpp"

namespace secular {
namespace {

std::string unit_stated_for(const DataVariable& variable) {
  return variable.stated_unit.empty() ? bracketed_unit(variable.name).unit : variable.stated_unit;
}

double hertz_of_frequency(const DataFile& data, const FoundColumns& columns, const TableRequest& request) {
  const DataVariable& variable = data.vector(columns.frequency);
  std::string unit = unit_stated_for(variable);
  if (unit.empty()) unit = request.convention.frequency_unit;
  const std::string name = variable.name.substr(variable.name.rfind('.') + 1);
  if (unit.empty() && is_circular_frequency_name(name))
    throw InputError(data.file, "variable " + variable.name, "has a name of frequencies in rad/s, and no unit",
                     request.words.frequency_unit);
  const auto hertz = hertz_in(unit.empty() ? "Hz" : unit);
  if (!hertz)
    throw InputError(data.file, "variable " + variable.name,
                     "has the unit '" + unit + "', which is none of frequency", request.words.frequency_unit);
  return *hertz;
}

// A frequency response function states the unit of a quotient, if any.
void require_quantity(const DataFile& data, const std::string& column, const TableChannel& channel,
                      bool per_excitation) {
  const DataVariable& variable = data.vector(column);
  if (unit_stated_for(variable) == "dB")
    throw InputError(data.file, "variable " + column, "is in dB", "amplitudes, or real and imaginary parts");
  if (per_excitation && channel.role == ChannelRole::response) return;
  if (const std::string fault = quantity_fault(variable, channel.quantity); !fault.empty())
    throw InputError(data.file, "variable " + column, fault,
                     fmt::format("channel {} is one of {}", channel.name, to_string(channel.quantity)));
}

void require_no_decibels(const DataFile& data, const std::string& column) {
  const std::vector<double>& values = data.vector(column).values;
  const auto negative = std::find_if(values.begin(), values.end(), [](double x) { return x < 0; });
  if (negative != values.end())
    throw InputError(
        data.file,
        fmt::format("variable {}, {}", column, data.place.of(static_cast<std::size_t>(negative - values.begin()))),
        "is a negative amplitude",
        "amplitudes beside a phase are positive numbers, not dB; a real part needs its imaginary part "
        "(.re, .im)");
}

}  // namespace

LoadedTable loaded_table(DataFile data, const FoundColumns& columns, const TableRequest& request) {
  LoadedTable table;
  table.hertz = hertz_of_frequency(data, columns, request);  // before its unit is lost
  convert_csv_units(data);
  table.rows = data.vector(columns.frequency).values.size();
  for (const std::string& column : columns.all()) {
    const std::vector<double>& values = data.vector(column).values;
    if (values.size() != table.rows)
      throw InputError(data.file, "variable " + column,
                       fmt::format("has {} numbers, {} has {}", values.size(), columns.frequency, table.rows),
                       "all columns of a table have one length");
    require_number_range(values, data.file, "variable " + column);
  }
  for (const LineColumns& line : columns.lines) {
    for (const std::string* column : {&line.amplitude, &line.real, &line.imaginary, &line.sd})
      if (!column->empty()) require_quantity(data, *column, request.channels[line.channel], columns.per_excitation);
    if (!line.amplitude.empty() && !line.number.is_mean()) require_no_decibels(data, line.amplitude);
  }
  table.data = std::move(data);
  return table;
}

}  // namespace secular
