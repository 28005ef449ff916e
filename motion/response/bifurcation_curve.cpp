#include "motion/response/bifurcation_curve.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "motion/response/augmented_systems.hpp"
#include "motion/response/differences.hpp"
#include "motion/response/scaled_field.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

double length_of(const ParameterRange& range) {
  return range.scale > 0 ? range.scale : range.upper - range.lower;
}

BifurcationKind kind_of(SpecialKind kind) {
  switch (kind) {
    case SpecialKind::saddle_node:
      return BifurcationKind::saddle_node;
    case SpecialKind::pitchfork:
    case SpecialKind::transcritical:
      return BifurcationKind::branch_point;
    case SpecialKind::hopf:
      return BifurcationKind::hopf;
    case SpecialKind::branch_point:
    case SpecialKind::double_zero:
      break;
  }
  throw std::invalid_argument("no curve in two parameters starts at a " + std::string(in_words(kind)));
}

class CurveOfBifurcations {
 public:
  CurveOfBifurcations(const ScaledField& field, BifurcationKind kind, const BifurcationCurveOptions& options)
      : field_(field), options_(options) {
    result_.kind = kind;
    const Index n = field_.dimension();
    const Index equations = kind == BifurcationKind::branch_point ? n + 2 : n + 1;
    curve_ = with_differences([this](const VectorXd& y) { return residual(y); }, equations);
    add_bound(options_.first, n, "the first parameter");
    add_bound(options_.second, n + 1, "the second parameter");
    if (std::isfinite(options_.state_bound))
      for (Index i = 0; i < n; ++i)
        bounds_.push_back({i, -options_.state_bound, options_.state_bound, TraceStatus::state_bound,
                           "state " + std::to_string(i)});
  }
  CurveOfBifurcations(const CurveOfBifurcations&) = delete;
  CurveOfBifurcations& operator=(const CurveOfBifurcations&) = delete;

  BifurcationCurve trace(const VectorXd& near) {
    const bool with_beta = result_.kind == BifurcationKind::branch_point;
    VectorXd unknowns = VectorXd::Zero(near.size() + (with_beta ? 1 : 0));
    unknowns.head(near.size()) = near;
    const MatrixXd jacobian = field_.state_jacobian(near);
    borders_ = null_vectors(jacobian);
    if (result_.kind == BifurcationKind::hopf) pair_ = most_neutral_pair(spectrum_of(jacobian));
    const VectorXd along = null_direction(unknowns);
    const NewtonResult start = correct(curve_, unknowns, along);
    if (!start.converged() || (result_.kind == BifurcationKind::hopf && !(pair_at(start.unknowns).product > 0))) {
      result_.first_end = result_.last_end = {TraceStatus::no_start, "no such bifurcation near the start"};
      return std::move(result_);
    }
    const CurvePoint first{start.unknowns, null_direction(start.unknowns)};
    std::vector<BifurcationCurvePoint> ahead = run(first, result_.last_end);
    result_.closed = result_.last_end.status == TraceStatus::closed_loop;
    result_.first_end = result_.last_end;
    if (!result_.closed) {
      const std::vector<BifurcationCurvePoint> back = run({first.unknowns, -first.tangent}, result_.first_end);
      result_.points.assign(back.rbegin(), back.rend());
    }
    result_.points.push_back(point_at(first.unknowns));
    result_.points.insert(result_.points.end(), ahead.begin(), ahead.end());
    return std::move(result_);
  }

 private:
  void add_bound(const ParameterRange& range, Index coordinate, const char* name) {
    const double half = 0.5 * (range.upper - range.lower) / length_of(range);
    bounds_.push_back({coordinate, -half, half, TraceStatus::parameter_bound, name});
  }

  VectorXd residual(const VectorXd& y) const {
    if (result_.kind == BifurcationKind::saddle_node) return fold_equations(field_, y, borders_);
    if (result_.kind == BifurcationKind::branch_point) return branch_point_equations(field_, y, borders_);
    return hopf_equations(field_, y, pair_);
  }

