#include "thesis/verify/lagrangian_symmetry.hpp"

#include "perturb/ordered_equation.hpp"
#include "perturb/term_sum.hpp"

namespace secular::verify {

std::vector<std::string> broken_lagrangian_symmetries(const Model& model, const std::vector<std::string>& without) {
  GiNaC::exmap zero;
  for (const std::string& name : without) zero[model.symbols.at(name)] = 0;
  std::vector<TermSum> equations;
  for (const TermSum& whole : equations_of_motion(model)) {
    TermSum equation;
    for (const auto& [product, coefficient] : whole.terms()) {
      TermSum term = TermSum::constant(coefficient.subs(zero, GiNaC::subs_options::no_pattern));
      for (const auto& [factor, power] : product) term = term * TermSum::factor(factor).power(power);
      equation += term;
    }
    equations.push_back(std::move(equation));
  }
  std::vector<std::string> broken;
  const auto partial = [&](std::size_t i, std::size_t j, int derivative) {
    return equations[i].partial({Factor::Kind::coordinate, static_cast<int>(j), derivative, 1});
  };
  const auto report = [&](TermSum left, const TermSum& right, const std::string& condition, std::size_t i,
                          std::size_t j) {
    left += right.scaled(-1);
    for (const auto& [product, coefficient] : left.terms())
      if (!coefficient.expand().is_zero())
        broken.push_back(condition + " for " + model.modes[i].coordinate + ", " + model.modes[j].coordinate +
                         ": terms in " + to_string(product, model));
  };
  const auto sum = [](TermSum a, const TermSum& b, int sign) {
    a += b.scaled(sign);
    return a;
  };
  for (std::size_t i = 0; i < equations.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      report(partial(i, j, 2), partial(j, i, 2), "dE_i/dq_j'' = dE_j/dq_i''", i, j);
      report(sum(partial(i, j, 1), partial(j, i, 1), 1),
             sum(partial(i, j, 2), partial(j, i, 2), 1).time_derivative(),
             "dE_i/dq_j' + dE_j/dq_i' = d/dt(dE_i/dq_j'' + dE_j/dq_i'')", i, j);
      report(sum(partial(i, j, 0), partial(j, i, 0), -1),
             sum(partial(i, j, 1), partial(j, i, 1), -1).time_derivative().scaled(GiNaC::numeric(1, 2)),
             "dE_i/dq_j - dE_j/dq_i = 1/2 d/dt(dE_i/dq_j' - dE_j/dq_i')", i, j);
    }
  return broken;
}

}  // namespace secular::verify
