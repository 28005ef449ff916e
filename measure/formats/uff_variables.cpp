#include "measure/formats/uff_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/uff_file.hpp"
#include "measure/formats/uff_frf.hpp"
#include "measure/formats/uff_units.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

constexpr int time_response = 1;

bool is_rotation(const UffPoint& point) {
  return std::abs(static_cast<long long>(point.direction)) >= 4;
}

std::string degree_of_freedom(const UffPoint& point) {
  static constexpr const char* axes[] = {"", "x", "y", "z", "rx", "ry", "rz"};
  const bool known = point.direction >= -6 && point.direction <= 6;
  const std::string axis = known ? axes[std::abs(point.direction)] : "";
  return point.entity + std::to_string(point.node) + axis + (point.direction < 0 ? "-" : axis.empty() ? "" : "+");
}

std::optional<SensorPlace> sensor_place(const UffPoint& point) {
  if (point.node == 0 || point.direction == 0 || is_rotation(point)) return std::nullopt;
  SensorPlace place{std::to_string(point.node), {}};
  place.direction[static_cast<std::size_t>(std::abs(point.direction)) - 1] = point.direction < 0 ? -1 : 1;
  return place;
}

std::vector<std::string> channel_names(const std::vector<UffFunction>& functions) {
  const std::function<std::string(const UffFunction&)> candidates[] = {
      [](const UffFunction& function) { return function.id_lines.front(); },
      [](const UffFunction& function) { return function.numerator.label; },
      [](const UffFunction& function) { return degree_of_freedom(function.response); }};
  for (const auto& candidate : candidates) {
    std::vector<std::string> names;
    for (const UffFunction& function : functions) names.push_back(candidate(function));
    const std::set<std::string> different(names.begin(), names.end());
    const bool usable =
        std::all_of(names.begin(), names.end(), [](const auto& name) { return channel_name_fault(name).empty(); });
    if (usable && different.size() == names.size()) return names;
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= functions.size(); ++i) names.push_back(fmt::format("channel {}", i));
  return names;
}

std::string type_name(UffOrdinate type) {
  return std::string(is_complex(type) ? "complex " : "") + (is_double(type) ? "double" : "single");
}

// Why a function is no channel of a record; empty if it is one.
std::string channel_fault(const UffFunction& function) {
  if (function.type != time_response)
    return fmt::format("is a {} (function type {}), no time response (type 1){}", function_type_name(function.type),
                       function.type,
                       is_frequency_function(function) ? "; --kind lines reads it as a table of lines" : "");
  if (is_complex(function.ordinate)) return "is complex";
  if (function.count == 0) return "is empty";
  return {};
}

// Repeats of one test stand one behind the other: the k-th function of a degree of freedom is of the k-th record.
// By function: its record, counted from 0; all 0 where time responses do not say where they were measured, or not
// all of two or more channels have equally many.
std::vector<std::size_t> records_of(const std::vector<UffFunction>& functions, std::size_t& records) {
  std::map<std::string, std::size_t> seen;
  std::vector<std::size_t> record(functions.size(), 0);
  bool placed = true;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const UffFunction& function = functions[i];
    if (!channel_fault(function).empty()) continue;
    placed = placed && function.response.node != 0;
    record[i] = seen[fmt::format("{} {} {} {}", degree_of_freedom(function.response), function.numerator.data_type,
                                 function.numerator.label, function.id_lines.front())]++;
  }
  records = seen.empty() ? 1 : seen.begin()->second;
  const bool equally = std::all_of(seen.begin(), seen.end(), [&](const auto& s) { return s.second == records; });
  if (!placed || !equally || seen.size() < 2) records = 1;
  if (records == 1) record.assign(functions.size(), 0);
  return record;
}

bool same_time(const UffFunction& a, const UffFunction& b) {
  return a.even == b.even && a.count == b.count && a.start == b.start && a.rate == b.rate &&
         a.uneven_abscissa == b.uneven_abscissa && a.abscissa.unit == b.abscissa.unit &&
         a.abscissa.data_type == b.abscissa.data_type;
}

DataVariable time_variable(std::string name, const UffFunction& function, bool read) {
  DataVariable time{std::move(name), {function.count}, "time", {}, {}};
  const std::optional<double> seconds = seconds_in_unit(function.abscissa);
  if (!seconds) {
    time.fault = function.abscissa.unit.empty()
                     ? fmt::format("is of data type {}, not time (17)", function.abscissa.data_type)
                     : fmt::format(
                           "has the unit '{}', which is no known unit of time (give --sample-rate HZ to "
                           "import it)",
                           function.abscissa.unit);
    return time;
  }
  if (!read) return time;
  time.values = function.uneven_abscissa;
  if (function.even)
    for (std::size_t i = 0; i < function.real.size(); ++i)
      time.values.push_back(function.start + static_cast<double>(i) / function.rate);
  scale_to_seconds(time.values, *seconds);
  return time;
}

DataVariable channel_variable(std::string name, UffFunction& function, bool read) {
  DataVariable channel{
      std::move(name), {function.count}, type_name(function.ordinate), {}, channel_fault(function)};
  channel.stated_unit = function.numerator.unit;
  channel.sensor = sensor_place(function.response);
  const std::optional<UffMeaning> meaning = ordinate_meaning(function.numerator, is_rotation(function.response));
  if (meaning) {
    channel.quantity = meaning->quantity;
    channel.unit = si_unit(meaning->quantity);
  }
  if (!read || !channel.fault.empty()) return channel;
  channel.values = std::move(function.real);
  if (meaning && meaning->si_factor != 1)
    for (double& value : channel.values) value *= meaning->si_factor;
  return channel;
}

}  // namespace

DataFile read_uff_variables(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                            std::size_t limit, std::size_t segment) {
  std::vector<UffFunction> functions = read_uff(path, limit);
  if (functions.empty())
    throw InputError(path.string(), "", "is a universal file without a data set 58",
                     "time responses as data sets 58 or 58b were expected");
  std::size_t records = 1, place = 0;
  const std::vector<std::size_t> record = records_of(functions, records);
  std::erase_if(functions, [&](const UffFunction&) { return record[place++] != segment; });
  const std::vector<std::string> names = channel_names(functions);
  std::vector<std::size_t> channels;
  for (std::size_t i = 0; i < functions.size(); ++i)
    if (channel_fault(functions[i]).empty()) channels.push_back(i);
  const bool shared = std::all_of(channels.begin(), channels.end(), [&](std::size_t i) {
    return same_time(functions[channels.front()], functions[i]);
  });
  const auto is_wanted = [&](const std::string& name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  DataFile data{path.string(), "UFF 58", {}, {"value", 1}};
  data.partial = std::any_of(functions.begin(), functions.end(),
                             [&](const UffFunction& function) { return function.count > limit; });
  for (const std::size_t i : channels) {
    const std::string name = shared ? "t" : names[i] + ".t";
    data.variables.push_back(time_variable(name, functions[i], is_wanted(name)));
    if (shared) break;
  }
  for (std::size_t i = 0; i < functions.size(); ++i)
    data.variables.push_back(channel_variable(names[i], functions[i], is_wanted(names[i])));
  add_frequency_functions(functions, names, is_wanted, data.variables);
  return data;
}

std::size_t count_uff_segments(const std::filesystem::path& path) {
  std::size_t records = 1;
  records_of(read_uff(path, 0), records);
  return records;
}

}  // namespace secular
