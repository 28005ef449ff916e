#include "estimator/identification/shared_parameters.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "estimator/regression/clustered_chi_squared.hpp"
#include "estimator/thresholds.hpp"
#include "input/numerical_failure.hpp"
#include "numerics/distribution.hpp"
#include "numerics/nonlinear_fit.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of scaled columns below this share of the largest are none; parts of directions, squared, below
/// the other belong to nothing.
constexpr double lost_direction = 1e-9, part_of_group = 1e-8;

/// Probability that lumps of a model that holds contradict one another.
constexpr auto& least_contradiction = estimator_thresholds().contradiction_alarm;

// Whitening of one case's lumps through scaled variables: they differ by many powers of ten.
struct Whitening {
  VectorXd inverse_sd;
  Eigen::LLT<MatrixXd> cholesky;

  explicit Whitening(const MatrixXd& covariance) {
    const VectorXd sd = covariance.diagonal().cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
    inverse_sd = sd.cwiseInverse();
    const MatrixXd correlation = inverse_sd.asDiagonal() * covariance * inverse_sd.asDiagonal();
    cholesky.compute(MatrixXd(correlation + 1e-12 * MatrixXd::Identity(sd.size(), sd.size())));
  }
  MatrixXd operator()(MatrixXd m) const {
    m = inverse_sd.asDiagonal() * m;
    cholesky.matrixL().solveInPlace(m);
    return m;
  }
};

// SharedParameters::null_space and null_space_coordinate.
struct NullSpace {
  MatrixXd directions, coordinates;
};

// By parameter of a group: the size with which it alone would do to some lump, by `slopes` of the lumps, all that
// the group does, within the error of that; of all lumps the smallest. What is more than that the others would have
// to cancel. `spread`: a factor of the covariance of the `values`.
VectorXd sizes_alone(const MatrixXd& slopes, const VectorXd& values, const MatrixXd& spread) {
  VectorXd sizes = VectorXd::Constant(values.size(), std::numeric_limits<double>::infinity());
  for (Index lump = 0; lump < slopes.rows(); ++lump) {
    const double done = std::hypot(slopes.row(lump).dot(values), (slopes.row(lump) * spread).norm());
    for (Index p = 0; p < values.size(); ++p)
      if (slopes(lump, p) != 0) sizes(p) = std::min(sizes(p), done / std::abs(slopes(lump, p)));
  }
  return sizes;
}

