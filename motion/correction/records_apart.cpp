#include "motion/correction/records_apart.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "estimator/thresholds.hpp"
#include "input/numerical_failure.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;

// The sets with one record alone, or without it; sets that are left without observations go.
std::vector<ObservationSet> part_of_records(const std::vector<ObservationSet>& sets, std::size_t record, bool alone) {
  std::vector<ObservationSet> result;
  for (const ObservationSet& set : sets) {
    ObservationSet part = set;
    part.truncation_change.clear();
    part.truncation_of_moves.clear();
    std::vector<Index> kept;
    part.observations.clear();
    for (std::size_t i = 0; i < set.observations.size(); ++i)
      if ((set.observations[i].record == record) == alone) {
        kept.push_back(static_cast<Index>(i));
        part.observations.push_back(set.observations[i]);
      }
    if (set.truncation.rows() > 0) part.truncation = set.truncation(kept, Eigen::all);
    if (!part.observations.empty()) result.push_back(std::move(part));
  }
  return result;
}

std::optional<Estimate> estimate_of(const std::vector<ObservationSet>& sets, const EstimateTask& task) {
  if (sets.empty()) return std::nullopt;
  try {
    return estimate(sets, task.units, task.options, {.judge_fit = false});
  } catch (const NumericalFailure&) {
    return std::nullopt;
  }
}

/// How far two estimates are apart: F with its degrees of freedom.
struct Distance {
  double f = 0, count = 0, freedom = INFINITY;
};

// docs/inference.md (64). Of coefficients that both have.
Distance distance_of(const Estimate& here, const Estimate& there, std::size_t modes) {
  std::vector<Index> common;
  Distance result;
  double off = 0;  // of natural frequencies, relative
  for (std::size_t p = 0; p < here.parameters.size(); ++p) {
    const EstimatedValue &a = here.parameters[p], &b = there.parameters[p];
    if (!a.value || !b.value || a.fixed) continue;
    if (p < modes) {
      off = std::max(off, std::abs(*a.value / *b.value - 1));
      continue;
    }
    common.push_back(static_cast<Index>(p));
    result.freedom = std::min({result.freedom, a.degrees_of_freedom, b.degrees_of_freedom});
  }
  result.count = static_cast<double>(common.size());
  if (common.empty()) return result;
  Eigen::MatrixXd covariance = here.covariance(common, common) + there.covariance(common, common);
  Eigen::VectorXd between(static_cast<Index>(common.size()));
  for (Index i = 0; i < between.size(); ++i) {
    const auto p = static_cast<std::size_t>(common[static_cast<std::size_t>(i)]);
    between(i) = *here.parameters[p].value - *there.parameters[p].value;
    covariance(i, i) += std::pow(off * *there.parameters[p].value, 2);
  }
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0)) return result;
  const Eigen::MatrixXd correlation = scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  const Eigen::VectorXd z = between.cwiseQuotient(scale);
  result.f = z.dot(correlation.ldlt().solve(z)) / result.count;
  return result;
}

}  // namespace

std::vector<RecordApart> records_apart(const CorrectedEstimate& found, const EstimateTask& task) {
  std::set<std::size_t> decays, all;
  for (const ObservationSet& set : found.corrected)
    for (const Observation& o : set.observations) {
      all.insert(o.record);
      if (!set.resonance->excited) decays.insert(o.record);
    }
  std::vector<RecordApart> result;
  if (all.size() < 2) return result;
  const std::size_t modes = found.corrected.front().model->modes();
  for (const std::size_t record : decays) {
    const auto alone = estimate_of(part_of_records(found.corrected, record, true), task);
    auto without = estimate_of(part_of_records(found.corrected, record, false), task);
    if (!alone || !without) continue;
    const Distance distance = distance_of(*alone, *without, modes);
    if (distance.count == 0 || !(distance.freedom >= 1)) continue;
    const double by_chance =
        f_upper_quantile(estimator_thresholds().contradiction_alarm / static_cast<double>(decays.size()),
                         distance.count, distance.freedom);
    if (!(distance.f > by_chance)) continue;
    result.push_back({record, std::sqrt(1 - by_chance / distance.f), std::move(*without)});
  }
  return result;
}

}  // namespace secular
