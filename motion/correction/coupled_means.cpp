#include "motion/correction/coupled_means.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "estimator/identification/beyond_chance.hpp"
#include "estimator/thresholds.hpp"
#include "measure/observe/record_ranges.hpp"
#include "motion/correction/chain_fault.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a record's means: a zero that wanders (a polynomial of second degree) and what a coupling makes of a step; a
/// constant and a drift where means are passed.
constexpr Index of_a_zero = 3, of_a_record = of_a_zero + 1, of_a_passed_record = 2;
/// Of all means: the square of the amplitude, and what its harmonics make of the fourth power.
constexpr Index of_a_law = 2;
/// RecordMeans count in full where chance leaves as much of them with this probability.
constexpr double means_hold = 0.05;
/// Time constants a factor of two apart are tried; a minimum between them is found by parabolas, each over half the
/// range of the one before.
constexpr int parabolas = 8;

// A power of the amplitude along a decay, exponential from window to window and beyond the outer ones, behind a
// low-pass of one pole.
class SmoothedPower {
 public:
  // `square`: of the amplitude, at the times `at`, which grow.
  SmoothedPower(std::vector<double> at, const std::vector<double>& square, double power, double tau)
      : at_(std::move(at)), tau_(tau) {
    for (const double s : square) log_.push_back(power * std::log(s));
    state_.push_back(0);
    for (std::size_t i = 0; i + 1 < at_.size(); ++i) state_.push_back(after(i, at_[i + 1]));
  }

  double operator()(double time) const {
    const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, time);
    return after(static_cast<std::size_t>(above - at_.begin()) - 1, time);
  }

 private:
  // What is left of the state at knot i, and what has come to it.
  double after(std::size_t i, double time) const {
    const double step = time - at_[i], growth = (log_[i + 1] - log_[i]) / (at_[i + 1] - at_[i]);
    const double left = std::exp(-step / tau_), z = (growth + 1 / tau_) * step;
    return left * (state_[i] + std::exp(log_[i]) * step / tau_ * (std::abs(z) > 1e-8 ? std::expm1(z) / z : 1));
  }

  std::vector<double> at_, log_, state_;
  double tau_;
};

// The means of one record, by window.
struct RecordMeans {
  std::vector<double> begin, end, weight, value;  // s, one over standard deviations, the channels' unit
  std::vector<double> mean_square;                // of half the amplitude
  std::vector<double> at, square;                 // s, of half the amplitude, from before the first window on
};

RecordMeans means_of(std::span<const Observation> windows, int derivatives, double& independent) {
  RecordMeans result;
  for (const Observation& o : windows) {
    if (o.mean.empty() || !(o.mean_sd.front() > 0) || o.growth_sd.front() < 0) continue;
    const double square = std::norm(o.amplitude.front() * derived(o.rate.front().imag(), derivatives));
    if (!(square > 0) || (!result.at.empty() && !(o.centre_s > result.at.back()))) continue;
    const double overlap = overlap_of_means(o);
    result.begin.push_back(o.centre_s - 0.5 * o.length_s);
    result.end.push_back(o.centre_s + 0.5 * o.length_s);
    result.weight.push_back(1 / (o.mean_sd.front() * std::sqrt(overlap)));
    result.value.push_back(o.mean.front());
    result.mean_square.push_back(mean_square(o, derivatives));
    if (result.at.empty()) {
      result.at.push_back(result.begin.front());
      result.square.push_back(square * std::exp(-o.rate.front().real() * o.length_s));
    }
    result.at.push_back(o.centre_s);
    result.square.push_back(square);
    independent += 1 / overlap;
  }
  return result;
}

struct MeanRows {
  MatrixXd columns;
  VectorXd target;
  Index filled = 0;
};

// What a law and a coupling leave of all means.
class CouplingFit {
 public:
  CouplingFit(std::span<const ObservationSet> sets, int derivatives) {
    for (const ObservationSet& set : sets) {
      if (set.resonance->excited) continue;
      for (const RecordRange& range : ranges_of_records(set.observations)) {
        RecordMeans means = means_of(range.of(set.observations), derivatives, independent_);
        if (!means.value.empty()) records_.push_back(std::move(means));
      }
    }
    for (const RecordMeans& m : records_) {
      rows_ += static_cast<Index>(m.value.size());
      longest_ = std::max(longest_, m.end.back() - m.begin.front());
      largest_ = std::max(largest_, *std::max_element(m.square.begin(), m.square.end()));
    }
  }

  // Beside `unknowns` of each record, and others.
  double freedom(Index unknowns, Index others) const {
    return independent_ - static_cast<double>(unknowns * static_cast<Index>(records_.size()) + others);
  }
  double longest() const { return longest_; }

  struct Left {
    double chi_squared = 0;
    double k = 0;  // zero without a law
  };

  // Where means are passed: chi-squared beside a constant and a drift in each record, and the square of the motion.
  double left_where_passed() const {
    MatrixXd columns = MatrixXd::Zero(rows_, of_a_passed_record * static_cast<Index>(records_.size()) + 1);
    VectorXd target(rows_);
    Index row = 0, first = 0;
    for (const RecordMeans& m : records_) {
      for (std::size_t i = 0; i < m.value.size(); ++i, ++row) {
        const double by = m.weight[i];
        columns(row, first) = by;
        columns(row, first + 1) = by * (m.end[i] - m.begin.front()) / longest_;
        columns(row, columns.cols() - 1) = by * m.mean_square[i] / largest_;
        target(row) = by * m.value[i];
      }
      first += of_a_passed_record;
    }
    return (target - columns * VectorXd(columns.colPivHouseholderQr().solve(target))).squaredNorm();
  }