// Of the whitened Jacobian; in columns of unit norm entangled parameters do the same for the same size. `slopes`:
// of all lumps as they are.
NullSpace null_space_directions(const MatrixXd& jacobian, const MatrixXd& slopes, const VectorXd& scale,
                                const VectorXd& values, const VectorXd& plausible_size) {
  std::vector<Index> seen;
  for (Index p = 0; p < jacobian.cols(); ++p)
    if (jacobian.col(p).squaredNorm() > 0) seen.push_back(p);
  // All are known, or nothing that was measured depends on those that are not.
  if (seen.empty()) return {MatrixXd::Zero(jacobian.cols(), 0), MatrixXd::Zero(0, jacobian.cols())};
  const VectorXd seen_scale = scale(seen), plausible_sizes = plausible_size(seen);
  const MatrixXd columns = jacobian(Eigen::all, seen) * seen_scale.asDiagonal();
  const auto width = static_cast<Index>(seen.size());
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  const MatrixXd triangle = qr.matrixQR().topRows(std::min(columns.rows(), width)).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<MatrixXd> svd(triangle * qr.colsPermutation().transpose(), Eigen::ComputeFullV);
  std::vector<Index> lost;
  MatrixXd spread = seen_scale.asDiagonal() * svd.matrixV();  // a factor of the covariance of what is seen
  for (Index k = 0; k < width; ++k) {
    const double singular = k < svd.singularValues().size() ? svd.singularValues()(k) : 0;
    const bool informed = singular > lost_direction * svd.singularValues()(0) &&
                          is_informed(svd.matrixV().col(k), singular, seen_scale, plausible_sizes);
    if (!informed) lost.push_back(k);
    spread.col(k) *= informed ? 1 / singular : 0;
  }
  const MatrixXd null = svd.matrixV()(Eigen::all, lost);
  const MatrixXd projection = null * null.transpose();
  NullSpace null_space{MatrixXd::Zero(jacobian.cols(), null.cols()), MatrixXd::Zero(null.cols(), jacobian.cols())};
  Index found = 0;
  std::vector<bool> done(seen.size(), false);
  for (Index first = 0; first < width; ++first) {
    if (done[static_cast<std::size_t>(first)] || projection(first, first) < part_of_group) continue;
    // Everything that is entangled with it.
    std::vector<Index> group{first};
    done[static_cast<std::size_t>(first)] = true;
    for (std::size_t at = 0; at < group.size(); ++at)
      for (Index other = 0; other < width; ++other)
        if (!done[static_cast<std::size_t>(other)] && std::abs(projection(group[at], other)) > part_of_group) {
          done[static_cast<std::size_t>(other)] = true;
          group.push_back(other);
        }
    std::vector<Index> symbols;
    for (const Index g : group) symbols.push_back(seen[static_cast<std::size_t>(g)]);
    // Independent parameters around zero with standard deviations D, given what lumps see: directions U along their
    // null space with U^T D^-2 U = 1, and U^T D^-2 parameters of mean zero.
    const VectorXd size = sizes_alone(slopes(Eigen::all, symbols), values(symbols), spread(group, Eigen::all));
    const VectorXd precision = size.cwiseAbs2().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> own(MatrixXd(projection(group, group)));
    std::vector<Index> free;
    for (Index i = 0; i < own.eigenvalues().size(); ++i)
      if (own.eigenvalues()(i) > 0.5 && found + static_cast<Index>(free.size()) < null.cols()) free.push_back(i);
    const MatrixXd basis = seen_scale(group).asDiagonal() * own.eigenvectors()(Eigen::all, free);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> given(
        MatrixXd(basis.transpose() * precision.asDiagonal() * basis));
    MatrixXd directions =
        basis * given.eigenvectors() * given.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
    // Either sense is as good; the same one each time, since corrections are not quite linear.
    for (auto direction : directions.colwise()) {
      const VectorXd share = direction.cwiseQuotient(size);
      Index clear = 0;  // the first that is at least half of the largest: equals may differ by rounding
      while (std::abs(share(clear)) < 0.5 * share.cwiseAbs().maxCoeff()) ++clear;
      if (share(clear) < 0) direction = -direction;
    }
    for (Index i = 0; i < directions.cols(); ++i, ++found)
      for (std::size_t g = 0; g < symbols.size(); ++g) {
        const auto at = static_cast<Index>(g);
        null_space.directions(symbols[g], found) = directions(at, i);
        null_space.coordinates(found, symbols[g]) = directions(at, i) * precision(at);
      }
  }
  null_space.directions.conservativeResize(Eigen::NoChange, found);
  null_space.coordinates.conservativeResize(found, Eigen::NoChange);
  return null_space;
}

// By unknown: the size with which it alone would make as much as is seen of all the lumps that it is part of,
// at `parameters`. Infinite where it is part of none.
VectorXd plausible_sizes(std::span<const LumpEstimates> cases, const VectorXd& parameters, Index unknowns) {
  VectorXd seen = VectorXd::Zero(unknowns), made = VectorXd::Zero(unknowns);
  for (const LumpEstimates& part : cases) {
    const std::size_t lump_count = part.resonance->lumps.size();
    const auto count = static_cast<std::size_t>(parameters.size());
    std::vector<double> slope(lump_count * count);
    if (lump_count > 0) part.resonance->evaluate_lumps_jacobian(parameters.data(), slope.data());
    for (std::size_t i = 0; i < part.index.size(); ++i) {
      if (part.index[i] < 0) continue;
      // What was estimated of this lump: itself, or combinations with others.
      for (Index v = 0; v < part.values.size(); ++v) {
        const double share = part.combination(v, static_cast<Index>(i)), sd = std::sqrt(part.plain(v, v));
        if (share == 0 || !(sd > 0)) continue;
        for (std::size_t p = 0; p < count; ++p) {
          const double d = share * slope[static_cast<std::size_t>(part.index[i]) * count + p];
          if (d == 0) continue;
          seen(static_cast<Index>(p)) += std::pow(part.values(v) / sd, 2);
          made(static_cast<Index>(p)) += std::pow(d / sd, 2);
        }
      }
    }
  }
  VectorXd sizes = VectorXd::Constant(unknowns, std::numeric_limits<double>::infinity());
  for (Index p = 0; p < unknowns; ++p)
    if (made(p) > 0) sizes(p) = std::sqrt(seen(p) / made(p));
  return sizes;
}

