// Parameters from lumps that were themselves estimated with something that depends on the parameters.
#include "estimator/identification/shared_parameters.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "generated/registry.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Lumps that are corrected at the parameters found, again and again until both rest, and the slopes that say so at
// once.
TEST(SharedParameters, SlopeIsThatOfLumpsCorrectedAtTheValues) {
  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  const CompiledCase& resonance = model.cases[0];
  const auto lumps = static_cast<Index>(resonance.lumps.size()), symbols = static_cast<Index>(model.symbols.size());
  VectorXd parameters = VectorXd::Constant(symbols, 0.5);
  parameters(0) = 5.77;
  VectorXd values(lumps);
  resonance.evaluate_lumps(parameters.data(), values.data());
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto drawn = [&](Index rows, Index columns, double size) {
    MatrixXd m(rows, columns);
    for (Index i = 0; i < rows; ++i)
      for (Index j = 0; j < columns; ++j) m(i, j) = size * normal(random);
    return m;
  };
  LumpEstimates part;
  part.resonance = &resonance;
  for (Index l = 0; l < lumps; ++l) part.index.push_back(static_cast<int>(l));
  part.combination = MatrixXd::Identity(lumps, lumps);
  const MatrixXd root = drawn(lumps, lumps, 0.1) + MatrixXd::Identity(lumps, lumps);
  part.plain = root * root.transpose();
  part.values = values + drawn(lumps, 1, 1e-3);
  part.truncation_effect = MatrixXd::Zero(lumps, 0);
  part.truncation_slope = drawn(lumps, symbols, 0.03);
  std::vector<bool> given(static_cast<std::size_t>(symbols), false);
  given[0] = true;
  const VectorXd measured = part.values;
  part.truncation_at = parameters + drawn(symbols, 1, 1e-2);
  part.truncation_at(0) = parameters(0);
  const auto settled = [&](const VectorXd& lumps_seen) {
    LumpEstimates now = part;
    VectorXd p = part.truncation_at;
    for (int pass = 0; pass < 50; ++pass) {
      now.values = lumps_seen + part.truncation_slope * (p - part.truncation_at);
      now.truncation_at = p;
      p = shared_parameters(std::vector{now}, parameters, given).values;
    }
    return p;
  };
  const SharedParameters shared = shared_parameters(std::vector{part}, parameters, given);
  ASSERT_EQ(shared.slope.size(), 1U);
  EXPECT_LT((shared.values - settled(measured)).norm(), 1e-8);
  for (Index l = 0; l < lumps; ++l) {
    const double step = 1e-4;
    const VectorXd change = (settled(measured + step * VectorXd::Unit(lumps, l)) -
                             settled(measured - step * VectorXd::Unit(lumps, l))) /
                            (2 * step);
    EXPECT_LT((shared.slope[0].col(l) - change).norm(), 1e-4 * (1 + change.norm())) << "lump " << l;
  }
}

}  // namespace
}  // namespace secular
