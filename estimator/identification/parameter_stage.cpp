// From lumps of all cases to parameters, and back where the truncation's correction depends on these.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/estimation.hpp"
#include "estimator/identification/silent_parameters.hpp"
#include "estimator/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Standard deviation, relative, of a natural frequency about the observed one where nothing else tells it.
constexpr auto& frequency_prior_sd = estimator_thresholds().frequency_prior_sd;

/// Standard deviation, relative, of a lump that is given: far below what measurements tell, and far enough above
/// rounding.
constexpr double given_width = 1e-5;

/// Rounding: combinations of columns that are orthogonal to everything lost are as good as these, and so are moves
/// of parameters that depend on one another (where there are more of them than dimensions beside the null space).
constexpr double lost_tolerance = 1e-8;

// Combinations of the columns `lost`, one a row, that the fit knows although it knows none of them alone:
// orthogonal, in scaled coefficients, to every direction that is lost.
MatrixXd known_combinations(const LinearFit& fit, const std::vector<Index>& lost) {
  if (lost.empty() || fit.lost.cols() == 0) return {};
  const MatrixXd directions = fit.lost(lost, Eigen::all);
  const Eigen::JacobiSVD<MatrixXd> svd(directions, Eigen::ComputeFullU);
  Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > lost_tolerance) ++rank;
  const VectorXd scale = fit.scale(lost);
  return svd.matrixU().rightCols(static_cast<Index>(lost.size()) - rank).transpose() *
         scale.cwiseInverse().asDiagonal();
}

// Each phase that is unknown takes up one row of its observation's.
void note_repeats(const CaseFit& fit, RowsByCondition& rows) {
  struct Repeats {
    double count = 0, weights = 0, sum = 0, squares = 0;
  };
  std::map<std::tuple<int, std::size_t, EquationPart>, Repeats> equations;
  const WhitenedSystem& system = fit.system;
  for (Index r = 0; r < fit.fit.residual.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    Repeats& repeats = equations[{system.condition[at], system.block[at], system.part[at]}];
    const double weight = fit.weight[system.observation[at]];  // rows are multiplied by its root
    if (!(weight > 0)) continue;
    repeats.count += 1;
    repeats.weights += weight;
    repeats.sum += std::sqrt(weight) * fit.fit.residual(r);
    repeats.squares += fit.fit.residual(r) * fit.fit.residual(r);
  }
  double squares = 0, freedom = 0;
  for (const auto& [equation, repeats] : equations) {
    squares += std::max(0.0, repeats.squares - repeats.sum * repeats.sum / repeats.weights);
    freedom += repeats.count - 1;
  }
  if (fit.overlap.gram.size() > 0) {  // docs/inference.md (45)
    const WindowOverlap& overlap = fit.overlap;
    rows.repeat_gram = overlap.gram;
    if (!(overlap.repeats_squared > 0)) return;
    rows.repeat_freedom = overlap.repeats * overlap.repeats / overlap.repeats_squared;
    rows.repeat_variance = squares / overlap.repeats;
    return;
  }
  const auto all = static_cast<double>(fit.fit.residual.size());
  rows.repeat_freedom = freedom * (1 - static_cast<double>(system.by_phase.size()) / all);
  rows.repeat_variance = rows.repeat_freedom > 0 ? squares / rows.repeat_freedom : 0;
}

// `used`: columns that parameters make. What the case has lost may be anything.
RowsByCondition rows_of(const CaseFit& fit, const std::vector<Index>& used) {
  const LinearFit& regression = fit.fit;
  const MatrixXd coordinates = regression.orthonormal.transpose() * fit.system.design;  // of each column
  std::vector<Index> rest;
  for (Index c = 0; c < coordinates.cols(); ++c)
    if (std::find(used.begin(), used.end(), c) == used.end()) rest.push_back(c);
  // What the rows do not see at all is nothing in their coordinates.
  const Index seen = regression.lost.cols() - (coordinates.cols() - regression.rank);
  RowsByCondition rows;
  rows.entries = coordinates(Eigen::all, used);
  rows.others.resize(coordinates.rows(), static_cast<Index>(rest.size()) + seen);
  rows.others << MatrixXd(coordinates(Eigen::all, rest)),
      coordinates * regression.scale.asDiagonal() * regression.lost.rightCols(seen);
  rows.reference = fit.reference(used);
  rows.estimate = coordinates * (regression.coefficients - fit.reference);
  rows.kept = regression.kept;
  rows.residual_sd = regression.residual_sd;
  note_repeats(fit, rows);
  rows.gram = regression.cluster_gram;
  rows.score = regression.cluster_score;
  return rows;
}

