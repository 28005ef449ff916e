#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/explanation.hpp"

namespace secular {

/// What evidence is taken at.
struct Weights {
  double dispersion = 1;  ///< variance of the rows, at least 1
  double price = 0;       ///< of one unknown more, in log evidence
  double prior_second = 1, prior_open_law = 1;
};

/// docs/inference.md (46), at least 1: by how many times the variance of a difference between explanations is
/// larger than rows make it that are independent, since what the better one leaves beside noise goes together
/// within a fold. `best`, `rival`: what either leaves, of unit repeatability; `folds`: by row. 1 where one fold
/// alone holds rows.
double dependence_of_rows(const Eigen::VectorXd& best, const Eigen::VectorXd& rival, const std::vector<int>& folds,
                          double dispersion);

/// Schwarz's approximation, with the prior odds of a second effect and of an open law, for independent rows.
double log_evidence(const Explanation& explanation, const std::vector<Candidate>& candidates,
                    const Weights& weights);

/// Of all, which are put in order, likeliest first: differences in chi-squared from the one that is the likeliest
/// by independent rows count less by the dependence of these rows. `folds`: by row.
void weigh(Explanation& null, std::vector<Explanation>& found, const std::vector<Candidate>& candidates,
           const Weights& weights, const std::vector<int>& folds);

}  // namespace secular
