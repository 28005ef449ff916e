// Work and precision of the integrators that simulate/ offers, on the full equations of motion of two_mass_mode1
// with an exact solution: undamped cubic stiffness v'' + w^2 v + k v^3 = 0 from rest at A,
//   v = A cn(W t, m), W^2 = w^2 + k A^2, m^2 = k A^2/(2 W^2).
// A new integrator is one line in `integrators`. Table: --benchmark_filter=integrator_table

#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "generated/registry.hpp"
#include "simulate/motion.hpp"

namespace secular {
namespace {

struct Integrator {
  std::string name;
  MotionSettings (*settings)(double tolerance);
};

const std::vector<Integrator> integrators = {
    {"Dormand-Prince 5(4)",
     [](double tolerance) {
       return MotionSettings{tolerance, 1e-4 * tolerance, 0, "bench"};
     }},
};

constexpr double frequency = 77.85, stiffness = 4e5, amplitude = 0.02, sample_rate = 256, duration_s = 10;

double exact(double time) {
  const double rate = std::sqrt(frequency * frequency + stiffness * amplitude * amplitude);
  return amplitude * boost::math::jacobi_cn(std::sqrt(stiffness / 2) * amplitude / rate, rate * time);
}

// The model with a count of how often its accelerations are asked for.
struct Counted {
  CompiledModel model = *generated::find_compiled_model("two_mass_mode1");
  mutable long calls = 0;
  Counted() {
    model.acceleration = {[](const void* self, const double* parameters, const ExcitationSample* excitation,
                             const double* displacement, const double* velocity, double* result) {
                            ++static_cast<const Counted*>(self)->calls;
                            generated::find_compiled_model("two_mass_mode1")
                                ->acceleration(parameters, excitation, displacement, velocity, result);
                          },
                          this};
  }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
};

struct Run {
  double cpu_s = 0, error = 0;
  long samples = 0;
};

Run integrate(const CompiledModel& model, const MotionSettings& settings) {
  std::vector<double> parameters(model.symbols.size(), 0.0);
  for (std::size_t p = 0; p < model.symbols.size(); ++p) {
    if (model.symbols[p].name == "omega0") parameters[p] = frequency;
    if (model.symbols[p].name == "alpha3") parameters[p] = stiffness;
  }
  const auto still = [](double, ExcitationSample* samples) { samples[0] = {}; };
  std::vector<double> displacement = {amplitude}, velocity = {0}, seen;
  const std::clock_t begin = std::clock();
  integrate_motion(model, parameters.data(), still, 0, displacement, velocity, 0, 1 / sample_rate,
                   static_cast<std::size_t>(duration_s * sample_rate), settings,
                   [&](const MotionSample& sample) { seen.push_back(sample.displacement[0]); });
  Run run;
  run.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  run.samples = static_cast<long>(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    run.error = std::max(run.error, std::abs(seen[i] - exact(static_cast<double>(i) / sample_rate)) / amplitude);
  return run;
}

void integrator_speed(benchmark::State& state) {
  const Integrator& integrator = integrators[static_cast<std::size_t>(state.range(0))];
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  long samples = 0;
  for (auto _ : state) samples += integrate(model, integrator.settings(1e-10)).samples;
  state.SetLabel(integrator.name + ", samples of 256 Hz");
  state.SetItemsProcessed(samples);
}
BENCHMARK(integrator_speed)->DenseRange(0, static_cast<int>(integrators.size()) - 1)->Unit(benchmark::kMillisecond);

/// Printed once: what each tolerance costs and what it gives.
void integrator_table(benchmark::State& state) {
  for (auto _ : state) {
    std::printf(
        "\nUndamped cubic stiffness, %g s of %g Hz: largest error over the amplitude, from the exact solution\n",
        duration_s, frequency / (2 * 3.14159265358979));
    std::printf("%-22s %10s %10s %12s %12s %14s %14s %14s\n", "integrator", "tolerance", "error", "CPU ms",
                "evaluations", "evals/CPU s", "motion s/CPU s", "digits/CPU s");
    for (const Integrator& integrator : integrators)
      for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        const Counted counted;
        Run best = integrate(counted.model, integrator.settings(tolerance));
        const long evaluations = counted.calls;
        for (int turn = 0; turn < 4; ++turn)
          best.cpu_s = std::min(best.cpu_s, integrate(counted.model, integrator.settings(tolerance)).cpu_s);
        std::printf("%-22s %10.0e %10.1e %12.3f %12ld %14.3g %14.3g %14.3g\n", integrator.name.c_str(), tolerance,
                    best.error, 1e3 * best.cpu_s, evaluations, static_cast<double>(evaluations) / best.cpu_s,
                    duration_s / best.cpu_s, -std::log10(best.error) / best.cpu_s);
      }
  }
}
BENCHMARK(integrator_table)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace secular
