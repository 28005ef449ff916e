// The committed code in generated/: up to date, the same whatever GiNaC's order of terms is, and right.
#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "codegen/canonical/evaluation.hpp"
#include "codegen/cpp/emit_cpp.hpp"
#include "generated/registry.hpp"
#include "perturb/lump_equations.hpp"
#include "perturb/model.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
const fs::path source = testing_support::source_folder();
const std::vector<std::string> small_models = {"mathieu_duffing", "pendulum", "two_mass_lumps", "two_mass_mode1",
                                               "van_der_pol"};

std::vector<std::string> shipped_models() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source / "models"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> large_models() {
  std::vector<std::string> names = shipped_models();
  std::erase_if(names, [](const std::string& name) {
    return std::find(small_models.begin(), small_models.end(), name) != small_models.end();
  });
  return names;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<GeneratedFile> generated_files(const std::vector<std::string>& models) {
  std::vector<GeneratedFile> files;
  for (const std::string& name : models)
    for (GeneratedFile& file : emit_cpp(canonical_model(read_model(source / "models" / (name + ".toml")))))
      files.push_back(std::move(file));
  for (GeneratedFile& file : emit_registry(models)) files.push_back(std::move(file));
  return files;
}

// First line that differs, with both texts.
std::string difference(const std::string& committed, const std::string& fresh) {
  std::istringstream a(committed), b(fresh);
  std::string left, right;
  for (int line = 1;; ++line) {
    const bool more_left = static_cast<bool>(std::getline(a, left)),
               more_right = static_cast<bool>(std::getline(b, right));
    if (!more_left && !more_right) return {};
    if (more_left != more_right || left != right)
      return "line " + std::to_string(line) + "\n- " + left + "\n+ " + right;
  }
}

TEST(Generated, FolderIsWhatTheGeneratorWrites) {
  std::vector<std::string> names;
  for (const GeneratedFile& file : generated_files(shipped_models())) {
    names.push_back(file.name);
    const std::string committed = text_of(source / "generated" / file.name);
    EXPECT_EQ(committed, file.text) << "generated/" << file.name
                                    << " has drifted; build with -DSECULAR_REGENERATE=ON. "
                                    << difference(committed, file.text);
  }
  for (const auto& entry : fs::directory_iterator(source / "generated"))
    EXPECT_NE(std::find(names.begin(), names.end(), entry.path().filename().string()), names.end())
        << entry.path() << " is not made by the generator";
}

// GiNaC orders terms by hashes that depend on how many symbols were made before.
void expect_same_bytes_whatever_ginacs_order(const std::vector<std::string>& models) {
  const std::vector<GeneratedFile> first = generated_files(models);
  std::mt19937 random(7);
  for (int run = 0; run < 3; ++run) {
    std::vector<GiNaC::symbol> junk;
    for (std::size_t i = 0, count = random() % 667; i < count; ++i) junk.emplace_back("junk");
    const std::vector<GeneratedFile> again = generated_files(models);
    ASSERT_EQ(first.size(), again.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].text, again[i].text) << first[i].name;
  }
}

TEST(Generated, BytesDoNotDependOnGinacsOrderOfTerms) {
  expect_same_bytes_whatever_ginacs_order(small_models);
}

TEST(SlowGenerated, NorDoThoseOfLargeModels) {
  expect_same_bytes_whatever_ginacs_order(large_models());
}

TEST(Generated, WritingLeavesUnchangedFilesAloneAndNothingHalfWritten) {
  const fs::path folder = testing_support::process_folder() / "generated_write";
  fs::remove_all(folder);
  write_generated({{"a.hpp", "one\n"}}, folder.string());
  const auto stamp = fs::last_write_time(folder / "a.hpp");
  write_generated({{"a.hpp", "one\n"}}, folder.string());
  EXPECT_EQ(stamp, fs::last_write_time(folder / "a.hpp"));
  EXPECT_EQ(text_of(folder / "a.hpp"), "one\n");
  EXPECT_FALSE(fs::exists(folder / "a.hpp.new"));
}

// Random values of order one for every parameter.
std::vector<double> random_parameters(const CompiledModel& model, std::mt19937_64& random) {
  std::vector<double> values;
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    values.push_back(0.5 + static_cast<double>(random() >> 11) * 0x1p-53);
  return values;
}

class GeneratedModel : public testing::TestWithParam<std::string> {
 protected:
  const CompiledModel& compiled = *generated::find_compiled_model(GetParam());
  Model model = read_model(source / "models" / (GetParam() + ".toml"));
  std::mt19937_64 random{11};