// Lumps and natural frequencies of one case, and their slopes by all unknowns.
struct Entries {
  VectorXd values;
  MatrixXd slope;
};

Entries entries_of(const LumpEstimates& part, const VectorXd& parameters, Index unknowns) {
  const Index count = parameters.size(), entries = static_cast<Index>(part.index.size());
  const auto lump_count = static_cast<Index>(part.resonance->lumps.size());
  VectorXd lumps(lump_count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> lump_slope(lump_count, count);
  if (lump_count > 0) {
    part.resonance->evaluate_lumps(parameters.data(), lumps.data());
    part.resonance->evaluate_lumps_jacobian(parameters.data(), lump_slope.data());
  }
  Entries result{VectorXd(entries), MatrixXd::Zero(entries, unknowns)};
  for (Index i = 0; i < entries; ++i) {
    const int index = part.index[static_cast<std::size_t>(i)];
    if (index < 0) {
      result.values(i) = parameters(-1 - index);
      result.slope(i, -1 - index) = 1;
    } else {
      result.values(i) = lumps(index);
      result.slope.row(i).head(count) = lump_slope.row(index);
    }
  }
  return result;
}

// The same as the regression should give them after the truncation is taken out; `given` parameters do not move.
Entries entries_at(const LumpEstimates& part, const VectorXd& unknowns, Index count, const std::vector<bool>& given,
                   bool with_truncation) {
  const Index directions = unknowns.size() - count;
  const VectorXd parameters = unknowns.head(count);
  Entries result = entries_of(part, parameters, unknowns.size());
  if (with_truncation && part.truncation_slope.cols() > 0) {
    result.values -= part.truncation_slope * (parameters - part.truncation_at);
    result.slope.leftCols(count) -= part.truncation_slope;
  }
  for (Index p = 0; p < count; ++p)
    if (given[static_cast<std::size_t>(p)]) result.slope.col(p).setZero();
  if (part.truncation_effect.cols() > 0) {
    result.values -= part.truncation_effect * unknowns.tail(directions);
    result.slope.rightCols(directions) = -part.truncation_effect;
  }
  return result;
}

// d values/d parameters of all cases, one after the other: as measured, not whitened.
MatrixXd slopes_of_lumps(std::span<const LumpEstimates> cases, const VectorXd& parameters, Index values) {
  MatrixXd slopes(values, parameters.size());
  Index row = 0;
  for (const LumpEstimates& part : cases) {
    const Index size = part.values.size();
    if (size > 0)
      slopes.middleRows(row, size) = part.combination * entries_of(part, parameters, parameters.size()).slope;
    row += size;
  }
  return slopes;
}

// Clustered cases by their own rows, the others by their lumps: the rows of `further`, which holds all lumps'.
// `directions`: along which unknowns are fitted.
std::optional<ClusterScatter> scatter_at(std::span<const LumpEstimates> cases, const VectorXd& unknowns,
                                         Index count, const std::vector<bool>& given, MatrixXd further,
                                         const MatrixXd& directions) {
  std::vector<CommonFit> common;
  Index row = 0;
  for (const LumpEstimates& part : cases) {
    const Index size = part.values.size();
    if (part.clustered && size > 0) {
      Entries entries = entries_at(part, unknowns, count, given, true);
      common.push_back({&part.rows, std::move(entries.slope), std::move(entries.values)});
      further.middleRows(row, size).setZero();
    }
    row += size;
  }
  return condition_scatter(common, further, directions);
}

// Lumps of all cases on the parameters that they share. Unknowns are parameters, then null-space coordinates; after
// the lumps' rows come the cases' evidence of null-space coordinates, and then those of the null-space coordinates'
// own size.
class SharedFit {
 public:
  SharedFit(std::span<const LumpEstimates> cases, const VectorXd& start, const std::vector<bool>& given,
            const NullSpacePlace& place, std::span<const ResidualInformation> evidence)
      : cases_(cases), evidence_of_(evidence), given_(given), count_(start.size()) {
    for (const LumpEstimates& part : cases) {
      lumps_ += part.values.size();
      directions_ = std::max(directions_, part.truncation_effect.cols());
      whitening_.emplace_back(part.plain);
    }
    for (const ResidualInformation& of_case : evidence_of_) evidence_ += of_case.target.size();
    result_.values = start;
    result_.covariance = result_.plain_covariance = MatrixXd::Zero(count_, count_);
    result_.noise_covariance = MatrixXd::Zero(count_ + directions_, count_ + directions_);
    result_.degrees_of_freedom = VectorXd::Constant(count_, std::numeric_limits<double>::infinity());
    result_.open_variance = VectorXd::Zero(count_);
    result_.slope.assign(cases.size(), MatrixXd());
    result_.null_coordinate_slope.assign(cases.size(), MatrixXd());
    result_.null_coordinate = VectorXd::Zero(directions_);
    result_.null_coordinate_sd = VectorXd::Ones(directions_);
    result_.null_coordinate_prior = MatrixXd::Identity(directions_, directions_);
    result_.value_prior = MatrixXd::Zero(count_, directions_);
    result_.value_by_information = MatrixXd::Zero(count_, evidence_);
    result_.null_coordinate_by_information = MatrixXd::Zero(directions_, evidence_);
    result_.null_space = MatrixXd::Zero(count_, 0);
    result_.null_space_coordinate = MatrixXd::Zero(0, count_);
    // Where no case has a coefficient left, none says anything of the directions.
    corrected_at_ = place.corrected_at.size() == directions_ ? place.corrected_at : result_.null_coordinate;
    expected_ = place.expected.size() == directions_ ? place.expected : result_.null_coordinate;
  }

  SharedParameters run(bool rough_errors) {
    if (lumps_ == 0) return std::move(result_);
    fit();
    see_null_space();
    invert();
    set_slopes();
    set_errors(rough_errors);
    set_chi_squared();
    return std::move(result_);
  }

 private:
  Index rows() const { return lumps_ + evidence_ + directions_; }

  void evaluate(const VectorXd& unknowns, bool with_truncation, VectorXd& residual, MatrixXd& jacobian) const {
    Index r = 0;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const LumpEstimates& part = cases_[c];
      const Index size = part.values.size();
      if (size == 0) continue;
      const Entries entries = entries_at(part, seen_from_correction(unknowns), count_, given_, with_truncation);
      residual.segment(r, size) = whitening_[c](part.combination * entries.values - part.values);
      jacobian.middleRows(r, size) = whitening_[c](part.combination * entries.slope);
      r += size;
    }
    jacobian.bottomRows(evidence_ + directions_).setZero();
    for (const ResidualInformation& evidence : evidence_of_) {
      const Index size = evidence.target.size();
      if (size == 0) continue;
      residual.segment(r, size) =
          evidence.design * seen_from_correction(unknowns).tail(directions_) - evidence.target;
      jacobian.block(r, count_, size, directions_) = evidence.design;
      r += size;
    }
    residual.tail(directions_) = unknowns.tail(directions_) - expected_;
    jacobian.bottomRightCorner(directions_, directions_).setIdentity();
  }

  // Shifts from where the truncation was taken out.
  VectorXd seen_from_correction(VectorXd unknowns) const {
    unknowns.tail(directions_) -= corrected_at_;
    return unknowns;
  }

  // `held`: a parameter that stays at its start.
  FitReport fit_from(const VectorXd& start, bool with_truncation, Index held = -1) const {
    const ResidualFunction function = [&](const VectorXd& at, VectorXd& residual, MatrixXd& jacobian) {
      evaluate(at, with_truncation, residual, jacobian);
      if (held >= 0) jacobian.col(held).setZero();
    };
    return nonlinear_fit(function, rows(), start, 100, plausible_);
  }

  MatrixXd slopes_at(const VectorXd& unknowns) const {
    VectorXd residual(rows());
    MatrixXd jacobian(rows(), unknowns.size());
    evaluate(unknowns, false, residual, jacobian);
    return jacobian;
  }

  // docs/inference.md, "Both sides of a saddle". Where lumps are products of parameters, zero is a saddle, and the
  // first step from there decides on which side the fit goes on.
  FitReport fit_on_both_sides(const VectorXd& from) const {
    FitReport best = fit_from(from, false);
    const auto surplus = static_cast<double>(std::max<Index>(0, lumps_ - count_));
    const double most = surplus > 0 ? chi_squared_upper_quantile(least_contradiction, surplus) : 1;
    if (!(2 * best.cost > most)) return best;
    const VectorXd end = best.parameters;
    const MatrixXd slopes = slopes_at(end);
    for (Index p = 0; p < count_; ++p) {
      if (from(p) != 0 || end(p) == 0) continue;
      VectorXd mirrored = from, changed = end;
      mirrored(p) = changed(p) = -end(p);
      if ((slopes_at(changed) - slopes).isZero(0)) continue;  // its sign changes nothing that others do
      FitReport other = fit_from(fit_from(mirrored, false, p).parameters, false);
      if (2 * (best.cost - other.cost) > 1) best = std::move(other);
    }
    return best;
  }

  // Slopes of the truncation hold about the parameters that it was taken out with; from afar they mean nothing. So
  // the fit comes near without them where that leaves less of the lumps. Of fewer lumps than parameters any end is
  // as good, and the one nearest to the start is taken.
  void fit() {
    const Index unknowns = count_ + directions_;
    VectorXd from(unknowns);
    from << result_.values, corrected_at_;
    plausible_ = plausible_sizes(cases_, result_.values, unknowns);
    FitReport found = fit_from(from, true);
    if (lumps_ >= count_) {
      FitReport near = fit_from(fit_on_both_sides(from).parameters, true);
      if (2 * (found.cost - near.cost) > 1) found = std::move(near);
    }
    unknowns_ = found.parameters;
    result_.values = unknowns_.head(count_);
    result_.null_coordinate = unknowns_.tail(directions_);
    residual_.resize(rows());
    jacobian_.resize(rows(), unknowns);
  }

  void see_null_space() {
    evaluate(unknowns_, false, residual_, jacobian_);
    if (!jacobian_.allFinite())
      throw NumericalFailure(Ending::ran_away,
                             "parameters from lumps: grow beyond bounds; the truncation that was taken out of the "
                             "equations may be far larger than these");
    NullSpace null_space = null_space_directions(
        jacobian_.topLeftCorner(lumps_, count_), slopes_of_lumps(cases_, result_.values, lumps_),
        unit_scale(jacobian_).head(count_), result_.values, plausible_.head(count_));
    result_.null_space = std::move(null_space.directions);
    result_.null_space_coordinate = std::move(null_space.coordinates);
  }

  // d unknowns / d whitened rows, in columns of unit norm. Where the lumps are not informed of a direction the fit
  // stays where it was: noise along it reaches no number. (The truncation's slopes are differences, and leave such
  // a direction some 1e-7 of what others have, by their own errors.)
  void invert() {
    evaluate(unknowns_, true, residual_, jacobian_);
    const VectorXd scale = unit_scale(jacobian_);
    const Eigen::BDCSVD<MatrixXd> svd(jacobian_ * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    const VectorXd& singular = svd.singularValues();
    std::vector<Index> informed;
    for (Index k = 0; k < singular.size(); ++k)
      if (singular(k) > lost_direction * singular(0) &&
          is_informed(svd.matrixV().col(k), singular(k), scale, plausible_))
        informed.push_back(k);
    directions_fitted_ = scale.asDiagonal() * svd.matrixV()(Eigen::all, informed);
    // What no row sees stays where it is: rounding would give it an error bar, and with that a slope to divide by
    // it.
    for (Index p = 0; p < jacobian_.cols(); ++p)
      if (jacobian_.col(p).isZero(0)) directions_fitted_.row(p).setZero();
    inverse_ = directions_fitted_ * singular(informed).cwiseInverse().asDiagonal() *
               svd.matrixU()(Eigen::all, informed).transpose();
    result_.surplus = rows() - static_cast<Index>(informed.size());
  }

  // d values / d lumps = pinv(W J) W, by cases.
  void set_slopes() {
    Index r = 0;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const Index size = cases_[c].values.size();
      if (size == 0) continue;
      const MatrixXd slope = inverse_.middleCols(r, size) * whitening_[c](MatrixXd::Identity(size, size));
      result_.slope[c] = slope.topRows(count_);
      result_.null_coordinate_slope[c] = slope.bottomRows(directions_);
      r += size;
    }
    result_.null_coordinate_prior = inverse_.bottomRightCorner(directions_, directions_);
    result_.value_prior = inverse_.topRightCorner(count_, directions_);
    result_.value_by_information = inverse_.block(0, lumps_, count_, evidence_);
    result_.null_coordinate_by_information = inverse_.block(count_, lumps_, directions_, evidence_);
  }

  void set_errors(bool rough_errors) {
    const std::optional<ClusterScatter> between =
        rough_errors || directions_fitted_.cols() == 0
            ? std::nullopt
            : scatter_at(cases_, seen_from_correction(unknowns_), count_, given_, jacobian_, directions_fitted_);
    VectorXd squares =
        VectorXd::Zero(count_);  // of independent parts of each variance, over their degrees of freedom
    result_.noise_covariance = MatrixXd::Zero(count_ + directions_, count_ + directions_);
    const auto add = [&](const MatrixXd& covariance, const VectorXd& freedom) {
      result_.noise_covariance += covariance;
      squares += covariance.diagonal().head(count_).cwiseAbs2().cwiseQuotient(freedom);
    };
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const LumpEstimates& part = cases_[c];
      if (part.values.size() == 0) continue;
      MatrixXd slope(count_ + directions_, part.values.size());
      slope << result_.slope[c], result_.null_coordinate_slope[c];
      const MatrixXd plain = slope * part.plain * slope.transpose();
      result_.plain_covariance += plain.topLeftCorner(count_, count_);
      if (part.record_moves.cols() > 0) {
        const MatrixXd moved = slope * part.combination * part.record_moves;
        add(moved * moved.transpose(), VectorXd::Constant(count_, part.record_freedom));
      }
      const VectorXd freedom = VectorXd::Constant(count_, part.degrees_of_freedom);
      if (!part.clustered) {
        add(plain, freedom);
      } else if (!between) {
        const auto n = static_cast<double>(part.influence.rows());
        const MatrixXd moved = part.influence * slope.transpose();
        add((n - 1) / n * moved.transpose() * moved, freedom);
      }
    }
    if (evidence_ > 0) {
      const MatrixXd slope = inverse_.middleCols(lumps_, evidence_);
      add(slope * slope.transpose(), VectorXd::Constant(count_, std::numeric_limits<double>::infinity()));
    }
    if (between)
      add(between->covariance,
          between->degrees_of_freedom.head(count_).cwiseMax(std::numeric_limits<double>::min()));
    result_.covariance = result_.noise_covariance.topLeftCorner(count_, count_);
    // Errors that no noise makes: where parameters may be along the null space, and what that does to the
    // others.
    const MatrixXd open =
        result_.value_prior * result_.value_prior.transpose() + result_.null_space * result_.null_space.transpose();
    result_.covariance += open;
    result_.plain_covariance += open;
    result_.open_variance = open.diagonal();
    const VectorXd of_coordinates = result_.noise_covariance.diagonal().tail(directions_);
    result_.null_coordinate_sd =
        (of_coordinates + result_.null_coordinate_prior.rowwise().squaredNorm()).cwiseSqrt();
    if (!result_.covariance.cwiseAbs2().allFinite())
      throw NumericalFailure(Ending::ran_away, "standard deviations of the parameters are beyond all numbers");
    for (Index p = 0; p < count_; ++p)
      if (squares(p) > 0) result_.degrees_of_freedom(p) = std::pow(result_.covariance(p, p), 2) / squares(p);
  }

  void set_chi_squared() {
    // What the fit leaves of a change of the lumps.
    const MatrixXd left = MatrixXd::Identity(rows(), rows()) - jacobian_ * inverse_;
    ResidualScatter scatter;
    scatter.known = left.rightCols(evidence_ + directions_);
    Index r = 0;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const LumpEstimates& part = cases_[c];
      const Index size = part.values.size();
      if (size == 0) continue;
      const auto of_case = left.middleCols(r, size);
      const auto also_known = [&](const MatrixXd& change) {
        scatter.known.conservativeResize(Eigen::NoChange, scatter.known.cols() + change.cols());
        scatter.known.rightCols(change.cols()) = of_case * change;
      };
      if (part.record_moves.cols() > 0) also_known(whitening_[c](part.combination * part.record_moves));
      if (part.clustered)
        scatter.influence.push_back(whitening_[c](part.influence.transpose()).transpose() * of_case.transpose());
      else
        also_known(MatrixXd::Identity(size, size));
      r += size;
    }
    result_.chi_squared = clustered_chi_squared(residual_, result_.surplus, scatter);
  }

  std::span<const LumpEstimates> cases_;
  std::span<const ResidualInformation> evidence_of_;
  const std::vector<bool>& given_;
  Index count_, lumps_ = 0, evidence_ = 0, directions_ = 0;
  std::vector<Whitening> whitening_;
  VectorXd corrected_at_, expected_;          // by direction
  VectorXd plausible_, unknowns_, residual_;  // at unknowns_
  MatrixXd jacobian_, inverse_, directions_fitted_;
  SharedParameters result_;
};

