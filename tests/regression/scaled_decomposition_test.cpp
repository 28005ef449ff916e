#include "estimator/regression/scaled_decomposition.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "../signal/gaussian.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The third column is the sum of the others. Few rows are decomposed as they are, many are condensed first.
TEST(ScaledDecomposition, NullSpaceAndNormalMatrixForFewAndManyRows) {
  testing_support::Gaussian noise(5);
  for (const Index rows : {Index{5}, Index{500}}) {
    MatrixXd design(rows, 3);
    design.col(0) = noise.vector(rows);
    design.col(1) = 1e6 * noise.vector(rows);
    design.col(2) = design.col(0) + design.col(1);
    const VectorXd response = noise.vector(rows);
    const ScaledDecomposition parts = scaled_decomposition(design, response, 1e-9, 1);
    ASSERT_EQ(parts.rank(), 2);
    ASSERT_EQ(parts.null.cols(), 1);
    const MatrixXd scaled = design * parts.scale.asDiagonal();
    EXPECT_LT((scaled.colwise().norm().array() - 1).abs().maxCoeff(), 1e-12);
    EXPECT_LT((scaled * parts.null).norm(), 1e-12);
    const VectorXd singular = parts.inverse.cwiseInverse();
    EXPECT_LT(
        (scaled.transpose() * scaled - parts.seen * singular.cwiseAbs2().asDiagonal() * parts.seen.transpose())
            .norm(),
        1e-12);
    EXPECT_DOUBLE_EQ(parts.largest, singular.maxCoeff());
    // Normal equations: scaled' response = seen * singular * coordinates.
    const VectorXd coordinates = parts.seen.transpose() * (scaled.transpose() * response);
    EXPECT_LT((coordinates - singular.cwiseProduct(parts.coordinates)).norm(), 1e-12 * response.norm());
    EXPECT_EQ(parts.left.size() > 0, rows == 5);
  }
}

TEST(ScaledDecomposition, FewerRowsThanColumns) {
  const ScaledDecomposition parts = scaled_decomposition(MatrixXd::Identity(2, 3), VectorXd::Ones(2), 1e-9, 1);
  EXPECT_EQ(parts.rank(), 2);
  EXPECT_NEAR(std::abs(parts.null(2, 0)), 1, 1e-15);
}

}  // namespace
}  // namespace secular
