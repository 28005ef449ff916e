#include "motion/response/special_points.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/response/augmented_systems.hpp"
#include "motion/response/crossing_tangents.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In scaled unknowns, and as a share of the largest singular value.
constexpr double same_place = 1e-6;

enum Test : std::size_t { fold_test, crossing_test, pair_test };

// det [f_x f_p; tangent'] by its sign, the smallest singular value over the largest as its size: it passes zero
// smoothly and knows its scale.
double crossing_value(const ScaledField& field, const CurvePoint& point) {
  const Index n = field.dimension();
  MatrixXd bordered(n + 1, n + 1);
  bordered << field.jacobian(point.unknowns), point.tangent.transpose();
  if (!bordered.allFinite()) return 0;
  const Eigen::JacobiSVD<MatrixXd> svd(bordered);
  const double largest = svd.singularValues()(0);
  const MatrixXd scaled = bordered / largest;
  return std::copysign(svd.singularValues()(n) / largest, scaled.determinant());
}

double test_value(const ScaledField& field, const CurvePoint& point, std::size_t test) {
  if (test == fold_test) return point.tangent(field.dimension());
  if (test == crossing_test) return crossing_value(field, point);
  return hopf_test(spectrum_of(field.state_jacobian(point.unknowns)));
}

bool changes_sign(const BranchTests& from, const BranchTests& to, std::size_t test) {
  const double a = from.value[test], b = to.value[test];
  return !has_no_sign(a) && !has_no_sign(b) && (a > 0) != (b > 0);
}

// Newton's result if it stayed within `reach` of the bracketed point.
std::optional<VectorXd> near_solution(const EquationSystem& system, const VectorXd& start,
                                      const VectorXd& bracketed, double reach) {
  const NewtonResult result = newton(system, start);
  if (!result.converged() || (result.unknowns.head(bracketed.size()) - bracketed).norm() > reach)
    return std::nullopt;
  return result.unknowns;
}

class Locator {
 public:
  Locator(const ScaledField& field, const EquationSystem& curve, const BranchStep& step)
      : field_(field), curve_(curve), step_(step), reach_((step.to.unknowns - step.from.unknowns).norm()) {}

  std::optional<LocatedPoint> locate(std::size_t test) const {
    const auto value = [&](const CurvePoint& point) { return test_value(field_, point, test); };
    std::optional<CurvePoint> bracketed = zero_between(curve_, step_.from, step_.to, value, 1e-6);
    if (!bracketed) bracketed = step_.from;
    LocatedPoint located;
    located.point = *bracketed;
    if (test == fold_test) {
      LocatedPoint fold = saddle_node(located);
      return is_crossing(fold.point) ? crossing(fold) : fold;
    }
    if (test == crossing_test) return crossing(located);
    return hopf(located);
  }

 private:
  // Where branches cross and one leaves the parameter alone, the tests of both change sign, by rounding in steps
  // that follow one another. With a free phase the test of crossings is zero everywhere, and says nothing.
  bool is_crossing(const CurvePoint& point) const {
    return std::abs(crossing_value(field_, point)) < same_place &&
           !(has_no_sign(step_.before.value[crossing_test]) && has_no_sign(step_.after.value[crossing_test]));
  }

  LocatedPoint saddle_node(LocatedPoint located) const {
    located.special.kind = SpecialKind::saddle_node;
    const Borders borders = null_vectors(field_.state_jacobian(located.point.unknowns));
    const EquationSystem system = with_differences(
        [&](const VectorXd& y) { return fold_equations(field_, y, borders); }, field_.dimension() + 1);
    take(near_solution(system, located.point.unknowns, located.point.unknowns, reach_), located);
    return with_null_vector(located);
  }

  LocatedPoint crossing(LocatedPoint located) const {
    const Index n = field_.dimension();
    const Borders borders = null_vectors(field_.state_jacobian(located.point.unknowns));
    const EquationSystem system =
        with_differences([&](const VectorXd& y) { return branch_point_equations(field_, y, borders); }, n + 2);
    VectorXd start(n + 2);
    start << located.point.unknowns, 0;
    take(near_solution(system, start, located.point.unknowns, reach_), located);
    // Tangents computed there are nobody's: the chord tells which of the two branches this is.
    const VectorXd chord = (step_.to.unknowns - step_.from.unknowns).normalized();
    const CrossingTangents crossing = crossing_tangents(field_, located.point.unknowns, chord);
    located.point.tangent = chord;
    located.special.kind = crossing.kind;
    if (crossing.tangents.size() > 0) {
      located.point.tangent = crossing.tangents.col(0);
      located.special.branches.resize(n + 1, 2);
      for (Index c = 0; c < 2; ++c) located.special.branches.col(c) = field_.direction(crossing.tangents.col(c));
    }
    return with_null_vector(located);
  }

