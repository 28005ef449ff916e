#include "codegen/document/steady_statements.hpp"

#include <algorithm>
#include <utility>

#include "codegen/canonical/cartesian_form.hpp"
#include "codegen/canonical/free_name.hpp"
#include "codegen/canonical/steady_state.hpp"
#include "codegen/canonical/zero_solution.hpp"
#include "codegen/document/plain_text.hpp"
#include "codegen/document/typeset_equations.hpp"
#include "codegen/document/typeset_variables.hpp"

namespace secular::typeset {
namespace {

// Longer polynomials are described, not written out.
constexpr std::size_t longest_polynomial = 400;  // monomials

std::size_t monomials(const VariableSum& sum) {
  std::size_t count = 0;
  for (const auto& [powers, parts] : sum.terms())
    for (const RationalFunction& part : parts)
      for (const Fraction& f : fractions(part)) {
        count += f.numerator.size() + f.denominator.size();
        for (const DivisorPower& divisor : f.divisors) count += divisor.sum->size();
      }
  return count;
}

bool turns(const std::vector<CanonicalRatio>& multiples) {
  return std::any_of(multiples.begin(), multiples.end(), [](const CanonicalRatio& r) { return r.numerator != 0; });
}

VariableSum negative(const VariableSum& sum) {
  VariableSum result;
  result.add(sum, -1);
  return result;
}

class Statements {
 public:
  Statements(const CanonicalModel& model, const CanonicalCase& resonance) : model_(model), c_(resonance) {}

  StatementSection jacobian() const;
  StatementSection zero() const;
  StatementSection steady() const;

 private:
  Sum empty_sum() const { return Sum(model_.order); }
  Expression free_symbol(const std::string& wanted) const { return symbol(free_name(model_, wanted)); }
  Expression of_mode(const std::string& letter, std::size_t mode) const {
    return free_symbol(letter + "_" + model_.coordinates[mode]);
  }
  Expression forced(const VariableSum& value) const {
    Sum sum = empty_sum();
    add_forced(sum, model_, value);
    return sum.expression();
  }
  // The value plus (or minus) what the frame turns by.
  Expression forced_and_turning(const VariableSum& value, const std::vector<CanonicalRatio>& turning,
                                bool minus) const {
    if (value.empty()) {
      std::vector<CanonicalRatio> multiples = turning;
      for (CanonicalRatio& multiple : multiples)
        if (minus) multiple.numerator = -multiple.numerator;
      return frequency_combination(model_, multiples);
    }
    Sum sum = empty_sum();
    add_forced(sum, model_, value);
    if (turns(turning)) sum.add(frequency_combination(model_, turning), minus);
    return sum.expression();
  }
  Expression of_amplitude(const VariableSum& value) const { return amplitude_expression(model_, c_, value); }
  // T - a d
  Expression in_phase(const AmplitudeRelation& relation) const {
    Sum sum = empty_sum();
    add_amplitude(sum, model_, c_, relation.still_imaginary);
    const Expression turning = frequency_combination(model_, frame_offset(c_, 0));
    sum.add(Product().times(named("a", model_, 0)).times(bracket(turning)).expression(), true);
    return sum.expression();
  }
  // Sum of squares of what is not zero.
  Expression squares(const std::vector<Expression>& values, std::size_t positive) const {
    Sum sum = empty_sum();
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != number(0)) sum.add(power(values[i], 2), i >= positive);
    return sum.expression();
  }

  Equation linearised(const ZeroSolution& zero, std::size_t mode) const;
  void single(const ZeroSolution& zero, std::size_t mode, std::vector<Statement>& list) const;
  void parametric(const ZeroSolution& zero, std::size_t mode, std::vector<Statement>& list) const;
  void pair(const ZeroSolution& zero, const ZeroSolution::Group& group, std::vector<Statement>& list) const;

  void free_or_none(std::vector<Statement>& list) const;
  void one_angle(const AmplitudeRelation& relation, std::vector<Statement>& list) const;
  void opposite_angles(const AmplitudeRelation& relation, std::vector<Statement>& list) const;
  void saddle_node(const AmplitudeRelation& relation, std::vector<Statement>& list) const;

