// Every function of a model's code against 60 digits: relative error below 64 ulp of the condition-scaled value.
#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "codegen/canonical/amplitude_derivative.hpp"
#include "codegen/runtime/derived_code.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "generated/registry.hpp"
#include "perturb/lump_equations.hpp"
#include "perturb/model.hpp"
#include "tests/codegen/fifty_digits.hpp"
#include "tests/places.hpp"
#include "tests/runtime/model_residual.hpp"

namespace secular {
namespace {

using namespace test;
namespace fs = std::filesystem;
const fs::path root = testing_support::source_folder();
constexpr double allowed = 64 * 0x1p-52;

// Compares numbers with their bounds and remembers the worst, in units of the last place.
class Judge {
 public:
  void operator()(double computed, const Real& truth, double size, const std::string& what) {
    const double error = std::abs(rounded(exact(computed) - truth));
    EXPECT_LE(error, allowed * size) << what << ": " << computed << " instead of " << rounded(truth);
    if (size > 0) worst_ = std::max(worst_, error / size * 0x1p52);
    ++count_;
  }
  void operator()(double computed, const Bounded& truth, const std::string& what) {
    (*this)(computed, truth.value, truth.size, what);
  }
  void operator()(Complex computed, const BoundedComplex& truth, const std::string& what) {
    (*this)(computed.real(), truth.real, what);
    (*this)(computed.imag(), truth.imag, what);
  }
  double worst() const { return worst_; }
  std::size_t count() const { return count_; }

 private:
  double worst_ = 0;
  std::size_t count_ = 0;
};

// Batch data of any number of points, structure of arrays.
class Batch {
 public:
  Batch(const CompiledModel& model, const std::vector<Point>& points) : frequency_(points[0].parameters) {
    amplitudes_.resize(model.modes());
    forcings_.resize(model.excitations.size());
    frequencies_.resize(model.excitations.size());
    for (const Point& p : points) {
      for (std::size_t k = 0; k < model.modes(); ++k) amplitudes_[k].push_back(p.amplitude[k]);
      for (std::size_t j = 0; j < model.excitations.size(); ++j) {
        forcings_[j].push_back(p.forcing[j]);
        frequencies_[j].push_back(p.excitation_frequency[j]);
      }
    }
  }
  /// Observations from `first` on; valid as long as this object.
  ObservationBatch from(std::size_t first, std::size_t count) {
    a_.clear(), f_.clear(), w_.clear();
    for (const auto& row : amplitudes_) a_.push_back(row.data() + first);
    for (const auto& row : forcings_) f_.push_back(row.data() + first);
    for (const auto& row : frequencies_) w_.push_back(row.data() + first);
    return {count, frequency_.data(), w_.data(), a_.data(), f_.data()};
  }

