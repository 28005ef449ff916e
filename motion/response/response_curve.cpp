#include "motion/response/response_curve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "motion/response/peak_curve.hpp"
#include "motion/response/response_peaks.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

/// Amplitudes below this many typical ones are none.
constexpr double at_rest_share = 1e-7;

/// Points of the trivial solution where it is not traced itself.
constexpr int rest_points = 201;

double largest_amplitude(const ModeAmplitudes& modes) {
  double largest = 0;
  for (const Complex& b : modes.amplitude) largest = std::max(largest, std::abs(b));
  return largest;
}

// The growth rates of the trivial solution change without bound as the amplitude falls (dry friction).
bool is_singular_at_rest(const ResponseField& field, const ConstVector& parameters, double scale) {
  const auto count = static_cast<Index>(field.active().size());
  const VectorXcd u = VectorXcd::Constant(count, Complex(0.8, 0.6));
  const VectorXcd offset = field.modulation(parameters, VectorXcd::Zero(count));
  const auto slope = [&](double a) { return ((field.modulation(parameters, a * u) - offset) / a).norm(); };
  return slope(1e-9 * scale) > 100 * slope(1e-5 * scale);
}

class CurveSearch {
 public:
  CurveSearch(const ResponseField& field, const ResponseRequest& request)
      : field_(field),
        request_(request),
        scale_(amplitude_scale(field, request.parameters, request.parameter, request.lower, request.upper)) {
    // Steps are measured in `scale_`: a search far below it needs a shorter one.
    if (request.largest > 0) scale_ = std::min(scale_, request.largest / 2);
    result_.parameter = request.parameter;
    result_.scale = scale_;
    result_.largest = request.largest > 0 ? request.largest : 4 * scale_;
  }

  ResponseDiagram run() {
    if (!(request_.lower < request_.upper)) throw std::invalid_argument("a response over an empty range");
    const VectorField reduced = field_.reduced(scale_, request_.parameters);
    DiagramOptions options;
    options.continuation.lower = request_.lower;
    options.continuation.upper = request_.upper;
    options.continuation.state_bound =
        std::max(result_.largest / scale_, field_.is_blown_up() ? field_.box(1).maxCoeff() : 0.0);
    options.upper = field_.box(result_.largest);
    options.lower = -options.upper;
    options.starts_at = VectorXd::LinSpaced(7, request_.lower, request_.upper);
    if (!request_.search_at.empty())
      options.starts_at =
          Eigen::Map<const VectorXd>(request_.search_at.data(), static_cast<Index>(request_.search_at.size()));
    const BifurcationDiagram diagram =
        bifurcation_diagram(reduced, request_.parameters, request_.parameter, options);
    result_.status = diagram.status;
    result_.reason = diagram.reason;
    result_.notes.push_back(field_.description());
    singular_ = is_singular_at_rest(field_, request_.parameters, scale_);
    if (singular_)
      result_.notes.emplace_back(
          "the equations are singular at rest (dry friction): the state of rest and what branches off it are left "
          "out");
    for (const Branch& branch : diagram.branches) add(branch);
    if (field_.is_blown_up() && !singular_) add_rest();
    return std::move(result_);
  }

 private:
  VectorXd parameters_at(double value) const {
    VectorXd parameters = request_.parameters;
    parameters(request_.parameter) = value;
    return parameters;
  }

  ResponsePoint point_of(const Equilibrium& at) const {
    ResponsePoint point;
    point.parameter = at.parameter;
    point.modes = field_.amplitudes(parameters_at(at.parameter), at.state);
    point.state = at.state;
    point.eigenvalues = at.eigenvalues;
    point.unstable = at.unstable;
    point.at_rest = largest_amplitude(point.modes) < at_rest_share * scale_;
    return point;
  }

  // Mirror image of another solution under a symmetry that was divided out.
  bool is_mirror(const Equilibrium& at) const {
    return field_.is_reduced() && field_.pinned(at.state).minCoeff() < -at_rest_share * scale_;
  }

