#include "perturb/lump_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/factored_fraction.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/prime_field.hpp"
#include "perturb/row_reduction.hpp"

namespace secular {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

GiNaC::exvector terms_of(const ex& sum) {
  if (!GiNaC::is_exactly_a<GiNaC::add>(sum)) return {sum};
  return {sum.begin(), sum.end()};
}

// above/below in few factors, by what is known of their denominators: greatest common divisors in the frequencies
// of several modes come to no end.
ex quotient(const ex& above, const ex& below) {
  FractionSums sums;
  const auto numerator = sums.sum(terms_of(above.expand())), denominator = sums.sum(terms_of(below.expand()));
  if (!numerator || !denominator) return (above / below).normal();
  ex ratio;
  if (!GiNaC::divide(numerator->numerator, denominator->numerator, ratio))
    ratio = (numerator->numerator / denominator->numerator).normal();
  FactorPowers powers = denominator->denominator;
  for (const auto& [factor, power] : numerator->denominator) powers[factor] -= power;
  for (const auto& [factor, power] : powers) ratio *= GiNaC::pow(factor, power);
  return ratio;
}

class LumpFinder {
 public:
  explicit LumpFinder(const Model& model) : model_(model), first_(point(model, 1)), second_(point(model, 2)) {
    for (const Shorthand& shorthand : model.shorthands)
      named_.push_back(candidate(
          {shorthand.name, formula_value(shorthand.expression, shorthand.source,
                                         [&](const Expression& s) { return ex(model.symbols.at(s.text)); })}));
  }

  struct Split {
    std::size_t lump;
    ex factor;
  };

  // coefficient = factor(frequencies) * lump. Nothing if the only fitting lump would depend on an excitation
  // frequency.
  std::optional<Split> split(const ex& coefficient, const std::string& fallback_name) {
    std::vector<std::string> present;
    for (const std::string& name : model_.parameters)
      if (coefficient.has(model_.symbols.at(name))) present.push_back(name);
    if (present.empty()) return Split{use(candidate({"one", 1})), coefficient};
    const Candidate whole = candidate({fallback_name, coefficient});
    if (present.size() == 1) {
      const Candidate single = candidate({present.front(), model_.symbols.at(present.front())});
      if (const auto ratio = proportion(whole, single)) return Split{use(single), *ratio};
    }
    for (const std::vector<Candidate>* candidates : {&named_, &used_})
      for (const Candidate& other : *candidates)
        if (const auto ratio = proportion(whole, other)) return Split{use(other), *ratio};
    for (const Excitation& excitation : model_.excitations)
      if (coefficient.has(model_.symbols.at(excitation.frequency))) return std::nullopt;
    return Split{use(whole), 1};
  }

  std::vector<Lump> lumps() const {
    std::vector<Lump> lumps;
    for (const Candidate& candidate : used_) lumps.push_back(candidate.lump);
    return lumps;
  }
  std::size_t size() const { return used_.size(); }
  void forget_after(std::size_t count) {
    used_.erase(used_.begin() + static_cast<std::ptrdiff_t>(count), used_.end());
  }

 private:
  // A definition with its values at two random points that differ in the parameters only.
  struct Candidate {
    Lump lump;
    PrimeFieldComplex first, second;
  };

  Candidate candidate(Lump lump) {
    const PrimeFieldComplex first = first_.value(lump.definition), second = second_.value(lump.definition);
    return {std::move(lump), first, second};
  }

  // All symbols from draw 0, parameters from the one given.
  static RandomPoint point(const Model& model, std::uint64_t parameter_draw) {
    return RandomPoint([&model, parameter_draw](const std::string& name) {
      const bool parameter =
          std::find(model.parameters.begin(), model.parameters.end(), name) != model.parameters.end();
      return parameter ? parameter_draw : std::uint64_t{0};
    });
  }

  // The ratio of two expressions if it is free of parameters. Decided at the random points; then parameters that
  // show the ratio are put in, so that a common denominator of frequencies alone is formed.
  std::optional<ex> proportion(const Candidate& above, const Candidate& below_it) const {
    if (above.first * below_it.second != above.second * below_it.first) return std::nullopt;
    const ex &coefficient = above.lump.definition, &definition = below_it.lump.definition;
    for (const std::string& chosen : model_.parameters) {
      if (!definition.has(model_.symbols.at(chosen))) continue;
      GiNaC::exmap values;
      for (const std::string& name : model_.parameters) values[model_.symbols.at(name)] = name == chosen ? 1 : 0;
      try {
        const ex below = definition.subs(values, GiNaC::subs_options::no_pattern);
        if (vanishes(below)) continue;
        return quotient(coefficient.subs(values, GiNaC::subs_options::no_pattern), below);
      } catch (const GiNaC::pole_error&) {
        continue;
      }
    }
    long next = 2;  // every single parameter alone makes it vanish, as in a product of two
    GiNaC::exmap values;
    for (const std::string& name : model_.parameters) values[model_.symbols.at(name)] = next++;
    return quotient(coefficient.subs(values, GiNaC::subs_options::no_pattern),
                    definition.subs(values, GiNaC::subs_options::no_pattern));
  }

