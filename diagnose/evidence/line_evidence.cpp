#include "diagnose/evidence/line_evidence.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "diagnose/evidence/likeliest_delay.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A row whose variance, given the rows before it, is below this share of its own is determined by them.
constexpr double determined = 1e-9;

/// Points of a turn for each line, at least: the fifth power of the highest is not taken for a line then.
constexpr Index points_of_a_line = 6;

/// Share of the inertia that a first look at unknown numbers allows.
constexpr auto& first_look = diagnose_thresholds().first_look;

/// Where no motion was found when the errors were taken, rows count this many standard deviations. Where one was
/// found then and is lost, no fit may go.
constexpr auto& no_motion = diagnose_thresholds().no_motion;

std::string line_name(const Condition& c, Index line, const CompiledModel& model) {
  const LinePhase& n = c.torus->phase(line);
  if (line == 0) return "mean";
  if (c.torus->dimensions() == 1 && c.fundamental > 0) {
    const auto divisor = static_cast<int>(c.fundamental);
    const std::string excitation(model.excitation_frequencies.empty() ? "Omega" : model.excitation_frequencies[0]);
    const int common = std::gcd(n[0], divisor);
    const int top = n[0] / common, bottom = divisor / common;
    return (top == 1 ? "" : std::to_string(top) + " ") + excitation +
           (bottom == 1 ? "" : "/" + std::to_string(bottom));
  }
  std::string name;
  for (std::size_t j = 0; j < 2; ++j) {
    if (n[j] == 0) continue;
    std::string base = "line " + std::to_string(j + 1);
    for (const MasterLine& m : c.masters)
      if (c.torus->phase(m.line) == (j == 0 ? LinePhase{1, 0} : LinePhase{0, 1}))
        base = std::string(model.symbols[m.mode].name);
    name += (n[j] < 0       ? "-"
             : name.empty() ? ""
                            : "+") +
            (std::abs(n[j]) == 1 ? "" : std::to_string(std::abs(n[j])) + " ") + base;
  }
  return name;
}

}  // namespace

LineEvidence::LineEvidence(ConditionModel model, std::vector<Condition> conditions, const VectorXd& unknowns,
                           unsigned threads)
    : model_(std::move(model)), conditions_(std::move(conditions)), threads_(threads) {
  const CompiledModel& compiled = model_.balance().model();
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    const Condition& c = conditions_[i];
    Whitening w;
    whiten(c, unknowns, first_look, w);
    const std::vector<RowMeaning> meanings = model_.meanings(c);
    double amplitude = 0;
    for (const MasterLine& m : c.masters)
      amplitude = std::max(amplitude, std::abs(w.motion.displacement(static_cast<Index>(m.mode), m.line)));
    for (const Index row : w.kept) {
      const RowMeaning& meaning = meanings[static_cast<std::size_t>(row)];
      RowLabel label;
      label.record = c.record;
      label.fold = c.fold;
      label.harmonic = line_name(c, meaning.line, compiled);
      label.time_s = c.time_s;
      label.level = c.excitation_level();
      label.frequency = c.excitation_frequency();
      label.amplitude = amplitude;
      label.balance = meaning.kind == RowMeaning::Kind::balance;
      if (label.balance) {
        label.mode = meaning.mode;
        label.place = std::string(compiled.coordinates[meaning.mode]);
        label.component = meaning.imaginary ? EffectComponent::dissipative : EffectComponent::conservative;
      } else {
        const SensorModel& sensors = model_.sensors();
        label.place = meaning.kind == RowMeaning::Kind::response ? sensors.response_names[meaning.channel]
                                                                 : sensors.excitation_names[meaning.channel];
      }
      labels_.push_back(std::move(label));
    }
    whitening_.push_back(std::move(w));
  }
}

