#include "estimator/campaign/import_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "estimator/campaign/data_file.hpp"
#include "estimator/campaign/names.hpp"
#include "estimator/campaign/time_axis.hpp"
#include "estimator/campaign/unit.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

constexpr const char* channel_form = "--channel NAME:ROLE:QUANTITY:UNIT, for example theta:response:angle:rad";

using Variables = std::vector<DataVariable>;

std::string listed(const Variables& variables) {
  std::string list;
  for (std::size_t i = 0; i < variables.size() && i < 20; ++i) list += (i ? ", " : "") + variables[i].name;
  return list + (variables.size() > 20 ? fmt::format(" and {} more", variables.size() - 20) : "");
}

const DataVariable* find(const Variables& variables, const std::string& name) {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const DataVariable& v) { return v.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct DescribedChannel {
  Channel channel;
  std::string variable;          // of the files
  bool stated_by_files = false;  // quantity and unit
};

// Takes ":LAST" off the end of `text`; false if there is no colon.
bool take_last_field(std::string& text, std::string& field) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  field = text.substr(colon + 1);
  text.resize(colon);
  return true;
}

// NAME may hold colons and, where the file has such a variable, equals signs: the fields behind it are fixed.
DescribedChannel named_channel(const std::string& option, const std::string& name, const Variables& variables,
                               const std::string& file) {
  DescribedChannel described{{name, ChannelRole::response, Quantity::acceleration, ""}, name};
  const std::size_t equals = name.find('=');
  if (!find(variables, name) && equals != std::string::npos) {
    described.channel.name = name.substr(0, equals);
    described.variable = name.substr(equals + 1);
  }
  if (!find(variables, described.variable))
    throw InputError(option, "", fmt::format("{} has no variable '{}'", file, described.variable),
                     "its variables are " + listed(variables));
  if (const std::string fault = channel_name_fault(described.channel.name); !fault.empty())
    throw InputError(option, "name", fault, "write NEWNAME=VARIABLE:ROLE:QUANTITY:UNIT to rename it");
  return described;
}

// NAME:ROLE, where the file itself says quantity and unit.
DescribedChannel short_channel(const std::string& text, ChannelRole role, const std::string& name,
                               const Variables& variables, const std::string& file) {
  const std::string option = "--channel " + text;
  DescribedChannel described = named_channel(option, name, variables, file);
  const DataVariable& variable = *find(variables, described.variable);
  if (!variable.quantity)
    throw InputError(option, "",
                     variable.stated_unit.empty()
                         ? fmt::format("{} does not say what '{}' measures and in which unit", file, variable.name)
                         : fmt::format("{} gives '{}' the unit '{}', which does not say what it measures", file,
                                       variable.name, variable.stated_unit),
                     std::string("give ") + channel_form);
  described.channel.role = role;
  described.channel.quantity = *variable.quantity;
  described.channel.unit = variable.unit;
  described.stated_by_files = true;
  return described;
}

DescribedChannel parse_channel(const std::string& text, const Variables& variables, const std::string& file) {
  const std::string option = "--channel " + text;
  std::string name = text, role_text, quantity_text, unit;
  if (std::string last, before = text; take_last_field(before, last))
    if (const auto role = parse_role(last)) return short_channel(text, *role, before, variables, file);
  int fields = 1;
  for (std::string* field : {&unit, &quantity_text, &role_text}) {
    if (!take_last_field(name, *field))
      throw InputError(option, "", fmt::format("has {} of four fields", fields), channel_form);
    ++fields;
  }
  DescribedChannel described = named_channel(option, name, variables, file);
  const auto role = parse_role(role_text);
  if (!role) throw InputError(option, "role", "is '" + role_text + "'", "excitation or response was expected");
  const auto quantity = parse_quantity(quantity_text);
  if (!quantity)
    throw InputError(option, "quantity", "is '" + quantity_text + "'",
                     std::string(quantity_list) + " was expected");
  described.channel.role = *role;
  described.channel.quantity = *quantity;
  described.channel.unit = unit;
  if (const std::string fault = unit_fault(*quantity, unit); !fault.empty())
    throw InputError(option, "unit", fault);
  return described;
}

