#include "thesis/verify/printed_formula.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "perturb/formula_value.hpp"
#include "thesis/verify/evaluation.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;

constexpr std::array<FormulaFunction, 11> printed_functions = {{{"E", 1},
                                                                {"conj", 1},
                                                                {"cc", 1},
                                                                {"D0", 1},
                                                                {"D1", 1},
                                                                {"D2", 1},
                                                                {"abs", 1},
                                                                {"cos", 1},
                                                                {"sin", 1},
                                                                {"cis", 1},
                                                                {"line", 2}}};

ex real_symbol(const std::string& name) {
  return GiNaC::realsymbol(name);
}

// Swaps what is conjugate to one another, and turns i.
class Conjugation : public GiNaC::map_function {
 public:
  explicit Conjugation(GiNaC::exmap swapped) : swapped_(std::move(swapped)) {}
  ex operator()(const ex& e) override {
    const auto found = swapped_.find(e);
    if (found != swapped_.end()) return found->second;
    if (GiNaC::is_a<GiNaC::numeric>(e)) return GiNaC::ex_to<GiNaC::numeric>(e).conjugate();
    return e.nops() == 0 ? e : e.map(*this);
  }

 private:
  GiNaC::exmap swapped_;
};

}  // namespace

PrintedFormula::PrintedFormula(const PrintedChapter& chapter, const Derivation& derivation)
    : chapter_(chapter), derivation_(derivation) {
  const Model& model = *derivation.model;
  if (chapter.suffixes.size() != model.modes.size() || chapter.unknowns.size() != model.modes.size())
    chapter.place.fail(chapter.suffixes.size() != model.modes.size() ? "suffixes" : "unknowns",
                       "does not name every mode of model " + model.name,
                       std::to_string(model.modes.size()) + " entries, one for each mode");
  for (const std::string& name : model.symbols.names()) names_[name] = model.symbols.at(name);
  names_["i"] = GiNaC::I;
  names_["Pi"] = GiNaC::Pi;
  names_["eps"] = real_symbol("eps");
  names_["t"] = real_symbol("t");
  names_["ghat"] = real_symbol("ghat");
  names_["det"] = real_symbol("det");
  names_["F_min"] = real_symbol("F_min");
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    const std::string& s = chapter.suffixes[k];
    const auto add = [&](std::vector<ex>& list, const std::string& name, bool named) {
      list.push_back(real_symbol(name));
      if (named) names_[name] = list.back();
    };
    add(amplitude_, "A" + s, true);
    add(conjugate_, "conj_A" + s, false);
    add(modulus_, "abs_A" + s, false);
    add(polar_, "a" + s, true);
    add(polar_rate_, "da" + s, true);
    add(phase_rate_, "dbeta" + s, true);
    add(wave_, "wave" + s, false);
    add(phase_factor_, "exp_i_beta" + s, false);
    slow_derivative_.emplace_back();
    slow_derivative_conjugate_.emplace_back();
    for (int n = 0; n <= derivation.resonance->expand_to; ++n) {
      add(slow_derivative_.back(), "D" + std::to_string(n) + "A" + s, n > 0);
      add(slow_derivative_conjugate_.back(), "conj_D" + std::to_string(n) + "A" + s, false);
    }
  }
  for (std::size_t r = 0; r < derivation.layout.relations; ++r) {
    slow_.push_back(real_symbol("slow_wave" + std::to_string(r)));
    detuning_.push_back(model.symbols.at(derivation.resonance->relations[r].detuning));
  }
  evaluated(chapter.gamma, [&] { return read_gamma(), 0; });
  names_["dgamma"] = real_symbol("dgamma");
  std::set<std::string> unknowns;
  for (const std::vector<std::string>& names : chapter.unknowns) unknowns.insert(names.begin(), names.end());
  for (const std::string& name : unknowns)
    if (names_.contains(name))
      chapter.place.fail("unknowns", "'" + name + "' has a meaning already", "choose another name");
  for (const auto& [name, source] : chapter.definitions) {
    if (names_.contains(name) || unknowns.contains(name))
      fail_at(source, {source.first_line, 1}, "'" + name + "' has a meaning already", "choose another name");
    const ex right = read(source);
    names_[name] = right;
  }
}

