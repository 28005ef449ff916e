#include "codegen/canonical/canonical_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "codegen/canonical/canonical_form.hpp"
#include "codegen/canonical/dimensions.hpp"
#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/function_expansion.hpp"
#include "perturb/lump_equations.hpp"
#include "perturb/ordered_equation.hpp"
#include "perturb/rest_position.hpp"
#include "perturb/term_sum.hpp"

namespace secular {
namespace {

// What rounding leaves depends on the order of terms, which changes from run to run.
constexpr double smallest_nonsmooth_error = 1e-14;

CanonicalRatio ratio(const GiNaC::numeric& value) {
  return {value.numer().to_int(), value.denom().to_int()};
}

CanonicalDimension canonical_dimension(const std::optional<Dimension>& dimension) {
  if (!dimension) return std::nullopt;
  std::vector<CanonicalRatio> exponents;
  for (const GiNaC::numeric& exponent : *dimension) exponents.push_back(ratio(exponent));
  return exponents;
}

CanonicalPowers powers_of(const FieldKey& key, const Derivation& d) {
  const FieldLayout& layout = d.layout;
  CanonicalPowers powers;
  for (std::size_t k = 0; k < layout.modes; ++k) {
    powers.amplitude.push_back(key[layout.amplitude(k)]);
    powers.conjugate.push_back(key[layout.conjugate(k)]);
    powers.modulus.push_back(key[layout.modulus(k)]);
  }
  for (std::size_t j = 0; j < layout.excitations; ++j) powers.forcing.push_back(key[layout.forcing(j)]);
  powers.phase = d.full_phase(key);
  for (std::size_t r = 0; r < layout.relations; ++r) powers.slow_phase.push_back(key[layout.slow(r)]);
  return powers;
}

// Sums by order and powers.
class TermList {
 public:
  void add(int order, CanonicalPowers powers, const GiNaC::ex& coefficient) {
    sums_[{order, std::move(powers)}] += coefficient;
  }
  std::vector<UnreducedTerm> terms() const {
    std::vector<UnreducedTerm> result;
    for (const auto& [key, coefficient] : sums_) result.push_back({key.second, key.first, coefficient});
    return result;
  }

 private:
  std::map<std::pair<int, CanonicalPowers>, GiNaC::ex> sums_;
};

std::vector<CanonicalTerm> canonical_terms(const std::vector<UnreducedTerm>& terms, const CanonicalForm& form) {
  std::vector<CanonicalTerm> result;
  for (const UnreducedTerm& term : terms) {
    CanonicalForm::Parts parts = form.parts(term.coefficient);
    if (!parts.real.is_zero() || !parts.imaginary.is_zero())
      result.push_back({term.powers, term.order, std::move(parts.real), std::move(parts.imaginary)});
  }
  return result;
}

std::string phase_name(const std::vector<int>& phase, const Model& model) {
  std::string name;
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == 0) continue;
    const std::string multiple = std::abs(phase[i]) == 1 ? "" : std::to_string(std::abs(phase[i])) + "*";
    name += (phase[i] < 0 ? "-" : (name.empty() ? "" : "+")) + multiple + model.frequency_name(i);
  }
  return name.empty() ? "0" : name;
}

std::vector<CanonicalMotionTerm> canonical_sum(const TermSum& sum, const CanonicalForm& form);

CanonicalFactor canonical_factor(const Factor& factor, int power, const CanonicalForm& form) {
  CanonicalFactor flat;
  flat.index = static_cast<std::size_t>(factor.index);
  flat.derivative = factor.derivative;
  flat.multiple = factor.multiple;
  flat.power = power;
  for (const auto& [name, weight] : factor.argument)
    flat.argument.emplace_back(name,
                               CanonicalRatio{static_cast<int>(weight.first), static_cast<int>(weight.second)});
  static constexpr CanonicalFactor::Kind motion[] = {
      CanonicalFactor::Kind::displacement, CanonicalFactor::Kind::velocity, CanonicalFactor::Kind::acceleration};
  switch (factor.kind) {
    case Factor::Kind::coordinate:
      flat.kind = motion[factor.derivative];
      break;
    case Factor::Kind::excitation:
      flat.kind = CanonicalFactor::Kind::excitation;
      break;
    case Factor::Kind::clock_cos:
      flat.kind = CanonicalFactor::Kind::clock_cos;
      break;
    case Factor::Kind::clock_sin:
      flat.kind = CanonicalFactor::Kind::clock_sin;
      break;
    case Factor::Kind::absolute:
      flat.kind = CanonicalFactor::Kind::absolute;
      break;
    case Factor::Kind::sign:
      flat.kind = CanonicalFactor::Kind::sign;
      break;
    case Factor::Kind::smooth:
      flat.kind = CanonicalFactor::Kind::smooth;
      flat.function = factor.function.kind();
      flat.exponent = {static_cast<int>(factor.function.exponent().first),
                       static_cast<int>(factor.function.exponent().second)};
      flat.inner = canonical_sum(factor.function.argument(), form);
      break;
  }
  return flat;
}

