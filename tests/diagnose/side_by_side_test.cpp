// Motions that are integrated side by side are those that are integrated one by one, to the last bit.
#include <gtest/gtest.h>

#include <cmath>

#include "motion/integrate/motion_integrator.hpp"
#include "effects/force_law.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

using Eigen::Index;

constexpr double swung_omega = 80, start = 1e-3;
constexpr Index moments = 60;
constexpr int substeps = 4;

class SideBySide : public testing::Test {
 protected:
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");

  std::size_t symbol(const std::string& name) const { return symbol_named(model, name); }
  // As many as fill two groups and a part of one, each with numbers of its own.
  std::vector<MotionStart> starts(const std::shared_ptr<const DrivingSignal>& signal = silent()) const {
    std::vector<MotionStart> all;
    for (int i = 0; i < 19; ++i) {
      MotionStart one{std::vector<double>(model.symbols.size(), 0.0),
                      Eigen::Vector2d(start * (1 + 0.05 * i), 0.01 * swung_omega * start * i), signal, moments,
                      substeps};
      one.parameters[symbol("omega0")] = swung_omega * (1 + 1e-3 * i);
      one.parameters[symbol("mu1")] = 0.4;
      one.parameters[symbol("mu3")] = i % 3 == 0 ? 30 : 0;
      one.parameters[symbol("alpha2")] = 1e4 * i;
      one.parameters[symbol("alpha3")] = -2e7;
      one.parameters[symbol("delta2")] = i % 2 == 0 ? 0 : 0.5;
      all.push_back(std::move(one));
    }
    return all;
  }
  // With and without a driving signal.
  static std::shared_ptr<const DrivingSignal> silent() {
    return std::make_shared<const DrivingSignal>(DrivingSignal{Eigen::MatrixXd(), 2e-3});
  }
  static std::shared_ptr<const DrivingSignal> driven() {
    DrivingSignal signal{Eigen::MatrixXd(1, 2 * moments - 1), 2e-3};
    for (Index i = 0; i < signal.half_steps.cols(); ++i)
      signal.half_steps(0, i) =
          std::sin(0.09 * static_cast<double>(i)) + 0.3 * std::cos(0.21 * static_cast<double>(i));
    return std::make_shared<const DrivingSignal>(std::move(signal));
  }
  void expect_the_same(const std::vector<StateForce>& forces, const std::vector<MotionStart>& all) const {
    const MotionIntegrator integrator(model, forces);
    const std::vector<StretchOfMotion> together = integrator.motions(all);
    ASSERT_EQ(together.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const StretchOfMotion alone = integrator.motion(all[i]);
      EXPECT_EQ(together[i].displacement, alone.displacement) << "motion " << i;
      EXPECT_EQ(together[i].velocity, alone.velocity) << "motion " << i;
      EXPECT_EQ(together[i].acceleration, alone.acceleration) << "motion " << i;
      EXPECT_EQ(together[i].side, alone.side) << "motion " << i;
      EXPECT_EQ(together[i].jumps, alone.jumps) << "motion " << i;
      EXPECT_GT(alone.acceleration.cwiseAbs().maxCoeff(), 0);
    }
  }
};

TEST_F(SideBySide, FreeMotionsAndThoseWithSmallChanges) {
  std::vector<MotionStart> all = starts();
  expect_the_same({}, all);
  all[3].change = {{1e-3 * swung_omega * swung_omega, 0}};
  all[4].change = {{0, 1e-3 * swung_omega}};
  expect_the_same({}, all);
}

TEST_F(SideBySide, DrivenMotionsWithAnOscillatorBesideSome) {
  std::vector<MotionStart> all = starts(driven());
  for (MotionStart& one : all) {
    one.parameters[symbol("eta1")] = -0.02;
    one.parameters[symbol("eta2")] = 7;
  }
  expect_the_same({}, all);
  for (std::size_t i = 0; i < all.size(); i += 2)
    all[i].side = SideOscillator{swung_omega * (0.9 + 0.01 * static_cast<double>(i)), 0.01};
  expect_the_same({}, all);
}

TEST_F(SideBySide, MotionsUnderSignalsOfTheirOwnAndOfOtherLengths) {
  std::vector<MotionStart> all = starts(driven());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].parameters[symbol("eta1")] = -0.02;
    DrivingSignal own = *all[i].signal;
    own.half_steps *= 1 + 0.1 * static_cast<double>(i);
    if (i % 3 > 0) all[i].signal = std::make_shared<const DrivingSignal>(std::move(own));
    if (i % 5 == 0) all[i].samples = moments / 2;
    if (i % 7 == 0) all[i].substeps = 2;
  }
  expect_the_same({}, all);
}

TEST_F(SideBySide, AMotionThatGoesBeyondAllBoundsStopsAlone) {
  std::vector<MotionStart> all = starts();
  all[2].parameters[symbol("mu1")] = -60;
  expect_the_same({}, all);
  const StretchOfMotion lost = MotionIntegrator(model, {}).motion(all[2]);
  EXPECT_EQ(lost.displacement(0, moments - 1), 0);
}

// The model's excitation carries the force.
TEST_F(SideBySide, ForcesOfEveryLaw) {
  for (const ForceLaw& law :
       {force_law::slider, force_law::spread_slider, force_law::smooth_slider, force_law::relaxation,
        force_law::displacement_power, force_law::loss_power, force_law::saturation, force_law::decay_with_speed}) {
    StateForce force{law, 0, 0, symbol("eta1"), symbol("mu2"), start};
    std::vector<MotionStart> all = starts();
    for (std::size_t i = 0; i < all.size(); ++i) {
      // Without a shape where it does not act: a law is not asked for then.
      if (i % 4 == 1) continue;
      all[i].parameters[symbol("eta1")] = -0.05 * swung_omega * swung_omega;
      all[i].parameters[symbol("mu2")] = law.kind == ForceLaw::Kind::relaxation ? 0.01 : 3e-4;
    }
    expect_the_same({force}, all);
  }
}

const ForceLaw dry{ForceLaw::Kind::state,
                   [](double, double v, double, double) { return v > 0   ? 1.0
                                                                 : v < 0 ? -1.0
                                                                         : 0.0; }, true};

// Steps end where a velocity comes to zero, in each motion at a time of its own.
TEST_F(SideBySide, FrictionJumps) {
  const StateForce friction{dry, 0, 0, symbol("eta1")};
  std::vector<MotionStart> all = starts();
  for (const std::size_t i : {0UL, 5UL, 6UL})
    all[i].parameters[symbol("eta1")] = -0.1 * start * swung_omega * swung_omega;
  expect_the_same({friction}, all);
  EXPECT_FALSE(MotionIntegrator(model, {friction}).motion(all[5]).jumps.empty());
}

// Some come to rest after half a turn, some never do.
TEST_F(SideBySide, FrictionHolds) {
  const StateForce friction{dry, 0, 0, symbol("eta1")};
  std::vector<MotionStart> all = starts();
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].parameters[symbol("eta1")] =
        -(0.05 + 0.2 * static_cast<double>(i % 5)) * start * swung_omega * swung_omega;
  expect_the_same({friction}, all);
  const StretchOfMotion held = MotionIntegrator(model, {friction}).motion(all[4]);
  EXPECT_EQ(held.velocity(0, moments - 1), 0);
  EXPECT_NE(held.displacement(0, moments - 1), 0);
}

}  // namespace
}  // namespace secular
