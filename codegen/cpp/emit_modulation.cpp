// Modulation equations in the observed frame and their derivative by Cartesian amplitudes.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "codegen/canonical/amplitude_derivative.hpp"
#include "codegen/cpp/emitter.hpp"
#include "codegen/cpp/monomial_code.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

class ModulationCode {
 public:
  ModulationCode(Emitter& emitter, const CanonicalCase& resonance)
      : emitter_(emitter), model_(emitter.model), case_(resonance), code_(emitter.code) {}

  void modulation() {
    const std::size_t modes = model_.coordinates.size();
    CppWriter writer(model_.order, "Scalar");
    MonomialCode monomials(model_);
    std::vector<std::string> sums(modes), assignments;
    for (const CanonicalBlock& block : case_.blocks) {
      if (!block.modulation) continue;
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms)
          add(sums[block.mode], term_code(column.lump, term, "", writer, monomials));
    }
    bool rotates = false;
    for (std::size_t k = 0; k < modes; ++k) {
      if (case_.mode_at_rest[k]) {
        assignments.push_back(fmt::format("store_complex(derivative, {}, Complex());", k));
        continue;
      }
      std::string value = sums[k].empty() ? "Complex()" : sums[k];
      if (const std::string rotation = rotation_code(k); !rotation.empty()) {
        value += fmt::format("\n - times_i(({}) * A_{})", rotation, model_.coordinates[k]);
        monomials.use_amplitude(k);
        rotates = true;
      }
      assignments.push_back(fmt::format("store_complex(derivative, {}, {});", k, value));
    }
    code_.comment(
        "dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. "
        "amplitude "
        "and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.");
    for (std::size_t k = 0; k < modes; ++k) code_.comment(modulation_text(model_, case_, k));
    code_.comment(fmt::format("{} operations besides the lumps.", operations(writer, assignments)));
    declare("modulation", "derivative");
    prepare(writer, monomials, rotates);
    for (const std::string& assignment : assignments) code_.statement(assignment);
    code_.line("}").line();
  }

  void jacobian() {
    const std::size_t modes = model_.coordinates.size();
    CppWriter writer(model_.order, "Scalar");
    MonomialCode monomials(model_);
    std::vector<std::string> assignments;
    bool rotates = false;
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t j = 0; j < modes; ++j) {
        if (case_.mode_at_rest[k] || case_.mode_at_rest[j]) continue;
        std::string by_amplitude = derived_terms(k, j, false, writer, monomials);
        const std::string by_conjugate = derived_terms(k, j, true, writer, monomials);
        const std::string rotation = j == k ? rotation_code(k) : "";
        if (!rotation.empty())
          by_amplitude +=
              (by_amplitude.empty() ? "-" : "\n - ") + fmt::format("Complex(Scalar(0.0), {})", rotation);
        rotates = rotates || !rotation.empty();
        if (by_amplitude.empty() && by_conjugate.empty()) continue;
        const std::string name = fmt::format("by_{}_{}", k, j);
        const std::size_t row = 4 * modes * k + 2 * j, next = row + 2 * modes;
        for (const auto& [prefix, value] : {std::pair("", by_amplitude), std::pair("conj_", by_conjugate)})
          assignments.push_back(
              fmt::format("const Complex {}{} = {};", prefix, name, value.empty() ? "Complex()" : value));
        assignments.push_back(fmt::format("jacobian[{0}] = {1}.real + conj_{1}.real;", row, name));
        assignments.push_back(fmt::format("jacobian[{0}] = conj_{1}.imag - {1}.imag;", row + 1, name));
        assignments.push_back(fmt::format("jacobian[{0}] = {1}.imag + conj_{1}.imag;", next, name));
        assignments.push_back(fmt::format("jacobian[{0}] = {1}.real - conj_{1}.real;", next + 1, name));
      }
    code_.comment(fmt::format(
        "jacobian[i * {} + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what "
        "`modulation` computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), "
        "d/dRe(B_j) = d/dB_j + d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero "
        "amplitude; a term that has no derivative there counts as zero. {} operations besides the lumps.",
        2 * modes, operations(writer, assignments)));
    declare("modulation_jacobian", "jacobian");
    prepare(writer, monomials, rotates);
    code_.line(fmt::format("for (std::size_t i = 0; i < {}; ++i) jacobian[i] = Scalar(0.0);", 4 * modes * modes));
    for (const std::string& assignment : assignments) code_.statement(assignment);
    code_.line("}").line();
  }

 private:
  // w_k - omega_k: the frame turns with w_k instead of omega_k.
  std::string rotation_code(std::size_t k) const {
    std::string rotation;
    for (std::size_t i = 0; i < case_.observed_frequency[k].size(); ++i) {
      CanonicalRatio r = case_.observed_frequency[k][i];
      if (i == k) r.numerator -= r.denominator;
      if (r.numerator == 0) continue;
      const std::size_t modes = model_.natural_frequencies.size();
      const std::string name = i < modes ? safe_identifier(model_.natural_frequencies[i])
                                         : fmt::format("excitation_frequency[{}]", i - modes);
      std::string weight = r.numerator == 1 ? "" : fmt::format("Scalar({}.0) * ", r.numerator);
      if (r.numerator == -1) weight = "-";
      add_to_sum(rotation,
                 weight + name + (r.denominator == 1 ? "" : fmt::format(" / Scalar({}.0)", r.denominator)));
    }
    return rotation;
  }

  static void add(std::string& sum, const std::string& product) { sum += (sum.empty() ? "" : "\n + ") + product; }

  std::string term_code(std::size_t lump, const CanonicalColumnTerm& term, const std::string& weight,
                        CppWriter& writer, MonomialCode& monomials) {
    std::string product = fmt::format("lumps[{}]", lump);
    if (!term.factor.is_one()) {
      const std::string value = writer.expression(term.factor);
      product += " * " + (reads_as_sum(term.factor) || value.front() == '-' ? "(" + value + ")" : value);
    }
    product += weight;
    bool real = false;
    const std::string monomial = monomials.product(term.powers, real);
    if (!monomial.empty()) product += " * (" + monomial + ")";
    if (real) product = "Complex(" + product + ")";
    return term.imaginary ? "times_i(" + product + ")" : product;
  }

  // Sum of the terms of dB_mode/dt, derived by B_along or its conjugate.
  std::string derived_terms(std::size_t mode, std::size_t along, bool by_conjugate, CppWriter& writer,
                            MonomialCode& monomials) {
    std::string sum;
    for (const CanonicalBlock& block : case_.blocks) {
      if (!block.modulation || block.mode != mode) continue;
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms) {
          const auto derived = amplitude_derivative(term.powers, along, by_conjugate);
          if (!derived) continue;
          std::string weight;
          if (derived->weight.denominator != 1 || derived->weight.numerator != 1)
            weight = fmt::format(" * Scalar({})",
                                 static_cast<double>(derived->weight.numerator) / derived->weight.denominator);
          const CanonicalColumnTerm of_derivative{term.factor, term.imaginary, derived->powers};
          add(sum, term_code(column.lump, of_derivative, weight, writer, monomials));
        }
    }
    return sum;
  }

  static int operations(const CppWriter& writer, const std::vector<std::string>& statements) {
    int count = 0;
    for (const std::string& definition : writer.definitions()) count += operations_in(definition);
    for (const std::string& statement : statements) count += operations_in(statement);
    return count;
  }

  void declare(const std::string& name, const std::string& result) {
    code_.line("template <class Scalar>");
    code_.line(fmt::format("void {}(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,",
                           name));
    code_.line("    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,");
    code_.line(fmt::format("    Scalar* {}) {{", result));
  }

  void prepare(const CppWriter& writer, const MonomialCode& monomials, bool rotates) {
    code_.line("using Complex = ComplexNumber<Scalar>;");
    std::vector<std::string> symbols = writer.used_symbols();
    for (const std::string& name : model_.natural_frequencies)
      if (rotates && std::find(symbols.begin(), symbols.end(), name) == symbols.end()) symbols.push_back(name);
    emitter_.unpack(symbols, "[[maybe_unused]] ");
    for (std::size_t j = 0; j < model_.excitation_frequencies.size(); ++j)
      if (const std::string& name = model_.excitation_frequencies[j];
          std::find(symbols.begin(), symbols.end(), name) != symbols.end())
        code_.line(fmt::format("const Scalar {} = excitation_frequency[{}];", safe_identifier(name), j));
    emitter_.definitions(writer);
    code_.line(fmt::format("Scalar lumps[{}];", std::max<std::size_t>(1, case_.lumps.size())));
    code_.line("evaluate_lumps(parameters, lumps);");
    monomials.declare(code_, "");
  }

  Emitter& emitter_;
  const CanonicalModel& model_;
  const CanonicalCase& case_;
  CodeText& code_;
};

}  // namespace

void emit_modulation(Emitter& emitter, const CanonicalCase& resonance) {
  ModulationCode code(emitter, resonance);
  code.modulation();
  code.jacobian();
}

}  // namespace secular
