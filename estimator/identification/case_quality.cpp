#include "estimator/identification/case_quality.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "estimator/identification/equation_data.hpp"
#include "estimator/model/zero_frequency.hpp"
#include "estimator/regression/signed_rank.hpp"
#include "estimator/thresholds.hpp"
#include "measure/signal/bispectral_phase.hpp"
#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Belsley, Kuh, Welsch: a near dependency has a condition index above 30 and half of two variances or more.
constexpr auto& near_dependency = estimator_thresholds().near_dependency;
constexpr auto& shared_variance = estimator_thresholds().shared_variance;

/// More candidates would make too many selections.
constexpr std::size_t damping_terms = 5;

/// A damping law is excluded where this is the probability that it predicts no worse.
constexpr auto& excluding_probability = estimator_thresholds().excluding_probability;

/// 2^-n is below that from eight conditions on.
constexpr Index fewest_ranks = 8;

std::map<int, std::vector<Index>> rows_by_condition(const CaseFit& fit) {
  std::map<int, std::vector<Index>> rows;
  for (std::size_t r = 0; r < fit.system.condition.size(); ++r)
    rows[fit.system.condition[r]].push_back(static_cast<Index>(r));
  return rows;
}

MatrixXd selected(const MatrixXd& m, const std::vector<Index>& rows) {
  MatrixXd result(static_cast<Index>(rows.size()), m.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Index>(i)) = m.row(rows[i]);
  return result;
}

// design = orthonormal * coordinates: basis = scale V/S, so that basis' scale^-2 basis = S^-2.
MatrixXd coordinates_of_columns(const LinearFit& fit) {
  const MatrixXd turned = (fit.scale.cwiseAbs2().cwiseInverse().asDiagonal() * fit.basis).transpose();
  return (turned * fit.basis).diagonal().cwiseInverse().asDiagonal() * turned;
}

std::vector<Index> dissipative_columns(const CaseFit& fit, std::size_t block_index) {
  const CompiledCase& resonance = *fit.set->resonance;
  const RegressorBlock& block = resonance.blocks[block_index];
  EquationData data(*fit.set, {block_index});
  EquationPoint point{std::vector<double>(resonance.lumps.size(), 0.0),
                      std::vector<double>(fit.set->model->modes(), 1.0)};
  std::vector<double>& natural = point.natural_frequency;
  for (std::size_t k = 0; k < natural.size(); ++k)
    natural[k] = std::max(1.0, fit.set->observations.front().rate[k].imag());
  data.evaluate(natural);
  std::vector<Index> found;
  for (std::size_t c = 0; c < fit.columns.size(); ++c) {
    if (fit.columns[c].kind != CaseColumn::Kind::lump || !fit.fit.identifiable[c]) continue;
    if (std::find(block.lumps.begin(), block.lumps.end(), static_cast<int>(fit.columns[c].index)) ==
        block.lumps.end())
      continue;
    bool real = true;
    double size = 0;
    for (std::size_t i = 0; i < fit.set->observations.size(); ++i) {
      const auto rows = data.rows(i, {fit.columns[c]}, point, natural);
      if (rows.design.rows() != 2) continue;
      real = real && std::abs(rows.design(1, 0)) <= 1e-9 * std::abs(rows.design(0, 0));
      size = std::max(size, std::abs(rows.design(0, 0)));
    }
    if (real && size > 0) found.push_back(static_cast<Index>(c));
  }
  return found;
}

// One condition's part of a regression in orthonormal coordinates.
struct ConditionPart {
  MatrixXd gram;        // orthonormal' * orthonormal
  VectorXd along;       // orthonormal' * residual of the whole fit
  double residual = 0;  // squared
  double rows = 0;
};

// `whole`: coordinates of the least-squares fit.
std::vector<ConditionPart> condition_parts(const CaseFit& fit, const VectorXd& whole,
                                           const std::map<int, std::vector<Index>>& conditions) {
  const VectorXd left = fit.system.response - fit.fit.orthonormal * whole;
  std::vector<ConditionPart> parts;
  for (const auto& [condition, rows] : conditions) {
    const MatrixXd basis = selected(fit.fit.orthonormal, rows);
    const VectorXd residual = selected(left, rows);
    ConditionPart part{MatrixXd::Zero(basis.cols(), basis.cols()), basis.transpose() * residual,
                       residual.squaredNorm(), static_cast<double>(rows.size())};
    part.gram.selfadjointView<Eigen::Lower>().rankUpdate(basis.transpose());
    part.gram = MatrixXd(part.gram.selfadjointView<Eigen::Lower>());
    parts.push_back(std::move(part));
  }
  return parts;
}

