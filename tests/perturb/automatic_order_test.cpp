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
