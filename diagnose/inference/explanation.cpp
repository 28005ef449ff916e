#include "diagnose/inference/explanation.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "diagnose/inference/screening.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd switched_off(VectorXd unknowns, const std::vector<std::size_t>& members,
                      const std::vector<Candidate>& candidates) {
  for (const std::size_t m : members)
    for (const std::size_t u : candidates[m].strengths) unknowns(static_cast<Index>(u)) = 0;
  return unknowns;
}

void take_over(VectorXd& into, const VectorXd& from, const Candidate& c) {
  for (const std::size_t u : c.strengths) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
  for (const std::size_t u : c.shapes) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
}

Explanation explanation_by(std::vector<std::size_t> members, Refit fit, const std::vector<Candidate>& candidates) {
  Explanation e;
  for (const std::size_t m : members) e.unknowns += candidates[m].strengths.size() + candidates[m].shapes.size();
  e.fit = std::move(fit);
  e.members = std::move(members);
  return e;
}

std::vector<std::size_t> free_beside(const std::vector<std::size_t>& own, const std::vector<std::size_t>& members,
                                     const std::vector<Candidate>& candidates) {
  std::set<std::size_t> free(own.begin(), own.end());
  for (const std::size_t m : members) {
    free.insert(candidates[m].strengths.begin(), candidates[m].strengths.end());
    free.insert(candidates[m].shapes.begin(), candidates[m].shapes.end());
  }
  return {free.begin(), free.end()};
}

bool is_possible(const Explanation& e, const std::vector<Candidate>& candidates) {
  return std::none_of(e.members.begin(), e.members.end(), [&](std::size_t m) {
    const Candidate& c = candidates[m];
    return (c.passive && e.fit.unknowns(static_cast<Index>(c.strengths[0])) < 0) ||
           (c.plausible && !c.plausible(e.fit.unknowns));
  });
}

bool has_open_law(const Explanation& e, const std::vector<Candidate>& candidates) {
  return std::any_of(e.members.begin(), e.members.end(), [&](std::size_t m) { return candidates[m].open_law; });
}

void keep_best_of_each(std::vector<Explanation>& all, const std::vector<Candidate>& candidates) {
  std::stable_sort(all.begin(), all.end(), [](const Explanation& a, const Explanation& b) {
    return a.fit.chi_squared < b.fit.chi_squared;
  });
  std::set<std::vector<std::string>> taken;
  std::vector<Explanation> kept;
  for (Explanation& e : all) {
    if (!is_possible(e, candidates)) continue;
    std::vector<std::string> name;
    for (const std::size_t m : e.members) name.push_back(candidates[m].effect + "\n" + candidates[m].subject);
    std::sort(name.begin(), name.end());
    if (!taken.insert(std::move(name)).second) continue;
    kept.push_back(std::move(e));
  }
  all = std::move(kept);
}

double expected_separation(const Explanation& truth, const Explanation& rival, const Explanation& null) {
  // Rows are data minus prediction: their difference is that of the predictions.
  const VectorXd signature = null.fit.rows - truth.fit.rows;
  return without_span(basis_of(rival.fit.jacobian), signature).squaredNorm();
}

}  // namespace secular
