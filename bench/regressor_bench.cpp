// Generated batch regressors beside a hand-written Eigen version of the same columns, the interpreted expression
// and the memory bandwidth of the same moment: rows of the principal parametric resonance, thesis Eq. (5.16). Five
// columns from two inputs: 2 complex numbers read and 5 written per observation. All ratios:
// --benchmark_filter=regressor_table

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <numbers>
#include <vector>

#include "codegen/runtime/interpreted_model.hpp"
#include "estimator/model/compiled_model.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t inputs = 2, outputs = 5;

const CompiledModel& interpreted() {
  static const auto model = interpreted_model(
      canonical_model(read_model(std::filesystem::path(SECULAR_SOURCE_DIR) / "models" / "two_mass_mode1.toml")));
  return *model;
}

const RegressorBlock& block_of(const CompiledModel& model) {
  for (const CompiledCase& resonance : model.cases)
    if (resonance.name == "principal_parametric") return resonance.blocks[0];
  std::abort();
}

class Observations {
 public:
  explicit Observations(std::size_t count) : amplitude_(count), forcing_(count), frequencies_(count, 155.0) {
    for (std::size_t i = 0; i < count; ++i) {
      amplitude_[i] = std::polar(1e-3 * (1 + std::sin(0.1 * static_cast<double>(i))), 0.7 * static_cast<double>(i));
      forcing_[i] = std::polar(22.5, 0.3 * static_cast<double>(i));
    }
    for (std::size_t j = 0; j < outputs; ++j) {
      values_.emplace_back(count);
      columns_.push_back(values_.back().data());
    }
  }

  void rows(const RegressorBlock& block) const { block.columns(batch_, columns_.data()); }

  // What a user of Eigen writes.
  void by_hand() const {
    using Column = Eigen::Map<Eigen::ArrayXcd>;
    using Values = Eigen::Map<const Eigen::ArrayXcd>;
    const auto n = static_cast<Eigen::Index>(amplitude_.size());
    const Values a(amplitude_.data(), n), f(forcing_.data(), n);
    const double w = frequency_;
    const Complex i(0, 1);
    Column(columns_[0], n) = -a;
    Column(columns_[1], n) = -8 * w / (3 * std::numbers::pi) * a.abs() * a;
    Column(columns_[2], n) = -1.5 * w * w * a.abs2() * a;
    Column(columns_[3], n) = i * (4 / w) * a.abs2() * a;
    Column(columns_[4], n) = i * (-1 / w) * a.conjugate() * f;
  }

  // The same numbers read and written, nothing computed.
  void stream() const {
    const double* __restrict a = reinterpret_cast<const double*>(amplitude_.data());
    const double* __restrict f = reinterpret_cast<const double*>(forcing_.data());
    double* __restrict c[outputs];
    for (std::size_t j = 0; j < outputs; ++j) c[j] = reinterpret_cast<double*>(columns_[j]);
    double* __restrict c0 = c[0], * __restrict c1 = c[1], * __restrict c2 = c[2], * __restrict c3 = c[3], * __restrict c4 = c[4];
    for (std::size_t n = 0; n < 2 * amplitude_.size(); ++n) {
      c0[n] = a[n];
      c1[n] = f[n];
      c2[n] = a[n];
      c3[n] = f[n];
      c4[n] = a[n];
    }
  }

  double bytes() const { return static_cast<double>((inputs + outputs) * sizeof(Complex) * amplitude_.size()); }
  Complex value(std::size_t column, std::size_t i) const { return columns_[column][i]; }
  std::size_t count() const { return amplitude_.size(); }

 private:
  double frequency_ = 77.85;
  std::vector<Complex> amplitude_, forcing_;
  std::vector<double> frequencies_;
  std::vector<std::vector<Complex>> values_;
  std::vector<Complex*> columns_;
  const double* frequency_list_[1] = {frequencies_.data()};
  const Complex *amplitude_list_[1] = {amplitude_.data()}, *forcing_list_[1] = {forcing_.data()};
  ObservationBatch batch_{amplitude_.size(), &frequency_, frequency_list_, amplitude_list_, forcing_list_};
};

