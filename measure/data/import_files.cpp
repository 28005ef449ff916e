#include "measure/data/import_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "measure/data/channel_times.hpp"
#include "measure/data/import_channels.hpp"
#include "measure/data/import_geometry.hpp"
#include "measure/data/import_parts.hpp"
#include "measure/data/jitter.hpp"
#include "measure/data/missing_cells.hpp"
#include "measure/data/names.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/numbered_options.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/unit.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// How the rows of files are read.
struct RowChoice {
  std::string variable;  // of time; empty where --sample-rate stands for it
  std::string unit;      // given with --time
  DecimalMark mark = DecimalMark::by_dialect;
};

RowChoice time_variable(const ImportOptions& options, const Variables& variables, const std::string& file) {
  if (!options.time.empty()) {
    if (find_variable(variables, options.time)) return {options.time, "", {}};
    const std::size_t colon = options.time.rfind(':');
    if (colon != std::string::npos && find_variable(variables, options.time.substr(0, colon)))
      return {options.time.substr(0, colon), options.time.substr(colon + 1), {}};
    std::vector<std::string> names;
    for (const DataVariable& variable : variables) names.push_back(variable.name);
    if (const std::string fault = matrix_fault(options.time, names); !fault.empty())
      throw InputError("--time " + options.time, "", fmt::format("this variable of {} {}", file, fault),
                       "name one of them, or give --sample-rate HZ");
    throw InputError("--time " + options.time, "", fmt::format("{} has no such variable", file),
                     remedy_for_word("its variables are " + listed_names(variables), options.time, names));
  }
  if (options.sample_rate_hz) return {};
  if (find_variable(variables, "t")) return {"t", "", {}};
  const auto is_time = [](const DataVariable& variable) { return is_called_time(variable.name); };
  const auto only = std::find_if(variables.begin(), variables.end(), is_time);
  if (only != variables.end() && std::find_if(only + 1, variables.end(), is_time) == variables.end())
    return {only->name, "", {}};
  throw InputError(file, "", "what its time is, is not known: its variables are " + listed_names(variables),
                   "name the variable with --time NAME, or give --sample-rate HZ");
}

RecordKind record_kind(const std::string& text) {
  if (text.empty())
    throw InputError("--kind", "", "what kind of records these are, is not known",
                     "give --kind " + std::string(record_kind_list));
  const auto kind = parse_record_kind(text);
  if (!kind)
    throw InputError(
        "--kind " + text, "", "is no kind of record",
        remedy_for_word(std::string(record_kind_list) + " was expected", text, words_of(record_kind_names)));
  if (kind == RecordKind::lines) throw std::invalid_argument("import_files: tables are read by import_tables");
  return *kind;
}

DecimalMark decimal_mark(const std::string& text) {
  if (text.empty()) return DecimalMark::by_dialect;
  if (text == ".") return DecimalMark::point;
  if (text == ",") return DecimalMark::comma;
  throw InputError("--decimal-mark", "", "is '" + text + "'", ". or , was expected");
}

/// A file, or one of the segments that it holds one behind the other, or its variables of one number.
struct RecordSource {
  std::filesystem::path path;
  std::size_t segment = 0;
  std::vector<DescribedChannel> channels;
  RowChoice rows;
};

// Files after the first hold what it holds, but for how often.
std::vector<RecordSource> sources_of(const ImportOptions& options, const Variables& variables) {
  std::vector<RecordSource> sources;
  for (const std::filesystem::path& path : options.files) {
    const bool first = sources.empty();
    const bool numbers = numbers_in(options, variables, options.files.front().string()).front() != "";
    const Variables own = first || !numbers ? variables : describe_data_file(path);
    for (const std::string& number : numbers_in(options, own, path.string())) {
      const ImportOptions chosen = numbered(options, number);
      const std::vector<DescribedChannel> channels = describe_channels(chosen, own);
      RowChoice rows = time_variable(chosen, own, options.files.front().string());
      rows.mark = decimal_mark(options.decimal_mark);
      for (std::size_t segment = 0, count = count_segments(path); segment < count; ++segment)
        sources.push_back({path, segment, channels, rows});
    }
  }
  return sources;
}

/// What every file of a campaign is expected to hold.
struct ExpectedFile {
  const std::vector<DescribedChannel>& channels;
  const RowChoice& rows;
  std::optional<double> sample_rate_hz;
  const char* rate_from;  // says whose rate that is
};