// Mean square of what every condition shows of its own prediction by the others where the coefficients are held to
// the columns of an orthonormal Q. `whole`: those of the whole fit. With P = Q'GQ and the residual e of the
// smaller fit, s = Q'X'e, the prediction without the condition leaves e + XQ (I - P)^-1 s.
VectorXd held_out_scores(const std::vector<ConditionPart>& parts, const VectorXd& whole, const MatrixXd& q) {
  const VectorXd dropped = whole - q * (q.transpose() * whole);
  VectorXd scores(static_cast<Index>(parts.size()));
  for (std::size_t g = 0; g < parts.size(); ++g) {
    const ConditionPart& part = parts[g];
    const VectorXd seen = part.gram * dropped;
    const double left = part.residual + 2 * dropped.dot(part.along) + dropped.dot(seen);
    const VectorXd along = q.transpose() * (part.along + seen);
    const MatrixXd own = q.transpose() * part.gram * q;
    const VectorXd change = MatrixXd(MatrixXd::Identity(q.cols(), q.cols()) - own).ldlt().solve(along);
    scores(static_cast<Index>(g)) = (left + 2 * change.dot(along) + change.dot(own * change)) / part.rows;
  }
  return scores;
}

// Probability that differences of scores like these, or larger, come from a law that predicts as well.
double probability_no_worse(const VectorXd& difference) {
  if (difference.size() >= fewest_ranks)
    return signed_rank_p_value({difference.data(), static_cast<std::size_t>(difference.size())});
  const auto n = static_cast<double>(difference.size());
  const double mean = difference.mean(), sd = std::sqrt((difference.array() - mean).square().sum() / (n - 1) / n);
  if (!(sd > 0)) return mean > 0 ? 0 : 1;
  const double two_sided = two_sided_p_value(mean / sd, n - 1);
  return mean > 0 ? two_sided / 2 : 1 - two_sided / 2;
}

}  // namespace

std::string column_name(const CaseFit& fit, std::size_t column) {
  const CaseColumn& c = fit.columns[column];
  switch (c.kind) {
    case CaseColumn::Kind::lump:
      return std::string(fit.set->resonance->lumps[c.index].name);
    case CaseColumn::Kind::natural_frequency:
      return std::string(fit.set->model->symbols[c.index].name);
    case CaseColumn::Kind::sensor_offset:
      return "offset of " + std::string(fit.set->model->coordinates[c.index]);
  }
  return {};
}

std::vector<BlockQuality> block_quality(const CaseFit& fit) {
  std::vector<BlockQuality> result;
  for (const std::size_t b : fit.blocks) {
    const RegressorBlock& block = fit.set->resonance->blocks[b];
    BlockQuality quality;
    quality.name = std::string(block.name);
    quality.resonance = std::string(fit.set->resonance->name);
    std::set<int> conditions;
    for (std::size_t r = 0; r < fit.system.block.size(); ++r)
      if (fit.system.block[r] == b) {
        ++quality.equations;
        conditions.insert(fit.system.condition[r]);
      }
    quality.conditions = conditions.size();
    const auto residual = fit.block_residual.find(b);
    quality.normalised_residual = residual == fit.block_residual.end() ? 0 : residual->second;
    quality.condition_index = fit.fit.rank > 0 ? fit.fit.condition_indices.head(fit.fit.rank).maxCoeff() : 0;
    quality.clustered = fit.fit.covariance_kind == CovarianceKind::clustered;
    for (std::size_t c = 0; c < fit.columns.size(); ++c) {
      const CaseColumn& column = fit.columns[c];
      const bool here = column.kind == CaseColumn::Kind::lump
                            ? std::find(block.lumps.begin(), block.lumps.end(), static_cast<int>(column.index)) !=
                                  block.lumps.end()
                        : column.kind == CaseColumn::Kind::natural_frequency
                            ? block.kind == BlockKind::modulation && static_cast<int>(column.index) == block.mode
                            : is_zero_frequency(block) && static_cast<int>(column.index) == block.mode;
      if (here) quality.variance_inflation[column_name(fit, c)] = fit.fit.variance_inflation(static_cast<Index>(c));
    }
    result.push_back(std::move(quality));
  }
  return result;
}