// Moves x symbols: how far along each of EstimatePass::moves parameters are.
MatrixXd along_moves(const Estimation& e) {
  const Index symbols = static_cast<Index>(e.model.symbols.size());
  VectorXd size = e.pass.moves.rowwise().norm();
  for (Index p = 0; p < symbols; ++p) size(p) = size(p) > 0 ? 1 / size(p) : 0;
  MatrixXd moves = size.asDiagonal() * e.pass.moves;
  const VectorXd length = moves.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
  moves = moves * length.cwiseInverse().asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(lost_tolerance);
  solver.compute(moves);
  return length.cwiseInverse().asDiagonal() * solver.pseudoInverse() * size.asDiagonal();
}

// Columns x symbols: how a case's coefficients change with the parameters that the truncation was taken out with,
// along EstimatePass::moves.
MatrixXd truncation_slope(const Estimation& e, const CaseFit& fit) {
  const Index count = e.pass.moves.cols();
  if (count == 0 || fit.moves_effect.cols() != count) return MatrixXd::Zero(fit.fit.coefficients.size(), 0);
  return fit.moves_effect * along_moves(e);
}

// A factor of a covariance of quantities of very different sizes.
MatrixXd factor_of(const MatrixXd& covariance) {
  const VectorXd sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd inverse = (sd.array() > 0).select(sd.cwiseInverse(), 0.0);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> own(
      MatrixXd(inverse.asDiagonal() * covariance * inverse.asDiagonal()));
  std::vector<Index> kept;
  for (Index i = 0; i < own.eigenvalues().size(); ++i)
    if (own.eigenvalues()(i) > lost_tolerance) kept.push_back(i);
  return sd.asDiagonal() * own.eigenvectors()(Eigen::all, kept) * own.eigenvalues()(kept).cwiseSqrt().asDiagonal();
}

// A natural frequency that no regression separates from other changes of stiffness is still near the observed
// one: that is what the resonance means. Without it, coefficients that hold it weakly would have to determine it.
void add_frequency_priors(Estimation& e) {
  for (std::size_t k = 0; k < e.model.modes(); ++k) {
    bool estimated = false;
    for (std::size_t s = 0; s < e.fits.size(); ++s) {
      const std::vector<int>& index = e.lump_estimates[s].index;
      const auto end = index.begin() + static_cast<std::ptrdiff_t>(e.single[s]);
      estimated = estimated || std::find(index.begin(), end, -1 - static_cast<int>(k)) != end;
    }
    if (estimated || e.given[k]) continue;
    LumpEstimates near;
    near.resonance = e.sets.front()->resonance;
    near.index = {-1 - static_cast<int>(k)};
    near.combination = MatrixXd::Identity(1, 1);
    near.values = VectorXd::Constant(1, e.knowledge.natural_frequency[k]);
    near.plain = MatrixXd::Constant(1, 1, std::pow(frequency_prior_sd * near.values(0), 2));
    near.degrees_of_freedom = std::numeric_limits<double>::infinity();
    e.lump_estimates.push_back(std::move(near));
  }
}

