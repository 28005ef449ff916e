#include "motion/response/curve_tracer.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

// The bound that the step leaves first, and the share of the step up to it.
struct Crossing {
  const CurveBound* bound = nullptr;
  double share = 1, value = 0;
};

Crossing first_crossing(const std::vector<CurveBound>& bounds, const VectorXd& from, const VectorXd& to) {
  Crossing first;
  for (const CurveBound& bound : bounds) {
    const double begin = from(bound.coordinate), end = to(bound.coordinate);
    if (end >= bound.lower && end <= bound.upper) continue;
    const double value = end < bound.lower ? bound.lower : bound.upper;
    const double share = std::clamp((value - begin) / (end - begin), 0.0, 1.0);
    if (first.bound == nullptr || share < first.share) first = {&bound, share, value};
  }
  return first;
}

std::optional<CurvePoint> point_on_bound(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to,
                                         const Crossing& crossing) {
  VectorXd guess = from.unknowns + crossing.share * (to.unknowns - from.unknowns);
  guess(crossing.bound->coordinate) = crossing.value;
  const VectorXd normal = VectorXd::Unit(guess.size(), crossing.bound->coordinate);
  const NewtonResult corrected = correct(curve, guess, normal);
  if (!corrected.converged()) return std::nullopt;
  const double length = (to.unknowns - from.unknowns).norm();
  if ((corrected.unknowns - guess).norm() > 0.3 * length) return std::nullopt;
  CurvePoint point{corrected.unknowns, tangent_at(curve, corrected.unknowns, to.tangent)};
  point.unknowns(crossing.bound->coordinate) = crossing.value;
  return point;
}

// Whether branches may cross there: [J; tangent'] is singular.
bool is_crossing(const EquationSystem& curve, const CurvePoint& point) {
  const MatrixXd equations = curve.jacobian(point.unknowns);
  MatrixXd bordered(equations.rows() + 1, equations.cols());
  bordered << equations, point.tangent.transpose();
  if (!bordered.allFinite()) return true;
  const VectorXd singular = Eigen::JacobiSVD<MatrixXd>(bordered).singularValues();
  return singular(singular.size() - 1) < 1e-6 * singular(0);
}

// Whether the step passes the start again, in the direction in which it was left. At a crossing Newton's method
// might lead along the other branch: there the chord decides, which an arc leaves by an eighth of length * turn.
bool passes(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to, const CurvePoint& start,
            bool start_is_crossing) {
  const double before = start.tangent.dot(from.unknowns - start.unknowns);
  const double after = start.tangent.dot(to.unknowns - start.unknowns);
  const VectorXd chord = to.unknowns - from.unknowns;
  if (before >= 0 || after < 0 || (to.unknowns - start.unknowns).norm() > 2 * chord.norm()) return false;
  if (to.tangent.dot(start.tangent) < 0.8) return false;
  const VectorXd guess = from.unknowns + before / (before - after) * chord;
  if (start_is_crossing) return (guess - start.unknowns).norm() < 0.05 * chord.norm() + 1e-9;
  const NewtonResult corrected = correct(curve, guess, start.tangent);
  return corrected.converged() && (corrected.unknowns - start.unknowns).norm() < 1e-5;
}

class Tracer {
 public:
  Tracer(const EquationSystem& curve, const CurvePoint& start, const std::vector<CurveBound>& bounds,
         const StepOptions& options, const StepVisitor& visit)
      : curve_(curve),
        start_(start),
        bounds_(bounds),
        options_(options),
        visit_(visit),
        start_is_crossing_(is_crossing(curve, start)) {}

  TraceEnd run() {
    CurvePoint now = start_;
    step_ = options_.first;
    if (const Crossing at_once = first_crossing(bounds_, now.unknowns, now.unknowns + options_.least * now.tangent);
        at_once.bound != nullptr)
      return {at_once.bound->status, at_once.bound->name + " is at its bound"};
    for (int points = 1; points < options_.point_limit;) {
      const std::optional<CurvePoint> ahead = predict_and_correct(now);
      if (!ahead) {
        if (step_ <= options_.least) return {TraceStatus::step_too_small, "no solution at the smallest step"};
        step_ = std::max(step_ / 2, options_.least);
        continue;
      }
      CurvePoint next = *ahead;
      TraceEnd end;
      bool ends = false;
      if (const Crossing crossing = first_crossing(bounds_, now.unknowns, next.unknowns);
          crossing.bound != nullptr) {
        const std::optional<CurvePoint> last = point_on_bound(curve_, now, next, crossing);
        if (!last && step_ > options_.least) {
          step_ = std::max(step_ / 2, options_.least);
          continue;
        }
        ends = true;
        end = {crossing.bound->status, crossing.bound->name + " reached its bound"};
        if (!last) return end;
        next = *last;
      } else if (points > 2 && passes(curve_, now, next, start_, start_is_crossing_)) {
        ends = true;
        end = {TraceStatus::closed_loop, "the curve closes"};
        next = start_;
      }
      const bool may_shorten = step_ > 4 * options_.least && shortened_ < 12;
      const Visit verdict = visit_(now, next, may_shorten, end);
      if (verdict == Visit::shorten && may_shorten) {
        step_ = std::max(0.45 * step_, options_.least);
        ++shortened_;
        continue;
      }
      if (verdict == Visit::stop || ends) return end;
      adapt(now, next);
      shortened_ = 0;
      now = next;
      ++points;
    }
    return {TraceStatus::point_limit, "as many points as allowed"};
  }

