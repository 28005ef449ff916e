// Work and precision of the integrators that simulate/ offers, on the full equations of motion of two_mass_mode1
// with an exact solution: undamped cubic stiffness v'' + w^2 v + k v^3 = 0 from rest at A,
//   v = A cn(W t, m), W^2 = w^2 + k A^2, m^2 = k A^2/(2 W^2).
// A new integrator is one line in `integrators`. Table: --benchmark_filter=integrator_table; with
// SECULAR_FIGURES=FOLDER in the environment it is also drawn, as FOLDER/work_precision.svg.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "generated/registry.hpp"
#include "motion/simulate/motion.hpp"
#include "report/figure.hpp"
#include "report/whole_file.hpp"

namespace secular {
namespace {

struct Method {
  std::string name;
  Integrator method;
  std::vector<double> settings;  ///< relative tolerances, or steps of a fixed length in a sample interval
};

const std::vector<Method> integrators = {
    {"Dormand-Prince 5(4)", Integrator::dormand_prince, {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
    {"Bulirsch-Stoer", Integrator::bulirsch_stoer, {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
    {"Dormand-Prince 8(7)", Integrator::dormand_prince_87, {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
    {"Runge-Kutta 4", Integrator::runge_kutta_4, {2, 4, 8, 16, 64}},
};

/// Enough for a few that nothing else on the machine disturbed.
constexpr int turns = 25;

constexpr double frequency = 77.85, stiffness = 4e5, amplitude = 0.02, sample_rate = 256, duration_s = 10;

MotionSettings settings_of(const Method& method, double setting) {
  MotionSettings settings;
  settings.label = "bench";
  settings.method = method.method;
  if (method.method == Integrator::runge_kutta_4) {
    settings.fixed_step = 1 / (sample_rate * setting);
  } else {
    settings.relative_tolerance = setting;
    settings.absolute_tolerance = 1e-4 * setting;
  }
  return settings;
}

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
  MotionState state{{amplitude}, {0}};
  std::vector<double> seen;
  const std::clock_t begin = std::clock();
  integrate_motion({model, parameters.data(), still},
                   {0, 0, 1 / sample_rate, static_cast<std::size_t>(duration_s * sample_rate)}, settings, state,
                   [&](const MotionSample& sample) { seen.push_back(sample.displacement[0]); });
  Run run;
  run.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  run.samples = static_cast<long>(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    run.error = std::max(run.error, std::abs(seen[i] - exact(static_cast<double>(i) / sample_rate)) / amplitude);
  return run;
}

void integrator_speed(benchmark::State& state) {
  const Method& method = integrators[static_cast<std::size_t>(state.range(0))];
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const double setting = method.method == Integrator::runge_kutta_4 ? 16 : 1e-10;
  long samples = 0;
  for (auto _ : state) samples += integrate(model, settings_of(method, setting)).samples;
  state.SetLabel(method.name + ", samples of 256 Hz");
  state.SetItemsProcessed(samples);
}
BENCHMARK(integrator_speed)->DenseRange(0, static_cast<int>(integrators.size()) - 1)->Unit(benchmark::kMillisecond);

/// Printed once: what each setting costs and what it gives. Methods take turns, the shortest of `turns` runs
/// counts.
void integrator_table(benchmark::State& state) {
  for (auto _ : state) {
    std::printf(
        "\nUndamped cubic stiffness, %g s of %g Hz: largest error over the amplitude, from the exact solution\n",
        duration_s, frequency / (2 * 3.14159265358979));
    std::printf("%-20s %9s %9s %9s %12s %12s %14s %13s\n", "integrator", "setting", "error", "CPU ms",
                "evaluations", "evals/CPU s", "motion s/CPU s", "digits/CPU s");
    report::Figure figure;
    figure.x = {"Processor time for a second of motion", "ms", true, {}};
    report::Panel panel;
    panel.y = {"Largest error over the amplitude", "", true, {}};
    for (const Method& method : integrators) {
      report::Series line;
      line.name = method.name;
      line.style = report::SeriesStyle::line_and_points;
      line.group = static_cast<int>(panel.series.size());
      for (const double setting : method.settings) {
        const Counted counted;
        Run best = integrate(counted.model, settings_of(method, setting));
        const long evaluations = counted.calls;
        for (int turn = 1; turn < turns; ++turn)
          best.cpu_s = std::min(best.cpu_s, integrate(counted.model, settings_of(method, setting)).cpu_s);
        std::printf("%-20s %9g %9.1e %9.3f %12ld %12.3g %14.3g %13.3g\n", method.name.c_str(), setting, best.error,
                    1e3 * best.cpu_s, evaluations, static_cast<double>(evaluations) / best.cpu_s,
                    duration_s / best.cpu_s, -std::log10(best.error) / best.cpu_s);
        line.x.push_back(1e3 * best.cpu_s / duration_s);
        line.y.push_back(best.error);
      }
      panel.series.push_back(std::move(line));
    }
    figure.panels.push_back(std::move(panel));
    if (const char* const folder = std::getenv("SECULAR_FIGURES"))
      report::write_whole_file(std::filesystem::path(folder) / "work_precision.svg",
                               render_figure(figure, "work-precision", report::FigureUse::standalone).svg);
  }
}
BENCHMARK(integrator_table)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace secular
