#include "blind/disturbances.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace secular::blind {
namespace {

constexpr std::size_t most_kinds_at_once = 3;

// Decay of coloured noise from one sample to the next.
double kept_per_sample(double correlation_s) {
  return std::exp(-1 / (correlation_s * sample_rate_hz));
}

std::vector<double> times(double factor, const std::vector<double>& sizes, bool excitation_too = true) {
  std::vector<double> result(sizes.size());
  for (std::size_t c = excitation_too ? 0 : 1; c < sizes.size(); ++c) result[c] = factor * sizes[c];
  return result;
}

void add_hum(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  const double phase = random.uniform(0, two_pi);
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (std::size_t i = 0; i < channels[c].size(); ++i) {
      const double turn = two_pi * d.hum_hz * static_cast<double>(i) / sample_rate_hz + phase;
      channels[c][i] += d.hum[c] * (std::cos(turn) + std::cos(3 * turn) / 3);
    }
}

// x_i = kept x_(i-1) + sqrt(1 - kept^2) e_i has unit variance and the correlation kept^|i-j|.
void add_coloured_noise(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  const double kept = kept_per_sample(d.correlation_s), fresh = std::sqrt(1 - kept * kept);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    double x = random.gaussian();
    for (double& sample : channels[c]) {
      sample += d.coloured[c] * x;
      x = kept * x + fresh * random.gaussian();
    }
  }
}

void add_ringing(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  const double phase = random.uniform(0, two_pi);
  for (std::size_t c = 1; c < channels.size(); ++c)
    for (std::size_t i = 0; i < channels[c].size(); ++i) {
      const double t = static_cast<double>(i) / sample_rate_hz;
      channels[c][i] += d.ringing[c] * std::exp(-d.ringing_rate * t) * std::cos(two_pi * d.ringing_hz * t + phase);
    }
}

void add_spikes(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  for (std::size_t n = 0; n < d.spikes_per_record; ++n) {
    const std::size_t c = 1 + random.below(channels.size() - 1);
    channels[c][random.below(channels[c].size())] += random.sign() * d.spike[c];
  }
}

void add_wander(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  for (std::size_t c = 1; c < channels.size(); ++c) {
    const double step = d.wander[c] / std::sqrt(static_cast<double>(channels[c].size()));
    double offset = 0;
    for (double& sample : channels[c]) sample += offset += step * random.gaussian();
  }
}

bool has(const Disturbances& d, const char* kind) {
  return std::find(d.kinds.begin(), d.kinds.end(), kind) != d.kinds.end();
}

}  // namespace

// Spectral density of the noise above over that of white noise of the same variance.
double Disturbances::coloured_as_white(std::size_t channel, double hz) const {
  if (coloured.empty()) return 0;
  const double kept = kept_per_sample(correlation_s);
  return coloured[channel] * std::sqrt(1 - kept * kept) /
         std::abs(1.0 - kept * std::polar(1.0, two_pi * hz / sample_rate_hz));
}

const std::vector<std::string>& disturbance_kinds() {
  static const std::vector<std::string> kinds = {
      "foreign_tone", "converter_step", "coloured_noise", "neighbour_mode", "spikes",
      "lost_samples", "held_samples",   "late_record",    "record_scatter", "offset_wander"};
  return kinds;
}

Disturbances draw_disturbances(const DisturbedCampaign& campaign, Random& random) {
  const std::vector<double>&rms = campaign.rms, &peak = campaign.peak;
  std::vector<std::string> lot = disturbance_kinds();
  random.shuffle(lot);
  lot.resize(1 + random.below(most_kinds_at_once));
  Disturbances d;
  for (const std::string& kind : disturbance_kinds())
    if (std::find(lot.begin(), lot.end(), kind) != lot.end()) d.kinds.push_back(kind);
  if (has(d, "foreign_tone")) {
    d.hum = times(random.log_uniform(0.002, 0.05), rms);
    d.hum_hz = 50 + random.uniform(-0.05, 0.05);
  }
  // A converter of 8 to 14 bits whose range is three times the largest signal.
  if (has(d, "converter_step")) d.step = times(6 / std::pow(2, 8 + static_cast<double>(random.below(7))), peak);
  if (has(d, "coloured_noise")) {
    d.coloured = times(random.log_uniform(0.003, 0.03), rms);
    d.correlation_s = random.log_uniform(0.01, 0.3);
  }
  if (has(d, "neighbour_mode")) {
    d.ringing = times(random.log_uniform(0.01, 0.1), rms, false);
    d.ringing_hz = campaign.highest_natural_hz * random.uniform(1.5, 3.4);
    d.ringing_rate = two_pi * d.ringing_hz * random.log_uniform(0.002, 0.02);
  }
  if (has(d, "spikes")) {
    d.spike = times(random.uniform(0.3, 3), peak, false);
    d.spikes_per_record = 1 + random.below(4);
  }
  if (has(d, "lost_samples")) d.lost_per_record = 1 + random.below(5);
  if (has(d, "held_samples")) d.held_share = random.log_uniform(0.001, 0.02);
  if (has(d, "late_record")) d.latest_s = random.uniform(0, 0.02);
  if (has(d, "record_scatter")) d.frequency_scatter = random.uniform(0, 0.005);
  if (has(d, "offset_wander")) d.wander = times(random.log_uniform(0.01, 0.3), rms, false);
  if (d.latest_s == 0 && d.frequency_scatter == 0) return d;
  for (std::size_t i = 0; i < campaign.records; ++i)
    d.records.push_back({1 + d.frequency_scatter * random.gaussian(), d.latest_s * random.uniform(0, 1)});
  return d;
}

void disturb_samples(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  if (!d.ringing.empty()) add_ringing(d, random, channels);
  if (!d.wander.empty()) add_wander(d, random, channels);
  if (!d.hum.empty()) add_hum(d, random, channels);
  if (!d.coloured.empty()) add_coloured_noise(d, random, channels);
  if (d.spikes_per_record > 0) add_spikes(d, random, channels);
}

void convert_samples(const Disturbances& d, Random& random, std::vector<std::vector<double>>& channels) {
  if (!d.step.empty())
    for (std::size_t c = 0; c < channels.size(); ++c)
      for (double& x : channels[c]) x = d.step[c] * std::round(x / d.step[c]);
  if (d.held_share > 0)
    for (std::vector<double>& channel : channels)
      for (std::size_t i = 1; i < channel.size(); ++i)
        if (random.chance(d.held_share)) channel[i] = channel[i - 1];
}

std::vector<std::size_t> lost_rows(const Disturbances& d, std::size_t samples, Random& random) {
  std::vector<std::size_t> rows;
  for (std::size_t n = 0; n < d.lost_per_record; ++n) rows.push_back(1 + random.below(samples - 2));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace secular::blind