std::vector<ConditionQuality> condition_quality(const CaseFit& fit) {
  const ObservationSet& set = *fit.set;
  const ModeFrequencies modes = mode_frequencies(*set.model, *set.resonance);
  std::vector<std::size_t> pair;
  for (std::size_t k = 0; k < set.model->modes(); ++k)
    if (modes.oscillates[k]) pair.push_back(k);
  const MatrixXd coordinates = coordinates_of_columns(fit.fit);
  const auto rows = rows_by_condition(fit);
  std::vector<ConditionQuality> result;
  for (std::size_t g = 0; g < fit.fit.cluster_labels.size(); ++g) {
    const int condition = fit.fit.cluster_labels[g];
    ConditionQuality quality;
    quality.resonance = std::string(set.resonance->name);
    double square = 0;
    for (const Index r : rows.at(condition)) {
      quality.leverage += fit.fit.leverage(r);
      square += fit.fit.residual(r) * fit.fit.residual(r);
    }
    quality.residual = std::sqrt(square / static_cast<double>(rows.at(condition).size()));
    const VectorXd change = coordinates * fit.fit.influence.row(static_cast<Index>(g)).transpose();
    const double variance = fit.fit.residual_sd * fit.fit.residual_sd * static_cast<double>(fit.fit.rank);
    quality.influence = variance > 0 ? change.squaredNorm() / variance : 0;
    quality.amplitude.assign(set.model->modes(), 0.0);
    std::vector<const Observation*> members;
    for (const Observation& o : set.observations)
      if (o.condition == condition) members.push_back(&o);
    quality.ensembles = members.size();
    if (members.empty()) continue;
    quality.record = members.front()->record;
    for (const Observation* o : members)
      for (std::size_t k = 0; k < quality.amplitude.size(); ++k)
        quality.amplitude[k] += 2 * std::abs(o->amplitude[k]) / static_cast<double>(members.size());
    if (set.resonance->excited && modes.free.size() == 1 && pair.size() == 2 && members.size() >= 2) {
      const auto count = static_cast<Index>(members.size());
      Eigen::VectorXcd force(count), first(count), second(count);
      for (Index i = 0; i < count; ++i) {
        const Observation& o = *members[static_cast<std::size_t>(i)];
        force(i) = o.forcing[0];
        first(i) = o.amplitude[pair[0]];
        second(i) = o.amplitude[pair[1]];
      }
      const BispectralPhase phase = bispectral_phase(force, first, second, ensemble_layout(count, 1, 0));
      quality.gamma = phase.gamma;
      quality.gamma_sd = phase.gamma_sd;
    }
    result.push_back(std::move(quality));
  }
  return result;
}

std::vector<OutlyingEnsemble> outlying_ensembles(const CaseFit& fit) {
  std::vector<OutlyingEnsemble> result;
  for (std::size_t i = 0; i < fit.weight.size(); ++i)
    if (fit.weight[i] < 1)
      result.push_back({std::string(fit.set->resonance->name), fit.set->observations[i].record,
                        fit.set->observations[i].centre_s, fit.distance[i], fit.weight[i]});
  return result;
}

std::vector<std::optional<PartialF>> partial_f(const CaseFit& fit) {
  std::vector<std::optional<PartialF>> result(fit.columns.size());
  std::vector<std::size_t> tested;
  for (std::size_t c = 0; c < fit.columns.size(); ++c) {
    const auto at = static_cast<Index>(c);
    const double variance = fit.fit.covariance(at, at);
    if (fit.columns[c].kind != CaseColumn::Kind::lump || !fit.fit.identifiable[c] || !(variance > 0)) continue;
    PartialF test;
    const double t = fit.fit.coefficients(at) / std::sqrt(variance);
    test.f = t * t;
    test.degrees_of_freedom = fit.fit.degrees_of_freedom;
    test.p_value = two_sided_p_value(t, test.degrees_of_freedom);
    result[c] = test;
    tested.push_back(c);
  }
  // Holm: the smallest p value times the number of tests, the next times one less, never falling.
  std::sort(tested.begin(), tested.end(),
            [&](std::size_t a, std::size_t b) { return result[a]->p_value < result[b]->p_value; });
  double running = 0;
  for (std::size_t i = 0; i < tested.size(); ++i) {
    PartialF& test = *result[tested[i]];
    running = std::max(running, std::min(1.0, static_cast<double>(tested.size() - i) * test.p_value));
    test.p_value_holm = running;
    test.tests = tested.size();
  }
  return result;
}

std::vector<std::vector<std::string>> nearly_entangled(const CaseFit& fit) {
  std::vector<std::set<std::string>> sets(fit.columns.size());
  for (Index i = 0; i < fit.fit.rank; ++i) {
    if (fit.fit.condition_indices(i) < near_dependency) continue;
    std::vector<std::size_t> together;
    for (std::size_t c = 0; c < fit.columns.size(); ++c)
      if (fit.fit.identifiable[c] && fit.fit.variance_proportions(i, static_cast<Index>(c)) > shared_variance)
        together.push_back(c);
    for (const std::size_t a : together)
      for (const std::size_t b : together)
        if (a != b) sets[a].insert(column_name(fit, b));
  }
  std::vector<std::vector<std::string>> result;
  for (const auto& names : sets) result.emplace_back(names.begin(), names.end());
  return result;
}