  GiNaC::exmap numbers(const std::vector<double>& values) const {
    GiNaC::exmap map;
    for (std::size_t p = 0; p < compiled.symbols.size(); ++p)
      map[model.symbols.at(std::string(compiled.symbols[p].name))] = values[p];
    return map;
  }
};

double number(const GiNaC::ex& e) {
  return GiNaC::ex_to<GiNaC::numeric>(e.evalf()).to_double();
}

TEST_P(GeneratedModel, LumpsEqualGinacAtFiftyDigits) {
  GiNaC::Digits = 50;
  for (std::size_t c = 0; c < compiled.cases.size(); ++c) {
    const CompiledCase& resonance = compiled.cases[c];
    const Derivation nominal = derive(model, model.cases[c], OmegaPolicy::nominal);
    FractionSums sums(model.symbols.with_pi());
    const LumpEquations seen = lump_equations(nominal, derive(model, model.cases[c], OmegaPolicy::kept), sums);
    ASSERT_EQ(seen.lumps.size(), resonance.lumps.size());
    for (int draw = 0; draw < 20; ++draw) {
      const std::vector<double> values = random_parameters(compiled, random);
      std::vector<double> lumps(resonance.lumps.size());
      resonance.evaluate_lumps(values.data(), lumps.data());
      const GiNaC::exmap map = numbers(values);
      for (std::size_t l = 0; l < lumps.size(); ++l) {
        // Condition: the sum of absolute values of the expanded terms.
        const GiNaC::ex expanded = seen.lumps[l].definition.expand();
        double size = 0;
        const bool sum = GiNaC::is_a<GiNaC::add>(expanded);
        for (std::size_t i = 0; i < (sum ? expanded.nops() : 1); ++i)
          size += std::abs(number((sum ? expanded.op(i) : expanded).subs(map)));
        EXPECT_NEAR(lumps[l], number(expanded.subs(map)), 64 * 0x1p-52 * size) << seen.lumps[l].name;
      }
    }
  }
}

TEST_P(GeneratedModel, LumpJacobianEqualsCentralDifferences) {
  for (const CompiledCase& resonance : compiled.cases) {
    const std::vector<double> values = random_parameters(compiled, random);
    const std::size_t count = values.size();
    std::vector<double> jacobian(resonance.lumps.size() * count), up(resonance.lumps.size()), down(up.size());
    resonance.evaluate_lumps_jacobian(values.data(), jacobian.data());
    for (std::size_t p = 0; p < count; ++p) {
      const double h = 1e-5;
      std::vector<double> moved = values;
      moved[p] += h;
      resonance.evaluate_lumps(moved.data(), up.data());
      moved[p] -= 2 * h;
      resonance.evaluate_lumps(moved.data(), down.data());
      for (std::size_t l = 0; l < up.size(); ++l) {
        const double difference = (up[l] - down[l]) / (2 * h);
        EXPECT_NEAR(jacobian[l * count + p], difference, 1e-7 * (1 + std::abs(difference)))
            << resonance.lumps[l].name;
      }
    }
  }
}

TEST_P(GeneratedModel, ModulationAndRowsAgree) {
  // sum of columns*lumps is dB/dt of the block's mode in the observed frame plus its rotation.
  const std::size_t modes = compiled.modes();
  for (const CompiledCase& resonance : compiled.cases) {
    const std::vector<double> values = random_parameters(compiled, random);
    const double omega = 2.3;
    const std::complex<double> forcing(0.3, 0.9);
    std::vector<std::complex<double>> amplitude, rate(modes);
    for (std::size_t k = 0; k < modes; ++k) amplitude.emplace_back(0.7 - 0.3 * static_cast<double>(k), -0.4);
    resonance.modulation(values.data(), &omega, amplitude.data(), &forcing, rate.data());
    std::vector<double> lumps(resonance.lumps.size());
    resonance.evaluate_lumps(values.data(), lumps.data());
    std::size_t blocks = 0;
    for (const RegressorBlock& block : resonance.blocks) {
      if (block.kind != BlockKind::modulation) continue;
      ++blocks;
      const auto mode = static_cast<std::size_t>(block.mode);
      std::vector<std::complex<double>> columns(block.lumps.size());
      std::vector<std::complex<double>*> pointers;
      for (auto& column : columns) pointers.push_back(&column);
      const double* frequencies = &omega;
      std::vector<const std::complex<double>*> amplitudes;
      for (const auto& b : amplitude) amplitudes.push_back(&b);
      const std::complex<double>* forcings = &forcing;
      block.columns({1, values.data(), &frequencies, amplitudes.data(), &forcings}, pointers.data());
      std::complex<double> sum = 0;
      for (std::size_t j = 0; j < columns.size(); ++j)
        sum += columns[j] * lumps[static_cast<std::size_t>(block.lumps[j])];
      double observed = 0;
      const std::size_t width = resonance.observed_frequency.size() / modes;
      for (std::size_t i = 0; i < width; ++i) {
        const Ratio weight = resonance.observed_frequency[mode * width + i];
        observed += static_cast<double>(weight.numerator) / weight.denominator * (i < modes ? values[i] : omega);
      }
      const std::complex<double> turning(0, observed - values[mode]);
      EXPECT_LT(std::abs(sum - (rate[mode] + turning * amplitude[mode])), 1e-12 * (1 + std::abs(sum)));
    }
    EXPECT_GT(blocks, 0u);
  }
}

