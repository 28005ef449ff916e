// order = "auto" finds the powers of eps that a table would have by hand, see docs/new_resonance_case.md.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

Model one_case(const std::string& equation, const std::string& resonance) {
  return read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"" + equation +
          "\"\n[[case]]\nname = \"c\"\n" + resonance,
      "auto");
}

// The same terms of dA/dt, each at the same order.
void expect_as_table(const std::string& equation, const std::string& resonance, const std::string& table) {
  const Model automatic = one_case(equation, resonance + "order = \"auto\"\n"),
              by_hand = one_case(equation, resonance + "order = " + table + "\n");
  const Derivation found = derive(automatic, automatic.cases[0]), expected = derive(by_hand, by_hand.cases[0]);
  EXPECT_TRUE(certify(found).holds) << equation;
  GiNaC::exmap same;
  for (const std::string& name : automatic.symbols.names())
    same[automatic.symbols.at(name)] = by_hand.symbols.at(name);
  for (std::size_t n = 1; n < expected.slow_derivative[0].size(); ++n) {
    const auto &left = found.slow_derivative[0][n].terms(), &right = expected.slow_derivative[0][n].terms();
    ASSERT_EQ(left.size(), right.size()) << equation << " at eps^" << n;
    for (const auto& [key, coefficient] : right) {
      const auto term = left.find(key);
      ASSERT_NE(term, left.end()) << equation << " at eps^" << n;
      EXPECT_TRUE((term->second.subs(same) - coefficient).normal().is_zero()) << equation << " at eps^" << n;
    }
  }
}

TEST(AutomaticOrder, IsThatOfTheTableByHand) {
  const std::string duffing = "D2(x) + w^2*x + 2*mu*D(x) + a*x^2 + b*x^3 = e*F*cos(Omega*t)";
  expect_as_table(duffing, "relations = [\"Omega = w + eps^2*s\"]\n", "{ mu = 2, a = 1, b = 2, e = 2 }");
  expect_as_table(duffing, "relations = [\"Omega = 3*w + eps^2*s\"]\n", "{ mu = 2, a = 1, b = 2, e = 0 }");
  expect_as_table(duffing, "relations = [\"Omega = w/2 + eps^2*s\"]\n", "{ mu = 2, a = 1, b = 2, e = 0 }");
  expect_as_table(duffing, "excitation = false\n", "{ mu = 2, a = 1, b = 2 }");
  const std::string mathieu = "D2(x) + w^2*x + 2*mu*D(x) + b*x^3 + e*x*F*cos(Omega*t) = 0";
  expect_as_table(mathieu, "relations = [\"Omega = 2*w + eps^2*s\"]\n", "{ mu = 2, b = 2, e = 2 }");
  expect_as_table(mathieu, "relations = [\"Omega = w + eps^2*s\"]\n", "{ mu = 2, b = 2, e = 1 }");
  expect_as_table("D2(x) + w^2*x + 2*mu*D(x) + d*D(x)*abs(D(x)) = 0", "excitation = false\nexpand_to = 1\n",
                  "{ mu = 1, d = 1 }");
}

TEST(AutomaticOrder, OfModesFollowsTheirResonance) {
  const auto order = [](const std::string& relation) {
    return read_model_text(
               "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"D2(x) + "
               "w^2*x + "
               "2*mu*D(x) + a*x*y + k*y + g*D(y) = e*F*cos(Omega*t)\"\n[[mode]]\ncoordinate = \"y\"\nfrequency = "
               "\"u\"\n"
               "equation = \"D2(y) + u^2*y + 2*nu*D(y) + b*x^2 = 0\"\n[[case]]\nname = \"c\"\norder = \"auto\"\n"
               "relations = [\"Omega = w + eps*s\"" +
                   relation + "]\n",
               "auto")
        .cases[0]
        .order;
  };
  using Orders = std::map<std::string, int>;
  EXPECT_EQ(order(""), (Orders{{"mu", 2}, {"nu", 2}, {"e", 2}, {"k", 1}, {"g", 1}}));
  EXPECT_EQ(order(", \"u = 2*w + eps*r\""), (Orders{{"mu", 1}, {"nu", 1}, {"e", 1}, {"k", 1}, {"g", 1}}));
  EXPECT_EQ(order(", \"u = w + eps^2*r\""), (Orders{{"mu", 2}, {"nu", 2}, {"e", 2}, {"k", 2}, {"g", 2}}));
}

