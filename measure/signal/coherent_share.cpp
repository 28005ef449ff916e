#include "measure/signal/coherent_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "numerics/fourier_transform.hpp"
#include "numerics/splitmix64.hpp"

namespace secular {
namespace {

using Eigen::Index;

constexpr Index coherence_windows = 64, coherence_parts = 8, fewest_coherent_samples = 512;

// Where windows begin: anywhere, the same in every run.
std::vector<Index> window_begins(Index samples, Index window) {
  std::vector<Index> begins;
  for (std::uint64_t m = 0; m < coherence_windows; ++m) {
    const double part = static_cast<double>(splitmix64(m * splitmix64_step) >> 11) * 0x1p-53;
    begins.push_back(static_cast<Index>(part * static_cast<double>(samples - window)));
  }
  return begins;
}

// Lines x windows.
Eigen::MatrixXcd window_lines(const Eigen::Ref<const Eigen::VectorXd>& signal, const std::vector<Index>& begins,
                              Index window) {
  Eigen::VectorXd taper(window);
  for (Index i = 0; i < window; ++i)
    taper(i) =
        std::pow(std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(window)), 2);
  Eigen::MatrixXcd lines(window / 2 + 1, coherence_windows);
  for (std::size_t m = 0; m < begins.size(); ++m) {
    const Eigen::VectorXd samples = signal.segment(begins[m], window);
    lines.col(static_cast<Index>(m)) =
        half_spectrum((samples.array() - samples.mean()).matrix().cwiseProduct(taper));
  }
  return lines;
}

// Correlation of the same line of white noise in two Hann windows so many of their lengths apart.
double hann_correlation(double apart) {
  if (apart >= 1) return 0;
  const double turn = 2 * std::numbers::pi * apart;
  return (1 - apart) * (2 + std::cos(turn)) / 3 + std::sin(turn) / (2 * std::numbers::pi);
}

// The mean coherence of two signals that have nothing to do with each other.
double chance_coherence(const std::vector<Index>& begins, Index window) {
  double sum = 0;
  for (const Index a : begins)
    for (const Index b : begins)
      sum += std::pow(hann_correlation(static_cast<double>(std::abs(a - b)) / static_cast<double>(window)), 2);
  return sum / static_cast<double>(begins.size() * begins.size());
}

}  // namespace

std::optional<CoherentShare> coherent_share(const Eigen::Ref<const Eigen::VectorXd>& excitation,
                                            const Eigen::Ref<const Eigen::VectorXd>& response) {
  if (excitation.size() != response.size())
    throw std::invalid_argument("coherence of signals of different lengths");
  if (response.size() < fewest_coherent_samples) return std::nullopt;
  const Index window = response.size() / coherence_parts;
  const std::vector<Index> begins = window_begins(response.size(), window);
  const Eigen::MatrixXcd driving = window_lines(excitation, begins, window),
                         answer = window_lines(response, begins, window);
  if (!(driving.squaredNorm() > 0) || !(answer.squaredNorm() > 0)) return std::nullopt;
  const Eigen::VectorXd power = driving.rowwise().squaredNorm();
  const Eigen::VectorXcd cross = driving.conjugate().cwiseProduct(answer).rowwise().sum();
  double coherent = 0;
  for (Index k = 0; k < cross.size(); ++k)
    if (power(k) > 0) coherent += std::norm(cross(k)) / power(k);
  const double seen = coherent / answer.squaredNorm(), chance = chance_coherence(begins, window);
  return CoherentShare{std::clamp((seen - chance) / (1 - chance), 0.0, 1.0), window};
}

}  // namespace secular