TEST_P(GeneratedModel, ModulationJacobianEqualsCentralDifferences) {
  const std::size_t modes = compiled.modes(), size = 2 * modes;
  for (const CompiledCase& resonance : compiled.cases) {
    const std::vector<double> values = random_parameters(compiled, random);
    const double omega = 2.3, h = 1e-5;
    const std::complex<double> forcing(0.3, 0.9);
    std::vector<std::complex<double>> amplitude;
    for (std::size_t k = 0; k < modes; ++k) amplitude.emplace_back(0.7 - 0.2 * static_cast<double>(k), -0.4);
    std::vector<double> jacobian(size * size);
    resonance.modulation_jacobian(values.data(), &omega, amplitude.data(), &forcing, jacobian.data());
    for (std::size_t j = 0; j < size; ++j) {
      const std::complex<double> step = j % 2 == 0 ? std::complex<double>(h) : std::complex<double>(0, h);
      std::vector<std::complex<double>> up = amplitude, down = amplitude, right(modes), left(modes);
      up[j / 2] += step;
      down[j / 2] -= step;
      resonance.modulation(values.data(), &omega, up.data(), &forcing, right.data());
      resonance.modulation(values.data(), &omega, down.data(), &forcing, left.data());
      for (std::size_t k = 0; k < modes; ++k) {
        const std::complex<double> slope = (right[k] - left[k]) / (2 * h);
        EXPECT_NEAR(jacobian[2 * k * size + j], slope.real(), 1e-8 * (1 + std::abs(slope))) << resonance.name;
        EXPECT_NEAR(jacobian[(2 * k + 1) * size + j], slope.imag(), 1e-8 * (1 + std::abs(slope))) << resonance.name;
      }
    }
  }
}

TEST_P(GeneratedModel, ZeroAmplitudeIsSafe) {
  for (const CompiledCase& resonance : compiled.cases) {
    const std::vector<double> values = random_parameters(compiled, random);
    const double omega = 2;
    const std::complex<double> none;
    const std::vector<std::complex<double>> zero(compiled.modes());
    std::vector<std::complex<double>> rate(compiled.modes(), {1, 1});
    resonance.modulation(values.data(), &omega, zero.data(), &none, rate.data());
    EXPECT_EQ(rate, zero);
    std::vector<double> jacobian(4 * compiled.modes() * compiled.modes(), NAN);
    resonance.modulation_jacobian(values.data(), &omega, zero.data(), &none, jacobian.data());
    for (const double entry : jacobian) EXPECT_TRUE(std::isfinite(entry));
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, GeneratedModel, testing::ValuesIn(small_models));

TEST(Evaluation, MatchesThesisFormulasAndIsByteStable) {
  const Model model = read_model(source / "models/two_mass_mode1.toml");
  const std::map<std::string, double> values = {{"omega0", 1.5}, {"mu1", 0.1},    {"mu2", 0.2},    {"mu3", 0.3},
                                                {"alpha2", 0.4}, {"alpha3", 0.5}, {"delta2", 0.6}, {"delta3", 0.7},
                                                {"eta1", 0.8},   {"eta2", 0.9}};
  const Derivation derivation = derive(model, model.find_case("principal_parametric"));
  const std::string text = evaluation_json(derivation, values, "values");
  EXPECT_EQ(text, evaluation_json(derivation, values, "values"));
  // -i*eta_e/omega0 multiplies conj(A) F exp(i sigma t), Eqs. (5.14), (5.16).
  const double eta_e = 0.9 / 4 + (0.4 - 3 * 0.6 * 2.25) * 0.8 / (6 * 2.25);
  std::ostringstream expected;
  expected.precision(12);
  expected << -eta_e / 1.5;
  EXPECT_NE(text.find(expected.str().substr(0, 10)), std::string::npos) << text;
  EXPECT_NE(text.find("\"conj_A_v\": 1"), std::string::npos);
  EXPECT_NE(text.find("\"abs_A_v\": 1"), std::string::npos);
}

}  // namespace
}  // namespace secular
