#pragma once

#include <Eigen/Core>
#include <string_view>

namespace secular {

/// Special points of a branch of fixed points in one parameter.
enum class SpecialKind {
  saddle_node,    ///< the branch turns back in the parameter; one eigenvalue passes zero
  pitchfork,      ///< two branches cross, one of them without a first-order change of the parameter
  transcritical,  ///< two branches cross, the parameter changes along both
  branch_point,   ///< branches meet, with more than one zero eigenvalue or tangents that do not separate
  hopf,           ///< a complex pair crosses the imaginary axis: a limit cycle begins
  double_zero,    ///< two eigenvalues pass zero together
};

/// "saddle_node", "branch_point", "hopf", ..., for programs.
std::string_view name_of(SpecialKind kind);
/// "saddle-node", "branch point", "Hopf", ..., for people.
std::string_view in_words(SpecialKind kind);

/// Whether branches cross there.
bool is_crossing(SpecialKind kind);

/// A fixed point on a branch.
struct Equilibrium {
  Eigen::VectorXd state;         ///< [dimension]
  double parameter = 0;          ///< the continued one
  double arclength = 0;          ///< from the first point, scaled
  Eigen::VectorXd tangent;       ///< [dimension + 1]: d(state, parameter) / d arclength
  Eigen::VectorXcd eigenvalues;  ///< of the Jacobian, by falling real part
  int unstable = 0;              ///< eigenvalues with a positive real part
};

struct SpecialPoint {
  SpecialKind kind = SpecialKind::branch_point;
  Equilibrium at;
  bool polished = false;  ///< located by Newton's method on its defining equations, otherwise by bisection only
  double frequency = 0;   ///< rad per unit of time, of a Hopf point
  Eigen::VectorXd null_vector;  ///< [dimension], unit in scaled states; saddle-nodes and branch points
  /// [dimension + 1][2], of pitchforks and transcritical points: direction (state, parameter) of the branch it was
  /// found on, and of the one that crosses it. Unit in scaled unknowns.
  Eigen::MatrixXd branches;
};

}  // namespace secular
