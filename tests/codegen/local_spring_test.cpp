// Forces between points of a structure, written in modal coordinates: b*(v0 + v1 + ...)^n in every equation. Every
// mode meets every other one with all their small divisors, which is what canonical forms grow with.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_form.hpp"
#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/evaluation.hpp"
#include "codegen/expression/cpp_expression.hpp"
#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

struct Structure {
  std::string name;
  int modes;
  std::string force;   ///< in equation {0}; {1} is v0 + v1 + ..., {2} phi0*v0 + phi1*v1 + ..., {3} D(v0) + ...
  std::string orders;  ///< of its parameters
  std::string relations = "\"Omega = w0 + eps^2*sigma\"";
};

std::ostream& operator<<(std::ostream& stream, const Structure& structure) {
  return stream << structure.name;
}

Structure local_spring(int modes, int power) {
  return {fmt::format("spring_{}_{}", modes, power), modes, fmt::format("- b*({{1}})^{}", power), "b = 1"};
}

Model model_of(const Structure& structure) {
  std::string sum, weighted, rates, text = "schema = 1\nname = \"m\"\n", orders = structure.orders;
  for (int i = 0; i < structure.modes; ++i) {
    const std::string plus = i > 0 ? "+" : "";
    sum += fmt::format("{}v{}", plus, i);
    weighted += fmt::format("{0}phi{1}*v{1}", plus, i);
    rates += fmt::format("{}D(v{})", plus, i);
    orders += fmt::format(", mu{} = 2", i);
    if (structure.force.find("{2}") != std::string::npos) orders += fmt::format(", phi{} = 0", i);
  }
  for (int i = 0; i < structure.modes; ++i)
    text += fmt::format(
        "[[mode]]\ncoordinate = \"v{0}\"\nfrequency = \"w{0}\"\nequation = \"D2(v{0}) + w{0}^2*v{0} = "
        "-2*mu{0}*D(v{0}) {1} + f*F*cos(Omega*t)\"\n",
        i, fmt::format(fmt::runtime(structure.force), i, sum, weighted, rates));
  text += fmt::format("[[case]]\nname = \"c\"\nrelations = [{}]\norder = {{ f = 2, {} }}\nexpand_to = 2\n",
                      structure.relations, orders);
  return read_model_text(text, "model.toml");
}

// Rational values of all symbols but Pi, in their order.
std::vector<GiNaC::numeric> rational_point(const SymbolOrder& order, std::mt19937_64& random) {
  std::vector<GiNaC::numeric> values;
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    values.push_back(GiNaC::numeric(static_cast<long>(1 + random() % 9973)) / static_cast<long>(1 + random() % 97));
  return values;
}

GiNaC::numeric value_of(const std::vector<PolynomialTerm>& terms, const std::vector<GiNaC::numeric>& point) {
  GiNaC::numeric sum = 0;
  for (const PolynomialTerm& term : terms) {
    GiNaC::numeric product(term.coefficient.c_str());
    for (std::size_t i = 0; i < point.size(); ++i)
      if (term.exponents[i] != 0) product *= point[i].power(term.exponents[i]);
    for (const DivisorPower& divisor : term.divisors) product /= value_of(*divisor.sum, point).power(divisor.power);
    sum += product;
  }
  return sum;
}

GiNaC::numeric value_of(const RationalFunction& f, const std::vector<GiNaC::numeric>& point) {
  return value_of(f.numerator, point) / value_of(f.denominator, point);
}

// Terms and divisors that are written.
std::size_t terms_in(const RationalFunction& f) {
  std::size_t count = 0;
  for (const Fraction& part : fractions(f)) count += part.numerator.size() + part.divisors.size();
  return count;
}

class LocalForce : public testing::TestWithParam<Structure> {};

TEST_P(LocalForce, CanonicalFormsHaveTheValuesOfTheTermsThatTheyJoin) {
  const Model model = model_of(GetParam());
  const SymbolOrder order = symbol_order(model);
  const Derivation derivation = derive(model, model.cases[0]);
  EXPECT_TRUE(certify(derivation).holds);
  std::mt19937_64 random(11);
  const std::vector<GiNaC::numeric> point = rational_point(order, random);
  GiNaC::exmap values;
  for (std::size_t i = 0; i < point.size(); ++i) values[model.symbols.at(order[i])] = point[i];
  const CanonicalForm form(model.symbols, order);
  std::size_t several = 0;
  for (std::size_t k = 0; k < model.modes.size(); ++k)
    for (const bool harmonics : {false, true})
      for (const UnreducedTerm& term :
           harmonics ? harmonic_terms(derivation, k) : modulation_terms(derivation, k)) {
        const CanonicalForm::Parts parts = form.parts(term.coefficient);
        const GiNaC::ex truth = term.coefficient.subs(values, GiNaC::subs_options::no_pattern);
        ASSERT_TRUE((truth - value_of(parts.real, point) - GiNaC::I * value_of(parts.imaginary, point)).is_zero())
            << term.coefficient;
        several += GiNaC::is_a<GiNaC::add>(term.coefficient) ? 1U : 0U;
      }
  EXPECT_GT(several, 0U);
}

