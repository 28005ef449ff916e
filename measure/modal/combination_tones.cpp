#include "measure/modal/combination_tones.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace secular {
namespace {

constexpr double normal_law = std::numeric_limits<double>::infinity();

/// Most factors of a product. Beyond, an amplitude of a tenth of the displacement at which the structure is no
/// longer weakly nonlinear leaves 1e-5.
constexpr int highest_order = 6;

struct Listed {
  Combination combination;
  double decades = 0;  // Eq. (C3)
};

// Of all partners, the largest first.
std::vector<Listed> combinations_of(const std::vector<DecayingMotion>& motions,
                                    const std::vector<std::size_t>& partners) {
  std::vector<Listed> list;
  if (partners.empty()) return list;
  const double largest = motions[partners.front()].displacement;
  const auto decades = [&](std::size_t motion) { return 1 + std::log10(largest / motions[motion].displacement); };
  for (std::size_t a = 0; a < partners.size(); ++a)
    for (int n = 1; n <= highest_order; ++n) {
      const double first = n * decades(partners[a]);
      if (n > 1) list.push_back({{{partners[a], partners[a]}, {n, 0}}, first});
      for (std::size_t b = 0; b < partners.size() && b < a; ++b)
        for (int m = 1; m + n <= highest_order; ++m)
          for (const int sign : {1, -1})
            list.push_back({{{partners[a], partners[b]}, {n, sign * m}}, first + m * decades(partners[b])});
    }
  std::stable_sort(list.begin(), list.end(),
                   [](const Listed& x, const Listed& y) { return x.decades < y.decades; });
  return list;
}

// Eq. (C1): of n1 times the first and n2 times the second.
Interval sum_of(const Interval& first, int n, const Interval& second, int m) {
  const Interval one{n * first.low, n * first.high};
  return m < 0 ? Interval{one.low + m * second.high, one.high + m * second.low}
               : Interval{one.low + m * second.low, one.high + m * second.high};
}

struct Predicted {
  Interval omega, rate;
  double omega_sd = 0, rate_sd = 0;
};

Predicted predicted(const std::vector<DecayingMotion>& motions, const Combination& c) {
  const DecayingMotion &first = motions[c.motions[0]], &second = motions[c.motions[1]];
  const int n = c.times[0], m = c.times[1];
  Predicted p;
  p.omega = sum_of(first.omega, n, second.omega, m);
  if (p.omega.low + p.omega.high < 0) p.omega = {-p.omega.high, -p.omega.low};
  p.rate = sum_of(first.rate, n, second.rate, std::abs(m));
  p.omega_sd = std::hypot(n * first.omega_sd, m * second.omega_sd);
  p.rate_sd = std::hypot(n * first.growth_sd, m * second.growth_sd);
  return p;
}

// Lengths of frequency that combinations take of those at which a mode can be.
class TakenFrequencies {
 public:
  explicit TakenFrequencies(double highest) : highest_(highest) {}

  void add(Interval omega) {
    omega = {std::max(omega.low, 0.0), std::min(omega.high, highest_)};
    if (omega.low < omega.high) taken_.push_back(omega);
  }