  const CanonicalModel& model_;
  const CanonicalCase& c_;
};

StatementSection Statements::jacobian() const {
  const ModulationJacobian jacobian = modulation_jacobian(model_, c_);
  Statement statement{"entries", {}, {}};
  statement.says.emplace_back(
      "Derivatives of the right sides of the Cartesian form, the turning of the frame included; entries that are "
      "not listed are zero.");
  if (!jacobian.regular_at_zero)
    statement.says.emplace_back(
        " Not regular at zero: with odd powers of a modulus the entries hold where that amplitude is not zero.");
  else if (jacobian.complete)
    statement.says.emplace_back(" Regular at zero.");
  if (!jacobian.complete) statement.says.emplace_back(" Without the terms that are left to quadrature.");
  const auto variable = [&](std::size_t i) { return named(i % 2 == 0 ? "x" : "y", model_, i / 2); };
  const auto partial = [](Expression of) {
    return Product().times(constant("partial")).times(std::move(of)).expression();
  };
  for (std::size_t i = 0; i < jacobian.entry.size(); ++i)
    for (std::size_t j = 0; j < jacobian.entry.size(); ++j)
      if (!jacobian.entry[i][j].empty())
        statement.equations.push_back({fraction(partial(accent("dot", variable(i))), partial(variable(j))),
                                       cartesian_expression(model_, c_, jacobian.entry[i][j])});
  return {"jacobian", "Jacobian of the Cartesian form", {std::move(statement)}};
}

Equation Statements::linearised(const ZeroSolution& zero, std::size_t mode) const {
  Sum sum = empty_sum();
  const auto add = [&](const ComplexSum& coefficient, const Expression& factor) {
    Product product;
    product.times(factor);
    add_forced(sum, model_, coefficient.real, product);
    add_forced(sum, model_, coefficient.imaginary, product, true);
  };
  for (std::size_t j = 0; j < model_.coordinates.size(); ++j) {
    const Expression b = named("B", model_, j);
    if (j == mode && turns(zero.offset[mode]))
      sum.add(Product()
                  .times(constant("i"))
                  .times(bracket(frequency_combination(model_, zero.offset[mode])))
                  .times(b)
                  .expression(),
              true);
    add(zero.direct[mode][j], b);
    add(zero.conjugate[mode][j], accent("bar", b));
  }
  return {rate_of(named("B", model_, mode)), sum.expression()};
}

StatementSection Statements::zero() const {
  StatementSection section{"zero_solution", "Zero solution", {}};
  const ZeroSolution zero = zero_solution(model_, c_);
  switch (zero.kind) {
    case ZeroSolution::Kind::none:
      section.statements.push_back(
          {"none", {"The modulation equations do not have it: some terms are free of all amplitudes."}, {}});
      return section;
    case ZeroSolution::Kind::undecided:
      section.statements.push_back({"undecided", {"Not examined: terms are left to quadrature."}, {}});
      return section;
    case ZeroSolution::Kind::not_differentiable:
      section.statements.push_back(
          {"not_differentiable",
           {"The modulation equations have no linearisation at zero: a modulus stands in terms of first or lower "
            "degree."},
           {}});
      return section;
    case ZeroSolution::Kind::linear:
      break;
  }
  Statement linear{"linearisation", {"Linearised at zero, in the observed frame:"}, {}};
  for (std::size_t k = 0; k < model_.coordinates.size(); ++k)
    if (c_.mode_at_rest.empty() || !c_.mode_at_rest[k]) linear.equations.push_back(linearised(zero, k));
  section.statements.push_back(std::move(linear));
  for (const ZeroSolution::Group& group : zero.groups) {
    switch (group.kind) {
      case ZeroSolution::Group::Kind::single:
        single(zero, group.modes[0], section.statements);
        break;
      case ZeroSolution::Group::Kind::parametric:
        parametric(zero, group.modes[0], section.statements);
        break;
      case ZeroSolution::Group::Kind::additive:
      case ZeroSolution::Group::Kind::difference:
        pair(zero, group, section.statements);
        break;
      case ZeroSolution::Group::Kind::several: {
        std::vector<Run> says{"No closed form of the threshold: the eigenvalues of the linearisation decide for "};
        for (std::size_t i = 0; i < group.modes.size(); ++i) {
          if (i > 0) says.emplace_back(", ");
          says.emplace_back(symbol(model_.coordinates[group.modes[i]]));
        }
        says.emplace_back(" together.");
        section.statements.push_back({"coupled", std::move(says), {}});
      }
    }
  }
  return section;
}

void Statements::single(const ZeroSolution& zero, std::size_t mode, std::vector<Statement>& list) const {
  const VariableSum decay = negative(zero.direct[mode][mode].real);
  const Expression v = symbol(model_.coordinates[mode]);
  if (decay.is_zero()) {
    list.push_back({"neutral", {v, " neither grows nor decays near zero to this order."}, {}});
    return;
  }
  list.push_back({"decay",
                  {v, " decays towards zero where the left side is positive, and grows where it is negative:"},
                  {{forced(decay), number(0)}}});
}

void Statements::parametric(const ZeroSolution& zero, std::size_t mode, std::vector<Statement>& list) const {
  const ComplexSum &p = zero.direct[mode][mode], &q = zero.conjugate[mode][mode];
  const Expression v = symbol(model_.coordinates[mode]);
  const Expression left = squares({forced(p.real), forced_and_turning(p.imaginary, zero.offset[mode], true)}, 2);
  list.push_back({"threshold",
                  {"Determinant of the Jacobian of ", v,
                   " at zero is zero; zero is unstable where the right side is larger than the left:"},
                  {{left, squares({forced(q.real), forced(q.imaginary)}, 2)}}});
  // Solved for the excitation where it stands in q alone, with one power.
  for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
    int power_of_forcing = 0;
    bool same = !p.real.depends_on_variable(j) && !p.imaginary.depends_on_variable(j);
    for (const VariableSum* sum : {&q.real, &q.imaginary})
      for (const auto& [powers, parts] : sum->terms()) {
        same = same && powers[j] > 0 && (power_of_forcing == 0 || power_of_forcing == powers[j]);
        power_of_forcing = powers[j];
      }
    if (!same) continue;
    const Expression below = squares(
        {forced(q.real.times_power(j, -power_of_forcing)), forced(q.imaginary.times_power(j, -power_of_forcing))},
        2);
    list.push_back({"critical_excitation",
                    {"The same, solved for the excitation:"},
                    {{power(symbol(model_.excitations[j]), 2 * power_of_forcing), fraction(left, below)}}});
  }
  VariableSum decay;
  decay.add(p.real, -2);
  if (decay.is_zero())
    list.push_back({"trace", {"The trace of the Jacobian of ", v, " at zero vanishes to this order."}, {}});
  else
    list.push_back(
        {"trace",
         {"Trace of the Jacobian of ", v,
          " at zero, with changed sign, is zero: a Hopf bifurcation where the left side of the threshold "
          "is larger than the right; zero is unstable where this is negative:"},
         {{forced(decay), number(0)}}});
}

