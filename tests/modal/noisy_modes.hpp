#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/modal/pole.hpp"
#include "tests/modal/pole_of.hpp"
#include "tests/modal/structure_campaign.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular::testing_support {

enum class NoiseColour { white, low, band, drift };

/// Linear modes in noise, as free decays or as blows whose force is measured.
struct NoisyModes {
  RecordKind kind = RecordKind::free_decay;
  double rate_hz = 512;
  int samples = 2048, channels = 1, records = 1;
  NoiseColour colour = NoiseColour::white;
  double snr_db = 30;  ///< largest response over the rms of the noise
  std::vector<std::complex<double>> poles;
  std::vector<double> strengths;  ///< of the modes beside each other; as many as poles
  bool common_noise = false;      ///< half the noise of every channel is the same (a floor that shakes)
  double second_hit_s = 0;        ///< so long after the first, half as strong; zero: none
  double clipped_at = 0;          ///< of the largest response; zero: not clipped
};

/// Noise of standard deviation one: white, through one real pole (0.9), through a pair at 0.17 of the sample rate,
/// or a slow walk (0.995) under white noise.
inline Eigen::VectorXd noise_of(NoiseColour colour, Eigen::Index samples, Gaussian& gaussian) {
  constexpr Eigen::Index settle = 2000;
  const Eigen::VectorXd white = gaussian.vector(samples + settle);
  Eigen::VectorXd y = white;
  const double radius = 0.9, turn = 2 * radius * std::cos(2 * std::numbers::pi * 0.17);
  for (Eigen::Index i = 2; i < y.size() && colour != NoiseColour::white; ++i) {
    if (colour == NoiseColour::low) y(i) += 0.9 * y(i - 1);
    if (colour == NoiseColour::band) y(i) += turn * y(i - 1) - radius * radius * y(i - 2);
    if (colour == NoiseColour::drift) y(i) += 0.995 * y(i - 1);
  }
  if (colour == NoiseColour::drift) y += 3 * gaussian.vector(y.size());
  const Eigen::VectorXd kept = y.tail(samples);
  return kept / std::sqrt(kept.squaredNorm() / static_cast<double>(samples));
}

/// One record without noise: the force (zero of a free decay) and the responses.
inline std::pair<Eigen::VectorXd, Eigen::MatrixXd> clean_record(const NoisyModes& m, const Eigen::MatrixXd& shapes,
                                                                Gaussian& gaussian) {
  const bool struck = m.kind == RecordKind::impact;
  constexpr int fine = 8, before = 40;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.samples);
  Eigen::MatrixXd responses = Eigen::MatrixXd::Zero(m.samples, m.channels);
  double highest = 0;
  for (const std::complex<double> pole : m.poles) highest = std::max(highest, pole.imag());
  const double width = std::max(2 / m.rate_hz, 1 / highest), h = 1 / (fine * m.rate_hz);
  const double size = 1 + 0.1 * gaussian();
  const auto push = [&](double t) {  // half a sine
    const double later = t - m.second_hit_s;
    double f = t > 0 && t < width ? size * std::sin(std::numbers::pi * t / width) : 0.0;
    if (m.second_hit_s > 0 && later > 0 && later < width)
      f += 0.5 * size * std::sin(std::numbers::pi * later / width);
    return struck ? f : 0.0;
  };
  for (std::size_t r = 0; r < m.poles.size(); ++r) {
    const std::complex<double> pole = m.poles[r], step = std::exp(pole * h);
    std::complex<double> motion = struck ? 0.0 : m.strengths[r] * std::polar(size, 3 * gaussian());
    for (int i = 0; i < m.samples; ++i) {
      responses.row(i) += motion.imag() * shapes.row(static_cast<Eigen::Index>(r));
      for (int k = 0; k < fine; ++k) {
        const double t = (i - before) / m.rate_hz + (k + 0.5) * h;
        motion = motion * step + push(t) * std::abs(pole) * m.strengths[r] * h * std::exp(0.5 * pole * h);
      }
    }
  }
  for (int i = 0; i < m.samples; ++i) force(i) = 100 * push((i - before) / m.rate_hz);
  return {force, responses};
}

