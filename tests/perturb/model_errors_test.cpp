#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "input/input_error.hpp"
#include "perturb/derivation.hpp"
#include "tests/places.hpp"
#include "textbook_models.hpp"

namespace secular {
namespace {

// The message of the InputError that reading and deriving ends with.
std::string complaint(const std::string& text) {
  try {
    const Model model = read_model_text(text, "model.toml");
    for (const ResonanceCase& resonance : model.cases) derive(model, resonance);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

void expect_complaint(const std::string& equation, const std::string& resonance, const std::string& part) {
  const std::string message = complaint(textbook::one_mode(equation, resonance));
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_NE(message.find("model.toml"), std::string::npos) << message;
}

TEST(ModelErrors, FormulaMistakesNameLineAndColumn) {
  expect_complaint("D2(x) + w^2*x = -g*x^3)", "", "line 6, column 23: ')' without its '('");
  expect_complaint("D2(x) + w^2*x = -g*(x^3", "", "'(' is never closed");
  expect_complaint("D2(x) + w^2*x = -2g*x", "", "a symbol directly after the number 2");
  expect_complaint("D2(x) + w^2*x = -g*cot(x)", "", "unknown function cot");
  expect_complaint("D2(x) + w^2*x = -g*x^w", "", "symbol 'w' in an exponent");
  expect_complaint("D2(x) + w^2*x = -g*x/0", "", "division by zero");
  expect_complaint("D2(x) + w^2*x", "", "is not an equation");
  expect_complaint("D2(x) + w^2*x = -g*x^3 = 0", "", "a second '='");
  expect_complaint("D2(x) + w^2*x = -g*F", "", "F without its cos(Omega*t)");
  expect_complaint("D2(x) + w^2*x = -g*t*x", "", "time stands outside cos and sin");
}

TEST(ModelErrors, DeepNestingIsAnErrorNotACrash) {
  const std::size_t depth = 1000000;
  expect_complaint("D2(x) + w^2*x = " + std::string(depth, '(') + "x" + std::string(depth, ')'), "",
                   "nested deeper");
  expect_complaint("D2(x) + w^2*x = " + std::string(depth, '-') + "x", "", "nested deeper");
}

// Short to write, and nothing that algebra comes to an end with: refused before any is done.
TEST(ModelErrors, TowersOfPowersAreRefused) {
  expect_complaint("D2(x) + w^2*x = -(((((g^64)^64)^64)^64)^64)^64*x^3", "", "line 6, column");
  expect_complaint("D2(x) + w^2*x = -g*(x^64)^64", "", "has a degree beyond");
  expect_complaint("D2(x) + w^2*x = -g*((1 + x + w)^40)^40", "", "when it is multiplied out");
  expect_complaint("D2(x) + w^2*x = -g*(1+x)^20*(1+w)^20*(1+g)^20*(2+x)^20", "", "when it is multiplied out");
  expect_complaint("D2(x) + w^2*x = -g*(1 + x + x^2 + x^3 + x^4)^12", "", "when it is multiplied out");
  expect_complaint("D2(x) + w^2*x = -g*D(D(D(D((x+w)^60))))", "", "when it is multiplied out");
  expect_complaint("D2(x) + w^2*x = -((((3^64)^64)^64)^64)^64*x^3", "", "digits");
  expect_complaint("D2(x) + w^2*x = -g*1e999999999*x^3", "", "digits");
  expect_complaint("D2(x) + w^2*x = -g*x^(2^(2^64))", "", "digits");
  for (const char* const relation : {"Omega = (((((2^64)^64)^64)^64)^64)*w + eps*s",
                                     "Omega = w + ((eps + eps^2 + s)^64)^64", "Omega = w + eps*s*(s+w+eps)^64^2"})
    expect_complaint("D2(x) + w^2*x = g*F*cos(Omega*t)",
                     fmt::format("order = {{ g = 1 }}\nrelations = [\"{}\"]", relation), "model.toml, line");
}

// Its many factors are multiplied order by order: the limit ends that, here one that is soon reached.
TEST(ModelErrors, ExpansionsBeyondAllMeasureEnd) {
  const Model model = read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
      "equation = \"D2(x) + w^2*x + k*x*(1+x)^64 = 0\"\n[[case]]\nname = \"c\"\norder = { k = 1 }\n"
      "excitation = false\n",
      "model.toml");
  constexpr std::size_t most = 50'000;
  try {
    derive(model, model.cases.at(0), OmegaPolicy::nominal, ProductCount(most));
    ADD_FAILURE() << "derived";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("more than 50000 products"), std::string::npos) << message;
    EXPECT_NE(message.find("equation of 'x', term x^"), std::string::npos) << message;
  }
}

TEST(ModelErrors, SharedTowersAreRefused) {
  const std::filesystem::path place = testing_support::source_folder() / "../shared/faults/robustness";
  if (!std::filesystem::exists(place)) GTEST_SKIP() << place << " is not there";
  for (const char* const file : {"reltower.toml", "relexp.toml", "coef_pow.toml"}) try {
      read_model(place / file);
      ADD_FAILURE() << file << " was read";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("line "), std::string::npos) << error.what();
    }
}

TEST(ModelErrors, NamesOfOtherLanguagesAndDelays) {
  expect_complaint("D2(x) + w^2*x = -g*ln(1 + x)", "excitation = false", "write log(...)");
  expect_complaint("D2(x) + w^2*x = -g*pow(x, 3)", "excitation = false", "as x^3");
  expect_complaint("D2(x) + w^2*x = -g*x(t - tau)", "excitation = false", "its series, x - tau*D(x)");
}

TEST(ModelErrors, OrdersAndResonances) {
  expect_complaint("D2(x) + w^2*x = -g*x^3", "excitation = false",
                   "coefficient symbol 'g' (term x^3) has no order");
  expect_complaint("D2(x) + w^2*x = -g*x^3", "order = { g = 0 }\nexcitation = false",
                   "not part of the linear oscillator");
  expect_complaint("D2(x) + 2*w^2*x = -g*x^3", "order = { g = 1 }\nexcitation = false",
                   "its linear part at order eps^0 is 2*w^2*x, not w^2*x");
  expect_complaint("D2(x) + w^2*x = -g*x^3", "order = { h = 1 }", "no coefficient symbol");
  expect_complaint("D2(x) + w^2*x = g*F*cos(Omega*t)",
                   "order = { g = 1 }\nrelations = [\"Omega = w/2000 + eps*s\"]",
                   "no ratio of integers up to 1000");
  expect_complaint("D2(x) + w^2*x = g*F*cos(Omega*t)",
                   "order = { g = 1 }\nrelations = [\"Omega = w + eps*s\", \"Omega = 2*w + eps*q\"]",
                   "together make");
  expect_complaint("D2(x) + w^2*x = g*F*cos(Omega*t)", "order = { g = 1 }\nrelations = [\"Omega = w + s\"]",
                   "does not enter as eps^n");
  expect_complaint("D2(x) + w^2*x = g*F*cos(Omega*t)", "order = { g = 1 }\nrelations = [\"Omega3 = w + eps*s\"]",
                   "unknown frequency 'Omega3'");
  expect_complaint("D2(x) + w^2*x = -g*abs(D(x))*D(x)", "order = { g = 1 }\nexcitation = false",
                   "below the order of expansion");
}

TEST(ModelErrors, ACoefficientThatActsNowhereIsNamed) {
  const std::string equation = "D2(x) + w^2*x = -2*m*D(x) - g*x^3 + k*F*cos(Omega*t)";
  const std::string relation = "\nrelations = [\"Omega = w + eps^2*s\"]\nexpand_to = ";
  expect_complaint(
      equation, "order = { m = 3, g = 2, k = 2 }" + relation + "2",
      "coefficient 'm' acts nowhere: its lowest term, D(x), is of order eps^3, and the case expands to eps^2");
  expect_complaint(equation, "order = { m = 2, g = 2, k = 2 }" + relation + "1", "acts nowhere");
  expect_complaint("D2(x) + w^2*x = -g*x^3 - h*x^5",
                   "ordering = \"degree\"\norder = { h = 1 }\nexpand_to = 2\nexcitation = false",
                   "coefficient 'h' acts nowhere: its lowest term, x^5, is of order eps^5");
  // By degree alone; the lowest of several terms counts, and what is not excited is no term.
  const std::string by_degree = "ordering = \"degree\"\nexcitation = false\nexpand_to = ";
  expect_complaint("D2(x) + w^2*x = -g*x^3 - h*x^4", by_degree + "2",
                   "coefficient 'h' acts nowhere: its lowest term, x^4, is of order eps^3");
  EXPECT_EQ(complaint(textbook::one_mode("D2(x) + w^2*x = -g*x^3 - h*x^4", by_degree + "3")), "no complaint");
  EXPECT_EQ(complaint(textbook::one_mode("D2(x) + w^2*x = -g*x^3 - w*g*x^5", by_degree + "2")), "no complaint");
  // Beyond the expansion in one term and within it in another: the expansion only cuts it off.
  EXPECT_EQ(complaint(textbook::one_mode("D2(x) + w^2*x = -g*x^3 - g^2*x^5",
                                         "order = { g = 2 }\nexpand_to = 2\nexcitation = false")),
            "no complaint");
  EXPECT_EQ(complaint(textbook::one_mode(equation, "order = { m = 2, g = 2, k = 2 }" + relation + "2")),
            "no complaint");
}

TEST(ModelErrors, KeysAndNames) {
  EXPECT_NE(complaint("schema = 2\nname = \"a\"").find("schema"), std::string::npos);
  EXPECT_NE(complaint("schema = 1\nname = \"a\"").find("no [[mode]]"), std::string::npos);
  EXPECT_NE(complaint("schema = 1\nname = \"a b\"").find("is not a symbol"), std::string::npos);
  const std::string model = textbook::one_mode("D2(x) + w^2*x = -g*x^3", "order = { g = 1 }\nexpand = 2");
  EXPECT_NE(complaint(model).find("key expand: is not a known key"), std::string::npos) << complaint(model);
}

TEST(ModelReader, NumbersAreExactRationals) {
  const Model model = read_model_text(
      textbook::one_mode("D2(x) + w^2*x = -0.1*g*x^3", "order = { g = 1 }\nexpand_to = 1\nexcitation = false"),
      "m");
  const Field field = derive(model, model.cases[0]).modulation(0);
  ASSERT_EQ(field.terms().size(), 1U);
  const GiNaC::ex expected = GiNaC::I * GiNaC::numeric(3, 20) * model.symbols.at("g") / model.symbols.at("w");
  EXPECT_TRUE((field.terms().begin()->second - expected).expand().is_zero());
}

TEST(ModelErrors, ImpossibleResonances) {
  const std::string head =
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w1\"\nequation = \"D2(x) + w1^2*x = "
      "-g*x*y\"\n[[mode]]\ncoordinate = \"y\"\nfrequency = \"w2\"\nequation = \"D2(y) + w2^2*y = -g*x^2 + "
      "e*F*cos(Omega*t)\"\n[nominal]\nw1 = 1\nw2 = 2.9\n[[case]]\nname = \"c\"\norder = { g = 1, e = 1 }\n";
  const auto expect = [&](const std::string& relations, const std::string& part) {
    const std::string message = complaint(head + "relations = [" + relations + "]\n");
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect("\"w2 = 2*w1 + eps*s\"", "impossible at the nominal frequencies (w1 = 1, w2 = 2.9)");
  expect("\"Omega = w1 - w2 + eps*s\"", "makes Omega negative");
  expect("\"Omega = w2 + eps*s\", \"Omega = 2*w1 + eps*q\"", "impossible");
  expect("\"Omega = w2 + eps*s\", \"2*Omega = 2*w2 + eps*q\"", "repeat or contradict");
  expect("\"w2 = 3*w1 + eps*s\"", "no complaint");
}

// A divisor that is small at the nominal frequencies is a warning with the relation to add.
TEST(ModelErrors, WarnsOfAnUnlistedResonance) {
  const Model model = read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w1\"\nequation = \"D2(x) + w1^2*x = "
      "-g*x*y\"\n[[mode]]\ncoordinate = \"y\"\nfrequency = \"w2\"\nequation = \"D2(y) + w2^2*y = -g*x^2\"\n"
      "[nominal]\nw1 = 1\nw2 = 2.02\n[[case]]\nname = \"c\"\norder = { g = 1 }\n",
      "m");
  const Derivation d = derive(model, model.cases[0]);
  ASSERT_FALSE(d.warnings.empty());
  EXPECT_NE(d.warnings[0].find("relations = [\"w2 = 2*w1 + eps^2*sigma\"]"), std::string::npos) << d.warnings[0];
}

}  // namespace
}  // namespace secular
