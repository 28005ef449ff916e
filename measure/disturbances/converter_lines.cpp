#include "measure/disturbances/converter_lines.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/data/noise_floor.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Less noise before the converter, in steps, is taken for so much: what rounding adds then stays a smooth function
// of the motion that a few terms hold (the ninth is 1e-7 of the first), and motion and rounding come to agree.
constexpr double least_noise = 0.1;
// More blurs the steps: the first term is 3e-9 of a step.
constexpr double blurred = 1;

constexpr int most_rounds = 40;
// They agree when the motion moves by less than this share of its standard error.
constexpr double agreed = 0.05;

// exp(-2 pi^2 n^2 s^2): what noise of s steps leaves of term n.
double damped(int n, double s) {
  const double x = std::numbers::pi * n * s;
  return std::exp(-2 * x * x);
}

// Mean square of what is left of rounding and noise of s steps when the mean of rounding is taken out, in steps^2.
double left_over(double s) {
  double taken_out = 0;
  for (int n = 1; n <= MeanRounding::terms; ++n) taken_out += std::pow(damped(n, s) / n, 2);
  return s * s + 1.0 / 12 - taken_out / (2 * std::numbers::pi * std::numbers::pi);
}

// The noise before the converter that leaves that mean square; left_over rises with it.
double noise_of(double mean_square) {
  double low = least_noise, high = std::max(least_noise, std::sqrt(mean_square));
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (left_over(middle) < mean_square ? low : high) = middle;
  }
  return high;
}

// Orthonormal columns of a constant, a straight line and tones.
MatrixXd motion_columns(std::size_t samples, double rate_hz, const std::vector<double>& frequencies_hz) {
  const auto n = static_cast<Index>(samples);
  const VectorXd t =
      VectorXd::LinSpaced(n, -0.5 * static_cast<double>(n - 1), 0.5 * static_cast<double>(n - 1)) / rate_hz;
  MatrixXd columns(n, 2 + 2 * static_cast<Index>(frequencies_hz.size()));
  columns.col(0).setOnes();
  columns.col(1) = t / std::max(1.0, t.cwiseAbs().maxCoeff());
  for (std::size_t j = 0; j < frequencies_hz.size(); ++j) {
    const auto at = 2 + 2 * static_cast<Index>(j);
    columns.col(at) = (two_pi * frequencies_hz[j] * t).array().cos();
    columns.col(at + 1) = (two_pi * frequencies_hz[j] * t).array().sin();
  }
  // Tones that a block cannot tell apart span fewer columns.
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(1e-6);
  return qr.householderQ() * MatrixXd::Identity(n, qr.rank());
}

// What rounding adds to one block in the mean; nothing where motion and rounding do not come to agree.
std::optional<VectorXd> rounding_of(const VectorXd& values, const MatrixXd& motion,
                                    const ConverterLattice& lattice) {
  const auto freedom = static_cast<double>(motion.rows() - motion.cols());
  VectorXd moved = motion * (motion.transpose() * values);
  double square = (values - moved).squaredNorm() / freedom;
  double noise = std::sqrt(std::max(0.0, square / (lattice.step * lattice.step) - 1.0 / 12));
  VectorXd added(values.size());
  for (int round = 0; round < most_rounds; ++round) {
    if (noise > blurred) return VectorXd::Zero(values.size());
    const double sd = std::max(noise, least_noise) * lattice.step;
    const MeanRounding rounding(lattice, sd);
    for (Index i = 0; i < values.size(); ++i) added(i) = rounding.at(moved(i));
    const VectorXd corrected = values - added;
    const VectorXd next = motion * (motion.transpose() * corrected);
    square = (corrected - next).squaredNorm() / freedom;
    noise = noise_of(square / (lattice.step * lattice.step));
    const double change = (next - moved).squaredNorm();
    moved = next;
    if (change < agreed * agreed * square * static_cast<double>(motion.cols())) return added;
  }
  return std::nullopt;
}

}  // namespace

// Unquantised values lie on a lattice of their smallest gap by chance: one gap in ten does within the tolerance of
// ValueGrid, which wants 95 % of them.
bool is_lattice(const ValueGrid& grid, double level) {
  if (!grid.visited || grid.levels < 4) return false;
  const auto gaps = static_cast<double>(grid.levels - 2);  // beside the smallest, which defines the step
  return binomial_upper_tail(std::ceil(0.95 * gaps), gaps, 0.1) < level;
}

double ConverterLattice::repeated_line() const {
  return step / std::numbers::pi * damped(1, noise / step);
}

std::optional<ConverterLattice> repeating_lattice(const SearchedChannel& channel, double level) {
  if (channel.samples.empty() || !is_lattice(channel.values->grid, level)) return std::nullopt;
  const std::optional<double> noise = noise_floor(channel.samples);
  if (!noise) return std::nullopt;
  ConverterLattice lattice{*channel.values->grid.mean_step, channel.values->sorted.front(), 0};
  lattice.noise = std::sqrt(std::max(0.0, *noise * *noise - lattice.step * lattice.step / 12));
  const double line_sd = *noise * std::sqrt(2 / static_cast<double>(channel.samples.size()));
  if (!(lattice.repeated_line() > line_sd)) return std::nullopt;
  return lattice;
}

MeanRounding::MeanRounding(const ConverterLattice& lattice, double sd) : lattice_(lattice) {
  for (int n = 1; n <= MeanRounding::terms; ++n)
    term_[static_cast<std::size_t>(n - 1)] = (n % 2 == 0 ? 1 : -1) * damped(n, sd / lattice.step) / n;
}

double MeanRounding::at(double x) const {
  const double turns = (x - lattice_.origin) / lattice_.step;
  const double phase = two_pi * (turns - std::round(turns));
  // sin(n phase) by its recurrence.
  const double twice = 2 * std::cos(phase);
  double before = 0, here = std::sin(phase), sum = 0;
  for (const double term : term_) {
    sum += term * here;
    const double after = twice * here - before;
    before = here;
    here = after;
  }
  return lattice_.step / std::numbers::pi * sum;
}

void take_out_rounding(std::span<double> samples, double rate_hz, const std::vector<double>& frequencies_hz,
                       const ConverterLattice& lattice, std::size_t block, const std::vector<std::size_t>& skip) {
  block = std::min(block, samples.size());
  if (block < 16) return;
  const std::size_t told = std::min(frequencies_hz.size(), block / 8 - 1);
  const MatrixXd motion = motion_columns(
      block, rate_hz, {frequencies_hz.begin(), frequencies_hz.begin() + static_cast<std::ptrdiff_t>(told)});
  VectorXd added = VectorXd::Zero(static_cast<Index>(samples.size()));
  for (std::size_t begin = 0; begin < samples.size(); begin += block) {
    // The last block overlaps the one before it.
    const std::size_t first = std::min(begin, samples.size() - block);
    const auto values = VectorXd::Map(samples.data() + first, static_cast<Index>(block));
    if (const std::optional<VectorXd> rounding = rounding_of(values, motion, lattice))
      added.segment(static_cast<Index>(begin), static_cast<Index>(std::min(block, samples.size() - begin))) =
          rounding->tail(static_cast<Index>(std::min(block, samples.size() - begin)));
  }
  for (const std::size_t i : skip) added(static_cast<Index>(i)) = 0;
  VectorXd::Map(samples.data(), added.size()) -= added;
}

}  // namespace secular
