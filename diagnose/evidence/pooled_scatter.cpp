#include "diagnose/evidence/pooled_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

/// A variance of nu degrees of freedom makes the mean square of rows in its unit nu/(nu - 2) (F law): 1 % too
/// large, which the chance of 20,000 rows would hide.
constexpr auto& enough_freedom = diagnose_thresholds().enough_freedom;

/// Of the median: lines of a dwell that something disturbs.
constexpr auto& disturbed = diagnose_thresholds().disturbed_line;

}  // namespace

PooledScatter::PooledScatter(std::vector<LineScatter> lines) : lines_(std::move(lines)) {
  std::stable_sort(lines_.begin(), lines_.end(),
                   [](const LineScatter& a, const LineScatter& b) { return a.frequency < b.frequency; });
}

double PooledScatter::sd(const LineScatter& own) const {
  const double frequency = own.frequency;
  const auto distance = [&](const LineScatter& line) {
    return line.frequency == frequency ? 0 : std::abs(std::log(line.frequency / frequency));
  };
  auto first = std::lower_bound(lines_.begin(), lines_.end(), frequency,
                                [](const LineScatter& line, double w) { return line.frequency < w; });
  auto last = first;
  // Lines at one distance belong together.
  double freedom = 0, reach = 0;
  while (first != lines_.begin() || last != lines_.end()) {
    const double below = first == lines_.begin() ? INFINITY : distance(*std::prev(first)),
                 above = last == lines_.end() ? INFINITY : distance(*last);
    if (freedom >= enough_freedom && std::min(below, above) > reach) break;
    reach = std::min(below, above);
    freedom += (below <= above ? *--first : *last++).freedom;
  }
  std::vector<double> typical;
  for (auto line = first; line != last; ++line) typical.push_back(line->sd);
  if (typical.empty()) return 0;
  const double most = disturbed * upper_median(std::move(typical));
  if (own.sd > most) return own.sd;
  double squares = 0;
  freedom = 0;
  for (auto line = first; line != last; ++line) {
    if (!(line->sd <= most)) continue;
    squares += line->sd * line->sd * line->freedom;
    freedom += line->freedom;
  }
  return freedom > 0 ? std::sqrt(squares / freedom) : 0;
}

}  // namespace secular
