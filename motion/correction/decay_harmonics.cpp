#include "motion/correction/decay_harmonics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

#include "estimator/identification/beyond_chance.hpp"
#include "estimator/identification/predicted_harmonics.hpp"
#include "estimator/thresholds.hpp"
#include "input/numerical_failure.hpp"
#include "measure/observe/common_observations.hpp"
#include "measure/observe/modal_projection.hpp"
#include "motion/correction/coupled_means.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The highest multiple of a motion's frequency that is looked at.
constexpr int highest_multiple = 3;
/// Of a mean in a record: a constant and a drift.
constexpr Index unknowns_of_mean = 2;
/// Of a mean: the square of the amplitude, and what its harmonics make of the fourth power.
constexpr Index terms_of_even_law = 2;
/// The first size that is tried of a fault, and the most that are.
constexpr double first_size = 0.01;
constexpr int most_sizes = 9;
/// Sizes that differ by less than this share are the same: what they move is allowed for to no more digits.
constexpr double same_size = 0.02;
constexpr int numbers_of_poles[] = {1, 4, 16, 64};
/// Kinds of faults: poles that pass what is below or above them (half a kind each, as they have no negative size),
/// a cubic law, an even law of which means show their part, do not, or do behind a coupling.
constexpr double kinds = 5;
/// A fault that explains harmonics less well than another does so as well where chance makes the difference with
/// this probability.
constexpr double as_likely = 0.05;

// A line of a window, or its mean (`block` none).
struct Line {
  std::size_t set = 0, observation = 0;  // of what was measured
  std::optional<std::size_t> block{};
  std::size_t mode = 0;
  int multiple = 0;
  double sd = 0;
  double overlap = 1;  // see overlap_of
  // In the frame of the motion, at the measured amplitude: by the full equations, and by the expansion at the
  // estimate. Of a mean nothing.
  Complex replayed{}, expanded{};
};

Complex to_frame(Complex line, Complex amplitude, int multiple) {
  return line * std::pow(std::conj(amplitude) / std::abs(amplitude), multiple);
}

// One length of a stretch has one more window than later ones overlap with, and a stretch is two lengths.
double windows_of_stretch(const Observation& o) {
  return o.overlap ? static_cast<double>(o.overlap->size() + 2) : 2;
}

// How many times windows of a stretch, which share samples, scatter by more about a slow course than as many
// independent ones: 1 + 2 sum_n (1 - n/N) rho_n, N windows, with rho of docs/inference.md (44).
double overlap_of(const Observation& o, std::size_t block) {
  const double count = windows_of_stretch(o);
  double sum = 1;
  for (std::size_t n = 1; o.overlap && n <= o.overlap->size(); ++n)
    sum += 2 * (1 - static_cast<double>(n) / count) * (*o.overlap)[n - 1].harmonic[block];
  return std::max(1.0, sum);
}

class DecayLines {
 public:
  DecayLines(const CorrectedEstimate& found, const EstimateTask& task)
      : task_(task), estimate_(found.estimate), sets_(found.corrected) {
    for (ObservationSet& set : sets_) {
      set.truncation_change.clear();
      set.truncation_of_moves.clear();
    }
    if (sets_.empty()) return;
    const ModalProjection projection = modal_projection(task.campaign, *sets_.front().model);
    derivatives_ = projection.derivatives;
    one_channel_ = projection.channels.size() == 1 && sets_.front().model->modes() == 1;
    for (std::size_t s = 0; s < sets_.size(); ++s)
      if (!sets_[s].resonance->excited && s < found.replayed.size()) gather(s, found.replayed[s]);
    if (lines_.empty()) return;
    here_ = parameters_of(sets_);
    for (Line& line : lines_) line.expanded = prediction(line, here_, observation_of(line));
    see_unknowns();
  }

  bool empty() const { return lines_.empty(); }
  bool one_channel() const { return one_channel_; }
  double weight_of_means() const { return weight_of_means_; }
  double freedom() const { return independent_ - weight_of_means_ * static_cast<double>(offsets_) - 1; }
  // An even law that means show behind a coupling, whose corner is below the motion.
  std::vector<FoundFault> behind_coupling() const {
    if (!one_channel_ || derivatives_ == 0) return {};
    const auto law =
        coupled_law(sets_, derivatives_, 1 / frequency_, estimator_thresholds().contradiction_alarm / kinds);
    if (!law || !(std::abs(law->k * largest_) < 1)) return {};
    SizedFault result = fault(ChainFault::even_law, 1);
    result.size = law->k * largest_;
    result.coupling_s = law->time_constant_s;
    return {{result, law->counts}};
  }
  SizedFault fault(ChainFault kind, int poles) const {
    return {kind, poles, 0, frequency_, largest_, derivatives_, false, 0};
  }