// A lump that is given is one of the values that parameters have to make, so sharp that nothing else moves it.
void add_given_lumps(Estimation& e, const VectorXd& parameters) {
  for (const ObservationSet* set : e.sets) {
    const CompiledCase& resonance = *set->resonance;
    const std::size_t count = resonance.lumps.size(), symbols = e.model.symbols.size();
    std::vector<double> slope(count * symbols);
    if (count > 0) resonance.evaluate_lumps_jacobian(parameters.data(), slope.data());
    for (std::size_t l = 0; l < count; ++l) {
      if (!is_given_itself(e, resonance, l)) continue;
      LumpEstimates given;
      given.resonance = &resonance;
      given.index = {static_cast<int>(l)};
      given.combination = MatrixXd::Identity(1, 1);
      given.values = VectorXd::Constant(1, *given_value(e, resonance, l));
      double size = std::abs(given.values(0));
      for (std::size_t p = 0; p < symbols; ++p)
        size = std::max(size, std::abs(slope[l * symbols + p] * parameters(static_cast<Index>(p))));
      given.plain = MatrixXd::Constant(1, 1, std::pow(given_width * (size > 0 ? size : 1), 2));
      given.degrees_of_freedom = std::numeric_limits<double>::infinity();
      e.lump_estimates.push_back(std::move(given));
    }
  }
}

// The lumps of case s, and what the bootstrap drew of them.
void move(Estimation& e, std::size_t s, const VectorXd& change) {
  e.fits[s].fit.coefficients += change;
  if (s < e.bootstrap_lumps.size() && e.bootstrap_lumps[s].rows() == change.size())
    e.bootstrap_lumps[s].colwise() += change;
}

// Parameters that no lump depends on act on the motions all the same (a coupling to a mode whose resonance was not
// excited): what they do to the truncation's correction is an unknown like the other null-space directions.
void add_silent_directions(Estimation& e) {
  const VectorXd size = sizes_by_force(e.model, e.sets, e.shared.values);
  std::vector<bool> heard(e.model.symbols.size(), false);
  for (const LumpEstimates& part : e.lump_estimates) {
    std::vector<double> slope(part.resonance->lumps.size() * heard.size());
    if (!slope.empty()) part.resonance->evaluate_lumps_jacobian(e.shared.values.data(), slope.data());
    for (std::size_t i = 0; i < slope.size(); ++i)
      if (slope[i] != 0) heard[i % heard.size()] = true;
  }
  for (std::size_t p = e.model.modes(); p < heard.size(); ++p) {
    const auto at = static_cast<Index>(p);
    if (heard[p] || e.given[p] || !(size(at) > 0)) continue;
    MatrixXd& null_space = e.shared.null_space;
    MatrixXd& coordinate = e.shared.null_space_coordinate;
    null_space.conservativeResize(Eigen::NoChange, null_space.cols() + 1);
    null_space.rightCols(1) = size(at) * VectorXd::Unit(null_space.rows(), at);
    coordinate.conservativeResize(coordinate.rows() + 1, Eigen::NoChange);
    coordinate.bottomRows(1) = VectorXd::Unit(coordinate.cols(), at).transpose() / size(at);
  }
}

// By LumpEstimates: covariance of what was estimated of the case, as its regression has it.
std::vector<MatrixXd> noise_of_lumps(const Estimation& e) {
  std::vector<MatrixXd> noise;
  for (std::size_t c = 0; c < e.lump_estimates.size(); ++c) {
    const LumpEstimates& part = e.lump_estimates[c];
    if (c >= e.fits.size() || part.values.size() == 0) {
      noise.push_back(part.plain);
      continue;
    }
    const MatrixXd& all = e.fits[c].fit.covariance;
    noise.emplace_back(part.combination * MatrixXd(all(e.used[c], e.used[c])) * part.combination.transpose());
  }
  return noise;
}

// Estimate::noise and Estimate::open, and what both leave unknown of the truncation.
void set_uncertainty(Estimation& e) {
  const Index symbols = e.shared.values.size(), directions = e.shared.null_coordinate.size();
  // Of values and null-space coordinates, one standard deviation along independent directions.
  const MatrixXd noise = factor_of(e.shared.noise_covariance);
  MatrixXd open(symbols + directions, directions);
  open << e.shared.value_prior, e.shared.null_coordinate_prior;
  e.result.noise = noise.topRows(symbols);
  e.result.open = e.shared.null_space;
  if (directions == e.shared.null_space.cols()) {
    e.result.noise += e.shared.null_space * noise.bottomRows(directions);
    e.result.open = open.topRows(symbols) + e.shared.null_space * open.bottomRows(directions);
  }
  e.truncation_unknown.resize(0, 0);
  if (e.pass.moves.cols() == 0) return;
  MatrixXd both(symbols + directions, noise.cols() + directions);
  both << noise, open;
  e.truncation_unknown.resize(e.pass.moves.cols() + directions, both.cols());
  e.truncation_unknown << along_moves(e) * both.topRows(symbols), both.bottomRows(directions);
}

}  // namespace

