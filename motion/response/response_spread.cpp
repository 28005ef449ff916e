#include "motion/response/response_spread.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "motion/response/amplitude_slope.hpp"
#include "motion/response/differences.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

/// Of singular values over the largest one: zero, after differences of rounded rates.
constexpr double singular = 1e-7;
/// Steps of differences, of quantities of the order of one.
constexpr double relative_step = 1e-5;
/// Share of a standard deviation by which parameters are moved: directions that change no response are long, and
/// straight for a short way only.
constexpr double share_of_sd = 1e-3;
/// Of second differences along the curve, the same.
constexpr double peak_step = 0x1p-10;
/// Amplitudes below this many typical ones are none.
constexpr double no_amplitude = 1e-6;

// A field's equations about a solution in unknowns of the order of one, y = (state / typical, parameter / range).
struct Linearised {
  MatrixXd state;      // d rate_i / d y_j over typical_i, states alone
  VectorXd parameter;  // the same by the varied parameter
  MatrixXd moved;      // rows x directions: rates that one standard deviation of each makes, over typical_i
};

Linearised linearised(const VectorField& field, const ConstVector& state, const ConstVector& parameters,
                      Index varied, double range, const MatrixXd& directions) {
  const VectorXd& typical = field.typical_state();
  const auto over_typical = [&](const VectorXd& rate) { return VectorXd(rate.cwiseQuotient(typical)); };
  Linearised result;
  result.state = typical.cwiseInverse().asDiagonal() * field.jacobian(state, parameters) * typical.asDiagonal();
  result.parameter = range * over_typical(field.parameter_derivative(state, parameters, varied));
  result.moved.resize(state.size(), directions.cols());
  for (Index d = 0; d < directions.cols(); ++d)
    result.moved.col(d) = over_typical(field.rate(state, parameters + share_of_sd * directions.col(d)) -
                                       field.rate(state, parameters - share_of_sd * directions.col(d))) /
                          (2 * share_of_sd);
  return result;
}

// The eigenvalue of a Jacobian that is nearest to a given one.
std::complex<double> nearest_eigenvalue(const VectorField& field, const ConstVector& state,
                                        const ConstVector& parameters, std::complex<double> given) {
  const VectorXcd all = spectrum_of(field.jacobian(state, parameters)).eigenvalues;
  Index nearest = 0;
  (all.array() - given).abs().minCoeff(&nearest);
  return all(nearest);
}

}  // namespace

ResponseSpread::ResponseSpread(const ResponseField& field, UncertainParameters parameters, Index varied,
                               double range, double scale)
    : field_(field),
      uncertain_(std::move(parameters)),
      varied_(varied),
      range_(range),
      scale_(scale),
      reduced_(field.reduced(scale, uncertain_.values)) {}

VectorXd ResponseSpread::parameters_at(double value) const {
  VectorXd parameters = uncertain_.values;
  parameters(varied_) = value;
  return parameters;
}

std::optional<ResponseSpread::Moved> ResponseSpread::moved(const ResponsePoint& point) const {
  if (point.at_rest || point.state.size() == 0) return {};
  const Linearised at =
      linearised(reduced_, point.state, parameters_at(point.parameter), varied_, range_, uncertain_.directions);
  const Index n = point.state.size();
  Moved result;
  result.jacobian.resize(n, n + 1);
  result.jacobian << at.state, at.parameter;
  if (!result.jacobian.allFinite() || !at.moved.allFinite()) return {};
  const Eigen::JacobiSVD<MatrixXd> svd(result.jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()(n - 1) < singular * svd.singularValues()(0)) return {};
  result.tangent = svd.matrixV().col(n);
  result.direction = -svd.solve(at.moved);  // of least norm: at right angles to the tangent
  return result;
}

