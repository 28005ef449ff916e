#include "measure/modal/pole_support.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "measure/modal/amplitude_motion.hpp"
#include "measure/modal/close_poles.hpp"
#include "measure/modal/fit_residual.hpp"
#include "measure/modal/noise_whitening.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/pole_fit.hpp"
#include "measure/modal/record_scatter.hpp"
#include "measure/thresholds.hpp"
#include "numerics/confidence.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr auto& amplitude_change_false_alarm = measure_thresholds().amplitude_change_false_alarm;
constexpr double least_at_null = 0.04;  // modes half as far apart as they are wide: exp(-pi)
constexpr int highest_degree = 3;       // of a law of amplitude that two modes are held against
constexpr double unlimited = std::numeric_limits<double>::infinity();

const std::string of_noise = "explains no more of the records than noise does";
const std::string once = "one record shows it, others of the same kind do not";
const std::string strays = "the records show no resonance where it is, but make up by it for another mode";
const std::string too_many = "the records are too short to determine so many poles";
const std::string too_wide = "its error bar is as wide as its resonance";
const std::string no_peak = "its damping cannot be distinguished from one without a resonance";
const std::string no_turn = "swings less than once in the records";
const std::string not_measured =
    "smaller than any converter resolves: it is of the arithmetic that made the samples";
const std::string at_the_top = "cannot be distinguished from one above half the sample rate";

VectorXcd as_vector(const std::vector<Complex>& poles) {
  return Eigen::Map<const VectorXcd>(poles.data(), static_cast<Index>(poles.size()));
}

