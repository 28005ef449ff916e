// Models that are not compiled into the program: derived, compiled and loaded at run time, or interpreted.
#include "codegen/runtime/runtime_model.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "codegen/runtime/model_cache.hpp"
#include "generated/registry.hpp"
#include "perturb/model.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"
#include "tests/runtime/compare_lanes.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using test::expect_same_tables;
using test::largest_difference;
using Origin = RuntimeModel::Origin;
const fs::path root = testing_support::source_folder();

constexpr const char* linear_text = R"toml(schema = 1
name = "linear"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*mu*D(x) + eta*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps*sigma"]
order = { mu = 1, eta = 1 }
expand_to = 1
)toml";

// Quadratic damping between two moving masses has no Fourier series in closed form; in the second case it is too
// small to matter.
constexpr const char* nonsmooth_text = R"toml(schema = 1
name = "nonsmooth"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -g*D(x) - k*x^3 - g*k*abs(D(x) - D(y))*(D(x) - D(y))"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = 0"
[[case]]
name = "both"
order = { g = 1, k = 1 }
expand_to = 2
excitation = false
[[case]]
name = "small"
order = { g = 1, k = 1 }
expand_to = 1
excitation = false
)toml";

/// Sets an environment variable and puts it back.
class Environment {
 public:
  Environment(std::string name, const char* value) : name_(std::move(name)) {
    if (const char* const old = std::getenv(name_.c_str())) old_ = old;
    set(value);
  }
  ~Environment() { set(old_ ? old_->c_str() : nullptr); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  void set(const char* value) const {
    if (value != nullptr)
      setenv(name_.c_str(), value, 1);
    else
      unsetenv(name_.c_str());
  }
  std::string name_;
  std::optional<std::string> old_;
};

class RuntimeModels : public TemporaryFolder {
 protected:
  RuntimeModelOptions options(std::optional<std::vector<std::string>> cases = std::nullopt) const {
    RuntimeModelOptions result;
    result.cases = std::move(cases);
    result.header_folders = {root};
    result.cache_folder = folder_ / "cache";
    return result;
  }
  RuntimeModel load(const fs::path& file, std::optional<std::vector<std::string>> cases = std::nullopt) const {
    return load_runtime_model(file, options(std::move(cases)));
  }
  fs::path linear_model() const { return write("linear.toml", linear_text); }
  std::vector<fs::path> shared_objects() const {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cache"))
      if (entry.path().extension() == ".so") files.push_back(entry.path());
    return files;
  }
};

TEST_F(RuntimeModels, EqualTheCompiledInAndTheInterpreted) {
  for (const char* const name : {"pendulum", "two_mass_mode1"}) {
    const CompiledModel& compiled_in = *generated::find_compiled_model(name);
    const fs::path file = root / "models" / (std::string(name) + ".toml");
    const RuntimeModel compiled = load(file);
    EXPECT_EQ(compiled.origin, Origin::compiled);
    EXPECT_TRUE(compiled.notes.empty());
    expect_same_tables(compiled_in, *compiled.model);
    EXPECT_LT(largest_difference(compiled_in, *compiled.model, 20), 4 * 0x1p-52) << name;
    RuntimeModelOptions without = options();
    without.interpret = true;
    const RuntimeModel interpreted = load_runtime_model(file, without);
    EXPECT_EQ(interpreted.origin, Origin::interpreted);
    expect_same_tables(compiled_in, *interpreted.model);
    EXPECT_LT(largest_difference(compiled_in, *interpreted.model, 20), 1e-12) << name;
  }
}

TEST(ShippedModels, ComputeMotionsSideBySideAsEachAlone) {
  for (const CompiledModel* model : generated::compiled_models())
    test::expect_lanes_of_each(*model, test::points_of_lanes(*model, 7));
}

TEST_F(RuntimeModels, TwoModesCompiledEqualInterpreted) {
  const std::vector<std::string> cases = {"additive_combination", "free_1"};
  const fs::path file = root / "models/two_mass.toml";
  const RuntimeModel compiled = load(file, cases);
  ASSERT_EQ(compiled.origin, Origin::compiled);
  ASSERT_EQ(compiled.model->cases.size(), 2u);
  RuntimeModelOptions without = options(cases);
  without.interpret = true;
  const RuntimeModel interpreted = load_runtime_model(file, without);
  expect_same_tables(*compiled.model, *interpreted.model);
  EXPECT_LT(largest_difference(*compiled.model, *interpreted.model, 20), 1e-12);
}

TEST_F(RuntimeModels, ModulationJacobianOfTwoModesEqualsCentralDifferences) {
  const RuntimeModel loaded = load(root / "models/two_mass.toml", std::vector<std::string>{"additive_combination"});
  const CompiledCase& resonance = loaded.model->cases[0];
  std::mt19937_64 random(3);
  test::Point p = test::random_point(*loaded.model, random);
  std::vector<double> jacobian(16);
  resonance.modulation_jacobian(p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(),
                                p.forcing.data(), jacobian.data());
  const double size = std::abs(*std::ranges::max_element(jacobian, {}, [](double x) { return std::abs(x); }));
  for (std::size_t j = 0; j < 4; ++j) {
    const double h = 1e-5;
    const std::complex<double> step = j % 2 == 0 ? std::complex<double>(h) : std::complex<double>(0, h);
    std::vector<std::complex<double>> up(2), down(2);
    const auto rate_at = [&](double sign, std::vector<std::complex<double>>& rate) {
      std::vector<std::complex<double>> moved = p.amplitude;
      moved[j / 2] += sign * step;
      resonance.modulation(p.parameters.data(), p.excitation_frequency.data(), moved.data(), p.forcing.data(),
                           rate.data());
    };
    rate_at(1, up);
    rate_at(-1, down);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::complex<double> slope = (up[k] - down[k]) / (2 * h);
      EXPECT_NEAR(jacobian[8 * k + j], slope.real(), 1e-8 * size);
      EXPECT_NEAR(jacobian[8 * k + 4 + j], slope.imag(), 1e-8 * size);
    }
  }
}