  // Points in a row that are no mirror images, one list for each stretch; a closed branch goes on across its ends.
  std::vector<std::vector<const Equilibrium*>> stretches(const Branch& branch) const {
    std::vector<std::vector<const Equilibrium*>> found;
    bool inside = false;
    for (const Equilibrium& at : branch.points) {
      const bool kept = !is_mirror(at);
      if (kept && !inside) found.emplace_back();
      if (kept) found.back().push_back(&at);
      inside = kept;
    }
    if (found.size() > 1 && branch.closed && !is_mirror(branch.points.front()) && inside) {
      found.back().insert(found.back().end(), found.front().begin() + 1, found.front().end());
      found.erase(found.begin());
    }
    return found;
  }

  void add(const Branch& branch) {
    const auto runs = stretches(branch);
    std::vector<ResponseBranch> results(runs.size());
    std::size_t kept = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      for (const Equilibrium* at : runs[r]) results[r].points.push_back(point_of(*at));
      kept += runs[r].size();
    }
    const bool whole = kept == branch.points.size();
    for (const SpecialPoint& special : branch.special) {
      if (is_mirror(special.at)) continue;
      std::size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t r = 0; r < runs.size(); ++r)
        for (const Equilibrium* at : runs[r])
          if (const double away = std::abs(at->arclength - special.at.arclength); away < least) {
            least = away;
            nearest = r;
          }
      if (results.empty()) break;
      results[nearest].special.push_back(
          {special.kind, point_of(special.at), special.frequency, special.polished, special});
    }
    for (ResponseBranch& result : results) {
      const TraceEnd mirrored{TraceStatus::special_end,
                              "goes on as its own mirror image, which is the same response"};
      result.first_end = whole ? branch.first_end : mirrored;
      result.last_end = whole ? branch.last_end : mirrored;
      result.closed = whole && branch.closed;
      add(std::move(result));
    }
  }

  void add(ResponseBranch result) {
    result.at_rest = std::all_of(result.points.begin(), result.points.end(),
                                 [](const ResponsePoint& point) { return point.at_rest; });
    if (result.at_rest && singular_) return;
    if (result.at_rest && field_.is_blown_up()) {
      // The same solution once for every direction in which it decays or grows.
      for (ResponseSpecial& special : result.special)
        if (is_crossing(special.kind)) thresholds_.push_back(std::move(special));
      return;
    }
    result_.branches.push_back(std::move(result));
  }

  VectorXcd rest_eigenvalues(const VectorField& full, double value, int& unstable) const {
    const Spectrum spectrum = spectrum_of(full.jacobian(VectorXd::Zero(full.dimension()), parameters_at(value)));
    unstable = spectrum.unstable;
    return spectrum.eigenvalues;
  }

  void add_rest() {
    const VectorField full = field_.full(scale_, request_.parameters);
    if (full.rate(VectorXd::Zero(full.dimension()), request_.parameters).norm() > 0) return;
    ResponseBranch rest;
    rest.at_rest = true;
    rest.first_end = rest.last_end = {TraceStatus::parameter_bound, "end of the range"};
    const auto point_at = [&](double value) {
      ResponsePoint point;
      point.parameter = value;
      point.modes.amplitude.resize(field_.model().modes());
      point.modes.frequency_shift.resize(field_.model().modes());
      point.eigenvalues = rest_eigenvalues(full, value, point.unstable);
      point.at_rest = true;
      return point;
    };
    for (int i = 0; i < rest_points; ++i)
      rest.points.push_back(point_at(request_.lower + (request_.upper - request_.lower) * i / (rest_points - 1)));
    const double near = 1e-6 * (request_.upper - request_.lower);
    for (ResponseSpecial& threshold : thresholds_) {
      const auto same = [&](const ResponseSpecial& other) {
        return std::abs(other.at.parameter - threshold.at.parameter) < near;
      };
      if (std::any_of(rest.special.begin(), rest.special.end(), same)) continue;
      // The drift on the branch that begins here.
      const ModeAmplitudes modes = threshold.at.modes;
      threshold.at = point_at(threshold.at.parameter);
      threshold.at.modes.frequency_shift = modes.frequency_shift;
      rest.points.push_back(threshold.at);
      rest.special.push_back(std::move(threshold));
    }
    const auto by_parameter = [](const auto& a, const auto& b) { return a.parameter < b.parameter; };
    std::sort(rest.points.begin(), rest.points.end(), by_parameter);
    std::sort(rest.special.begin(), rest.special.end(),
              [](const auto& a, const auto& b) { return a.at.parameter < b.at.parameter; });
    result_.branches.insert(result_.branches.begin(), std::move(rest));
  }

  const ResponseField& field_;
  const ResponseRequest& request_;
  double scale_;
  bool singular_ = false;
  std::vector<ResponseSpecial> thresholds_;
  ResponseDiagram result_;
};