std::vector<DampingComparison> compare_damping(const CaseFit& fit) {
  std::vector<DampingComparison> result;
  if (fit.fit.rank == 0 || fit.set->observations.empty()) return result;
  const auto conditions = rows_by_condition(fit);
  if (conditions.size() < 4) return result;
  const MatrixXd coordinates = coordinates_of_columns(fit.fit);
  const VectorXd whole = fit.fit.orthonormal.transpose() * fit.system.response;
  const std::vector<ConditionPart> parts = condition_parts(fit, whole, conditions);
  for (const std::size_t b : fit.blocks) {
    const RegressorBlock& block = fit.set->resonance->blocks[b];
    if (block.kind != BlockKind::modulation) continue;
    const std::vector<Index> terms = dissipative_columns(fit, b);
    if (terms.size() < 2 || terms.size() > damping_terms) continue;
    DampingComparison comparison;
    comparison.resonance = std::string(fit.set->resonance->name);
    comparison.mode = std::string(fit.set->model->coordinates[static_cast<std::size_t>(block.mode)]);
    struct Candidate {
      unsigned selection;
      VectorXd scores;
    };
    std::vector<Candidate> candidates;
    for (unsigned selection = 1; selection < 1U << terms.size(); ++selection) {
      std::vector<Index> columns;
      for (Index c = 0; c < coordinates.cols(); ++c) {
        const auto term = std::find(terms.begin(), terms.end(), c);
        if (term == terms.end() || (selection >> (term - terms.begin()) & 1U)) columns.push_back(c);
      }
      MatrixXd kept(coordinates.rows(), static_cast<Index>(columns.size()));
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const VectorXd column = coordinates.col(columns[i]);
        kept.col(static_cast<Index>(i)) = column / std::max(column.norm(), 1e-300);
      }
      Eigen::ColPivHouseholderQR<MatrixXd> qr(kept);
      qr.setThreshold(1e-10);
      const MatrixXd q = MatrixXd(qr.householderQ()).leftCols(qr.rank());
      candidates.push_back({selection, held_out_scores(parts, whole, q)});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.scores.mean() < y.scores.mean(); });
    const auto terms_of = [](const Candidate& c) { return std::popcount(c.selection); };
    for (std::size_t i = 1; i < candidates.size(); ++i)
      if (terms_of(candidates[i]) < terms_of(candidates[comparison.chosen]) &&
          probability_no_worse(candidates[i].scores - candidates.front().scores) >= excluding_probability)
        comparison.chosen = i;
    const Candidate& chosen = candidates[comparison.chosen];
    comparison.decided = true;
    const auto n = static_cast<double>(conditions.size());
    for (const Candidate& candidate : candidates) {
      DampingLaw law;
      for (std::size_t t = 0; t < terms.size(); ++t)
        if (candidate.selection >> t & 1U)
          law.terms.push_back(column_name(fit, static_cast<std::size_t>(terms[t])));
      law.score = candidate.scores.mean();
      const VectorXd difference = candidate.scores - chosen.scores;
      law.worse_by = difference.mean();
      law.sd = std::sqrt((difference.array() - law.worse_by).square().sum() / (n - 1) / n);
      if (&candidate != &chosen) law.p_value = probability_no_worse(difference);
      law.excluded = law.p_value < excluding_probability;
      if ((candidate.selection & chosen.selection) != chosen.selection && !law.excluded) comparison.decided = false;
      comparison.laws.push_back(std::move(law));
    }
    result.push_back(std::move(comparison));
  }
  return result;
}

MatrixXd bootstrap_coefficients(const CaseFit& fit, int resamples, std::uint64_t seed) {
  std::vector<MatrixXd> gram;
  std::vector<VectorXd> right;
  for (const auto& [condition, rows] : rows_by_condition(fit)) {
    const MatrixXd part = selected(fit.fit.orthonormal, rows);
    gram.emplace_back(part.transpose() * part);
    right.emplace_back(part.transpose() * selected(fit.system.response, rows));
  }
  std::mt19937_64 random(seed);
  const auto n = static_cast<std::uint64_t>(gram.size());
  MatrixXd result(fit.fit.coefficients.size(), resamples);
  constexpr int draws = 20;
  for (int s = 0; s < resamples; ++s) {
    result.col(s) = fit.fit.coefficients;
    for (int attempt = 0; attempt < draws; ++attempt) {
      MatrixXd sum = MatrixXd::Zero(fit.fit.rank, fit.fit.rank);
      VectorXd total = VectorXd::Zero(fit.fit.rank);
      for (std::uint64_t i = 0; i < n; ++i) {
        // The modulus is biased by less than n/2^64.
        const std::size_t pick = random() % n;
        sum += gram[pick];
        total += right[pick];
      }
      const Eigen::LDLT<MatrixXd> solver(sum);
      if (solver.vectorD().minCoeff() < 1e-6) continue;
      result.col(s) = fit.reference + fit.fit.basis * VectorXd(solver.solve(total)) - fit.fit.bias;
      break;
    }
  }
  return result;
}

}  // namespace secular