PrintedFormula::PhaseCombination PrintedFormula::phase_combination(const FormulaSource& source) const {
  const Model& model = *derivation_.model;
  std::map<std::string, ex> betas;
  for (const std::string& s : chapter_.suffixes) betas["beta" + s] = real_symbol("beta" + s);
  const Expression parsed = parse_expression(source, printed_functions);
  const ex phase = formula_value(parsed, source, [&](const Expression& e) -> ex {
                     const auto beta = betas.find(e.text);
                     if (beta != betas.end()) return beta->second;
                     if (model.symbols.contains(e.text)) return model.symbols.at(e.text);
                     fail_at(source, e.place, "unknown symbol '" + e.text + "'", "detunings and phases");
                   }).expand();
  const auto refuse = [&] {
    fail_at(source, parsed.place, "is not an integer combination of detunings and phases",
            "for example sigma - 2*beta");
  };
  ex rest = phase;
  const auto integer = [&](const ex& symbol) {
    const ex coefficient = phase.coeff(symbol, 1);
    if (!GiNaC::is_a<GiNaC::numeric>(coefficient) || !GiNaC::ex_to<GiNaC::numeric>(coefficient).is_integer() ||
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(coefficient)) > largest_exponent)
      refuse();
    rest -= coefficient * symbol;
    return GiNaC::ex_to<GiNaC::numeric>(coefficient).to_int();
  };
  PhaseCombination turns;
  for (const ex& detuning : detuning_) turns.slow.push_back(integer(detuning));
  for (const std::string& s : chapter_.suffixes) turns.phases.push_back(integer(betas["beta" + s]));
  if (!rest.expand().is_zero()) refuse();
  return turns;
}

void PrintedFormula::read_gamma() {
  const PhaseCombination turns = phase_combination(chapter_.gamma);
  gamma_slow_ = turns.slow;
  gamma_phases_ = turns.phases;
  gamma_rate_ = 0;
  for (std::size_t r = 0; r < detuning_.size(); ++r) gamma_rate_ += gamma_slow_[r] * detuning_[r];
  for (std::size_t k = 0; k < gamma_phases_.size(); ++k) gamma_rate_ += gamma_phases_[k] * phase_rate_[k];
}

ex PrintedFormula::read(const FormulaSource& source) const {
  return evaluated(source, [&] { return value(parse_expression(source, printed_functions), source); });
}

ex PrintedFormula::difference(const FormulaSource& source) const {
  const std::size_t at = source.text.find('=');
  if (at == std::string::npos) return read(source);
  // Blanks stand for what is left of it, so that places stay those of the file.
  std::string right = source.text;
  for (std::size_t i = 0; i <= at; ++i)
    if (right[i] != '\n') right[i] = ' ';
  return read({source.text.substr(0, at), source.file, source.first_line}) -
         read({right, source.file, source.first_line});
}

ex PrintedFormula::value(const Expression& e, const FormulaSource& source) const {
  switch (e.kind) {
    case Expression::Kind::number:
      return exact_number(e.text);
    case Expression::Kind::symbol: {
      for (std::size_t k = 0; k < chapter_.unknowns.size(); ++k)
        for (std::size_t n = 0; n < chapter_.unknowns[k].size(); ++n)
          if (chapter_.unknowns[k][n] == e.text) return unknown(k, n, {0, 0, 0});
      const auto found = names_.find(e.text);
      if (found != names_.end()) return found->second;
      const std::vector<Mode>& modes = derivation_.model->modes;
      for (std::size_t k = 0; k < modes.size(); ++k)
        if (modes[k].coordinate == e.text) return unknown(k, 0, {0, 0, 0});
      fail_at(source, e.place, "unknown symbol '" + e.text + "'", "a symbol of the model or of the chapter");
    }
    case Expression::Kind::sum: {
      ex sum = 0;
      for (const Expression& operand : e.operands) sum += value(operand, source);
      return sum;
    }
    case Expression::Kind::product: {
      ex product = 1;
      for (const Expression& operand : e.operands) product *= value(operand, source);
      return product;
    }
    case Expression::Kind::quotient: {
      const ex divisor = value(e.operands[1], source);
      if (divisor.normal().is_zero()) fail_at(source, e.place, "division by zero", "correct the denominator");
      return value(e.operands[0], source) / divisor;
    }
    case Expression::Kind::power: {
      const int exponent = integer_exponent(e, source);
      const ex base = value(e.operands[0], source);
      if (exponent <= 0) refuse_power_of_zero(base, exponent, e, source);
      return GiNaC::pow(base, exponent);
    }
    case Expression::Kind::negation:
      return -value(e.operands[0], source);
    case Expression::Kind::call:
      return call(e, source);
  }
  return 0;
}

