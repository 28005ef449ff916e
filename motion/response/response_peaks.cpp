#include "motion/response/response_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "motion/response/amplitude_slope.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Typical amplitudes below which there is none.
constexpr double no_peak = 1e-6;
/// Distance, of unknowns of the order of one, within which points are one.
constexpr double one_point = 1e-6;
/// Share of the way between two points to which a peak is found.
constexpr double to_rounding = 1e-13;

// A point may be found from both sides of it.
void mark(ResponsePoint& point, std::size_t mode) {
  if (std::none_of(point.peaks.begin(), point.peaks.end(),
                   [&](const ResponsePeak& one) { return one.mode == mode; }))
    point.peaks.push_back({mode});
}

class PeakSearch {
 public:
  PeakSearch(const ResponseField& field, const ResponseRequest& request, double scale)
      : field_(field),
        request_(request),
        scale_(scale),
        scaled_(field.reduced(scale, request.parameters), request.parameters,
                {{request.parameter, request.lower, request.upper - request.lower}}) {
    curve_.value = [this](const VectorXd& y) { return scaled_.rate(y); };
    curve_.jacobian = [this](const VectorXd& y) { return scaled_.jacobian(y); };
  }
  PeakSearch(const PeakSearch&) = delete;
  PeakSearch& operator=(const PeakSearch&) = delete;

  // Points of the branch and the peaks between them, in order.
  void add_to(ResponseBranch& branch) const {
    std::vector<ResponsePoint> all;
    std::optional<CurvePoint> before;
    for (ResponsePoint& point : branch.points) {
      std::optional<CurvePoint> now = place(point);
      if (before && now) add_between(*before, *now, all, point);
      before = std::move(now);
      all.push_back(std::move(point));
    }
    branch.points = std::move(all);
  }

 private:
  std::optional<CurvePoint> place(const ResponsePoint& point) const {
    if (point.at_rest || point.state.size() == 0) return std::nullopt;
    CurvePoint placed{scaled_.unknowns_at(point.state, parameters_at(point.parameter)), {}};
    placed.tangent = turned_tangent(scaled_.jacobian(placed.unknowns));
    if (!placed.tangent.allFinite()) return std::nullopt;
    return placed;
  }

  VectorXd parameters_at(double value) const {
    VectorXd parameters = request_.parameters;
    parameters(request_.parameter) = value;
    return parameters;
  }

  void add_between(CurvePoint from, CurvePoint to, std::vector<ResponsePoint>& points, ResponsePoint& end) const {
    const VectorXd chord = to.unknowns - from.unknowns;
    for (CurvePoint* point : {&from, &to})
      if (point->tangent.dot(chord) < 0) point->tangent = -point->tangent;
    std::vector<std::pair<VectorXd, ResponsePoint>> tops;  // with their unknowns
    for (const std::size_t mode : field_.active()) {
      const AmplitudeSquare square(field_, scaled_, mode, scale_);
      const auto slope = [&](const CurvePoint& at) { return square.slope(at.unknowns, at.tangent); };
      if (!(slope(from) > 0) || !(slope(to) <= 0) || square.at(from.unknowns) < no_peak * no_peak) continue;
      // A saturated amplitude has slopes of rounding, of either sign.
      if (slope(from) - slope(to) <= flat_bend * chord.norm() * square.at(from.unknowns)) continue;
      const std::optional<CurvePoint> top = zero_between(curve_, from, to, slope, to_rounding);
      if (!top || square.at(top->unknowns) < std::max(square.at(from.unknowns), square.at(to.unknowns))) continue;
      // A point that is the peak becomes it; the first and the last of a branch stay where they are.
      if ((top->unknowns - to.unknowns).norm() < one_point)
        mark(end, mode);
      else if ((top->unknowns - from.unknowns).norm() < one_point)
        mark(points.back(), mode);
      else
        mark(top_at(*top, tops), mode);
    }
    std::sort(tops.begin(), tops.end(),
              [&](const auto& a, const auto& b) { return chord.dot(a.first) < chord.dot(b.first); });
    for (auto& [unknowns, point] : tops) points.push_back(std::move(point));
  }

  // The one of `tops` that is there, or a new one.
  ResponsePoint& top_at(const CurvePoint& at, std::vector<std::pair<VectorXd, ResponsePoint>>& tops) const {
    for (auto& [unknowns, point] : tops)
      if ((unknowns - at.unknowns).norm() < one_point) return point;
    return tops.emplace_back(at.unknowns, point_of(at)).second;
  }

  ResponsePoint point_of(const CurvePoint& at) const {
    ResponsePoint point;
    point.parameter = scaled_.parameters(at.unknowns)(request_.parameter);
    point.state = scaled_.state(at.unknowns);
    point.modes = field_.amplitudes(parameters_at(point.parameter), point.state);
    const Spectrum spectrum = spectrum_of(scaled_.state_jacobian(at.unknowns));
    point.eigenvalues = spectrum.eigenvalues;
    point.unstable = spectrum.unstable;
    return point;
  }

  const ResponseField& field_;
  const ResponseRequest& request_;
  double scale_;
  ScaledField scaled_;
  EquationSystem curve_;
};

}  // namespace

void add_peaks(const ResponseField& field, const ResponseRequest& request, ResponseDiagram& diagram) {
  const PeakSearch search(field, request, diagram.scale);
  for (ResponseBranch& branch : diagram.branches)
    if (!branch.at_rest) search.add_to(branch);
}

}  // namespace secular
