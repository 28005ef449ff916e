#include "measure/data/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/jitter.hpp"
#include "measure/data/missing_cells.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/record_data.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/formats/csv_header.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/unit.hpp"
#include "measure/thresholds.hpp"
#include "numerics/fill_gaps.hpp"

namespace secular {
namespace {

std::string without_file(const InputError& error) {
  std::string text = error.place();
  text += (text.empty() ? "" : ": ") + error.wrong();
  return text + (error.right().empty() ? "" : "; " + error.right());
}

// The time axis, or a fault that says why there is none.
std::optional<TimeAxis> judged_axis(const std::vector<double>& stamps, const RowPlace& place,
                                    std::optional<double> expected_rate, std::vector<DataFault>& faults) {
  const auto missing = std::find_if(stamps.begin(), stamps.end(), [](double t) { return !std::isfinite(t); });
  if (missing != stamps.end()) {
    faults.push_back({"time", fmt::format("{}: the time stamp is missing or not finite",
                                          place.of(static_cast<std::size_t>(missing - stamps.begin())))});
    return std::nullopt;
  }
  try {
    return even_time_axis(stamps, "", place, expected_rate);
  } catch (const InputError& error) {
    faults.push_back({"time", without_file(error)});
    return std::nullopt;
  }
}

// The same for a variable in its own unit, which becomes seconds.
std::optional<TimeAxis> judged_time(DataVariable& time, const DataFile& data, std::vector<DataFault>& faults) {
  try {
    convert_to_seconds(time, data.file);
  } catch (const InputError& error) {
    faults.push_back({"time", without_file(error)});
    return std::nullopt;
  }
  return judged_axis(time.values, data.place, std::nullopt, faults);
}

// Samples of a channel that the limit leaves to each of `channels`.
std::size_t share_of(const InspectionLimit& limit, std::uintmax_t bytes, std::size_t channels) {
  if (bytes <= limit.whole_bytes || !limit.span.all()) return all_values;
  return std::max(limit.least_samples, limit.values / std::max<std::size_t>(1, channels));
}

std::uintmax_t size_of(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  return unknown ? 0 : size;
}

// Samples up to the last stamp of a CSV of about `rows` rows that goes on as it begins; a fault if it does not.
std::optional<std::size_t> samples_until(std::optional<double> last, const std::optional<TimeAxis>& axis,
                                         std::size_t rows, std::vector<DataFault>& faults) {
  if (!last || !axis) return std::nullopt;
  const double samples = std::round((*last - axis->start_s) * axis->sample_rate_hz) + 1;
  if (!(std::abs(samples / static_cast<double>(rows) - 1) < 0.2)) {
    faults.push_back(
        {"time", fmt::format("the last stamp, {} s, does not belong to about {} rows at {} Hz from {} s", *last,
                             rows, axis->sample_rate_hz, axis->start_s)});
    return std::nullopt;
  }
  return static_cast<std::size_t>(samples);
}

// Cuts channels of `samples` samples to a span and the axis with them; the number of samples left.
std::size_t cut(const TimeSpan& span, TimeAxis& axis, std::size_t samples,
                const std::vector<std::vector<double>*>& channels) {
  const SpanOfSamples kept = samples_within(span, axis.start_s, axis.sample_rate_hz, samples);
  for (std::vector<double>* channel : channels) {
    channel->resize(kept.first + kept.count);
    channel->erase(channel->begin(), channel->begin() + static_cast<std::ptrdiff_t>(kept.first));
  }
  axis.start_s += static_cast<double>(kept.first) / axis.sample_rate_hz;
  return kept.count;
}

void note_filled(const std::vector<std::size_t>& filled, std::size_t samples, ChannelQuality& quality) {
  quality.missing += filled.size();
  quality.faults.push_back(
      {"missing", fmt::format("{} of {} samples are no finite numbers, first sample {}: replaced by what those "
                              "around them tell",
                              filled.size(), samples, filled.front() + 1)});
}

// Levels and faults of what is left beside a number that stands for none, and that number.
ChannelQuality check_variable(std::vector<double> values) {
  const std::optional<FillValue> fill = suspected_fill_value(values);
  if (!fill) return check_channel(values);
  std::replace(values.begin(), values.end(), fill->value, std::nan(""));
  ChannelQuality quality = check_channel(values);
  std::erase_if(quality.faults, [](const DataFault& fault) { return fault.kind == "missing"; });
  quality.faults.insert(
      quality.faults.begin(),
      {"fill_value",
       fmt::format("{} of {} samples are {}, first sample {}: it seems to stand for samples that are "
                   "missing; write nan in its place (up to {} in a row are replaced by what those "
                   "around them tell)",
                   fill->count, values.size(), number_text(fill->value), fill->first + 1, longest_filled)});
  return quality;
}

// Without those that a number stood for which was none (Unrecorded).
MissingCells without_ends(MissingCells cells, const std::vector<Unrecorded>& ends) {
  for (const Unrecorded& part : ends) {
    std::vector<std::size_t>& places = cells[part.channel];
    if (!part.replaced || !std::isfinite(part.value) || places.size() < part.samples) continue;
    const auto begin = part.at_end ? places.end() - static_cast<std::ptrdiff_t>(part.samples) : places.begin();
    places.erase(begin, begin + static_cast<std::ptrdiff_t>(part.samples));
  }
  return cells;
}

RecordInspection inspect_record(const Campaign& campaign, std::size_t index, std::size_t limit,
                                const TimeSpan& span, const RecordLook& look) {
  RecordInspection inspection;
  if (campaign.records[index].row) {
    inspection.samples = inspection.judged = 1;
    return inspection;
  }
  try {
    RecordData data = read_record_data(campaign, campaign.records[index], MissingNumbers::keep_as_nan, limit);
    CutEnds cut = data.partial ? CutEnds{} : cut_unrecorded(campaign, data.stamps_s, data.channels);
    data.place.first += cut.first;
    FilledSamples filled = fill_missing(data.stamps_s, data.channels);
    inspection.judged = data.stamps_s.size();
    inspection.samples = data.total - cut.rows + filled.rows.size();
    inspection.axis = judged_axis(data.stamps_s, data.place, campaign.sample_rate_hz, inspection.faults);
    if (inspection.axis && !(std::abs(inspection.axis->sample_rate_hz / campaign.sample_rate_hz - 1) <=
                             measure_thresholds().same_setting))
      inspection.faults.push_back({"time", fmt::format("is sampled at {:.6g} Hz; campaign.toml says {}",
                                                       inspection.axis->sample_rate_hz, campaign.sample_rate_hz)});
    const TimeAxis axis = inspection.axis.value_or(TimeAxis{0, campaign.sample_rate_hz, 0});
    const MissingCells no_numbers = without_ends(filled.cells, cut.unrecorded);
    Record record{axis.start_s,           axis.sample_rate_hz,     std::move(data.channels),  axis.jitter_s,
                  std::move(filled.rows), std::move(filled.cells), std::move(cut.unrecorded), cut.rows};
    if (inspection.axis && !span.all()) {
      const SpanOfSamples kept = samples_within(span, record.start_s, axis.sample_rate_hz, record.samples());
      cut_record(record, kept.first, kept.count);
      inspection.axis->start_s = record.start_s;
      inspection.samples = inspection.judged = kept.count;
    }
    if (data.partial && data.csv) {
      const std::optional<std::size_t> counted =
          samples_until(data.last_stamp_s, inspection.axis, data.total, inspection.faults);
      inspection.samples = counted.value_or(inspection.samples);
      inspection.estimated = !counted;
    }
    if (inspection.axis && inspection.axis->jitter_s > 0)
      inspection.faults.push_back({"time", jitter_text(*inspection.axis, record.channels)});
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
      inspection.channels.push_back(check_channel(record.channels[c]));
      if (!no_numbers[c].empty()) note_filled(no_numbers[c], inspection.samples, inspection.channels.back());
    }
    if (look && inspection.axis) look(index, record);
  } catch (const InputError& error) {
    inspection.faults.push_back({"unreadable", without_file(error)});
  }
  return inspection;
}

// The variables that go with a time.
std::vector<std::vector<double>> channels_beside(const DataFile& data, const std::string& time) {
  std::vector<std::vector<double>> channels;
  const std::size_t length = data.vector(time).values.size();
  for (const DataVariable& variable : data.variables)
    if (variable.name != time && variable.values.size() == length) channels.push_back(variable.values);
  return channels;
}

// Where none is called time: one that is measured in a unit of time, has time among the words of its name or no
// name (a line of a matrix, a column below no header), and rises evenly.
void find_time_column(DataFile& data, FileInspection& inspection) {
  constexpr std::size_t fewest = 16;  // of a line of so many numbers chance makes no ramp
  for (DataVariable& variable : data.variables) {
    if (!inspection.time.empty()) return;
    const bool in_seconds = seconds_in(variable.stated_unit).has_value();
    const bool nameless =
        is_matrix_line(variable.name) || is_nameless_column(variable.name) || holds_word_time(variable.name);
    if ((!in_seconds && !nameless) || counts_rows(variable) || variable.values.size() < fewest) continue;
    std::vector<DataFault> ignored;
    DataVariable time = variable;
    std::optional<TimeAxis> axis =
        in_seconds ? judged_time(time, data, ignored) : judged_axis(time.values, data.place, std::nullopt, ignored);
    if (!axis || (!in_seconds && axis->jitter_s > 0)) continue;
    inspection.time = variable.name;
    inspection.axis = axis;
    variable = std::move(time);
  }
}

void look_at_file(const FileLook& look, const DataFile& data, const FileInspection& inspection) {
  Campaign campaign;
  Record record{inspection.axis->start_s, inspection.axis->sample_rate_hz, {}, inspection.axis->jitter_s};
  campaign.sample_rate_hz = record.sample_rate_hz;
  const std::size_t samples = data.vector(inspection.time).values.size();
  for (const DataVariable& variable : data.variables) {
    if (is_called_time(variable.name) || variable.name == inspection.time || !variable.fault.empty() ||
        variable.values.size() != samples)
      continue;
    std::vector<double> values = variable.values;
    drop_fill_values(values);
    if (!number_range_fault(values).empty()) continue;
    const bool drives = variable.quantity == Quantity::force;  // a blow is no knock at a sensor
    campaign.channels.push_back({variable.name, drives ? ChannelRole::excitation : ChannelRole::response,
                                 variable.quantity.value_or(Quantity::displacement),
                                 variable.unit.empty() ? variable.stated_unit : variable.unit});
    record.channels.push_back(std::move(values));
  }
  RecordEntry entry;
  entry.file = std::filesystem::path(data.file).filename().string();
  const bool driven = std::any_of(campaign.channels.begin(), campaign.channels.end(),
                                  [](const Channel& channel) { return channel.role == ChannelRole::excitation; });
  entry.kind = driven ? RecordKind::impact : RecordKind::free_decay;
  campaign.records.push_back(std::move(entry));
  if (record.channels.empty()) return;
  if (!data.partial) {
    std::vector<double> stamps(record.samples());
    CutEnds cut = cut_unrecorded(campaign, stamps, record.channels);
    record.no_numbers = fill_missing_cells(record.channels);
    record.start_s += static_cast<double>(cut.first) / record.sample_rate_hz;
    record.unrecorded = std::move(cut.unrecorded);
    record.cut_off = cut.rows;
  }
  look(campaign, record);
}

// No reading of a sensor does for long.
bool only_rises(const std::vector<double>& values) {
  return values.size() > 2 &&
         std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

// The time and what goes with it, cut to a span.
void cut_file(const TimeSpan& span, DataFile& data, FileInspection& inspection) {
  if (!inspection.axis)
    throw InputError(data.file, "", "has no even time, which --from and --to need",
                     "a variable that is called time (t, time, ...)");
  const std::size_t samples = data.vector(inspection.time).values.size();
  const TimeAxis whole = *inspection.axis;
  std::vector<std::vector<double>*> columns;
  for (DataVariable& variable : data.variables)
    if (variable.values.size() == samples) columns.push_back(&variable.values);
  if (cut(span, *inspection.axis, samples, columns) == 0)
    throw InputError(data.file, "", "has no sample between --from and --to",
                     fmt::format("it goes from {:.6g} s to {:.6g} s", whole.start_s,
                                 whole.start_s + static_cast<double>(samples - 1) / whole.sample_rate_hz));
}

}  // namespace

std::vector<RecordInspection> inspect_records(const Campaign& campaign, const InspectionLimit& limit,
                                              const RecordLook& look) {
  std::uintmax_t bytes = 0;
  for (const RecordEntry& entry : campaign.records) bytes += size_of(campaign.folder / entry.file);
  const std::size_t share = share_of(limit, bytes, campaign.records.size() * (campaign.channels.size() + 1));
  std::vector<RecordInspection> inspections;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    inspections.push_back(inspect_record(campaign, r, share, limit.span, look));
  return inspections;
}

FileInspection inspect_file(const std::filesystem::path& path, const InspectionLimit& limit, const FileLook& look) {
  const std::uintmax_t bytes = size_of(path);
  const std::size_t channels = bytes <= limit.whole_bytes ? 1 : describe_data_file(path).size();
  DataFile data = read_data_file(path, {}, MissingNumbers::keep_as_nan, share_of(limit, bytes, channels));
  convert_csv_units(data);
  FileInspection inspection;
  inspection.format = data.format;
  inspection.partial = data.partial;
  inspection.segments = count_segments(path);
  for (DataVariable& variable : data.variables)
    if (inspection.time.empty() && variable.fault.empty() && variable.values.size() > 1 &&
        is_called_time(variable.name)) {
      inspection.time = variable.name;
      inspection.axis = judged_time(variable, data, inspection.faults);
    }
  find_time_column(data, inspection);
  if (!limit.span.all()) cut_file(limit.span, data, inspection);
  for (DataVariable& variable : data.variables) {
    inspection.variables.push_back({variable.name, variable.shape, variable.type, variable.unit,
                                    variable.stated_unit, variable.fault, std::nullopt});
    if (!variable.fault.empty()) continue;
    inspection.variables.back().quality = check_variable(variable.values);
    if (is_called_time(variable.name) || variable.name == inspection.time || only_rises(variable.values)) {
      // Neither an offset nor a ramp is a fault of a time or of a spectrum's frequency.
      inspection.variables.back().quality->faults.clear();
      inspection.variables.back().quality->noise.reset();
      inspection.variables.back().quality->resolution.reset();
    }
  }
  if (inspection.axis && inspection.axis->jitter_s > 0)
    inspection.faults.push_back({"time", jitter_text(*inspection.axis, channels_beside(data, inspection.time))});
  if (look && inspection.axis) look_at_file(look, data, inspection);
  if (!data.partial || data.last_row.empty()) {
    inspection.estimated = data.partial && data.format == "CSV";
    return inspection;
  }
  std::optional<std::size_t> counted;
  if (!inspection.time.empty()) {
    const std::size_t column = data.index_of(inspection.time);
    std::vector<double> last = {data.last_row[column]};
    scale_to_seconds(last, seconds_in(data.variables[column].stated_unit).value_or(1));
    counted = samples_until(last.front(), inspection.axis, data.variables[column].shape.front(), inspection.faults);
  }
  inspection.estimated = !counted;
  if (counted)
    for (VariableInspection& variable : inspection.variables) variable.shape = {*counted};
  return inspection;
}

}  // namespace secular