TEST(AutomaticOrder, IsRefusedWhereOneCoefficientWouldNeedTwo) {
  try {
    one_case("D2(x) + w^2*x + c*D(x) + c*x^3 = 0", "excitation = false\norder = \"auto\"\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("write a table, as order = { c = 2 }"), std::string::npos)
        << error.what();
  }
}

Model at_rest(const std::string& law, const std::string& order) {
  return read_model_text(
      "schema = 1\nname = \"m\"\nreference = \"rest\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = "
      "\"w\"\nequation = \"D2(x) + 2*mu*D(x) + k*x + " +
          law + " + e*F*cos(Omega*t)\"\n[[case]]\nname = \"c\"\nrelations = [\"Omega = w + eps^2*s\"]\norder = " +
          order + "\n",
      "rest");
}

// Rest positions and what stands inside functions and denominators bear no order: damping and excitation do.
TEST(AutomaticOrder, AboutRestIsThatOfDampingAndExcitation) {
  using Orders = std::map<std::string, int>;
  for (const auto& [law, orders] :
       std::map<std::string, Orders>{{"0*x = c/(d - x)^2", {{"mu", 2}, {"e", 2}}},
                                     {"exp(b*x) = g + 1", {{"mu", 2}, {"e", 2}}},
                                     {"a*x^3 + m*x*D(x) = g", {{"mu", 2}, {"e", 2}, {"m", 1}}},
                                     {"v*sinh(D(x)/u) + a*sin(b*x) = g", {{"mu", 2}, {"e", 2}, {"v", 2}}}}) {
    const Model model = at_rest(law, "\"auto\"");
    EXPECT_EQ(model.cases[0].order, orders) << law;
    EXPECT_TRUE(certify(derive(model, model.cases[0])).holds) << law;
  }
}

// Functions count by their series, also beside an excitation.
TEST(AutomaticOrder, OfFunctionsIsThatOfTheirSeries) {
  const auto order = [](const std::string& equation) {
    const Model model = one_case(equation, "order = \"auto\"\nrelations = [\"Omega = 2*w + eps^2*s\"]\n");
    EXPECT_TRUE(certify(derive(model, model.cases[0])).holds) << equation;
    return model.cases[0].order;
  };
  using Orders = std::map<std::string, int>;
  EXPECT_EQ(order("D2(x) + w^2*sin(x) + 2*mu*D(x) = h*F*cos(Omega*t)*sin(x)"), (Orders{{"mu", 2}, {"h", 2}}));
  EXPECT_EQ(order("D2(x) + w^2*x + c*(sin(x) - x) + mu*sinh(D(x)) = 0*F*cos(Omega*t)*x + h*F*cos(Omega*t)*x"),
            (Orders{{"mu", 2}, {"h", 2}}));
}

// Damping balances the first nonlinear term where that comes in.
TEST(AutomaticOrder, IsThatOfTheFirstNonlinearTerm) {
  for (const auto& [law, order] : std::map<std::string, int>{{"b*x^5", 4},
                                                             {"b*x^3 + c*x^5", 2},
                                                             {"b*x^2", 2},
                                                             {"b*x^4", 4},
                                                             {"b*(sin(x) - x)", 2},
                                                             {"b*x^5*cos(x)", 4}}) {
    const Model model = one_case("D2(x) + w^2*x + 2*mu*D(x) + " + law + " = e*F*cos(Omega*t)",
                                 "order = \"auto\"\nexpand_to = 4\nrelations = [\"Omega = w/5 + eps^4*s\"]\n");
    EXPECT_EQ(model.cases[0].order, (std::map<std::string, int>{{"mu", order}})) << law;
  }
}

// What is refused has a table that is not.
TEST(AutomaticOrder, TheTableThatItAdvisesIsTaken) {
  const std::string equation = "D2(x) + w^2*x + 2*mu*D(x) + c*D(x) + c*x^3 + a*x^2 = e*F*cos(Omega*t)",
                    relation = "relations = [\"Omega = w + eps^2*s\"]\norder = ";
  try {
    one_case(equation, relation + "\"auto\"\n");
    FAIL();
  } catch (const InputError& error) {
    const std::string& advice = error.right();
    const std::size_t begin = advice.find("{ ");
    ASSERT_NE(begin, std::string::npos) << error.what();
    const Model model = one_case(equation, relation + advice.substr(begin) + "\n");
    EXPECT_EQ(model.cases[0].order, (std::map<std::string, int>{{"a", 1}, {"c", 2}, {"e", 2}, {"mu", 2}}));
    EXPECT_TRUE(certify(derive(model, model.cases[0])).holds);
  }
}

// A detuning beyond the expansion is told.
TEST(AutomaticOrder, OfADetuningIsToldWhereItIsBeyondTheExpansion) {
  const Model model = one_case("D2(x) + w^2*x + 2*mu*D(x) + b*x^3 = e*F*cos(Omega*t)",
                               "order = \"auto\"\nrelations = [\"Omega = w + eps^4*s\"]\n");
  const Derivation d = derive(model, model.cases[0]);
  ASSERT_EQ(d.warnings.size(), 1U);
  EXPECT_NE(d.warnings[0].find("write eps^2*s"), std::string::npos) << d.warnings[0];
}

}  // namespace
}  // namespace secular