struct ReadFile {
  Record record;
  std::string time_unit;  // as the file states it
  std::vector<std::string> warnings;
};

DataFile read_variables(const RecordSource& source, const ExpectedFile& expected) {
  const std::string& time = expected.rows.variable;
  std::vector<std::string> wanted;
  for (const DescribedChannel& described : expected.channels)
    if (!contains(wanted, described.variable)) wanted.push_back(described.variable);
  if (!time.empty() && !contains(wanted, time)) wanted.push_back(time);
  DataFile data = read_data_file(source.path, wanted, MissingNumbers::keep_gaps, all_values, expected.rows.mark,
                                 source.segment);
  convert_csv_units(data);
  return data;
}

// Start, rate and jitter.
void read_time(DataFile& data, const ExpectedFile& expected, ReadFile& read) {
  Record& record = read.record;
  const std::string& time = expected.rows.variable;
  if (time.empty()) {
    record.sample_rate_hz = *expected.sample_rate_hz;
    return;
  }
  DataVariable& stamps = data.vector(time);
  convert_to_seconds(stamps, data.file, expected.rows.unit);
  read.time_unit = stamps.stated_unit;
  const TimeAxis axis = even_time_axis(stamps.values, data.file, data.place, expected.sample_rate_hz);
  if (expected.sample_rate_hz &&
      !(std::abs(axis.sample_rate_hz / *expected.sample_rate_hz - 1) <= measure_thresholds().same_setting))
    throw InputError(data.file, "variable " + time, fmt::format("is sampled at {} Hz", axis.sample_rate_hz),
                     fmt::format("{} {}", expected.rate_from, *expected.sample_rate_hz));
  record.start_s = axis.start_s;
  record.sample_rate_hz = axis.sample_rate_hz;
  record.jitter_s = axis.jitter_s;
}

// By channel: samples by which it is late.
std::vector<std::optional<std::ptrdiff_t>> read_delays(DataFile& data, const ExpectedFile& expected,
                                                       std::vector<std::string>& warnings) {
  const std::string& time = expected.rows.variable;
  std::vector<std::string> variables;
  for (const DescribedChannel& described : expected.channels) variables.push_back(described.variable);
  const auto delays =
      channel_delays(data, time, variables, time.empty() ? std::vector<double>{} : data.vector(time).values);
  for (std::size_t c = 0; c < variables.size(); ++c)
    if (delays[c].value_or(0) != 0)
      warnings.push_back(
          fmt::format("{}: {} begins {} samples {} by a time of its own: shifted, and all channels cut to what "
                      "they have in common",
                      data.file, variables[c], std::abs(*delays[c]), *delays[c] > 0 ? "later" : "earlier"));
  return delays;
}

void check_quantity(const DataVariable& variable, const DescribedChannel& described, const std::string& file) {
  const Quantity expected = described.of_voltage ? Quantity::voltage : described.channel.quantity;
  if (const std::string fault = quantity_fault(variable, expected); !fault.empty())
    throw InputError(
        file, "variable " + variable.name, fault,
        fmt::format("--channel {} says {}", described.channel.name, to_string(described.channel.quantity)));
  if (described.stated_by_files && !variable.quantity)
    throw InputError(file, "variable " + variable.name, "does not say quantity and unit, as the first file does",
                     std::string("give ") + channel_form);
}

// Samples that are no numbers stay what they are: whoever reads the record knows that they follow from others.
void note_missing(const DataFile& data, const std::vector<DescribedChannel>& channels, ReadFile& read) {
  Record& record = read.record;
  record.no_numbers = missing_cells(record.channels);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::size_t missing = record.no_numbers[c].size();
    if (missing == 0) continue;
    const std::string& name = channels[c].channel.name;
    std::vector<std::vector<double>> filled = {record.channels[c]};
    fill_missing_cells(filled);
    RowPlace place = data.place;
    place.first += drop_ends_without_numbers(filled.front());
    require_filled(filled.front(), name, data.file, place);
    read.warnings.push_back(fmt::format(
        "{}: {} of {} samples of {} are no finite numbers: written as nan, and replaced by what is around "
        "them, or cut off at the ends, where the record is read",
        data.file, missing, record.samples(), name));
  }
}