  std::size_t use(Candidate candidate) {
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (used_[i].lump.name == candidate.lump.name) return i;
    used_.push_back(std::move(candidate));
    return used_.size() - 1;
  }

  const Model& model_;
  RandomPoint first_, second_;
  std::vector<Candidate> named_;
  std::vector<Candidate> used_;
};

std::string powers_name(const FieldKey& key, const FieldLayout& layout, const Model& model) {
  std::string name;
  const auto add = [&](const std::string& base, int power) {
    if (power == 0) return;
    name += (name.empty() ? "" : "_") + base +
            (power == 1 ? "" : (power < 0 ? "m" : "") + std::to_string(std::abs(power)));
  };
  for (std::size_t k = 0; k < layout.modes; ++k) add("A_" + model.modes[k].coordinate, key[layout.amplitude(k)]);
  for (std::size_t k = 0; k < layout.modes; ++k)
    add("conjA_" + model.modes[k].coordinate, key[layout.conjugate(k)]);
  for (std::size_t k = 0; k < layout.modes; ++k) add("absA_" + model.modes[k].coordinate, key[layout.modulus(k)]);
  for (std::size_t j = 0; j < layout.excitations; ++j) add(model.excitations[j].amplitude, key[layout.forcing(j)]);
  return name;
}

// One product of powers of the detunings in a coefficient.
struct DetunedPart {
  ex coefficient;      // free of detunings
  ex detunings = 1;    // in terms of the frequencies: sigma = (Omega - 2*omega0)/c for Omega = 2*omega0 + c*sigma
  std::string suffix;  // for names: "_sigma2"
};

// Detunings are known from measured frequencies, so that they belong to the columns and never to a lump.
std::vector<DetunedPart> without_detunings(const Derivation& d, const ex& coefficient) {
  std::vector<DetunedPart> parts = {{coefficient, 1, ""}};
  for (const ResonanceRelation& relation : d.resonance->relations) {
    if (relation.detuning.empty()) continue;
    const ex& sigma = d.model->symbols.at(relation.detuning);
    ex value = 0;
    for (std::size_t i = 0; i < relation.multiples.size(); ++i)
      value += relation.multiples[i] * d.model->frequency(i);
    std::vector<DetunedPart> next;
    for (const DetunedPart& part : parts)
      for (int power = 0; power <= part.coefficient.degree(sigma); ++power) {
        const ex alone = part.coefficient.coeff(sigma, power).expand();
        if (alone.is_zero()) continue;
        next.push_back(
            {alone, part.detunings * GiNaC::pow(value / relation.coefficient, power),
             part.suffix +
                 (power == 0 ? "" : "_" + relation.detuning + (power == 1 ? "" : std::to_string(power)))});
      }
    parts = std::move(next);
  }
  return parts;
}

// A term of a field with its key, in a fixed order (by key).
bool append_terms(LumpEquation& block, LumpFinder& finder, const Derivation& d,
                  const std::vector<std::pair<FieldKey, ex>>& terms) {
  for (const auto& [key, coefficient] : terms)
    for (const bool imaginary : {false, true}) {
      const ex part = (imaginary ? coefficient.imag_part() : coefficient.real_part()).expand();
      if (part.is_zero()) continue;
      const std::string kind = block.modulation ? (imaginary ? "conservative_" : "dissipative_")
                                                : (imaginary ? "harmonic_im_" : "harmonic_re_");
      const std::string name =
          kind + d.model->modes[block.mode].coordinate + "_" + powers_name(key, d.layout, *d.model);
      for (const DetunedPart& detuned : without_detunings(d, part)) {
        const auto split = finder.split(detuned.coefficient, name + detuned.suffix);
        if (!split) return false;
        auto column = std::find_if(block.columns.begin(), block.columns.end(),
                                   [&](const LumpEquation::Column& c) { return c.lump == split->lump; });
        if (column == block.columns.end()) column = block.columns.insert(block.columns.end(), {split->lump, {}});
        column->terms.push_back({split->factor * detuned.detunings, imaginary, key});
      }
    }
  return true;
}

std::vector<std::pair<FieldKey, ex>> terms_of(const Field& field) {
  return {field.terms().begin(), field.terms().end()};
}

// At the nominal values, an excitation's without one as the resonance has it; not a number without them.
double nominal_frequency(const Phase& phase, const Derivation& d) {
  const Model& model = *d.model;
  const auto nominal = [&](std::size_t i) {
    const auto entry = model.nominal.find(model.frequency_name(i));
    return entry == model.nominal.end() ? std::numeric_limits<double>::quiet_NaN() : entry->second;
  };
  double frequency = 0;
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == 0) continue;
    double value = nominal(i);
    if (std::isnan(value) && i >= model.modes.size()) {
      GiNaC::exmap numbers;
      for (std::size_t k = 0; k < model.modes.size(); ++k)
        if (!std::isnan(nominal(k))) numbers[model.frequency(k)] = nominal(k);
      const ex resonant = d.lattice.resonant_frequency(i - model.modes.size()).subs(numbers).evalf();
      if (GiNaC::is_a<numeric>(resonant)) value = GiNaC::ex_to<numeric>(resonant).to_double();
    }
    frequency += phase[i] * value;
  }
  return frequency;
}