  // What is left of the rows beside what is not known, where a fault is taken off (and first another, `beside` it)
  // and everything is estimated once more.
  VectorXd left(const SizedFault& fault, const SizedFault* beside = nullptr) const {
    std::vector<ObservationSet> sets = sets_;
    for (const SizedFault* one : {beside, &fault})
      if (one != nullptr && one->size != 0) sets = without_fault(sets, *one);
    const VectorXd there = fault.size == 0 && beside == nullptr ? here_ : parameters_of(sets);
    VectorXd rows = VectorXd::Zero(orthonormal_.rows());
    Index at = 0;
    for (const Line& line : lines_) {
      const Observation& is = sets[line.set].observations[line.observation];
      const Complex predicted = line.block ? line.replayed + prediction(line, there, is) - line.expanded : 0;
      const double sd = line.block ? is.harmonic_sd[*line.block] : line.sd;
      put((measured(line, is) - predicted) / (sd * std::sqrt(line.overlap)), line, rows, at);
    }
    return rows - orthonormal_ * (orthonormal_.transpose() * rows);
  }

 private:
  void gather(std::size_t s, const ObservationSet& replayed) {
    const ObservationSet& set = sets_[s];
    for_common_observations(set, replayed, [&](std::size_t i, std::size_t r) {
      for (std::size_t b = 0; b < set.resonance->blocks.size(); ++b) add_block(s, i, b, replayed.observations[r]);
      if (one_channel_ && derivatives_ > 0) add_mean(s, i);
    });
  }

  void add_block(std::size_t s, std::size_t i, std::size_t b, const Observation& replayed) {
    const RegressorBlock& block = sets_[s].resonance->blocks[b];
    const Observation& o = sets_[s].observations[i];
    const int multiple = block.kind == BlockKind::harmonic ? multiple_of(block) : 0;
    const auto mode = static_cast<std::size_t>(block.mode);
    if (multiple < 2 || multiple > highest_multiple || !(o.harmonic_sd[b] > 0) || o.growth_sd[mode] < 0) return;
    const double was = std::abs(replayed.amplitude[mode]), is = std::abs(o.amplitude[mode]);
    if (!(was > 0)) return;
    const double overlap = overlap_of(o, b);
    lines_.push_back(
        {s,
         i,
         b,
         mode,
         multiple,
         o.harmonic_sd[b],
         overlap,
         std::pow(is / was, multiple) * to_frame(replayed.harmonic[b], replayed.amplitude[mode], multiple),
         {}});
    rows_ += 2;
    independent_ += 2 / overlap;
    frequency_ += (o.rate[mode].imag() - frequency_) / static_cast<double>(lines_.size());
    largest_ = std::max(largest_, std::abs(o.amplitude[mode] * derived(o.rate[mode].imag(), derivatives_)));
  }

  // Of a velocity or an acceleration, whose motion has none.
  void add_mean(std::size_t s, std::size_t i) {
    const Observation& o = sets_[s].observations[i];
    if (o.mean.empty() || !(o.mean_sd.front() > 0) || o.growth_sd.front() < 0) return;
    means_.push_back({s, i, std::nullopt, 0, 0, o.mean_sd.front(), overlap_of_means(o), {}, {}});
  }

  // The weight of means, by what a zero, its drift and an even law leave of them: none where zeros
  // wander otherwise.
  void weigh_means() {
    const auto rows = static_cast<Index>(means_.size());
    constexpr Index of_a_record = unknowns_of_mean + terms_of_even_law;
    const Index unknowns = of_a_record * static_cast<Index>(records_.size());
    MatrixXd columns = MatrixXd::Zero(rows, unknowns);
    VectorXd target(rows);
    double independent = 0;
    for (Index i = 0; i < rows; ++i) {
      const Line& mean = means_[static_cast<std::size_t>(i)];
      const Observation& o = observation_of(mean);
      const double by = mean.sd * std::sqrt(mean.overlap);
      const Index first = of_a_record * records_.at(o.record);
      columns(i, first) = 1 / by;
      columns(i, first + 1) = o.centre_s / by;
      const double square = mean_square(o, derivatives_);
      for (Index term = 0; term < terms_of_even_law; ++term)
        columns(i, first + unknowns_of_mean + term) = std::pow(square, 1 + term) / by;
      target(i) = o.mean.front() / by;
      independent += 1 / mean.overlap;
    }
    columns.colwise().normalize();
    const double freedom = independent - static_cast<double>(unknowns);
    if (freedom >= 1) {
      const double left = (target - columns * VectorXd(columns.colPivHouseholderQr().solve(target))).squaredNorm();
      weight_of_means_ = weight_by_what_is_left(left, freedom);
    }
    if (weight_of_means_ == 0) means_.clear();
    if (means_.empty()) offsets_ = 0;
    for (Line& mean : means_) {
      mean.overlap /= weight_of_means_;
      independent_ += 1 / mean.overlap;
    }
  }

