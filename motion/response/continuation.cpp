#include "motion/response/continuation.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "motion/response/crossing_tangents.hpp"
#include "motion/response/scaled_field.hpp"
#include "motion/response/special_points.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

struct PlacedPoint {
  std::size_t segment = 0;  // between points segment and segment + 1
  LocatedPoint located;
};

// One direction from the start: its points (the start first) and the special points between them.
struct Run {
  std::vector<CurvePoint> points;
  std::vector<PlacedPoint> special;
  TraceEnd end;
};

void reverse(CurvePoint& point) {
  point.tangent = -point.tangent;
}

void reverse(LocatedPoint& located) {
  reverse(located.point);
  if (located.special.branches.size() > 0) located.special.branches.col(0) *= -1;
}

Branch no_branch(Index parameter, const std::string& reason) {
  Branch none;
  none.parameter = parameter;
  none.first_end = none.last_end = {TraceStatus::no_start, reason};
  return none;
}

class BranchTracer {
 public:
  BranchTracer(const ScaledField& field, Index parameter, const ContinuationOptions& options)
      : field_(field), parameter_(parameter), options_(options) {
    curve_.value = [this](const VectorXd& y) { return field_.rate(y); };
    curve_.jacobian = [this](const VectorXd& y) { return field_.jacobian(y); };
    const Index n = field_.dimension();
    const double half = 0.5 * (options_.upper - options_.lower) / scale_of(options_);
    bounds_.push_back({n, -half, half, TraceStatus::parameter_bound, "the parameter"});
    if (std::isfinite(options_.state_bound))
      for (Index i = 0; i < n; ++i)
        bounds_.push_back({i, -options_.state_bound, options_.state_bound, TraceStatus::state_bound,
                           "state " + std::to_string(i)});
  }
  BranchTracer(const BranchTracer&) = delete;
  BranchTracer& operator=(const BranchTracer&) = delete;

  static double scale_of(const ContinuationOptions& options) {
    return options.parameter_scale > 0 ? options.parameter_scale : options.upper - options.lower;
  }

  // The tangent at a start that may itself be a special point, towards larger parameters.
  VectorXd start_tangent(const VectorXd& unknowns) const {
    const Index n = field_.dimension();
    const Eigen::JacobiSVD<MatrixXd> svd(field_.jacobian(unknowns), Eigen::ComputeFullV);
    VectorXd tangent = svd.matrixV().col(n);
    if (svd.singularValues()(n - 1) <= 1e-7 * svd.singularValues()(0)) {
      const CrossingTangents crossing = crossing_tangents(field_, unknowns, VectorXd::Unit(n + 1, n));
      // Without two separate directions: the one across whatever family of fixed points this is in.
      tangent = crossing.tangents.size() > 0 ? VectorXd(crossing.tangents.col(0))
                                             : tangent_at(curve_, unknowns, VectorXd::Unit(n + 1, n));
    }
    return tangent(n) < 0 ? VectorXd(-tangent) : tangent;
  }

  Branch trace(const CurvePoint& start) {
    for (const CurveBound& bound : bounds_) {
      const double value = start.unknowns(bound.coordinate), slack = 1e-9;
      if (value < bound.lower - slack || value > bound.upper + slack)
        return no_branch(parameter_, "the fixed point near the start is out of bounds: " + bound.name);
    }
    Run ahead = run(start);
    Branch branch;
    branch.closed = ahead.end.status == TraceStatus::closed_loop;
    Run back;
    if (branch.closed) {
      back.points = {start};
      back.end = ahead.end;
    } else {
      CurvePoint reversed = start;
      reverse(reversed);
      back = run(reversed);
    }
    join(ahead, back, branch.closed);
    assemble(ahead, back, branch);
    return branch;
  }

 private:
  Run run(const CurvePoint& start) const {
    Run run;
    run.points.push_back(start);
    BranchTests before = branch_tests(field_, start);
    int shortened = 0;
    const StepVisitor visit = [&](const CurvePoint& from, const CurvePoint& to, bool may_shorten, TraceEnd&) {
      const BranchTests after = branch_tests(field_, to);
      bool on_top = false;  // of a special point: nothing could be told from signs
      for (std::size_t test = 0; test < after.value.size(); ++test)
        on_top = on_top || (has_no_sign(after.value[test]) && !has_no_sign(before.value[test]));
      if (may_shorten && ((on_top && shortened < 4) || !explained(before, after))) {
        ++shortened;
        return Visit::shorten;
      }
      shortened = 0;
      for (LocatedPoint& located : special_points_between(field_, curve_, {from, to, before, after}))
        if (run.special.empty() || !are_one(run.special.back().located, located))
          run.special.push_back({run.points.size() - 1, std::move(located)});
      before = after;
      run.points.push_back(to);
      return Visit::accept;
    };
    run.end = trace_curve(curve_, start, bounds_, options_.steps, visit);
    return run;
  }

  // The start may itself be a special point: looks across it.
  void join(Run& ahead, Run& back, bool closed) const {
    if (closed && ahead.special.size() > 1 && are_one(ahead.special.front().located, ahead.special.back().located))
      ahead.special.pop_back();
    if (ahead.points.size() < 3 || (!closed && back.points.size() < 2)) return;
    CurvePoint before = closed ? ahead.points[ahead.points.size() - 2] : back.points[1];
    if (!closed) reverse(before);
    const BranchTests tests = branch_tests(field_, ahead.points.front());
    if (std::none_of(tests.value.begin(), tests.value.end(), has_no_sign)) return;
    const BranchStep across{before, ahead.points[1], branch_tests(field_, before),
                            branch_tests(field_, ahead.points[1])};
    for (LocatedPoint& located : special_points_between(field_, curve_, across)) {
      const auto same = [&](const PlacedPoint& other) { return are_one(other.located, located); };
      if (std::any_of(ahead.special.begin(), ahead.special.end(), same)) continue;
      if (std::any_of(back.special.begin(), back.special.end(), same)) continue;
      ahead.special.insert(ahead.special.begin(), PlacedPoint{0, std::move(located)});
    }
  }