std::vector<CurveSpread> ResponseSpread::of(const ResponsePoint& point) const {
  const std::optional<Moved> curve = this->moved(point);
  if (!curve) return {};
  const VectorXd parameters = parameters_at(point.parameter);
  const Index n = point.state.size();
  const VectorXd& tangent = curve->tangent;
  const MatrixXd& moved = curve->direction;

  // |B| along a direction of y, over the typical amplitude.
  const auto amplitude_along = [&](const VectorXd& direction) {
    const VectorXd move = relative_step * direction.head(n).cwiseProduct(reduced_.typical_state());
    const ModeAmplitudes ahead = field_.amplitudes(parameters, point.state + move),
                         behind = field_.amplitudes(parameters, point.state - move);
    VectorXd slope(static_cast<Index>(ahead.amplitude.size()));
    for (std::size_t k = 0; k < ahead.amplitude.size(); ++k)
      slope(static_cast<Index>(k)) =
          (std::abs(ahead.amplitude[k]) - std::abs(behind.amplitude[k])) / (2 * relative_step * scale_);
    return slope;
  };
  const VectorXd rise = amplitude_along(tangent);
  MatrixXd raised(rise.size(), moved.cols());
  for (Index d = 0; d < moved.cols(); ++d) raised.col(d) = amplitude_along(moved.col(d));
  std::vector<CurveSpread> spread(point.modes.amplitude.size());
  for (std::size_t k = 0; k < spread.size(); ++k) {
    const auto row = static_cast<Index>(k);
    const double run = tangent(n), length = std::hypot(run, rise(row));
    if (std::abs(point.modes.amplitude[k]) < no_amplitude * scale_ || !(length > 0)) continue;
    const double right = -rise(row) / length, up = run / length;  // the normal of the curve
    const double across = (right * moved.row(n) + up * raised.row(row)).norm();
    spread[k] = {scale_ * across / std::abs(up), range_ * across / std::abs(right), range_ * across * right,
                 scale_ * across * up};
  }
  return spread;
}

std::optional<double> ResponseSpread::of_peak(const ResponsePoint& point, std::size_t mode) const {
  const std::optional<Moved> curve = moved(point);
  if (!curve) return {};
  const Index n = point.state.size();
  const VectorXd& typical = reduced_.typical_state();
  const auto square = [&](const VectorXd& parameters, const VectorXd& state) {
    return std::norm(field_.amplitudes(parameters, state).amplitude[mode] / scale_);
  };
  const VectorXd here = parameters_at(point.parameter);
  const MatrixXd level = difference_jacobian(
      [&](const VectorXd& y) { return VectorXd::Constant(1, square(here, y.cwiseProduct(typical))); },
      point.state.cwiseQuotient(typical), VectorXd::Ones(n), 1);
  VectorXd slope = VectorXd::Zero(n + 1);
  slope.head(n) = level.row(0).transpose();
  const VectorXd weight =
      curve->jacobian.transpose().jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(slope);
  // What is stationary under f = 0, at unknowns and parameters moved from here.
  const auto lagrangian = [&](const VectorXd& unknowns, const VectorXd& by) {
    VectorXd parameters = here + by;
    parameters(varied_) += range_ * unknowns(n);
    const VectorXd state = point.state + unknowns.head(n).cwiseProduct(typical);
    return square(parameters, state) - weight.dot(reduced_.rate(state, parameters).cwiseQuotient(typical));
  };
  const VectorXd along = peak_step * curve->tangent, none = VectorXd::Zero(here.size());
  const auto mixed = [&](const VectorXd& unknowns, const VectorXd& by) {
    return lagrangian(along + unknowns, by) - lagrangian(along - unknowns, -by) - lagrangian(unknowns - along, by) +
           lagrangian(-along - unknowns, -by);
  };
  const double bend = mixed(along, none) / peak_step;  // 4 peak_step times the second derivative
  if (std::abs(bend) <= 4 * peak_step * flat_bend * square(here, point.state)) return {};
  VectorXd place(curve->direction.cols());
  for (Index d = 0; d < place.size(); ++d) {
    const VectorXd unknowns = curve->direction.col(d);
    const double turn = mixed(share_of_sd * unknowns, share_of_sd * uncertain_.directions.col(d)) / share_of_sd;
    place(d) = unknowns(n) - turn / bend * curve->tangent(n);
  }
  const double sd = range_ * place.norm();
  return std::isfinite(sd) ? std::optional<double>(sd) : std::nullopt;
}

std::optional<double> ResponseSpread::of(const ResponseSpecial& special) const {
  if (special.at.at_rest) {
    const VectorField full = field_.full(scale_, uncertain_.values);
    return of_eigenvalue(full, VectorXd::Zero(full.dimension()), special.at.parameter);
  }
  if (special.at.state.size() == 0) return {};
  if (special.kind == SpecialKind::saddle_node) return of_saddle_node(special.at);
  if (special.kind == SpecialKind::hopf) return of_eigenvalue(reduced_, special.at.state, special.at.parameter);
  return {};
}

std::optional<double> ResponseSpread::of_saddle_node(const ResponsePoint& point) const {
  const Linearised at =
      linearised(reduced_, point.state, parameters_at(point.parameter), varied_, range_, uncertain_.directions);
  if (!at.state.allFinite() || !at.moved.allFinite()) return {};
  const Eigen::JacobiSVD<MatrixXd> svd(at.state, Eigen::ComputeFullU);
  const VectorXd left = svd.matrixU().rightCols(1);
  const double slope = left.dot(at.parameter);
  if (std::abs(slope) < singular * svd.singularValues()(0)) return {};
  return range_ * (left.transpose() * at.moved / slope).norm();
}

