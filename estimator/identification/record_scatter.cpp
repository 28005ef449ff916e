#include "estimator/identification/record_scatter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stretches that leave less than this of a record's rows to the others tell nothing of their scatter.
constexpr double one_stretch = 1e-6;

/// On either side of a 95 % interval.
constexpr auto& tail_share = estimator_thresholds().interval_tail;

/// Probability that records of a case which do not differ show that they do.
constexpr auto& false_alarm = estimator_thresholds().false_lack_of_fit;

// A record's rows, of the column x of one natural frequency.
struct RecordPart {
  double squares = 0;                                  // |x_r|^2
  double product = 0;                                  // x_r'e
  VectorXd seen;                                       // U_r'x_r
  MatrixXd gram;                                       // U_r'U_r
  std::map<int, std::pair<double, double>> stretches;  // |x_g|^2, x_g'e
};

// Stretches of a dwell are its ensembles.
std::map<std::size_t, RecordPart> parts_of(const CaseFit& fit, Index column) {
  std::map<std::size_t, RecordPart> records;
  const bool dwells = fit.set->resonance->excited;
  const Index rank = fit.fit.rank;
  for (Index row = 0; row < fit.system.design.rows(); ++row) {
    const auto at = static_cast<std::size_t>(row);
    const double x = fit.system.design(row, column), e = fit.fit.residual(row);
    RecordPart& part = records[fit.set->observations[fit.system.observation[at]].record];
    if (part.seen.size() == 0) {
      part.seen = VectorXd::Zero(rank);
      part.gram = MatrixXd::Zero(rank, rank);
    }
    const VectorXd u = fit.fit.orthonormal.row(row).transpose();
    part.gram.selfadjointView<Eigen::Lower>().rankUpdate(u);
    if (x == 0) continue;
    auto& [squares, product] =
        part.stretches[dwells ? static_cast<int>(fit.system.observation[at]) : fit.system.condition[at]];
    squares += x * x;
    product += x * e;
    part.squares += x * x;
    part.product += x * e;
    part.seen += x * u;
  }
  std::erase_if(records, [](const auto& entry) { return entry.second.squares == 0; });
  return records;
}

// Variance of x_r'e by what the stretches of the record scatter about their common shift, with shares w_g of
// |x_r|^2: sum (x_g'e - w_g x_r'e)^2 is (1 - sum w_g^2) of it on average. And its degrees of freedom.
std::optional<std::pair<double, double>> variance_of_product(const RecordPart& part) {
  double sum = 0, second = 0, third = 0;
  for (const auto& [label, stretch] : part.stretches) {
    const double share = stretch.first / part.squares;
    sum += std::pow(stretch.second - share * part.product, 2);
    second += share * share;
    third += share * share * share;
  }
  const double left = 1 - second;
  if (!(left > one_stretch)) return std::nullopt;
  return std::pair{sum / left, left * left / (second - 2 * third + second * second)};
}

std::optional<RecordSums> sums_of(const CaseFit& fit, Index column) {
  const std::map<std::size_t, RecordPart> records = parts_of(fit, column);
  const auto count = static_cast<Index>(records.size());
  if (count < 2) return std::nullopt;
  RecordSums result;
  result.unit = 0;
  for (const auto& [index, part] : records) result.unit += part.squares / static_cast<double>(count);
  result.sums.resize(count);
  result.own_noise.resize(count);
  result.freedom.resize(count);
  VectorXd squares(count), by_row(count);  // |x_r|^2, and the variance of a row of each record
  MatrixXd& seen = result.seen;
  seen.resize(fit.fit.rank, count);
  MatrixXd gram = MatrixXd::Zero(fit.fit.rank, fit.fit.rank);
  Index r = 0;
  for (const auto& [index, part] : records) {
    const auto variance = variance_of_product(part);
    if (!variance) return std::nullopt;
    result.record.push_back(index);
    result.sums(r) = part.product / std::sqrt(result.unit);
    squares(r) = part.squares / result.unit;
    by_row(r) = variance->first / part.squares;
    result.own_noise(r) = by_row(r) / squares(r);
    result.freedom(r) = variance->second;
    seen.col(r) = part.seen / std::sqrt(result.unit);
    gram += by_row(r) * MatrixXd(part.gram.selfadjointView<Eigen::Lower>());
    ++r;
  }
  const MatrixXd common = seen.transpose() * seen;
  result.shown = MatrixXd(squares.asDiagonal()) - common;
  // Of x_r'M e, where e has the variance `by_row` in the rows of each record.
  result.noise = MatrixXd(squares.cwiseProduct(by_row).asDiagonal()) - by_row.asDiagonal() * common -
                 common * by_row.asDiagonal() + seen.transpose() * gram * seen;
  return result;
}