void Statements::pair(const ZeroSolution& zero, const ZeroSolution::Group& group,
                      std::vector<Statement>& list) const {
  const bool additive = group.kind == ZeroSolution::Group::Kind::additive;
  const std::size_t a = group.modes[0], b = group.modes[1];
  const ZeroSolution::Pair pair = zero.pair(group);
  const Expression c_a = of_mode("c", a), c_b = of_mode("c", b), d_a = of_mode("d", a), d_b = of_mode("d", b),
                   real = free_symbol("K_r"), imaginary = free_symbol("K_i"), s = free_symbol("s"),
                   detuning = free_symbol("Delta");
  const bool real_exchange = pair.exchange.imaginary.is_zero();
  Statement characteristic{"characteristic_equation", {}, {}};
  characteristic.says = {"Combination resonance of the ",
                         additive ? "additive" : "difference",
                         " type of ",
                         symbol(model_.coordinates[a]),
                         " and ",
                         symbol(model_.coordinates[b]),
                         "; growth ",
                         s,
                         " of both from"};
  const auto factor = [&](const Expression& decay, const Expression& turning, bool plus) {
    Sum sum = empty_sum();
    sum.add(s, false).add(decay, false);
    sum.add(Product().times(constant("i")).times(turning).expression(), !plus);
    return bracket(sum.expression());
  };
  Sum right = empty_sum();
  right.add(real, false);
  if (!real_exchange) right.add(Product().times(constant("i")).times(imaginary).expression(), false);
  characteristic.equations = {
      {Product().times(factor(c_a, d_a, false)).times(factor(c_b, d_b, additive)).expression(), right.expression()},
      {c_a, forced(pair.first_decay)},
      {c_b, forced(pair.second_decay)},
      {d_a, forced_and_turning(zero.direct[a][a].imaginary, zero.offset[a], true)},
      {d_b, forced_and_turning(zero.direct[b][b].imaginary, zero.offset[b], true)},
      {real, forced(pair.exchange.real)}};
  if (!real_exchange) characteristic.equations.push_back({imaginary, forced(pair.exchange.imaginary)});
  list.push_back(std::move(characteristic));

  // c1 c2 (1 + Delta^2/(c1 + c2)^2) - K_i (K_i + Delta (c2 - c1))/(c1 + c2)^2
  const auto threshold = [&](const Expression& first, const Expression& second, const Expression& distance) {
    const Expression both = empty_sum().add(first, false).add(second, false).expression();
    const Expression quotient = fraction(power(distance, 2), power(both, 2));
    const Expression widened = empty_sum().add(number(1), false).add(quotient, false).expression();
    Sum sum = empty_sum();
    sum.add(Product().times(first).times(second).times(bracket(widened)).expression(), false);
    if (!real_exchange) {
      const Expression difference = empty_sum().add(second, false).add(first, true).expression();
      const Expression inner = empty_sum()
                                   .add(imaginary, false)
                                   .add(Product().times(distance).times(bracket(difference)).expression(), false)
                                   .expression();
      sum.add(fraction(Product().times(imaginary).times(bracket(inner)).expression(), power(both, 2)), true);
    }
    return sum.expression();
  };
  list.push_back({"threshold",
                  {"A growth is imaginary, with ", empty_sum().add(c_a, false).add(c_b, false).expression(),
                   " positive; zero is unstable where the left side of the threshold is larger than the right:"},
                  {{real, threshold(c_a, c_b, detuning)},
                   {detuning, forced_and_turning(pair.detuning, pair.turning, false)}}});
  if (real_exchange)
    list.push_back(
        {"threshold_in_parameters",
         {"The same in the parameters of the model:"},
         {{forced(pair.exchange.real), threshold(forced(pair.first_decay), forced(pair.second_decay),
                                                 forced_and_turning(pair.detuning, pair.turning, false))}}});
  list.push_back({"trace",
                  {"Trace with changed sign is zero; zero is unstable where this is negative:"},
                  {{forced(pair.first_decay + pair.second_decay), number(0)}}});
}