// Of terms without accelerations.
std::vector<CanonicalMotionTerm> canonical_sum(const TermSum& sum, const CanonicalForm& form) {
  std::vector<CanonicalMotionTerm> terms;
  for (const auto& [product, coefficient] : sum.terms()) {
    CanonicalMotionTerm& term = terms.emplace_back();
    term.coefficient = form.of(coefficient);
    for (const auto& [factor, power] : product) term.factors.push_back(canonical_factor(factor, power, form));
  }
  return terms;
}

// What a model about its rest position has beside others.
void add_rest(const Model& model, const CanonicalForm& form, CanonicalModel& result) {
  if (!model.rest) return;
  const auto plain = [&](const Expression& formula) {
    return form.of(formula_value(
        formula, {}, [&](const Expression& symbol) -> GiNaC::ex { return model.symbols.at(symbol.text); }));
  };
  for (const RestValue& value : model.rest->values)
    result.rest_values.push_back({value.name,
                                  value.kind,
                                  {static_cast<int>(value.exponent.first), static_cast<int>(value.exponent.second)},
                                  plain(value.argument),
                                  plain(model.rest->slope(value))});
  for (const HeldCoefficient& held : model.rest->held)
    result.following.push_back({held.name, plain(parse_expression({held.text, model.file, 1}))});
}

std::vector<CanonicalSeries> canonical_series(const Model& model, const ResonanceCase& resonance,
                                              const CanonicalForm& form) {
  std::map<SmoothFunction, int> degrees;
  for (const OrderedEquation& equation : ordered_equations(model, resonance))
    for (const ExpandedFunction& expanded : equation.expanded) {
      const auto [known, added] = degrees.try_emplace(expanded.function, expanded.degree);
      known->second = std::max(known->second, expanded.degree);
    }
  std::vector<CanonicalSeries> result;
  for (const auto& [function, degree] : degrees) {
    Factor factor{Factor::Kind::smooth, 0, 0, 1};
    factor.function = function;
    result.push_back(
        {canonical_factor(factor, 1, form), degree, canonical_sum(FunctionExpansions(degree).of(function), form)});
    std::stable_sort(result.back().terms.begin(), result.back().terms.end(), [](const auto& a, const auto& b) {
      const auto total = [](const CanonicalMotionTerm& term) {
        int sum = 0;
        for (const CanonicalFactor& f : term.factors) sum += f.power;
        return sum;
      };
      return total(a) < total(b);
    });
  }
  return result;
}

std::vector<CanonicalMotionTerm> motion_terms(const Model& model, const TermSum& equation,
                                              const CanonicalForm& form, std::size_t mode) {
  std::vector<CanonicalMotionTerm> terms;
  for (const auto& [product, coefficient] : equation.terms()) {
    CanonicalMotionTerm term;
    term.coefficient = form.of(coefficient);
    for (const auto& [factor, power] : product) {
      CanonicalFactor flat = canonical_factor(factor, power, form);
      if (flat.kind != CanonicalFactor::Kind::acceleration) {
        term.factors.push_back(std::move(flat));
        continue;
      }
      if (power > 1 || term.acceleration_of)
        throw InputError(model.file, "equation of '" + model.modes[mode].coordinate + "'",
                         "is not linear in the accelerations", "D2 may enter once in every term");
      term.acceleration_of = flat.index;
    }
    terms.push_back(std::move(term));
  }
  return terms;
}

// How often canonical_case() tells that a step is done.
constexpr std::size_t steps_of_case = 5;

