#include "codegen/canonical/evaluation.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "codegen/canonical/canonical_form.hpp"
#include "input/input_error.hpp"
#include "perturb/ordered_equation.hpp"

namespace secular {
namespace {

using Number = boost::multiprecision::cpp_bin_float_50;
using Json = nlohmann::ordered_json;

// A sum of 50-digit numbers this much smaller than the numbers has fewer than 30 digits, or is zero.
const Number most_cancellation("1e-20");

// A coefficient is evaluated term by term, without a common denominator. Where that leaves too few digits, or has
// no value, its canonical form has all digits or says what is wrong: it decides what is exactly zero.
class Evaluator {
 public:
  Evaluator(const Model& model, const std::map<std::string, double>& values, std::string values_file)
      : order_(symbol_order(model)),
        form_(model.symbols, order_),
        values_(values),
        values_file_(std::move(values_file)) {
    for (const std::string& name : order_) {
      const auto entry = values_.find(name);
      known_.push_back(name == "pi" || entry != values_.end());
      numbers_.push_back(name == "pi"    ? boost::math::constants::pi<Number>()
                         : known_.back() ? Number(entry->second)
                                         : Number(0));
    }
  }

  struct Value {
    Number real, imaginary;
  };
  Value value(const GiNaC::ex& coefficient) {
    const FractionTerms terms = form_.terms(coefficient);
    const auto part = [&](const FractionTerms& real) -> Number {
      const std::optional<Number> sum = by_terms(real);
      if (sum) return *sum;
      try {
        return canonical(form_.of(form_.sums().sum(real)));
      } catch (const PolynomialTooLarge& error) {
        throw InputError(values_file_, "",
                         fmt::format("leaves a coefficient no digits term by term, and it has {} when it is "
                                     "multiplied out",
                                     error.what()),
                         "choose values away from a resonance that the case does not list");
      }
    };
    return {part(real_part(terms)), part(imaginary_part(terms))};
  }

 private:
  std::optional<Number> by_terms(const FractionTerms& terms) {
    const FractionSums& sums = form_.sums();
    Number sum = 0, size = 0;
    for (const FractionTerm& term : terms) {
      Number product = quotient(term.real);
      for (std::size_t s = 0; s < order_.size(); ++s) {
        if (term.powers[s] == 0) continue;
        if (!known_[s] || (term.powers[s] < 0 && numbers_[s] == 0)) return std::nullopt;
        product *= boost::multiprecision::pow(numbers_[s], term.powers[s]);
      }
      for (const auto& [divisor, power] : term.divisors) {
        for (const std::size_t variable : sums.variables(divisor))
          if (!known_[variable]) return std::nullopt;
        for (std::size_t d = divisors_.size(); d <= divisor; ++d) divisors_.push_back(value_of(d));
        if (power > 0 && divisors_[divisor] == 0) return std::nullopt;
        product *= boost::multiprecision::pow(divisors_[divisor], -power);
      }
      sum += product;
      size += abs(product);
    }
    if (size != 0 && !(abs(sum) > most_cancellation * size)) return std::nullopt;
    return sum;
  }

  static Number quotient(const cln::cl_RA& value) {
    const auto number = [](const cln::cl_I& integer) { return Number(decimal_digits(integer)); };
    return number(cln::numerator(value)) / number(cln::denominator(value));
  }

  // Of a divisor; one that cancels to few digits counts as zero.
  Number value_of(std::size_t divisor) const {
    const Polynomial& p = form_.sums().divisor(divisor);
    const std::vector<std::size_t>& variables = form_.sums().variables(divisor);
    Number sum = 0, size = 0;
    for (std::size_t t = 0; t < p.size(); ++t) {
      Number product = quotient(p.coefficient(t));
      for (std::size_t v = 0; v < variables.size(); ++v)
        if (const int power = p.power(t, v); power != 0)
          product *= boost::multiprecision::pow(numbers_[variables[v]], power);
      sum += product;
      size += abs(product);
    }
    return abs(sum) > most_cancellation * size ? sum : Number(0);
  }

  Number canonical(const RationalFunction& f) const {
    if (f.is_zero()) return 0;
    const Number below = polynomial(f.denominator);
    if (below == 0) refuse_pole();
    return polynomial(f.numerator) / below;
  }

  Number polynomial(const std::vector<PolynomialTerm>& terms) const {
    Number sum = 0;
    for (const PolynomialTerm& term : terms) {
      Number product(term.coefficient);
      for (std::size_t i = 0; i < order_.size(); ++i) {
        if (term.exponents[i] == 0) continue;
        if (!known_[i])
          throw InputError(values_file_, "", "has no value for symbol '" + order_[i] + "'",
                           "give a number for every symbol of the model's equations, frequencies and detunings");
        product *= boost::multiprecision::pow(numbers_[i], term.exponents[i]);
      }
      for (const auto& [divisor, power] : term.divisors) {
        const Number below = polynomial(*divisor);
        if (below == 0) refuse_pole();
        product /= boost::multiprecision::pow(below, power);
      }
      sum += product;
    }
    return sum;
  }