void Statements::free_or_none(std::vector<Statement>& list) const {
  switch (steady_state(model_, c_).kind) {
    case SteadyState::Kind::several_modes:
      list.push_back({"several_modes",
                      {"Several modes: the phases cannot be eliminated in closed form; the steady states are where "
                       "all right sides of the Cartesian form vanish."},
                      {}});
      return;
    case SteadyState::Kind::free: {
      std::vector<Equation> equations = steady_equations(model_, c_);
      list.push_back({"decay_law", {"decay law:"}, {equations[0]}});
      list.push_back(
          {"backbone",
           {"backbone, with ", observed_frequency_symbol(model_, 0), " the frequency of the oscillation:"},
           {equations[1]}});
      return;
    }
    default:
      list.push_back({"several_angles",
                      {"Terms with several phase angles: the phase cannot be eliminated in closed form."},
                      {}});
  }
}

void Statements::one_angle(const AmplitudeRelation& relation, std::vector<Statement>& list) const {
  list.push_back({"frequency_response",
                  {"frequency response, the phase eliminated by squaring and adding:"},
                  steady_equations(model_, c_)});
  const Expression frame = frequency_combination(model_, frame_offset(c_, 0));
  if (relation.force) {
    list.push_back(
        {"force_response",
         {"force response:"},
         {{power(symbol(model_.excitations[relation.force->excitation]), 2 * relation.force->power),
           fraction(squares({of_amplitude(relation.still_real), in_phase(relation)}, 2),
                    squares({of_amplitude(relation.force->real), of_amplitude(relation.force->imaginary)}, 2))}}});
  }
  if (!relation.detuning_is_explicit) return;
  const auto over_a = [&](const VariableSum& sum) {
    return of_amplitude(sum.times_power(AmplitudeVariables::amplitude, -1));
  };
  const Expression radicand = free_symbol("R");
  const auto branch = [&](bool minus) {
    Sum sum = empty_sum();
    add_amplitude(sum, model_, c_, relation.still_imaginary.times_power(AmplitudeVariables::amplitude, -1));
    return Equation{frame, sum.add(root(radicand), minus).expression()};
  };
  list.push_back({"detuning",
                  {"detuning at given amplitude, two branches about the backbone:"},
                  {branch(false),
                   branch(true),
                   {radicand, squares({over_a(relation.turning_real), over_a(relation.turning_imaginary),
                                       over_a(relation.still_real)},
                                      2)}}});
  const VariableSum squared = relation.turning_real * relation.turning_real +
                              relation.turning_imaginary * relation.turning_imaginary -
                              relation.still_real * relation.still_real;
  if (!squared.times_power(AmplitudeVariables::amplitude, -2).depends_on_variable(AmplitudeVariables::amplitude)) {
    list.push_back({"peak",
                    {radicand,
                     " does not depend on the amplitude: both branches are there where it is positive, and "
                     "they do not meet."},
                    {}});
    return;
  }
  list.push_back({"peak",
                  {"extreme amplitude, where the branches meet: ", radicand, " is zero, that is"},
                  {{squares({over_a(relation.turning_real), over_a(relation.turning_imaginary)}, 2),
                    squares({over_a(relation.still_real)}, 1)},
                   {frame, over_a(relation.still_imaginary)}}});
}

