// Eqs. (2.17) to (2.20) from Tables 2.3 to 2.5, to the printed digits.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "measure/modal/modal_mass.hpp"
#include "measure/modal/pole.hpp"
#include "tests/modal/two_mass_structure.hpp"

namespace secular {
namespace {

using Eigen::Matrix3d;
using testing_support::two_mass_tables;

Matrix3d mass_normalised() {
  const auto t = two_mass_tables();
  return mass_normalised_shapes(t.shapes, t.masses);
}

DynamicMatrices matrices_of(const Matrix3d& shapes) {
  const auto t = two_mass_tables();
  Eigen::Vector3cd poles;
  for (int r = 0; r < 3; ++r)
    poles(r) = 2 * std::numbers::pi * std::complex<double>(t.damping_factor_hz(r), t.frequency_hz(r));
  return dynamic_matrices(shapes, poles);
}

void expect_printed(const Matrix3d& computed, const Matrix3d& printed, double half_digit) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_LE(std::abs(computed(i, j) - printed(i, j)), half_digit)
          << i << ", " << j << ": " << computed(i, j) << " for " << printed(i, j);
}

TEST(ThesisTables, AverageModalMasses) {
  const auto t = two_mass_tables();
  EXPECT_NEAR(0.5 * (0.528 + 0.518), t.masses(0), 5e-4);
  EXPECT_NEAR(0.5 * (0.570 + 0.526), t.masses(1), 5e-4);
}

TEST(ThesisTables, MassNormalisedShapes) {
  Matrix3d printed;
  printed << 1.1603, -0.7199, 0.0105, 0.7336, 1.1428, -0.0166, -0.1669, 0.0228, 1.3826;
  expect_printed(mass_normalised(), printed, 0.5e-4);
}

// All eighteen different entries agree to the printed digits, no exception. They do so from the unrounded shapes:
// the printed ones of (2.17) would give 1900 and 31895 where (2.20) has 1899 and 31893.
TEST(ThesisTables, Matrices) {
  const DynamicMatrices computed = matrices_of(mass_normalised());
  Matrix3d mass, damping, stiffness;
  mass << 0.5421, -0.0048, 0.0543, -0.0048, 0.5444, 0.0330, 0.0543, 0.0330, 0.5230;
  damping << 0.3171, -0.0062, 0.0606, -0.0062, 0.3205, 0.0324, 0.0606, 0.0324, 0.5638;
  stiffness << 9533, -9191, 3387, -9191, 18192, 1899, 3387, 1899, 31893;
  expect_printed(computed.mass, mass, 0.5e-4);
  expect_printed(computed.damping, damping, 0.5e-4);
  expect_printed(computed.stiffness, stiffness, 0.5);
}

TEST(ThesisTables, RoundedShapesMissTheStiffness) {
  Matrix3d rounded;
  rounded << 1.1603, -0.7199, 0.0105, 0.7336, 1.1428, -0.0166, -0.1669, 0.0228, 1.3826;
  const DynamicMatrices computed = matrices_of(rounded);
  EXPECT_NEAR(computed.stiffness(1, 2), 1900.16, 0.01);
  EXPECT_NEAR(computed.stiffness(2, 2), 31894.75, 0.01);
}

// The matrices give back what they were made of, Eqs. (2.10) to (2.12).
TEST(ThesisTables, MatricesAreOrthogonalInTheShapes) {
  const Matrix3d shapes = mass_normalised();
  const DynamicMatrices m = matrices_of(shapes);
  const auto t = two_mass_tables();
  EXPECT_LT((shapes.transpose() * m.mass * shapes - Matrix3d::Identity()).norm(), 1e-12);
  for (int r = 0; r < 3; ++r) {
    const std::complex<double> pole =
        2 * std::numbers::pi * std::complex<double>(t.damping_factor_hz(r), t.frequency_hz(r));
    EXPECT_NEAR((shapes.transpose() * m.damping * shapes)(r, r), 2 * damping_ratio(pole) * natural_frequency(pole),
                1e-10);
    EXPECT_NEAR((shapes.transpose() * m.stiffness * shapes)(r, r), std::pow(natural_frequency(pole), 2), 1e-8);
  }
}

TEST(ThesisTables, ShapesOfTable25HaveUnitLength) {
  const auto t = two_mass_tables();
  for (int r = 0; r < 3; ++r) EXPECT_NEAR(t.shapes.col(r).norm(), 1, 2e-4);
}

}  // namespace
}  // namespace secular
