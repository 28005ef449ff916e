// Regressor rows: columns of a block and their derivatives by the natural frequencies, batched.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "codegen/cpp/emitter.hpp"
#include "codegen/cpp/monomial_code.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

bool uses_excitation_frequency(const CanonicalModel& model, const RationalFunction& f) {
  const std::size_t modes = model.coordinates.size();
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    if (depends_on(f, modes + j)) return true;
  return false;
}

bool uses_natural_frequency(const CanonicalModel& model, const RationalFunction& f) {
  for (std::size_t k = 0; k < model.coordinates.size(); ++k)
    if (depends_on(f, k)) return true;
  return false;
}

class BlockCode {
 public:
  BlockCode(Emitter& emitter, const CanonicalCase& resonance, std::size_t block)
      : emitter_(emitter),
        model_(emitter.model),
        case_(resonance),
        block_(resonance.blocks[block]),
        number_(block),
        monomials_(emitter.model) {
    CppWriter writer(model_.order, "Scalar");
    for (const CanonicalBlock::Column& column : block_.columns) {
      std::string sum;
      for (const CanonicalColumnTerm& term : column.terms) {
        add_to_sum(sum, term_code(term, factors_.size()));
        factors_.push_back(writer.expression(term.factor));
        varies_ = varies_ || uses_excitation_frequency(model_, term.factor);
        slopes_ = slopes_ || uses_natural_frequency(model_, term.factor);
      }
      columns_.push_back(sum);
    }
    for (const std::string& name : writer.used_symbols()) symbols_.insert(name);
    definitions_ = writer.definitions();
  }

  void emit() {
    factors();
    rows();
    columns();
    column_slopes();
  }

 private:
  std::string term_code(const CanonicalColumnTerm& term, std::size_t t) {
    bool real = false;
    const std::string monomial = monomials_.product(term.powers, real);
    std::string product = fmt::format("factor[{}]", t);
    if (!monomial.empty()) product += fmt::format(" * ({})", monomial);
    if (real) product = "Complex(" + product + ")";
    return term.imaginary ? "times_i(" + product + ")" : product;
  }

  void factors() {
    CodeText& code = emitter_.code;
    int operations = 0;
    for (const auto* list : {&definitions_, &factors_})
      for (const std::string& text : *list) operations += operations_in(text);
    code.comment(
        fmt::format("What multiplies the {} terms of the {}: functions of the frequencies alone. {} "
                    "operations.",
                    factors_.size(), block_.name, operations));
    code.line("template <class Scalar>");
    code.line(fmt::format("void factors_{}([[maybe_unused]] const Scalar* natural_frequency,", number_));
    code.line("    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {");
    for (std::size_t i = 0; i < model_.natural_frequencies.size(); ++i)
      unpack(model_.natural_frequencies[i], "natural_frequency", i);
    for (std::size_t j = 0; j < model_.excitation_frequencies.size(); ++j)
      unpack(model_.excitation_frequencies[j], "excitation_frequency", j);
    if (symbols_.count("pi")) code.line("const Scalar pi = Scalar(std::numbers::pi);");
    for (const std::string& definition : definitions_) code.line(definition);
    for (std::size_t t = 0; t < factors_.size(); ++t) code.line(fmt::format("factor[{}] = {};", t, factors_[t]));
    code.line("}").line();
  }

  void unpack(const std::string& name, const char* array, std::size_t i) {
    if (symbols_.count(name))
      emitter_.code.line(fmt::format("const Scalar {} = {}[{}];", safe_identifier(name), array, i));
  }