// Channels of which no sum is another one or constant: others repeat the same noise, and would count it twice.
std::vector<Index> independent_channels(const FreeMotions& motions) {
  const Index rows = motions.samples.rows(), records = motions.samples.cols() / motions.channels;
  MatrixXd moved(rows * records, motions.channels);
  const MatrixXd about_mean = motions.samples.rowwise() - motions.samples.colwise().mean();
  for (Index r = 0; r < records; ++r)
    moved.middleRows(r * rows, rows) = about_mean.middleCols(r * motions.channels, motions.channels);
  // Offsets are rounded, too: what is left of a constant is as small against it as rounding.
  const Eigen::VectorXd level = motions.samples.cwiseAbs().colwise().maxCoeff();
  constexpr double rounding = 1e-12;
  for (Index c = 0; c < motions.channels; ++c) {
    double largest = 0;
    for (Index r = 0; r < records; ++r) largest = std::max(largest, level(r * motions.channels + c));
    const double norm = moved.col(c).norm();
    if (norm > rounding * largest * std::sqrt(static_cast<double>(moved.rows())))
      moved.col(c) /= norm;
    else
      moved.col(c).setZero();
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(moved);
  qr.setThreshold(rounding);
  std::vector<Index> kept;
  for (Index k = 0; k < qr.rank(); ++k) kept.push_back(qr.colsPermutation().indices()(k));
  std::sort(kept.begin(), kept.end());
  return kept;
}

FreeMotions with_channels(const FreeMotions& motions, const std::vector<Index>& kept) {
  FreeMotions result = motions;
  result.channels = static_cast<Index>(kept.size());
  std::vector<Index> columns;
  for (Index first = 0; first < motions.samples.cols(); first += motions.channels)
    for (const Index c : kept) columns.push_back(first + c);
  result.samples = motions.samples(Eigen::all, columns);
  return result;
}

// Sums of squares that poles leave, by signal.
VectorXd left_by(const MatrixXd& samples, const PoleFit& fit) {
  const auto freedom = static_cast<double>(samples.rows() - 2 * fit.poles.size() - 1);
  return fit.noise_sd.cwiseAbs2() * freedom;
}

class Selection {
 public:
  Selection(const FreeMotions& motions, const std::vector<Complex>& candidates, double false_alarm,
            const std::function<void(double)>& progress)
      : motions_(motions),
        candidates_(candidates),
        false_alarm_(false_alarm),
        progress_(progress),
        support_(candidates.size()),
        most_(static_cast<std::size_t>(motions.samples.rows() / 8)) {  // four unknowns a pole and channel, twice
    for (std::size_t c = 0; c < candidates.size(); ++c) support_[c].pole = candidates[c];
  }

  std::vector<PoleSupport> run() {
    // What grows by more than numbers hold is no motion over the records.
    const double duration = static_cast<double>(motions_.samples.rows()) / motions_.sample_rate_hz;
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      if (representable(candidates_[c], duration))
        open_.push_back(c);
      else
        support_[c].reason = of_noise;
    if (open_.empty()) return support_;
    whiten_by_candidates();
    add_poles();
    drop_redundant();
    drop_unrepeated();
    drop_wide();
    whiten_by_chosen();
    split_close();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      PoleSupport& s = support_[chosen_[i]];
      const auto row = static_cast<Index>(i);
      s.moves = true;
      s.pole = fit_.poles(row);
      s.growth_sd = fit_.growth_sd(row);
      s.omega_sd = fit_.omega_sd(row);
    }
    if (chosen_.empty()) return support_;
    find_amplitudes();
    widen();
    keep_resonances();
    return support_;
  }

 private:
  // By error bars that hold all that is known.
  void keep_resonances() {
    for (const std::size_t c : chosen_) {
      PoleSupport& s = support_[c];
      s.reason = is_measured(s) ? no_resonance(s.value, s.growth_error, s.omega_error) : not_measured;
      s.stands = s.reason.empty();
    }
  }

  // The widest converters have 32 bits.
  bool is_measured(const PoleSupport& s) const {
    constexpr double resolution = 0x1p-32;
    for (std::size_t record = 0; record < s.amplitudes.size(); ++record) {
      const auto first = static_cast<Index>(record) * motions_.channels;
      const double largest = motions_.samples.middleCols(first, motions_.channels).cwiseAbs().maxCoeff();
      if (s.amplitudes[record] > resolution * largest) return true;
    }
    return false;
  }

  // Of the samples as they are: each record is whitened by mixing of its own.
  void find_amplitudes() {
    const PoleFit fit = fit_residues(motions_.samples, motions_.sample_rate_hz, fit_.poles);
    const auto records = static_cast<Index>(motions_.groups.size());
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      const Eigen::MatrixXcd residues =
          fit.residues.row(static_cast<Index>(i)).reshaped(motions_.channels, records);
      for (Index record = 0; record < records; ++record)
        support_[chosen_[i]].amplitudes.push_back(2 * residues.col(record).norm());
    }
  }

  // Error bars hold what the fit leaves near a pole, Eq. (M7), and by what records differ, Eq. (M8).
  void widen() {
    const FitResidual whitened(samples_, motions_.sample_rate_hz, fit_of_values_);
    const std::vector<RecordScatter> scatter = record_scatter(whitened.by_record(motions_.channels));
    const auto tests = 2 * static_cast<double>(chosen_.size());  // (M5) and (M6) of each pole
    bool constant = true;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      PoleSupport& s = support_[chosen_[i]];
      const auto row = static_cast<Index>(i);
      std::vector<ExplainedSquares> seen = whitened.along_powers(row);
      seen.push_back(whitened.along_laws(row, s.amplitudes, motions_.channels));
      double excess = 0;
      for (const ExplainedSquares& squares : seen) {
        if (tests * squares.probability() < amplitude_change_false_alarm)
          excess = std::max(excess, squares.gain - squares.freedom);
      }
      s.more_than_noise = excess > 0;
      constant = constant && !s.more_than_noise;
      s.value = fit_of_values_.poles(row);
      s.growth_error = widened(fit_of_values_.growth_sd(row), excess, scatter[2 * i]);
      s.omega_error = widened(fit_of_values_.omega_sd(row), excess, scatter[2 * i + 1]);
    }
    // What one pole leaves is in the noise that all are measured by.
    for (const std::size_t c : chosen_) support_[c].all_constant = constant;
  }

  // A part of the excess along the pole's columns counts as two standard deviations, and so does the 95 % interval
  // of a scatter that few records tell.
  static double widened(double sd, double excess, const RecordScatter& scatter) {
    const double noise = sd * sd, both = noise + scatter.variance;
    double student = 1;
    if (scatter.variance > 0) {
      const double freedom = scatter.degrees_of_freedom * std::pow(both / scatter.variance, 2);
      student = confidence_interval(0, 1, freedom).high / confidence_interval(0, 1, unlimited).high;
    }
    return std::sqrt(student * student * both + noise * excess / 4);
  }

  void whiten(const FitResidual::Noise& noise) {
    const double largest = motions_.samples.cwiseAbs().maxCoeff();
    // Rounding of what a reader or a filter made of the samples.
    constexpr double rounding = 1e-12;
    const NoiseWhitening whitening(noise.samples, motions_.channels, noise.unknowns, rounding * largest);
    samples_ = whitening(motions_.samples);
    const Eigen::RowVectorXd mean = samples_.colwise().mean();
    nothing_ = (samples_.rowwise() - mean).colwise().squaredNorm().transpose();
  }

  // The noise is what all candidates leave, each carried to where it explains most.
  void whiten_by_candidates() {
    const PoleFit fit = refine_poles(motions_.samples, motions_.sample_rate_hz, determined());
    const FitResidual residual(motions_.samples, motions_.sample_rate_hz, fit);
    whiten({residual.left(), 2 * fit.poles.size() + 1});
  }

  // What the poles that stand lack near them is no noise, and would hide there from (M5) and (M6): error bars are
  // those in what is left beside it. Where one pole then comes closer to another's place than to its own, the fit
  // has more poles than this noise tells, and stays as it was.
  void whiten_by_chosen() {
    fit_of_values_ = fit_;
    if (chosen_.empty()) return;
    const PoleFit fit = fit_residues(motions_.samples, motions_.sample_rate_hz, fit_.poles);
    const MatrixXd before = samples_;
    whiten(FitResidual(motions_.samples, motions_.sample_rate_hz, fit).noise());
    PoleFit again = refined(fit_.poles);
    if (strayed_from(fit_.poles, again.poles))
      samples_ = before;
    else
      fit_of_values_ = std::move(again);
  }

  // Two modes that were seen as one.
  void split_close() {
    if (chosen_.empty()) return;
    const MatrixXd before = samples_;
    std::set<std::size_t> judged;
    find_pairs();
    bool any = false, again = true;
    while (again && chosen_.size() < most_) {
      again = false;
      whiten_beside(all_pairs());
      const PoleFit fit = refined(fit_of_values_.poles);
      if (strayed_from(fit_of_values_.poles, fit.poles)) break;
      for (const Index row : poles_with_excess(fit)) {
        if (!judged.insert(chosen_[static_cast<std::size_t>(row)]).second || !split(fit, row)) continue;
        again = any = true;
        break;
      }
    }
    samples_ = before;
    if (any) whiten_by_chosen();
  }

  // By pole of the fit two poles near it that explain most of the samples as they are.
  void find_pairs() {
    const PoleFit raw = fit_residues(motions_.samples, motions_.sample_rate_hz, fit_of_values_.poles);
    for (Index r = 0; r < raw.poles.size(); ++r) {
      const auto [first, second] = closest_pair(motions_.samples, motions_.sample_rate_hz, raw, r);
      pairs_.push_back({first, second});
    }
  }

  // What is left of two motions, as large and decaying at the mean rate, where their beat is null for the first
  // time. Before, they decay like one whose damping changes with amplitude.
  static double beat_left(Complex first, Complex second) {
    const double rate = std::abs(first.real() + second.real()) / 2;
    return std::exp(-std::numbers::pi * rate / std::abs(first.imag() - second.imag()));
  }

  // Of all poles but that at `without`.
  std::vector<Complex> all_pairs(std::size_t without = std::numeric_limits<std::size_t>::max()) const {
    std::vector<Complex> all;
    for (std::size_t r = 0; r < pairs_.size(); ++r)
      if (r != without) all.insert(all.end(), pairs_[r].begin(), pairs_[r].end());
    return all;
  }

  // The noise is what is left beside two poles in the place of each, whether or not there are two: a second mode is
  // no noise.
  void whiten_beside(std::vector<Complex> poles) {
    if (4 * static_cast<Index>(poles.size()) > motions_.samples.rows()) poles.resize(chosen_.size());
    const PoleFit raw = fit_residues(motions_.samples, motions_.sample_rate_hz, as_vector(poles));
    const FitResidual residual(motions_.samples, motions_.sample_rate_hz, raw);
    whiten({residual.left(), 2 * raw.poles.size() + 1});
  }

  // Whether more than noise is left near a pole, (M6), at the level over `poles` of them; by how much, or zero.
  static double excess_near(const FitResidual& residual, Index pole, std::size_t poles) {
    double excess = 0;
    for (const ExplainedSquares& squares : residual.along_powers(pole))
      if (static_cast<double>(poles) * squares.probability() < amplitude_change_false_alarm)
        excess = std::max(excess, squares.gain - squares.freedom);
    return excess;
  }

  // The largest excess first.
  std::vector<Index> poles_with_excess(const PoleFit& fit) const {
    const FitResidual residual(samples_, motions_.sample_rate_hz, fit);
    std::vector<std::pair<double, Index>> by_excess;
    for (Index r = 0; r < fit.poles.size(); ++r)
      if (const double excess = excess_near(residual, r, chosen_.size()); excess > 0)
        by_excess.emplace_back(-excess, r);
    std::sort(by_excess.begin(), by_excess.end());
    std::vector<Index> rows;
    for (const auto& [excess, row] : by_excess) rows.push_back(row);
    return rows;
  }

  double squares(const PoleFit& fit) const { return left_by(samples_, fit).sum(); }

  // Two motions of constant frequency and damping in the place of one, where they leave no more than noise there
  // and are the better explanation by Schwarz's criterion than one that may change with amplitude.
  bool split(const PoleFit& fit, Index row) {
    const MatrixXd before = samples_;
    PoleFit pair = refined(with_pair(fit.poles, row, closest_pair(samples_, motions_.sample_rate_hz, fit, row)));
    const Index last = pair.poles.size() - 1;
    std::vector<Complex> all = {pair.poles(row), pair.poles(last)};
    for (const Complex pole : all_pairs(static_cast<std::size_t>(row))) all.push_back(pole);
    whiten_beside(std::move(all));
    pair = refined(pair.poles);
    const PoleFit one = refined(fit.poles);
    if (strayed_from(fit.poles, one.poles) || strayed_from(fit.poles, pair.poles) || !two_stand(pair, one, row)) {
      samples_ = before;
      return false;
    }
    const std::size_t seen_as = chosen_[static_cast<std::size_t>(row)];
    const int first = support_[seen_as].beside;
    chosen_.push_back(support_.size());
    support_.emplace_back().beside = first < 0 ? static_cast<int>(seen_as) : first;
    pairs_[static_cast<std::size_t>(row)] = {pair.poles(row)};
    pairs_.push_back({pair.poles(last)});
    fit_ = fit_of_values_ = std::move(pair);
    return true;
  }

  // `pair`: with two poles, at `row` and the last, in the place of that at `row` of `one`.
  bool two_stand(const PoleFit& pair, const PoleFit& one, Index row) const {
    const Index last = pair.poles.size() - 1;
    if (!(beat_left(pair.poles(row), pair.poles(last)) > least_at_null)) return false;
    const double price = std::log(static_cast<double>(samples_.size())), left = squares(pair);
    const double with_two = left + static_cast<double>(2 + 2 * samples_.cols()) * price;
    double rival = squares(one);
    if (!(with_two < rival) || !significant(rival - left)) return false;
    const FitResidual residual(samples_, motions_.sample_rate_hz, pair);
    for (const Index r : {row, last})
      if (!(std::max(pair.growth_sd(r), pair.omega_sd(r)) < width(pair.poles(r))) || !has_peak(pair.poles(r)) ||
          nearest(one.poles, pair.poles(r)) != row || excess_near(residual, r, 2) > 0)
        return false;
    MotionBeside motion{
        samples_, motions_.channels, motions_.sample_rate_hz, without(one.poles, row), one.poles(row), {}};
    // As measured: the noise that whitened samples are counted in may differ from record to record.
    const PoleFit measured = fit_residues(motions_.samples, motions_.sample_rate_hz, one.poles);
    for (Index s = 0; s < samples_.cols(); s += motions_.channels)
      motion.amplitudes.push_back(measured.residues.row(row).segment(s, motions_.channels).norm());
    // A law explains as much as any of lower degree.
    const double most = squares_left_by_law(motion, highest_degree, rival);
    rival = std::min(rival, most + 2 * highest_degree * price);
    for (int degree = 1; degree < highest_degree && with_two < rival && most + 2 * degree * price < with_two;
         ++degree)
      rival = std::min(rival, squares_left_by_law(motion, degree, rival) + 2 * degree * price);
    return with_two < rival;
  }

  // Whether one of the poles is nearer to another's place than to its own.
  static bool strayed_from(const VectorXcd& places, const VectorXcd& poles) {
    for (Index r = 0; r < places.size(); ++r)
      if (nearest(places, poles(r)) != r) return true;
    return false;
  }

  static Index nearest(const VectorXcd& poles, Complex pole) {
    Index at = 0;
    (poles.array() - pole).abs().minCoeff(&at);
    return at;
  }

  // As many as the rows determine together, those that explain most each by itself.
  VectorXcd determined() const {
    std::vector<std::pair<double, std::size_t>> by_rest;
    for (const std::size_t c : open_) {
      const PoleFit alone =
          fit_residues(motions_.samples, motions_.sample_rate_hz, VectorXcd::Constant(1, candidates_[c]));
      by_rest.emplace_back(alone.noise_sd.squaredNorm(), c);
    }
    std::sort(by_rest.begin(), by_rest.end());
    by_rest.resize(std::min(by_rest.size(), most_));
    std::vector<Complex> kept;
    for (const auto& [rest, c] : by_rest) kept.push_back(candidates_[c]);
    return as_vector(kept);
  }

  PoleFit refined(const VectorXcd& start) const { return refine_poles(samples_, motions_.sample_rate_hz, start); }
  PoleFit residues(const VectorXcd& poles) const { return fit_residues(samples_, motions_.sample_rate_hz, poles); }
  VectorXd left() const { return chosen_.empty() ? nothing_ : left_by(samples_, fit_); }

  // A damped motion that fills a share of the rows has that share of the rows' half as its frequencies; over shares
  // of 1, 1/2, 1/4, ... they add up to the rows, and growth counts like decay.
  bool significant(double gain) const {
    const auto cells = static_cast<double>(2 * samples_.rows());
    const auto freedom = static_cast<double>(2 + 2 * samples_.cols());
    return cells * chi_squared_upper_tail(gain, freedom) < false_alarm_;
  }

  void add_poles() {
    while (!open_.empty() && chosen_.size() < most_) {
      if (progress_) progress_(1 - static_cast<double>(open_.size()) / static_cast<double>(candidates_.size()));
      const auto with = [&](std::size_t candidate) {
        VectorXcd start(static_cast<Index>(chosen_.size()) + 1);
        start << fit_.poles, candidates_[candidate];
        return start;
      };
      std::size_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < open_.size(); ++k) {
        const double sum = left_by(samples_, residues(with(open_[k]))).sum();
        if (sum < least) best = k;
        least = std::min(least, sum);
      }
      const std::size_t candidate = open_[best];
      open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(best));
      PoleFit fit = refined(with(candidate));
      const Complex from = candidates_[candidate];
      if (!significant(left().sum() - left_by(samples_, fit).sum())) {
        support_[candidate].reason = of_noise;
      } else if (strayed(fit, from)) {
        support_[candidate].reason = strays;
      } else {
        chosen_.push_back(candidate);
        fit_ = std::move(fit);
      }
    }
    for (const std::size_t candidate : open_) support_[candidate].reason = too_many;
  }

  // Whether the last pole came closer to another one than to where it was seen.
  static bool strayed(const PoleFit& fit, Complex from) {
    const Index last = fit.poles.size() - 1;
    const double way = std::abs(fit.poles(last) - from);
    for (Index r = 0; r < last; ++r)
      if (std::abs(fit.poles(last) - fit.poles(r)) < way) return true;
    return false;
  }

  static VectorXcd without(const VectorXcd& all, Index row) {
    VectorXcd poles(all.size() - 1);
    poles << all.head(row), all.tail(poles.size() - row);
    return poles;
  }

  void drop(Index row, const std::string& reason) {
    const VectorXcd others = without(fit_.poles, row);
    const auto at = chosen_.begin() + row;
    support_[*at].reason = reason;
    chosen_.erase(at);
    fit_ = chosen_.empty() ? PoleFit() : refined(others);
  }

  // The pole that is missed least, as long as leaving it out costs no more than noise.
  void drop_redundant() {
    while (chosen_.size() > 1) {
      Index least = 0;
      double cost = std::numeric_limits<double>::infinity();
      for (Index r = 0; r < fit_.poles.size(); ++r) {
        const double sum = left_by(samples_, residues(without(fit_.poles, r))).sum();
        if (sum < cost) least = r;
        cost = std::min(cost, sum);
      }
      if (significant(left_by(samples_, refined(without(fit_.poles, least))).sum() - left().sum())) return;
      drop(least, of_noise);
    }
  }

  bool repeats(const VectorXd& gains) const {
    const Index records = gains.size() / motions_.channels;
    std::map<std::string, std::vector<double>> by_group;
    std::string of_best;
    double best = -1;
    for (Index r = 0; r < records; ++r) {
      const std::string& group = motions_.groups[static_cast<std::size_t>(r)];
      by_group[group].push_back(gains.segment(r * motions_.channels, motions_.channels).sum());
      if (by_group[group].back() > best) of_best = group;
      best = std::max(best, by_group[group].back());
    }
    double rest = -best;
    for (const double gain : by_group[of_best]) rest += gain;
    const auto others = static_cast<double>(by_group[of_best].size() - 1);
    if (others == 0) return true;
    const auto freedom = 2 * others * static_cast<double>(motions_.channels);  // the pole is known by now
    return chi_squared_upper_tail(rest, freedom) < false_alarm_;
  }

  void drop_unrepeated() {
    for (Index r = fit_.poles.size(); r-- > 0;) {
      const VectorXd rest = chosen_.size() > 1 ? left_by(samples_, residues(without(fit_.poles, r))) : nothing_;
      if (!repeats(rest - left())) drop(r, once);
    }
  }

  void drop_wide() {
    for (Index r = fit_.poles.size(); r-- > 0;)
      if (!(std::max(fit_.growth_sd(r), fit_.omega_sd(r)) < width(fit_.poles(r)))) drop(r, too_wide);
  }

  // Why what the records hold there is no resonance; empty where it is one. The fit keeps it beside the others: it
  // is motion, and would be taken for theirs. What ended at a limit of the fit has no error bar that counts, and is
  // nearer to the limit than one.
  std::string no_resonance(Complex pole, double growth_sd, double omega_sd) const {
    const double duration = static_cast<double>(samples_.rows()) / motions_.sample_rate_hz;
    const Interval peak =
        confidence_interval(pole.imag() - std::abs(pole.real()), std::hypot(growth_sd, omega_sd), unlimited);
    const Interval omega = confidence_interval(pole.imag(), omega_sd, unlimited);
    if (!(peak.low > 0)) return no_peak;
    if (!(pole.imag() * duration > two_pi)) return no_turn;
    return omega.high < std::numbers::pi * motions_.sample_rate_hz ? "" : at_the_top;
  }

  // Half-power bandwidth (rad/s), or what the record's length makes of it.
  double width(Complex pole) const {
    const double duration = static_cast<double>(samples_.rows()) / motions_.sample_rate_hz;
    return 2 * std::max(std::abs(pole.real()), 1 / duration);
  }

  const FreeMotions& motions_;
  const std::vector<Complex>& candidates_;
  double false_alarm_;
  const std::function<void(double)>& progress_;
  std::vector<PoleSupport> support_;
  std::vector<std::size_t> open_;  // candidates not decided on
  std::size_t most_;               // poles at a time
  MatrixXd samples_;               // whitened
  VectorXd nothing_;               // sums of squares about the mean, by signal
  std::vector<std::size_t> chosen_;
  std::vector<std::vector<Complex>> pairs_;  // in the place of each of the chosen ones
  PoleFit fit_;                              // of the chosen ones
  PoleFit fit_of_values_;                    // the same in noise that holds nothing of what it lacks
};

}  // namespace

std::vector<PoleSupport> pole_support(const FreeMotions& motions, const std::vector<Complex>& candidates,
                                      double false_alarm, const std::function<void(double)>& progress) {
  if (motions.channels < 1 ||
      motions.samples.cols() != motions.channels * static_cast<Index>(motions.groups.size()))
    throw std::invalid_argument("pole_support: channels and groups do not make up the signals");
  if (candidates.empty()) return {};
  if (!motions.samples.allFinite()) throw std::invalid_argument("pole_support: not finite");
  const std::vector<Index> kept = independent_channels(motions);
  if (kept.empty() || static_cast<Index>(kept.size()) == motions.channels)
    return Selection(motions, candidates, false_alarm, progress).run();
  return Selection(with_channels(motions, kept), candidates, false_alarm, progress).run();
}

}  // namespace secular