bool is_wanted(CurveKind kind, const ResponseSpecial& special) {
  switch (kind) {
    case CurveKind::saddle_node:
      return special.kind == SpecialKind::saddle_node && !special.at.at_rest;
    case CurveKind::threshold:
      return special.at.at_rest && (is_crossing(special.kind) || special.kind == SpecialKind::hopf);
    case CurveKind::hopf:
      return special.kind == SpecialKind::hopf && !special.at.at_rest;
    case CurveKind::peak:
      break;
  }
  return false;
}

// Whether the curve passes this point, to the width of its steps.
bool passes(const ResponseCurve& curve, const ResponsePoint& point, double second, const CurveRequest& request,
            double scale) {
  const double first_length = request.response.upper - request.response.lower;
  const double second_length = request.second_upper - request.second_lower;
  const auto place = [&](double first, double other, const ModeAmplitudes& modes) {
    VectorXd v(2 + static_cast<Index>(modes.amplitude.size()));
    v(0) = first / first_length;
    v(1) = other / second_length;
    for (std::size_t k = 0; k < modes.amplitude.size(); ++k)
      v(2 + static_cast<Index>(k)) = std::abs(modes.amplitude[k]) / scale;
    return v;
  };
  const VectorXd at = place(point.parameter, second, point.modes);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const VectorXd from = place(curve.points[i - 1].first, curve.points[i - 1].second, curve.points[i - 1].modes);
    const VectorXd chord = place(curve.points[i].first, curve.points[i].second, curve.points[i].modes) - from;
    const double length = chord.norm();
    if (!(length > 0)) continue;
    const double share = std::clamp(chord.dot(at - from) / (length * length), 0.0, 1.0);
    if ((from + share * chord - at).norm() < 0.05 * length + 1e-6) return true;
  }
  return false;
}

class Curves {
 public:
  Curves(const ResponseField& field, const CurveRequest& request) : field_(field), request_(request) {
    if (!(request.second_lower < request.second_upper)) throw std::invalid_argument("a curve over an empty range");
  }

  std::vector<ResponseCurve> run() {
    for (int d = 0; d < request_.diagrams; ++d) {
      response_ = request_.response;
      second_ =
          request_.second_lower + (request_.second_upper - request_.second_lower) * (d + 0.5) / request_.diagrams;
      response_.parameters(request_.second) = second_;
      ResponseDiagram diagram = response_diagram(field_, response_);
      scale_ = diagram.scale;
      if (request_.kind == CurveKind::peak) add_peaks(field_, response_, diagram);
      for (const ResponseBranch& branch : diagram.branches)
        if (request_.kind == CurveKind::peak)
          add_peaks_of(branch);
        else
          add_special(branch);
    }
    return std::move(curves_);
  }

 private:
  bool is_known(const ResponsePoint& point) const {
    return std::any_of(curves_.begin(), curves_.end(),
                       [&](const ResponseCurve& curve) { return passes(curve, point, second_, request_, scale_); });
  }

