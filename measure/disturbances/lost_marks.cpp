#include "measure/disturbances/lost_marks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/data/resolution.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

// Values on either side that tell how often one is hit.
std::size_t either_side() {
  return measure_thresholds().local_samples / 2;
}

// Whether chance makes so many of `all` agree, each of which may be any of so many values: some value is hit as
// often with no more than the sum of its probability over them.
bool agree_by_chance(std::size_t agreeing, std::size_t all, std::size_t values, double false_alarm) {
  const auto any = static_cast<double>(values);
  return any * poisson_upper_tail(agreeing, static_cast<double>(all) / any) > false_alarm;
}

// Mean number of hits of a value there, at most.
double hits(const std::vector<ValueLevel>& levels, std::size_t level) {
  const std::size_t begin = level - std::min(level, either_side()),
                    end = std::min(levels.size(), level + either_side() + 1);
  double count = 1;  // one more than is seen: none may be seen twice
  for (std::size_t k = begin; k < end; ++k)
    if (k != level) count += static_cast<double>(levels[k].count);
  const double mean = count / static_cast<double>(end - begin - 1);
  return std::min(mean, 2 * (mean - 1));
}

// Whether chance hits a value so often, with no more than `alarm` for its probability. P(N >= n) is at least
// P(N = n) = exp(-mean) mean^n/n!, which decides most values without the incomplete gamma function.
bool hit_by_chance(std::size_t times, double mean, double alarm) {
  if (mean > 1) return true;
  double as_often = std::exp(-mean);
  for (std::size_t n = 1; n <= times && as_often > alarm; ++n) as_often *= mean / static_cast<double>(n);
  return as_often > alarm || poisson_upper_tail(times, mean) > alarm;
}

struct Run {
  std::size_t begin = 0, end = 0;
};

class Visits {
 public:
  Visits(std::span<const double> x, double value, const SameValue& same) : x_(x), value_(value), same_(same) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!same(x[i], value)) continue;
      if (runs_.empty() || runs_.back().end != i) runs_.push_back({i, i});
      runs_.back().end = i + 1;
    }
  }

  std::size_t runs() const { return runs_.size(); }

  // Whether more than a quarter of what stands beside the runs is not among the nearest half of the other samples.
  bool come_from_far() const {
    std::vector<double> distances;
    for (const double x : x_)
      if (!same_(x, value_)) distances.push_back(std::abs(x - value_));
    if (distances.empty()) return false;
    const auto half = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), half, distances.end());
    std::size_t sides = 0, far = 0;
    const auto look = [&](double x) {
      ++sides;
      if (std::abs(x - value_) > *half) ++far;
    };
    for (const Run& run : runs_) {
      if (run.begin > 0) look(x_[run.begin - 1]);
      if (run.end < x_.size()) look(x_[run.end]);
    }
    return 4 * far > sides;
  }

  // Whether every step to it is more than twice the largest of all other steps.
  bool out_of_reach() const {
    const auto is_it = [&](double x) { return same_(x, value_); };
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (std::size_t i = 1; i < x_.size(); ++i) {
      const double step = std::abs(x_[i] - x_[i - 1]);
      if (is_it(x_[i]) != is_it(x_[i - 1]))
        least = std::min(least, step);
      else
        largest = std::max(largest, step);
    }
    return least > 2 * largest;
  }

  // Nothing where they are a quarter of the record or more: what is lost is the exception.
  LostMarks marks() const {
    LostMarks result{{}, value_};
    for (const Run& run : runs_)
      for (std::size_t i = run.begin; i < run.end; ++i) result.at.push_back(i);
    return 4 * result.at.size() < x_.size() ? result : LostMarks{};
  }

 private:
  std::span<const double> x_;
  double value_ = 0;
  SameValue same_;
  std::vector<Run> runs_;
};

// The value that most spikes share.
std::optional<double> shared_by_spikes(std::span<const double> x, const Impulses& impulses, const SameValue& same,
                                       std::size_t levels_of_all, double false_alarm) {
  std::vector<double> values;
  for (const Impulses::One& spike : impulses.spikes) values.push_back(x[spike.at]);
  std::sort(values.begin(), values.end());
  const std::vector<ValueLevel> levels = levels_of_sorted(values, same);
  const auto most = std::max_element(levels.begin(), levels.end(),
                                     [](const ValueLevel& a, const ValueLevel& b) { return a.count < b.count; });
  if (most == levels.end() || agree_by_chance(most->count, values.size(), levels_of_all, false_alarm))
    return std::nullopt;
  return most->value;
}

}  // namespace

LostMarks find_lost_marks(std::span<const double> x, const std::vector<double>& sorted, const Impulses& impulses,
                          double false_alarm) {
  if (x.empty() || !(sorted.back() > sorted.front())) return {};
  const SameValue same(sorted);
  const std::vector<ValueLevel> levels = levels_of_sorted(sorted, same);
  if (levels.size() < 2) return {};
  if (const std::optional<double> shared = shared_by_spikes(x, impulses, same, levels.size(), false_alarm)) {
    const auto level =
        std::find_if(levels.begin(), levels.end(), [&](const ValueLevel& l) { return same(l.value, *shared); });
    if (level != levels.end() && hits(levels, static_cast<std::size_t>(level - levels.begin())) <= 1)
      return Visits(x, level->value, same).marks();
  }
  if (levels.size() > 2 * either_side())
    for (const double end : {sorted.front(), sorted.back()}) {
      const Visits visits(x, end, same);
      if (!agree_by_chance(visits.runs(), visits.runs(), levels.size(), false_alarm) && visits.out_of_reach())
        return visits.marks();
    }
  const double level_alarm = false_alarm / static_cast<double>(levels.size());
  std::optional<Visits> most;
  for (std::size_t k = 1; k + 1 < levels.size(); ++k) {
    const double mean = hits(levels, k);
    if (hit_by_chance(levels[k].count, mean, level_alarm)) continue;
    Visits visits(x, levels[k].value, same);
    if (most && visits.runs() <= most->runs()) continue;
    if (!hit_by_chance(visits.runs(), mean, level_alarm) && visits.come_from_far())
      most.emplace(std::move(visits));
  }
  return most ? most->marks() : LostMarks{};
}

}  // namespace secular
