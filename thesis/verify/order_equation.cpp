#include "thesis/verify/order_equation.hpp"

#include "perturb/ordered_equation.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;
using Series = std::vector<ex>;

Series product(const Series& a, const Series& b) {
  Series result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < a.size(); ++j) result[i + j] += (a[i] * b[j]).expand();
  return result;
}

// (D0 + eps D1 + eps^2 D2)^derivative of v_0 + eps v_1 + ..., by powers of eps.
Series coordinate(const PrintedFormula& formula, std::size_t mode, int derivative, int order) {
  const auto size = static_cast<std::size_t>(order) + 1;
  Series series(size);
  const auto add = [&](std::vector<int> scales, std::size_t power) {
    if (power >= size) return;
    std::vector<int> derivatives(3, 0);
    for (const int scale : scales) ++derivatives[static_cast<std::size_t>(scale)];
    for (std::size_t n = 0; n + power < size; ++n) series[n + power] += formula.unknown(mode, n, derivatives);
  };
  if (derivative == 0) add({}, 0);
  for (int first = 0; derivative >= 1 && first <= 2; ++first) {
    if (derivative == 1) add({first}, static_cast<std::size_t>(first));
    for (int second = 0; derivative == 2 && second <= 2; ++second)
      add({first, second}, static_cast<std::size_t>(first + second));
  }
  return series;
}

Series factor_series(const PrintedFormula& formula, const Factor& factor, int order) {
  const auto index = static_cast<std::size_t>(factor.index);
  Series series(static_cast<std::size_t>(order) + 1);
  switch (factor.kind) {
    case Factor::Kind::coordinate:
      return coordinate(formula, index, factor.derivative, order);
    case Factor::Kind::excitation:
      series[0] = formula.excitation(index, factor.derivative);
      return series;
    case Factor::Kind::clock_cos:
    case Factor::Kind::clock_sin:
      series[0] = formula.clock(index, factor.multiple, factor.kind == Factor::Kind::clock_cos);
      return series;
    case Factor::Kind::absolute:
    case Factor::Kind::sign:
      // Nonsmooth terms enter at the highest order: their leading value is all that counts.
      series[0] = formula.absolute(coordinate(formula, index, factor.derivative, order)[0]);
      return series;
    case Factor::Kind::smooth:
      break;  // expanded by ordered_equations()
  }
  return series;
}

}  // namespace

ex order_equation(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode, int order) {
  const auto n = static_cast<std::size_t>(order);
  ex sum = formula.unknown(mode, n, {2, 0, 0}) - coordinate(formula, mode, 2, order)[n];
  const std::vector<OrderedEquation> equations = ordered_equations(*derivation.model, *derivation.resonance);
  for (const OrderedTerm& term : equations[mode].right_hand_side) {
    if (term.order > order) continue;
    Series series(n + 1);
    series[0] = term.coefficient;
    for (const auto& [factor, power] : term.factors)
      for (int p = 0; p < power; ++p) series = product(series, factor_series(formula, factor, order));
    sum += series[static_cast<std::size_t>(order - term.order)];
  }
  return sum;
}

}  // namespace secular::verify
