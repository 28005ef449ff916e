#include "report/number_format.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace secular::report {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

TEST(NumberFormat, KeepsSignificantTrailingZeros) {
  EXPECT_EQ(format_number(0.222), "0.2220");
  EXPECT_EQ(format_number(-77.85, 4), "−77.85");
  EXPECT_EQ(format_number(9.9996, 4), "10.00");
  EXPECT_EQ(format_number(123456, 3), "123456");
  EXPECT_EQ(format_number(0), "0");
}

TEST(NumberFormat, UsesPowersOfTenOutsideTheOrdinaryRange) {
  EXPECT_EQ(format_number(1.3e-6, 2), "1.3\u202F×\u202F10⁻⁶");
  EXPECT_EQ(format_number(-2.5e12, 3), "−2.50\u202F×\u202F10¹²");
  EXPECT_EQ(format_number(0.00099996, 4), "0.001000");  // rounds up into the ordinary range
}

TEST(NumberFormat, IsPlainForPrograms) {
  {
    const PlainNumbers plain;
    EXPECT_EQ(format_number(-0.02), "-0.02000");
    EXPECT_EQ(format_number(-1.3e-6, 2), "-1.3e-06");
    EXPECT_EQ(format_number(2.5e7, 2), "2.5e+07");
    EXPECT_EQ(format_uncertain(-0.002, 0.042), "-0.002(42)");
    EXPECT_EQ(format_uncertain(0.222, 0.0013, UncertaintyStyle::plus_minus), "0.2220 +- 0.0013");
    EXPECT_EQ(format_percent(-0.5), "-50.0 %");
    EXPECT_EQ(format_quantity(77.85, 0.012, "rad/s^2"), "77.850(12) rad/s^2");
    EXPECT_EQ(format_number(-INFINITY), "-inf");
  }
  EXPECT_EQ(format_number(-1.3e-6, 2), "−1.3\u202F×\u202F10⁻⁶");
}

TEST(NumberFormat, NamesWhatIsNotANumber) {
  EXPECT_EQ(format_number(nan), "n/a");
  EXPECT_EQ(format_number(-infinity), "−∞");
  EXPECT_EQ(format_uncertain(nan, 1), "n/a");
}

TEST(NumberFormat, UncertaintyFixesTheDigits) {
  EXPECT_EQ(format_uncertain(0.222, 0.0013), "0.2220(13)");
  EXPECT_EQ(format_uncertain(0.222, 0.0013, UncertaintyStyle::plus_minus), "0.2220 ± 0.0013");
  EXPECT_EQ(format_uncertain(-77.8512, 0.012), "−77.851(12)");
  EXPECT_EQ(format_uncertain(3.14159, 0.0996), "3.14(10)");  // 0.0996 is 0.10 to two digits
}

TEST(NumberFormat, UncertaintyPastThePointIsWrittenWithThePoint) {
  EXPECT_EQ(format_uncertain(12.34, 1.4), "12.3(1.4)");
  EXPECT_EQ(format_uncertain(0.02, 1.3), "0.0(1.3)");
  EXPECT_EQ(format_uncertain(1234, 12), "1234(12)");
}

TEST(NumberFormat, NoFillingZerosAreInvented) {
  EXPECT_EQ(format_uncertain(184321, 250), "1.8432(25)\u202F×\u202F10⁵");
  EXPECT_EQ(format_uncertain(12345, 130, UncertaintyStyle::plus_minus), "(1.234 ± 0.013)\u202F×\u202F10⁴");
  EXPECT_EQ(format_uncertain(1.3e-7, 2e-9), "1.300(20)\u202F×\u202F10⁻⁷");
}

TEST(NumberFormat, UncertaintyThatSaysNothing) {
  EXPECT_EQ(format_uncertain(0.25, 0), "0.250000");
  EXPECT_EQ(format_uncertain(0.25, nan), "0.250000 ± ?");
  EXPECT_EQ(format_uncertain(0, 0.013), "0.000(13)");
}

TEST(NumberFormat, QuantityCarriesItsUnit) {
  EXPECT_EQ(format_quantity(77.85, 0.012, "rad/s"), "77.850(12)\u202Frad/s");
  EXPECT_EQ(format_quantity(77.85, 0.012, "rad/s", UncertaintyStyle::plus_minus), "(77.850 ± 0.012)\u202Frad/s");
  EXPECT_EQ(format_quantity(2, 0.1, "1"), "2.00(10)");
}

TEST(NumberFormat, IntervalEndsDifferInTheDigitsShown) {
  EXPECT_EQ(format_interval(0.21941, 0.22459), "[0.2194, 0.2246]");
  EXPECT_EQ(format_interval(-1.5e-6, 2.5e-6), "[−1.5, 2.5]\u202F×\u202F10⁻⁶");
}

TEST(NumberFormat, UnitsGetSuperscripts) {
  EXPECT_EQ(pretty_unit("m/s^2"), "m/s²");
  EXPECT_EQ(pretty_unit("kg^-1 m^-12"), "kg⁻¹ m⁻¹²");
  EXPECT_EQ(pretty_unit("kg^(1/2) m"), "kg^(1/2) m");
  EXPECT_EQ(pretty_unit("m^0.5"), "m^0.5");
  EXPECT_EQ(pretty_unit("1"), "");
  EXPECT_EQ(pretty_unit("x^"), "x^");
}

TEST(NumberFormat, PercentAndFixed) {
  EXPECT_EQ(format_percent(0.9823), "98.2\u202F%");
  EXPECT_EQ(format_fixed(-0.0004, 2), "0.00");  // no negative zero
}

}  // namespace
}  // namespace secular::report
