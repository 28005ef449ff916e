// Parameters from lumps that were themselves estimated with something that depends on the parameters.
#include "estimator/identification/shared_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "estimator/identification/identified_lumps.hpp"
#include "estimator/model/by_name.hpp"
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

// Lumps of a loaded spring of unit frequency, docs/new_resonance_case.md: 3/2*(a - 10*(a*x)^2) and -6*a*x. Zero is
// a saddle of them, and where the second part of the first is the larger one its sign is not that of a.
class LoadedSpringLumps : public testing::Test {
 protected:
  LoadedSpringLumps() {
    case_.lumps = names_;
    case_.evaluate_lumps = lumps_of;
    case_.evaluate_lumps_jacobian = slopes_of;
    part_.resonance = &case_;
    part_.index = {0, 1, -1};
    part_.combination = MatrixXd::Identity(3, 3);
    part_.plain = Eigen::Vector3d(1e-3, 1e-3, 1e-6).cwiseAbs2().asDiagonal();
    part_.influence = MatrixXd::Zero(2, 3);
    part_.degrees_of_freedom = 20;
    part_.truncation_effect = MatrixXd::Zero(3, 0);
  }
  static void lumps_of(const double* p, double* lumps) {
    const double a = p[1], x = p[2];
    lumps[0] = 1.5 * (a - 10 * a * a * x * x);
    lumps[1] = -6 * a * x;
  }
  static void slopes_of(const double* p, double* slope) {
    const double a = p[1], x = p[2];
    const double rows[] = {0, 1.5 * (1 - 20 * a * x * x), -30 * a * a * x, 0, -6 * x, -6 * a};
    std::copy(std::begin(rows), std::end(rows), slope);
  }
  void see(const VectorXd& truth) {
    part_.values = VectorXd::Ones(3);
    lumps_of(truth.data(), part_.values.data());
  }
  VectorXd found() const {
    return shared_parameters(std::vector{part_}, Eigen::Vector3d(1, 0, 0), {false, false, false}).values;
  }

  CompiledLump names_[2] = {};
  CompiledCase case_;
  LumpEstimates part_;
};

TEST_F(LoadedSpringLumps, AreFollowedOnTheRightSideOfZero) {
  for (const double a : {0.5, -0.5, 1.0})
    for (const double x : {0.1, -0.1, 0.5, -0.5}) {
      const VectorXd truth = Eigen::Vector3d(1, a, x);
      see(truth);
      EXPECT_LT((found() - truth).norm(), 1e-6) << a << " " << x << ": " << found().transpose();
    }
}

// Slopes of the truncation's correction at the parameters, as large beside the lumps as they may be: carried to
// zero they would be as large as the lumps.
TEST_F(LoadedSpringLumps, AreCorrectedAtTheParametersAndNotAtZero) {
  const VectorXd truth = Eigen::Vector3d(1, 0.5, 0.1);
  see(truth);
  part_.truncation_at = truth;
  part_.truncation_slope = MatrixXd::Zero(3, 3);
  part_.truncation_slope(0, 1) = 2.5;
  part_.truncation_slope(0, 2) = -2;
  EXPECT_LT((found() - truth).norm(), 1e-6) << found().transpose();
}