TEST_P(LocalForce, LumpsTimesTheirFactorsAreTheTerms) {
  const Model model = model_of(GetParam());
  const CanonicalModel canonical = canonical_model(model);
  const CanonicalCase& resonance = canonical.cases.front();
  ASSERT_FALSE(resonance.lumps.empty());
  std::mt19937_64 random(12);
  std::vector<GiNaC::numeric> point = rational_point(canonical.order, random);
  // Where the resonances are exact: there detunings are zero, and lumps times factors are the terms as listed.
  const auto at = [&](const std::string& name) -> GiNaC::numeric& {
    return point[static_cast<std::size_t>(std::find(canonical.order.begin(), canonical.order.end(), name) -
                                          canonical.order.begin())];
  };
  if (GetParam().relations.find("w2 = 2*w0") != std::string::npos) at("w2") = 2 * at("w0");
  at("Omega") = at("w0");
  for (const CanonicalRelation& relation : resonance.relations) at(relation.detuning) = 0;
  for (const CanonicalBlock& block : resonance.blocks) {
    if (!block.modulation) continue;
    std::map<CanonicalPowers, GiNaC::ex> sums;
    for (const CanonicalTerm& term : resonance.slow_derivative[block.mode]) {
      CanonicalPowers powers = term.powers;
      sums[powers] += value_of(term.real, point) + GiNaC::I * value_of(term.imaginary, point);
    }
    for (const CanonicalBlock::Column& column : block.columns)
      for (const CanonicalColumnTerm& term : column.terms)
        sums[term.powers] -= value_of(resonance.lumps[column.lump].definition, point) *
                             value_of(term.factor, point) * (term.imaginary ? GiNaC::ex(GiNaC::I) : GiNaC::ex(1));
    for (const auto& [powers, left] : sums) EXPECT_TRUE(left.is_zero()) << block.name << ": " << left;
  }
}

TEST_P(LocalForce, NumbersTermByTermAreThoseOfTheCanonicalForm) {
  const Model model = model_of(GetParam());
  const SymbolOrder order = symbol_order(model);
  const Derivation derivation = derive(model, model.cases[0]);
  std::mt19937_64 random(13);
  std::map<std::string, double> values;
  std::vector<GiNaC::numeric> point;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const long numerator = 16384 + static_cast<long>(random() % 65536);
    values[order[i]] = static_cast<double>(numerator) / 32768;
    point.push_back(GiNaC::numeric(numerator) / 32768);
  }
  const nlohmann::json json = nlohmann::json::parse(evaluation_json(derivation, values, "values"));
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    const nlohmann::json& listed = json["harmonics"][model.modes[k].coordinate];
    std::size_t next = 0;
    for (const CanonicalTerm& term : canonical_harmonics(derivation, k, order)) {
      const GiNaC::numeric real = value_of(term.real, point), imaginary = value_of(term.imaginary, point);
      if (real.is_zero() && imaginary.is_zero()) continue;
      ASSERT_LT(next, listed.size());
      EXPECT_DOUBLE_EQ(listed[next]["value"][0].get<double>(), real.to_double());
      EXPECT_DOUBLE_EQ(listed[next]["value"][1].get<double>(), imaginary.to_double());
      ++next;
    }
    EXPECT_EQ(next, listed.size());
  }
}