TEST_F(RuntimeModels, EquationsOfMotionAloneNeedNoCase) {
  const RuntimeModel compiled = load(root / "models/two_mass.toml", std::vector<std::string>{});
  ASSERT_EQ(compiled.origin, Origin::compiled);
  EXPECT_TRUE(compiled.model->cases.empty());
  EXPECT_EQ(compiled.model->modes(), 2u);
}

TEST_F(RuntimeModels, SecondUseComesFromTheCache) {
  const fs::path file = linear_model();
  EXPECT_EQ(load(file).origin, Origin::compiled);
  EXPECT_EQ(load(file).origin, Origin::cached);
  // A changed model is another model.
  std::ofstream(file, std::ios::app) << "[nominal]\nw = 2\n";
  const RuntimeModel changed = load(file);
  EXPECT_EQ(changed.origin, Origin::compiled);
  EXPECT_EQ(changed.model->nominal[0], 2);
}

TEST_F(RuntimeModels, InterpretationTakesTheDerivationFromTheCache) {
  RuntimeModelOptions without = options();
  without.interpret = true;
  for (const char* const name : {"two_mass_lumps", "pendulum"}) {
    const fs::path file = root / "models" / (std::string(name) + ".toml");
    const RuntimeModel first = load_runtime_model(file, without), second = load_runtime_model(file, without);
    EXPECT_EQ(first.origin, Origin::interpreted);
    expect_same_tables(*first.model, *second.model);
    EXPECT_EQ(largest_difference(*first.model, *second.model, 5), 0) << name;
  }
  // What it is taken from: an entry with other words in it is believed as long as its digest is right.
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cache"))
    if (entry.path().extension() == ".model") entries.push_back(entry.path());
  ASSERT_EQ(entries.size(), 2u);
  const ModelCache cache(folder_ / "cache");
  for (const fs::path& entry : entries) {
    const std::string key = entry.stem().string();
    std::string text = *cache.read(key, ".model");
    if (text.find("pendulum") == std::string::npos) continue;
    text.replace(text.find("pendulum"), 8, "cachelum");
    ASSERT_TRUE(cache.store(key, ".model", text));
  }
  EXPECT_EQ(load_runtime_model(root / "models/pendulum.toml", without).model->name, "cachelum");
  // One that is damaged, or of another form, is derived anew.
  for (const fs::path& entry : entries) fs::resize_file(entry, 50);
  EXPECT_EQ(load_runtime_model(root / "models/pendulum.toml", without).model->name, "pendulum");
  for (const fs::path& entry : entries)
    cache.store(entry.stem().string(), ".model", R"({"notes":[],"model":"{}"})");
  EXPECT_EQ(load_runtime_model(root / "models/pendulum.toml", without).model->name, "pendulum");
}

