#include "perturb/nonsmooth_terms.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "input/input_error.hpp"
#include "perturb/nonsmooth.hpp"

namespace secular {
namespace {

// How many nonsmooth factors a term has, and one of them.
std::pair<int, const Factor*> nonsmooth_factor(const OrderedTerm& term) {
  int count = 0;
  const Factor* nonsmooth = nullptr;
  for (const auto& [factor, power] : term.factors)
    if (factor.nonsmooth()) {
      count += power;
      nonsmooth = &factor;
    }
  return {count, nonsmooth};
}

}  // namespace

NonsmoothTerms tell_nonsmooth_apart(const OrderedEquation& equation, std::size_t mode, const Model& model,
                                    const ResonanceCase& resonance, const std::vector<bool>& sinusoidal) {
  const int highest = resonance.expand_to;
  NonsmoothTerms result;
  for (const OrderedTerm& term : equation.right_hand_side) {
    const auto [count, nonsmooth] = nonsmooth_factor(term);
    if (count == 0) {
      result.expanded.push_back(term);
      continue;
    }
    const std::string text = to_string(term.factors, model);
    if (count > 1)
      throw InputError(model.file, resonance.place(), "term " + text + " multiplies nonsmooth functions",
                       "write abs(x)^2 as x^2, sgn(x)^2 as 1 and abs(x)*sgn(x) as x");
    const auto refuse_before_highest_order = [&](const std::string& why) {
      if (term.order < highest)
        throw InputError(model.file, resonance.place(),
                         fmt::format("nonsmooth term {} enters at eps^{}, below the order of expansion {}, and {}",
                                     text, term.order, highest, why),
                         fmt::format("give its coefficient order {}, or set expand_to = {}", highest, term.order));
    };
    if (nonsmooth->compound() || !sinusoidal[static_cast<std::size_t>(nonsmooth->index)]) {
      refuse_before_highest_order("goes to quadrature, which is not expanded further");
      result.quadratures.push_back({mode, term.order, term.coefficient, term.factors});
      continue;
    }
    if (highest - term.order > 1) refuse_before_highest_order("its second derivative is not a function");
    if (nonsmooth->kind == Factor::Kind::sign)
      refuse_before_highest_order("the derivative of sgn is not a function");
    if (term.order < 2) refuse_before_highest_order("its correction is a sum over infinitely many harmonics");
    result.expanded.push_back(term);
  }
  return result;
}

std::vector<int> complete_harmonics(const std::vector<OrderedEquation>& equations, const Model& model,
                                    const ResonanceCase& resonance) {
  const auto size = static_cast<std::size_t>(resonance.expand_to) + 1;
  std::vector<bool> present(size, false);
  std::vector<int> complete(size, highest_nonsmooth_harmonic);
  for (std::size_t n = 0; n < size; ++n)
    for (const OrderedEquation& equation : equations)
      for (const OrderedTerm& term : equation.right_hand_side) {
        const auto order = static_cast<std::size_t>(term.order);
        int degree = 0;
        for (const auto& [factor, power] : term.factors)
          if (factor.kind == Factor::Kind::coordinate) degree += power;
        if (nonsmooth_factor(term).second) present[n] = present[n] || order <= n;
        if (order == 0 || order > n || !present[n - order]) continue;
        present[n] = true;
        complete[n] = std::min(complete[n], complete[n - order] - std::max(0, degree - 1));
        if (complete[n] < 1)
          throw InputError(
              model.file, resonance.place(),
              fmt::format("at eps^{} nonsmooth terms need harmonics above the {}th", n, highest_nonsmooth_harmonic),
              "expand to a lower order");
      }
  return complete;
}

}  // namespace secular
