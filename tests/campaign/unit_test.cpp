#include "measure/formats/unit.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

TEST(Unit, SiUnitsFitTheirQuantityAndNoOther) {
  const Quantity all[] = {Quantity::acceleration, Quantity::velocity, Quantity::displacement, Quantity::force,
                          Quantity::voltage,      Quantity::strain,   Quantity::angle};
  for (const Quantity quantity : all)
    for (const Quantity other : all)
      EXPECT_EQ(unit_fault(quantity, si_unit(other)).empty(), quantity == other) << to_string(quantity);
  EXPECT_EQ(unit_fault(Quantity::strain, "m/m"), "");
}

TEST(Unit, KnownUnitsComeWithTheirFactor) {
  EXPECT_TRUE(
      contains(unit_fault(Quantity::acceleration, "g"), "multiply the samples by 9.80665 and write 'm/s^2'"));
  EXPECT_TRUE(contains(unit_fault(Quantity::displacement, "mm"), "multiply the samples by 0.001 and write 'm'"));
  EXPECT_TRUE(contains(unit_fault(Quantity::angle, "deg"), "multiply the samples by pi/180 and write 'rad'"));
  EXPECT_TRUE(contains(unit_fault(Quantity::strain, "microstrain"), "1e-6"));
  EXPECT_TRUE(contains(unit_fault(Quantity::acceleration, "m/s²"), "write 'm/s^2'"));
}

TEST(Unit, OtherUnitsSayWhatTheyMeasure) {
  EXPECT_TRUE(
      contains(unit_fault(Quantity::angle, "m/s^2"), "measures acceleration, the quantity is angle: 'rad'"));
  EXPECT_TRUE(contains(unit_fault(Quantity::force, "mm"), "measures displacement"));
  EXPECT_TRUE(
      contains(unit_fault(Quantity::velocity, "Hz"), "measures frequency, the quantity is velocity: 'm/s'"));
  EXPECT_TRUE(contains(unit_fault(Quantity::voltage, "parsec"), "not known: 'V' was expected"));
}

TEST(Unit, MeaningsConvertToSi) {
  const auto factor = [](const char* unit) { return unit_meaning(unit).value().si_factor; };
  EXPECT_EQ(factor("m/s^2"), 1);
  EXPECT_EQ(factor("g"), 9.80665);
  EXPECT_EQ(factor("deg"), std::numbers::pi / 180);
  EXPECT_EQ(factor("rev"), 2 * std::numbers::pi);
  EXPECT_EQ(factor("km/h"), 1 / 3.6);
  EXPECT_EQ(unit_meaning("mV").value().quantity, Quantity::voltage);
  EXPECT_EQ(unit_meaning("1").value().quantity, Quantity::strain);
  EXPECT_FALSE(unit_meaning("EU"));
  EXPECT_FALSE(unit_meaning("Hz"));
}

}  // namespace
}  // namespace secular
