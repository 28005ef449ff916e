#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "input/input_error.hpp"
#include "input/stop_request.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/channel_times.hpp"
#include "measure/data/held_campaign.hpp"
#include "measure/data/missing_cells.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/record_data.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/unit.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

RecordData held_data(const RecordEntry& entry) {
  std::vector<std::vector<double>> columns = measured_columns(*entry.held, 0, entry.held->samples());
  RecordData record;
  record.file = entry.file;
  record.stamps_s = std::move(columns.front());
  record.channels.assign(std::make_move_iterator(columns.begin() + 1), std::make_move_iterator(columns.end()));
  record.total = record.stamps_s.size();
  return record;
}

}  // namespace

RecordData read_record_data(const Campaign& campaign, const RecordEntry& entry, MissingNumbers missing,
                            std::size_t limit) {
  if (entry.held) return held_data(entry);
  std::vector<std::string> names;  // of t and of every channel
  for (std::size_t c = 0; c <= campaign.channels.size(); ++c) {
    const std::string channel = c == 0 ? "t" : campaign.channels[c - 1].name;
    const auto renamed = entry.variables.find(channel);
    names.push_back(renamed == entry.variables.end() ? channel : renamed->second);
  }
  DataFile data = read_data_file(campaign.folder / entry.file, names, missing, limit);
  convert_to_seconds(data.vector(names.front()), data.file);
  // A channel may bear the unit that it had before import in its name; a row of units speaks of the numbers below
  // it.
  for (DataVariable& variable : data.variables)
    if (variable.stated_unit == bracketed_unit(variable.name).unit) variable.stated_unit.clear();
  convert_csv_units(data);
  // Values move to their last reader: a record is held once.
  const auto take = [&](std::size_t column) {
    DataVariable& variable = data.vector(names[column]);
    const bool again = std::find(names.begin() + static_cast<std::ptrdiff_t>(column) + 1, names.end(),
                                 names[column]) != names.end();
    return again ? variable.values : std::exchange(variable.values, {});
  };
  RecordData record{data.file, data.place, take(0), {}, 1, data.partial, data.format == "CSV", {}};
  for (const std::size_t length : data.vector(names.front()).shape) record.total *= length;
  if (!data.last_row.empty()) {
    std::vector<double> last = {data.last_row[data.index_of(names.front())]};
    scale_to_seconds(last, seconds_in(data.vector(names.front()).stated_unit).value_or(1));
    record.last_stamp_s = last.front();
  }
  const std::vector<std::string> variables(names.begin() + 1, names.end());
  const auto delays = channel_delays(data, names.front(), variables, record.stamps_s);
  for (std::size_t c = 0; c < delays.size(); ++c)
    if (delays[c].value_or(0) != 0)
      throw InputError(
          data.file, "variable " + variables[c],
          fmt::format("begins {} samples off the time {}, by a time of its own", *delays[c], names.front()),
          "secular import shifts channels to one time");
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    const DataVariable& variable = data.vector(names[c + 1]);
    const Quantity quantity = campaign.channels[c].quantity;
    if (const std::string fault = quantity_fault(variable, quantity); !fault.empty())
      throw InputError(data.file, "variable " + variable.name, fault,
                       fmt::format("campaign.toml says {}", to_string(quantity)));
    if (variable.of_full_scale)
      throw InputError(data.file, "variable " + variable.name,
                       "holds fractions of a range that the file does not state",
                       "secular import makes a record of it with --channel NAME:ROLE:QUANTITY:UNIT:FACTOR");
    record.channels.push_back(take(c + 1));
    if (record.channels.back().size() != record.stamps_s.size())
      throw InputError(
          data.file, "channel " + campaign.channels[c].name,
          fmt::format("has {} samples for {} time stamps", record.channels.back().size(), record.stamps_s.size()),
          "all variables of a record have one length");
    drop_fill_values(record.channels.back());
    require_number_range(record.channels.back(), data.file, "channel " + campaign.channels[c].name);
  }
  return record;
}

namespace {

Record mended_record(const Campaign& campaign, RecordData data) {
  CutEnds cut = cut_unrecorded(campaign, data.stamps_s, data.channels);
  data.place.first += cut.first;
  FilledSamples filled = fill_missing(data.stamps_s, data.channels);
  for (std::size_t c = 0; c < data.channels.size(); ++c)
    require_filled(data.channels[c], campaign.channels[c].name, data.file, data.place);
  const TimeAxis axis = even_time_axis(data.stamps_s, data.file, data.place, campaign.sample_rate_hz);
  if (!(std::abs(axis.sample_rate_hz / campaign.sample_rate_hz - 1) <= measure_thresholds().same_setting))
    throw InputError(data.file, "", fmt::format("is sampled at {} Hz", axis.sample_rate_hz),
                     fmt::format("campaign.toml says sample_rate_hz = {}", campaign.sample_rate_hz));
  return {axis.start_s,           axis.sample_rate_hz,     std::move(data.channels),  axis.jitter_s,
          std::move(filled.rows), std::move(filled.cells), std::move(cut.unrecorded), cut.rows};
}

}  // namespace

Record read_record(const Campaign& campaign, const RecordEntry& entry) {
  end_if_stopped();
  if (entry.held) return *entry.held;
  if (entry.row) {
    Record record;
    record.row = entry.row;
    return record;
  }
  return mended_record(campaign, read_record_data(campaign, entry, MissingNumbers::keep_gaps));
}

Campaign held_campaign(const std::string& text, std::vector<MeasuredSamples> records) {
  const TomlTable root = TomlTable::from_text(text, "the campaign");
  Campaign campaign = described_campaign(root, root.string("name"), true);
  if (records.size() != campaign.records.size())
    throw InputError(campaign.name, "", fmt::format("has samples of {} records", records.size()),
                     fmt::format("{} records are described", campaign.records.size()));
  for (std::size_t r = 0; r < records.size(); ++r) {
    RecordEntry& entry = campaign.records[r];
    const auto refuse = [&](const std::string& wrong, const std::string& right) {
      throw InputError(campaign.name, entry.file, wrong, right);
    };
    RecordData data;
    data.file = entry.file;
    data.channels = std::move(records[r].channels);
    if (data.channels.size() != campaign.channels.size())
      refuse(fmt::format("has {} channels", data.channels.size()),
             fmt::format("the campaign has {}", campaign.channels.size()));
    const std::size_t samples = data.channels.front().size();
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (data.channels[c].size() != samples) refuse("has channels of several lengths", "one length is needed");
      drop_fill_values(data.channels[c]);
      require_number_range(data.channels[c], data.file, "channel " + campaign.channels[c].name);
    }
    for (std::size_t i = 0; i < samples; ++i)
      data.stamps_s.push_back(records[r].start_s + static_cast<double>(i) / campaign.sample_rate_hz);
    data.total = samples;
    entry.held = std::make_shared<const Record>(mended_record(campaign, std::move(data)));
  }
  return campaign;
}

}  // namespace secular
