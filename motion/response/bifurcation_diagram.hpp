#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "motion/response/continuation.hpp"

namespace secular {

struct DiagramOptions {
  ContinuationOptions continuation;
  Eigen::VectorXd starts_at;     ///< values of the parameter at which fixed points are searched for
  Eigen::VectorXd lower, upper;  ///< box of that search, [dimension]
  int branch_limit = 60;
};

enum class DiagramStatus {
  complete,      ///< every start and every crossing was followed
  branch_limit,  ///< as many branches as allowed
  search_limit,  ///< a search for fixed points ended at a limit; with FixedPointStatus::root_limit nothing is
                 ///< traced
};

/// All branches of fixed points in one parameter that could be found.
struct BifurcationDiagram {
  DiagramStatus status = DiagramStatus::complete;
  std::string reason;
  std::vector<Branch> branches;
};

/// Response curves: fixed points at some values of the parameter (find_fixed_points; isolated branches are only
/// seen there), the branches through them, and every branch that crosses those. No branch is followed twice. What
/// find_fixed_points and continue_fixed_points cannot guarantee is not guaranteed here. Throws
/// std::invalid_argument like these.
BifurcationDiagram bifurcation_diagram(const VectorField& field,
                                       const Eigen::Ref<const Eigen::VectorXd>& parameters, Eigen::Index parameter,
                                       const DiagramOptions& options);

}  // namespace secular
