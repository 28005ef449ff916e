#include "estimator/identification/instrument_motions.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <set>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/row_noise.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// From the record's own natural frequency to the common one: shifts of half of the resonance's width are followed
/// in parts of a sixteenth, in each of which the response is nearly straight. Newton's method squares what is left.
constexpr int steps_to_common = 8;
constexpr int newton_steps = 3;

/// What is left of a step before Newton's method's last one; where that is more, or an amplitude changes by more
/// than a factor of two, there is no motion nearby.
constexpr double followed = 1e-3;
constexpr double nearby = 2;

/// Directions that the equations do not notice: the phase that modes of a combination resonance share.
constexpr double unnoticed_direction = 1e-9;

/// Of intervals that have to be bounded, on both sides.
constexpr double outside_interval = 2 * EstimatorThresholds{}.interval_tail;

using ByMode = std::vector<Complex>;

std::vector<std::size_t> modulations_of(const CompiledCase& resonance, const std::vector<std::size_t>& blocks) {
  std::vector<std::size_t> result;
  for (const std::size_t b : blocks)
    if (resonance.blocks[b].kind == BlockKind::modulation) result.push_back(b);
  return result;
}

// What the balances of an observation leave over the amplitude, by mode that has them: a rate of growth and, in
// quadrature, a natural frequency; and the variance of that by noise alone, without what records differ by.
struct Left {
  ByMode rate;
  std::vector<double> noise;
};

Left left_of(const ObservationSet& set, std::size_t observation, const EquationData::Rows& rows, double repeats) {
  const Observation& o = set.observations[observation];
  Left result{ByMode(o.amplitude.size()), std::vector<double>(o.amplitude.size(), 0.0)};
  const VectorXd sd = row_noise_sd(rows);
  for (Index r = 0; r < rows.response.size(); r += 2) {
    const auto mode = static_cast<std::size_t>(set.resonance->blocks[rows.block[static_cast<std::size_t>(r)]].mode);
    const double size = std::abs(o.amplitude[mode]);
    result.rate[mode] = Complex(rows.response(r), rows.response(r + 1)) / size;
    const double own = set.frequency_scatter[mode] * set.frequency_scatter[mode] * repeats;
    result.noise[mode] = std::max(0.0, std::pow(sd(r + 1) / size, 2) - own);
  }
  return result;
}

// docs/inference.md (54), by record and mode: how much of the variance of what its balance leaves is its own
// natural frequency's.
std::map<std::size_t, std::vector<double>> shares_of(const ObservationSet& set, const std::vector<Left>& left,
                                                     TakenOff taken_off) {
  std::map<std::size_t, std::vector<double>> shares;
  std::map<std::size_t, double> count;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::size_t record = set.observations[i].record;
    shares[record].resize(left[i].noise.size(), 0.0);
    count[record] += 1;
    for (std::size_t k = 0; k < left[i].noise.size(); ++k) shares[record][k] += left[i].noise[k];
  }
  for (auto& [record, values] : shares)
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double own = std::pow(set.frequency_scatter[k], 2), n = count[record];
      values[k] = taken_off == TakenOff::all ? 1 : own > 0 ? own / (own + values[k] / (n * n)) : 0;
    }
  return shares;
}

std::vector<Left> all_left(const ObservationSet& set, const std::vector<std::size_t>& modulations,
                           const EquationPoint& point) {
  EquationData data(set, modulations);
  data.evaluate(point.natural_frequency);
  std::map<std::size_t, double> repeats;
  for (const Observation& o : set.observations) repeats[o.record] += 1;
  std::vector<Left> left;
  for (std::size_t i = 0; i < set.observations.size(); ++i)
    left.push_back(
        left_of(set, i, data.rows(i, {}, point, point.natural_frequency), repeats[set.observations[i].record]));
  return left;
}

bool is_nearby(const Observation& from, const Observation& to) {
  for (std::size_t k = 0; k < from.amplitude.size(); ++k) {
    const double before = std::abs(from.amplitude[k]), now = std::abs(to.amplitude[k]);
    if (!(now <= nearby * before && before <= nearby * now)) return false;
  }
  return true;
}

