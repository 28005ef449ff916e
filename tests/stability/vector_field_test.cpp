#include "motion/response/vector_field.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fields.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(VectorField, DifferencesAreExactForCubics) {
  const VectorField closed_form = duffing();
  const VectorField differences(
      2, closed_form.parameter_names(),
      [&](const ConstVector& x, const ConstVector& p, OutVector rate) { rate = closed_form.rate(x, p); });
  const VectorXd x = vector({1.3, -0.7}), p = vector({0.1, 0.4, 0.8, 0.3});
  const MatrixXd error = closed_form.jacobian(x, p) - differences.jacobian(x, p);
  EXPECT_LT(error.norm(), 1e-12);
  EXPECT_LT((closed_form.parameter_derivative(x, p, 1) - vector({x(1), -x(0)})).norm(), 1e-12);
}

TEST(VectorField, MisuseIsRefused) {
  const auto nothing = [](const ConstVector&, const ConstVector&, OutVector) {};
  EXPECT_THROW(VectorField(0, {}, nothing), std::invalid_argument);
  EXPECT_THROW(VectorField(1, {}, {}), std::invalid_argument);
  EXPECT_THROW(VectorField(1, {"a", "a"}, nothing), std::invalid_argument);
  VectorField field(1, {"a"}, nothing);
  EXPECT_THROW(field.rate(vector({1, 2}), vector({1})), std::invalid_argument);
  EXPECT_THROW(field.set_typical(vector({0}), vector({1})), std::invalid_argument);
}

}  // namespace
}  // namespace secular
