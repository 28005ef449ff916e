#include "codegen/canonical/evaluation.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "codegen/canonical/canonical_form.hpp"
#include "input/input_error.hpp"
#include "perturb/ordered_equation.hpp"

namespace secular {
namespace {

using Number = boost::multiprecision::cpp_bin_float_50;
using Json = nlohmann::ordered_json;

class Evaluator {
 public:
  Evaluator(const SymbolOrder& order, const std::map<std::string, double>& values, std::string values_file)
      : order_(order), values_(values), values_file_(std::move(values_file)) {}

  Number value(const RationalFunction& f) const {
    if (f.is_zero()) return 0;
    const Number below = polynomial(f.denominator);
    if (below == 0)
      throw InputError(values_file_, "", "a denominator of the derivation is zero at these values",
                       "choose values away from a resonance that the case does not list");
    return polynomial(f.numerator) / below;
  }

 private:
  Number polynomial(const std::vector<PolynomialTerm>& terms) const {
    Number sum = 0;
    for (const PolynomialTerm& term : terms) {
      Number product(term.coefficient);
      for (std::size_t i = 0; i < order_.size(); ++i)
        if (term.exponents[i] != 0) product *= boost::multiprecision::pow(symbol(i), term.exponents[i]);
      sum += product;
    }
    return sum;
  }

  Number symbol(std::size_t i) const {
    if (order_[i] == "pi") return boost::math::constants::pi<Number>();
    const auto entry = values_.find(order_[i]);
    if (entry == values_.end())
      throw InputError(values_file_, "", "has no value for symbol '" + order_[i] + "'",
                       "give a number for every symbol of the model's equations, frequencies and detunings");
    return Number(entry->second);
  }

  const SymbolOrder& order_;
  const std::map<std::string, double>& values_;
  std::string values_file_;
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
  const SymbolOrder order = symbol_order(model);
  const Evaluator evaluator(order, values, values_file);
  Json result;
  result["case"] = derivation.resonance->name;
  result["omega_policy"] = derivation.policy == OmegaPolicy::nominal ? "nominal" : "kept";
  Json modulation = Json::object(), harmonics = Json::object();
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    std::map<CanonicalPowers, std::pair<Number, Number>> sums;
    for (const CanonicalTerm& term : canonical_modulation(derivation, k, order)) {
      auto& [real, imaginary] = sums[term.powers];
      real += evaluator.value(term.real);
      imaginary += evaluator.value(term.imaginary);
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
    for (const CanonicalTerm& term : canonical_harmonics(derivation, k, order)) {
      const Number real = evaluator.value(term.real), imaginary = evaluator.value(term.imaginary);
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
  const CanonicalForm form(model.symbols, order);
  for (const QuadratureTerm& quadrature : derivation.quadratures) {
    const GiNaC::ex scale = derivation.quadrature_rate(quadrature);
    Json entry;
    entry["mean_of"] = to_string(quadrature.factors, model);
    entry["order"] = quadrature.order;
    entry["value"] = {rounded(evaluator.value(form.of(scale.real_part()))),
                      rounded(evaluator.value(form.of(scale.imag_part())))};
    result["quadratures"][model.modes[quadrature.mode].coordinate].push_back(std::move(entry));
  }
  return result.dump(2) + "\n";
}

}  // namespace secular