ex PrintedFormula::call(const Expression& e, const FormulaSource& source) const {
  const Expression& argument = e.operands[0];
  if (e.text == "E") return exponential(argument, source, false);
  if (e.text == "cos" || e.text == "sin") {
    // cos(gamma) has no time in it, cos(Omega*t + beta) has.
    const ex forward = exponential(argument, source, true);
    return e.text == "cos" ? (forward + 1 / forward) / 2 : (forward - 1 / forward) / (2 * GiNaC::I);
  }
  if (e.text == "cis") return exponential(argument, source, true);
  if (e.text == "line") return line(e, source);
  const ex inside = value(argument, source);
  if (e.text == "conj") return conjugated(inside);
  if (e.text == "cc") return inside + conjugated(inside);
  if (e.text == "abs") return absolute(inside);
  return slow_scale_derivative(inside, static_cast<std::size_t>(e.text[1] - '0'));
}

// line(coordinate or excitation amplitude, frequency)
ex PrintedFormula::line(const Expression& e, const FormulaSource& source) const {
  const Model& model = *derivation_.model;
  const ex wave = exponential(e.operands[1], source, false);
  std::vector<int> multiples;
  for (const ex& mode_wave : wave_) multiples.push_back(wave.degree(mode_wave));
  const std::string& name = e.operands[0].text;
  for (std::size_t k = 0; k < model.modes.size(); ++k)
    if (model.modes[k].coordinate == name) return lines_ ? lines_(k, multiples) : response_line(k, multiples);
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    if (model.excitations[j].amplitude != name) continue;
    ex slow = excitation_wave(j, 1);
    for (std::size_t k = 0; k < wave_.size(); ++k) slow *= GiNaC::pow(wave_[k], -multiples[k]);
    const bool at_it = std::none_of(wave_.begin(), wave_.end(), [&](const ex& w) { return slow.has(w); });
    return at_it ? model.symbols.at(name) * slow : ex(0);
  }
  fail_at(source, e.operands[0].place, "is neither a coordinate nor an excitation's amplitude",
          "line(" + model.modes[0].coordinate + ", frequency)");
}

ex PrintedFormula::response_line(std::size_t mode, const std::vector<int>& multiples) const {
  for (const Field& order : derivation_.response[mode]) {
    ex sum = 0;
    for (const auto& [key, coefficient] : order.terms()) {
      Field one;
      one.add(key, 1);
      const ex term = field(one);
      bool same = true;
      for (std::size_t k = 0; k < wave_.size(); ++k) same = same && term.degree(wave_[k]) == multiples[k];
      if (!same) continue;
      ex slow = 2 * coefficient * term;
      for (std::size_t k = 0; k < wave_.size(); ++k) slow *= GiNaC::pow(wave_[k], -multiples[k]);
      sum += slow;
    }
    if (!sum.is_zero()) return sum;
  }
  return 0;
}

