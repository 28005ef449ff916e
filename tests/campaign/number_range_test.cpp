// Numbers whose tenth powers double precision does not hold.
#include "measure/data/number_range.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "input/input_error.hpp"

namespace secular {
namespace {

std::string fault_of(double peak) {
  return number_range_fault(std::vector<double>{0, -peak, peak / 3, std::numeric_limits<double>::quiet_NaN()});
}

TEST(NumberRange, EndsWhereTenthPowersDo) {
  for (const double peak : {0.0, 1e-30, 1e-9, 1.0, 1e30}) EXPECT_EQ(fault_of(peak), "") << peak;
  for (const double peak : {1.1e30, 1e300}) EXPECT_NE(fault_of(peak).find("above the largest"), std::string::npos);
  for (const double peak : {5e-324, 0.9e-30})
    EXPECT_NE(fault_of(peak).find("below the smallest"), std::string::npos);
  EXPECT_THROW(require_number_range(std::vector<double>{1e200}, "a.csv", "column 2"), InputError);
}

}  // namespace
}  // namespace secular
