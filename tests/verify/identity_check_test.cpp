#include "thesis/verify/identity_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "input/input_error.hpp"
#include "thesis/verify/changed_term.hpp"
#include "thesis/verify/table_arithmetic.hpp"

namespace secular::verify {
namespace {

PrintedSource source_with(const std::string& tables) {
  return read_printed_source_text("schema = 1\nname = \"n\"\nsource = \"s\"\n" + tables, "source.toml");
}
IdentityCheck checked_identity(const std::string& keys, const std::string& printed) {
  const PrintedSource source = source_with("[[identity]]\nequation = \"1\"\nverdict = \"confirmed\"\nprinted = \"" +
                                           printed + "\"\n" + keys);
  return check_identity(source.identities.at(0), source.identities.at(0).printed);
}

TEST(Identity, HoldsForAllValuesOrNot) {
  EXPECT_TRUE(checked_identity("", "cosh(x)^2 - sinh(x)^2 = 1").holds);
  EXPECT_FALSE(checked_identity("", "cosh(x)^2 + sinh(x)^2 = 1").holds);
  EXPECT_TRUE(checked_identity("complex = [\"z\"]\n", "real(z)^2 + imag(z)^2 = z*conj(z)").holds);
  EXPECT_FALSE(checked_identity("complex = [\"z\"]\n", "conj(z) = z").holds);
  EXPECT_TRUE(checked_identity("", "conj(z) = z").holds);  // real where nothing else is said
  EXPECT_TRUE(checked_identity("define = [\"b = 1/a\"]\n", "a*b = 1").holds);
}

TEST(Identity, OfMatricesKnowsTheOrderOfFactors) {
  const std::string square = "sizes = { A = [3, 3], B = [3, 3] }\n";
  EXPECT_TRUE(checked_identity(square, "inverse(A*B) = inverse(B)*inverse(A)").holds);
  EXPECT_FALSE(checked_identity(square, "inverse(A*B) = inverse(A)*inverse(B)").holds);
  EXPECT_TRUE(checked_identity("sizes = { A = [3, 3] }\n", "A^(-2)*A^3 = A").holds);
  const IdentityCheck sizes = checked_identity("sizes = { A = [3, 2] }\n", "A*A = A");
  EXPECT_FALSE(sizes.holds);
  EXPECT_NE(sizes.why.find("inner sizes"), std::string::npos) << sizes.why;
  const std::string tall = "sizes = { A = [4, 2] }\n";
  EXPECT_TRUE(
      checked_identity(tall, "A = left_singular(A)*diagonal(singular(A))*transpose(right_singular(A))").holds);
  EXPECT_TRUE(checked_identity(tall, "pseudoinverse(A)*A = unit(2)").holds);
  EXPECT_FALSE(checked_identity(tall, "A*pseudoinverse(A) = unit(4)").holds);
  EXPECT_TRUE(checked_identity("", "part(hankel(powers(z, 5), 3, 3), 2, 3, 3, 3) = z^3*powers(z, 2)").holds);
}

// What is false stays false beside small constants, in long products, and where it holds for one sign alone.
TEST(Identity, IsMeasuredByItsTermsAtBothSigns) {
  std::string product = "s1";
  for (int n = 2; n <= 35; ++n) product += "*s" + std::to_string(n);
  for (const std::string& printed :
       {std::string("1e-10*x = 2e-10*x"), std::string("eps0*x^3/3 = eps0*x^3/6"), product + " = 0",
        std::string("abs(c) = c"), std::string("abs(c*d) = c*d"), std::string("sqrt(c^2) = c"),
        std::string("1e5*x + y = 1e5*x + 1.0000001*y")}) {
    const bool has_constant = printed.starts_with("eps0");
    EXPECT_FALSE(checked_identity(has_constant ? "define = [\"eps0 = 8.854e-12\"]\n" : "", printed).holds)
        << printed;
  }
  EXPECT_TRUE(checked_identity("", "1e-10*(x + y)^3 = 1e-10*x^3 + 3e-10*x*y*(x + y) + 1e-10*y^3").holds);
  EXPECT_TRUE(checked_identity("", "(x - y)*(x + y) - x^2 + y^2 = 0").holds);
  EXPECT_TRUE(checked_identity("", "abs(c)^2 = c^2").holds);
}

// The null vectors of a matrix of rank 2 are any: nothing is confirmed that uses them, those of its range are fine.
TEST(Identity, DoesNotDecideByRounding) {
  const std::string sizes = "sizes = { A = [4, 2], B = [2, 4] }\ndefine = [\"U = left_singular(A*B)\"]\n";
  const IdentityCheck null =
      checked_identity(sizes, "part(U, 1, 1, 3, 3) = part(left_singular(2*A*B), 1, 1, 3, 3)");
  EXPECT_FALSE(null.holds);
  EXPECT_NE(null.why.find("double precision"), std::string::npos) << null.why;
  const std::string nothing = "((x + y)^2 - x^2 - 2*x*y - y^2 + x*0.1 - x/10)";  // zero but for rounding
  for (const std::string& form : {"x/" + nothing + " = x", "sqrt(" + nothing + ") = 1e-7*x",
                                  nothing + "^(1/2) = 1e-7*x", nothing + "^(-1) = x", "log(" + nothing + ") = x"}) {
    try {
      EXPECT_FALSE(checked_identity("", form).holds) << form;
    } catch (const InputError&) {  // zero at a draw
    }
  }
  EXPECT_TRUE(checked_identity("", nothing + " = 0").holds);
  EXPECT_TRUE(checked_identity(sizes, "part(U, 1, 4, 1, 2)*transpose(part(U, 1, 4, 1, 2))*A = A").holds);
}

TEST(Identity, NamesOccurOnceAndHaveOneMeaning) {
  const struct {
    const char *keys, *wrong;
  } cases[] = {{"sizes = { X = [2, 2] }", "key sizes: 'X' does not occur"},
               {"complex = [\"zz\"]", "key complex: 'zz' does not occur"},
               {"complex = [\"z\", \"z\"]", "key complex: has 'z' twice"},
               {"complex = [\"i\"]", "key complex: 'i' has a value already"},
               {"define = [\"z = a\"]\ncomplex = [\"z\"]", "key complex: 'z' has a value already"},
               {"define = [\"y = a\"]", "key define: 'y' does not occur"},
               {"define = [\"z = 1\", \"z = 2\"]", "key define: has 'z' twice"},
               {"define = [\"Pi = 3\"]", "key define: 'Pi' has a meaning already"},
               {"define = [\"z = b\", \"b = a\"]", "key define: 'z' is made from 'b'"},
               {"define = [\"z = z + a\"]", "key define: 'z' is made from 'z'"}};
  for (const auto& one : cases) {
    try {
      checked_identity(std::string(one.keys) + "\n", "conj(z) = z + 0*b*Pi*i");
      FAIL() << one.keys;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("source.toml, line "), std::string::npos) << message;
      EXPECT_NE(message.find(one.wrong), std::string::npos) << message;
    }
  }
}

TEST(Identity, SaysWhatHasNoValue) {
  for (const auto& [printed, wrong] :
       {std::pair{"a/0 = 1", "division by zero"}, std::pair{"a", "no equals sign"},
        std::pair{"log(0) = a", "no finite value"}, std::pair{"unit(0) = a", "no index"},
        std::pair{"f_quantile(2, 1, 1) = a", "no quantile"},
        std::pair{"f_quantile(0.5, 1e308, 1e308) = a", "no quantile"}}) {
    try {
      checked_identity("", printed);
      FAIL() << printed;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(wrong), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("line 7"), std::string::npos) << error.what();
    }
  }
}

