#include "thesis/verify/statement_check.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "perturb/prime_field.hpp"
#include "thesis/verify/evaluation.hpp"
#include "thesis/verify/order_equation.hpp"
#include "thesis/verify/scheme_check.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;

ex substituted(const ex& e, const GiNaC::exmap& values) {
  return e.subs(values, GiNaC::subs_options::no_pattern);
}

}  // namespace

StatementCheck::StatementCheck(const PrintedChapter& chapter, const Derivation& derivation)
    : derivation_(derivation), formula_(chapter, derivation) {
  const std::size_t modes = derivation.layout.modes;
  for (std::size_t k = 0; k < modes; ++k) {
    rate_.emplace_back();
    for (const Field& field : derivation.slow_derivative[k]) rate_.back().push_back(formula_.field(field));
    // exp(-i beta) dA/dt = (da + i a dbeta)/2
    ex sum = 0;
    for (const ex& rate : rate_.back()) sum += rate;
    const ex turned = formula_.in_polar_form(sum) / formula_.phase_factor(k), back = formula_.conjugated(turned);
    polar_rates_[formula_.amplitude_rate(k)] = turned + back;
    polar_rates_[formula_.phase_rate(k)] = (turned - back) / GiNaC::I / formula_.polar_amplitude(k);
  }
  polar_rates_[formula_.symbol("dgamma")] = substituted(formula_.gamma_rate(), polar_rates_);
}

const ex& StatementCheck::named(const PrintedStatement& statement, const char* key, const std::string& name) const {
  if (!formula_.is_symbol(name))
    statement.place.fail(key, "'" + name + "' is no symbol",
                         "a symbol of model " + derivation_.model->name + ", no definition");
  return formula_.symbol(name);
}

// What hangs on the model and its case; what does not is checked where the file is read.
void StatementCheck::require_possible(const PrintedStatement& statement) const {
  const int modes = static_cast<int>(rate_.size()), expanded = derivation_.resonance->expand_to;
  if (statement.mode < 0 || statement.mode >= modes)
    statement.place.fail("mode", "is " + std::to_string(statement.mode + 1),
                         "model " + derivation_.model->name + " has " + std::to_string(modes));
  // Equations of an order are written with D0, D1 and D2; derivatives by time are the first and the second.
  const bool by_time = statement.kind == "time_derivative";
  const int highest = by_time ? 2 : statement.kind == "order_equation" ? std::min(expanded, 2) : expanded;
  const int lowest = by_time || statement.kind == "forcing" ? 1 : 0;
  if (statement.order < lowest || statement.order > highest)
    statement.place.fail("order", "is " + std::to_string(statement.order),
                         "case " + derivation_.resonance->name + " has orders " + std::to_string(lowest) + " to " +
                             std::to_string(highest) + " of it");
  if (statement.kind == "real_response" && expanded < 1)
    statement.place.fail("kind", "is real_response", "case " + derivation_.resonance->name + " has no first order");
  const bool in_a_frame =
      statement.kind == "threshold" || statement.kind == "saddle_node" || statement.kind == "fixed_points";
  if (in_a_frame && (derivation_.layout.relations == 0 || formula_.gamma_phases()[0] == 0))
    statement.place.fail("kind", "is " + statement.kind,
                         "that needs an excited case, and a gamma that holds the phase of the first mode");
}

bool StatementCheck::vanishes_at_resonance(const ex& difference, const PrintedStatement& statement) const {
  GiNaC::exmap values;
  for (const std::string& name : statement.without) values[named(statement, "without", name)] = 0;
  for (const auto& [name, value] : statement.where) values[named(statement, "where", name)] = formula_.read(value);
  const ex at_resonance = formula_.at_resonance(substituted(difference, values));
  return value_at_random_point(at_resonance).is_zero();
}

ex StatementCheck::with_engine_rates(const ex& expression) const {
  GiNaC::exmap rates;
  for (std::size_t k = 0; k < rate_.size(); ++k) {
    for (std::size_t n = 1; n < rate_[k].size(); ++n) {
      rates[formula_.slow_derivative(k, static_cast<int>(n))] = rate_[k][n];
      rates[formula_.slow_derivative_conjugate(k, static_cast<int>(n))] = formula_.conjugated(rate_[k][n]);
    }
    // The integral of the source's nonsmooth damping, as the engine's closed form has it.
    if (derivation_.model->symbols.contains("mu2"))
      rates[formula_.symbol("ghat")] = -2 * GiNaC::I * derivation_.model->frequency(k) *
                                       rate_[k].back().diff(GiNaC::ex_to<GiNaC::symbol>(formula_.symbol("mu2")));
  }
  return substituted(expression, rates);
}

