#include "diagnose/verdict/fitted_numbers.hpp"

#include <algorithm>
#include <cstddef>

namespace secular {

using Eigen::Index;

FittedNumbers fitted_numbers(const Refit& fit, const std::vector<const Candidate*>& members,
                             const std::vector<std::string>& names, const Eigen::MatrixXd& covariance,
                             const Campaign& campaign, const CompiledModel& model) {
  FittedNumbers numbers;
  const SymbolUnits units(campaign, model);
  std::vector<Index> places, unknowns;
  for (std::size_t f = 0; f < fit.free.size(); ++f) {
    if (!fit.identifiable[f]) continue;
    places.push_back(static_cast<Index>(f));
    unknowns.push_back(static_cast<Index>(fit.free[f]));
    numbers.names.push_back(names[fit.free[f]]);
    numbers.units.push_back(units.of(fit.free[f]));
  }
  numbers.values = fit.unknowns(unknowns);
  numbers.covariance = covariance(places, places);
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Identity(numbers.values.size(), numbers.values.size());
  const auto place = [&](std::size_t unknown) {
    return std::find(unknowns.begin(), unknowns.end(), static_cast<Index>(unknown)) - unknowns.begin();
  };
  for (const Candidate* member : members) {
    const Index at = place(member->strengths.front());
    if (at == numbers.values.size()) continue;
    const Candidate::Strength strength = member->strength_of_term(fit.unknowns);
    numbers.values(at) = strength.value;
    slopes(at, at) = strength.by_strength;
    if (strength.by_shape == 0) continue;
    if (const Index shape = place(member->shapes.front()); shape < numbers.values.size()) {
      slopes(at, shape) = strength.by_shape;
      slopes(shape, shape) = member->sign_of_shapes(fit.unknowns);
      numbers.values(shape) *= slopes(shape, shape);
    }
  }
  numbers.covariance = slopes * numbers.covariance * slopes.transpose();
  return numbers;
}

}  // namespace secular