std::optional<double> ResponseSpread::of_eigenvalue(const VectorField& field, const VectorXd& state,
                                                    double value) const {
  const VectorXd parameters = parameters_at(value);
  const Linearised at = linearised(field, state, parameters, varied_, range_, uncertain_.directions);
  if (!at.state.allFinite() || !at.moved.allFinite()) return {};
  const VectorXcd all = spectrum_of(field.jacobian(state, parameters)).eigenvalues;
  Index critical = 0;
  all.real().cwiseAbs().minCoeff(&critical);
  // The solution follows: zero stays zero, and elsewhere the Jacobian is regular.
  const auto followed = [&](const VectorXd& rates) {
    return VectorXd(-at.state.completeOrthogonalDecomposition().solve(rates).cwiseProduct(field.typical_state()));
  };
  const bool at_zero = state.isZero(0);
  const auto growth_along = [&](const VectorXd& move, const VectorXd& change) {
    const auto growth = [&](double sign) {
      return nearest_eigenvalue(field, state + sign * move, parameters + sign * change, all(critical)).real();
    };
    return (growth(1) - growth(-1)) / 2;
  };
  const VectorXd still = VectorXd::Zero(state.size());
  const VectorXd change = relative_step * range_ * VectorXd::Unit(parameters.size(), varied_);
  const double slope =
      growth_along(at_zero ? still : VectorXd(relative_step * followed(at.parameter)), change) / relative_step;
  VectorXd moved(at.moved.cols());
  for (Index d = 0; d < moved.size(); ++d)
    moved(d) = growth_along(at_zero ? still : VectorXd(share_of_sd * followed(at.moved.col(d))),
                            share_of_sd * uncertain_.directions.col(d)) /
               share_of_sd;
  const double sd = range_ * moved.norm() / std::abs(slope);
  return std::isfinite(sd) ? std::optional<double>(sd) : std::nullopt;
}

std::vector<BackboneSpread> backbone_spread(const ResponseField& field, const UncertainParameters& parameters,
                                            std::size_t mode, double largest, int points) {
  std::vector<BackboneSpread> spread(static_cast<std::size_t>(points));
  for (Index d = 0; d < parameters.directions.cols(); ++d) {
    const VectorXd move = share_of_sd * parameters.directions.col(d);
    const std::vector<BackbonePoint> plus = backbone(field, parameters.values + move, mode, largest, points),
                                     minus = backbone(field, parameters.values - move, mode, largest, points);
    for (std::size_t i = 0; i < spread.size(); ++i) {
      spread[i].frequency += std::pow((plus[i].frequency - minus[i].frequency) / (2 * share_of_sd), 2);
      spread[i].growth += std::pow((plus[i].growth - minus[i].growth) / (2 * share_of_sd), 2);
    }
  }
  for (BackboneSpread& at : spread) at = {std::sqrt(at.frequency), std::sqrt(at.growth)};
  return spread;
}

std::optional<LimitCycleSpread> limit_cycle_spread(const ResponseField& field,
                                                   const UncertainParameters& parameters, std::size_t mode,
                                                   const LimitCycle& cycle) {
  const auto at = [&](const VectorXd& values, double amplitude) {
    return backbone(field, values, mode, amplitude, 1).front();
  };
  const double a = cycle.at.amplitude;
  const BackbonePoint above = at(parameters.values, a * (1 + relative_step)),
                      below = at(parameters.values, a * (1 - relative_step));
  const double growth_slope = (above.growth - below.growth) / (2 * relative_step * a);
  const double frequency_slope = (above.frequency - below.frequency) / (2 * relative_step * a);
  VectorXd amplitude(parameters.directions.cols()), frequency(parameters.directions.cols());
  for (Index d = 0; d < parameters.directions.cols(); ++d) {
    const VectorXd move = share_of_sd * parameters.directions.col(d);
    const BackbonePoint plus = at(parameters.values + move, a), minus = at(parameters.values - move, a);
    amplitude(d) = -(plus.growth - minus.growth) / (2 * share_of_sd) / growth_slope;
    frequency(d) = (plus.frequency - minus.frequency) / (2 * share_of_sd) + frequency_slope * amplitude(d);
  }
  const LimitCycleSpread spread{amplitude.norm(), frequency.norm()};
  if (!std::isfinite(spread.amplitude) || !std::isfinite(spread.frequency)) return {};
  return spread;
}

}  // namespace secular
