#include "diagnose/verdict/cause_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "diagnose/verdict/ties.hpp"

namespace secular {
namespace {

using Eigen::Index;

/// Predicting what was held out takes longer than all else that a report says.
constexpr std::size_t most_closed_shares = 6;

double sd_of(const Refit& fit, std::size_t unknown, const Eigen::MatrixXd& covariance) {
  const auto at = static_cast<Index>(std::find(fit.free.begin(), fit.free.end(), unknown) - fit.free.begin());
  return std::sqrt(std::max(0.0, covariance(at, at)));
}

// The strength as its term in the catalogue has it.
void say_strength(const Candidate& candidate, const Refit& fit, const Eigen::MatrixXd& covariance,
                  CauseReport& cause) {
  const Candidate::Strength strength = candidate.strength_of_term(fit.unknowns);
  Eigen::VectorXd slopes = Eigen::VectorXd::Zero(covariance.rows());
  const auto place = [&](std::size_t unknown) {
    return static_cast<Index>(std::find(fit.free.begin(), fit.free.end(), unknown) - fit.free.begin());
  };
  slopes(place(candidate.strengths.front())) = strength.by_strength;
  if (strength.by_shape != 0) slopes(place(candidate.shapes.front())) = strength.by_shape;
  cause.coefficient = strength.value;
  cause.sd = std::sqrt(std::max(0.0, slopes.dot(covariance * slopes)));
}

}  // namespace

std::vector<CauseReport> CauseReporter::causes(const std::vector<Rival>& rivals) const {
  std::vector<CauseReport> found;
  std::map<std::string, std::size_t> places;
  for (const Rival& r : rivals) {
    const Refit& fit = r.explanation->fit;
    const Eigen::MatrixXd of_fit = covariance(fit);
    for (std::size_t m = 0; m < r.effects.size(); ++m) {
      const bool own = r.explanation->members.empty();
      const Candidate* candidate = own ? nullptr : &candidates[r.explanation->members[m]];
      const std::string key = r.effects[m] + "\n" + (candidate ? candidate->subject : "");
      const auto [place, fresh] = places.emplace(key, found.size());
      if (!fresh) {
        found[place->second].probability += r.probability;
        continue;
      }
      CauseReport cause;
      cause.effect = r.effects[m];
      cause.probability = r.probability;
      if (candidate) {
        cause.subject = candidate->subject;
        cause.coefficient_name = unknown_names[candidate->strengths.front()];
        cause.unit = unit(candidate->strengths.front());
        say_strength(*candidate, fit, of_fit, cause);
        for (const std::size_t shape : candidate->shapes)
          cause.shapes.push_back({unknown_names[shape],
                                  candidate->sign_of_shapes(fit.unknowns) * fit.unknowns(static_cast<Index>(shape)),
                                  sd_of(fit, shape, of_fit), unit(shape)});
      }
      if (r.effects.size() == 1 && found.size() < most_closed_shares) cause.closed = closed_share(*r.explanation);
      found.push_back(std::move(cause));
    }
  }
  // Of equal probability in the order of the rivals.
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto probability = [&](std::size_t i) { return found[i].probability; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probability(a) > probability(b); });
  order_ties(order, same_probability, probability, std::less<>());
  std::vector<CauseReport> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(found[i]));
  return sorted;
}

OpenLaw CauseReporter::open_law(const Rival& rival) const {
  const Candidate& law = candidates[rival.explanation->members.front()];
  const Refit& fit = rival.explanation->fit;
  const std::size_t exponent = law.shapes.front();
  return {law.subject,
          law.effect,
          law.in_words,
          fit.unknowns(static_cast<Index>(exponent)),
          sd_of(fit, exponent, covariance(fit)),
          rival.probability};
}

const Rival* best_wrong_cause(const std::vector<Rival>& rivals, const std::vector<std::string>& set) {
  for (const Rival& r : rivals)
    if (r.effects.size() == 1 && std::find(set.begin(), set.end(), r.effects.front()) == set.end()) return &r;
  return nullptr;
}

}  // namespace secular