ex PrintedFormula::exponential(const Expression& angle, const FormulaSource& source, bool timed) const {
  const Model& model = *derivation_.model;
  std::map<std::string, ex> betas;
  for (const std::string& s : chapter_.suffixes) betas["beta" + s] = real_symbol("beta" + s);
  const ex gamma = real_symbol("gamma");
  const ex form = formula_value(angle, source, [&](const Expression& e) -> ex {
                    const auto beta = betas.find(e.text);
                    if (beta != betas.end()) return beta->second;
                    if (e.text == "gamma") return gamma;
                    const auto found = names_.find(e.text);
                    if (found == names_.end())
                      fail_at(source, e.place, "unknown symbol '" + e.text + "' in an angle");
                    return found->second;
                  }).expand();
  const ex moving = timed ? form.coeff(names_.at("t"), 1).expand() : form;
  const ex resting = timed ? form.coeff(names_.at("t"), 0).expand() : ex(0);
  std::vector<GiNaC::numeric> waves(wave_.size(), 0), slow(slow_.size(), 0), phases(wave_.size(), 0);
  const auto refuse = [&] {
    fail_at(source, angle.place, "is not a linear combination of frequencies and phases",
            timed ? "for example Omega*t + beta" : "for example 2*omega0");
  };
  const auto number = [&](const ex& coefficient) {
    if (!GiNaC::is_a<GiNaC::numeric>(coefficient)) refuse();
    return GiNaC::ex_to<GiNaC::numeric>(coefficient);
  };
  ex rest = form;
  const auto taken = [&](const ex& part, const ex& symbol) {
    const GiNaC::numeric coefficient = number(part.coeff(symbol, 1));
    rest -= timed && &part == &moving ? coefficient * symbol * names_.at("t") : coefficient * symbol;
    return coefficient;
  };
  for (std::size_t k = 0; k < waves.size(); ++k) {
    waves[k] = waves[k] + taken(moving, model.frequency(k));
    phases[k] = phases[k] + taken(resting, betas["beta" + chapter_.suffixes[k]]);
  }
  for (std::size_t r = 0; r < slow.size(); ++r) slow[r] = slow[r] + taken(moving, detuning_[r]);
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    const GiNaC::numeric multiple = taken(moving, model.frequency(waves.size() + j));
    if (multiple.is_zero()) continue;
    const ex resonant = derivation_.lattice.resonant_frequency(j);
    for (std::size_t k = 0; k < waves.size(); ++k)
      waves[k] = waves[k] + multiple * number(resonant.expand().coeff(model.frequency(k), 1));
    for (std::size_t r = 0; r < slow.size(); ++r)
      slow[r] = slow[r] + multiple * derivation_.lattice.resonant_offset(j)[r];
  }
  const GiNaC::numeric turns = taken(resting, gamma);
  if (!rest.expand().is_zero()) refuse();
  for (std::size_t r = 0; r < slow.size(); ++r) slow[r] = slow[r] + turns * gamma_slow_[r];
  for (std::size_t k = 0; k < phases.size(); ++k) phases[k] = phases[k] + turns * gamma_phases_[k];
  ex product = 1;
  const auto multiply = [&](const ex& base, const GiNaC::numeric& exponent) {
    if (!exponent.is_integer() || GiNaC::abs(exponent) > largest_exponent)
      fail_at(source, angle.place, "is a fraction of the frequencies that occur, or a large multiple",
              "integer multiples up to " + std::to_string(largest_exponent));
    product *= GiNaC::pow(base, exponent);
  };
  for (std::size_t k = 0; k < waves.size(); ++k) {
    multiply(wave_[k], waves[k]);
    multiply(phase_factor_[k], phases[k]);
  }
  for (std::size_t r = 0; r < slow.size(); ++r) multiply(slow_[r], slow[r]);
  return product;
}

ex PrintedFormula::excitation_wave(std::size_t index, int multiple) const {
  const Model& model = *derivation_.model;
  const ex resonant = derivation_.lattice.resonant_frequency(index).expand();
  ex product = 1;
  for (std::size_t k = 0; k < wave_.size(); ++k)
    product *= GiNaC::pow(wave_[k], multiple * resonant.coeff(model.frequency(k), 1));
  for (std::size_t r = 0; r < slow_.size(); ++r)
    product *= GiNaC::pow(slow_[r], derivation_.lattice.resonant_offset(index)[r] * multiple);
  return product;
}

ex PrintedFormula::clock(std::size_t index, int multiple, bool cosine) const {
  const ex forward = excitation_wave(index, multiple);
  return cosine ? (forward + 1 / forward) / 2 : (forward - 1 / forward) / (2 * GiNaC::I);
}

ex PrintedFormula::excitation(std::size_t index, int derivative) const {
  const Model& model = *derivation_.model;
  const ex forward = excitation_wave(index, 1), rate = GiNaC::I * model.frequency(wave_.size() + index);
  return model.symbols.at(model.excitations[index].amplitude) *
         (GiNaC::pow(rate, derivative) * forward + GiNaC::pow(-rate, derivative) / forward) / 2;
}