  Equilibrium equilibrium(const CurvePoint& point, double arclength) const {
    const Spectrum spectrum = spectrum_of(field_.state_jacobian(point.unknowns));
    return {field_.state(point.unknowns),
            field_.parameters(point.unknowns)(parameter_),
            arclength,
            field_.direction(point.tangent),
            spectrum.eigenvalues,
            spectrum.unstable};
  }

  void assemble(const Run& ahead, const Run& back, Branch& branch) const {
    branch.parameter = parameter_;
    branch.first_end = back.end;
    branch.last_end = ahead.end;
    const std::size_t offset = back.points.size() - 1;
    std::vector<CurvePoint> points(back.points.rbegin(), back.points.rend());
    for (CurvePoint& point : points) reverse(point);
    points.insert(points.end(), ahead.points.begin() + 1, ahead.points.end());
    std::vector<double> arclength(points.size(), 0);
    for (std::size_t i = 1; i < points.size(); ++i)
      arclength[i] = arclength[i - 1] + (points[i].unknowns - points[i - 1].unknowns).norm();
    for (std::size_t i = 0; i < points.size(); ++i) branch.points.push_back(equilibrium(points[i], arclength[i]));
    const auto place = [&](LocatedPoint located, std::size_t segment) {
      const double into = (located.point.unknowns - points[segment].unknowns).norm();
      located.special.at = equilibrium(located.point, arclength[segment] + into);
      branch.special.push_back(std::move(located.special));
    };
    for (auto special = back.special.rbegin(); special != back.special.rend(); ++special) {
      LocatedPoint located = special->located;
      reverse(located);
      place(std::move(located), offset - 1 - special->segment);
    }
    for (const PlacedPoint& special : ahead.special) place(special.located, offset + special.segment);
    std::stable_sort(branch.special.begin(), branch.special.end(),
                     [](const SpecialPoint& a, const SpecialPoint& b) { return a.at.arclength < b.at.arclength; });
  }

  const ScaledField& field_;
  Index parameter_;
  const ContinuationOptions& options_;
  EquationSystem curve_;
  std::vector<CurveBound> bounds_;
};

void check(const VectorField& field, const ConstVector& parameters, Index parameter, const ConstVector& state,
           const ContinuationOptions& options) {
  field.check(state, parameters);
  if (parameter < 0 || parameter >= field.parameter_count())
    throw std::invalid_argument("continuation in a parameter that the vector field does not have");
  if (!(options.lower < options.upper) || !std::isfinite(options.lower) || !std::isfinite(options.upper) ||
      !(options.state_bound > 0) || !(options.parameter_scale >= 0))
    throw std::invalid_argument("bounds of a continuation: lower < upper, both finite; the others not negative");
  check_steps(options.steps);
}

ScaledField scaled(const VectorField& field, const ConstVector& parameters, Index parameter,
                   const ContinuationOptions& options) {
  return {field, parameters, {{parameter, 0.5 * (options.lower + options.upper), BranchTracer::scale_of(options)}}};
}

}  // namespace

Branch continue_fixed_points(const VectorField& field, const ConstVector& parameters, Index parameter,
                             const ConstVector& state, const ContinuationOptions& options) {
  check(field, parameters, parameter, state, options);
  if (parameters(parameter) < options.lower || parameters(parameter) > options.upper)
    throw std::invalid_argument("a continuation starts outside of its bounds");
  const ScaledField scaled_field = scaled(field, parameters, parameter, options);
  const VectorXd guess = scaled_field.unknowns_at(state, parameters);
  EquationSystem curve;
  curve.value = [&](const VectorXd& y) { return scaled_field.rate(y); };
  curve.jacobian = [&](const VectorXd& y) { return scaled_field.jacobian(y); };
  const NewtonResult start = correct(curve, guess, VectorXd::Unit(guess.size(), field.dimension()));
  if (!start.converged()) {
    return no_branch(parameter, "no fixed point near the start");
  }
  BranchTracer tracer(scaled_field, parameter, options);
  return tracer.trace({start.unknowns, tracer.start_tangent(start.unknowns)});
}

Branch switch_branch(const VectorField& field, const ConstVector& parameters, Index parameter,
                     const SpecialPoint& crossing, const ContinuationOptions& options) {
  check(field, parameters, parameter, crossing.at.state, options);
  if (crossing.branches.rows() != field.dimension() + 1 || crossing.branches.cols() != 2)
    throw std::invalid_argument("branches are switched at pitchforks and transcritical points");
  const ScaledField scaled_field = scaled(field, parameters, parameter, options);
  VectorXd at = parameters;
  at(parameter) = crossing.at.parameter;
  const VectorXd across = scaled_field.scaled_direction(crossing.branches.col(1));
  BranchTracer tracer(scaled_field, parameter, options);
  return tracer.trace({scaled_field.unknowns_at(crossing.at.state, at), across / across.norm()});
}

}  // namespace secular