CanonicalCase canonical_case(const Model& model, const ResonanceCase& resonance, const CanonicalForm& form,
                             const std::map<std::string, Dimension>& dimensions, CanonicalContent content,
                             const std::function<void()>& step_done) {
  const Derivation nominal = derive(model, resonance, OmegaPolicy::nominal);
  step_done();
  const Derivation kept = derive(model, resonance, OmegaPolicy::kept);
  step_done();
  CanonicalCase result;
  result.name = resonance.name;
  result.expand_to = resonance.expand_to;
  result.excited = resonance.excited;
  result.mode_at_rest = resonance.mode_at_rest;
  for (const ResonanceRelation& relation : resonance.relations) {
    std::vector<int> multiples = relation.multiples;
    multiples.resize(model.frequency_count(), 0);
    result.relations.push_back(
        {multiples, relation.detuning, relation.order, ratio(relation.coefficient), relation.text});
  }
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    result.slow_derivative.push_back(canonical_terms(modulation_terms(nominal, k), form));
    result.harmonics.emplace_back();
    if (content == CanonicalContent::all)
      result.harmonics.back() = canonical_terms(harmonic_terms(nominal, k), form);
  }
  step_done();
  for (const QuadratureTerm& quadrature : nominal.quadratures) {
    CanonicalForm::Parts rate = form.parts(nominal.quadrature_rate(quadrature));
    CanonicalQuadrature flat{
        quadrature.mode, quadrature.order, std::move(rate.real), std::move(rate.imaginary), {}};
    for (const auto& [factor, power] : quadrature.factors)
      flat.factors.push_back(canonical_factor(factor, power, form));
    result.quadratures.push_back(std::move(flat));
  }
  result.series = canonical_series(model, resonance, form);
  const Certificate certificate = certify(nominal);
  result.certificate = {certificate.holds,
                        certificate.order,
                        certificate.coefficients_checked,
                        certificate.nonsmooth_harmonics,
                        std::max(certificate.nonsmooth_error, smallest_nonsmooth_error),
                        certificate.remainders};
  result.warnings = nominal.warnings;
  if (resonance.automatic_order) result.chosen_orders = resonance.order;
  step_done();
  if (!observed_frequencies(nominal)) {
    step_done();
    return result;
  }
  const LumpEquations seen = lump_equations(nominal, kept, form.sums());
  for (const auto& row : seen.frequencies.of_mode) {
    std::vector<CanonicalRatio> ratios;
    for (const GiNaC::numeric& multiple : row) ratios.push_back(ratio(multiple));
    result.observed_frequency.push_back(std::move(ratios));
  }
  for (const Lump& lump : seen.lumps)
    result.lumps.push_back({lump.name, form.of(lump.definition),
                            canonical_dimension(dimension_of(lump.definition, dimensions, model))});
  for (const LumpEquation& block : seen.blocks) {
    CanonicalBlock flat;
    flat.modulation = block.modulation;
    flat.mode = block.mode;
    flat.order = block.order;
    flat.phase = block.phase;
    flat.name = (block.modulation ? "modulation of " : "harmonic " + phase_name(block.phase, model) + " of ") +
                model.modes[block.mode].coordinate;
    for (const LumpEquation::Column& column : block.columns) {
      CanonicalBlock::Column terms{column.lump, {}};
      for (const ColumnTerm& term : column.terms)
        terms.terms.push_back(
            {form.of(term.factor), term.imaginary, powers_of(term.key, block.modulation ? nominal : kept)});
      flat.columns.push_back(std::move(terms));
    }
    std::sort(flat.columns.begin(), flat.columns.end(),
              [](const auto& a, const auto& b) { return a.lump < b.lump; });
    result.blocks.push_back(std::move(flat));
  }
  step_done();
  return result;
}