ReadFile read_file(const RecordSource& source, const ExpectedFile& expected) {
  DataFile data = read_variables(source, expected);
  ReadFile read;
  Record& record = read.record;
  read_time(data, expected, read);
  const auto delays = read_delays(data, expected, read.warnings);
  const std::vector<DescribedChannel>& channels = expected.channels;
  const std::string& time = expected.rows.variable;
  const std::string& first = time.empty() ? channels.front().variable : time;
  const std::size_t count = data.vector(first).values.size();
  for (auto described = channels.begin(); described != channels.end(); ++described) {
    DataVariable& variable = data.vector(described->variable);
    check_quantity(variable, *described, data.file);
    const bool last = std::none_of(described + 1, channels.end(), [&](const DescribedChannel& later) {
      return later.variable == described->variable;
    });
    record.channels.push_back(last ? std::move(variable.values) : variable.values);
    if ((variable.unit.empty() || described->of_voltage) && described->si_factor != 1)
      for (double& value : record.channels.back()) value *= described->si_factor;
    drop_fill_values(record.channels.back());
    require_number_range(record.channels.back(), data.file, "variable " + described->variable);
    if (record.channels.back().size() != count && !delays[record.channels.size() - 1])
      throw InputError(data.file, "variable " + described->variable,
                       fmt::format("has {} samples, {} has {}", record.channels.back().size(), first, count),
                       "all channels of a record have one length");
  }
  const bool cut = std::any_of(record.channels.begin(), record.channels.end(),
                               [&](const std::vector<double>& samples) { return samples.size() != count; });
  if (cut || std::any_of(delays.begin(), delays.end(), [](const auto& delay) { return delay.value_or(0) != 0; }))
    record.start_s += static_cast<double>(align_channels(record.channels, delays)) / record.sample_rate_hz;
  if (record.samples() < 2)
    throw InputError(data.file, "",
                     cut ? "has channels that share fewer than two sampling times" : "has fewer than two samples",
                     "a record needs many samples");
  note_missing(data, channels, read);
  return read;
}

/// Rates of two times that are one: as those of the records of a campaign. And their first samples: rounding of
/// stamps.
constexpr auto& one_rate = measure_thresholds().same_setting;
constexpr auto& one_start = measure_thresholds().same_sample;

// A variable that no channel is named after and that rises evenly, but not as the time of the channels does: a
// second time axis. What was sampled by it stands at wrong instants now.
std::optional<std::string> other_time(const std::filesystem::path& path, const std::string& variable,
                                      const RowChoice& time) {
  try {
    DataFile data =
        read_data_file(path, {time.variable, variable}, MissingNumbers::keep_gaps, all_values, time.mark);
    if (data.format.starts_with("UFF"))
      return std::nullopt;  // its channels have times of their own, which are read
    convert_to_seconds(data.vector(time.variable), data.file, time.unit);
    convert_to_seconds(data.vector(variable), data.file);
    const TimeAxis own = even_time_axis(data.vector(time.variable).values, data.file, data.place),
                   other = even_time_axis(data.vector(variable).values, data.file, data.place);
    const double samples_later = std::abs(other.start_s - own.start_s) * own.sample_rate_hz;
    if (std::abs(other.sample_rate_hz / own.sample_rate_hz - 1) < one_rate && samples_later < one_start)
      return std::nullopt;
    return fmt::format(
        "{}: {} is a time, too, from {:.6g} s on at {:.6g} Hz; {} goes from {:.6g} s on at {:.6g} Hz. Channels "
        "that "
        "were sampled by {} are at wrong instants now: import them by themselves with --time {}",
        data.file, variable, other.start_s, other.sample_rate_hz, time.variable, own.start_s, own.sample_rate_hz,
        variable, variable);
  } catch (const InputError&) {
    return std::nullopt;  // no axis
  }
}

