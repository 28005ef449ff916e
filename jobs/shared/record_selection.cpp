#include "jobs/shared/record_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimator/identification/short_list.hpp"
#include "input/input_error.hpp"
#include "measure/data/file_pattern.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/disturbances/treatment.hpp"
#include "measure/observe/passed_record.hpp"
#include "measure/observe/record_window.hpp"

namespace secular {
namespace {

std::string toml_of(const Campaign& campaign) {
  return (campaign.folder / "campaign.toml").string();
}

// Throws unless some record has a sample in the window.
void require_samples(const Campaign& campaign, const Window& window) {
  if (!window.cuts()) return;
  const bool of_time = window.from_s != Window{}.from_s || window.to_s != Window{}.to_s;
  std::string longest;
  double most = -1;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!window.takes(r, entry.file)) continue;
    if (entry.row) {  // has no time; lines outside of a band are left out where they are read
      longest = fmt::format("{} is a row of a table of lines, which has no time", entry.file);
      if (of_time) continue;
      return;
    }
    Record record = read_record(campaign, entry);
    const double end = record.start_s + (static_cast<double>(record.samples()) - 1) / record.sample_rate_hz;
    const std::string span = fmt::format("{} goes from {:.6g} s to {:.6g} s", entry.file, record.start_s, end);
    if (end - record.start_s > most) longest = span;
    most = std::max(most, end - record.start_s);
    record = passed_record(campaign, r, std::move(record), window);
    if (range_of(record, window).count > 0) return;
  }
  const std::string reach =
      window.band && campaign.sample_rate_hz > 0
          ? fmt::format(", and the filter of --band reaches {:.4g} s into a record from both ends",
                        static_cast<double>(band_pass_reach(*window.band, campaign.sample_rate_hz)) /
                            campaign.sample_rate_hz)
          : "";
  throw InputError(toml_of(campaign), "",
                   window.band ? "no record has a sample left by --from, --to and --band"
                               : "no record has a sample between --from and --to",
                   longest + reach);
}

// Looks at what the window leaves of a record.
WatchedReader::Look at_what_counts(const Campaign& campaign, const Window& window, WatchedReader::Look look) {
  if (!look || !window.cuts()) return look;
  return [&campaign, window, look](std::size_t index, const Record& whole, const std::vector<ChannelValues>&) {
    Record record = passed_record(campaign, index, whole, window);
    const SampleRange range = range_of(record, window);
    if (range.count == 0) return;
    const auto first = static_cast<std::size_t>(range.first), count = static_cast<std::size_t>(range.count);
    std::vector<ChannelValues> values;
    for (std::size_t c = 0; c < record.channels.size(); ++c)
      values.push_back(values_of(record, c, std::span(record.channels[c]).subspan(first, count)));
    cut_record(record, first, count);
    look(index, record, values);
  };
}

}  // namespace

std::set<std::size_t> records_within(const Campaign& campaign, const Window& window) {
  std::set<std::size_t> records;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (window.takes(r, campaign.records[r].file)) records.insert(r);
  return records;
}

void require_match(const Campaign& campaign, const Window& window) {
  std::vector<std::string> files;
  for (const RecordEntry& entry : campaign.records) {
    if (matches_record(window.records, entry.file)) return;
    files.push_back(entry.file);
  }
  throw InputError(toml_of(campaign), "", "no record matches --records " + window.records,
                   "its records are " + short_list(files));
}

TimeSpan span_of(const Window& window) {
  TimeSpan span;
  if (window.from_s != Window{}.from_s) span.from_s = window.from_s;
  if (window.to_s != Window{}.to_s) span.to_s = window.to_s;
  return span;
}

void require_any_record(const std::string& file, const Window& window) {
  if (window.records != Window{}.records)
    throw InputError("--records " + window.records, "", file + " is a single record",
                     "--records chooses among those of a campaign folder");
}

void require_sampled(const Window& window, double sample_rate_hz) {
  if (window.band && sample_rate_hz > 0 && !(window.band->high_hz < 0.5 * sample_rate_hz))
    throw InputError(
        fmt::format("--band {:.6g}:{:.6g}", window.band->low_hz, window.band->high_hz), "",
        "ends above half the sample rate",
        fmt::format("{:.6g} samples/s hold what is below {:.6g} Hz", sample_rate_hz, 0.5 * sample_rate_hz));
}

void list_clipped_as_left_out(std::vector<Disturbance>& found) {
  for (Disturbance& disturbance : found)
    if (disturbance.kind == "clipping") disturbance.treated = "left_out";
}

SelectedRecords::SelectedRecords(const Campaign& campaign, const Window& window, WatchedReader::Look look)
    : campaign_(campaign),
      window_(window),
      // Of whole records: a filter would spread held samples and spikes, and hide a converter's steps.
      reader_(campaign, at_what_counts(campaign, window, std::move(look)), treatments_of(campaign)) {
  require_match(campaign, window);
  require_sampled(window, campaign.sample_rate_hz);
  require_samples(campaign, window);
}

Record SelectedRecords::read(std::size_t record) {
  return passed_record(campaign_, record, reader_.read(record), window_);
}

}  // namespace secular