  void add_special(const ResponseBranch& branch) {
    for (const ResponseSpecial& special : branch.special) {
      if (!is_wanted(request_.kind, special) || is_known(special.at)) continue;
      if (special.source.kind == SpecialKind::branch_point || special.source.kind == SpecialKind::double_zero)
        continue;
      BifurcationCurveOptions options;
      options.first = {response_.parameter, response_.lower, response_.upper, 0};
      options.second = {request_.second, request_.second_lower, request_.second_upper, 0};
      options.state_bound = std::max(8.0, field_.is_blown_up() ? field_.box(1).maxCoeff() : 0.0);
      VectorXd parameters = response_.parameters;
      parameters(response_.parameter) = special.source.at.parameter;
      const BifurcationCurve traced =
          continue_bifurcation(field_.reduced(scale_, response_.parameters), parameters, special.source, options);
      const auto converted = [&](const BifurcationCurvePoint& at) {
        parameters(response_.parameter) = at.first;
        parameters(request_.second) = at.second;
        return ResponseCurvePoint{at.first, at.second, field_.amplitudes(parameters, at.state), at.frequency};
      };
      ResponseCurve curve;
      curve.kind = request_.kind;
      curve.first_end = traced.first_end;
      curve.last_end = traced.last_end;
      curve.closed = traced.closed;
      for (const BifurcationCurvePoint& at : traced.points) curve.points.push_back(converted(at));
      for (const CodimensionTwoPoint& at : traced.special) curve.special.emplace_back(at.kind, converted(at.at));
      curves_.push_back(std::move(curve));
    }
  }

  void add_peaks_of(const ResponseBranch& branch) {
    for (const ResponsePoint& top : branch.points)
      for (const ResponsePeak& peak : top.peaks) {
        const double amplitude = std::abs(top.modes.amplitude[peak.mode]);
        if (amplitude < 1e-3 * scale_ || amplitude < largest_amplitude(top.modes) || is_known(top)) continue;
        const PeakRequest request{response_, request_.second, request_.second_lower, request_.second_upper,
                                  peak.mode, scale_};
        curves_.push_back(peak_curve(field_, request, top));
      }
  }

  const ResponseField& field_;
  const CurveRequest& request_;
  ResponseRequest response_;
  double second_ = 0, scale_ = 1;
  std::vector<ResponseCurve> curves_;
};

}  // namespace

ResponseDiagram response_diagram(const ResponseField& field, const ResponseRequest& request) {
  return CurveSearch(field, request).run();
}

std::vector<ResponseCurve> response_curves(const ResponseField& field, const CurveRequest& request) {
  return Curves(field, request).run();
}

std::vector<BackbonePoint> backbone(const ResponseField& field, const ConstVector& parameters, std::size_t mode,
                                    double largest, int points) {
  if (mode >= field.active().size()) throw std::invalid_argument("a backbone of a mode that does not move");
  const CompiledModel& model = field.model();
  const std::size_t k = field.active()[mode], columns = model.modes() + model.excitations.size();
  double observed = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    const Ratio weight = field.resonance().observed_frequency[k * columns + c];
    if (weight.numerator == 0) continue;
    const std::size_t index = c < model.modes() ? c : model.symbols.size() + c - model.modes();
    observed += static_cast<double>(weight.numerator) / weight.denominator * parameters(static_cast<Index>(index));
  }
  VectorXd undriven = parameters;
  undriven.tail(static_cast<Index>(model.excitations.size())).setZero();
  std::vector<BackbonePoint> curve;
  for (int i = 1; i <= points; ++i) {
    VectorXcd b = VectorXcd::Zero(static_cast<Index>(field.active().size()));
    const double a = largest * i / points;
    b(static_cast<Index>(mode)) = a;
    const Complex rate = field.modulation(undriven, b)(static_cast<Index>(mode)) / a;
    curve.push_back({a, observed + rate.imag(), rate.real()});
  }
  return curve;
}

}  // namespace secular
