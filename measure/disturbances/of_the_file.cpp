#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "measure/disturbances/rows.hpp"

// What is known from reading alone.
namespace secular {

void find_clipped(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const SearchedChannel& channel = record.channels[c];
    const Clipping& clipping = channel.values->clipping;
    if (!clipping.found()) continue;
    Disturbance clipped = record.found("clipping", c, static_cast<double>(clipping.samples));
    clipped.unit = "samples";
    clipped.share = clipped.size / static_cast<double>(record.samples());
    clipped.text = fmt::format(
        "{} samples are stuck at the ends of the range: {} times at {:.4g}, {} times at {:.4g}", clipping.samples,
        clipping.runs_low, channel.values->sorted.front(), clipping.runs_high, channel.values->sorted.back());
    found.push_back(std::move(clipped));
  }
}

namespace {

// What the file holds of a channel outside of its recording.
std::string text_of(const Unrecorded& part, std::size_t total) {
  const std::string where =
      fmt::format("the {} {} of {} samples", part.at_end ? "last" : "first", part.samples, total);
  return (std::isfinite(part.value) ? fmt::format("{} hold {:.6g}, where nothing was recorded: ", where, part.value)
                                    : where + " hold no numbers: ") +
         (part.replaced ? "replaced" : "cut off");
}

}  // namespace

void find_lost_samples(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const LostMarks& marks = record.channels[c].wrong.marks;
    const std::size_t missing = record.channels[c].missing, rows = record.lost_rows;
    std::size_t cells = record.channels[c].filled + missing, samples = cells + rows + marks.at.size();
    std::vector<std::string> ends;
    for (const Unrecorded& part : record.unrecorded)
      if (part.channel == c) {
        if (part.replaced)
          cells -= std::min(cells, part.samples);  // they are among the filled ones
        else
          samples += part.samples;
        ends.push_back(text_of(part, record.total));
      }
    std::vector<std::string> texts;
    if (rows > 0) texts.push_back(fmt::format("{} of {} samples are not in the file", rows, record.total));
    if (cells > 0) texts.push_back(fmt::format("{} of {} samples are no numbers", cells, record.total));
    if (marks.value)
      texts.push_back(fmt::format("{} of {} samples are {:.6g} wherever the signal stood: lost and written as that",
                                  marks.at.size(), record.total, *marks.value));
    texts.insert(texts.end(), ends.begin(), ends.end());
    if (texts.empty()) continue;
    Disturbance lost = record.found("lost_samples", c, static_cast<double>(samples));
    lost.unit = "samples";
    lost.share = lost.size / static_cast<double>(record.total);
    if (missing == 0) lost.treated = record.channels[c].treated_as();
    lost.text = fmt::format("{}", fmt::join(texts, ", "));
    found.push_back(std::move(lost));
  }
}

void find_time_scatter(const SearchedRecord& record, std::vector<Disturbance>& found) {
  if (!(record.jitter_s > 0) || record.channels.empty()) return;
  Disturbance scatter = record.found("uneven_time", 0, record.jitter_s);
  scatter.channel.reset();
  scatter.unit = "s";
  scatter.share = record.jitter_s * record.rate;
  scatter.text = fmt::format("time stamps scatter by {:.3g} s rms, {:.2g} % of the step", record.jitter_s,
                             100 * scatter.share);
  found.push_back(std::move(scatter));
}

}  // namespace secular
