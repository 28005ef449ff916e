#include "motion/response/bifurcation_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "motion/response/fixed_points.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

class DiagramSearch {
 public:
  DiagramSearch(const VectorField& field, const ConstVector& parameters, Index parameter,
                const DiagramOptions& options)
      : field_(field), parameters_(parameters), parameter_(parameter), options_(options) {
    scale_.resize(field.dimension() + 1);
    const ContinuationOptions& continuation = options.continuation;
    const double length =
        continuation.parameter_scale > 0 ? continuation.parameter_scale : continuation.upper - continuation.lower;
    scale_ << field.typical_state(), length;
  }

  BifurcationDiagram run() {
    FixedPointOptions search;
    search.lower = options_.lower;
    search.upper = options_.upper;
    for (const double value : options_.starts_at) {
      VectorXd parameters = parameters_;
      parameters(parameter_) = value;
      const FixedPoints found = find_fixed_points(field_, parameters, search);
      if (found.status != FixedPointStatus::nothing_new) {
        result_.status = DiagramStatus::search_limit;
        result_.reason = found.reason;
      }
      if (found.status == FixedPointStatus::root_limit) return std::move(result_);
      for (const FixedPoint& start : found.points) {
        if (covered(start.state, value)) continue;
        if (at_limit()) return std::move(result_);
        Branch branch = continue_fixed_points(field_, parameters, parameter_, start.state, options_.continuation);
        if (branch.points.empty()) continue;
        if (!add(std::move(branch))) return std::move(result_);
      }
    }
    if (result_.status == DiagramStatus::complete) result_.reason = "every start and every crossing was followed";
    return std::move(result_);
  }

 private:
  bool at_limit() {
    if (static_cast<int>(result_.branches.size()) < options_.branch_limit) return false;
    result_.status = DiagramStatus::branch_limit;
    result_.reason = "as many branches as allowed";
    return true;
  }

  VectorXd scaled(const VectorXd& state, double value) const {
    VectorXd point(scale_.size());
    point << state, value;
    return point.cwiseQuotient(scale_);
  }

  // Whether a branch passes this fixed point, as far as its chords tell.
  bool covered(const VectorXd& state, double value) const {
    const VectorXd point = scaled(state, value);
    for (const Branch& branch : result_.branches)
      for (std::size_t i = 1; i < branch.points.size(); ++i) {
        const VectorXd from = scaled(branch.points[i - 1].state, branch.points[i - 1].parameter);
        const VectorXd chord = scaled(branch.points[i].state, branch.points[i].parameter) - from;
        const double length = chord.norm();
        if (!(length > 0)) continue;
        const double share = std::clamp(chord.dot(point - from) / (length * length), 0.0, 1.0);
        // An arc leaves its chord by an eighth of length * turn.
        const double sag = 0.125 * length * 3 * options_.continuation.steps.turn + 1e-9;
        if ((from + share * chord - point).norm() < sag) return true;
      }
    return false;
  }

  // Whether a branch passes the crossing along the direction that it has for the other branch.
  bool crossed(const SpecialPoint& crossing) const {
    const VectorXd at = scaled(crossing.at.state, crossing.at.parameter);
    const VectorXd across = crossing.branches.col(1).cwiseQuotient(scale_).normalized();
    for (const Branch& branch : result_.branches)
      for (const SpecialPoint& special : branch.special) {
        if (special.branches.size() == 0) continue;
        if ((scaled(special.at.state, special.at.parameter) - at).norm() > 1e-6) continue;
        if (std::abs(special.branches.col(0).cwiseQuotient(scale_).normalized().dot(across)) > 1 - 1e-4)
          return true;
      }
    return false;
  }

  // Adds the branch and, one after the other, those that cross it; false at the limit.
  bool add(Branch first) {
    result_.branches.push_back(std::move(first));
    for (std::size_t b = result_.branches.size() - 1; b < result_.branches.size(); ++b)
      for (std::size_t s = 0; s < result_.branches[b].special.size(); ++s) {
        const SpecialPoint crossing = result_.branches[b].special[s];
        if (crossing.branches.size() == 0 || crossed(crossing)) continue;
        if (at_limit()) return false;
        Branch other = switch_branch(field_, parameters_, parameter_, crossing, options_.continuation);
        if (!other.points.empty()) result_.branches.push_back(std::move(other));
      }
    return true;
  }

  const VectorField& field_;
  VectorXd parameters_;
  Index parameter_;
  const DiagramOptions& options_;
  VectorXd scale_;
  BifurcationDiagram result_;
};

}  // namespace

BifurcationDiagram bifurcation_diagram(const VectorField& field, const ConstVector& parameters, Index parameter,
                                       const DiagramOptions& options) {
  if (parameters.size() != field.parameter_count() || parameter < 0 || parameter >= parameters.size())
    throw std::invalid_argument("a diagram in a parameter that the vector field does not have");
  if (options.branch_limit < 1) throw std::invalid_argument("a limit of branches below 1");
  return DiagramSearch(field, parameters, parameter, options).run();
}

}  // namespace secular
