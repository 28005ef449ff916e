// Regressor rows: what multiplies the terms of a block, and its columns.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "codegen/canonical/amplitude_derivative.hpp"
#include "codegen/cpp/emitter.hpp"
#include "codegen/cpp/monomial_code.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

constexpr std::size_t longest_declaration = 110;

bool are_equal(const CanonicalPowers& a, const CanonicalPowers& b) {  // slow phases are in no row
  return a.amplitude == b.amplitude && a.conjugate == b.conjugate && a.modulus == b.modulus &&
         a.forcing == b.forcing && a.phase == b.phase;
}

bool are_equal(const CanonicalColumnTerm& a, const CanonicalColumnTerm& b) {
  return a.imaginary == b.imaginary && are_equal(a.powers, b.powers) && a.factor == b.factor;
}

bool are_equal(const CanonicalCase& first, const CanonicalBlock& a, const CanonicalCase& second,
               const CanonicalBlock& b) {
  return a.modulation == b.modulation && a.mode == b.mode && a.phase == b.phase && a.name == b.name &&
         std::equal(a.columns.begin(), a.columns.end(), b.columns.begin(), b.columns.end(),
                    [&](const CanonicalBlock::Column& x, const CanonicalBlock::Column& y) {
                      return first.lumps[x.lump].name == second.lumps[y.lump].name &&
                             std::equal(x.terms.begin(), x.terms.end(), y.terms.begin(), y.terms.end(),
                                        [](const auto& s, const auto& t) { return are_equal(s, t); });
                    });
}

// "harmonic 2*omega1 - Omega of v1" as harmonic_2_omega1_minus_Omega_of_v1.
std::string identifier_of(const std::string& block_name) {
  std::string text;
  for (const char c : block_name) {
    const bool word = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const std::string part = c == '+' ? "_plus_" : c == '-' ? "_minus_" : c == '/' ? "_by_" : std::string(1, c);
    for (const char letter : word ? std::string(1, c) : part.size() > 1 ? part : "_")
      if (letter != '_' || (!text.empty() && text.back() != '_')) text += letter;
  }
  while (!text.empty() && text.back() == '_') text.pop_back();
  return text;
}

std::vector<std::string> block_names(const CanonicalCase& c) {
  std::vector<std::string> names;
  for (const CanonicalBlock& block : c.blocks) {
    std::string name = identifier_of(block.name);
    while (std::find(names.begin(), names.end(), name) != names.end()) name += "_also";
    names.push_back(name);
  }
  return names;
}

// Derivatives of a term of a modulation equation by the amplitude of a mode, then by its conjugate.
std::optional<WeightedPowers> derivative(const CanonicalColumnTerm& term, std::size_t variable) {
  return amplitude_derivative(term.powers, variable / 2, variable % 2 == 1);
}

// Signals that any block of the model needs.
MonomialCode all_signals(const CanonicalModel& model) {
  MonomialCode monomials(model);
  bool real = false;
  for (const CanonicalCase& c : model.cases)
    for (const CanonicalBlock& block : c.blocks)
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms) {
          monomials.product(term.powers, real);
          for (std::size_t z = 0; z < 2 * model.coordinates.size() && block.modulation; ++z)
            if (const auto slope = derivative(term, z)) monomials.product(slope->powers, real);
        }
  return monomials;
}

class BlockText {
 public:
  BlockText(Emitter& emitter, const CanonicalCase& resonance, std::size_t block, std::string name,
            const std::vector<std::string>& signals)
      : code_(emitter.code),
        model_(emitter.model),
        case_(resonance),
        block_(resonance.blocks[block]),
        name_(std::move(name)),
        signals_(signals),
        monomials_(emitter.model),
        writer_(emitter.model.order, "Number") {
    for (const CanonicalBlock::Column& column : block_.columns) {
      std::string sum;
      for (const CanonicalColumnTerm& term : column.terms) add_to_sum(sum, term_code(term));
      columns_.push_back(sum);
    }
  }

  void emit() {
    code_.comment(equation_text(model_, case_, block_));
    const std::string shape = fmt::format(": BlockShape<{}, {}, {}> {{", columns_.size(), factors_.size(), uses());
    if (name_.size() + shape.size() > longest_declaration)
      code_.wrapped("struct " + name_, shape);
    else
      code_.line("struct " + name_ + " " + shape);
    factors();
    row();
    if (block_.modulation) slopes();
    code_.line("};").line();
  }

