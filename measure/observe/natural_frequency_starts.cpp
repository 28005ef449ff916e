#include "measure/observe/natural_frequency_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "measure/observe/decay_lines.hpp"
#include "measure/observe/driven_lines.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Over six turns, the fewest of a segment that is driven, a motion so far off is off by half a turn
/// (docs/inference.md (40)); one that decays is found by its first turn.
constexpr double near_enough = 1.0 / 12;

class Search {
 public:
  Search(const std::vector<double>& nominal, const std::vector<Resonance>& cases,
         const std::vector<DwellTones>& dwells, const ModeLines& seen)
      : nominal_(nominal), cases_(cases), dwells_(dwells), seen_(seen) {
    for (const std::optional<double>& line : seen.at_nominal)
      if (line) lines_.push_back(*line);
    lines_.insert(lines_.end(), seen.further.begin(), seen.further.end());
    order_.resize(nominal.size());
    std::iota(order_.begin(), order_.end(), 0U);
    if (std::all_of(nominal.begin(), nominal.end(), [](double w) { return std::isfinite(w); }))
      std::stable_sort(order_.begin(), order_.end(),
                       [&](std::size_t a, std::size_t b) { return nominal_[a] < nominal_[b]; });
  }

  std::vector<double> run() const {
    Found best = judged(nominal_, 0);
    if (explains_all(best)) return nominal_;
    Found from_lines = judged(with_lines(), 0);
    improve(best);
    improve(from_lines);
    return (from_lines < best ? from_lines : best).frequency;
  }

  // Every frequency in the middle of the dwells that it explains, within the resonance width.
  std::vector<double> centred(const std::vector<double>& found) const {
    Found best = judged(found, 0);
    for (bool more = true; more;) {
      more = false;
      for_moves(std::vector<double>(best.frequency), [&](Found tried) {
        for (std::size_t k = 0; k < found.size(); ++k)
          if (std::abs(tried.frequency[k] - found[k]) > measure_thresholds().largest_detuning * found[k]) return;
        if (!keeps(tried, best) || tried.agreeing < best.agreeing) return;
        if (tried.agreeing == best.agreeing && !(tried.off < best.off)) return;
        best = std::move(tried);
        more = true;
      });
    }
    return best.frequency;
  }

 private:
  struct Found {
    std::vector<double> frequency;
    std::size_t explained = 0, agreeing = 0;  // records
    std::vector<bool> which;                  // dwells and lines that are explained
    double moved = 0;                         // from the nominal values, logarithms
    std::size_t reading = 0;  // number of the relation that it was read by: of equals the model's first
    double off = 0;           // of the dwells that agree
    friend bool operator<(const Found& a, const Found& b) {
      return std::tie(b.explained, b.agreeing, a.moved, a.reading, a.off) <
             std::tie(a.explained, a.agreeing, b.moved, b.reading, b.off);
    }
  };

  // Whether all that `before` explains stays explained: a model of some modes is not led away to others' dwells.
  static bool keeps(const Found& found, const Found& before) {
    for (std::size_t i = 0; i < before.which.size(); ++i)
      if (before.which[i] && !found.which[i]) return false;
    return true;
  }

  bool explains_all(const Found& found) const {
    return found.explained == dwells_.size() + lines_.size() * seen_.records &&
           std::all_of(nominal_.begin(), nominal_.end(), [](double w) { return std::isfinite(w); });
  }

  Found judged(std::vector<double> frequency, std::size_t reading) const {
    Found found{std::move(frequency), 0, 0, {}, 0, reading, 0};
    const std::vector<double>& w = found.frequency;
    for (const DwellTones& dwell : dwells_) {
      const DwellCase own = case_of_dwell(dwell, cases_, w);
      found.which.push_back(own.resonance < cases_.size() && own.response != DwellCase::Response::contradicts);
      if (!found.which.back()) continue;
      ++found.explained;
      if (own.response != DwellCase::Response::agrees) continue;
      ++found.agreeing;
      found.off += mismatch(cases_[own.resonance], w, dwell.excitation);
    }
    for (const double line : lines_) {
      found.which.push_back(std::any_of(w.begin(), w.end(), [&](double own) {
        return std::abs(line - own) < measure_thresholds().largest_detuning * own;
      }));
      if (found.which.back()) found.explained += seen_.records;
    }
    for (std::size_t k = 0; k < w.size(); ++k)
      if (std::isfinite(nominal_[k]) && std::isfinite(w[k])) found.moved += std::abs(std::log(w[k] / nominal_[k]));
    return found;
  }