// What the files say of their channels, and how to say the rest.
[[noreturn]] void ask_for_channels(const std::string& file, const Variables& variables) {
  const auto stated = std::find_if(variables.begin(), variables.end(),
                                   [](const DataVariable& v) { return v.quantity.has_value(); });
  const std::string wrong = "no channel of it is described: its variables are " + listed(variables);
  if (stated == variables.end())
    throw InputError(file, "", wrong, std::string("give for each channel ") + channel_form);
  throw InputError(
      file, "", wrong,
      fmt::format("give for each channel --channel NAME:ROLE, for example {}:response ({} in {}, as the "
                  "file says), or --channel NAME:ROLE:QUANTITY:UNIT where the file does not say it",
                  stated->name, to_string(*stated->quantity), stated->unit));
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
  if (!any_response)
    throw InputError("--channel", "", "no channel is a response", "describe at least one with the role response");
  return described;
}

// The variable that holds time, or empty where --sample-rate stands for it.
std::string time_variable(const ImportOptions& options, const Variables& variables, const std::string& file) {
  if (!options.time.empty()) {
    if (find(variables, options.time)) return options.time;
    throw InputError("--time " + options.time, "", fmt::format("{} has no such variable", file),
                     "its variables are " + listed(variables));
  }
  if (options.sample_rate_hz) return {};
  if (find(variables, "t")) return "t";
  throw InputError(file, "", "what its time is, is not known: its variables are " + listed(variables),
                   "name the variable with --time NAME, or give --sample-rate HZ");
}

RecordKind record_kind(const std::string& text) {
  if (text.empty())
    throw InputError("--kind", "", "what kind of records these are, is not known",
                     "give --kind " + std::string(record_kind_list));
  const auto kind = parse_record_kind(text);
  if (!kind)
    throw InputError("--kind " + text, "", "is no kind of record", std::string(record_kind_list) + " was expected");
  return *kind;
}

// Value of an option that is given once for all files or once a file.
std::optional<double> of_file(const std::vector<double>& values, std::size_t file, std::size_t files,
                              const char* option) {
  if (values.empty()) return std::nullopt;
  if (values.size() != 1 && values.size() != files)
    throw InputError(option, "", fmt::format("has {} values for {} files", values.size(), files),
                     "one for all files or one for each was expected");
  const double value = values.size() == 1 ? values.front() : values[file];
  if (!std::isfinite(value) || value <= 0)
    throw InputError(option, "", fmt::format("is {}", value), "a positive number was expected");
  return value;
}

// A file name that says where the record came from, in characters every system knows.
std::string record_file(const std::filesystem::path& source, std::set<std::string>& taken) {
  std::string stem;
  for (const char c : source.stem().string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                       c == '-' || c == '.';
    stem += plain ? c : '_';
  }
  // The writer puts .csv in place of an extension: a point of the name must not look like one.
  std::string name = "records/" + stem + ".csv";
  for (int copy = 2; !taken.insert(name).second; ++copy) name = fmt::format("records/{}-{}.csv", stem, copy);
  return name;
}

