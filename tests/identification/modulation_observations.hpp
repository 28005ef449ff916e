#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/simulate/noise.hpp"

// Observations made from the modulation equations themselves, so that what is wrong with a model is known exactly.
namespace secular::testing_support {

inline constexpr double w0 = 77.84866595595507;

// Principal parametric dwells of the two-mass structure's first mode.
struct OneMode {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance = case_named(model, "principal_parametric");
  int conditions = 16, ensembles = 8;
  double mu1 = 0.222, mu2 = 0, mu3 = 36.87, alpha_e = -10.62e6, eta_e = 1.922;
  double amplitude_sd = 3e-6, growth_sd = 2e-4, growth_spread = 0, forcing_sd = 0.003, peak_spread = 1.6e-3;

  // dB/dt = (i w0 - mu1 - (4/(3 pi)) mu2 w0 2|B| - (3/2) mu3 w0^2 |B|^2 - i (4 alpha_e/w0)|B|^2) B + ..., by the
  // engine's own columns; the excitation's frequency is where the balance of frequency holds.
  Observation exact(int condition, double peak, double force, double phase, double instant) const {
    const RegressorBlock& block = *std::find_if(resonance.blocks.begin(), resonance.blocks.end(),
                                                [](const auto& b) { return b.kind == BlockKind::modulation; });
    Observation o;
    o.condition = condition;
    o.record = static_cast<std::size_t>(condition);
    o.forcing = {std::polar(force, 2 * instant)};
    o.amplitude = {std::polar(0.5 * peak, phase + instant)};
    double frequency = 2 * w0;
    for (int pass = 0; pass < 3; ++pass) {
      std::vector<std::complex<double>> values(block.lumps.size());
      std::vector<std::complex<double>*> columns;
      for (std::complex<double>& v : values) columns.push_back(&v);
      const std::complex<double>* amplitude = o.amplitude.data();
      const std::complex<double>* forcing = o.forcing.data();
      const double* excitation = &frequency;
      block.columns({1, &w0_, &excitation, &amplitude, &forcing}, columns.data());
      std::complex<double> rate = std::complex<double>(0, w0) * o.amplitude[0];
      for (std::size_t j = 0; j < values.size(); ++j) {
        const std::string_view name = resonance.lumps[static_cast<std::size_t>(block.lumps[j])].name;
        const double lump = name == "mu1"       ? mu1
                            : name == "mu2"     ? mu2
                            : name == "mu3"     ? mu3
                            : name == "alpha_e" ? alpha_e
                            : name == "eta_e"   ? eta_e
                                                : 0;
        rate += lump * values[j];
      }
      o.rate = {rate / o.amplitude[0]};
      frequency = 2 * o.rate[0].imag();
    }
    o.excitation_frequency = {frequency};
    o.excitation_frequency_sd = {1e-7};
    o.forcing_sd = {forcing_sd};
    o.amplitude_sd = {amplitude_sd};
    o.growth_sd = {growth_sd * (1 + growth_spread * condition / (conditions - 1))};
    o.frequency_sd = {0};
    o.harmonic.assign(resonance.blocks.size(), std::complex<double>());
    o.harmonic_sd.assign(resonance.blocks.size(), -1.0);
    return o;
  }

  ObservationSet set(std::uint64_t seed, bool turned = true) const {
    ObservationSet result;
    result.model = &model;
    result.resonance = &resonance;
    for (int c = 0; c < conditions; ++c)
      for (int e = 0; e < ensembles; ++e) {
        const double share = static_cast<double>(c) / (conditions - 1);
        const double instant = turned ? 2.3 * e + 0.7 * c : 0;
        Observation o = exact(c, 0.8e-3 + peak_spread * share, 15 + 10 * std::fmod(5 * share, 1.0),
                              0.4 + std::fmod(3 * share, 1.0), instant);
        o.centre_s = e;
        NoiseStream noise(seed, static_cast<std::uint64_t>(c), static_cast<std::uint64_t>(e));
        const std::complex<double> turn = std::polar(1.0, instant);
        o.amplitude[0] += amplitude_sd * std::complex<double>(noise.gaussian(), noise.gaussian()) * turn;
        o.forcing[0] += forcing_sd * std::complex<double>(noise.gaussian(), noise.gaussian()) * turn * turn;
        o.rate[0] += o.growth_sd[0] * noise.gaussian();
        result.observations.push_back(std::move(o));
      }
    return result;
  }

 private:
  double w0_ = w0;
};

}  // namespace secular::testing_support
