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

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < 20; ++i) list += (i ? ", " : "") + names[i];
  return list + (names.size() > 20 ? fmt::format(" and {} more", names.size() - 20) : "");
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct DescribedChannel {
  Channel channel;
  std::string variable;  // of the files
};

// NAME may hold colons and, where the file has such a variable, equals signs: the last three fields are fixed.
DescribedChannel parse_channel(const std::string& text, const std::vector<std::string>& variables,
                               const std::string& file) {
  const std::string option = "--channel " + text;
  std::vector<std::string> fields;
  std::string name = text;
  for (int i = 0; i < 3; ++i) {
    const std::size_t colon = name.rfind(':');
    if (colon == std::string::npos)
      throw InputError(option, "", fmt::format("has {} of four fields", fields.size() + 1), channel_form);
    fields.insert(fields.begin(), name.substr(colon + 1));
    name.resize(colon);
  }
  DescribedChannel described{{name, ChannelRole::response, Quantity::acceleration, fields[2]}, name};
  const std::size_t equals = name.find('=');
  if (!contains(variables, name) && equals != std::string::npos) {
    described.channel.name = name.substr(0, equals);
    described.variable = name.substr(equals + 1);
  }
  if (!contains(variables, described.variable))
    throw InputError(option, "", fmt::format("{} has no variable '{}'", file, described.variable),
                     "its variables are " + listed(variables));
  if (const std::string fault = channel_name_fault(described.channel.name); !fault.empty())
    throw InputError(option, "name", fault, "write NEWNAME=VARIABLE:ROLE:QUANTITY:UNIT to rename it");
  const auto role = parse_role(fields[0]);
  if (!role) throw InputError(option, "role", "is '" + fields[0] + "'", "excitation or response was expected");
  const auto quantity = parse_quantity(fields[1]);
  if (!quantity)
    throw InputError(option, "quantity", "is '" + fields[1] + "'", std::string(quantity_list) + " was expected");
  described.channel.role = *role;
  described.channel.quantity = *quantity;
  if (const std::string fault = unit_fault(*quantity, fields[2]); !fault.empty())
    throw InputError(option, "unit", fault);
  return described;
}

std::vector<DescribedChannel> describe_channels(const ImportOptions& options,
                                                const std::vector<std::string>& variables) {
  const std::string file = options.files.front().string();
  if (options.channels.empty())
    throw InputError(file, "", "no channel of it is described: its variables are " + listed(variables),
                     std::string("give for each channel ") + channel_form);
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
std::string time_variable(const ImportOptions& options, const std::vector<std::string>& variables,
                          const std::string& file) {
  if (!options.time.empty()) {
    if (contains(variables, options.time)) return options.time;
    throw InputError("--time " + options.time, "", fmt::format("{} has no such variable", file),
                     "its variables are " + listed(variables));
  }
  if (options.sample_rate_hz) return {};
  if (contains(variables, "t")) return "t";
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
    record.channels.push_back(data.vector(described.variable).values);
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
  const std::vector<std::string> variables = data_variable_names(options.files.front());
  const std::vector<DescribedChannel> channels = describe_channels(options, variables);
  const std::string time = time_variable(options, variables, options.files.front().string());
  const RecordKind kind = record_kind(options.kind);

  ImportedCampaign imported;
  Campaign& campaign = imported.campaign;
  campaign.name = options.name.empty() ? options.files.front().stem().string() : options.name;
  for (const DescribedChannel& described : channels) campaign.channels.push_back(described.channel);
  for (const std::string& variable : variables) {
    const bool used =
        variable == time || std::any_of(channels.begin(), channels.end(),
                                        [&](const DescribedChannel& d) { return d.variable == variable; });
    if (!used) imported.left_out.push_back(variable);
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