ArithmeticCheck checked_number(const std::string& printed, const std::string& claim, const std::string& formula) {
  const PrintedSource source =
      source_with("[[arithmetic]]\ntable = \"1\"\nentry = \"x\"\nverdict = \"agrees\"\nprinted = \"" + printed +
                  "\"\nclaim = \"" + claim + "\"\nformula = \"" + formula + "\"\nfrom = { a = \"2.0\" }\n");
  return check_arithmetic(source.arithmetic.at(0));
}

TEST(Arithmetic, BoundsAndQuantiles) {
  EXPECT_TRUE(checked_number("1.41", "equals", "sqrt(a)").agrees);
  EXPECT_FALSE(checked_number("1.45", "equals", "sqrt(a)").agrees);
  EXPECT_TRUE(checked_number("1.45", "at most", "sqrt(a)").agrees);
  EXPECT_FALSE(checked_number("1.45", "at least", "sqrt(a)").agrees);
  EXPECT_TRUE(checked_number("1.30", "at least", "sqrt(a)").agrees);
  EXPECT_TRUE(checked_number("4.965", "equals", "f_quantile(0.95, 1, 10)").agrees);  // as tables of F have it
  EXPECT_FALSE(checked_number("4.967", "equals", "f_quantile(0.95, 1, 10)").agrees);
  EXPECT_THROW(checked_number("1", "equals", "sqrt(-a)"), InputError);
}

