#include "measure/data/found_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/line_names.hpp"
#include "measure/data/table_names.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/uff_frf.hpp"

namespace secular {
namespace {

/// What may stand between a channel's name and a part of it.
constexpr const char* joints[] = {".", "_", " "};

// A file may say itself that its numbers are frequency response functions.
bool holds_response_functions(const std::vector<DataVariable>& variables, const TableRequest& request) {
  return std::any_of(variables.begin(), variables.end(), [&](const DataVariable& variable) {
    return variable.type.starts_with(frequency_response) &&
           std::any_of(request.channels.begin(), request.channels.end(), [&](const TableChannel& channel) {
             return variable.name.starts_with(channel.variable + ".") ||
                    variable.name.starts_with(channel.name + ".");
           });
  });
}

std::size_t only_excitation(const std::string& file, const TableRequest& request) {
  std::vector<std::size_t> places;
  for (std::size_t c = 0; c < request.channels.size(); ++c)
    if (request.channels[c].role == ChannelRole::excitation) places.push_back(c);
  if (places.size() != 1)
    throw InputError(file, "", fmt::format("a table of lines with {} excitation channels", places.size()),
                     "exactly one channel with the role excitation was expected: its level is a column of the "
                     "table, or given");
  return places.front();
}

std::vector<std::string> bases_of(const TableChannel& channel) {
  if (channel.variable == channel.name) return {channel.name};
  return {channel.variable, channel.name};
}

bool has_real_part(const TableNames& names, const std::string& base) {
  return std::any_of(std::begin(joints), std::end(joints),
                     [&](const char* joint) { return names.has(base + joint + "re"); });
}

// Without those that hold amplitudes of a channel.
std::vector<std::string> unclaimed(std::vector<std::string> usual, const TableNames& names,
                                   const TableRequest& request) {
  std::erase_if(usual, [&](const std::string& name) {
    return !has_real_part(names, name) &&
           std::any_of(request.channels.begin(), request.channels.end(),
                       [&](const TableChannel& c) { return c.name == name || c.variable == name; });
  });
  return usual;
}

std::string frequency_column(const std::string& file, TableNames& names, const TableRequest& request) {
  if (const auto given = names.given("f")) return *given;
  const std::string asks = fmt::format(fmt::runtime(request.words.column), "f");
  const std::vector<std::string> usual =
      unclaimed({std::begin(frequency_names), std::end(frequency_names)}, names, request);
  const auto found = names.first_of(usual);
  if (!found)
    throw InputError(
        file, "", "which column holds the excitation's frequency is not known: its variables are " + names.listed(),
        asks);
  for (const DataVariable& other : names.variables())
    if (other.name != *found &&
        std::find(usual.begin(), usual.end(), bracketed_unit(other.name).name) != usual.end())
      throw InputError(file, "", fmt::format("{} and {} both have a name of frequencies", *found, other.name),
                       asks);
  return *found;
}

std::string condition_column(TableNames& names, const TableRequest& request) {
  if (const auto given = names.given("condition")) return *given;
  return names.first_of(unclaimed({"condition"}, names, request)).value_or("");
}

// Column of a part of a line ("", "phase", "re", ...); empty: none.
std::string part_of(const TableChannel& channel, LineNumber number, const std::string& part, TableNames& names) {
  const std::string of_line = line_suffix(number);
  if (const auto given = names.given(channel.name + of_line + (part.empty() ? "" : "." + part))) return *given;
  std::vector<std::string> candidates;
  for (const std::string& base : bases_of(channel)) {
    if (part.empty()) candidates.push_back(base + of_line);
    for (const char* const joint : joints)
      if (!part.empty()) candidates.push_back(base + of_line + joint + part);
  }
  return names.first_of(candidates).value_or("");
}

std::set<LineNumber> numbers_of(const TableChannel& channel, const TableNames& names, const TableRequest& request) {
  std::set<LineNumber> numbers = {LineNumber{}};
  const auto add = [&](const std::string& name, const std::string& base) {
    if (!name.starts_with(base + "@")) return;
    std::string text = name.substr(base.size() + 1);
    text.resize(std::min(text.find_first_not_of("0123456789/"), text.size()));
    if (const auto number = parsed_line_number(text)) numbers.insert(*number);
  };
  for (const auto& [part, variable] : request.columns) add(part, channel.name);
  for (const DataVariable& variable : names.variables())
    for (const std::string& base : bases_of(channel)) add(variable.name, base);
  return numbers;
}

// Of a line without columns: an excitation may have its level from elsewhere.
void require_known_level(const std::string& file, const LineColumns& line, const TableNames& names,
                         const TableRequest& request, bool per_excitation) {
  const std::string& name = request.channels[line.channel].name;
  if (request.channels[line.channel].role != ChannelRole::excitation || line.number != LineNumber{})
    throw InputError(file, "channel " + name + line_suffix(line.number),
                     "has no column of amplitudes: its variables are " + names.listed(),
                     fmt::format(fmt::runtime(request.words.column), name + line_suffix(line.number)));
  if (!request.convention.level)
    throw InputError(file, "channel " + name,
                     fmt::format("{}its level is not known: there is no column {}",
                                 per_excitation ? "responses are given per unit of it, and a nonlinear structure "
                                                  "answers to its level; "
                                                : "",
                                 name),
                     request.words.level);
}

void require_parts(const std::string& file, const LineColumns& line, const TableNames& names,
                   const TableRequest& request) {
  const std::string name = request.channels[line.channel].name + line_suffix(line.number);
  const bool drives = request.channels[line.channel].role == ChannelRole::excitation;
  if (drives && line.number == LineNumber{} && request.convention.level)
    throw InputError(file, "channel " + name, "has a column of levels and is given another one",
                     "leave the level out, or name the channel as no column is");
  if (!line.amplitude.empty() && line.phase.empty() && !drives && !line.number.is_mean())
    throw InputError(file, "channel " + name,
                     fmt::format("has amplitudes ({}) and no phases against the excitation: its variables are {}",
                                 line.amplitude, names.listed()),
                     fmt::format(fmt::runtime(request.words.column), name + ".phase"));
}

LineColumns line_columns(const std::string& file, std::size_t c, LineNumber number, TableNames& names,
                         const TableRequest& request) {
  const TableChannel& channel = request.channels[c];
  LineColumns line{c, number};
  const std::string name = channel.name + line_suffix(number);
  line.real = part_of(channel, number, "re", names);
  line.imaginary = part_of(channel, number, "im", names);
  if (line.real.empty() != line.imaginary.empty())
    throw InputError(file, "channel " + name,
                     fmt::format("has a{} part and no{} part", line.real.empty() ? "n imaginary" : " real",
                                 line.real.empty() ? " real" : " imaginary"),
                     fmt::format("columns {0}.re and {0}.im, or {0} and {0}.phase", name));
  if (line.real.empty()) {
    line.amplitude = part_of(channel, number, "", names);
    if (!number.is_mean()) line.phase = part_of(channel, number, "phase", names);
    const bool only_response = request.channels.size() == 2 && channel.role == ChannelRole::response;
    if (line.phase.empty() && number == LineNumber{} && only_response)
      line.phase = names.first_of({"phase"}).value_or("");
  }
  line.sd = part_of(channel, number, "sd", names);
  line.phase_sd = part_of(channel, number, "phase_sd", names);
  return line;
}

}  // namespace

std::vector<std::string> FoundColumns::all() const {
  std::vector<std::string> names = {frequency};
  const auto add = [&](const std::string& column) {
    if (!column.empty() && std::find(names.begin(), names.end(), column) == names.end()) names.push_back(column);
  };
  add(condition);
  for (const LineColumns& line : lines)
    for (const std::string* column :
         {&line.amplitude, &line.phase, &line.real, &line.imaginary, &line.sd, &line.phase_sd})
      add(*column);
  return names;
}

FoundColumns find_columns(const std::string& file, const std::vector<DataVariable>& variables,
                          const TableRequest& request) {
  FoundColumns columns;
  columns.per_excitation = request.convention.per_excitation || holds_response_functions(variables, request);
  columns.excitation = only_excitation(file, request);
  TableNames names(file, variables, request.columns);
  columns.frequency = frequency_column(file, names, request);
  columns.condition = condition_column(names, request);
  for (std::size_t c = 0; c < request.channels.size(); ++c)
    for (const LineNumber number : numbers_of(request.channels[c], names, request)) {
      LineColumns line = line_columns(file, c, number, names, request);
      if (line.found()) {
        require_parts(file, line, names, request);
        columns.lines.push_back(std::move(line));
      } else {
        require_known_level(file, line, names, request, columns.per_excitation);
      }
    }
  names.require_known_parts();
  columns.unused = names.unused();
  return columns;
}

}  // namespace secular