// FNV-1a over a plain serialisation of everything that code is made from: whatever of the file changes what the
// compiled model does changes it.
class Digest {
 public:
  void add(const std::string& text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix('\n');
  }
  void add(const std::vector<std::string>& texts) { add(fmt::format("{}", fmt::join(texts, "\n"))); }
  void add(const std::vector<int>& numbers) { add(fmt::format("{}", fmt::join(numbers, " "))); }
  void add(const CanonicalRatio& ratio) { add(fmt::format("{}/{}", ratio.numerator, ratio.denominator)); }
  void add(const CanonicalDimension& dimension) {
    add(std::string(dimension ? "dimension" : "none"));
    if (!dimension) return;
    for (const CanonicalRatio& power : *dimension) add(power);
  }
  // Terms are many: symbols and powers that are not zero as numbers, a divisor by the number of its first
  // occurrence.
  void add(const std::vector<PolynomialTerm>& terms) {
    mix(terms.size());
    for (const PolynomialTerm& term : terms) {
      add(term.coefficient);
      for (std::size_t i = 0; i < term.exponents.size(); ++i)
        if (term.exponents[i] != 0) mix(i << 32U | static_cast<std::uint32_t>(term.exponents[i]));
      for (const auto& [sum, power] : term.divisors) {
        const auto [known, added] = divisors_.try_emplace(sum.get(), divisors_.size());
        if (added) add(*sum);
        mix(known->second << 32U | static_cast<std::uint32_t>(power));
      }
    }
  }
  void add(const RationalFunction& f) {
    add(f.numerator);
    add(f.denominator);
  }
  void add(const CanonicalPowers& p) {
    for (const auto* part : {&p.amplitude, &p.conjugate, &p.modulus, &p.forcing, &p.phase, &p.slow_phase})
      add(*part);
  }
  void add(const CanonicalFactor& f) {
    add(fmt::format("{} {} {} {} {}", static_cast<int>(f.kind), f.index, f.derivative, f.multiple, f.power));
    for (const auto& [name, weight] : f.argument) {
      add(name);
      add(weight);
    }
    if (f.kind != CanonicalFactor::Kind::smooth) return;
    add(fmt::format("{} {}", static_cast<int>(f.function), f.inner.size()));
    add(f.exponent);
    for (const CanonicalMotionTerm& term : f.inner) add(term);
  }
  void add(const CanonicalMotionTerm& term) {
    add(term.coefficient);
    add(term.acceleration_of ? std::to_string(*term.acceleration_of) : "-");
    for (const CanonicalFactor& f : term.factors) add(f);
  }
  void add(const CanonicalBlock& block) {
    add(fmt::format("{} {} {} {}", block.modulation, block.mode, block.order, block.name));
    add(block.phase);
    for (const CanonicalBlock::Column& column : block.columns) {
      add(std::to_string(column.lump));
      for (const CanonicalColumnTerm& term : column.terms) {
        add(term.factor);
        add(std::string(term.imaginary ? "i" : "1"));
        add(term.powers);
      }
    }
  }
  void add(const CanonicalCase& c) {
    add(fmt::format("{} {} {}", c.name, c.expand_to, c.excited));
    for (const bool rest : c.mode_at_rest) add(std::string(rest ? "at rest" : "moves"));
    for (const CanonicalRelation& relation : c.relations) {
      add(relation.text);
      add(relation.multiples);
      add(fmt::format("{} {}", relation.detuning, relation.order));
    }
    for (const CanonicalLump& lump : c.lumps) {
      add(lump.name);
      add(lump.definition);
      add(lump.dimension);
    }
    for (const auto& terms : c.slow_derivative)
      for (const CanonicalTerm& term : terms) {
        add(term.powers);
        add(std::to_string(term.order));
        add(term.real);
        add(term.imaginary);
      }
    for (const CanonicalQuadrature& q : c.quadratures) {
      add(fmt::format("{} {}", q.mode, q.order));
      add(q.real);
      add(q.imaginary);
      for (const CanonicalFactor& f : q.factors) add(f);
    }
    for (const auto& ratios : c.observed_frequency)
      for (const CanonicalRatio& ratio : ratios) add(ratio);
    for (const CanonicalBlock& block : c.blocks) add(block);
  }
  void add(const CanonicalModel& model) {
    for (const auto* names : {&model.coordinates, &model.natural_frequencies, &model.excitations,
                              &model.excitation_frequencies, &model.parameters, &model.order})
      add(*names);
    for (const std::string& name : model.strengths) add("strength " + name);
    for (const CanonicalDimension& dimension : model.parameter_dimensions) add(dimension);
    for (const std::optional<double>& value : model.nominal) add(value ? fmt::format("{:a}", *value) : "none");
    for (const CanonicalRestValue& value : model.rest_values) {
      add(fmt::format("{} {}", value.name, static_cast<int>(value.function)));
      add(value.exponent);
      add(value.argument);
      add(value.slope);
    }
    for (const auto& equation : model.motion)
      for (const CanonicalMotionTerm& term : equation) add(term);
    for (const CanonicalCase& c : model.cases) add(c);
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void mix(std::uint64_t value) { hash_ = (hash_ ^ value) * 1099511628211ULL; }

  std::uint64_t hash_ = 14695981039346656037ULL;
  std::map<const void*, std::size_t> divisors_;
};

std::string fingerprint(const CanonicalModel& model) {
  Digest digest;
  digest.add(model);
  return digest.text();
}

}  // namespace

bool has_smooth_functions(const CanonicalModel& model) {
  if (!model.rest_values.empty()) return true;
  for (const auto& equation : model.motion)
    for (const CanonicalMotionTerm& term : equation)
      for (const CanonicalFactor& factor : term.factors)
        if (factor.kind == CanonicalFactor::Kind::smooth) return true;
  return false;
}

