#include "diagnose/evidence/resonant_lines.hpp"

#include <cmath>
#include <numeric>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

/// A mode may move by itself where a multiple of the excitation is this close to its natural frequency (relative).
/// Wider than largest_detuning, by which dwells are given to a case whose expansion must hold: a line that is
/// looked at in vain costs time alone.
constexpr auto& resonant_reach = diagnose_thresholds().resonant_reach;

struct Multiple {
  int numerator = 1, denominator = 1;
};

// The simplest multiple a/b of the excitation near a natural frequency.
std::optional<Multiple> simplest_multiple(double natural, double excitation) {
  static constexpr Multiple candidates[] = {{1, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}, {3, 2}};
  std::optional<Multiple> best;
  double distance = resonant_reach;
  for (const Multiple& m : candidates) {
    // The higher the multiple, the narrower its resonance.
    const int order = m.numerator * m.denominator;
    const double off = std::abs(excitation * m.numerator / m.denominator / natural - 1) * (order > 3   ? 4
                                                                                           : order > 2 ? 2
                                                                                                       : 1);
    // A simpler one is kept unless the other is much closer.
    if (off < distance) {
      best = m;
      distance = off / 3;
    }
  }
  return best;
}

}  // namespace

std::vector<LineLayout> possible_layouts(const std::vector<double>& natural_frequency, double excitation) {
  std::vector<LineLayout> layouts;
  // One base phase with all modes that a multiple of the excitation meets, then those on its own harmonics alone
  // (the subharmonic motion may be absent).
  std::vector<std::optional<Multiple>> multiples;
  for (const double w : natural_frequency) multiples.push_back(simplest_multiple(w, excitation));
  const auto locked = [&](bool subharmonics) {
    LineLayout layout;
    for (const auto& m : multiples)
      if (m && (subharmonics || m->denominator == 1)) layout.divisor = std::lcm(layout.divisor, m->denominator);
    layout.excitation = {layout.divisor, 0};
    for (std::size_t k = 0; k < multiples.size(); ++k)
      if (multiples[k] && layout.divisor % multiples[k]->denominator == 0)
        layout.resonances.push_back({k, {multiples[k]->numerator * layout.divisor / multiples[k]->denominator, 0}});
    return layout;
  };
  const LineLayout all = locked(true), direct = locked(false);
  if (all.divisor > 1) layouts.push_back(all);
  // Pairs of modes whose frequencies add up to the excitation's, or differ by it.
  for (std::size_t low = 0; low < natural_frequency.size(); ++low)
    for (std::size_t high = 0; high < natural_frequency.size(); ++high) {
      if (multiples[low] || multiples[high] || natural_frequency[low] >= natural_frequency[high]) continue;
      for (const int sign : {1, -1}) {
        const double combined = natural_frequency[high] + sign * natural_frequency[low];
        if (std::abs(combined / excitation - 1) > resonant_reach) continue;
        LineLayout pair;
        pair.dimensions = 2;
        pair.excitation = {sign, 1};
        pair.resonances = {{low, {1, 0}}, {high, {0, 1}}};
        layouts.push_back(pair);
      }
    }
  layouts.push_back(direct);
  return layouts;
}

}  // namespace secular