// Right-hand side at an order: what the solution of that order was made from.
ex StatementCheck::forcing(const PrintedStatement& statement) const {
  const auto k = static_cast<std::size_t>(statement.mode), n = static_cast<std::size_t>(statement.order);
  const Model& model = *derivation_.model;
  const ex omega = model.frequency(k);
  const ex solvable =
      2 * GiNaC::I * omega * (rate_[k][n] - formula_.slow_derivative(k, statement.order)) * formula_.wave(k);
  if (statement.only_secular) return solvable;
  ex sum = solvable + formula_.conjugated(solvable);
  for (const auto& [key, coefficient] : derivation_.response[k][n].terms()) {
    ex frequency = 0;
    for (std::size_t i = 0; i < derivation_.layout.frequencies(); ++i) frequency += key[i] * model.frequency(i);
    Field one;
    one.add(key, 1);
    sum += coefficient * (GiNaC::pow(omega, 2) - GiNaC::pow(frequency, 2)) * formula_.field(one);
  }
  return sum;
}

// -(2 i omega D_n A's coefficient at `term`)/times, of which the real part is meant where `times` is real.
ex StatementCheck::definition(const PrintedStatement& statement) const {
  const auto k = static_cast<std::size_t>(statement.mode);
  const ex monomial = formula_.read(*statement.term), times = formula_.read(*statement.times);
  ex coefficient = 0;
  const Field& field = derivation_.slow_derivative[k].back();
  for (const auto& [key, value] : field.terms()) {
    Field one;
    one.add(key, 1);
    if ((formula_.field(one) / monomial).is_equal(1)) coefficient += value;
  }
  const ex whole = (-2 * GiNaC::I * derivation_.model->frequency(k) * coefficient).expand();
  return times.info(GiNaC::info_flags::real) ? (whole.real_part() / times).expand()
                                             : (whole.imag_part() * GiNaC::I / times).expand();
}

bool StatementCheck::holds(const PrintedStatement& statement, const FormulaSource& text) const {
  require_possible(statement);
  return evaluated(text, [&] { return compared(statement, text); });
}

bool StatementCheck::compared(const PrintedStatement& statement, const FormulaSource& text) const {
  const auto k = static_cast<std::size_t>(statement.mode);
  const auto equals = [&] { return statement.equals ? formula_.read(*statement.equals) : ex(0); };
  if (statement.kind == "order_equation")
    return vanishes_at_resonance(formula_.read(text) - order_equation(formula_, derivation_, k, statement.order),
                                 statement);
  if (statement.kind == "forcing")
    return vanishes_at_resonance(formula_.read(text) - forcing(statement), statement);
  if (statement.kind == "response")
    return vanishes_at_resonance(
        formula_.read(text) - formula_.field(derivation_.response[k][static_cast<std::size_t>(statement.order)]),
        statement);
  if (statement.kind == "velocity") {
    const ex forward = GiNaC::I * derivation_.model->frequency(k) * formula_.amplitude(k) * formula_.wave(k);
    return vanishes_at_resonance(formula_.read(text) - forward - formula_.conjugated(forward), statement);
  }
  if (const auto scheme = scheme_difference(statement, text)) return vanishes_at_resonance(*scheme, statement);
  if (statement.kind == "phase") return phase_leaves_rates(statement, text);
  if (statement.kind == "line") return vanishes_at_resonance(formula_.difference(text), statement);
  if (statement.kind == "modulation")
    return vanishes_at_resonance(with_engine_rates(formula_.difference(text)), statement);
  if (statement.kind == "definition") {
    const ex scale = statement.scale ? formula_.read(*statement.scale) : ex(1);
    return vanishes_at_resonance(formula_.read(text) / scale - definition(statement), statement);
  }
  if (statement.kind == "polar")
    return vanishes_at_resonance(substituted(formula_.difference(text) - equals(), polar_rates_), statement);
  if (statement.kind == "real_response") {
    const ex& eps = formula_.symbol("eps");
    const ex ours = formula_.field(derivation_.response[k][0]) + eps * formula_.field(derivation_.response[k][1]);
    return vanishes_at_resonance(formula_.read(text) - formula_.in_polar_form(ours), statement);
  }
  if (statement.kind == "fixed_points") return holds_on_fixed_points(statement, text);
  if (statement.kind == "saddle_node") return holds_at_saddle_node(statement, text);
  if (statement.kind == "threshold") return holds_at_threshold(statement, text);
  if (statement.kind == "fourier_mean") return fourier_mean_holds(statement, text);
  if (statement.kind == "special_case")
    return vanishes_at_resonance(formula_.read(text) - formula_.read(*statement.of), statement);
  if (statement.kind == "identity") return vanishes_at_resonance(formula_.difference(text), statement);
  throw std::logic_error("no check for statements of kind " + statement.kind);
}

