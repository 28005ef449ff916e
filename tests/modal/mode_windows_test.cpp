// Windows in which a record shows nothing of a mode: it is followed no longer, and nothing is wrong with the call.
#include "measure/modal/mode_windows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double rate = 256;
const std::complex<double> pole_at_20_hz(-1, 2 * 3.14159265358979 * 20);

MatrixXd windowed_decay(Index rows) {
  MatrixXd samples(rows, 2);
  for (Index i = 0; i < rows; ++i) {
    const double value = std::exp(pole_at_20_hz * (static_cast<double>(i) / rate)).real();
    samples.row(i) << value, -0.5 * value;
  }
  return samples;
}

ModeWindowOptions windows_of(double length_s) {
  ModeWindowOptions options;
  options.length_s = length_s;
  return options;
}

TEST(ModeWindows, EndWhereARecordIsSilent) {
  MatrixXd samples = windowed_decay(1024);
  samples.bottomRows(600).setZero();
  const auto windows = mode_windows(samples, rate, {pole_at_20_hz}, windows_of(0.25));
  ASSERT_FALSE(windows.empty());
  for (const ModeWindow& window : windows) EXPECT_LT(window.centre_s, 424 / rate);
  EXPECT_TRUE(mode_windows(MatrixXd::Zero(512, 2), rate, {pole_at_20_hz}, windows_of(0.25)).empty());
}

TEST(ModeWindows, LeaveOutWhatTheSampleRateDoesNotShow) {
  const std::complex<double> above(-1, 2 * 3.14159265358979 * 150);
  for (const ModeWindow& window : mode_windows(windowed_decay(512), rate, {pole_at_20_hz, above}, windows_of(0.25)))
    EXPECT_EQ(window.mode, 0);
}

TEST(ModeWindows, RefuseAWindowThatDoesNotFit) {
  for (const double length_s : {0.01, 2.5, 1e300}) {
    EXPECT_FALSE(window_fits(512, rate, 1, length_s)) << length_s;
    EXPECT_THROW(mode_windows(windowed_decay(512), rate, {pole_at_20_hz}, windows_of(length_s)),
                 std::invalid_argument);
  }
  EXPECT_TRUE(window_fits(512, rate, 1, 2));
}

}  // namespace
}  // namespace secular