ex PrintedFormula::unknown(std::size_t mode, std::size_t order, const std::vector<int>& derivatives) const {
  std::string name = "v_" + std::to_string(mode) + "_" + std::to_string(order);
  for (const int d : derivatives) name += "_" + std::to_string(d);
  const auto found = jets_.find(name);
  if (found != jets_.end()) return found->second.first;
  const ex symbol = real_symbol(name);
  jets_[name] = {symbol, {mode, order, derivatives}};
  return symbol;
}

ex PrintedFormula::absolute(const ex& inside) const {
  for (const auto& [name, jet] : jets_)
    if (jet.first.is_equal(inside)) {
      const auto [entry, added] = absolutes_.try_emplace("abs_" + name, real_symbol("abs_" + name));
      return entry->second;
    }
  return GiNaC::abs(inside);
}

ex PrintedFormula::slow_scale_derivative(const ex& expression, std::size_t scale) const {
  ex sum = 0;
  const std::map<std::string, std::pair<ex, Jet>> known = jets_;
  for (const auto& [name, jet] : known) {
    const ex partial = expression.diff(GiNaC::ex_to<GiNaC::symbol>(jet.first));
    if (partial.is_zero()) continue;
    std::vector<int> derivatives = jet.second.derivatives;
    ++derivatives[scale];
    sum += partial * unknown(jet.second.mode, jet.second.order, derivatives);
  }
  return sum;
}

ex PrintedFormula::conjugated(const ex& expression) const {
  GiNaC::exmap swapped;
  const auto pair = [&](const ex& a, const ex& b) {
    swapped[a] = b;
    swapped[b] = a;
  };
  for (std::size_t k = 0; k < wave_.size(); ++k) {
    pair(amplitude_[k], conjugate_[k]);
    swapped[wave_[k]] = 1 / wave_[k];
    swapped[phase_factor_[k]] = 1 / phase_factor_[k];
    for (std::size_t n = 0; n < slow_derivative_[k].size(); ++n)
      pair(slow_derivative_[k][n], slow_derivative_conjugate_[k][n]);
  }
  for (const ex& wave : slow_) swapped[wave] = 1 / wave;
  return Conjugation(std::move(swapped))(expression);
}

ex PrintedFormula::field(const Field& field) const {
  const FieldLayout& layout = derivation_.layout;
  const Model& model = *derivation_.model;
  ex sum = 0;
  for (const auto& [key, coefficient] : field.terms()) {
    ex product = coefficient;
    for (std::size_t k = 0; k < layout.modes; ++k)
      product *= GiNaC::pow(wave_[k], key[k]) * GiNaC::pow(amplitude_[k], key[layout.amplitude(k)]) *
                 GiNaC::pow(conjugate_[k], key[layout.conjugate(k)]) *
                 GiNaC::pow(modulus_[k], key[layout.modulus(k)]);
    for (std::size_t j = 0; j < layout.excitations; ++j)
      product *= excitation_wave(j, key[layout.modes + j]) *
                 GiNaC::pow(model.symbols.at(model.excitations[j].amplitude), key[layout.forcing(j)]);
    for (std::size_t r = 0; r < layout.relations; ++r) product *= GiNaC::pow(slow_[r], key[layout.slow(r)]);
    sum += product;
  }
  return sum;
}

ex PrintedFormula::in_polar_form(const ex& expression) const {
  GiNaC::exmap polar;
  for (std::size_t k = 0; k < wave_.size(); ++k) {
    polar[amplitude_[k]] = polar_[k] * phase_factor_[k] / 2;
    polar[conjugate_[k]] = polar_[k] / phase_factor_[k] / 2;
    polar[modulus_[k]] = polar_[k] / 2;
  }
  return expression.subs(polar, GiNaC::subs_options::no_pattern);
}

ex PrintedFormula::at_resonance(const ex& expression) const {
  const Model& model = *derivation_.model;
  GiNaC::exmap values;
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    values[model.frequency(wave_.size() + j)] = derivation_.lattice.resonant_frequency(j);
  return expression.subs(values, GiNaC::subs_options::no_pattern);
}

}  // namespace secular::verify