ConditionRows LineEvidence::whiten(const Condition& c, const VectorXd& unknowns, double coarse,
                                   Whitening& w) const {
  w.motion = model_.rows(c, unknowns, w.motion.converged() ? &w.motion : nullptr).motion;
  // From a motion that is lost none is looked for here.
  ConditionRows here = model_.rows(c, unknowns, w.motion.converged() ? &w.motion : nullptr);
  MatrixXd covariance = model_.covariance(c, unknowns, here);
  for (std::size_t m = 0; m < c.masters.size(); ++m) {
    const double inertia = std::norm(c.line_rate(c.masters[m].line));
    covariance.diagonal().segment<2>(static_cast<Index>(2 * m)).array() += coarse * inertia * coarse * inertia;
  }
  const bool first = w.kept.empty();
  std::vector<Index> rows = w.kept;
  if (first)
    for (Index i = 0; i < covariance.rows(); ++i) rows.push_back(i);
  // Numbers so far off that no motion is found: errors stay what they were; without any, every row counts alike
  // until the numbers are nearer.
  w.is_of_before = !covariance.allFinite() && !first;
  if (w.is_of_before) return here;
  if (!covariance.allFinite()) {
    covariance.setIdentity();
  }
  // A row of a channel has at least its line's error of its own, unless the amplitudes were taken from it.
  const std::vector<RowMeaning> meanings = model_.meanings(c);
  const auto own_variance = [&](Index row) {
    const RowMeaning& meaning = meanings[static_cast<std::size_t>(row)];
    if (meaning.kind != RowMeaning::Kind::response) return 0.0;
    const auto column = std::find(c.lines.begin(), c.lines.end(), meaning.line) - c.lines.begin();
    const double sd = c.response_sd(static_cast<Index>(meaning.channel), column);
    return sd * sd;
  };
  // Cholesky in the rows' own order.
  std::vector<Index> order;
  MatrixXd root = MatrixXd::Zero(static_cast<Index>(rows.size()), static_cast<Index>(rows.size()));
  for (const Index row : rows) {
    const auto n = static_cast<Index>(order.size());
    VectorXd line(n);
    for (Index j = 0; j < n; ++j) {
      double sum = covariance(row, order[static_cast<std::size_t>(j)]);
      for (Index k = 0; k < j; ++k) sum -= line(k) * root(j, k);
      line(j) = sum / root(j, j);
    }
    const double least = determined * std::max(covariance(row, row), own_variance(row));
    double left = covariance(row, row) - line.squaredNorm();
    if (!(left > least)) {
      if (first) continue;
      left = least > 0 ? least : 1;
    }
    root.row(n).head(n) = line.transpose();
    root(n, n) = std::sqrt(left);
    order.push_back(row);
  }
  w.kept = order;
  const auto n = static_cast<Index>(order.size());
  w.inverse_root =
      root.topLeftCorner(n, n).triangularView<Eigen::Lower>().solve(MatrixXd(MatrixXd::Identity(n, n)));
  return here;
}

bool LineEvidence::took_more_lines(std::size_t condition, const VectorXd& unknowns, const ConditionRows& few,
                                   Whitening& w) {
  Condition& c = conditions_[condition];
  const Index highest = c.torus->lines() - 1;
  if (c.torus->dimensions() != 1 || 2 * highest * points_of_a_line > c.torus->points() || !w.motion.converged())
    return false;
  Condition finer = c;
  finer.torus = std::make_shared<const Torus>(1, static_cast<int>(2 * highest), c.torus->points());
  Motion start = w.motion;
  start.displacement.conservativeResizeLike(MatrixXcd::Zero(start.displacement.rows(), finer.torus->lines()));
  const ConditionRows more = model_.rows(finer, unknowns, &start);
  const VectorXd moved = w.inverse_root * (more.values - few.values)(w.kept);
  if (!moved.allFinite() || !(moved.cwiseAbs().maxCoeff() > negligible_step)) return false;
  c = std::move(finer);
  w.motion = more.motion;
  return true;
}

void LineEvidence::freeze(const VectorXd& unknowns, double coarse) {
  in_parallel(conditions_.size(), threads_, [&](std::size_t i) {
    Whitening& w = whitening_[i];
    while (true) {
      const ConditionRows few = whiten(conditions_[i], unknowns, coarse, w);
      if (coarse > 0 || !took_more_lines(i, unknowns, few, w)) break;
    }
  });
}

void LineEvidence::approach(const VectorXd& unknowns) {
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    Motion& known = whitening_[i].motion;
    Motion motion = model_.rows(conditions_[i], unknowns, known.converged() ? &known : nullptr).motion;
    if (motion.converged()) known = std::move(motion);
  }
}

// Of unit variance; not finite where there is no motion.
VectorXd LineEvidence::whitened(const ConditionRows& raw, const Whitening& w) {
  VectorXd kept(static_cast<Index>(w.kept.size()));
  for (Index r = 0; r < kept.size(); ++r) kept(r) = raw.values(w.kept[static_cast<std::size_t>(r)]);
  if (kept.allFinite()) kept = w.inverse_root * kept;
  return kept;
}

void LineEvidence::evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const {
  if (!has_frequencies(unknowns, model_.balance().model().modes())) {
    rows.setConstant(std::numeric_limits<double>::infinity());
    return;
  }
  Index first = 0;
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    const Whitening& w = whitening_[i];
    const auto count = static_cast<Index>(w.kept.size());
    const VectorXd own =
        whitened(model_.rows(conditions_[i], unknowns, w.motion.converged() ? &w.motion : nullptr), w);
    if (own.allFinite())
      rows.segment(first, count) = own;
    else
      rows.segment(first, count)
          .setConstant(w.motion.converged() ? std::numeric_limits<double>::infinity() : no_motion);
    first += count;
  }
}