  // Modes keep the order of their nominal frequencies.
  std::vector<double> in_order(const std::vector<double>& frequency) const {
    std::vector<double> sorted = frequency, result = frequency;
    if (!std::all_of(sorted.begin(), sorted.end(), [](double w) { return std::isfinite(w); })) return result;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i]] = sorted[i];
    return result;
  }

  // Modes that are not seen near their nominal frequencies take the strongest of the further lines.
  std::vector<double> with_lines() const {
    std::vector<double> frequency = nominal_;
    auto line = seen_.further.begin();
    for (const std::size_t k : order_)
      if (seen_.may_be_further[k] && !seen_.at_nominal[k] && line != seen_.further.end()) frequency[k] = *line++;
    return in_order(frequency);
  }

  // Calls visit(found) for every way to move one frequency to where a relation is exact at a dwell.
  template <class Visit>
  void for_moves(const std::vector<double>& from, const Visit& visit) const {
    std::size_t reading = 0;
    for (std::size_t k = 0; k < nominal_.size(); ++k)
      for (const Resonance& resonance : cases_)
        for (const std::vector<int>& relation : resonance.relations) {
          ++reading;
          if (!resonance.excited || relation.size() != nominal_.size() + 1 || relation[k] == 0) continue;
          for (const DwellTones& dwell : dwells_) {
            double sum = relation.back() * dwell.excitation;
            for (std::size_t i = 0; i < nominal_.size(); ++i)
              if (i != k && relation[i] != 0) sum += relation[i] * from[i];
            const double exact = -sum / relation[k];
            if (!(exact > 0)) continue;
            std::vector<double> frequency = from;
            frequency[k] = exact;
            visit(judged(in_order(frequency), reading));
          }
        }
  }

  // Moves one frequency after the other, as long as that explains more.
  void improve(Found& best) const {
    for (;;) {
      Found better = best;
      for_moves(best.frequency, [&](Found tried) {
        if (tried.explained > best.explained && keeps(tried, best) && tried < better) better = std::move(tried);
      });
      if (better.explained == best.explained) return;
      best = std::move(better);
    }
  }

  const std::vector<double>& nominal_;
  const std::vector<Resonance>& cases_;
  const std::vector<DwellTones>& dwells_;
  const ModeLines& seen_;
  std::vector<double> lines_;
  std::vector<std::size_t> order_;  // modes by nominal frequency
};

}  // namespace

NaturalFrequencyStarts natural_frequency_starts(const Campaign& campaign, const RecordReader& read,
                                                const std::vector<double>& nominal,
                                                const std::vector<Resonance>& cases,
                                                const std::vector<DwellTones>& dwells, const Window& window) {
  ModeLines seen = decay_lines(campaign, read, nominal, window);
  const bool is_driven = seen.records == 0;
  if (is_driven) seen = driven_lines(campaign, read, nominal, window);
  const Search search(nominal, cases, dwells, seen);
  const std::vector<double> found = search.run();
  NaturalFrequencyStarts starts{search.centred(found), {}};
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    starts.moved.push_back(std::isfinite(nominal[k]) && found[k] != nominal[k]);
    if (!is_driven || !seen.at_nominal[k] || starts.moved[k]) continue;
    if (std::abs(*seen.at_nominal[k] - nominal[k]) < near_enough * nominal[k]) continue;
    starts.frequency[k] = *seen.at_nominal[k];
    starts.moved[k] = true;
  }
  return starts;
}

}  // namespace secular
