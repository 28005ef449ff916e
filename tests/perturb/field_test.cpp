// Fields against the numbers that they stand for.
#include "perturb/field.hpp"

#include <algorithm>

#include "field_value.hpp"

namespace secular {
namespace {

using namespace testing_fields;

const FieldLayout layout{2, 1, 1};

TEST(Field, ConvolutionIsTheProductOfTheNumbers) {
  std::mt19937 random(1);
  for (int draw = 0; draw < 10; ++draw) {
    const Field a = random_field(layout, 4, random), b = random_field(layout, 5, random);
    const Point at = random_point(layout, random);
    expect_near(value(a * b, layout, at), value(a, layout, at) * value(b, layout, at), 1e-12);
  }
}

TEST(Field, ARealFieldIsItsOwnConjugate) {
  std::mt19937 random(2);
  const Field a = random_field(layout, 6, random);
  const Point at = random_point(layout, random);
  EXPECT_NEAR(value(a, layout, at).imag(), 0, 1e-12);
  expect_near(value(a.conjugated(layout), layout, at), value(a, layout, at), 1e-12);
}

TEST(Field, JoinedModuliHaveTheSameValue) {
  std::mt19937 random(3);
  for (int draw = 0; draw < 10; ++draw) {
    const Field a = random_field(layout, 8, random), joined = a.with_moduli_joined(layout);
    const Point at = random_point(layout, random);
    expect_near(value(joined, layout, at), value(a, layout, at), 1e-12);
    for (const auto& [key, ignored] : joined.terms())
      for (std::size_t k = 0; k < layout.modes; ++k) {
        const int modulus = key[layout.modulus(k)];
        EXPECT_TRUE(modulus == 0 || modulus % 2 != 0);
        if (modulus != 0) {
          EXPECT_EQ(std::min(key[layout.amplitude(k)], key[layout.conjugate(k)]), 0);
        }
      }
  }
}

TEST(Field, ProductsBeyondAllMeasureEnd) {
  ProductCount count;
  count.add(ProductCount::most);
  EXPECT_THROW(count.add(1), std::length_error);
}

TEST(Field, ProductOfSeriesIsTheProductOfPolynomialsInEps) {
  std::mt19937 random(4);
  const FieldSeries a{random_field(layout, 2, random), random_field(layout, 2, random)},
      b{random_field(layout, 2, random), {}, random_field(layout, 3, random)};
  const Point at = random_point(layout, random);
  std::vector<Complex> x, y;
  for (const Field& field : a) x.push_back(value(field, layout, at));
  for (const Field& field : b) y.push_back(value(field, layout, at));
  for (int order = 0; order <= 4; ++order) {
    Complex expected = 0;  // (x0 + eps x1)^2 (y0 + eps^2 y2)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k)
          if (i + j + k == order)
            expected +=
                x[static_cast<std::size_t>(i)] * x[static_cast<std::size_t>(j)] * y[static_cast<std::size_t>(k)];
    ProductCount count;
    expect_near(value(product_at_order({&a, &b, &a}, order, count), layout, at), expected, 1e-10);
  }
}

}  // namespace
}  // namespace secular
