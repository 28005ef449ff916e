#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// One or more candidates together, with everything of the model's own fitted beside them.
struct Explanation {
  std::vector<std::size_t> members;  ///< indices of candidates; empty: the model as it is
  Refit fit;
  std::size_t unknowns = 0;  ///< that it has beyond the model's own
  double log_evidence = 0;
};

/// An explanation's unknowns with these candidates switched off.
Eigen::VectorXd switched_off(Eigen::VectorXd unknowns, const std::vector<std::size_t>& members,
                             const std::vector<Candidate>& candidates);

/// The strengths and shapes of one candidate from one vector of unknowns put into another.
void take_over(Eigen::VectorXd& into, const Eigen::VectorXd& from, const Candidate& candidate);

/// By these candidates, all of whose unknowns are free in the fit.
Explanation explanation_by(std::vector<std::size_t> members, Refit fit, const std::vector<Candidate>& candidates);

/// What is free beside `own` unknowns where these candidates are fitted, in order: a strength that another member
/// or the model frees already counts once.
std::vector<std::size_t> free_beside(const std::vector<std::size_t>& own, const std::vector<std::size_t>& members,
                                     const std::vector<Candidate>& candidates);

/// Whether a passive force is no negative one, and all members make sense.
bool is_possible(const Explanation& explanation, const std::vector<Candidate>& candidates);

/// Whether a law outside of the catalogue is among its members.
bool has_open_law(const Explanation& explanation, const std::vector<Candidate>& candidates);

/// Best first; of explanations by the same effect at the same place only the best stays, and only those that are
/// possible.
void keep_best_of_each(std::vector<Explanation>& all, const std::vector<Candidate>& candidates);

/// Expected fall of chi-squared if `truth` (a fitted explanation) is right and `rival` is fitted in its place, to
/// first order: |(1 - P) C theta|^2 with P on the columns of rival and own unknowns. Below about six, data like
/// these cannot tell the two apart.
double expected_separation(const Explanation& truth, const Explanation& rival, const Explanation& null);

}  // namespace secular