  std::optional<LocatedPoint> hopf(LocatedPoint located) const {
    const Spectrum bracketed = spectrum_of(field_.state_jacobian(located.point.unknowns));
    const EigenvaluePair pair = most_neutral_pair(bracketed);
    const EquationSystem system = with_differences(
        [&](const VectorXd& y) { return hopf_equations(field_, y, pair); }, field_.dimension() + 1);
    take(near_solution(system, located.point.unknowns, located.point.unknowns, reach_), located);
    const Spectrum spectrum = spectrum_of(field_.state_jacobian(located.point.unknowns));
    const double product = most_neutral_pair(spectrum).product;
    const double rate = spectrum.eigenvalues.cwiseAbs().maxCoeff();
    const double zero = 1e-9 * rate * rate;
    if (product < -zero) return std::nullopt;  // a neutral saddle: nothing happens to the motion
    located.special.kind = product > zero ? SpecialKind::hopf : SpecialKind::double_zero;
    located.special.frequency = product > zero ? std::sqrt(product) : 0;
    return located;
  }

  void take(const std::optional<VectorXd>& solution, LocatedPoint& located) const {
    if (!solution) return;
    located.special.polished = true;
    located.point.unknowns = solution->head(field_.unknowns());
    const VectorXd tangent = tangent_at(curve_, located.point.unknowns, located.point.tangent);
    if (tangent.allFinite()) located.point.tangent = tangent;
  }

  LocatedPoint with_null_vector(LocatedPoint located) const {
    located.special.null_vector = null_vectors(field_.state_jacobian(located.point.unknowns)).right;
    return located;
  }

  const ScaledField& field_;
  const EquationSystem& curve_;
  const BranchStep& step_;
  double reach_;
};

}  // namespace

bool are_one(const LocatedPoint& one, const LocatedPoint& other) {
  return (one.point.unknowns - other.point.unknowns).norm() < same_place;
}

bool has_no_sign(double test) {
  return !(std::abs(test) > 1e-9);
}

BranchTests branch_tests(const ScaledField& field, const CurvePoint& point) {
  const Spectrum spectrum = spectrum_of(field.state_jacobian(point.unknowns));
  BranchTests tests;
  tests.value = {test_value(field, point, fold_test), crossing_value(field, point), hopf_test(spectrum)};
  tests.unstable = spectrum.unstable;
  return tests;
}

bool explained(const BranchTests& from, const BranchTests& to) {
  const int single = (changes_sign(from, to, fold_test) ? 1 : 0) + (changes_sign(from, to, crossing_test) ? 1 : 0);
  const int pairs = changes_sign(from, to, pair_test) ? 1 : 0;
  const int change = std::abs(to.unstable - from.unstable);
  return change <= single + 2 * pairs;
}

std::vector<LocatedPoint> special_points_between(const ScaledField& field, const EquationSystem& curve,
                                                 const BranchStep& step) {
  const Locator locator(field, curve, step);
  const auto turns_back = [&](const LocatedPoint& other) {
    return other.special.kind == SpecialKind::pitchfork &&
           std::abs(other.point.tangent(field.dimension())) < same_place;
  };
  std::vector<LocatedPoint> found;
  for (const std::size_t test : {crossing_test, fold_test, pair_test}) {
    if (!changes_sign(step.before, step.after, test)) continue;
    // Along the branch of a pitchfork that leaves the parameter alone, the saddle-node test changes sign with the
    // other one: that is one point.
    if (test == fold_test && std::any_of(found.begin(), found.end(), turns_back)) continue;
    std::optional<LocatedPoint> located = locator.locate(test);
    if (!located) continue;
    // Where a continuous symmetry keeps one eigenvalue zero, a saddle-node is a double zero too.
    const auto same = [&](const LocatedPoint& other) { return are_one(other, *located); };
    if (located->special.kind == SpecialKind::double_zero && std::any_of(found.begin(), found.end(), same))
      continue;
    found.push_back(std::move(*located));
  }
  const VectorXd chord = step.to.unknowns - step.from.unknowns;
  std::sort(found.begin(), found.end(), [&](const LocatedPoint& a, const LocatedPoint& b) {
    return chord.dot(a.point.unknowns) < chord.dot(b.point.unknowns);
  });
  return found;
}

}  // namespace secular
