// Residue conversion, scaling, assurance, modal mass on a system whose matrices are known.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "measure/modal/modal_assurance.hpp"
#include "measure/modal/modal_mass.hpp"
#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/residue_conversion.hpp"
#include "tests/modal/pole_of.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

TEST(ResidueConversion, TableB1) {
  const Complex pole = pole_of(30, 0.02), receptance = 1.0 / (Complex(0, 2 * pole.imag()) * 0.5);  // m = 0.5 kg
  const Complex mobility = convert_residue(receptance, pole, ResponseForm::receptance, ResponseForm::mobility);
  const Complex accelerance =
      convert_residue(receptance, pole, ResponseForm::receptance, ResponseForm::accelerance);
  EXPECT_LT(std::abs(mobility - receptance * pole), 1e-15);
  EXPECT_LT(std::abs(accelerance - receptance * pole * pole), 1e-13);
  EXPECT_LT(
      std::abs(convert_residue(accelerance, pole, ResponseForm::accelerance, ResponseForm::mobility) - mobility),
      1e-15);
  EXPECT_LT(std::abs(convert_residue(accelerance, pole, ResponseForm::accelerance, ResponseForm::receptance) -
                     receptance),
            1e-17);
  // D = 1/m, real: the last rows of Table B.1 need a factor i beside 2 omega sqrt(1 - zeta^2), since a receptance
  // residue is imaginary, Eqs. (B.6) and (B.9). Eq. (B.8) shows the same: its pulse is -a omega sqrt(1 - zeta^2).
  for (const auto& [residue, form] :
       {std::pair(receptance, ResponseForm::receptance), std::pair(mobility, ResponseForm::mobility),
        std::pair(accelerance, ResponseForm::accelerance)})
    EXPECT_LT(
        std::abs(Complex(0, 2 * pole.imag()) * convert_residue(residue, pole, form, ResponseForm::receptance) -
                 2.0),
        1e-13);
}

TEST(ResidueConversion, FormOfAQuantity) {
  EXPECT_EQ(response_form(Quantity::acceleration), ResponseForm::accelerance);
  EXPECT_EQ(response_form(Quantity::velocity), ResponseForm::mobility);
  EXPECT_EQ(response_form(Quantity::angle), ResponseForm::receptance);
  EXPECT_THROW(response_form(Quantity::force), std::invalid_argument);
}

TEST(ModalAssurance, KnownValues) {
  Eigen::Vector3cd a, b, c;
  a << 1, 2, 2;
  b << Complex(0, -3), Complex(0, -6), Complex(0, -6);
  c << 2, -1, 0;
  EXPECT_NEAR(modal_assurance(a, b), 1, 1e-15);
  EXPECT_NEAR(modal_assurance(a, c), 0, 1e-15);
  EXPECT_EQ(modal_assurance(a, Eigen::Vector3cd::Zero()), 0);
  Eigen::Vector3cd d;
  d << 1, 0, 0;
  EXPECT_NEAR(modal_assurance(a, d), 1.0 / 9, 1e-15);
  EXPECT_NEAR(phase_collinearity(b), 1, 1e-15);
  Eigen::Vector2cd wave;
  wave << 1, Complex(0, 1);
  EXPECT_NEAR(phase_collinearity(wave), 0, 1e-15);
  EXPECT_THROW(scale_shape(Eigen::Vector2cd::Zero()), std::invalid_argument);
}

TEST(ModeScaling, SumOfSquaresIsOne) {
  Eigen::Vector3cd shape;
  shape << Complex(0.1, -2), Complex(-0.02, 1), Complex(0.3, 0.4);
  const ScaledShape scaled = scale_shape(shape);
  EXPECT_LT(std::abs((scaled.shape.array() * scaled.shape.array()).sum() - 1.0), 1e-14);
  EXPECT_LT((scaled.factor * scaled.shape - shape).norm(), 1e-14);
  EXPECT_GT(scaled.shape(0).real(), 0);
  // No other phase has a larger real part.
  for (double turn = -3; turn < 3; turn += 0.1)
    EXPECT_LE((scaled.shape * std::polar(1.0, turn)).real().norm(), scaled.shape.real().norm() + 1e-12);
}

TEST(ModeScaling, SquaresOfAWhirlingModeCancel) {
  Eigen::Vector2cd whirl;
  whirl << Complex(0, -3), Complex(3, 0);
  EXPECT_TRUE(squares_cancel(whirl));
  EXPECT_FALSE(squares_cancel(Eigen::Vector2cd(1, Complex(0, 0.9))));
  const ScaledShape scaled = scale_shape(whirl);
  EXPECT_NEAR(scaled.shape.norm(), 1, 1e-14);
  EXPECT_LT((scaled.factor * scaled.shape - whirl).norm(), 1e-14);
  EXPECT_NEAR(std::abs(scaled.shape(0).real()), std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(scaled.shape(0).imag(), 0, 1e-14);
}

// Accelerance residues of a system with known M, C = alpha M + beta K, K: masses by Eq. (2.7) and matrices come
// back.
TEST(ModalMass, RecoversTheMatrices) {
  Eigen::Matrix3d mass, stiffness;
  mass << 0.54, 0, 0.05, 0, 0.55, 0.03, 0.05, 0.03, 0.52;
  stiffness << 9500, -9200, 3400, -9200, 18200, 1900, 3400, 1900, 32000;
  const Eigen::Matrix3d damping = 0.3 * mass + 2e-5 * stiffness;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> eigen(stiffness, mass);
  Eigen::Matrix3d shapes;
  Eigen::Vector3d masses;
  Eigen::Vector3cd poles;
  for (int r = 0; r < 3; ++r) {
    const double omega = std::sqrt(eigen.eigenvalues()(r));
    poles(r) = pole_of(omega, (0.3 + 2e-5 * omega * omega) / (2 * omega));
    const Eigen::Vector3d phi = eigen.eigenvectors().col(r);
    const int reference = r;
    Eigen::Vector3cd accelerance;
    for (int p = 0; p < 3; ++p)
      accelerance(p) = convert_residue(phi(p) * phi(reference) / Complex(0, 2 * poles(r).imag()), poles(r),
                                       ResponseForm::receptance, ResponseForm::accelerance);
    // Any split of the residue into C and B; then Eqs. (2.4) to (2.6).
    const ScaledShape scaled = scale_shape(accelerance);
    const Complex amplitude =
        convert_residue(scaled.factor, poles(r), ResponseForm::accelerance, ResponseForm::receptance);
    const Complex estimate = modal_mass(poles(r), scaled.shape(reference), amplitude);
    EXPECT_LT(std::abs(estimate.imag()), 1e-10);
    masses(r) = estimate.real();
    shapes.col(r) = scaled.shape.real();
  }
  const DynamicMatrices found = dynamic_matrices(mass_normalised_shapes(shapes, masses), poles);
  EXPECT_LT((found.mass - mass).norm(), 1e-10);
  EXPECT_LT((found.damping - damping).norm(), 1e-9);
  EXPECT_LT((found.stiffness - stiffness).norm(), 1e-6);
  EXPECT_THROW(mass_normalised_shapes(shapes, Eigen::Vector3d(1, -1, 1)), std::invalid_argument);
  shapes.col(1) = shapes.col(0);
  EXPECT_THROW(dynamic_matrices(shapes, poles), std::invalid_argument);
}

}  // namespace
}  // namespace secular