// Of a phase and its conjugate one is listed, of all phases that are seen at one frequency (`seen`, a row over all
// frequencies) the same one: with Omega = 3*omega0, omega0 - 2*Omega and 2*omega0 + Omega make one line, which is
// one equation.
bool conjugate_is_listed(const Phase& phase, const std::vector<numeric>& seen, const Derivation& d) {
  const double frequency = nominal_frequency(phase, d);
  if (!std::isnan(frequency) && frequency != 0) return frequency < 0;
  const auto first = std::find_if(seen.begin(), seen.end(), [](const numeric& x) { return !x.is_zero(); });
  return first != seen.end() && first->is_negative();
}

struct PhaseRowLess {
  bool operator()(const std::vector<numeric>& a, const std::vector<numeric>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) return a[i] < b[i];
    return false;
  }
};

// Harmonic terms of one mode by the frequency at which they are seen.
std::vector<LumpEquation> harmonic_blocks(const Derivation& d, const ObservedFrequencies& frequencies,
                                          std::size_t mode,
                                          std::vector<std::vector<std::pair<FieldKey, ex>>>& terms) {
  std::map<std::vector<numeric>, std::size_t, PhaseRowLess> groups;
  std::vector<LumpEquation> blocks;
  for (std::size_t n = 0; n < d.response[mode].size(); ++n)
    for (const auto& [key, coefficient] : d.response[mode][n].terms()) {
      Phase phase = d.full_phase(key);
      Phase own(phase.size(), 0);
      own[mode] = 1;
      if (n == 0 && (phase == own || d.lattice.slow_multipliers([&] {
            Phase opposite = phase;
            ++opposite[mode];
            return opposite;
          }())))
        continue;  // the oscillation itself
      const std::vector<numeric> seen = frequencies.of_phase(phase);
      const bool zero = std::all_of(seen.begin(), seen.end(), [](const numeric& x) { return x.is_zero(); });
      if (!zero && conjugate_is_listed(phase, seen, d)) continue;
      const auto [group, added] = groups.try_emplace(seen, blocks.size());
      if (added) {
        LumpEquation block;
        block.modulation = false;
        block.mode = mode;
        block.order = static_cast<int>(n);
        block.phase = zero ? Phase(phase.size(), 0) : phase;
        blocks.push_back(std::move(block));
        terms.emplace_back();
      }
      LumpEquation& block = blocks[group->second];
      const auto cost = [&](const Phase& p) {
        int total = 0, natural = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
          total += std::abs(p[i]);
          if (i < d.layout.modes) natural += std::abs(p[i]);
        }
        return std::pair(total, natural);
      };
      if (!zero && cost(phase) < cost(block.phase)) block.phase = phase;
      terms[group->second].emplace_back(key, coefficient);
    }
  return blocks;
}

}  // namespace

std::vector<numeric> ObservedFrequencies::of_phase(const Phase& phase) const {
  std::vector<numeric> row(phase.size(), 0);
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == 0) continue;
    if (i >= of_mode.size()) {
      row[i] = row[i] + phase[i];
      continue;
    }
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = row[c] + phase[i] * of_mode[i][c];
  }
  return row;
}