  VectorXd null_direction(const VectorXd& y) const {
    const MatrixXd jacobian = curve_.jacobian(y);
    if (!jacobian.allFinite()) return VectorXd::Unit(y.size(), 0);
    const Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeFullV);
    return svd.matrixV().col(y.size() - 1);
  }

  VectorXd field_unknowns(const VectorXd& y) const { return y.head(field_.unknowns()); }

  EigenvaluePair pair_at(const VectorXd& y) const {
    return nearest_pair(spectrum_of(field_.state_jacobian(field_unknowns(y))), {0, pair_.product});
  }

  BifurcationCurvePoint point_at(const VectorXd& y) const {
    const VectorXd unknowns = field_unknowns(y), parameters = field_.parameters(unknowns);
    BifurcationCurvePoint point;
    point.state = field_.state(unknowns);
    point.first = parameters(options_.first.parameter);
    point.second = parameters(options_.second.parameter);
    point.eigenvalues = spectrum_of(field_.state_jacobian(unknowns)).eigenvalues;
    if (result_.kind == BifurcationKind::hopf) point.frequency = std::sqrt(std::max(pair_at(y).product, 0.0));
    return point;
  }

  // Vanishes at the codimension-two point of this kind.
  double test(CodimensionTwo kind, const VectorXd& y) const {
    if (result_.kind == BifurcationKind::hopf) return pair_at(y).product;
    const VectorXd unknowns = field_unknowns(y);
    const BorderedSolution bordered = solve_bordered(field_.state_jacobian(unknowns), borders_);
    if (kind == CodimensionTwo::bogdanov_takens) return bordered.left.dot(bordered.right);
    VectorXd direction = VectorXd::Zero(unknowns.size());
    direction.head(field_.dimension()) = bordered.right;
    const auto rate = [this](const VectorXd& at) { return field_.rate(at); };
    return bordered.left.dot(second_difference(rate, unknowns, direction));
  }

  // Whether one was found.
  bool look_for(CodimensionTwo kind, const CurvePoint& from, const CurvePoint& to) {
    const double before = test(kind, from.unknowns), after = test(kind, to.unknowns);
    if (!(std::abs(before) > 0) || !std::isfinite(after) || std::signbit(before) == std::signbit(after))
      return false;
    const auto value = [&](const CurvePoint& point) { return test(kind, point.unknowns); };
    const std::optional<CurvePoint> located = zero_between(curve_, from, to, value, 1e-13);
    if (!located) return false;
    result_.special.push_back({kind, point_at(located->unknowns)});
    return true;
  }

  std::vector<BifurcationCurvePoint> run(const CurvePoint& start, TraceEnd& end) {
    std::vector<BifurcationCurvePoint> points;
    renew(start.unknowns);
    const StepVisitor visit = [&](const CurvePoint& from, const CurvePoint& to, bool, TraceEnd& why) {
      if (result_.kind == BifurcationKind::hopf && look_for(CodimensionTwo::bogdanov_takens, from, to)) {
        points.push_back(result_.special.back().at);
        why = {TraceStatus::special_end, "the frequency reaches zero"};
        return Visit::stop;
      }
      if (result_.kind == BifurcationKind::saddle_node) {
        look_for(CodimensionTwo::cusp, from, to);
        if (field_.dimension() > 1) look_for(CodimensionTwo::bogdanov_takens, from, to);
      }
      if (result_.kind == BifurcationKind::branch_point && std::abs(to.unknowns(to.unknowns.size() - 1)) > 1e-7) {
        why = {TraceStatus::not_persistent, "the second parameter unfolds the branch point"};
        return Visit::stop;
      }
      points.push_back(point_at(to.unknowns));
      renew(to.unknowns);
      return Visit::accept;
    };
    end = trace_curve(curve_, start, bounds_, options_.steps, visit);
    return points;
  }

  // Borders (or the pair) of the latest point; the curve does not depend on them.
  void renew(const VectorXd& y) {
    if (result_.kind == BifurcationKind::hopf) {
      pair_ = pair_at(y);
    } else {
      const Borders previous = borders_;
      borders_ = null_vectors(field_.state_jacobian(field_unknowns(y)), &previous);
    }
  }

  const ScaledField& field_;
  const BifurcationCurveOptions& options_;
  EquationSystem curve_;
  std::vector<CurveBound> bounds_;
  Borders borders_;
  EigenvaluePair pair_;
  BifurcationCurve result_;
};

void check(const VectorField& field, const ConstVector& parameters, const SpecialPoint& start,
           const BifurcationCurveOptions& options) {
  field.check(start.at.state, parameters);
  for (const ParameterRange* range : {&options.first, &options.second}) {
    if (range->parameter < 0 || range->parameter >= field.parameter_count())
      throw std::invalid_argument("a curve in a parameter that the vector field does not have");
    if (!(range->lower < range->upper) || !std::isfinite(range->lower) || !std::isfinite(range->upper) ||
        !(range->scale >= 0))
      throw std::invalid_argument("ranges of a curve in two parameters: lower < upper, both finite");
    const double value = parameters(range->parameter);
    if (value < range->lower || value > range->upper)
      throw std::invalid_argument("a curve in two parameters starts outside of its ranges");
  }
  if (options.first.parameter == options.second.parameter)
    throw std::invalid_argument("a curve in two parameters needs two of them");
  if (!(options.state_bound > 0)) throw std::invalid_argument("a bound of the states that is not positive");
  check_steps(options.steps);
}

}  // namespace

BifurcationCurve continue_bifurcation(const VectorField& field, const ConstVector& parameters,
                                      const SpecialPoint& start, const BifurcationCurveOptions& options) {
  check(field, parameters, start, options);
  const auto free = [](const ParameterRange& range) {
    return FreeParameter{range.parameter, 0.5 * (range.lower + range.upper), length_of(range)};
  };
  const ScaledField scaled(field, parameters, {free(options.first), free(options.second)});
  CurveOfBifurcations curve(scaled, kind_of(start.kind), options);
  return curve.trace(scaled.unknowns_at(start.at.state, parameters));
}

}  // namespace secular