// The true range over the rounding of the digits, wherever the formula turns.
TEST(Arithmetic, FindsTheEndsWhereAFormulaTurns) {
  const auto ends = [](const std::string& formula, const std::string& from) {
    const PrintedSource source = source_with(
        "[[arithmetic]]\ntable = \"1\"\nentry = \"x\"\nverdict = \"agrees\"\nprinted = \"1\"\n"
        "formula = \"" +
        formula + "\"\nfrom = { " + from + " }\n");
    return check_arithmetic(source.arithmetic.at(0)).expected;
  };
  const auto expect = [&](const std::string& formula, const std::string& from, double low, double high) {
    const RoundedNumber found = ends(formula, from);
    EXPECT_NEAR(found.low, low, 1e-9) << formula;
    EXPECT_NEAR(found.high, high, 1e-9) << formula;
  };
  expect("cos(a)", "a = \"0\"", std::cos(0.5), 1);
  expect("cos(a - 0.3)", "a = \"0\"", std::cos(0.8), 1);
  expect("square(a - 2.03)", "a = \"2.0\"", 0, 0.08 * 0.08);
  expect("abs(a - b)", "a = \"2.0\", b = \"2.01\"", 0, 0.065);
  expect("a*(1 - a)*b", "a = \"0.6\", b = \"2\"", 1.5 * 0.65 * 0.35, 2.5 * 0.55 * 0.45);
  expect("(a - 1)^2 + (b - 3)^2", "a = \"1\", b = \"3\"", 0, 0.5);
}

// The inverse of [[2, 1], [1, 1]] is [[1, -1], [-1, 2]]; one entry printed wrong is the one that is named.
TEST(Matrix, NamesTheEntryThatDoesNotFollow) {
  const auto wrong = [](const std::string& corner) {
    const PrintedSource source = source_with(
        "[[matrix]]\nequation = \"1\"\nverdict = \"agrees\"\nprinted = [\"1.00 -1.00\", \"-1.00 " + corner +
        "\"]\nformula = \"inverse(m)\"\nfrom = { m = [\"2.0000 1.0000\", \"1.0000 1.0000\"] }\n");
    return wrong_entries(source.matrices.at(0));
  };
  EXPECT_TRUE(wrong("2.00").empty());
  const std::vector<std::string> found = wrong("2.01");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("row 2, column 2"), std::string::npos) << found[0];
}

TEST(ChangedTerm, IsWholeTermsWithTheirBrackets) {
  using Two = std::pair<std::string, std::string>;
  EXPECT_EQ(changed_term("a + 4*b - c", "a + 4*b - c"), Two());
  EXPECT_EQ(changed_term("a + 4*b - c", "a - 4*b - c"), Two("+4*b", "-4*b"));
  EXPECT_EQ(changed_term("x*(a + b/(c + d)) - e", "x*(a + b/(c + 2*d)) - e"), Two("+d", "+2*d"));
  EXPECT_EQ(changed_term("a - f(x)*y = 0", "a - f(x)*z*y = 0"), Two("-f(x)*y", "-f(x)*z*y"));
  EXPECT_EQ(changed_term("a = b^2", "a = b^2*(1 + c)"), Two("b^2", "b^2*(1 + c)"));
}

}  // namespace
}  // namespace secular::verify