std::optional<ObservedFrequencies> observed_frequencies(const Derivation& d) {
  const FieldLayout& layout = d.layout;
  // Unknown x_k per relation: w_k = omega_k + sum_r x_kr * relation_r.
  std::vector<std::vector<numeric>> shifts(layout.modes, std::vector<numeric>(layout.relations, 0));
  for (std::size_t r = 0; r < layout.relations; ++r) {
    std::vector<std::vector<numeric>> rows;
    for (std::size_t k = 0; k < layout.modes; ++k) {
      const Field modulation = d.modulation(k);
      for (const auto& [key, coefficient] : modulation.terms()) {
        std::vector<numeric> row(layout.modes + 1, 0);
        for (std::size_t j = 0; j < layout.modes; ++j) row[j] = key[layout.amplitude(j)] - key[layout.conjugate(j)];
        row[k] = row[k] - 1;
        row[layout.modes] = -key[layout.slow(r)];
        rows.push_back(std::move(row));
      }
    }
    const auto solution = solve_exactly(std::move(rows), layout.modes);
    if (!solution) return std::nullopt;
    for (std::size_t k = 0; k < layout.modes; ++k) shifts[k][r] = (*solution)[k];
  }
  ObservedFrequencies frequencies;
  for (std::size_t k = 0; k < layout.modes; ++k) {
    std::vector<numeric> row(layout.frequencies(), 0);
    row[k] = 1;
    for (std::size_t r = 0; r < layout.relations; ++r) {
      std::vector<int> single(layout.relations, 0);
      single[r] = 1;
      const Phase relation = d.lattice.phase_of(single);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] + shifts[k][r] * relation[i];
    }
    frequencies.of_mode.push_back(std::move(row));
  }
  return frequencies;
}

bool orient(Phase& phase, const Derivation& d) {
  const double frequency = nominal_frequency(phase, d);
  bool turn = frequency < 0;
  if (std::isnan(frequency) || frequency == 0) {
    const auto first = std::find_if(phase.begin(), phase.end(), [](int p) { return p != 0; });
    turn = first != phase.end() && *first < 0;
  }
  if (turn)
    for (int& multiple : phase) multiple = -multiple;
  return turn;
}

LumpEquations lump_equations(const Derivation& nominal, const Derivation& kept) {
  const Model& model = *nominal.model;
  const auto frequencies = observed_frequencies(nominal);
  if (!frequencies)
    throw InputError(model.file, "case " + nominal.resonance->name,
                     "no rotating frame makes its modulation equations autonomous",
                     "its relations are incommensurate: estimation needs one steady state per excitation");
  LumpEquations result;
  result.frequencies = *frequencies;
  LumpFinder finder(model);
  for (std::size_t k = 0; k < nominal.layout.modes; ++k) {
    if (nominal.resonance->mode_at_rest[k]) continue;
    LumpEquation block;
    block.mode = k;
    if (!append_terms(block, finder, nominal, terms_of(nominal.modulation(k))))
      throw InputError(model.file, "case " + nominal.resonance->name,
                       "a lump depends on an excitation frequency that no relation fixes",
                       "relate the excitation frequency to a natural one");
    if (!block.columns.empty()) result.blocks.push_back(std::move(block));
  }
  for (std::size_t k = 0; k < nominal.layout.modes; ++k) {
    std::vector<std::vector<std::pair<FieldKey, ex>>> kept_terms, nominal_terms;
    std::vector<LumpEquation> kept_blocks = harmonic_blocks(kept, *frequencies, k, kept_terms);
    std::vector<LumpEquation> nominal_blocks = harmonic_blocks(nominal, *frequencies, k, nominal_terms);
    for (std::size_t b = 0; b < nominal_blocks.size(); ++b) {
      // The same observed frequency in both derivations.
      const auto seen = frequencies->of_phase(nominal_blocks[b].phase);
      const auto same = std::find_if(kept_blocks.begin(), kept_blocks.end(), [&](const LumpEquation& block) {
        return frequencies->of_phase(block.phase) == seen;
      });
      const std::size_t lumps_before = finder.size();
      if (same != kept_blocks.end()) {
        LumpEquation attempt = *same;
        if (append_terms(attempt, finder, kept, kept_terms[static_cast<std::size_t>(same - kept_blocks.begin())])) {
          result.blocks.push_back(std::move(attempt));
          continue;
        }
        finder.forget_after(lumps_before);
      }
      if (append_terms(nominal_blocks[b], finder, nominal, nominal_terms[b]))
        result.blocks.push_back(std::move(nominal_blocks[b]));
    }
  }
  result.lumps = finder.lumps();
  return result;
}

}  // namespace secular