SymbolOrder symbol_order(const Model& model) {
  SymbolOrder order;
  for (std::size_t i = 0; i < model.frequency_count(); ++i) order.push_back(model.frequency_name(i));
  for (const std::string& name : model.symbols.names())
    if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
  order.push_back("pi");
  return order;
}

std::vector<UnreducedTerm> modulation_terms(const Derivation& derivation, std::size_t mode) {
  TermList list;
  for (std::size_t n = 0; n < derivation.slow_derivative[mode].size(); ++n)
    for (const auto& [key, coefficient] : derivation.slow_derivative[mode][n].terms())
      list.add(static_cast<int>(n), powers_of(key, derivation), coefficient);
  return list.terms();
}

std::vector<UnreducedTerm> harmonic_terms(const Derivation& derivation, std::size_t mode) {
  TermList list;
  for (std::size_t n = 0; n < derivation.response[mode].size(); ++n)
    for (const auto& [key, coefficient] : derivation.response[mode][n].terms()) {
      CanonicalPowers powers = powers_of(key, derivation);
      std::vector<int> own(powers.phase.size(), 0);
      own[mode] = 1;
      Phase oriented = powers.phase;
      if (orient(oriented, derivation)) continue;  // the conjugate is listed
      if (n == 0 && powers.phase == own) continue;
      std::fill(powers.slow_phase.begin(), powers.slow_phase.end(), 0);  // it is part of the true phase
      list.add(static_cast<int>(n), std::move(powers), coefficient);
    }
  return list.terms();
}

std::vector<CanonicalTerm> canonical_modulation(const Derivation& derivation, std::size_t mode,
                                                const SymbolOrder& order) {
  return canonical_terms(modulation_terms(derivation, mode), CanonicalForm(derivation.model->symbols, order));
}

std::vector<CanonicalTerm> canonical_harmonics(const Derivation& derivation, std::size_t mode,
                                               const SymbolOrder& order) {
  return canonical_terms(harmonic_terms(derivation, mode), CanonicalForm(derivation.model->symbols, order));
}

CanonicalModel canonical_model(const Model& model, const std::string& only_case, CanonicalContent content,
                               const CanonicalProgress& progress) {
  if (!only_case.empty()) model.find_case(only_case);
  CanonicalModel result;
  result.name = model.name;
  result.source = model.source;
  result.order = symbol_order(model);
  const CanonicalForm form(model.symbols, result.order);
  add_rest(model, form, result);
  const std::vector<TermSum> equations = equations_of_motion(model);
  const std::map<std::string, Dimension> dimensions = symbol_dimensions(model, equations);
  for (const Mode& mode : model.modes) {
    result.coordinates.push_back(mode.coordinate);
    result.natural_frequencies.push_back(mode.frequency);
  }
  for (const Excitation& excitation : model.excitations) {
    result.excitations.push_back(excitation.amplitude);
    result.excitation_frequencies.push_back(excitation.frequency);
  }
  result.parameters = result.natural_frequencies;
  result.parameters.insert(result.parameters.end(), model.parameters.begin(), model.parameters.end());
  result.strengths = model.strengths;
  for (const std::string& name : result.parameters) {
    const auto dimension = dimensions.find(name);
    result.parameter_dimensions.push_back(
        canonical_dimension(dimension == dimensions.end() ? std::nullopt : std::optional(dimension->second)));
    const auto value = model.nominal.find(name);
    result.nominal.push_back(value == model.nominal.end() ? std::nullopt : std::optional(value->second));
  }
  std::string place;
  try {
    for (std::size_t k = 0; k < equations.size(); ++k) {
      place = "equation of '" + model.modes[k].coordinate + "'";
      result.motion.push_back(motion_terms(model, equations[k], form, k));
    }
    std::size_t done = 0;
    const std::size_t steps = steps_of_case * (only_case.empty() ? model.cases.size() : 1);
    const auto step_done = [&] {
      if (progress) progress(++done, steps);
    };
    for (const ResonanceCase& resonance : model.cases) {
      if (!only_case.empty() && resonance.name != only_case) continue;
      place = resonance.place();
      result.cases.push_back(canonical_case(model, resonance, form, dimensions, content, step_done));
    }
  } catch (const PolynomialTooLarge& error) {
    throw InputError(model.file, place, fmt::format("has {} in its expansion", error.what()),
                     "lower expand_to or leave out modes, terms or cases; `secular evaluate` gives its numbers as "
                     "it is");
  }
  result.fingerprint = fingerprint(result);
  return result;
}

}  // namespace secular