  void rows() {
    CodeText& code = emitter_.code;
    code.comment(fmt::format("Rows of the {}: target = sum of columns[j][i] * lump_j, with the factors above.",
                             block_.name));
    code.comment(equation_text(model_, case_, block_));
    int operations = monomials_.products();
    for (const std::string& column : columns_) operations += operations_in(column);
    code.comment(fmt::format("{} columns; per observation at most {} products and sums of complex numbers.",
                             columns_.size(), operations));
    code.line("template <class Factors>");
    code.line(
        fmt::format("void rows_{}(const BatchArrays& data, Factors factors, double* const* columns) {{", number_));
    code.line("using Scalar = double;").line("using Complex = ComplexNumber<double>;");
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k)
      if (monomials_.uses_amplitude(k))
        code.line(fmt::format("const Scalar* __restrict amplitude_{0} = data.amplitude[{0}];", k));
    for (std::size_t j = 0; j < model_.excitations.size(); ++j)
      if (monomials_.uses_forcing(j))
        code.line(fmt::format("const Scalar* __restrict forcing_{0} = data.forcing[{0}];", j));
    for (std::size_t j = 0; j < columns_.size(); ++j)
      code.line(fmt::format("Scalar* __restrict column_{0} = columns[{0}];", j));
    code.line(fmt::format("Scalar factor[{}];", factors_.size()));
    std::string natural, excitation;
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k)
      natural += fmt::format("{}data.natural_frequency[{}]", k ? ", " : "", k);
    code.line(fmt::format("const Scalar natural_frequency[] = {{{}}};", natural));
    if (varies_) {
      for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
        code.line(fmt::format("const Scalar* __restrict frequency_{0} = data.excitation_frequency[{0}];", j));
        excitation += fmt::format("{}frequency_{}[i]", j ? ", " : "", j);
      }
    } else {
      code.line("factors(natural_frequency, nullptr, factor);");
    }
    code.line("for (std::size_t i = 0; i < data.count; ++i) {");
    if (varies_) {
      code.line(fmt::format("const Scalar excitation_frequency[] = {{{}}};", excitation));
      code.line("factors(natural_frequency, excitation_frequency, factor);");
    }
    monomials_.declare(code, "i");
    for (std::size_t j = 0; j < columns_.size(); ++j)
      code.line(fmt::format("store_complex(column_{0}, i, {1});  // {2}", j, columns_[j],
                            case_.lumps[block_.columns[j].lump].name));
    code.line("}").line("}").line();
  }

  const char* linkage() const { return emitter_.units ? "" : "inline "; }

  void columns() {
    emitter_.code.comment("columns[j][i] of the rows.");
    emitter_.code.line(
        fmt::format("{}void columns_{}(const BatchArrays& data, double* const* columns) {{", linkage(), number_));
    emitter_.code.line(fmt::format("rows_{0}(data, FactorValues<factors_{0}<double>>{{}}, columns);", number_));
    emitter_.code.line("}").line();
  }

  void column_slopes() {
    CodeText& code = emitter_.code;
    code.comment("columns[j][i] = d(column j)/d(natural frequency of `mode`).");
    code.line(fmt::format("{}void column_slopes_{}(const BatchArrays& data, [[maybe_unused]] std::size_t mode,",
                          linkage(), number_));
    code.line("    double* const* columns) {");
    if (slopes_) {
      code.line(
          fmt::format("rows_{0}(data, FactorSlopes<factors_{0}<DualNumber>, {1}, {2}, {3}>{{mode}}, columns);",
                      number_, model_.coordinates.size(), model_.excitations.size(), factors_.size()));
    } else {
      code.line(fmt::format("for (std::size_t j = 0; j < {}; ++j)", columns_.size()));
      code.line("  for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;");
    }
    code.line("}").line();
  }

  Emitter& emitter_;
  const CanonicalModel& model_;
  const CanonicalCase& case_;
  const CanonicalBlock& block_;
  std::size_t number_;
  MonomialCode monomials_;
  bool varies_ = false, slopes_ = false;
  std::vector<std::string> factors_, columns_, definitions_;
  std::set<std::string> symbols_;
};

}  // namespace

void emit_block(Emitter& emitter, const CanonicalCase& resonance, std::size_t block) {
  BlockCode(emitter, resonance, block).emit();
}

}  // namespace secular