  [[noreturn]] void refuse_pole() const {
    throw InputError(values_file_, "", "a denominator of the derivation is zero at these values",
                     "choose values away from a resonance that the case does not list");
  }

  const SymbolOrder order_;
  CanonicalForm form_;
  const std::map<std::string, double>& values_;
  std::string values_file_;
  std::vector<Number> numbers_;  // of symbols
  std::vector<bool> known_;
  std::vector<Number> divisors_;
};

double rounded(const Number& value) {
  const double result = value.convert_to<double>();
  return result == 0 ? 0.0 : result;  // no negative zero
}

Json powers_json(const Model& model, const CanonicalPowers& powers) {
  Json object = Json::object();
  const auto add = [&](const std::string& name, int power) {
    if (power != 0) object[name] = power;
  };
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    add("A_" + model.modes[k].coordinate, powers.amplitude[k]);
    add("conj_A_" + model.modes[k].coordinate, powers.conjugate[k]);
    add("abs_A_" + model.modes[k].coordinate, powers.modulus[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j) add(model.excitations[j].amplitude, powers.forcing[j]);
  return object;
}

Json slow_phase_json(const ResonanceCase& resonance, const CanonicalPowers& powers) {
  Json object = Json::object();
  for (std::size_t r = 0; r < resonance.relations.size(); ++r) {
    const ResonanceRelation& relation = resonance.relations[r];
    if (powers.slow_phase[r] == 0 || relation.detuning.empty()) continue;
    const GiNaC::numeric multiple = relation.coefficient * powers.slow_phase[r];
    if (multiple.is_integer())
      object[relation.detuning] = multiple.to_int();
    else
      object[relation.detuning] = multiple.to_double();
  }
  return object;
}

Json phase_json(const Model& model, const std::vector<int>& phase) {
  Json object = Json::object();
  for (std::size_t i = 0; i < phase.size(); ++i)
    if (phase[i] != 0) object[model.frequency_name(i)] = phase[i];
  return object;
}

}  // namespace

std::string evaluation_json(const Derivation& derivation, const std::map<std::string, double>& values,
                            const std::string& values_file) {
  const Model& model = *derivation.model;
  Evaluator evaluator(model, values, values_file);
  Json result;
  result["case"] = derivation.resonance->name;
  result["omega_policy"] = derivation.policy == OmegaPolicy::nominal ? "nominal" : "kept";
  Json modulation = Json::object(), harmonics = Json::object();
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    std::map<CanonicalPowers, std::pair<Number, Number>> sums;
    for (const UnreducedTerm& term : modulation_terms(derivation, k)) {
      const Evaluator::Value value = evaluator.value(term.coefficient);
      auto& [real, imaginary] = sums[term.powers];
      real += value.real;
      imaginary += value.imaginary;
    }
    Json terms = Json::array();
    for (const auto& [powers, value] : sums) {
      if (value.first == 0 && value.second == 0) continue;
      Json term;
      term["powers"] = powers_json(model, powers);
      term["slow_phase"] = slow_phase_json(*derivation.resonance, powers);
      term["value"] = {rounded(value.first), rounded(value.second)};
      terms.push_back(std::move(term));
    }
    modulation[model.modes[k].coordinate] = std::move(terms);
    Json listed = Json::array();
    for (const UnreducedTerm& term : harmonic_terms(derivation, k)) {
      const auto [real, imaginary] = evaluator.value(term.coefficient);
      if (real == 0 && imaginary == 0) continue;
      Json entry;
      entry["phase"] = phase_json(model, term.powers.phase);
      entry["powers"] = powers_json(model, term.powers);
      entry["order"] = term.order;
      entry["value"] = {rounded(real), rounded(imaginary)};
      listed.push_back(std::move(entry));
    }
    harmonics[model.modes[k].coordinate] = std::move(listed);
  }
  result["modulation"] = std::move(modulation);
  result["harmonics"] = std::move(harmonics);
  // Terms left to quadrature: dA_m/dt also holds value * mean(mean_of * exp(-i w_m t)).
  for (const QuadratureTerm& quadrature : derivation.quadratures) {
    const Evaluator::Value rate = evaluator.value(derivation.quadrature_rate(quadrature));
    Json entry;
    entry["mean_of"] = to_string(quadrature.factors, model);
    entry["order"] = quadrature.order;
    entry["value"] = {rounded(rate.real), rounded(rate.imaginary)};
    result["quadratures"][model.modes[quadrature.mode].coordinate].push_back(std::move(entry));
  }
  return result.dump(2) + "\n";
}

}  // namespace secular
