#include "measure/data/missing_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/lost_rows.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/formats/number_table.hpp"
#include "numerics/fill_gaps.hpp"

namespace secular {
namespace {

// Places of cells among all rows, once the lost ones stand among them.
void move_behind(const std::vector<std::size_t>& lost, MissingCells& cells) {
  for (std::vector<std::size_t>& places : cells) {
    std::size_t before = 0;  // lost rows
    for (std::size_t& place : places) {
      while (before < lost.size() && lost[before] <= place + before) ++before;
      place += before;
    }
  }
}

}  // namespace

MissingCells missing_cells(const std::vector<std::vector<double>>& channels) {
  MissingCells missing;
  for (const std::vector<double>& samples : channels) {
    missing.emplace_back();
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!std::isfinite(samples[i])) missing.back().push_back(i);
  }
  return missing;
}

std::size_t drop_fill_values(std::vector<double>& samples) {
  constexpr double out_of_all_reach = 1e8;  // derived: one over what SameValue calls equal
  constexpr double least = 1e9;             // no measured value in any unit: the least of those in use is 2^31 - 1
  std::size_t all = 0;
  for (;;) {  // both signs, one after the other
    double most = 0, other = 0;
    for (const double x : samples)
      if (std::isfinite(x)) most = std::max(most, std::abs(x));
    const auto stands_for_none = [&](double x) { return std::abs(std::abs(x) - most) <= most / out_of_all_reach; };
    for (const double x : samples)
      if (std::isfinite(x) && !stands_for_none(x)) other = std::max(other, std::abs(x));
    if (!(other > 0) || most < least || most < out_of_all_reach * other) return all;
    all += static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(), stands_for_none));
    std::replace_if(samples.begin(), samples.end(), stands_for_none, std::nan(""));
  }
}

namespace {

// 999, 9999.9: nines and no other digit, as a person or a program writes where a number lacks.
bool is_nines(double x) {
  const std::string text = number_text(std::abs(x));
  const auto nines = std::count(text.begin(), text.end(), '9'), points = std::count(text.begin(), text.end(), '.');
  return nines >= 3 && nines + points == static_cast<std::ptrdiff_t>(text.size());
}

bool is_end_of_integers(double x) {
  return x == -32768 || x == 32767 || x == 65535 || x == -2147483648.0 || x == 2147483647.0 || x == 4294967295.0;
}

}  // namespace

std::optional<FillValue> suspected_fill_value(std::span<const double> samples) {
  double low = INFINITY, high = -INFINITY;
  for (const double x : samples)
    if (std::isfinite(x)) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  std::vector<double> others(samples.begin(), samples.end());
  const bool out_of_all_reach = drop_fill_values(others) > 0;
  for (const double value : {low, high}) {
    if (!std::isfinite(value)) continue;
    const bool dropped = out_of_all_reach && std::find(others.begin(), others.end(), value) == others.end();
    if (!dropped && !is_nines(value) && !is_end_of_integers(value)) continue;
    FillValue fill{value, 0, samples.size()};
    double least = INFINITY, most = -INFINITY;  // of the others
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i] == value) {
        ++fill.count;
        fill.first = std::min(fill.first, i);
      } else if (std::isfinite(others[i])) {
        least = std::min(least, samples[i]);
        most = std::max(most, samples[i]);
      }
    }
    const double away = value < least ? least - value : value - most;
    if (least <= most && away > most - least) return fill;
  }
  return std::nullopt;
}

MissingCells fill_missing_cells(std::vector<std::vector<double>>& channels) {
  MissingCells missing = missing_cells(channels);
  for (std::size_t c = 0; c < missing.size(); ++c) {
    if (missing[c].empty()) continue;
    for (const std::size_t i : missing[c]) channels[c][i] = 0;  // whatever it is
    const std::vector<std::size_t> left = fill_gaps(channels[c], missing[c]);
    for (const std::size_t i : left) channels[c][i] = std::nan("");
    std::erase_if(missing[c], [&](std::size_t i) { return std::binary_search(left.begin(), left.end(), i); });
  }
  return missing;
}

FilledSamples fill_missing(std::vector<double>& stamps_s, std::vector<std::vector<double>>& channels) {
  FilledSamples filled{{}, fill_missing_cells(channels)};
  std::vector<std::size_t> lost = lost_rows(stamps_s);
  if (!fill_lost_rows(lost, stamps_s, channels)) return filled;
  move_behind(lost, filled.cells);
  filled.rows = std::move(lost);
  return filled;
}

std::size_t drop_ends_without_numbers(std::vector<double>& samples) {
  const auto is_number = [](double x) { return std::isfinite(x); };
  const auto last = std::find_if(samples.rbegin(), samples.rend(), is_number).base();
  if (last - std::find_if(samples.begin(), samples.end(), is_number) < static_cast<std::ptrdiff_t>(fewest_recorded))
    return 0;
  samples.erase(last, samples.end());
  const auto first = std::find_if(samples.begin(), samples.end(), is_number);
  const auto count = static_cast<std::size_t>(first - samples.begin());
  samples.erase(samples.begin(), first);
  return count;
}

void require_filled(const std::vector<double>& samples, const std::string& channel, const std::string& file,
                    const RowPlace& place) {
  const auto is_missing = [](double x) { return !std::isfinite(x); };
  const auto first = std::find_if(samples.begin(), samples.end(), is_missing);
  if (first == samples.end()) return;
  const auto length = std::find_if_not(first, samples.end(), is_missing) - first;
  throw InputError(
      file, fmt::format("{}, column {}", place.of(static_cast<std::size_t>(first - samples.begin())), channel),
      length == 1 ? std::string("is no finite number, and what is around it does not tell it")
                  : fmt::format("{} in a row are no finite numbers", length),
      fmt::format("up to {} in a row are replaced by what enough numbers around them tell; cut the record around "
                  "longer gaps",
                  longest_filled));
}

std::vector<std::size_t> filled_samples(const Record& record, std::size_t channel) {
  std::vector<std::size_t> all = record.lost;
  if (channel < record.no_numbers.size())
    all.insert(all.end(), record.no_numbers[channel].begin(), record.no_numbers[channel].end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace secular
