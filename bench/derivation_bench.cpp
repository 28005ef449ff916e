#include <benchmark/benchmark.h>

#include <filesystem>

#include "codegen/emit_cpp.hpp"
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

}  // namespace
}  // namespace secular