void measure(benchmark::State& state, const std::function<void(const Observations&)>& work) {
  const Observations data(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    work(data);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(data.bytes()) * static_cast<std::int64_t>(state.iterations()));
}

const RegressorBlock& generated_block() {
  return block_of(*generated::find_compiled_model("two_mass_mode1"));
}

void regressor_generated(benchmark::State& state) {
  measure(state, [](const Observations& data) { data.rows(generated_block()); });
}
void regressor_eigen(benchmark::State& state) {
  measure(state, [](const Observations& data) { data.by_hand(); });
}
void regressor_interpreted(benchmark::State& state) {
  measure(state, [](const Observations& data) { data.rows(block_of(interpreted())); });
}
void regressor_memory(benchmark::State& state) {
  measure(state, [](const Observations& data) { data.stream(); });
}
BENCHMARK(regressor_generated)->Arg(1 << 10)->Arg(1 << 20)->Unit(benchmark::kMicrosecond);
BENCHMARK(regressor_eigen)->Arg(1 << 10)->Arg(1 << 20)->Unit(benchmark::kMicrosecond);
BENCHMARK(regressor_interpreted)->Arg(1 << 10)->Unit(benchmark::kMicrosecond);
BENCHMARK(regressor_memory)->Arg(1 << 10)->Arg(1 << 20)->Unit(benchmark::kMicrosecond);

// Best of several turns in seconds of processor time; the candidates take turns, so that a busy machine disturbs
// all alike.
std::vector<double> best_times(const std::vector<std::function<void()>>& work, int turns, int calls) {
  std::vector<double> best(work.size(), INFINITY);
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t w = 0; w < work.size(); ++w) {
      const std::clock_t begin = std::clock();
      for (int call = 0; call < calls; ++call) {
        work[w]();
        benchmark::ClobberMemory();
      }
      const double elapsed = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      best[w] = std::min(best[w], elapsed / calls);
    }
  return best;
}

/// Printed once: GB/s of each and the ratios that issue from them, where data stream and where they stay in the
/// cache.
void regressor_table(benchmark::State& state) {
  for (auto _ : state) {
    std::printf("\nRows of the principal parametric resonance: 112 bytes an observation\n");
    std::printf("%14s %10s %10s %12s %10s | %14s %14s %16s\n", "observations", "generated", "Eigen", "interpreted",
                "memory", "gen./Eigen", "gen./memory", "gen./interpreted");
    for (const std::size_t count : {std::size_t{1} << 10, std::size_t{1} << 20}) {
      const Observations data(count), other(count);
      data.rows(generated_block());
      other.by_hand();
      for (std::size_t j = 0; j < outputs; ++j)
        for (std::size_t i = 0; i < 100; ++i)
          if (std::abs(data.value(j, i) - other.value(j, i)) > 1e-14 * std::abs(other.value(j, i))) {
            state.SkipWithError("the hand-written columns are others");
            return;
          }
      const bool small = count < 10000;
      const std::vector<double> best =
          best_times({[&] { data.rows(generated_block()); }, [&] { data.by_hand(); }, [&] { data.stream(); }},
                     small ? 200 : 9, small ? 20 : 1);
      const double slow = best_times({[&] { data.rows(block_of(interpreted())); }}, small ? 5 : 1, 1)[0];
      const double gigabytes = 1e-9 * data.bytes();
      std::printf("%14zu %10.2f %10.2f %12.3f %10.2f | %14.2f %14.2f %16.0f\n", count, gigabytes / best[0],
                  gigabytes / best[1], gigabytes / slow, gigabytes / best[2], best[1] / best[0], best[2] / best[0],
                  slow / best[0]);
    }
    std::printf("speeds in GB/s; ratios of speeds, above 1: generated code is faster\n");
  }
}
BENCHMARK(regressor_table)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace secular
