#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Orthonormal functions of records, one row a record, from what may matter of each record, most often first; the
/// first is the constant. The first of those that are independent, no more than leave as many degrees of freedom as
/// they take. Of no records none.
Eigen::MatrixXd independent_functions(const std::vector<Eigen::VectorXd>& of_records);

enum class Following { at_random, settings, too_few };

/// Whether what records have of their own, of equal variance beside `functions`, follows these beyond chance (F
/// law, 5 % over `tests` such questions), as what a missing law makes of it does; or too few degrees of freedom are
/// left to tell.
Following follows_settings(const Eigen::VectorXd& own, const Eigen::MatrixXd& functions, double tests = 1);

}  // namespace secular