  const Observation& observation_of(const Line& line) const {
    return sets_[line.set].observations[line.observation];
  }

  static Complex measured(const Line& line, const Observation& o) {
    return line.block ? to_frame(o.harmonic[*line.block], o.amplitude[line.mode], line.multiple)
                      : Complex(o.mean.front());
  }

  // By the expansion, of which differences alone are used.
  Complex prediction(const Line& line, const VectorXd& parameters, const Observation& o) const {
    const ObservationSet& set = sets_[line.set];
    const std::vector<Complex> all = predicted_harmonics(*set.model, *set.resonance, parameters, o);
    return to_frame(all[*line.block], o.amplitude[line.mode], line.multiple);
  }

  static void put(Complex value, const Line& line, VectorXd& rows, Index& at) {
    rows(at++) = value.real();
    if (line.block) rows(at++) = value.imag();
  }

  VectorXd parameters_of(const std::vector<ObservationSet>& sets) const {
    EstimatePass pass = pass_between();
    pass.start = estimate_.state;
    return estimate(sets, task_.units, task_.options, pass).parameter_values;
  }

  // Steps of the estimate, each as likely as a standard normal number, and what means have of their own in each
  // record.
  void see_unknowns() {
    for (const Line& mean : means_)
      records_.try_emplace(observation_of(mean).record, static_cast<Index>(records_.size()));
    offsets_ = unknowns_of_mean * static_cast<Index>(records_.size());
    weigh_means();
    lines_.insert(lines_.end(), means_.begin(), means_.end());
    rows_ += static_cast<Index>(means_.size());
    std::vector<VectorXd> steps;
    for (const MatrixXd* of : {&estimate_.noise, &estimate_.open})
      for (const auto& step : of->colwise()) steps.emplace_back(step);
    const auto count = static_cast<Index>(steps.size());
    MatrixXd columns = MatrixXd::Zero(rows_ + count, count + offsets_);
    for (Index d = 0; d < count; ++d) {
      VectorXd column = VectorXd::Zero(rows_ + count);
      Index at = 0;
      const VectorXd moved = here_ + steps[static_cast<std::size_t>(d)];
      for (const Line& line : lines_) {
        const Observation& o = observation_of(line);
        put(line.block ? (prediction(line, moved, o) - line.expanded) / (line.sd * std::sqrt(line.overlap))
                       : Complex(),
            line, column, at);
      }
      column(rows_ + d) = 1;
      columns.col(d) = column;
    }
    Index at = 0;
    for (const Line& line : lines_) {
      if (!line.block) {
        const Observation& o = observation_of(line);
        const Index first = count + unknowns_of_mean * records_.at(o.record);
        columns(at, first) = 1 / line.sd;  // whatever its weight: a column may have any length
        columns(at, first + 1) = o.centre_s / line.sd;
      }
      at += line.block ? 2 : 1;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
    orthonormal_ = MatrixXd(qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank()));
  }

  const EstimateTask& task_;
  const Estimate& estimate_;
  std::vector<ObservationSet> sets_;
  std::vector<Line> lines_, means_;
  int derivatives_ = 0;
  bool one_channel_ = false;
  double frequency_ = 0, largest_ = 0;
  VectorXd here_;
  MatrixXd orthonormal_;
  std::map<std::size_t, Index> records_;  // of those with means, one after the other
  Index rows_ = 0, offsets_ = 0;
  double weight_of_means_ = 0;
  double independent_ = 0;  // of the rows
};

// A fault at the size that explains most, and what is left then.
struct Explained {
  SizedFault fault;
  double chi_squared = 0;
};

/// Whether more sizes are tried hangs on whether the first slope promises this share of what would count.
constexpr double promising = 0.25;

// By Gauss-Newton steps with slopes from size to size. Poles have no negative size. Nothing where no size explains
// more than none, or where the first slope does not promise a good part of `least_gain` in chi-squared.
std::optional<Explained> best_size(const DecayLines& lines, SizedFault fault, const VectorXd& without,
                                   double least_gain, const SizedFault* beside = nullptr) {
  std::optional<Explained> best;
  VectorXd before = without;
  double size_before = 0, size = first_size;
  for (int step = 0; step < most_sizes; ++step) {
    fault.size = size;
    VectorXd here;
    try {
      here = lines.left(fault, beside);
    } catch (const NumericalFailure&) {
      return best;
    }
    const double chi_squared = here.squaredNorm();
    if (chi_squared < (best ? best->chi_squared : without.squaredNorm())) best = Explained{fault, chi_squared};
    const VectorXd slope = (here - before) / (size - size_before);
    if (!(slope.squaredNorm() > 0)) break;
    if (step == 0 && std::pow(slope.dot(without), 2) / slope.squaredNorm() < promising * least_gain)
      return std::nullopt;
    double next = size - slope.dot(here) / slope.squaredNorm();
    if (is_filter(fault.kind) && next <= 0) {
      if (best) break;
      next = 0.1 * size;
    }
    if (!std::isfinite(next) || std::abs(next) > 1) break;
    if (std::abs(next - size) < same_size * std::abs(next)) break;
    before = here;
    size_before = size;
    size = next;
  }
  return best;
}