// What becomes of the variables of the first file.
void note_variables(const Variables& variables, const std::vector<RecordSource>& sources,
                    ImportedCampaign& imported) {
  const RowChoice& time = sources.front().rows;
  for (const DataVariable& variable : variables) {
    const DescribedChannel* channel = nullptr;
    bool is_time = false;
    for (const RecordSource& source : sources) {
      is_time = is_time || source.rows.variable == variable.name;
      for (const DescribedChannel& described : source.channels)
        if (!channel && described.variable == variable.name) channel = &described;
    }
    if (!channel) {
      if (is_time) continue;
      imported.left_out.push_back(variable.name);
      // Of a time that belongs to a channel ("tip.t") the begin is used (channel_delays).
      if (time.variable.empty() && is_called_time(variable.name) && variable.name.find('.') == std::string::npos)
        imported.warnings.push_back(fmt::format(
            "{}: {} is called a time and is not used, since --sample-rate stands for it: --time {} takes it",
            sources.front().path.string(), variable.name, variable.name));
      if (time.variable.empty() || !may_be_time(variable.name)) continue;
      if (auto warning = other_time(sources.front().path, variable.name, time))
        imported.warnings.push_back(std::move(*warning));
    } else if (std::any_of(imported.converted.begin(), imported.converted.end(),
                           [&](const ConvertedChannel& c) { return c.name == channel->channel.name; })) {
      continue;  // of another number
    } else if (!variable.unit.empty() && variable.stated_unit != variable.unit) {
      imported.converted.push_back({channel->channel.name, variable.stated_unit, variable.unit});
    } else if (!channel->given_unit.empty()) {
      imported.converted.push_back({channel->channel.name, channel->given_unit, channel->channel.unit});
    }
  }
}

}  // namespace

ImportedCampaign import_files(const ImportOptions& options, const RecordSink& sink) {
  if (options.files.empty()) throw InputError("FILE", "", "no file is named", "name the files to import");
  if (options.sample_rate_hz && (!std::isfinite(*options.sample_rate_hz) || *options.sample_rate_hz <= 0))
    throw InputError("--sample-rate", "", "is not positive", "a rate in Hz was expected");
  if (options.ensemble_s && (!std::isfinite(*options.ensemble_s) || *options.ensemble_s <= 0))
    throw InputError("--ensemble", "", "is not positive", "a duration in seconds was expected");
  if (options.table.any())
    throw InputError(
        "--column, --amplitudes, --phases, --phase-sign, --phase-offset, --per-excitation, --frequency-unit", "",
        "belong to tables", "give them with --kind lines");
  const Variables variables = describe_data_file(options.files.front());
  const std::vector<RecordSource> sources = sources_of(options, variables);
  const RecordKind kind = record_kind(options.kind);

  ImportedCampaign imported;
  Campaign& campaign = imported.campaign;
  campaign.name = options.name.empty() ? options.files.front().stem().string() : options.name;
  for (const DescribedChannel& described : sources.front().channels) campaign.channels.push_back(described.channel);
  campaign.geometry = import_geometry(options.geometry, options.files.front(), sources.front().channels, variables,
                                      imported.warnings);
  note_variables(variables, sources, imported);
  std::set<std::string> taken;
  for (std::size_t f = 0; f < sources.size(); ++f) {
    // Files after the first are expected at the first one's rate.
    const std::optional<double> expected = f == 0 ? options.sample_rate_hz : std::optional(campaign.sample_rate_hz);
    auto [record, time_unit, warnings] =
        read_file(sources[f], {sources[f].channels, sources[f].rows, expected,
                               options.sample_rate_hz ? "--sample-rate says" : "the first file's rate is"});
    imported.sources.push_back(sources[f].path);
    std::move(warnings.begin(), warnings.end(), std::back_inserter(imported.warnings));
    if (f == 0 && seconds_in(time_unit).value_or(1) != 1) imported.converted.push_back({"t", time_unit, "s"});
    if (f == 0) campaign.sample_rate_hz = record.sample_rate_hz;
    RecordEntry entry;
    entry.file = record_file(sources[f].path, taken);
    entry.kind = kind;
    entry.excitation_frequency_hz = of_file(options.frequencies_hz, f, sources.size(), "--frequency");
    if (entry.excitation_frequency_hz && *entry.excitation_frequency_hz >= 0.5 * campaign.sample_rate_hz)
      throw InputError("--frequency", "",
                       fmt::format("is {}, not below half the sample rate", *entry.excitation_frequency_hz),
                       "check the unit (Hz)");
    entry.excitation_amplitude = of_file(options.amplitudes, f, sources.size(), "--amplitude");
    entry.ensemble_s = options.ensemble_s;
    entry.group = options.group;
    if (record.jitter_s > 0)
      imported.warnings.push_back(
          sources[f].path.string() + ": " +
          jitter_text({record.start_s, record.sample_rate_hz, record.jitter_s}, record.channels));
    sink(campaign, entry, std::move(record));
    campaign.records.push_back(std::move(entry));
  }
  return imported;
}

}  // namespace secular
