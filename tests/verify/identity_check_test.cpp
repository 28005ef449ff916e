#include "thesis/verify/identity_check.hpp"

#include <gtest/gtest.h>

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
  EXPECT_TRUE(checked_identity(square, "A^(-2)*A^3 = A").holds);
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

TEST(Identity, SaysWhatHasNoValue) {
  for (const auto& [printed, wrong] :
       {std::pair{"a/0 = 1", "division by zero"}, std::pair{"a", "no equals sign"},
        std::pair{"log(0) = a", "no finite value"}, std::pair{"unit(0) = a", "no index"},
        std::pair{"f_quantile(2, 1, 1) = a", "no quantile"}}) {
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
