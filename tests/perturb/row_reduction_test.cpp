#include "numerics/row_reduction.hpp"

#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include <boost/rational.hpp>

namespace secular {
namespace {

using Fraction = boost::rational<long long>;
using Rows = std::vector<std::vector<Fraction>>;

TEST(RowReduction, SolvesExactly) {
  const auto solution = solve_exactly(Rows{{3, 1, 1}, {1, 2, 1}, {4, 3, 2}}, 2);
  ASSERT_TRUE(solution);
  EXPECT_EQ(*solution, (std::vector<Fraction>{Fraction(1, 5), Fraction(2, 5)}));
  EXPECT_FALSE(solve_exactly(Rows{{1, 1, 1}, {2, 2, 3}}, 2));
  const auto numbers = solve_exactly(std::vector<std::vector<GiNaC::numeric>>{{3, 1}}, 1);
  ASSERT_TRUE(numbers);
  EXPECT_EQ(numbers->front(), GiNaC::numeric(1, 3));
}

TEST(RowReduction, WhatStaysFreeIsZero) {
  const auto solution = solve_exactly(Rows{{0, 2, 4, 6}}, 3);
  ASSERT_TRUE(solution);
  EXPECT_EQ(*solution, (std::vector<Fraction>{0, 3, 0}));
}

TEST(RowReduction, CarriesTheOtherColumnsAlong) {
  Rows rows = {{5, 0, 2, 1, 0}, {7, 4, 2, 0, 1}};
  const std::vector<Pivot> pivots = reduce_rows(rows, 1, 3);
  ASSERT_EQ(pivots.size(), 2U);
  EXPECT_EQ(pivots[0].column, 1U);
  EXPECT_EQ(pivots[1].column, 2U);
  EXPECT_EQ(rows[0], (std::vector<Fraction>{Fraction(1, 2), 1, 0, Fraction(-1, 4), Fraction(1, 4)}));
  EXPECT_EQ(rows[1], (std::vector<Fraction>{Fraction(5, 2), 0, 1, Fraction(1, 2), 0}));
}

}  // namespace
}  // namespace secular