// Each case's evidence as far as it tells more than the lumps do, which leave the null-space coordinates this
// covariance. Both see the same noise: what the lumps tell nearly as well would count twice. A row counts with the
// share 1 - q of its weight, q what the lumps tell along it (beyond what is plausible, a variance of
// one) over what it tells itself.
std::vector<ResidualInformation> beyond_lumps(std::span<const LumpEstimates> cases, const MatrixXd& by_lumps) {
  const Index directions = by_lumps.rows();
  const MatrixXd told = by_lumps.ldlt().solve(MatrixXd(MatrixXd::Identity(directions, directions))) -
                        MatrixXd::Identity(directions, directions);
  std::vector<ResidualInformation> result;
  for (const LumpEstimates& part : cases) {
    const ResidualInformation& all = part.residual_information;
    std::vector<Index> kept;
    std::vector<double> share;
    for (Index row = 0; row < all.target.size(); ++row) {
      const VectorXd along = all.design.row(row).transpose().normalized();
      const double by_the_lumps = std::max(0.0, along.dot(told * along)),
                   by_itself = all.design.row(row).squaredNorm();
      const double left = 1 - by_the_lumps / by_itself;
      if (!(left > 0)) continue;
      kept.push_back(row);
      share.push_back(std::sqrt(left));
    }
    if (kept.empty()) continue;
    const Eigen::Map<const VectorXd> weight(share.data(), static_cast<Index>(share.size()));
    result.push_back({weight.asDiagonal() * all.design(kept, Eigen::all), weight.cwiseProduct(all.target(kept))});
  }
  return result;
}

}  // namespace

SharedParameters shared_parameters(std::span<const LumpEstimates> cases, const VectorXd& start,
                                   const std::vector<bool>& given, const NullSpacePlace& place, bool rough_errors) {
  std::vector<ResidualInformation> evidence;
  if (std::any_of(cases.begin(), cases.end(),
                  [](const auto& c) { return c.residual_information.target.size() > 0; })) {
    const SharedParameters by_lumps = SharedFit(cases, start, given, place, {}).run(true);
    const Index directions = by_lumps.null_coordinate.size();
    evidence = beyond_lumps(cases, by_lumps.noise_covariance.bottomRightCorner(directions, directions) +
                                       by_lumps.null_coordinate_prior * by_lumps.null_coordinate_prior.transpose());
  }
  return SharedFit(cases, start, given, place, evidence).run(rough_errors);
}

}  // namespace secular