Record read_file(const std::filesystem::path& path, const std::vector<DescribedChannel>& channels,
                 const std::string& time, std::optional<double> sample_rate_hz) {
  std::vector<std::string> wanted;
  for (const DescribedChannel& described : channels)
    if (!contains(wanted, described.variable)) wanted.push_back(described.variable);
  if (!time.empty() && !contains(wanted, time)) wanted.push_back(time);
  const DataFile data = read_data_file(path, wanted);
  Record record;
  if (time.empty()) {
    record.sample_rate_hz = *sample_rate_hz;
  } else {
    const TimeAxis axis = even_time_axis(data.vector(time).values, data.file, data.place, sample_rate_hz);
    if (sample_rate_hz && !(std::abs(axis.sample_rate_hz / *sample_rate_hz - 1) <= 1e-3))
      throw InputError(data.file, "variable " + time, fmt::format("is sampled at {} Hz", axis.sample_rate_hz),
                       fmt::format("--sample-rate says {}", *sample_rate_hz));
    record.start_s = axis.start_s;
    record.sample_rate_hz = axis.sample_rate_hz;
  }
  const std::string& first = time.empty() ? channels.front().variable : time;
  const std::size_t count = data.vector(first).values.size();
  for (const DescribedChannel& described : channels) {
    const DataVariable& variable = data.vector(described.variable);
    if (const std::string fault = quantity_fault(variable, described.channel.quantity); !fault.empty())
      throw InputError(
          data.file, "variable " + variable.name, fault,
          fmt::format("--channel {} says {}", described.channel.name, to_string(described.channel.quantity)));
    if (described.stated_by_files && !variable.quantity)
      throw InputError(data.file, "variable " + variable.name,
                       "does not say quantity and unit, as the first file does",
                       std::string("give ") + channel_form);
    record.channels.push_back(variable.values);
    if (record.channels.back().size() != count)
      throw InputError(data.file, "variable " + described.variable,
                       fmt::format("has {} samples, {} has {}", record.channels.back().size(), first, count),
                       "all channels of a record have one length");
  }
  if (count < 2) throw InputError(data.file, "", "has fewer than two samples", "a record needs many samples");
  return record;
}

}  // namespace

ImportedCampaign import_files(const ImportOptions& options) {
  if (options.files.empty()) throw InputError("FILE", "", "no file is named", "name the files to import");
  if (options.sample_rate_hz && (!std::isfinite(*options.sample_rate_hz) || *options.sample_rate_hz <= 0))
    throw InputError("--sample-rate", "", "is not positive", "a rate in Hz was expected");
  if (options.ensemble_s && (!std::isfinite(*options.ensemble_s) || *options.ensemble_s <= 0))
    throw InputError("--ensemble", "", "is not positive", "a duration in seconds was expected");
  const Variables variables = describe_data_file(options.files.front());
  const std::vector<DescribedChannel> channels = describe_channels(options, variables);
  const std::string time = time_variable(options, variables, options.files.front().string());
  const RecordKind kind = record_kind(options.kind);

  ImportedCampaign imported;
  Campaign& campaign = imported.campaign;
  campaign.name = options.name.empty() ? options.files.front().stem().string() : options.name;
  for (const DescribedChannel& described : channels) campaign.channels.push_back(described.channel);
  for (const DataVariable& variable : variables) {
    const auto channel = std::find_if(channels.begin(), channels.end(),
                                      [&](const DescribedChannel& d) { return d.variable == variable.name; });
    if (channel == channels.end()) {
      if (variable.name != time) imported.left_out.push_back(variable.name);
    } else if (!variable.unit.empty() && variable.stated_unit != variable.unit) {
      imported.converted.push_back({channel->channel.name, variable.stated_unit, variable.unit});
    }
  }
  std::set<std::string> taken;
  for (std::size_t f = 0; f < options.files.size(); ++f) {
    // Files after the first are expected at the first one's rate.
    const std::optional<double> expected = f == 0 ? options.sample_rate_hz : std::optional(campaign.sample_rate_hz);
    imported.samples.push_back(read_file(options.files[f], channels, time, expected));
    if (f == 0) campaign.sample_rate_hz = imported.samples.front().sample_rate_hz;
    RecordEntry entry;
    entry.file = record_file(options.files[f], taken);
    entry.kind = kind;
    entry.excitation_frequency_hz = of_file(options.frequencies_hz, f, options.files.size(), "--frequency");
    if (entry.excitation_frequency_hz && *entry.excitation_frequency_hz >= 0.5 * campaign.sample_rate_hz)
      throw InputError("--frequency", "",
                       fmt::format("is {}, not below half the sample rate", *entry.excitation_frequency_hz),
                       "check the unit (Hz)");
    entry.excitation_amplitude = of_file(options.amplitudes, f, options.files.size(), "--amplitude");
    entry.ensemble_s = options.ensemble_s;
    entry.group = options.group;
    campaign.records.push_back(std::move(entry));
  }
  return imported;
}

}  // namespace secular