class Entangled : public testing::Test {
 protected:
  void SetUp() override {
    const std::map<std::string, double> known{{"omega0", 77.85}, {"mu1", 0.2},   {"mu2", 0.1},     {"mu3", 37.0},
                                              {"eta1", -0.02},   {"eta2", 7.6},  {"alpha2", -1e4}, {"alpha3", -2e7},
                                              {"delta2", 0.5},   {"delta3", 2e3}};
    parameters_ = VectorXd::Zero(static_cast<Index>(model_.symbols.size()));
    for (const auto& [name, value] : known) parameters_(symbol(name)) = value;
    part_.resonance = &resonance_;
    lumps_.resize(static_cast<Index>(resonance_.lumps.size()));
    resonance_.evaluate_lumps(parameters_.data(), lumps_.data());
    // Neither the zero-frequency component nor higher harmonics, which would separate stiffness from inertia.
    for (std::size_t l = 0; l < resonance_.lumps.size(); ++l)
      if (const std::string name(resonance_.lumps[l].name); name != "alpha_0" && name.find("harmonic") != 0)
        part_.index.push_back(static_cast<int>(l));
    part_.values = lumps_(part_.index);
    const Index lumps = part_.values.size();
    part_.combination = MatrixXd::Identity(lumps, lumps);
    sd_ = 1e-3 * part_.values.cwiseAbs().cwiseMax(1e-3);
    part_.plain = sd_.cwiseAbs2().asDiagonal();
    part_.influence = MatrixXd::Zero(2, lumps);
    part_.degrees_of_freedom = 20;
    part_.truncation_effect = MatrixXd::Zero(lumps, 0);
    std::vector<bool> given(model_.symbols.size(), false);
    given[0] = true;
    shared_ = shared_parameters(std::vector{part_}, parameters_, given);
  }
  Index symbol(const std::string& name) const { return static_cast<Index>(symbol_named(model_, name)); }
  double lump(const std::string& name) const {
    for (std::size_t l = 0; l < resonance_.lumps.size(); ++l)
      if (resonance_.lumps[l].name == name) return lumps_(static_cast<Index>(l));
    throw std::out_of_range(name);
  }

  const CompiledModel& model_ = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance_ = model_.cases[0];
  LumpEstimates part_;
  SharedParameters shared_;
  VectorXd parameters_, lumps_, sd_;
};

TEST_F(Entangled, WhatIsPlausibleOfAParameterFollowsFromTheLumpThatItWouldMakeAlone) {
  const MatrixXd& null_space = shared_.null_space;
  ASSERT_EQ(null_space.cols(), 2);
  EXPECT_LT((shared_.null_space_coordinate * null_space - MatrixXd::Identity(2, 2)).norm(), 1e-9);
  const auto plausible = [&](const char* name) { return null_space.row(symbol(name)).norm(); };
  // alpha_q = alpha2 - 3*omega0^2*delta2: each as much as the lump, of which they share one direction.
  const double omega = parameters_(0), alone = std::abs(lump("alpha_q"));
  EXPECT_NEAR(plausible("alpha2"), alone / std::sqrt(2.0), 1e-3 * alone);
  EXPECT_NEAR(plausible("delta2"), alone / (3 * omega * omega) / std::sqrt(2.0),
              1e-3 * alone / (3 * omega * omega));
  // Nothing that lumps tell moves along it.
  for (const char* name : {"mu1", "mu2", "mu3", "eta1"}) EXPECT_EQ(plausible(name), 0) << name;
}

TEST_F(Entangled, ParametersReturnToTheirLumps) {
  Estimate estimate;
  estimate.cases = {&resonance_};
  estimate.lumps.resize(resonance_.lumps.size());
  for (Index l = 0; l < sd_.size(); ++l) {
    EstimatedValue& value = estimate.lumps[static_cast<std::size_t>(part_.index[static_cast<std::size_t>(l)])];
    value.value = part_.values(l);
    value.sd = sd_(l);
  }
  const IdentifiedLumps seen(estimate);
  for (Index d = 0; d < 2; ++d) {
    const VectorXd tangent = shared_.values + 2 * shared_.null_space.col(d);
    const VectorXd there = seen.returned(tangent, shared_.values, shared_.null_space);
    EXPECT_LT((seen.at(there) - seen.at(shared_.values)).norm(), 1e-3);
    // The way back is short beside the way there.
    EXPECT_LT(((shared_.null_space_coordinate * (there - tangent)).norm()), 0.5);
    EXPECT_EQ(there(symbol("mu1")), shared_.values(symbol("mu1")));
  }
  // The quadratic ones are part of alpha_e as products: their tangent leaves it.
  const double moved =
      std::max((seen.at(shared_.values + 2 * shared_.null_space.col(0)) - seen.at(shared_.values)).norm(),
               (seen.at(shared_.values + 2 * shared_.null_space.col(1)) - seen.at(shared_.values)).norm());
  EXPECT_GT(moved, 1);
}

}  // namespace
}  // namespace secular