 private:
  std::optional<CurvePoint> predict_and_correct(const CurvePoint& now) {
    const VectorXd guess = now.unknowns + step_ * now.tangent;
    const NewtonResult corrected = correct(curve_, guess, now.tangent);
    iterations_ = corrected.iterations;
    if (!corrected.converged()) return std::nullopt;
    if ((corrected.unknowns - guess).norm() > 0.3 * step_ + 1e-10) return std::nullopt;
    CurvePoint next{corrected.unknowns, tangent_at(curve_, corrected.unknowns, now.tangent)};
    if (!next.tangent.allFinite()) return std::nullopt;
    if (next.tangent.dot(now.tangent) < std::cos(3 * options_.turn)) return std::nullopt;
    return next;
  }

  void adapt(const CurvePoint& now, const CurvePoint& next) {
    const double turn = std::acos(std::clamp(next.tangent.dot(now.tangent), -1.0, 1.0));
    const double by_turn = options_.turn / std::max(turn, 1e-3);
    const double by_effort = 5.0 / std::max(iterations_, 1);
    step_ =
        std::clamp(step_ * std::clamp(std::min(by_turn, by_effort), 0.5, 1.6), options_.least, options_.largest);
  }

  const EquationSystem& curve_;
  const CurvePoint& start_;
  const std::vector<CurveBound>& bounds_;
  const StepOptions& options_;
  const StepVisitor& visit_;
  bool start_is_crossing_;
  double step_ = 0;
  int iterations_ = 0, shortened_ = 0;
};

}  // namespace

NewtonResult correct(const EquationSystem& curve, const ConstVector& guess, const ConstVector& normal) {
  const VectorXd origin = guess, direction = normal;
  EquationSystem square;
  square.value = [&](const VectorXd& y) {
    const VectorXd equations = curve.value(y);
    VectorXd value(equations.size() + 1);
    value << equations, direction.dot(y - origin);
    return value;
  };
  square.jacobian = [&](const VectorXd& y) {
    const MatrixXd equations = curve.jacobian(y);
    MatrixXd jacobian(equations.rows() + 1, equations.cols());
    jacobian << equations, direction.transpose();
    return jacobian;
  };
  return newton(square, origin);
}

VectorXd tangent_at(const EquationSystem& curve, const ConstVector& unknowns, const ConstVector& reference) {
  const MatrixXd equations = curve.jacobian(unknowns);
  MatrixXd bordered(equations.rows() + 1, equations.cols());
  bordered << equations, reference.transpose();
  const VectorXd tangent = newton_step(bordered, -VectorXd::Unit(bordered.rows(), equations.rows()));
  return tangent / tangent.norm();
}

std::optional<CurvePoint> point_between(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to,
                                        double share) {
  const VectorXd chord = to.unknowns - from.unknowns;
  const double length = chord.norm();
  if (!(length > 0)) return std::nullopt;
  const VectorXd normal = chord / length;
  const NewtonResult corrected = correct(curve, from.unknowns + share * chord, normal);
  if (!corrected.converged() || (corrected.unknowns - from.unknowns - share * chord).norm() > length)
    return std::nullopt;
  return CurvePoint{corrected.unknowns, tangent_at(curve, corrected.unknowns, normal)};
}

std::optional<CurvePoint> zero_between(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to,
                                       const std::function<double(const CurvePoint&)>& test, double tolerance) {
  double low = 0, high = 1, at_low = test(from), at_high = test(to);
  std::optional<CurvePoint> best;
  for (int iteration = 0; iteration < 80 && high - low > tolerance; ++iteration) {
    // Every fourth step halves the bracket: a test function with a jump must not stall it.
    const double secant = low - at_low * (high - low) / (at_high - at_low);
    const bool halve = iteration % 4 == 3 || !(secant > low && secant < high);
    const double share = halve ? 0.5 * (low + high) : secant;
    const std::optional<CurvePoint> point = point_between(curve, from, to, share);
    if (!point) break;
    const double value = test(*point);
    if (!std::isfinite(value)) break;
    best = point;
    if (value == 0) break;
    if (std::signbit(value) == std::signbit(at_low)) {
      low = share;
      at_low = value;
      at_high /= 2;
    } else {
      high = share;
      at_high = value;
      at_low /= 2;
    }
  }
  return best;
}

TraceEnd trace_curve(const EquationSystem& curve, const CurvePoint& start, const std::vector<CurveBound>& bounds,
                     const StepOptions& options, const StepVisitor& visit) {
  return Tracer(curve, start, bounds, options, visit).run();
}

void check_steps(const StepOptions& options) {
  if (!(options.least > 0) || !(options.first >= options.least) || !(options.largest >= options.first) ||
      !(options.turn > 0 && options.turn < 0.5) || options.point_limit < 2)
    throw std::invalid_argument("steps of a continuation: 0 < least <= first <= largest, turn in (0, 0.5) rad");
}

}  // namespace secular