 private:
  // Its number in the list.
  std::size_t factor_number(const RationalFunction& value) {
    const std::string factor = writer_.expression(value);
    const auto known = std::find(factors_.begin(), factors_.end(), factor);
    const std::size_t number = static_cast<std::size_t>(known - factors_.begin());
    if (known == factors_.end()) factors_.push_back(factor);
    return number;
  }

  std::string term_code(const CanonicalColumnTerm& term) {
    const std::size_t number = factor_number(term.factor);
    for (std::size_t i = 0; i < model_.natural_frequencies.size() + model_.excitation_frequencies.size(); ++i)
      if (depends_on(term.factor, i)) (i < model_.natural_frequencies.size() ? by_natural_ : by_excitation_) = true;
    bool real = false;
    const std::string monomial = monomials_.product(term.powers, real);
    std::string product = fmt::format("factor[{}]", number);
    if (monomial.find(" * ") != std::string::npos)
      product += " * (" + monomial + ")";
    else if (!monomial.empty())
      product += " * " + monomial;
    if (real) product = "ComplexNumber<Number>(" + product + ")";
    return term.imaginary ? "times_i(" + product + ")" : product;
  }

  std::string uses() const {
    std::string text;
    const auto add = [&](bool used, const char* name) {
      if (used) text += (text.empty() ? "" : " | ") + std::string(name);
    };
    add(by_natural_, "follows_modes");
    add(by_excitation_, "follows_excitation");
    add(monomials_.uses_excitation(), "is_forced");
    return text.empty() ? "0" : text;
  }

  std::vector<std::string> frequency_names() const {
    std::vector<std::string> names;
    for (const auto* list : {&model_.natural_frequencies, &model_.excitation_frequencies})
      for (const std::string& name : *list) names.push_back(safe_identifier(name));
    return names;
  }

  void factors() {
    const bool varies = by_natural_ || by_excitation_;
    code_.line("template <class Number>");
    code_.line(fmt::format("static NumberList<Number, {}> factors(const Model::Frequencies<Number>&{}) {{",
                           factors_.size(), varies ? " frequencies" : ""));
    if (varies) code_.list("const auto& [", frequency_names(), "] = frequencies;");
    for (const std::string& name : writer_.used_symbols())
      if (name == "pi") code_.line("const double pi = std::numbers::pi;");
    for (const std::string& definition : writer_.definitions()) code_.line(definition);
    code_.list("return {", factors_, "};");
    code_.line("}");
  }

  void row() {
    code_.line("template <class Number, class Factors> [[gnu::always_inline]]");
    code_.line(
        fmt::format("static void row(const Model::Signals<Number>&{}, const Factors& "
                    "factor, ComplexNumber<Number>* "
                    "column) {{",
                    monomials_.uses_any() ? " signals" : ""));
    if (monomials_.uses_any()) code_.list("const auto& [", signals_, "] = signals;");
    for (std::size_t j = 0; j < columns_.size(); ++j)
      code_.line(fmt::format("column[{}] = {};  // {}", j, columns_[j], case_.lumps[block_.columns[j].lump].name));
    code_.line("}");
  }

  // The sum of lumps times the derivatives of their columns.
  std::string slope_code(std::size_t variable, MonomialCode& monomials) {
    std::string numbers[2], sums[2];  // by whether i multiplies them
    for (std::size_t j = 0; j < block_.columns.size(); ++j)
      for (const CanonicalColumnTerm& term : block_.columns[j].terms) {
        const auto slope = derivative(term, variable);
        if (!slope) continue;
        const CanonicalRatio weight = slope->weight;
        std::string product = fmt::format("lump[{}] * factor[{}]", j, factor_number(term.factor));
        if (weight.numerator != 1 || weight.denominator != 1)
          product = fmt::format("{:#} * ", static_cast<double>(weight.numerator) / weight.denominator) + product;
        bool real = false;
        const std::string monomial = monomials.product(slope->powers, real);
        if (!monomial.empty())
          product += monomial.find(" * ") == std::string::npos ? " * " + monomial : " * (" + monomial + ")";
        add_to_sum((real ? numbers : sums)[term.imaginary], product);
      }
    std::string value;
    if (!numbers[0].empty() || !numbers[1].empty())
      value = fmt::format("ComplexNumber<double>({}{}{})", numbers[0].empty() ? "0.0" : numbers[0],
                          numbers[1].empty() ? "" : ", ", numbers[1]);
    if (!sums[0].empty()) add_to_sum(value, sums[0]);
    if (!sums[1].empty()) add_to_sum(value, "times_i(" + sums[1] + ")");
    return value;
  }

