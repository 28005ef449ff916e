#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "codegen/cpp/emit_cpp.hpp"
#include "codegen/document/print_text.hpp"
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

/// A spring between points of a structure, b*(v0 + v1 + ...)^power in every mode's equation.
Model local_spring(std::int64_t modes, std::int64_t power, int order_of_force) {
  std::string text = "schema = 1\nname = \"local\"\n", sum, orders = fmt::format("f = 2, b = {}", order_of_force);
  for (std::int64_t i = 0; i < modes; ++i) {
    sum += fmt::format("{}v{}", i > 0 ? "+" : "", i);
    orders += fmt::format(", mu{} = 2", i);
  }
  for (std::int64_t i = 0; i < modes; ++i)
    text += fmt::format(
        "[[mode]]\ncoordinate = \"v{0}\"\nfrequency = \"w{0}\"\nequation = \"D2(v{0}) + w{0}^2*v{0} = "
        "-2*mu{0}*D(v{0}) - b*({1})^{2} + f*F*cos(Omega*t)\"\n",
        i, sum, power);
  text += fmt::format(
      "[[case]]\nname = \"c\"\nrelations = [\"Omega = w0 + eps^2*sigma\"]\norder = {{ {} }}\nexpand_to = 2\n",
      orders);
  return read_model_text(text, "local");
}

/// Model to plain data, certificate and document: number of modes, power of the spring, its order. Second order of
/// the expansion where the order is 1 (aims: below 1 s for four modes quadratic and three modes cubic), its leading
/// terms where it is 2 (six modes cubic below 10 s). Time beside the number of terms of the formulas.
void document_local_spring(benchmark::State& state) {
  const Model model = local_spring(state.range(0), state.range(1), static_cast<int>(state.range(2)));
  std::size_t terms = 0;
  for (auto _ : state) {
    const CanonicalModel canonical = canonical_model(model);
    benchmark::DoNotOptimize(derivation_text(canonical));
    terms = 0;
    for (const auto* lists : {&canonical.cases[0].slow_derivative, &canonical.cases[0].harmonics})
      for (const auto& list : *lists)
        for (const CanonicalTerm& term : list)
          for (const RationalFunction* part : {&term.real, &term.imaginary})
            terms += part->numerator.size() + part->denominator.size();
  }
  state.counters["terms"] = static_cast<double>(terms);
  state.counters["s_per_term"] = benchmark::Counter(
      static_cast<double>(terms), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(document_local_spring)
    ->ArgsProduct({{2, 3, 4}, {2}, {1}})
    ->ArgsProduct({{2, 3}, {3}, {1}})
    ->ArgsProduct({{2, 3, 4, 5, 6}, {3}, {2}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace secular