// Q(t) and its law at the variance t between records.
class Moments {
 public:
  explicit Moments(const RecordSums& sums) : sums_(sums) {
    // Differences between records: a shift of all of them is no scatter.
    const Index count = sums.sums.size();
    const MatrixXd mean = VectorXd::Ones(count) / std::sqrt(static_cast<double>(count));
    const MatrixXd basis =
        Eigen::HouseholderQR<MatrixXd>(mean).householderQ() * MatrixXd(MatrixXd::Identity(count, count));
    contrasts_ = basis.rightCols(count - 1);
    differences_ = contrasts_.transpose() * sums.sums;
    noise_ = contrasts_.transpose() * sums.noise * contrasts_;
    const MatrixXd shown = contrasts_.transpose() * sums.shown;
    between_ = shown * shown.transpose();
  }

  double statistic(double variance) const {
    return differences_.dot(MatrixXd(noise_ + variance * between_).ldlt().solve(differences_));
  }
  // What Q/freedom is divided by to follow the F law, and the degrees of freedom of its denominator (B. L. Welch,
  // Biometrika 38, 1951); of a record's variance the part counts that its stretches have to tell.
  std::pair<double, double> law(double variance) const {
    const VectorXd weight = (sums_.own_noise.array() + variance).inverse();
    double sum = 0;
    for (Index r = 0; r < weight.size(); ++r)
      sum += std::pow((1 - weight(r) / weight.sum()) * sums_.own_noise(r) * weight(r), 2) / sums_.freedom(r);
    const auto count = static_cast<double>(weight.size()), pairs = count * count - 1;
    return {1 + 2 * (count - 2) / pairs * sum, pairs / (3 * sum)};
  }
  // By record: the likeliest shift from the mean.
  VectorXd shifts(double variance) const { return shifts_of(differences_, variance); }
  // Of shifts() where records scatter by `variance`.
  MatrixXd covariance(double variance) const {
    return variance * shifts_of(contrasts_.transpose() * sums_.shown, variance);
  }
  double freedom() const { return static_cast<double>(differences_.size()); }
  double expected(double variance) const {
    const auto [divisor, denominator] = law(variance);
    return freedom() * divisor * (denominator > 2 ? denominator / (denominator - 2) : 1);
  }
  // By how much a Q(0) that records which do not differ exceed with probability `tail` is larger than the one seen.
  double alarm(double tail) const {
    const auto [divisor, denominator] = law(0);
    return divisor * freedom() * f_upper_quantile(tail, freedom(), denominator) / statistic(0);
  }
  // That records which scatter by `variance` give a Q as large as `factor` times the one seen.
  double tail(double variance, double factor = 1) const {
    const auto [divisor, denominator] = law(variance);
    return f_upper_tail(factor * statistic(variance) / (divisor * freedom()), freedom(), denominator);
  }

 private:
  MatrixXd shifts_of(const MatrixXd& differences, double variance) const {
    return variance * sums_.shown *
           (contrasts_ * MatrixXd(MatrixXd(noise_ + variance * between_).ldlt().solve(differences)));
  }