// One step of Newton's method at all observations, each in units of its noise, so that what the equations do not
// notice stays. By observation: what was left before it, over the amplitudes.
std::vector<double> newton_step(ObservationSet& set, const std::vector<std::size_t>& blocks,
                                const EquationPoint& point) {
  EquationData data(set, blocks);
  data.evaluate(point.natural_frequency);
  std::vector<double> left(set.observations.size(), 0.0);
  const std::vector<Index> motion = data.motion_quantities();
  for (std::size_t i = 0; i < set.observations.size(); ++i) {
    const EquationData::Rows rows = data.rows(i, {}, point, point.natural_frequency);
    if (rows.response.size() == 0) continue;
    for (Index r = 0; r < rows.response.size(); ++r) {
      const auto& block = set.resonance->blocks[rows.block[static_cast<std::size_t>(r)]];
      const double size = std::abs(set.observations[i].amplitude[static_cast<std::size_t>(block.mode)]);
      left[i] = std::max(left[i], std::abs(rows.response(r)) / size);
    }
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(unnoticed_direction);
    solver.compute(MatrixXd(rows.variants(Eigen::all, motion)));
    VectorXd deviations = VectorXd::Zero(data.quantities());
    deviations(motion) = VectorXd(solver.solve(rows.response));
    if (deviations.allFinite()) data.move(set.observations[i], deviations);
  }
  return left;
}

}  // namespace

std::vector<InstrumentMotion> instrument_motions(const ObservationSet& set, const std::vector<std::size_t>& blocks,
                                                 const EquationPoint& point, TakenOff taken_off) {
  const std::vector<std::size_t> modulations = modulations_of(*set.resonance, blocks);
  const std::vector<Left> left = all_left(set, modulations, point);
  const std::map<std::size_t, std::vector<double>> shares = shares_of(set, left, taken_off);
  // With rates less what the equations leave at the measured motion these hold there.
  const auto turn = [&](Observation& o, std::size_t i, double taken, double sign) {
    for (std::size_t k = 0; k < left[i].rate.size(); ++k)
      o.rate[k] -= sign * left[i].rate[k] * (1 - taken * shares.at(o.record)[k]);
  };
  ObservationSet moving = set;
  std::set<std::size_t> ended;  // records
  for (int step = 1; step <= steps_to_common; ++step) {
    const double taken = static_cast<double>(step) / steps_to_common;
    const std::vector<Observation> before = moving.observations;
    for (std::size_t i = 0; i < left.size(); ++i) turn(moving.observations[i], i, taken, 1);
    std::vector<double> rest;
    for (int iteration = 0; iteration < newton_steps; ++iteration) rest = newton_step(moving, modulations, point);
    for (std::size_t i = 0; i < left.size(); ++i) {
      Observation& o = moving.observations[i];
      turn(o, i, taken, -1);
      double size = 0;
      for (const Complex rate : left[i].rate) size = std::max(size, std::abs(rate) / steps_to_common);
      if (!(rest[i] <= followed * size) || !is_nearby(before[i], o)) ended.insert(o.record);
    }
    for (std::size_t i = 0; i < left.size(); ++i)  // stay where they are
      if (ended.contains(before[i].record)) moving.observations[i] = before[i];
  }
  std::vector<InstrumentMotion> result;
  for (const Observation& o : moving.observations) {
    const std::vector<double>& share = shares.at(o.record);
    const double noise_left = 1 - *std::max_element(share.begin(), share.end());
    result.push_back({o.amplitude, o.rate, noise_left, !ended.contains(o.record)});
  }
  return result;
}

bool instruments_tell(const CaseFit& fit) {
  std::map<std::size_t, bool> found;  // by record
  for (const Observation& o : fit.set->observations) found[o.record] = o.instrument && o.instrument->found;
  const auto all = static_cast<double>(found.size());
  const auto left = static_cast<double>(
      std::count_if(found.begin(), found.end(), [](const auto& record) { return record.second; }));
  const double freedom = left - static_cast<double>(fit.fit.rank), lost = 1 - left / all;
  if (!(freedom >= 1) || lost >= 0.5) return false;
  const double density =
      lost > 0 ? std::exp(-chi_squared_upper_quantile(2 * lost, 1) / 2) / std::sqrt(2 * std::numbers::pi) : 0;
  return std::sqrt(left) * density / (1 - lost) < 1 &&
         fit.instrument_relevance > f_upper_quantile(outside_interval, 1, freedom);
}

}  // namespace secular