 private:
  std::vector<double> frequency_;
  std::vector<std::vector<Complex>> amplitudes_, forcings_;
  std::vector<std::vector<double>> frequencies_;
  std::vector<const Complex*> a_, f_;
  std::vector<const double*> w_;
};

std::vector<Complex*> rows_of(std::vector<std::vector<Complex>>& values) {
  std::vector<Complex*> pointers;
  for (auto& row : values) pointers.push_back(row.data());
  return pointers;
}

std::vector<Real> values_of(const std::vector<Bounded>& list) {
  std::vector<Real> values;
  for (const Bounded& b : list) values.push_back(b.value);
  return values;
}
std::vector<Real> values_of(const std::vector<BoundedComplex>& list) {
  std::vector<Real> values;
  for (const BoundedComplex& z : list) values.insert(values.end(), {z.real.value, z.imag.value});
  return values;
}

void check_motion(const CompiledModel& compiled, const CanonicalModel& canonical, const Point& p, Judge& judge) {
  const Reference reference(canonical);
  ExactPoint point(p);
  const std::size_t n = compiled.modes(), symbols = compiled.symbols.size();
  const auto call = [&](const CompiledModel::MotionFunction& function, std::size_t size) {
    std::vector<double> values(size, NAN);
    function(p.parameters.data(), p.excitation.data(), p.displacement.data(), p.velocity.data(), values.data());
    return values;
  };
  const std::vector<Bounded> mass = reference.mass(point), acceleration = reference.acceleration(point);
  const std::vector<double> m = call(compiled.mass_matrix, n * n), a = call(compiled.acceleration, n);
  for (std::size_t i = 0; i < n * n; ++i) judge(m[i], mass[i], "mass matrix");
  for (std::size_t k = 0; k < n; ++k) judge(a[k], acceleration[k], "acceleration");
  const auto check_slopes = [&](const CompiledModel::MotionFunction& function,
                                const std::vector<MotionVariable>& variables, std::vector<Real*> numbers,
                                const std::string& what) {
    const std::vector<double> slope = call(function, n * variables.size());
    std::vector<Real> truth(n * variables.size(), exact(0));
    for (std::size_t x = 0; x < variables.size(); ++x) {
      const std::vector<Real> column = central_difference(
          point, *numbers[x], [&](const ExactPoint& moved) { return values_of(reference.acceleration(moved)); });
      for (std::size_t k = 0; k < n; ++k) truth[k * variables.size() + x] = column[k];
    }
    const std::vector<double> sizes = reference.slope_size(point, variables, truth);
    for (std::size_t i = 0; i < slope.size(); ++i) judge(slope[i], truth[i], sizes[i] + 1e-18, what);
  };
  std::vector<MotionVariable> state, parameters;
  std::vector<Real*> state_numbers, parameter_numbers;
  for (const bool velocity : {false, true})
    for (std::size_t k = 0; k < n; ++k) {
      state.push_back({velocity ? MotionVariable::Kind::velocity : MotionVariable::Kind::displacement, k});
      state_numbers.push_back(&(velocity ? point.velocity : point.displacement)[k]);
    }
  for (std::size_t i = 0; i < symbols; ++i) {
    parameters.push_back({MotionVariable::Kind::parameter, i});
    parameter_numbers.push_back(&point.parameters[i]);
  }
  check_slopes(compiled.acceleration_by_state, state, state_numbers, "acceleration by state");
  check_slopes(compiled.acceleration_by_parameters, parameters, parameter_numbers, "acceleration by parameters");
}

// Lumps, modulation and their derivatives by parameters.
void check_case(const CompiledModel& compiled, const CompiledCase& resonance, const CanonicalModel& canonical,
                const CanonicalCase& c, const Point& p, Judge& judge) {
  const Reference reference(canonical);
  ExactPoint point(p);
  const std::size_t n = compiled.modes(), symbols = compiled.symbols.size(), lumps = c.lumps.size();
  const std::vector<Bounded> s = reference.symbols(point), lump = reference.lumps(c, point);
  std::vector<double> values(lumps), jacobian(lumps * symbols), gradient(lumps * symbols);
  resonance.evaluate_lumps(p.parameters.data(), values.data());
  resonance.evaluate_lumps_jacobian(p.parameters.data(), jacobian.data());
  for (std::size_t l = 0; l < lumps; ++l) {
    judge(values[l], lump[l], c.lumps[l].name);
    const std::vector<double> sizes = reference.gradient_size(c.lumps[l].definition, s);
    std::copy(sizes.begin(), sizes.end(), gradient.begin() + static_cast<std::ptrdiff_t>(l * symbols));
  }
  // The right side by every parameter, with the sizes of what the sum consists of.
  std::vector<BoundedComplex> rate = reference.modulation(c, point);
  std::vector<double> sensitivity(2 * n * symbols), sensitivity_size(n * symbols, 0.0);
  modulation_by_parameters(compiled, resonance, p.parameters.data(), p.excitation_frequency.data(),
                           p.amplitude.data(), p.forcing.data(), sensitivity.data());
  for (const CanonicalBlock& block : c.blocks) {
    if (!block.modulation || c.mode_at_rest[block.mode]) continue;
    for (const CanonicalBlock::Column& column : block.columns) {
      const BoundedComplex value = reference.column(column, point);
      const std::vector<double> slopes = reference.column_slope_size(column, point);
      for (std::size_t i = 0; i < symbols; ++i)
        sensitivity_size[block.mode * symbols + i] +=
            (value.real.size + value.imag.size) * gradient[column.lump * symbols + i] +
            lump[column.lump].size * slopes[i];
    }
  }
  for (std::size_t i = 0; i < symbols; ++i) {
    const std::vector<Real> slope = central_difference(point, point.parameters[i], [&](const ExactPoint& moved) {
      std::vector<Real> all = values_of(reference.lumps(c, moved));
      for (const Real& x : values_of(reference.modulation(c, moved))) all.push_back(x);
      return all;
    });
    for (std::size_t l = 0; l < lumps; ++l)
      judge(jacobian[l * symbols + i], slope[l], gradient[l * symbols + i] + 1e-18, "d " + c.lumps[l].name);
    for (std::size_t k = 0; k < n; ++k) {
      // The turning of the frame adds at most one multiple of the amplitude.
      const double size = sensitivity_size[k * symbols + i] + (i < n ? std::abs(p.amplitude[k]) : 0) + 1e-18;
      judge(sensitivity[2 * k * symbols + i], slope[lumps + 2 * k], size, "modulation by a parameter");
      judge(sensitivity[(2 * k + 1) * symbols + i], slope[lumps + 2 * k + 1], size, "modulation by a parameter");
    }
  }
  std::vector<Complex> derivative(n);
  resonance.modulation(p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(), p.forcing.data(),
                       derivative.data());
  const std::vector<BoundedComplex> alone = reference.derived_modulation(c, point);
  for (std::size_t k = 0; k < n; ++k) {
    judge(derivative[k], rate[k], "modulation");
    EXPECT_LE(magnitude(rate[k].real.value - alone[k].real.value), 1e-45 * alone[k].real.size) << c.name;
    EXPECT_LE(magnitude(rate[k].imag.value - alone[k].imag.value), 1e-45 * alone[k].imag.size) << c.name;
  }
}

// The modulation's derivatives by amplitudes. Size: the derivative of B^n conj(B)^m |B|^q is at most
// 2 (n + m + |q|)/|B| times as large.
void check_modulation_jacobian(const CompiledCase& resonance, const CanonicalModel& canonical,
                               const CanonicalCase& c, const Point& p, Judge& judge) {
  const Reference reference(canonical);
  ExactPoint point(p);
  const std::size_t n = p.amplitude.size();
  const std::vector<Bounded> s = reference.symbols(point), lump = reference.lumps(c, point);
  std::vector<double> by_amplitude(4 * n * n), size(n * n, 0.0);
  resonance.modulation_jacobian(p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(),
                                p.forcing.data(), by_amplitude.data());
  for (const CanonicalBlock& block : c.blocks) {
    if (!block.modulation || c.mode_at_rest[block.mode]) continue;
    for (const CanonicalBlock::Column& column : block.columns)
      for (const CanonicalColumnTerm& term : column.terms)
        for (std::size_t j = 0; j < n; ++j)
          for (const bool conjugated : {false, true}) {
            const auto derived = amplitude_derivative(term.powers, j, conjugated);
            if (!derived) continue;
            const BoundedComplex m = reference.monomial(derived->powers, point);
            size[block.mode * n + j] +=
                std::abs(static_cast<double>(derived->weight.numerator) / derived->weight.denominator) *
                lump[column.lump].size * reference.value(term.factor, s).size * (m.real.size + m.imag.size);
          }
  }
  for (std::size_t k = 0; k < n; ++k) size[k * n + k] += reference.turning(c, k, s).size;
  for (std::size_t z = 0; z < 2 * n; ++z) {
    if (c.mode_at_rest[z / 2]) continue;
    const std::vector<Real> slope = central_difference(point, point.amplitude[z], [&](const ExactPoint& moved) {
      return values_of(reference.modulation(c, moved));
    });
    for (std::size_t i = 0; i < 2 * n; ++i)
      judge(by_amplitude[i * 2 * n + z], slope[i], size[(i / 2) * n + z / 2] + 1e-18, "modulation by amplitudes");
  }
}

// Columns, their slopes and residuals, batched; a batch equals its single calls bit by bit.
void check_blocks(const CompiledModel& compiled, const CompiledCase& resonance, const CanonicalModel& canonical,
                  const CanonicalCase& c, std::vector<Point> points, Judge& judge) {
  const Reference reference(canonical);
  for (Point& p : points) p.parameters = points[0].parameters;
  const std::size_t n = compiled.modes(), symbols = compiled.symbols.size(), count = points.size();
  Batch batch(compiled, points), single(compiled, points);
  std::vector<double> lumps(c.lumps.size());
  resonance.evaluate_lumps(points[0].parameters.data(), lumps.data());
  for (std::size_t b = 0; b < c.blocks.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    const auto& columns = c.blocks[b].columns;
    std::vector<std::vector<Complex>> values(columns.size(), std::vector<Complex>(count)), one = values;
    block.columns(batch.from(0, count), rows_of(values).data());
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::vector<Complex>> alone(columns.size(), std::vector<Complex>(1));
      block.columns(single.from(i, 1), rows_of(alone).data());
      for (std::size_t j = 0; j < columns.size(); ++j)
        EXPECT_EQ(std::memcmp(&alone[j][0], &values[j][i], sizeof(Complex)), 0) << block.name;
    }
    const std::size_t checked = std::min<std::size_t>(count, 2);
    for (std::size_t i = 0; i < checked; ++i)
      for (std::size_t j = 0; j < columns.size(); ++j)
        judge(values[j][i], reference.column(columns[j], ExactPoint(points[i])), std::string(block.name));
    std::vector<std::vector<std::vector<Complex>>> slopes(n, values);
    for (std::size_t mode = 0; mode < n; ++mode) {
      block.column_slopes(batch.from(0, count), mode, rows_of(slopes[mode]).data());
      for (std::size_t i = 0; i < checked; ++i) {
        ExactPoint point(points[i]);
        for (std::size_t j = 0; j < columns.size(); ++j) {
          const double size = reference.column_slope_size(columns[j], point)[mode] + 1e-18;
          const std::vector<Real> slope =
              central_difference(point, point.parameters[mode], [&](const ExactPoint& x) {
                return values_of(std::vector<BoundedComplex>{reference.column(columns[j], x)});
              });
          judge(slopes[mode][j][i].real(), slope[0], size, "slope of " + std::string(block.name));
          judge(slopes[mode][j][i].imag(), slope[1], size, "slope of " + std::string(block.name));
        }
      }
    }
    // Residual and its derivative: sums of the columns, in any order.
    std::vector<Complex> observed, residual(count), jacobian(symbols * count);
    for (std::size_t i = 0; i < count; ++i) observed.emplace_back(std::sin(1.0 + static_cast<double>(i)), 0.3);
    const double* const parameters = points[0].parameters.data();
    block_residual(compiled, resonance, block, parameters, batch.from(0, count), observed.data(), residual.data());
    block_residual_by_parameters(compiled, resonance, block, parameters, batch.from(0, count), jacobian.data());
    std::vector<double> lump_jacobian(c.lumps.size() * symbols);
    resonance.evaluate_lumps_jacobian(parameters, lump_jacobian.data());
    const std::size_t mode = c.blocks[b].mode;
    const auto expect_near = [&](Complex computed, Complex wanted, double size, const char* what) {
      EXPECT_LE(std::abs(computed - wanted), 64 * 0x1p-52 * size) << what << " of " << block.name;
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Complex turned = c.blocks[b].modulation ? Complex(0, 1) * points[i].amplitude[mode] : Complex();
      Complex wanted = observed[i] - parameters[mode] * turned;
      double size = std::abs(wanted);
      std::vector<Complex> rates(symbols);
      std::vector<double> sizes(symbols, 1e-300);
      rates[mode] -= turned;
      sizes[mode] += std::abs(turned);
      for (std::size_t j = 0; j < columns.size(); ++j) {
        const double lump = lumps[columns[j].lump];
        wanted -= lump * values[j][i];
        size += std::abs(lump * values[j][i]);
        for (std::size_t q = 0; q < symbols; ++q) {
          const double rate = lump_jacobian[columns[j].lump * symbols + q];
          rates[q] -= rate * values[j][i] + (q < n ? lump * slopes[q][j][i] : Complex());
          sizes[q] += std::abs(rate * values[j][i]) + (q < n ? std::abs(lump * slopes[q][j][i]) : 0.0);
        }
      }
      expect_near(residual[i], wanted, size, "residual");
      for (std::size_t q = 0; q < symbols; ++q)
        expect_near(jacobian[q * count + i], rates[q], sizes[q], "residual by a parameter");
    }
  }
}

void check_model(const CompiledModel& compiled, const CanonicalModel& canonical, int draws) {
  std::mt19937_64 random(17);
  Judge judge;
  for (int draw = 0; draw < draws; ++draw) {
    const Point p = random_point(compiled, random);
    check_motion(compiled, canonical, p, judge);
    ASSERT_EQ(compiled.cases.size(), canonical.cases.size());
    for (std::size_t c = 0; c < compiled.cases.size(); ++c) {
      check_case(compiled, compiled.cases[c], canonical, canonical.cases[c], p, judge);
      check_modulation_jacobian(compiled.cases[c], canonical, canonical.cases[c], p, judge);
      std::vector<Point> points = {p};
      while (points.size() < 19) points.push_back(random_point(compiled, random));
      check_blocks(compiled, compiled.cases[c], canonical, canonical.cases[c], points, judge);
    }
  }
  EXPECT_GT(judge.count(), 20u);
  testing::Test::RecordProperty("numbers", std::to_string(judge.count()));
  testing::Test::RecordProperty("worst_ulp", std::to_string(judge.worst()));
}

CanonicalModel canonical_of(const std::string& name) {
  const fs::path file = root / "models" / (name + ".toml");
  std::vector<std::string> notes;
  return derive_for_code({file.string(), *read_file_bytes(file), std::nullopt, {}}, notes);
}

class Digits : public testing::TestWithParam<std::string> {};

TEST_P(Digits, OfEveryGeneratedFunction) {
  check_model(*generated::find_compiled_model(GetParam()), canonical_of(GetParam()), 3);
}

INSTANTIATE_TEST_SUITE_P(Small, Digits,
                         testing::Values("duffing", "mathieu_duffing", "parametric_pair", "pendulum",
                                         "two_mass_lumps", "two_mass_mode1", "van_der_pol"));
INSTANTIATE_TEST_SUITE_P(SlowOnes, Digits,
                         testing::Values("internal_resonance", "three_modes", "two_mass_frame", "two_mass"));

class InterpretedDigits : public testing::TestWithParam<std::string> {};

TEST_P(InterpretedDigits, OfEveryFunction) {
  const CanonicalModel canonical = canonical_of(GetParam());
  check_model(*interpreted_model(canonical), canonical, 2);
}

INSTANTIATE_TEST_SUITE_P(Small, InterpretedDigits,
                         testing::Values("duffing", "mathieu_duffing", "pendulum", "van_der_pol", "two_mass_lumps",
                                         "internal_resonance", "parametric_pair"));
INSTANTIATE_TEST_SUITE_P(SlowOnes, InterpretedDigits, testing::Values("three_modes", "two_mass_frame", "two_mass"));

// The canonical form that the references above are computed from is what GiNaC derived.
TEST(CanonicalForm, HasTheValuesOfGinacsFormulasInSixtyDigits) {
  GiNaC::Digits = 60;
  std::mt19937_64 random(3);
  for (const char* const name : {"two_mass_mode1", "pendulum", "duffing"}) {
    const Model model = read_model(root / "models" / (std::string(name) + ".toml"));
    const CanonicalModel canonical = canonical_model(model);
    const Reference reference(canonical);
    for (std::size_t c = 0; c < model.cases.size(); ++c) {
      FractionSums sums(model.symbols.with_pi());
      const LumpEquations seen = lump_equations(derive(model, model.cases[c], OmegaPolicy::nominal),
                                                derive(model, model.cases[c], OmegaPolicy::kept), sums);
      std::vector<Bounded> symbols;
      GiNaC::exmap map;
      for (const std::string& symbol : canonical.order) {
        symbols.push_back(bounded(exact(0.5 + static_cast<double>(random() >> 11) * 0x1p-53)));
        if (symbol != "pi") map[model.symbols.at(symbol)] = GiNaC::numeric(rounded(symbols.back().value));
      }
      symbols.back() = bounded(cln::pi(cln::float_format(60)));
      const auto expect_equal = [&](const GiNaC::ex& formula, const RationalFunction& flat) {
        const Bounded value = reference.value(flat, symbols);
        const Real truth =
            cln::cl_float(cln::realpart(GiNaC::ex_to<GiNaC::numeric>(formula.subs(map).evalf()).to_cl_N()),
                          cln::float_format(60));
        EXPECT_LE(magnitude(value.value - truth), 1e-50 * (1 + value.size));
      };
      ASSERT_EQ(seen.lumps.size(), canonical.cases[c].lumps.size());
      for (std::size_t l = 0; l < seen.lumps.size(); ++l)
        expect_equal(seen.lumps[l].definition, canonical.cases[c].lumps[l].definition);
      ASSERT_EQ(seen.blocks.size(), canonical.cases[c].blocks.size());
      for (std::size_t b = 0; b < seen.blocks.size(); ++b)
        for (const LumpEquation::Column& column : seen.blocks[b].columns)
          for (const CanonicalBlock::Column& flat : canonical.cases[c].blocks[b].columns) {
            if (flat.lump != column.lump) continue;
            ASSERT_EQ(flat.terms.size(), column.terms.size());
            for (std::size_t t = 0; t < flat.terms.size(); ++t) {
              GiNaC::ex factor = 0;
              for (const FactoredFraction& part : column.terms[t].factor) factor += sums.expression(part);
              expect_equal(factor, flat.terms[t].factor);
            }
          }
    }
  }
}

}  // namespace
}  // namespace secular