void Statements::opposite_angles(const AmplitudeRelation& r, std::vector<Statement>& list) const {
  const VariableSum u_plus = r.turning_real + r.opposite_real, u_minus = r.turning_real - r.opposite_real,
                    v_plus = r.turning_imaginary + r.opposite_imaginary,
                    v_minus = r.turning_imaginary - r.opposite_imaginary;
  const Expression s = free_symbol("S"), t = free_symbol("T");
  const auto combination = [&](const Expression& x, const VariableSum& by_x, const Expression& y,
                               const VariableSum& by_y, bool minus) {
    Sum sum = empty_sum();
    const auto add = [&](const Expression& one, const VariableSum& by, bool negated) {
      if (!by.empty()) sum.add(Product().times(one).times(bracket(of_amplitude(by))).expression(), negated);
    };
    add(x, by_x, false);
    add(y, by_y, minus);
    return sum.expression();
  };
  list.push_back(
      {"frequency_response",
       {"frequency response; terms turn with an angle and with its negative, and cosine and sine of the "
        "angle are eliminated:"},
       {{squares({combination(s, u_minus, t, v_minus, false), combination(t, u_plus, s, v_plus, true)}, 2),
         power(of_amplitude(u_plus * u_minus + v_plus * v_minus), 2)},
        {s, of_amplitude(r.still_real)},
        {t, in_phase(r)}}});
}

void Statements::saddle_node(const AmplitudeRelation& relation, std::vector<Statement>& list) const {
  const Expression a = named("a", model_, 0);
  Statement statement{"saddle_node", {}, {}};
  statement.says = {"saddle-nodes at constant detuning and excitation: the squared relation and its derivative by ",
                    a, relation.divided > 0 ? " vanish together, the relation divided by " : " vanish together"};
  if (relation.divided > 0) {
    statement.says.emplace_back(power(a, relation.divided));
    statement.says.emplace_back(" and so without the zero solution");
  }
  if (monomials(relation.relation) > longest_polynomial) {
    statement.says.emplace_back(" (too long to be written out).");
  } else {
    statement.says.emplace_back(":");
    statement.equations = {{number(0), of_amplitude(relation.relation)}, {number(0), of_amplitude(relation.fold)}};
  }
  list.push_back(std::move(statement));
}

StatementSection Statements::steady() const {
  StatementSection section{"steady_states", "Steady states", {}};
  if (!c_.quadratures.empty())
    section.statements.push_back({"incomplete", {"Without the terms that are left to quadrature:"}, {}});
  const AmplitudeRelation relation = amplitude_relation(model_, c_);
  switch (relation.kind) {
    case AmplitudeRelation::Kind::none:
      free_or_none(section.statements);
      return section;
    case AmplitudeRelation::Kind::one_angle:
      one_angle(relation, section.statements);
      break;
    case AmplitudeRelation::Kind::opposite_angles:
      opposite_angles(relation, section.statements);
      break;
  }
  saddle_node(relation, section.statements);
  return section;
}

}  // namespace

std::vector<StatementSection> steady_sections(const CanonicalModel& model, const CanonicalCase& resonance) {
  const Statements statements(model, resonance);
  return {statements.jacobian(), statements.zero(), statements.steady()};
}

std::string plain_text(const std::vector<Run>& runs) {
  struct Writer {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const Code& code) const { return code.text; }
    std::string operator()(const Expression& formula) const { return plain_text(formula); }
  };
  std::string text;
  for (const Run& run : runs) text += std::visit(Writer{}, run);
  return text;
}

}  // namespace secular::typeset