void share_parameters(Estimation& e) {
  e.lump_estimates.clear();
  e.bootstrap_lumps.clear();
  e.used.clear();
  e.truncation_slope.clear();
  e.single.clear();
  for (const CaseFit& fit : e.fits) {
    LumpEstimates part;
    part.resonance = fit.set->resonance;
    e.truncation_slope.emplace_back();
    std::vector<Index> used, lost;
    for (std::size_t c = 0; c < fit.columns.size() && fit.fit.coefficients.size() > 0; ++c)
      if (fit.columns[c].kind != CaseColumn::Kind::sensor_offset)
        (fit.fit.identifiable[c] ? used : lost).push_back(static_cast<Index>(c));
    const auto single = static_cast<Index>(used.size());
    const MatrixXd together = known_combinations(fit.fit, lost);
    used.insert(used.end(), lost.begin(), lost.end());
    for (const Index c : used) {
      const CaseColumn& column = fit.columns[static_cast<std::size_t>(c)];
      part.index.push_back(column.kind == CaseColumn::Kind::lump ? static_cast<int>(column.index)
                                                                 : -1 - static_cast<int>(column.index));
    }
    const Index size = single + together.rows(), entries = static_cast<Index>(used.size());
    part.combination = MatrixXd::Zero(size, entries);
    part.combination.topLeftCorner(single, single).setIdentity();
    if (together.size() > 0) part.combination.bottomRightCorner(together.rows(), together.cols()) = together;
    if (size > 0) {
      part.values = part.combination * fit.fit.coefficients(used);
      part.plain = part.combination * MatrixXd(fit.fit.plain_covariance(used, used)) * part.combination.transpose();
      part.influence = MatrixXd(fit.fit.influence(Eigen::all, used)) * part.combination.transpose();
      part.record_moves = fit.record_moves(used, Eigen::all);
      part.record_freedom = fit.record_freedom;
      part.truncation_effect = fit.truncation_effect(used, Eigen::all);
      part.residual_information = fit.residual_information;
      e.truncation_slope.back() = truncation_slope(e, fit);
      part.truncation_slope = e.truncation_slope.back()(used, Eigen::all);
      part.truncation_at = e.pass.corrected_at;
      if (!e.pass.between) part.rows = rows_of(fit, used);
    }
    part.clustered = fit.fit.covariance_kind == CovarianceKind::clustered;
    part.degrees_of_freedom = fit.fit.degrees_of_freedom;
    e.lump_estimates.push_back(std::move(part));
    e.used.push_back(std::move(used));
    e.single.push_back(static_cast<std::size_t>(single));
  }
  add_frequency_priors(e);
  VectorXd start = VectorXd::Zero(static_cast<Index>(e.model.symbols.size()));
  for (Index p = 0; p < start.size(); ++p) {
    const std::string name(e.model.symbols[static_cast<std::size_t>(p)].name);
    if (p < static_cast<Index>(e.model.modes()))
      start(p) = e.knowledge.natural_frequency[static_cast<std::size_t>(p)];
    for (std::size_t s = 0; s < e.fits.size(); ++s)
      for (std::size_t i = 0; i < e.single[s]; ++i)
        if (const LumpEstimates& part = e.lump_estimates[s];
            part.index[i] >= 0 && is_symbol(part.resonance->lumps[static_cast<std::size_t>(part.index[i])], name))
          start(p) = part.values(static_cast<Index>(i));
    if (e.given[static_cast<std::size_t>(p)]) start(p) = e.options.fixed.at(name);
  }
  add_given_lumps(e, start);
  e.shared = shared_parameters(e.lump_estimates, start, e.given, e.pass.null_space_place, e.pass.between);
  add_silent_directions(e);
  e.result.parameter_values = e.shared.values;
  e.result.parameter_sd = e.shared.covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

void place_along_null_space(Estimation& e) {
  e.result.null_space = e.shared.null_space;
  e.result.null_space_coordinate = e.shared.null_space_coordinate;
  e.result.null_coordinate = e.shared.null_coordinate;
  e.result.null_coordinate_sd = e.shared.null_coordinate_sd;
  set_uncertainty(e);
  e.open_variance.assign(e.fits.size(), VectorXd());
  const std::vector<MatrixXd> noise = noise_of_lumps(e);
  for (std::size_t s = 0; s < e.fits.size(); ++s) {
    const CaseFit& fit = e.fits[s];
    const Index columns = fit.fit.coefficients.size();
    if (columns == 0 || e.shared.slope[s].size() == 0) continue;
    const MatrixXd& effect = fit.truncation_effect;
    const MatrixXd& by_values = e.truncation_slope[s];
    const bool follows_values = by_values.cols() > 0;
    const bool follows_coordinates = effect.cols() > 0 && e.shared.null_coordinate_slope[s].size() > 0;
    // Coefficients are corrected at the parameters found: c + by_values*(values - corrected_at) +
    // effect*(null_coordinate - from). What makes values and null-space coordinates uncertain therefore makes these
    // uncertain, too.
    const auto followed = [&](const MatrixXd& of_values, const MatrixXd& of_coordinates) {
      MatrixXd change = MatrixXd::Zero(columns, of_values.cols());
      if (follows_values) change += by_values * of_values;
      if (follows_coordinates) change += effect * of_coordinates;
      return change;
    };
    if (follows_values) move(e, s, by_values * (e.shared.values - e.pass.corrected_at));
    if (follows_coordinates) {
      const VectorXd& from = e.pass.null_space_place.corrected_at;
      move(e, s, effect * (from.size() > 0 ? VectorXd(e.shared.null_coordinate - from) : e.shared.null_coordinate));
    }
    MatrixXd map = MatrixXd::Identity(columns, columns);  // of the coefficients' own noise
    map(Eigen::all, e.used[s]) +=
        followed(e.shared.slope[s], e.shared.null_coordinate_slope[s]) * e.lump_estimates[s].combination;
    const MatrixXd open = followed(e.shared.value_prior, e.shared.null_coordinate_prior);
    e.open_variance[s] = open.rowwise().squaredNorm();
    const MatrixXd told = followed(e.shared.value_by_information, e.shared.null_coordinate_by_information);
    MatrixXd further = open * open.transpose() + told * told.transpose(), plain_further = further;
    for (std::size_t other = 0; other < noise.size(); ++other) {
      if (other == s || e.shared.slope[other].size() == 0) continue;
      const MatrixXd by_other = followed(e.shared.slope[other], e.shared.null_coordinate_slope[other]);
      further += by_other * noise[other] * by_other.transpose();
      plain_further += by_other * e.lump_estimates[other].plain * by_other.transpose();
    }
    LinearFit& regression = e.fits[s].fit;
    regression.influence = regression.influence * map.transpose();
    regression.covariance = map * regression.covariance * map.transpose() + further;
    regression.plain_covariance = map * regression.plain_covariance * map.transpose() + plain_further;
  }
}

void draw_bootstrap(Estimation& e) {
  const Index count = e.shared.values.size();
  e.bootstrap = e.shared.values.replicate(1, e.options.bootstrap);
  for (std::size_t s = 0; s < e.fits.size(); ++s) {
    if (e.fits[s].fit.coefficients.size() == 0) {
      e.bootstrap_lumps.emplace_back();
      continue;
    }
    e.bootstrap_lumps.push_back(bootstrap_coefficients(e.fits[s], e.options.bootstrap, e.options.seed + s));
    MatrixXd change(static_cast<Index>(e.used[s].size()), e.options.bootstrap);
    for (std::size_t i = 0; i < e.used[s].size(); ++i)
      change.row(static_cast<Index>(i)) =
          e.bootstrap_lumps[s].row(e.used[s][i]).array() - e.fits[s].fit.coefficients(e.used[s][i]);
    if (e.shared.slope[s].rows() == count)
      e.bootstrap += e.shared.slope[s] * (e.lump_estimates[s].combination * change);
  }
}

}  // namespace secular
