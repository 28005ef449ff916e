#include "thesis/verify/full_equations.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "perturb/formula_value.hpp"

namespace secular::verify {

FullEquations::FullEquations(const Model& model, std::map<std::string, double> values)
    : model_(model), values_(std::move(values)) {
  for (const Mode& mode : model.modes) {
    look_up(mode.equation->left, mode.source);
    look_up(mode.equation->right.front(), mode.source);
  }
}

void FullEquations::look_up(const Expression& e, const FormulaSource& source) {
  for (const Expression& operand : e.operands) look_up(operand, source);
  Leaf leaf;
  if (e.kind == Expression::Kind::number) {
    leaf.value = std::strtod(e.text.c_str(), nullptr);
  } else if (e.kind == Expression::Kind::power) {
    leaf.value = integer_exponent(e, source);
  } else if (e.kind == Expression::Kind::symbol) {
    const auto coordinate = std::find_if(model_.modes.begin(), model_.modes.end(),
                                         [&](const Mode& mode) { return mode.coordinate == e.text; });
    if (coordinate != model_.modes.end())
      leaf = {Leaf::Kind::coordinate, static_cast<std::size_t>(coordinate - model_.modes.begin()), 0};
    else if (e.text == "t")
      leaf.kind = Leaf::Kind::time;
    else
      leaf.value = e.text == "Pi" ? std::numbers::pi : values_.at(e.text);
  } else {
    return;
  }
  leaves_[&e] = leaf;
}

double FullEquations::value(const Expression& e, const FormulaSource& source, double t,
                            const std::vector<double>& q, const std::vector<double>& v,
                            const std::vector<double>& a) const {
  const auto of = [&](std::size_t operand) { return value(e.operands[operand], source, t, q, v, a); };
  switch (e.kind) {
    case Expression::Kind::number:
      return leaves_.at(&e).value;
    case Expression::Kind::symbol: {
      const Leaf& leaf = leaves_.at(&e);
      if (leaf.kind == Leaf::Kind::coordinate) return q[leaf.coordinate];
      return leaf.kind == Leaf::Kind::time ? t : leaf.value;
    }
    case Expression::Kind::sum: {
      double sum = 0;
      for (std::size_t i = 0; i < e.operands.size(); ++i) sum += of(i);
      return sum;
    }
    case Expression::Kind::product: {
      double product = 1;
      for (std::size_t i = 0; i < e.operands.size(); ++i) product *= of(i);
      return product;
    }
    case Expression::Kind::quotient:
      return of(0) / of(1);
    case Expression::Kind::power:
      return std::pow(of(0), static_cast<int>(leaves_.at(&e).value));
    case Expression::Kind::negation:
      return -of(0);
    case Expression::Kind::call:
      break;
  }
  if (e.text == "D" || e.text == "D2") {
    const auto leaf = leaves_.find(&e.operands[0]);
    if (leaf != leaves_.end() && leaf->second.kind == Leaf::Kind::coordinate)
      return e.text == "D" ? v[leaf->second.coordinate] : a[leaf->second.coordinate];
    fail_at(source, e.place, "derivative of something else than a coordinate", "write it out for this check");
  }
  const double x = of(0);
  if (e.text == "cos") return std::cos(x);
  if (e.text == "sin") return std::sin(x);
  if (e.text == "abs") return std::abs(x);
  if (e.text == "sgn") return x > 0 ? 1 : (x < 0 ? -1 : 0);
  return e.text == "max" ? std::max(x, of(1)) : std::min(x, of(1));
}

std::vector<double> FullEquations::acceleration(double t, const std::vector<double>& q,
                                                const std::vector<double>& v) const {
  const std::size_t n = model_.modes.size();
  const auto residual = [&](std::size_t k, const std::vector<double>& a) {
    const Mode& mode = model_.modes[k];
    return value(mode.equation->left, mode.source, t, q, v, a) -
           value(mode.equation->right.front(), mode.source, t, q, v, a);
  };
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd mass(size, size);
  Eigen::VectorXd force(size);
  std::vector<double> a(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) force(static_cast<Eigen::Index>(k)) = residual(k, a);
  for (std::size_t j = 0; j < n; ++j) {
    a[j] = 1;
    for (std::size_t k = 0; k < n; ++k)
      mass(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) =
          residual(k, a) - force(static_cast<Eigen::Index>(k));
    a[j] = 0;
  }
  const Eigen::VectorXd solution = mass.partialPivLu().solve(Eigen::VectorXd(-force));
  return {solution.data(), solution.data() + size};
}

std::vector<std::vector<double>> integrated(const FullEquations& equations, std::vector<double> displacement,
                                            std::vector<double> velocity, double step, std::size_t samples) {
  namespace odeint = boost::numeric::odeint;
  const std::size_t n = displacement.size();
  using State = std::vector<double>;
  State state = displacement;
  state.insert(state.end(), velocity.begin(), velocity.end());
  const auto rates = [&](const State& x, State& rate, double t) {
    const State q(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n)),
        v(x.begin() + static_cast<std::ptrdiff_t>(n), x.end());
    const State a = equations.acceleration(t, q, v);
    for (std::size_t k = 0; k < n; ++k) {
      rate[k] = v[k];
      rate[n + k] = a[k];
    }
  };
  std::vector<std::vector<double>> record(n, std::vector<double>(samples));
  auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(1e-12, 1e-12);
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t k = 0; k < n; ++k) record[k][i] = state[k];
    const double t = step * static_cast<double>(i);
    odeint::integrate_adaptive(stepper, rates, state, t, t + step, step);
  }
  return record;
}

}  // namespace secular::verify