  Left left(double tau, bool law) const {
    const Index records = static_cast<Index>(records_.size());
    MeanRows rows{MatrixXd::Zero(rows_, of_a_record * records + (law ? of_a_law : 0)), VectorXd(rows_)};
    for (Index r = 0; r < records; ++r) add(records_[static_cast<std::size_t>(r)], tau, law, of_a_record * r, rows);
    auto& [columns, target, filled] = rows;
    const VectorXd size = columns.colwise().norm().transpose();
    for (Index c = 0; c < columns.cols(); ++c)
      if (size(c) > 0) columns.col(c) /= size(c);
    const VectorXd found = columns.colPivHouseholderQr().solve(target);
    Left result{(target - columns * found).squaredNorm(), 0};
    const Index at = of_a_record * records;
    if (law && size(at) > 0) result.k = found(at) / size(at) / (2 * largest_);
    return result;
  }

 private:
  // The mean over a window of what a high-pass leaves of m is tau times what its low-pass grows by, over the
  // window.
  void add(const RecordMeans& m, double tau, bool law, Index first, MeanRows& rows) const {
    std::vector<double> relative = m.square;
    for (double& s : relative) s /= largest_;
    std::vector<SmoothedPower> powers;
    for (Index term = 0; law && term < of_a_law; ++term)
      powers.emplace_back(m.at, relative, static_cast<double>(1 + term), tau);
    const double start = m.begin.front();
    for (std::size_t i = 0; i < m.value.size(); ++i, ++rows.filled) {
      const double by = m.weight[i], share = tau / (m.end[i] - m.begin[i]);
      for (Index degree = 0; degree < of_a_zero; ++degree)
        rows.columns(rows.filled, first + degree) = by * std::pow((m.end[i] - start) / longest_, degree);
      rows.columns(rows.filled, first + of_a_zero) =
          by * share * (std::exp((start - m.begin[i]) / tau) - std::exp((start - m.end[i]) / tau));
      for (std::size_t term = 0; term < powers.size(); ++term)
        rows.columns(rows.filled, rows.columns.cols() - of_a_law + static_cast<Index>(term)) =
            by * share * (powers[term](m.end[i]) - powers[term](m.begin[i]));
      rows.target(rows.filled) = by * m.value[i];
    }
  }

  std::vector<RecordMeans> records_;
  Index rows_ = 0;
  double independent_ = 0, longest_ = 0, largest_ = 0;
};

// The likeliest time constant. Every step is continuous in what is fitted, but for the first choice.
double likeliest(const CouplingFit& fit, double shortest, bool law) {
  double best = std::log(shortest), least = INFINITY;
  const double from = best, to = std::log(0.5 * fit.longest());
  for (double at = from; at < to; at += std::numbers::ln2) {
    const double here = fit.left(std::exp(at), law).chi_squared;
    if (here < least) {
      least = here;
      best = at;
    }
  }
  double step = std::numbers::ln2;
  for (int i = 0; i < parabolas; ++i, step /= 2) {
    const double below = fit.left(std::exp(best - step), law).chi_squared,
                 here = fit.left(std::exp(best), law).chi_squared,
                 above = fit.left(std::exp(best + step), law).chi_squared;
    const double bend = below - 2 * here + above, slope = 0.5 * (below - above);
    const double move = bend > 0 ? std::clamp(slope / bend, -1.0, 1.0) : below < above ? -1 : 1;
    best = std::clamp(best + move * step, from, to);
  }
  return std::exp(best);
}

}  // namespace

double overlap_of_means(const Observation& window) {
  return 0.5 * (window.overlap ? static_cast<double>(window.overlap->size() + 2) : 2);
}

double weight_by_what_is_left(double chi_squared, double freedom) {
  const double most = chi_squared_upper_quantile(estimator_thresholds().contradiction_alarm, freedom),
               usual = chi_squared_upper_quantile(means_hold, freedom);
  return std::clamp((most - chi_squared) / (most - usual), 0.0, 1.0);
}

std::optional<CoupledLaw> coupled_law(std::span<const ObservationSet> sets, int derivatives, double shortest_s,
                                      double alarm) {
  const CouplingFit fit(sets, derivatives);
  const double freedom = fit.freedom(of_a_record, of_a_law + 1);
  if (!(freedom >= 1)) return std::nullopt;
  const double passed = weight_by_what_is_left(fit.left_where_passed(), fit.freedom(of_a_passed_record, 1));
  if (passed == 1) return std::nullopt;
  CoupledLaw law;
  law.time_constant_s = likeliest(fit, shortest_s, true);
  const CouplingFit::Left with = fit.left(law.time_constant_s, true);
  law.k = with.k;
  const double weight = (1 - passed) * weight_by_what_is_left(with.chi_squared, freedom);
  if (!(weight > 0)) return std::nullopt;
  const double gain = fit.left(likeliest(fit, shortest_s, false), false).chi_squared - with.chi_squared;
  const double scatter = std::max(1.0, with.chi_squared / freedom);
  constexpr auto unknowns = static_cast<double>(of_a_law);
  law.counts = weight * beyond_chance(gain / (unknowns * scatter), freedom, alarm, unknowns);
  if (!(law.counts > 0)) return std::nullopt;
  return law;
}

}  // namespace secular