// What is left of a statement of what the derivation lays down; nothing for other kinds.
std::optional<ex> StatementCheck::scheme_difference(const PrintedStatement& statement,
                                                    const FormulaSource& text) const {
  const auto k = static_cast<std::size_t>(statement.mode);
  if (statement.kind == "motion") return formula_.difference(text) - ordered_motion(formula_, derivation_, k);
  if (statement.kind == "expansion") return formula_.read(text) - expansion(formula_, derivation_, k);
  if (statement.kind == "time_derivative") return formula_.read(text) - time_derivative(formula_, statement.order);
  if (statement.kind == "polar_form") return formula_.read(text) - formula_.in_polar_form(formula_.amplitude(k));
  if (statement.kind == "detuning")
    return substituted(formula_.difference(text), detuned_frequencies(formula_, derivation_));
  return {};
}

// The rates of a and beta hang on time and on beta through this combination of phases alone.
bool StatementCheck::phase_leaves_rates(const PrintedStatement& statement, const FormulaSource& text) const {
  const PrintedFormula::PhaseCombination turns = formula_.phase_combination(text);
  const GiNaC::exmap turned = turned_phases(formula_, turns.slow, turns.phases);
  return std::all_of(polar_rates_.begin(), polar_rates_.end(), [&](const auto& rate) {
    return vanishes_at_resonance(rate.second - substituted(rate.second, turned), statement);
  });
}

// Of a condition by what it is solved for, in which it has to be linear.
ex StatementCheck::slope_by(const PrintedStatement& statement, const ex& condition, const ex& unknown) const {
  const auto& symbol = GiNaC::ex_to<GiNaC::symbol>(unknown);
  const ex slope = condition.diff(symbol);
  if (vanishes(slope) || !vanishes(slope.diff(symbol)))
    statement.place.fail("solve_for", "'" + symbol.get_name() + "' is nothing that its condition is linear in",
                         "da = 0 is solved for the first name, dgamma = 0 for the second");
  return slope;
}

// With beta = 0 the slow wave is exp(i gamma); a' = gamma' = 0 gives two parameters, and the relation must follow.
bool StatementCheck::holds_on_fixed_points(const PrintedStatement& statement, const FormulaSource& text) const {
  GiNaC::exmap gauge;
  for (std::size_t k = 0; k < rate_.size(); ++k) gauge[formula_.phase_factor(k)] = 1;
  if (statement.at_peak) gauge[formula_.slow_wave(0)] = GiNaC::I;  // cos(gamma) = 0
  const ex amplitude_rate = substituted(polar_rates_.at(formula_.amplitude_rate(0)), gauge);
  const ex gamma_rate = substituted(polar_rates_.at(formula_.symbol("dgamma")), gauge);
  const ex first = named(statement, "solve_for", statement.solve_for.at(0)),
           second = named(statement, "solve_for", statement.solve_for.at(1));
  GiNaC::exmap solved;
  solved[first] = -amplitude_rate.subs(first == 0) / slope_by(statement, amplitude_rate, first);
  solved[second] = -gamma_rate.subs(second == 0) / slope_by(statement, gamma_rate, second);
  return vanishes_at_resonance(substituted(substituted(formula_.difference(text), gauge), solved), statement);
}