  const RecordSums& sums_;
  VectorXd differences_;
  MatrixXd contrasts_, noise_, between_;
};

// Where `rising` is zero, from zero on; zero if it is positive there.
double root_of(const std::function<double(double)>& rising) {
  if (rising(0) >= 0) return 0;
  double low = 0, high = 1;
  while (rising(high) < 0 && high < 1e300) {
    low = high;
    high *= 4;
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = low + 0.5 * (high - low);
    (rising(middle) < 0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::size_t count_of_records(const ObservationSet& set) {
  std::set<std::size_t> records;
  for (const Observation& o : set.observations) records.insert(o.record);
  return records.size();
}

std::optional<ScatterBetweenRecords> scatter_of(const RecordSums& sums) {
  const Moments moments(sums);
  if (!(moments.statistic(0) > 0) || !std::isfinite(moments.statistic(0))) return std::nullopt;
  const auto sd = [&](const std::function<double(double)>& rising) {
    return std::sqrt(root_of(rising) / sums.unit);
  };
  ScatterBetweenRecords scatter;
  scatter.records = sums.record;
  scatter.p_value = moments.tail(0);
  const double variance = root_of([&](double t) { return moments.expected(t) - moments.statistic(t); });
  scatter.sd = std::sqrt(variance / sums.unit);
  // Records that agree better than their stretches should tell no more of how far they may scatter than others do.
  const double factor = std::max(1.0, moments.expected(0) / moments.statistic(0));
  scatter.low = sd([&](double t) { return moments.tail(t) - tail_share; });
  scatter.high = sd([&](double t) { return moments.tail(t, factor) - (1 - tail_share); });
  const VectorXd shifts = moments.shifts(variance) / std::sqrt(sums.unit);
  scatter.shifts.assign(shifts.begin(), shifts.end());
  scatter.covariance = moments.covariance(variance) / sums.unit;
  return scatter;
}

double told_scatter(const RecordSums& sums, double probability) {
  const Moments moments(sums);
  if (!(moments.statistic(0) > 0) || !std::isfinite(moments.statistic(0))) return 0;
  const double alarm = moments.alarm(probability);
  const auto variance = [&](double factor) {
    return root_of([&](double t) { return moments.expected(t) - factor * moments.statistic(t); });
  };
  return std::sqrt(std::max(0.0, variance(1) - variance(alarm)) / sums.unit);
}

RecordScatter record_scatter(const CaseFit& fit) {
  RecordScatter result;
  result.moves.resize(fit.fit.coefficients.size(), 0);
  if (fit.fit.rank == 0) return result;
  const bool dwells = fit.set->resonance->excited;
  const auto tests = std::count_if(fit.columns.begin(), fit.columns.end(), [](const CaseColumn& c) {
    return c.kind == CaseColumn::Kind::natural_frequency;
  });
  const Eigen::LDLT<MatrixXd> kept(fit.fit.kept);
  for (std::size_t c = 0; c < fit.columns.size(); ++c) {
    if (fit.columns[c].kind != CaseColumn::Kind::natural_frequency) continue;
    const std::optional<RecordSums> sums = sums_of(fit, static_cast<Index>(c));
    std::optional<ScatterBetweenRecords> scatter = sums ? scatter_of(*sums) : std::nullopt;
    if (!scatter) continue;
    scatter->mode = fit.columns[c].index;
    result.told.push_back(told_scatter(*sums, false_alarm / static_cast<double>(tests)));
    if (scatter->sd > 0 && !dwells) {
      const MatrixXd moved =
          scatter->sd * std::sqrt(sums->unit) * (fit.fit.basis * MatrixXd(kept.solve(sums->seen)));
      const Index before = result.moves.cols();
      result.moves.conservativeResize(Eigen::NoChange, before + moved.cols());
      result.moves.rightCols(moved.cols()) = moved;
    }
    result.frequencies.push_back(std::move(*scatter));
  }
  return result;
}

}  // namespace secular
