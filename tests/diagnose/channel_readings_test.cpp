// From motions to readings and back.
#include "diagnose/evidence/channel_readings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using testing_support::Laboratory;
using testing_support::natural;

TEST(ChannelCut, IsUndoneWithTheLinesItWasCutWith) {
  const Torus torus(1, 5, 256);
  for (const double level : {1.5, 1.0, 0.7})
    for (const double noise : {0.0, 0.1}) {
      const ChannelCut cut{level, noise};
      MatrixXcd lines = MatrixXcd::Zero(1, torus.lines());
      lines(0, 0) = 0.05;
      lines(0, 1) = Complex(0.4, -0.5);
      lines(0, 3) = Complex(-0.03, 0.06);
      MatrixXcd shown = lines;
      cut.apply(torus, shown, 0);
      const Complex share = cut.uncut_share(torus, lines, 1, shown(0, 1));
      EXPECT_LT(std::abs(share * shown(0, 1) - lines(0, 1)), 1e-6) << level << " " << noise;
    }
}

TEST(ChannelCut, LeavesAloneWhatStaysClearOfTheLevel) {
  const Torus torus(1, 3, 64);
  MatrixXcd lines = MatrixXcd::Zero(1, torus.lines());
  lines(0, 1) = Complex(0.1, 0.2);
  MatrixXcd shown = lines;
  ChannelCut{1, 0}.apply(torus, shown, 0);
  EXPECT_EQ(shown, lines);
  EXPECT_EQ(ChannelCut({1, 0}).uncut_share(torus, lines, 1, 0), 1.0);
}

// Every fault at once: what the channels would show of a motion gives back the motion's amplitude, and what the
// excitation channel shows is what was measured of it.
TEST(ChannelReadings, MasterAmplitudeOfAPredictedReadingIsThatOfTheMotion) {
  const Laboratory lab;
  const Complex amplitude(2e-3, -1.5e-3);
  for (const double level : {0.0, 0.8}) {
    Condition dwell = lab.dwell(natural, 3, amplitude);
    Eigen::VectorXd values = lab.unknowns({});
    const auto set = [&](std::size_t fault, double value) {
      values(static_cast<Index>(lab.compiled.symbols.size() + fault)) = value;
    };
    set(lab.faults.gain(0), 0.07);
    set(lab.faults.cross(0), 0.02);
    set(lab.faults.delay(0), 1e-3);
    set(lab.faults.offset(0), 0.5);
    set(lab.faults.gain(1), -0.04);
    set(lab.faults.delay(1), -2e-3);
    set(lab.faults.mixing(0, 0), 0.1);
    set(lab.faults.extra_amplitude(0), 0.03);
    if (level > 0) set(lab.faults.inverse_level(0), 1 / (level * 2 * natural * natural * std::abs(amplitude)));
    const Faults faults = lab.faults.faults(values.data() + lab.compiled.symbols.size());

    MatrixXcd displacement = MatrixXcd::Zero(1, dwell.torus->lines());
    displacement(0, 1) = amplitude;
    displacement(0, 2) = Complex(1e-5, 2e-5);
    displacement(0, 3) = Complex(-3e-5, 1e-5);
    const MatrixXcd shown = ChannelReadings(dwell, lab.sensors, faults).predicted_responses(displacement);
    for (std::size_t l = 0; l < dwell.lines.size(); ++l)
      dwell.response(0, static_cast<Index>(l)) = shown(0, dwell.lines[l]);

    const ChannelReadings readings(dwell, lab.sensors, faults);
    EXPECT_EQ(readings.response_saturates(), level > 0);
    EXPECT_LT(std::abs(readings.master_amplitudes(displacement)(0) - amplitude), 1e-7 * std::abs(amplitude));
    EXPECT_LT(std::abs(readings.expected_excitation()(0, 0) - dwell.excitation(0, 0)), 1e-12);
    EXPECT_GT(std::abs(readings.true_excitation()(0, 0) - dwell.excitation(0, 0)), 0.01);
  }
}

}  // namespace
}  // namespace secular