TEST_F(RuntimeModels, DamagedEntriesAreRebuilt) {
  const fs::path file = linear_model();
  load(file);
  ASSERT_EQ(shared_objects().size(), 1u);
  const fs::path object = shared_objects()[0];
  std::ifstream stream(object, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  std::string flipped = whole;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
  for (const std::string& damage : {whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 1), flipped,
                                    std::string(), whole + "x"}) {
    fs::remove(object);
    std::ofstream(object, std::ios::binary) << damage;
    const RuntimeModel rebuilt = load(file);
    EXPECT_EQ(rebuilt.origin, Origin::compiled);
    EXPECT_EQ(rebuilt.model->name, "linear");
    EXPECT_EQ(load(file).origin, Origin::cached);
  }
  // The same for what is kept of the derivation.
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cache"))
    if (entry.path().extension() == ".json") fs::resize_file(entry.path(), 100);
  EXPECT_EQ(load(file).origin, Origin::cached);
}

TEST_F(RuntimeModels, ProgramsAtOnceDoNotCollide) {
  const fs::path file = linear_model();
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const RuntimeModel loaded = load(file);
      _exit(loaded.origin != Origin::interpreted && loaded.model->name == "linear" ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(load(file).origin, Origin::cached);
  EXPECT_EQ(shared_objects().size(), 1u);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cache"))
    EXPECT_TRUE(entry.is_regular_file()) << entry.path() << " was left behind";
}

TEST_F(RuntimeModels, WithoutACompilerTheModelIsInterpreted) {
  const fs::path file = linear_model();
  const Environment chosen("CXX", nullptr), path("PATH", "/nonexistent");
  const RuntimeModel loaded = load(file);
  EXPECT_EQ(loaded.origin, Origin::interpreted);
  ASSERT_EQ(loaded.notes.size(), 1u);
  EXPECT_TRUE(contains(loaded.notes[0], "no C++ compiler was found"));
  EXPECT_EQ(loaded.model->cases.size(), 1u);
}

TEST_F(RuntimeModels, ACompilerThatFailsLeadsToInterpretation) {
  const fs::path compiler = write("compiler",
                                  "#!/bin/sh\n[ \"$1\" = --version ] && echo fake 1.0 && exit 0\n"
                                  "echo 'error: no space left' >&2\nexit 1\n");
  fs::permissions(compiler, fs::perms::owner_all);
  const Environment chosen("CXX", compiler.c_str());
  const RuntimeModel loaded = load(linear_model());
  EXPECT_EQ(loaded.origin, Origin::interpreted);
  ASSERT_EQ(loaded.notes.size(), 1u);
  EXPECT_TRUE(contains(loaded.notes[0], "error: no space left"));
}

TEST_F(RuntimeModels, ACacheThatCannotBeTrustedIsNotUsed) {
  const fs::path cache = folder_ / "cache";
  fs::create_directory(cache);
  fs::permissions(cache, fs::perms::all);
  const fs::path file = linear_model();
  EXPECT_EQ(load(file).origin, Origin::compiled);
  EXPECT_TRUE(shared_objects().empty());
}

TEST_F(RuntimeModels, NamesOfAModelCannotBecomeCode) {
  const fs::path trace = folder_ / "trace";
  const auto model = [&](const std::string& name, const std::string& source, const std::string& coordinate,
                         const std::string& symbol, const std::string& resonance) {
    return write("hostile.toml", "schema = 1\nname = '''" + name + "'''\nsource = '''" + source +
                                     "'''\n[[mode]]\ncoordinate = '''" + coordinate + "'''\nfrequency = \"w\"\n" +
                                     "equation = '''D2(" + coordinate + ") + w^2*" + coordinate + " = -" + symbol +
                                     "*" + coordinate + "^3'''\n[[case]]\nname = '''" + resonance +
                                     "'''\norder = { " + symbol + " = 1 }\nexpand_to = 1\nexcitation = false\n");
  };
  const std::string call = "system(\"touch " + trace.string() + "\")";
  // What is no identifier is refused.
  for (const std::string& bad : {"a; " + call, std::string("a/../../b"), std::string("a\nb"), std::string("a\"b"),
                                 std::string("\xce\xb1"), std::string("a b"), std::string(65, 'a')}) {
    EXPECT_THROW(load(model(bad, "", "x", "g", "c")), InputError) << bad;
    EXPECT_THROW(load(model("m", "", bad, "g", "c")), InputError) << bad;
    EXPECT_THROW(load(model("m", "", "x", bad, "c")), InputError) << bad;
    EXPECT_THROW(load(model("m", "", "x", "g", bad)), InputError) << bad;
  }
  // Free text is a string and a comment.
  for (const std::string& source :
       {"\"; " + call + "; //", "\n#error\n" + call + ";", "*/ " + call + " /*", std::string("\\\n#error"),
        std::string("?") + "?/\n#error", std::string(")\" %s {} {0}")}) {
    const RuntimeModel loaded = load(model("m", source, "x", "g", "c"));
    EXPECT_EQ(loaded.origin, Origin::compiled) << source;
  }
  EXPECT_FALSE(fs::exists(trace));
}

// Words of C++, of its library and of the generated code itself are fine names for a model's symbols.
TEST_F(RuntimeModels, AnyIdentifierMayBeASymbol) {
  std::string damping, order;
  for (const char* const name :
       {"int",           "std",        "__LINE__",  "_Pragma",       "NAN",        "M_PI",
        "errno",         "x_2",        "mu",        "mu_2",          "s_mu_2_s",   "A_x",
        "norm_A_x",      "unit_A_x",   "i",         "lumps",         "parameters", "rate",
        "mass",          "force",      "Scalar",    "denominator_0", "factor_0_0", "evaluate_lumps",
        "integer_power", "is_nonzero", "Parameter", "Sample",        "Lanes",      "LaneSample",
        "data",          "count",      "asm",       "__asm__",       "F_",         "c_0_0"}) {
    damping += std::string(" - ") + name + "*D(x)^3 - " + name + "^2*x^2";
    order += std::string(order.empty() ? "" : ", ") + name + " = 1";
  }
  for (const char* const name :
       {"std", "int", "model", "cases", "CompiledModel", "__LINE__", "case_0", "main", "Lanes"}) {
    const fs::path file = write(
        "names.toml",
        "schema = 1\nname = \"" + std::string(name) +
            "\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"D2(x) + w^2*x = eta*F*cos(Omega*t)" +
            damping + "\"\n[[case]]\nname = \"" + name +
            "\"\nrelations = [\"Omega = w + eps*sigma\"]\norder = { eta = 1, " + order + " }\nexpand_to = 1\n");
    const RuntimeModel compiled = load(file);
    ASSERT_EQ(compiled.origin, Origin::compiled) << name << ": " << compiled.notes[0];
    std::vector<std::string> notes;
    EXPECT_LT(largest_difference(*compiled.model, *interpreted_model(canonical_model(read_model(file))), 3), 1e-12);
  }
}

TEST_F(RuntimeModels, CasesWithoutRegressorAreLeftOutOrRefused) {
  const fs::path file = write("nonsmooth.toml", nonsmooth_text);
  const RuntimeModel all = load(file);
  ASSERT_EQ(all.model->cases.size(), 1u);
  EXPECT_EQ(all.model->cases[0].name, "small");
  ASSERT_EQ(all.notes.size(), 1u);
  EXPECT_TRUE(contains(all.notes[0], "case both is left out"));
  EXPECT_TRUE(contains(refusal([&] { load(file, std::vector<std::string>{"both"}); }), "quadrature"));
  EXPECT_TRUE(contains(refusal([&] { load(file, std::vector<std::string>{"third"}); }), "has no case 'third'"));
}

}  // namespace
}  // namespace secular