inline CampaignData noisy_campaign(const NoisyModes& m, std::uint64_t seed) {
  Gaussian gaussian(seed);
  const bool struck = m.kind == RecordKind::impact;
  CampaignData data;
  data.campaign.name = "modes in noise";
  data.campaign.sample_rate_hz = m.rate_hz;
  if (struck) data.campaign.channels.push_back({"hammer", ChannelRole::excitation, Quantity::force, "N"});
  for (int c = 0; c < m.channels; ++c)
    data.campaign.channels.push_back({"x" + std::to_string(c), ChannelRole::response, Quantity::displacement, "m"});
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(m.poles.size()), m.channels);
  for (double& value : shapes.reshaped()) value = gaussian() > 0 ? 0.5 : -1;
  for (double& value : shapes.reshaped()) value *= 1 + 0.2 * gaussian();
  for (int d = 0; d < m.records; ++d) {
    auto [force, responses] = clean_record(m, shapes, gaussian);
    const double level = std::pow(10, -m.snr_db / 20) * responses.cwiseAbs().maxCoeff();
    const Eigen::VectorXd floor = noise_of(m.colour, m.samples, gaussian);
    Record record;
    record.sample_rate_hz = m.rate_hz;
    if (struck) {
      force += 0.1 * gaussian.vector(m.samples);
      record.channels.emplace_back(force.begin(), force.end());
    }
    for (int c = 0; c < m.channels; ++c) {
      Eigen::VectorXd noise = noise_of(m.colour, m.samples, gaussian);
      if (m.common_noise) noise = std::sqrt(0.5) * (noise + floor);
      Eigen::VectorXd seen = responses.col(c) + level * noise;
      const double most = m.clipped_at * responses.cwiseAbs().maxCoeff();
      if (most > 0) seen = seen.cwiseMax(-most).cwiseMin(most).eval();
      record.channels.emplace_back(seen.begin(), seen.end());
    }
    RecordEntry entry;
    entry.kind = m.kind;
    entry.file = "records/" + std::to_string(d) + ".csv";
    data.campaign.records.push_back(entry);
    data.samples.push_back(std::move(record));
  }
  return data;
}

/// A test as somebody may make it, drawn at random: rate, length, channels, records, noise, and `modes` modes of
/// 0.1 to 5 % damping that swing twenty times or more in a record and keep below a third of the sample rate. The
/// two lowest of several modes lie one to four sums of their half bandwidths apart in two of five draws, the others
/// half an octave or more.
inline NoisyModes random_modes(RecordKind kind, int modes, std::uint64_t seed) {
  std::mt19937_64 random(seed * 7919 + 17);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const auto pick = [&](auto... values) {
    const double choices[] = {static_cast<double>(values)...};
    return choices[random() % sizeof...(values)];
  };
  NoisyModes m;
  m.kind = kind;
  m.rate_hz = pick(256, 1024, 4096);
  m.samples = static_cast<int>(pick(1024, 2048, 4096, 8192));
  m.channels = static_cast<int>(pick(1, 2, 3));
  m.records = static_cast<int>(pick(1, 2, 3));
  m.colour = static_cast<NoiseColour>(random() % 4);
  m.common_noise = random() % 2 == 0;
  m.snr_db = uniform(10, 60);
  const double lowest = 20 * m.rate_hz / m.samples, highest = 0.3 * m.rate_hz;
  const bool close = modes > 1 && uniform(0, 1) < 0.4;
  const int apart = close ? modes - 1 : modes;
  double hz = std::exp(uniform(std::log(lowest), std::log(highest / std::pow(1.4142, apart - 1))));
  for (int r = 0; r < modes; ++r) {
    const double damping = std::exp(uniform(std::log(0.001), std::log(0.05)));
    if (r > 0 && close && r == 1)
      hz *= 1 + uniform(1, 4) * (damping + damping_ratio(m.poles.back()));
    else if (r > 0)
      hz *= uniform(1.4142, std::max(1.42, std::pow(highest / hz, 1.0 / (modes - r))));
    m.poles.push_back(pole_of(2 * std::numbers::pi * std::min(hz, 1.2 * highest), damping));
    m.strengths.push_back(std::pow(10, -uniform(0, 1)));
  }
  return m;
}

}  // namespace secular::testing_support