std::string name_of(const testing::TestParamInfo<Structure>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Few, LocalForce,
                         testing::Values(local_spring(3, 2), local_spring(2, 3),
                                         Structure{"shape_numbers", 3, "- b*phi{0}*({2})^2", "b = 1"},
                                         Structure{"shape_numbers_cubic", 2, "- b*phi{0}*({2})^3", "b = 1"},
                                         Structure{"quadratic_damper", 3, "- b*({3})^2", "b = 1"},
                                         Structure{"two_springs", 3, "- b*({1})^2 - c*(1+{0})*(v0 - v1 + 2*v2)^2",
                                                   "b = 1, c = 1"}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(SlowOnes, LocalForce,
                         testing::Values(local_spring(4, 2), local_spring(3, 3),
                                         Structure{"damper", 3, "- b*({3})^3", "b = 1"},
                                         Structure{"internal_resonance", 4, "- b*({1})^2", "b = 1",
                                                   "\"Omega = w0 + eps^2*sigma\", \"w2 = 2*w0 + eps*sigma2\""}),
                         name_of);

// All coefficients of a case with their summands.
template <class Visit>
void for_each_coefficient(const Derivation& derivation, const Visit& visit) {
  for (std::size_t k = 0; k < derivation.model->modes.size(); ++k)
    for (const bool harmonics : {false, true})
      for (const UnreducedTerm& term : harmonics ? harmonic_terms(derivation, k) : modulation_terms(derivation, k))
        visit(term.coefficient);
}

// Counted, not timed: a term of a result is made about once for every divisor of its sum, a few for every mode.
TEST(LocalSpring, WorkGrowsWithWhatIsWritten) {
  for (const int modes : {2, 3, 4}) {
    const Model model = model_of(local_spring(modes, 2));
    const Derivation derivation = derive(model, model.cases[0]);
    const CanonicalForm form(model.symbols, symbol_order(model));
    std::size_t written = 0;
    for_each_coefficient(derivation, [&](const GiNaC::ex& coefficient) {
      const CanonicalForm::Parts parts = form.parts(coefficient);
      written += terms_in(parts.real) + terms_in(parts.imaginary);
    });
    EXPECT_LT(form.work(), 4 * static_cast<std::size_t>(modes) * written) << modes << " modes";
  }
}

// No coefficient takes more terms and divisors than the fractions that the expansion made it of, and its text grows
// with these.
TEST(LocalSpring, TextIsNoLongerThanTheFactoredForm) {
  for (const int modes : {2, 3, 4}) {
    const Model model = model_of(local_spring(modes, 2));
    const Derivation derivation = derive(model, model.cases[0]);
    const SymbolOrder order = symbol_order(model);
    const CanonicalForm form(model.symbols, order);
    std::size_t summands = 0, written = 0, characters = 0;
    for_each_coefficient(derivation, [&](const GiNaC::ex& coefficient) {
      std::size_t own = 0;
      for (const FractionTerm& term : form.terms(coefficient)) own += 1 + term.divisors.size();
      const CanonicalForm::Parts parts = form.parts(coefficient);
      const std::size_t here = terms_in(parts.real) + terms_in(parts.imaginary);
      EXPECT_LE(here, own) << coefficient;
      summands += own;
      written += here;
      characters += formula_text(parts.real, order).size() + formula_text(parts.imaginary, order).size();
    });
    EXPECT_LE(written, summands);
    // A term and a divisor hold one number and at most all frequencies, each with sign, factor and power.
    EXPECT_LT(characters, written * (8 + 10 * static_cast<std::size_t>(modes))) << modes << " modes";
  }
}

// The same numbers to fifty digits with divisors as they stand and with all of them multiplied out over one
// denominator.
TEST(LocalSpring, FactoredAndExpandedFormsAgreeToFiftyDigits) {
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>>;
  const Model model = model_of(local_spring(3, 2));
  const Derivation derivation = derive(model, model.cases[0]);
  const SymbolOrder order = symbol_order(model);
  const CanonicalForm form(model.symbols, order);
  std::mt19937_64 random(14);
  std::vector<Number> point;
  for (std::size_t i = 0; i < order.size(); ++i) point.push_back(Number(1 + random() % 9973) / (1 + random() % 97));
  const std::function<Number(const std::vector<PolynomialTerm>&)> value = [&](const auto& terms) {
    Number sum = 0;
    for (const PolynomialTerm& term : terms) {
      Number product(term.coefficient);
      for (std::size_t i = 0; i < point.size(); ++i) product *= pow(point[i], term.exponents[i]);
      for (const DivisorPower& divisor : term.divisors) product /= pow(value(*divisor.sum), divisor.power);
      sum += product;
    }
    return sum;
  };
  std::size_t compared = 0;
  for_each_coefficient(derivation, [&](const GiNaC::ex& coefficient) {
    const FractionTerms terms = real_part(form.terms(coefficient));
    const RationalFunction factored = form.of(terms);
    RationalFunction expanded = form.of(form.sums().sum(terms));
    if (expanded.is_zero()) {
      EXPECT_TRUE(factored.is_zero());
      return;
    }
    Number below = value(expanded.denominator);
    for (const DivisorPower& divisor : expanded.numerator.front().divisors)
      below *= pow(value(*divisor.sum), divisor.power);
    for (PolynomialTerm& term : expanded.numerator) term.divisors.clear();
    const Number one = value(factored.numerator) / value(factored.denominator),
                 other = value(expanded.numerator) / below;
    EXPECT_LE(abs(one - other), Number("1e-50") * abs(other)) << coefficient;
    ++compared;
  });
  EXPECT_GT(compared, 50U);
}

// One denominator for all of it would fill the memory.
TEST(SlowLocalSpring, FiveModesAreWrittenAndCertified) {
  const CanonicalModel model = canonical_model(model_of(local_spring(5, 2)));
  EXPECT_TRUE(model.cases.front().certificate.holds);
  EXPECT_FALSE(model.cases.front().lumps.empty());
}

}  // namespace
}  // namespace secular
