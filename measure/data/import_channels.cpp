#include "measure/data/import_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "measure/data/names.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

// Takes ":LAST" off the end of `text`; false if there is no colon.
bool take_last_field(std::string& text, std::string& field) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  field = text.substr(colon + 1);
  text.resize(colon);
  return true;
}

std::vector<std::string> all_names(const Variables& variables) {
  std::vector<std::string> names;
  for (const DataVariable& variable : variables) names.push_back(variable.name);
  return names;
}

// NAME may hold colons and, where the file has such a variable, equals signs: the fields behind it are fixed.
DescribedChannel named_channel(const std::string& option, const std::string& name, const Variables& variables,
                               const std::string& file) {
  DescribedChannel described{{name, ChannelRole::response, Quantity::acceleration, ""}, name};
  const std::size_t equals = name.find('=');
  if (!find_variable(variables, name) && equals != std::string::npos) {
    described.channel.name = name.substr(0, equals);
    described.variable = name.substr(equals + 1);
  }
  if (const std::string fault = matrix_fault(described.variable, all_names(variables)); !fault.empty())
    throw InputError(option, "", fmt::format("variable {} of {} {}", described.variable, file, fault),
                     fmt::format("name one of them, as in --channel NEWNAME='{}(:,1)':...", described.variable));
  if (!find_variable(variables, described.variable))
    throw InputError(
        option, "", fmt::format("{} has no variable '{}'", file, described.variable),
        remedy_for_word("its variables are " + listed_names(variables), described.variable, all_names(variables)));
  if (const std::string fault = channel_name_fault(described.channel.name); !fault.empty())
    throw InputError(option, "name", fault, "write NEWNAME=VARIABLE:ROLE:QUANTITY:UNIT to rename it");
  return described;
}

// NAME:ROLE, where the file itself says quantity and unit.
DescribedChannel short_channel(const std::string& text, ChannelRole role, const std::string& name,
                               const Variables& variables, const std::string& file) {
  const std::string option = "--channel " + text;
  DescribedChannel described = named_channel(option, name, variables, file);
  const DataVariable& variable = *find_variable(variables, described.variable);
  if (!variable.quantity)
    throw InputError(option, "",
                     variable.stated_unit.empty()
                         ? fmt::format("{} does not say what '{}' measures and in which unit", file, variable.name)
                         : fmt::format("{} gives '{}' the unit '{}', which does not say what it measures", file,
                                       variable.name, variable.stated_unit),
                     std::string("give ") + (variable.of_full_scale ? factor_form : channel_form));
  described.channel.role = role;
  described.channel.quantity = *variable.quantity;
  described.channel.unit = variable.unit;
  described.stated_by_files = true;
  return described;
}

// Takes ":FACTOR" off the end of NAME:ROLE:QUANTITY:UNIT:FACTOR. A unit may be a number too (1): the fields before
// it tell.
std::optional<double> take_factor(std::string& text) {
  std::string rest = text, last, unit, quantity, role;
  if (!take_last_field(rest, last)) return std::nullopt;
  const std::string without = rest;
  if (!take_last_field(rest, unit) || !take_last_field(rest, quantity) || !take_last_field(rest, role) ||
      !parse_role(role) || !parse_quantity(quantity))
    return std::nullopt;
  double factor = 0;
  const auto end = std::from_chars(last.data(), last.data() + last.size(), factor);
  if (end.ec != std::errc() || end.ptr != last.data() + last.size() || !std::isfinite(factor) || factor == 0)
    throw InputError("--channel " + text, "factor", "is '" + last + "'", "a number other than zero was expected");
  text = without;
  return factor;
}

// What a number of the file means: the unit given, times the factor given, unless the file says it all itself.
void give_unit(DescribedChannel& described, const std::string& unit, std::optional<double> factor,
               const DataVariable& variable, const std::string& option, const std::string& file) {
  Channel& channel = described.channel;
  const std::optional<UnitMeaning> meaning = unit_meaning(usual_spelling(unit));
  if (!meaning || meaning->quantity != channel.quantity)
    throw InputError(option, "unit", unit_fault(channel.quantity, unit),
                     meaning ? "" : std::string("or, where a number stands for so much of it, ") + factor_form);
  channel.unit = si_unit(channel.quantity);
  described.si_factor = meaning->si_factor * factor.value_or(1);
  if (factor && variable.quantity == Quantity::voltage && channel.quantity != Quantity::voltage) {
    // What an amplifier gives for the quantity; the factor is that of a number of the file, in its own unit.
    const std::optional<UnitMeaning> stated = unit_meaning(usual_spelling(variable.stated_unit));
    described.si_factor /= stated ? stated->si_factor : 1;
    described.of_voltage = true;
    described.given_unit = fmt::format("{} {} for {}", *factor, unit, variable.stated_unit);
    return;
  }
  if (!variable.unit.empty()) {
    if (factor || (meaning->si_factor != 1 && usual_spelling(variable.stated_unit) != usual_spelling(unit)))
      throw InputError(option, factor ? "factor" : "unit",
                       fmt::format("{} states the unit '{}' itself", file, variable.stated_unit),
                       "give NAME:ROLE alone");
    return;
  }
  if (!factor && variable.of_full_scale)
    throw InputError(
        option, "",
        fmt::format("{} holds fractions of full scale, and does not say what that is in {}", file, unit),
        std::string("give ") + factor_form);
  if (const std::string other = other_measure(variable.stated_unit); !factor && !other.empty())
    throw InputError(option, "unit",
                     fmt::format("is '{}', {} says '{}' ({})", unit, file, variable.stated_unit, other),
                     std::string("give ") + factor_form);
  if (factor)
    described.given_unit = fmt::format("{} {}", *factor, unit);
  else if (usual_spelling(unit) != channel.unit)
    described.given_unit = unit;
}