// An even law that means show beside another fault, which harmonics show: means know nothing of that one.
std::optional<FoundFault> law_beside(const DecayLines& lines, const SizedFault& first, double alarm) {
  SizedFault even = lines.fault(ChainFault::even_law, 1);
  if (!lines.one_channel() || even.derivatives == 0) return std::nullopt;
  even.shows_mean = true;
  const double freedom = lines.freedom() - 1;
  if (!(freedom >= 1)) return std::nullopt;
  const VectorXd without = lines.left(even, &first);
  const auto one = best_size(lines, even, without, f_upper_quantile(alarm, 1, freedom), &first);
  if (!one) return std::nullopt;
  const double scatter = std::max(1.0, one->chi_squared / freedom);
  const double counts = beyond_chance((without.squaredNorm() - one->chi_squared) / scatter, freedom, alarm);
  return counts > 0 ? std::optional(FoundFault{one->fault, counts}) : std::nullopt;
}

// A high-pass takes off the means by which an even law would show, and turns the second harmonic that it makes:
// that it explains more than such a law says nothing against the law.
bool hides_behind(const SizedFault& law, const SizedFault& best) {
  return best.kind == ChainFault::high_pass && law.kind == ChainFault::even_law && !law.shows_mean;
}

}  // namespace

std::vector<FoundFault> faults_in_decays(const CorrectedEstimate& found, const EstimateTask& task) {
  const DecayLines lines(found, task);
  if (lines.empty() || !(lines.freedom() >= 1)) return {};
  const VectorXd without = lines.left(lines.fault(ChainFault::low_pass, 1));
  const double alarm = estimator_thresholds().contradiction_alarm / kinds;
  const double least_gain = f_upper_quantile(alarm, 1, lines.freedom());
  std::vector<Explained> explained;
  const auto search = [&](const SizedFault& fault) {
    auto one = best_size(lines, fault, without, least_gain);
    if (one) explained.push_back(*one);
    return one.has_value();
  };
  for (const ChainFault kind : {ChainFault::low_pass, ChainFault::high_pass})
    for (const int poles : numbers_of_poles)
      if (!search(lines.fault(kind, poles))) break;
  if (lines.one_channel()) {
    search(lines.fault(ChainFault::cubic_law, 1));
    SizedFault even = lines.fault(ChainFault::even_law, 1);
    const bool moves = even.derivatives == 0;  // its mean is among what numbers are estimated from
    even.shows_mean = moves;
    search(even);
    even.shows_mean = true;
    if (!moves && lines.weight_of_means() > 0) search(even);
  }
  const auto best = std::min_element(explained.begin(), explained.end(),
                                     [](const auto& a, const auto& b) { return a.chi_squared < b.chi_squared; });
  std::vector<FoundFault> result = lines.behind_coupling();
  if (explained.empty()) return result;
  const double least = best->chi_squared;
  const double scatter = std::max(1.0, least / lines.freedom());
  const double usual = f_upper_quantile(as_likely, 1, lines.freedom());
  double best_counts = 0, told_alone = 0;  // of the best one; of an even law that means show, as if it were alone
  for (const Explained& one : explained) {
    const double gain = without.squaredNorm() - one.chi_squared;
    const double counts = beyond_chance(gain / scatter, lines.freedom(), alarm);
    const double beside_best =
        hides_behind(one.fault, best->fault)
            ? 1
            : std::clamp((least_gain - (one.chi_squared - least) / scatter) / (least_gain - usual), 0.0, 1.0);
    if (!(counts > 0) || !(beside_best > 0)) continue;
    const bool told_by_means = one.fault.shows_mean && one.fault.derivatives > 0;
    if (told_by_means) told_alone = beside_best;
    if (&one == &*best) best_counts = counts;
    const double seen = told_by_means ? lines.weight_of_means() : 1;
    result.push_back({one.fault, seen * counts * beside_best});
  }
  if (best_counts * (1 - told_alone) * lines.weight_of_means() > 0)
    if (auto second = law_beside(lines, best->fault, alarm)) {
      second->counts *= best_counts * (1 - told_alone) * lines.weight_of_means();
      result.push_back(*second);
    }
  return result;
}

}  // namespace secular
