#include "motion/response/peak_curve.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "motion/response/amplitude_slope.hpp"
#include "motion/response/scaled_field.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Typical amplitudes below which a peak is none.
constexpr double least_peak = 0.02;

class Peaks {
 public:
  Peaks(const ResponseField& field, const PeakRequest& request)
      : field_(field),
        request_(request),
        scaled_(
            field.reduced(request.scale, request.response.parameters), request.response.parameters,
            {{request.response.parameter, request.response.lower, request.response.upper - request.response.lower},
             {request.second, request.second_lower, request.second_upper - request.second_lower}}),
        square_(field, scaled_, request.mode, request.scale) {}
  Peaks(const Peaks&) = delete;
  Peaks& operator=(const Peaks&) = delete;

  Index dimension() const { return scaled_.dimension(); }

  VectorXd unknowns_at(const ResponsePoint& point) const {
    VectorXd parameters = request_.response.parameters;
    parameters(request_.response.parameter) = point.parameter;
    return scaled_.unknowns_at(point.state, parameters);
  }

  // f, and the slope of |B|^2 along the branch in the first parameter.
  VectorXd equations(const VectorXd& y) const {
    const Index n = dimension();
    VectorXd along = VectorXd::Zero(y.size());
    along.head(n + 1) = turned_tangent(scaled_.jacobian(y).leftCols(n + 1));
    VectorXd value(n + 1);
    value.head(n) = scaled_.rate(y);
    value(n) = square_.slope(y, along);
    return value;
  }

  ModeAmplitudes modes(const VectorXd& y) const {
    return field_.amplitudes(scaled_.parameters(y), scaled_.state(y));
  }
  double first(const VectorXd& y) const { return scaled_.parameters(y)(request_.response.parameter); }
  double second(const VectorXd& y) const { return scaled_.parameters(y)(request_.second); }

 private:
  const ResponseField& field_;
  const PeakRequest& request_;
  ScaledField scaled_;
  AmplitudeSquare square_;
};

}  // namespace

ResponseCurve peak_curve(const ResponseField& field, const PeakRequest& request, const ResponsePoint& start) {
  const Peaks peaks(field, request);
  const Index n = peaks.dimension();
  const EquationSystem system = with_differences([&](const VectorXd& y) { return peaks.equations(y); }, n + 1);
  CurvePoint at{peaks.unknowns_at(start), {}};
  at.tangent = tangent_at(system, at.unknowns, VectorXd::Unit(n + 2, n + 1));
  const std::vector<CurveBound> bounds{{n, 0, 1, TraceStatus::parameter_bound, "the first parameter"},
                                       {n + 1, 0, 1, TraceStatus::parameter_bound, "the second parameter"}};
  ResponseCurve curve;
  curve.kind = CurveKind::peak;
  const auto add = [&](const VectorXd& y) {
    curve.points.push_back({peaks.first(y), peaks.second(y), peaks.modes(y), 0});
  };
  const auto visit = [&](const CurvePoint&, const CurvePoint& to, bool, TraceEnd& end) {
    const double amplitude = std::abs(peaks.modes(to.unknowns).amplitude[request.mode]);
    if (amplitude < least_peak * request.scale) {
      end = {TraceStatus::special_end, "the peak's amplitude falls to zero"};
      return Visit::stop;
    }
    add(to.unknowns);
    return Visit::accept;
  };
  CurvePoint back = at;
  back.tangent = -at.tangent;
  StepOptions steps;
  steps.point_limit = 500;
  steps.least = 1e-4;  // towards amplitude zero the equations lose their condition: end there
  curve.first_end = trace_curve(system, back, bounds, steps, visit);
  std::reverse(curve.points.begin(), curve.points.end());
  add(at.unknowns);
  curve.last_end = trace_curve(system, at, bounds, steps, visit);
  return curve;
}

}  // namespace secular