DescribedChannel parse_channel(const std::string& text, const Variables& variables, const std::string& file) {
  const std::string option = "--channel " + text;
  if (std::string last, before = text; take_last_field(before, last))
    if (const auto role = parse_role(last)) return short_channel(text, *role, before, variables, file);
  std::string name = text, role_text, quantity_text, unit;
  const std::optional<double> factor = take_factor(name);
  int fields = 1;
  for (std::string* field : {&unit, &quantity_text, &role_text}) {
    if (!take_last_field(name, *field))
      throw InputError(option, "", fmt::format("has {} of four fields", fields),
                       remedy_for_word(channel_form, fields == 2 ? unit : quantity_text, words_of(role_names)));
    ++fields;
  }
  DescribedChannel described = named_channel(option, name, variables, file);
  const auto role = parse_role(role_text);
  if (!role)
    throw InputError(option, "role", "is '" + role_text + "'",
                     remedy_for_word("excitation or response was expected", role_text, words_of(role_names)));
  const auto quantity = parse_quantity(quantity_text);
  if (!quantity)
    throw InputError(
        option, "quantity", "is '" + quantity_text + "'",
        remedy_for_word(std::string(quantity_list) + " was expected", quantity_text, words_of(quantity_names)));
  described.channel.role = *role;
  described.channel.quantity = *quantity;
  give_unit(described, unit, factor, *find_variable(variables, described.variable), option, file);
  return described;
}

// What the files say of their channels, and how to say the rest.
[[noreturn]] void ask_for_channels(const std::string& file, const Variables& variables) {
  const auto stated = std::find_if(variables.begin(), variables.end(),
                                   [](const DataVariable& v) { return v.quantity.has_value(); });
  const std::string wrong = "no channel of it is described: its variables are " + listed_names(variables);
  if (stated == variables.end())
    throw InputError(file, "", wrong, std::string("give for each channel ") + channel_form);
  throw InputError(
      file, "", wrong,
      fmt::format("give for each channel --channel NAME:ROLE, for example {}:response ({} in {}, as the "
                  "file says), or --channel NAME:ROLE:QUANTITY:UNIT where the file does not say it",
                  stated->name, to_string(*stated->quantity), stated->unit));
}

// --delay NAME=S.
void take_delay(const std::string& text, std::vector<DescribedChannel>& described) {
  const std::size_t equals = text.rfind('=');
  const std::string name = text.substr(0, equals);
  const auto found = std::find_if(described.begin(), described.end(),
                                  [&](const DescribedChannel& d) { return d.channel.name == name; });
  if (equals == std::string::npos || found == described.end())
    throw InputError("--delay " + text, "", "names no channel that is imported",
                     "NAME=S, by how many seconds a channel is late");
  const std::string digits = text.substr(equals + 1);
  double delay = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), delay);
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size() || !std::isfinite(delay))
    throw InputError("--delay " + text, "", "has no number of seconds", "NAME=S, for example tip=0.002");
  if (found->channel.delay_s != 0)
    throw InputError("--delay " + text, "", "is the second delay of this channel", "one for each channel");
  found->channel.delay_s = delay;
}

}  // namespace

std::string listed_names(const Variables& variables) {
  std::string list;
  for (std::size_t i = 0; i < variables.size() && i < 20; ++i) list += (i ? ", " : "") + variables[i].name;
  return list + (variables.size() > 20 ? fmt::format(" and {} more", variables.size() - 20) : "");
}

const DataVariable* find_variable(const Variables& variables, const std::string& name) {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const DataVariable& v) { return v.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

std::vector<DescribedChannel> describe_channels(const ImportOptions& options, const Variables& variables) {
  const std::string file = options.files.front().string();
  if (options.channels.empty()) ask_for_channels(file, variables);
  std::vector<DescribedChannel> described;
  std::set<std::string> names;
  bool any_response = false;
  for (const std::string& text : options.channels) {
    described.push_back(parse_channel(text, variables, file));
    any_response = any_response || described.back().channel.role == ChannelRole::response;
    if (!names.insert(described.back().channel.name).second)
      throw InputError("--channel " + text, "name", "is described twice", "every channel has a name of its own");
  }
  for (const std::string& name : options.absolute) {
    const auto found = std::find_if(described.begin(), described.end(),
                                    [&](const DescribedChannel& d) { return d.channel.name == name; });
    if (found == described.end())
      throw InputError(name, "frame", "belongs to no channel", "name a channel that is imported");
    found->channel.frame = Frame::absolute;
  }
  for (const std::string& text : options.delays) take_delay(text, described);
  if (!any_response)
    throw InputError("--channel", "", "no channel is a response", "describe at least one with the role response");
  return described;
}

}  // namespace secular