MatrixXd LineEvidence::slopes(const VectorXd& unknowns, const std::vector<std::size_t>& which,
                              const VectorXd& scale, unsigned threads) const {
  MatrixXd columns = MatrixXd::Zero(size(), static_cast<Index>(which.size()));
  std::vector<Index> first(conditions_.size(), 0);
  for (std::size_t i = 1; i < conditions_.size(); ++i)
    first[i] = first[i - 1] + static_cast<Index>(whitening_[i - 1].kept.size());
  in_parallel(conditions_.size(), threads, [&](std::size_t i) {
    const Whitening& w = whitening_[i];
    const Condition& c = conditions_[i];
    const ConditionRows raw = model_.rows(c, unknowns, w.motion.converged() ? &w.motion : nullptr);
    if (!raw.values.allFinite()) return;
    const MatrixXd slopes = model_.slopes(c, unknowns, raw.motion.displacement, which, scale);
    if (!slopes.allFinite()) return;
    MatrixXd kept(static_cast<Index>(w.kept.size()), slopes.cols());
    for (Index r = 0; r < kept.rows(); ++r) kept.row(r) = slopes.row(w.kept[static_cast<std::size_t>(r)]);
    columns.middleRows(first[i], kept.rows()) = w.inverse_root.triangularView<Eigen::Lower>() * kept;
  });
  return columns;
}

void LineEvidence::set_frequency_offsets(const std::map<std::size_t, VectorXd>& offsets) {
  for (Condition& condition : conditions_) {
    const auto own = offsets.find(condition.record);
    condition.frequency_offset = own == offsets.end() ? VectorXd() : own->second;
  }
}

void LineEvidence::put_in_step(const VectorXd& unknowns, double coarse, Lookout lookout,
                               const std::map<std::size_t, double>& periods,
                               std::map<std::size_t, double>& late_s) {
  std::map<std::size_t, std::vector<std::size_t>> of_record;
  for (std::size_t i = 0; i < conditions_.size(); ++i)
    if (periods.contains(conditions_[i].record)) of_record[conditions_[i].record].push_back(i);
  const std::vector<std::pair<std::size_t, std::vector<std::size_t>>> late(of_record.begin(), of_record.end());
  std::vector<double> found(late.size());
  in_parallel(late.size(), threads_, [&](std::size_t i) {
    const auto& [record, conditions] = late[i];
    const std::function<double(double)> deviance = [&](double seconds) {
      return deviance_if_late(conditions, unknowns, coarse, seconds);
    };
    const double here = conditions_[conditions.front()].late_s, period = periods.at(record);
    std::optional<double> close;
    if (lookout == Lookout::close_by) close = likeliest_delay_near(deviance, here, period);
    found[i] = close ? *close : likeliest_delay(deviance, here, period);
  });
  for (std::size_t i = 0; i < late.size(); ++i) {
    for (const std::size_t c : late[i].second) conditions_[c].count_as_late(found[i]);
    late_s[late[i].first] = found[i];
  }
}

// -2 log likelihood of conditions of one record if its responses are so late, but for a constant. Errors are those
// of that lateness: their axes turn with it, so that errors of one place see no other.
double LineEvidence::deviance_if_late(const std::vector<std::size_t>& conditions, const VectorXd& unknowns,
                                      double coarse, double seconds) const {
  double deviance = 0;
  for (const std::size_t i : conditions) {
    Condition c = conditions_[i];
    c.count_as_late(seconds);
    Whitening w = whitening_[i];
    const ConditionRows rows = whiten(c, unknowns, coarse, w);
    if (w.is_of_before) return std::numeric_limits<double>::infinity();
    deviance += whitened(rows, w).squaredNorm() - 2 * w.inverse_root.diagonal().array().log().sum();
  }
  return std::isfinite(deviance) ? deviance : std::numeric_limits<double>::infinity();
}

VectorXd LineEvidence::unmixed(const VectorXd& rows) const {
  VectorXd all(rows.size());
  Index first = 0;
  for (const Whitening& w : whitening_) {
    const auto count = static_cast<Index>(w.kept.size());
    all.segment(first, count) =
        w.inverse_root.triangularView<Eigen::Lower>().solve(rows.segment(first, count).eval());
    first += count;
  }
  return all;
}

}  // namespace secular