  void slopes() {
    MonomialCode monomials(model_);
    std::vector<std::string> lines;
    bool by_conjugate = false;
    for (std::size_t z = 0; z < 2 * model_.coordinates.size(); ++z)
      if (const std::string value = slope_code(z, monomials); !value.empty()) {
        lines.push_back(fmt::format("{}[{}] = {};", z % 2 == 0 ? "by" : "by_conjugate", z / 2, value));
        by_conjugate = by_conjugate || z % 2 == 1;
      }
    code_.line(
        fmt::format("static void slopes(const Model::Signals<double>&{}, const double* factor, const double* lump,",
                    monomials.uses_any() ? " signals" : ""));
    code_.line(fmt::format("    ComplexNumber<double>* by, ComplexNumber<double>*{}) {{",
                           by_conjugate ? " by_conjugate" : ""));
    if (monomials.uses_any()) code_.list("const auto& [", signals_, "] = signals;");
    for (const std::string& line : lines) code_.line(line);
    code_.line("}");
  }

  CodeText& code_;
  const CanonicalModel& model_;
  const CanonicalCase& case_;
  const CanonicalBlock& block_;
  std::string name_;
  const std::vector<std::string>& signals_;
  MonomialCode monomials_;
  CppWriter writer_;
  bool by_natural_ = false, by_excitation_ = false;
  std::vector<std::string> factors_, columns_;
};

}  // namespace

BlockPlace block_place(const CanonicalModel& model, std::size_t resonance, std::size_t block) {
  const CanonicalCase& own = model.cases[resonance];
  for (std::size_t c = 0; c < resonance; ++c)
    for (std::size_t b = 0; b < model.cases[c].blocks.size(); ++b)
      if (are_equal(model.cases[c], model.cases[c].blocks[b], own, own.blocks[block]))
        return {c, block_names(model.cases[c])[b]};
  return {resonance, block_names(own)[block]};
}

void emit_row_signals(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  CodeText& code = emitter.code;
  std::vector<std::string> names, values;
  for (std::size_t k = 0; k < model.natural_frequencies.size(); ++k) {
    names.push_back(safe_identifier(model.natural_frequencies[k]));
    values.push_back(fmt::format("{}(natural[{}])", names.back(), k));
  }
  for (std::size_t j = 0; j < model.excitation_frequencies.size(); ++j) {
    names.push_back(safe_identifier(model.excitation_frequencies[j]));
    values.push_back(fmt::format("{}(excitation[{}])", names.back(), j));
  }
  code.comment(
      "What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2 "
      "and moduli, and the excitation.");
  code.line("struct Model {");
  code.line(fmt::format("static constexpr std::size_t modes = {}, excitations = {};", model.coordinates.size(),
                        model.excitations.size()));
  code.line();
  code.line("template <class Number>");
  code.line("struct Frequencies {");
  code.list("const Number ", names, ";");
  code.list("Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : ", values, " {}");
  code.line("};").line();
  code.line("template <class Number>");
  code.line("struct Signals {");
  code.line("using Complex = ComplexNumber<Number>;");
  all_signals(model).declare(code);
  code.line("};");
  code.line("};").line();
}

void emit_blocks(Emitter& emitter, std::size_t resonance) {
  const CanonicalCase& c = emitter.model.cases[resonance];
  const std::vector<std::string> signals = all_signals(emitter.model).names();
  for (std::size_t b = 0; b < c.blocks.size(); ++b)
    if (const BlockPlace place = block_place(emitter.model, resonance, b); place.resonance == resonance)
      BlockText(emitter, c, b, place.name, signals).emit();
}

std::vector<std::string> block_function_list(const CanonicalModel& model, std::size_t resonance) {
  std::vector<std::string> list;
  const CanonicalCase& c = model.cases[resonance];
  for (std::size_t b = 0; b < c.blocks.size(); ++b) {
    const BlockPlace place = block_place(model, resonance, b);
    const std::string space =
        place.resonance == resonance ? "" : safe_namespace(model.cases[place.resonance].name) + "::";
    list.push_back(fmt::format("{}_functions<Model, {}{}>()", c.blocks[b].modulation ? "modulation" : "harmonic",
                               space, place.name));
  }
  return list;
}

}  // namespace secular
