#include "diagnose/evidence/dwell_ensembles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::Index;

constexpr double rate = 200, excitation = 2 * std::numbers::pi * 10;
constexpr Index length = 400;

// A motion at half of the excitation's frequency and the excitation; the responses' phase jumps by half a turn of
// the excitation's, which the two cannot tell, in every second ensemble.
RecordPart subharmonic_dwell(Index ensembles) {
  RecordPart part;
  part.samples.resize(ensembles * length, 2);
  for (Index i = 0; i < part.samples.rows(); ++i) {
    const double t = static_cast<double>(i) / rate;
    const double turn = (i / length) % 2 == 0 ? 1 : -1;
    part.samples(i, 0) = 0.5 + turn * 3 * std::cos(0.5 * excitation * t + 0.4) + std::sin(excitation * t);
    part.samples(i, 1) = 4 * std::cos(excitation * t + 0.3);
  }
  return part;
}

DwellLines subharmonic_lines(const DwellReader& reader) {
  DwellLines lines;
  lines.layout.divisor = 2;
  lines.layout.excitation = {2, 0};
  lines.torus = std::make_shared<const Torus>(1, 8, 255);
  lines.base = {0.5 * excitation, 0};
  lines.fundamental = *lines.torus->find({2, 0});
  lines.observed = reader.observable(lines, Window{});
  lines.excitation = {0, lines.fundamental};
  return lines;
}

TEST(DwellEnsembles, AlignedOnesAgreeWhateverTurnTheyBeganAt) {
  const RecordPart part = subharmonic_dwell(4);
  const DwellReader reader(part, rate, 1, length);
  ASSERT_EQ(reader.ensembles(), 4);
  const DwellLines lines = subharmonic_lines(reader);
  std::vector<LineEnsemble> ensembles = reader.read(lines);
  align(ensembles, lines);
  const EnsembleStatistics statistics = statistics_of(ensembles, lines);
  EXPECT_LT(statistics.response_scatter.maxCoeff(), 1e-12);
  EXPECT_LT(statistics.response_about_line.maxCoeff(), 1e-12);
  const auto of_excitation = statistics.excitation(0, lines.excitation_column(lines.fundamental));
  EXPECT_NEAR(of_excitation.real(), 2, 1e-12);
  EXPECT_NEAR(of_excitation.imag(), 0, 1e-12);
  EXPECT_NEAR(std::abs(statistics.response(0, lines.column(*lines.torus->find({1, 0})))), 1.5, 1e-12);
  // sin = cos(. - pi/2) against the excitation's phase of 0.3.
  EXPECT_NEAR(std::arg(statistics.response(0, lines.column(lines.fundamental))), -std::numbers::pi / 2 - 0.3,
              1e-12);
  EXPECT_NEAR(statistics.response(0, lines.column(0)).real(), 0.5, 1e-12);
}

TEST(DwellEnsembles, TheMeanIsLeftOutWhereABandHasTakenItAway) {
  const RecordPart part = subharmonic_dwell(2);
  const DwellReader reader(part, rate, 1, length);
  DwellLines lines = subharmonic_lines(reader);
  std::vector<LineEnsemble> ensembles = reader.read(lines);
  const Index columns = ensembles.front().response.cols();
  leave_mean_out(ensembles, lines);
  EXPECT_FALSE(lines.observes(0));
  EXPECT_EQ(ensembles.front().response.cols(), columns - 1);
}

// Three ensembles with values 1, 2, 3: a straight line leaves nothing, the mean a standard deviation of one.
TEST(DwellEnsembles, ScatterAboutTheMeanAndAboutAStraightLine) {
  DwellLines lines;
  lines.observed = lines.excitation = {0};
  std::vector<LineEnsemble> ensembles(3);
  for (std::size_t e = 0; e < ensembles.size(); ++e) {
    ensembles[e].response = ensembles[e].excitation =
        Eigen::MatrixXcd::Constant(1, 1, 1.0 + static_cast<double>(e));
    ensembles[e].noise = Eigen::VectorXd::Constant(2, static_cast<double>(e));
  }
  const EnsembleStatistics statistics = statistics_of(ensembles, lines);
  EXPECT_DOUBLE_EQ(statistics.response(0, 0).real(), 2);
  EXPECT_DOUBLE_EQ(statistics.response_scatter(0, 0), 1);
  EXPECT_NEAR(statistics.response_about_line(0, 0), 0, 1e-15);
  EXPECT_DOUBLE_EQ(statistics.noise(0), std::sqrt(5.0 / 3));
}

}  // namespace
}  // namespace secular