// On fixed points where the Jacobian of (a', gamma') by (a, gamma) is singular: two parameters from the fixed
// point, a third from the determinant, in which it is linear.
bool StatementCheck::holds_at_saddle_node(const PrintedStatement& statement, const FormulaSource& text) const {
  const GiNaC::exmap gauge{{formula_.phase_factor(0), 1}};
  const ex rate[] = {substituted(polar_rates_.at(formula_.amplitude_rate(0)), gauge),
                     substituted(polar_rates_.at(formula_.symbol("dgamma")), gauge)};
  const auto by = [](const ex& e, const ex& symbol) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)); };
  const ex &a = formula_.polar_amplitude(0), &wave = formula_.slow_wave(0);  // wave = exp(i gamma)
  const ex determinant = by(rate[0], a) * by(rate[1], wave) - by(rate[0], wave) * by(rate[1], a);
  GiNaC::exmap solved;
  for (std::size_t n = 0; n < 2; ++n) {
    const ex unknown = named(statement, "solve_for", statement.solve_for.at(n));
    solved[unknown] = -rate[n].subs(unknown == 0) / slope_by(statement, rate[n], unknown);
  }
  const ex third = named(statement, "solve_for", statement.solve_for.at(2));
  const ex singular = substituted(determinant, solved);
  const GiNaC::exmap last{{third, -singular.subs(third == 0) / by(singular, third).subs(third == 0)}};
  const ex difference = substituted(formula_.difference(text), gauge);
  return vanishes_at_resonance(substituted(substituted(difference, solved), last), statement);
}

// dB/dt = p B + q conj(B) in the frame of gamma: the trivial solution changes stability where |p|^2 = |q|^2.
bool StatementCheck::holds_at_threshold(const PrintedStatement& statement, const FormulaSource& text) const {
  const ex rate = rate_[0].back().expand();
  GiNaC::exmap at_zero{{formula_.amplitude(0), 0}, {formula_.conjugate_amplitude(0), 0}, {formula_.modulus(0), 0}};
  const auto linear = [&](const ex& by) {
    return substituted(rate.diff(GiNaC::ex_to<GiNaC::symbol>(by)), at_zero).subs(formula_.slow_wave(0) == 1);
  };
  // gamma = sigma T - 2 beta: the frame turns with half the slow phase.
  const ex frame = GiNaC::I * derivation_.model->symbols.at(derivation_.resonance->relations[0].detuning) *
                   formula_.gamma_slow()[0] / formula_.gamma_phases()[0];
  const ex p = linear(formula_.amplitude(0)) + frame, q = linear(formula_.conjugate_amplitude(0));
  const ex determinant = p * formula_.conjugated(p) - q * formula_.conjugated(q);
  const ex equals = statement.equals ? formula_.read(*statement.equals) : ex(0);
  return vanishes_at_resonance(
      substituted(formula_.difference(text) - equals, {{formula_.symbol("det"), determinant}}), statement);
}

// Mean of v'|v'| exp(-i omega T0) by the trapezoidal rule, which for a periodic function converges fast, against
// the engine's closed form.
bool StatementCheck::fourier_mean_holds(const PrintedStatement& statement, const FormulaSource& text) const {
  const auto k = static_cast<std::size_t>(statement.mode);
  const double omega = 1.7;
  const std::complex<double> a = std::polar(0.8, 0.6);
  const auto number = [&text](const ex& e) {
    const ex value = e.evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value))
      fail_at(text, {text.first_line, 1}, "holds a symbol without a value",
              "the mean is that of a velocity in A, its conjugate, E and the mode's frequency");
    const auto& n = GiNaC::ex_to<GiNaC::numeric>(value);
    return std::complex<double>(n.real().to_double(), n.imag().to_double());
  };
  const ex& damping = named(statement, "of", statement.mean_of);
  GiNaC::exmap values;
  for (const std::string& name : derivation_.model->symbols.names())
    values[derivation_.model->symbols.at(name)] = name == statement.mean_of ? 1 : 0;
  values[derivation_.model->frequency(k)] = omega;
  values[formula_.amplitude(k)] = a.real() + GiNaC::I * a.imag();
  values[formula_.conjugate_amplitude(k)] = a.real() - GiNaC::I * a.imag();
  values[formula_.modulus(k)] = std::abs(a);
  const ex closed =
      -2 * GiNaC::I * derivation_.model->frequency(k) * rate_[k].back().diff(GiNaC::ex_to<GiNaC::symbol>(damping));
  const ex printed = formula_.read(text);
  const std::complex<double> expected = number(substituted(closed, values));
  const int points = 4096;
  std::complex<double> mean = 0;
  for (int i = 0; i < points; ++i) {
    const double phase = 2 * std::numbers::pi * i / points;
    GiNaC::exmap here = values;
    here[formula_.wave(k)] = std::cos(phase) + GiNaC::I * std::sin(phase);
    const std::complex<double> velocity = number(substituted(printed, here));
    mean += velocity * std::abs(velocity) * std::polar(1.0, -phase) / static_cast<double>(points);
  }
  return std::abs(mean - expected) < 1e-5 * std::abs(expected);
}

}  // namespace secular::verify
