// Signals: cost of a decomposition beside that of a transform of the same data, and the table of variance over
// Cramer-Rao bound. Run with --benchmark_filter='signal_'.

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "bench/rival_methods.hpp"
#include "measure/signal/decomposition.hpp"
#include "measure/signal/exponential_fit.hpp"
#include "numerics/hertz.hpp"
#include "tests/signal/cramer_rao_bound.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rate = 256;

// Four accelerometers in a combination resonance: modal tones, their sum and a harmonic; `tones` of up to 8.
std::vector<Pole> tones_of(int tones) {
  const double hertz[] = {12.5, 33.1, 45.6, 58.1, 66.2, 78.7, 91.2, 103.7};
  std::vector<Pole> poles;
  for (int i = 0; i < tones; ++i) poles.push_back({PoleFamily::circular, two_pi * hertz[i], 0, false});
  return poles;
}

MatrixXd amplitudes_of(int tones, Index channels) {
  MatrixXd amplitudes(2 * tones, channels);
  for (Index i = 0; i < amplitudes.rows(); ++i)
    for (Index c = 0; c < channels; ++c)
      amplitudes(i, c) = std::cos(1.3 * static_cast<double>(i * i + 1) + 2.1 * static_cast<double>(c + 1)) + 0.1;
  return amplitudes;
}

MatrixXd record_of(int tones, Index samples, Index channels, double noise, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd y = pole_functions(tones_of(tones), samples, rate, 0) * amplitudes_of(tones, channels);
  for (Index c = 0; c < channels; ++c)
    for (Index i = 0; i < samples; ++i) y(i, c) += noise * normal(random);
  return y;
}

/// One ensemble of 4 channels: arguments samples, tones (order m = 2 tones), refinement.
void signal_decompose(benchmark::State& state) {
  const Index samples = state.range(0);
  const int tones = static_cast<int>(state.range(1));
  const MatrixXd y = record_of(tones, samples, 4, 0.01, 1);
  DecompositionOptions options;
  options.order = tones;
  options.refine = state.range(2) != 0;
  int iterations = 0;
  for (auto _ : state) {
    const Decomposition fit = decompose(y, rate, options);
    iterations = fit.iterations;
    benchmark::DoNotOptimize(fit.amplitudes.data());
  }
  state.counters["steps"] = iterations;
  state.SetComplexityN(samples);
}
BENCHMARK(signal_decompose)
    ->ArgNames({"samples", "tones", "refine"})
    ->Args({1024, 4, 0})
    ->Args({1024, 4, 1})
    ->Args({1024, 8, 1})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(signal_decompose)
    ->ArgNames({"samples", "tones", "refine"})
    ->ArgsProduct({{512, 1024, 2048, 4096, 8192, 16384}, {4}, {1}})
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMicrosecond);

/// The transform of the same 4 channels.
void signal_transform(benchmark::State& state) {
  const MatrixXd y = record_of(4, state.range(0), 4, 0.01, 1);
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXcd spectrum;
  VectorXd column;
  for (auto _ : state) {
    for (Index c = 0; c < y.cols(); ++c) {
      column = y.col(c);
      transform.fwd(spectrum, column);
      benchmark::DoNotOptimize(spectrum.data());
    }
  }
}
BENCHMARK(signal_transform)->Arg(1024)->Arg(16384)->Unit(benchmark::kMicrosecond);

/// Time of a refined decomposition over that of the transform of the same 1024 x 4 samples, as a counter.
void signal_ratio_to_transform(benchmark::State& state) {
  const int tones = static_cast<int>(state.range(0));
  const MatrixXd y = record_of(tones, 1024, 4, 0.01, 1);
  DecompositionOptions options;
  options.order = tones;
  options.refine = true;
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXcd spectrum;
  using Clock = std::chrono::steady_clock;
  double decomposing = 0, transforming = 0;
  for (auto _ : state) {
    const auto begin = Clock::now();
    const Decomposition fit = decompose(y, rate, options);
    benchmark::DoNotOptimize(fit.amplitudes.data());
    const auto middle = Clock::now();
    for (Index c = 0; c < y.cols(); ++c) {
      const VectorXd column = y.col(c);
      transform.fwd(spectrum, column);
      benchmark::DoNotOptimize(spectrum.data());
    }
    decomposing += std::chrono::duration<double>(middle - begin).count();
    transforming += std::chrono::duration<double>(Clock::now() - middle).count();
  }
  state.counters["ratio"] = decomposing / transforming;
}
BENCHMARK(signal_ratio_to_transform)->ArgName("tones")->Arg(4)->Arg(8)->Unit(benchmark::kMicrosecond);

/// Mean squared error of the frequency of one tone between bins over its bound, 256 samples: printed once.
void signal_efficiency(benchmark::State& state) {
  const Index samples = 256;
  constexpr int draws = 2000;
  const double frequency = two_pi * 40.37, centre = 0.5 * static_cast<double>(samples - 1) / rate;
  const std::vector<Pole> pole = {{PoleFamily::circular, frequency, 0, false}};
  const Eigen::Vector2d amplitude(0.6, 0.8);
  const VectorXd clean = pole_functions(pole, samples, rate, -centre) * amplitude;
  for (auto _ : state) {
    std::printf("\nMean squared error of the frequency over the Cramer-Rao bound, %d draws of %d samples\n", draws,
                static_cast<int>(samples));
    std::printf("%6s %10s %10s %10s %10s %12s %10s %10s\n", "S/N dB", "refined", "4.3.1", "4.3.2", "4.3.3",
                "exponential", "Pisarenko", "DFT peak");
    for (const double db : {0.0, 10.0, 20.0, 40.0, 60.0}) {
      std::mt19937_64 random(7);
      std::normal_distribution<double> normal;
      const double noise = std::sqrt(0.5) * std::pow(10, -db / 20);
      const double bound =
          testing_support::cramer_rao_bound(pole, amplitude, VectorXd::Constant(1, noise), samples, rate)(0, 0);
      double error[7] = {};
      for (int d = 0; d < draws; ++d) {
        VectorXd y = clean;
        for (double& value : y) value += noise * normal(random);
        double estimate[7] = {};
        DecompositionOptions options;
        const PolynomialMethod methods[] = {PolynomialMethod::least_squares, PolynomialMethod::noise_eigenvector,
                                            PolynomialMethod::lagged_covariance};
        for (int m = 0; m < 3; ++m) {
          options.method = methods[m];
          estimate[m + 1] = decompose(y, rate, options).poles[0].frequency;
        }
        options.method = PolynomialMethod::noise_eigenvector;
        options.refine = true;
        estimate[0] = decompose(y, rate, options).poles[0].frequency;
        estimate[4] = complex_exponential_frequency(y, rate);
        estimate[5] = pisarenko_frequency(y, rate);
        estimate[6] = spectrum_peak(y, rate, frequency).frequency;
        for (int k = 0; k < 7; ++k) error[k] += std::pow(estimate[k] - frequency, 2) / draws;
      }
      std::printf("%6.0f %10.3f %10.3g %10.3g %10.3g %12.3g %10.3g %10.3g\n", db, error[0] / bound,
                  error[1] / bound, error[2] / bound, error[3] / bound, error[4] / bound, error[5] / bound,
                  error[6] / bound);
    }
  }
}
BENCHMARK(signal_efficiency)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace secular
