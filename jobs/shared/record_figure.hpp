#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "report/figure.hpp"

namespace secular {

/// Root mean square of every record's rows, with the model as it is (`before`) and, where there is one, with an
/// explanation added.
report::Figure record_figure(const std::vector<RowLabel>& labels, const Eigen::VectorXd& before,
                             const Eigen::VectorXd* after = nullptr);

}  // namespace secular