  // Eq. (C4).
  double share() {
    std::sort(taken_.begin(), taken_.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
    double sum = 0, end = 0;
    for (const Interval& i : taken_) {
      sum += std::max(0.0, i.high - std::max(i.low, end));
      end = std::max(end, i.high);
    }
    return sum / highest_;
  }

 private:
  double highest_;
  std::vector<Interval> taken_;
};

bool meets(const Interval& range, double value, double tolerance) {
  return range.low - tolerance <= value && value <= range.high + tolerance;
}

enum class AmplitudeEvidence { none, product, excitation };

// Eq. (C5).
AmplitudeEvidence amplitude_evidence(const std::vector<DecayingMotion>& motions, const DecayingMotion& motion,
                                     const Combination& c) {
  const std::vector<double>&first = motions[c.motions[0]].amplitudes, &second = motions[c.motions[1]].amplitudes;
  const std::size_t records = motion.amplitudes.size();
  if (records < 4 || first.size() != records || second.size() != records) return AmplitudeEvidence::none;
  std::vector<double> x, y;
  for (std::size_t r = 0; r < records; ++r) {
    if (!(std::min({motion.amplitudes[r], first[r], second[r]}) > 0)) return AmplitudeEvidence::none;
    x.push_back(c.times[0] * std::log(first[r]) + std::abs(c.times[1]) * std::log(second[r]));
    y.push_back(std::log(motion.amplitudes[r]));
  }
  const auto n = static_cast<double>(records);
  const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n,
               y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t r = 0; r < records; ++r) {
    xx += (x[r] - x_mean) * (x[r] - x_mean);
    xy += (x[r] - x_mean) * (y[r] - y_mean);
    yy += (y[r] - y_mean) * (y[r] - y_mean);
  }
  if (!(xx > 0)) return AmplitudeEvidence::none;
  const double slope = xy / xx, left = std::max(0.0, yy - slope * xy);
  const Interval likely = confidence_interval(slope, std::sqrt(left / (n - 2) / xx), n - 2);
  const auto holds = [&](double value) { return likely.low <= value && value <= likely.high; };
  const bool product = holds(1), excitation = holds(1.0 / c.order());
  if (product == excitation) return AmplitudeEvidence::none;
  return product ? AmplitudeEvidence::product : AmplitudeEvidence::excitation;
}

CombinationVerdict judged(const std::vector<DecayingMotion>& motions, const DecayingMotion& motion,
                          const Combination& c, const Predicted& p, bool likely_by_chance) {
  const AmplitudeEvidence amplitudes = amplitude_evidence(motions, motion, c);
  const double sd = std::hypot(p.rate_sd, motion.growth_sd), middle = (p.rate.low + p.rate.high) / 2;
  const double tolerance = confidence_interval(0, sd, normal_law).high;
  if (amplitudes == AmplitudeEvidence::excitation) return CombinationVerdict::own_amplitude;
  if (!meets(p.rate, -motion.pole.real(), tolerance)) return CombinationVerdict::own_rate;
  // Half and twice the rate would be taken for it.
  const bool known = tolerance + (p.rate.high - p.rate.low) / 2 < middle / 2;
  if (!known && amplitudes != AmplitudeEvidence::product) return CombinationVerdict::rates_unknown;
  return likely_by_chance ? CombinationVerdict::by_chance : CombinationVerdict::tone;
}

std::optional<CombinationMatch> match_of(const std::vector<DecayingMotion>& motions, std::size_t motion,
                                         const std::vector<std::size_t>& partners, double highest,
                                         double false_alarm) {
  const DecayingMotion& tone = motions[motion];
  TakenFrequencies taken(highest);
  for (const Listed& listed : combinations_of(motions, partners)) {
    const Predicted p = predicted(motions, listed.combination);
    // Eq. (C2)
    const double error = confidence_interval(0, std::hypot(p.omega_sd, tone.omega_sd), normal_law).high;
    const double tolerance = std::min(error, std::abs(tone.pole.real()));
    taken.add({p.omega.low - tolerance, p.omega.high + tolerance});
    const double chance = taken.share();
    const bool likely = chance >= false_alarm;
    if (meets(p.omega, tone.pole.imag(), tolerance))
      return CombinationMatch{motion,  listed.combination,
                              p.omega, p.rate,
                              chance,  judged(motions, tone, listed.combination, p, likely)};
    if (likely) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

int Combination::order() const {
  return std::abs(times[0]) + std::abs(times[1]);
}

std::vector<CombinationMatch> find_combinations(const std::vector<DecayingMotion>& motions, double false_alarm) {
  std::vector<std::size_t> by_size(motions.size()), partners;
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return motions[a].displacement > motions[b].displacement; });
  double highest = 0;
  for (const DecayingMotion& motion : motions) highest = std::max(highest, motion.pole.imag());
  std::vector<CombinationMatch> found;
  for (const std::size_t motion : by_size) {
    const std::optional<CombinationMatch> match = match_of(motions, motion, partners, highest, false_alarm);
    if (match) found.push_back(*match);
    if (motions[motion].followed && (!match || match->verdict != CombinationVerdict::tone))
      partners.push_back(motion);
  }
  return found;
}

}  // namespace secular
