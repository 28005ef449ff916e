#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "codegen/cpp/emit_cpp.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"

namespace secular {
namespace {

const std::filesystem::path models = std::filesystem::path(SECULAR_SOURCE_DIR) / "models";

const Model& two_mass() {
  static const Model model = read_model(models / "two_mass_mode1.toml");
  return model;
}

/// Second-order expansion of thesis Eq. (5.1) near the principal parametric resonance.
void derive_principal_parametric(benchmark::State& state) {
  const ResonanceCase& resonance = two_mass().find_case("principal_parametric");
  for (auto _ : state) benchmark::DoNotOptimize(derive(two_mass(), resonance));
}
BENCHMARK(derive_principal_parametric)->Unit(benchmark::kMillisecond);

/// Its certificate by substitution into the original equation.
void certify_principal_parametric(benchmark::State& state) {
  const Derivation derivation = derive(two_mass(), two_mass().find_case("principal_parametric"));
  for (auto _ : state) benchmark::DoNotOptimize(certify(derivation));
}
BENCHMARK(certify_principal_parametric)->Unit(benchmark::kMillisecond);

/// Duffing oscillator, `order` of expansion from 1 to 4.
void derive_duffing(benchmark::State& state) {
  Model model = read_model_text(
      "schema = 1\nname = \"duffing\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
      "equation = \"D2(x) + w^2*x = -g*x^3\"\n[[case]]\nname = \"free\"\norder = { g = 1 }\nexcitation = false\n",
      "duffing");
  model.cases[0].expand_to = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(derive(model, model.cases[0]));
}
BENCHMARK(derive_duffing)->DenseRange(1, 4)->Unit(benchmark::kMillisecond);

/// Model text to C++ text, three cases with certificates.
void generate_two_mass(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(emit_cpp(canonical_model(two_mass())));
}
BENCHMARK(generate_two_mass)->Unit(benchmark::kMillisecond);

const Model& two_modes() {
  static const Model model = read_model(models / "two_mass.toml");
  return model;
}

/// Thesis chapter 6 to second order (aim: below 50 ms), and with its certificate (below 100 ms).
void derive_additive_combination(benchmark::State& state) {
  const ResonanceCase& resonance = two_modes().find_case("additive_combination");
  for (auto _ : state) benchmark::DoNotOptimize(derive(two_modes(), resonance));
}
BENCHMARK(derive_additive_combination)->Unit(benchmark::kMillisecond);

void derive_and_certify_additive_combination(benchmark::State& state) {
  const ResonanceCase& resonance = two_modes().find_case("additive_combination");
  for (auto _ : state) benchmark::DoNotOptimize(certify(derive(two_modes(), resonance)));
}
BENCHMARK(derive_and_certify_additive_combination)->Unit(benchmark::kMillisecond);

/// Every cubic term in every equation.
Model dense_cubic(std::int64_t modes, std::int64_t order) {
  std::string text = "schema = 1\nname = \"dense\"\n", orders;
  for (std::int64_t k = 1; k <= modes; ++k) {
    std::string right;
    for (std::int64_t a = 1; a <= modes; ++a)
      for (std::int64_t b = a; b <= modes; ++b)
        for (std::int64_t c = b; c <= modes; ++c) {
          const std::string g = fmt::format("g{}_{}{}{}", k, a, b, c);
          right += fmt::format(" - {}*v{}*v{}*v{}", g, a, b, c);
          orders += (orders.empty() ? "" : ", ") + g + " = 1";
        }
    text += fmt::format(
        "[[mode]]\ncoordinate = \"v{0}\"\nfrequency = \"w{0}\"\nequation = \"D2(v{0}) + w{0}^2*v{0} ={1}\"\n", k,
        right);
  }
  text += fmt::format("[[case]]\nname = \"free\"\nexpand_to = {}\norder = {{ {} }}\n", order, orders);
  return read_model_text(text, "dense");
}

/// Growth with the number of modes (first argument) and the order of expansion (second): time beside the number of
/// terms of the expansion, which it should not outgrow.
void derive_dense_cubic(benchmark::State& state) {
  const Model model = dense_cubic(state.range(0), state.range(1));
  std::size_t terms = 0;
  for (auto _ : state) {
    const Derivation d = derive(model, model.cases[0]);
    terms = 0;
    for (const auto* fields : {&d.response, &d.slow_derivative})
      for (const FieldSeries& series : *fields)
        for (const Field& field : series) terms += field.terms().size();
    benchmark::DoNotOptimize(terms);
  }
  state.counters["terms"] = static_cast<double>(terms);
  state.counters["s_per_term"] = benchmark::Counter(
      static_cast<double>(terms), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(derive_dense_cubic)
    ->ArgsProduct({{1, 2, 3, 4, 5, 6}, {1}})
    ->ArgsProduct({{1}, {2, 3, 4}})
    ->ArgsProduct({{2}, {2}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace secular
