#include "perturb/lump_equations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/factored_fraction.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/prime_field.hpp"
#include "perturb/rest_position.hpp"
#include "numerics/row_reduction.hpp"

namespace secular {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

std::vector<std::string> coefficient_names(const Model& model) {
  std::vector<std::string> names = model.parameters;
  if (model.rest)
    for (const RestValue& value : model.rest->values) names.push_back(value.name);
  return names;
}

class LumpFinder {
 public:
  LumpFinder(const Model& model, FractionSums& sums)
      : model_(model), sums_(sums), names_(coefficient_names(model)), first_(point(1)), second_(point(2)) {
    for (const std::string& name : names_) parameters_.push_back(sums.place(model.symbols.at(name)));
    for (const Shorthand& shorthand : model.shorthands)
      named_.push_back(candidate(
          shorthand.name, read(formula_value(shorthand.expression, shorthand.source,
                                             [&](const Expression& s) { return ex(model.symbols.at(s.text)); }))));
  }

  struct Split {
    std::size_t lump;
    std::vector<FactoredFraction> factor;
  };

  // coefficient = sum of factor(frequencies) * lump: one where possible; where one lump would depend on an
  // excitation frequency a sum, if the frequency `is_free`. Nothing if it would even so.
  std::vector<Split> split(const FractionTerms& coefficient, const std::string& fallback_name, bool is_free) {
    if (auto one = single_split(coefficient, fallback_name)) return {std::move(*one)};
    return is_free ? split_by_products(coefficient) : std::vector<Split>();
  }

  std::vector<Lump> lumps() const {
    std::vector<Lump> lumps;
    for (const Candidate& candidate : used_)
      lumps.push_back({candidate.name, sums_.expression(candidate.definition)});
    return lumps;
  }
  std::size_t size() const { return used_.size(); }
  void forget_after(std::size_t count) {
    used_.erase(used_.begin() + static_cast<std::ptrdiff_t>(count), used_.end());
  }

 private:
  // A definition with its values at two random points that differ in the parameters only.
  struct Candidate {
    std::string name;
    FractionTerms definition;
    PrimeFieldComplex first, second;
  };

  std::optional<Split> single_split(const FractionTerms& coefficient, const std::string& fallback_name) {
    std::vector<std::size_t> present;
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      if (sums_.has(coefficient, parameters_[p])) present.push_back(p);
    if (present.empty()) return Split{use(candidate("one", read(1))), sums_.parts(coefficient)};
    if (auto split = product_times_sum(coefficient)) return split;
    Candidate whole = candidate(fallback_name, coefficient);
    if (present.size() == 1) {
      const std::string& name = names_[present.front()];
      Candidate single = candidate(name, read(model_.symbols.at(name)));
      if (auto ratio = proportion(whole, single)) return Split{use(std::move(single)), {std::move(*ratio)}};
    }
    for (const std::vector<Candidate>* candidates : {&named_, &used_})
      for (const Candidate& other : *candidates)
        if (auto ratio = proportion(whole, other)) return Split{use(other), {std::move(*ratio)}};
    for (const Excitation& excitation : model_.excitations)
      if (sums_.has(coefficient, sums_.place(model_.symbols.at(excitation.frequency)))) return std::nullopt;
    return Split{use(std::move(whole)), {sums_.sum(read(1))}};
  }

  // Each product of parameters is a lump and what stands with it its factor. None where a divisor holds a
  // parameter.
  std::vector<Split> split_by_products(const FractionTerms& coefficient) {
    std::map<std::vector<int>, FractionTerms> of_product;
    for (FractionTerm term : coefficient) {
      std::vector<int> product(term.powers.size(), 0);
      for (const std::size_t place : parameters_) product[place] = std::exchange(term.powers[place], 0);
      of_product[product].push_back(std::move(term));
    }
    std::vector<Split> splits;
    for (const auto& [powers, frequencies] : of_product) {
      if (holds_parameters(frequencies)) return {};
      std::vector<FactoredFraction> factor = sums_.parts(frequencies);
      if (!factor.empty()) splits.push_back({use_product(powers), std::move(factor)});
    }
    return splits;
  }

  FractionTerms read(const ex& definition) {
    std::optional<FractionTerms> terms = sums_.terms(definition.expand());
    if (!terms) throw std::logic_error("a lump is not rational in the model's symbols");
    return std::move(*terms);
  }

  Candidate candidate(std::string name, FractionTerms definition) {
    const PrimeFieldComplex first = first_.value(definition), second = second_.value(definition);
    return {std::move(name), std::move(definition), first, second};
  }

  // A product of parameters times a sum of frequencies that takes several fractions to write: the product is the
  // lump. Ratios of such sums would have one of them multiplied out as their denominator.
  std::optional<Split> product_times_sum(const FractionTerms& coefficient) {
    FractionTerms frequencies = coefficient;
    std::vector<int> product(coefficient.front().powers.size(), 0);
    for (const std::size_t place : parameters_) {
      product[place] = coefficient.front().powers[place];
      for (FractionTerm& term : frequencies)
        if (std::exchange(term.powers[place], 0) != product[place]) return std::nullopt;
    }
    if (holds_parameters(frequencies)) return std::nullopt;
    std::vector<FactoredFraction> factor = sums_.parts(frequencies);
    if (factor.size() < 2) return std::nullopt;
    return Split{use_product(product), std::move(factor)};
  }

  bool holds_parameters(const FractionTerms& terms) const {
    return std::any_of(parameters_.begin(), parameters_.end(),
                       [&](std::size_t parameter) { return sums_.has(terms, parameter); });
  }

  // The lump that is a product of parameters: a parameter, or product_a_b2. `powers`: of all symbols.
  std::size_t use_product(const std::vector<int>& powers) {
    std::string name = "product";
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      if (const int power = powers[parameters_[p]]; power != 0)
        name += "_" + names_[p] + (power == 1 ? "" : (power < 0 ? "m" : "") + std::to_string(std::abs(power)));
    const bool single =
        std::accumulate(powers.begin(), powers.end(), 0) == 1 &&
        std::count(powers.begin(), powers.end(), 0) + 1 == static_cast<std::ptrdiff_t>(powers.size());
    return use(candidate(single ? name.substr(8) : name, {FractionTerm{1, 0, powers, {}}}));
  }

  // All symbols from draw 0, parameters from the one given.
  FractionPoint point(std::uint64_t parameter_draw) const {
    std::vector<PrimeFieldComplex> values(model_.symbols.names().size() + 1, random_value("Pi", 0));
    for (const std::string& name : model_.symbols.names())
      values[sums_.place(model_.symbols.at(name))] = random_value(name, 0);
    for (const std::string& name : names_)
      values[sums_.place(model_.symbols.at(name))] = random_value(name, parameter_draw);
    return FractionPoint(sums_, std::move(values));
  }

  // The sum with numbers for parameters; none for a division by zero.
  std::optional<FactoredFraction> at(const FractionTerms& terms, const std::vector<long>& values) {
    FractionTerms result;
    for (const FractionTerm& term : terms) {
      FractionTerm rest = term;
      for (std::size_t p = 0; p < parameters_.size(); ++p) {
        int& power = rest.powers[parameters_[p]];
        if (power < 0 && values[p] == 0) return std::nullopt;
        if (power != 0) rest.real = rest.real * cln::expt(cln::cl_RA(values[p]), power);
        power = 0;
      }
      result.push_back(std::move(rest));
    }
    if (std::none_of(parameters_.begin(), parameters_.end(),
                     [&](std::size_t parameter) { return sums_.has(result, parameter); }))
      return sums_.sum(result);
    GiNaC::exmap numbers;  // parameters in divisors
    for (std::size_t p = 0; p < parameters_.size(); ++p) numbers[model_.symbols.at(names_[p])] = values[p];
    try {
      return sums_.sum(read(sums_.expression(result).subs(numbers, GiNaC::subs_options::no_pattern)));
    } catch (const GiNaC::pole_error&) {
      return std::nullopt;
    }
  }

  // The ratio of two sums if it is free of parameters. Decided at the random points; then parameters that show the
  // ratio are put in, so that a common denominator of frequencies alone is formed.
  std::optional<FactoredFraction> proportion(const Candidate& above, const Candidate& below_it) {
    if (below_it.first.is_zero() || above.first * below_it.second != above.second * below_it.first)
      return std::nullopt;
    const auto ratio = [&](const std::vector<long>& values) -> std::optional<FactoredFraction> {
      const std::optional<FactoredFraction> below = at(below_it.definition, values);
      if (!below || below->is_zero()) return std::nullopt;
      const std::optional<FactoredFraction> numerator = at(above.definition, values);
      if (!numerator) return std::nullopt;
      return sums_.quotient(*numerator, *below);
    };
    for (std::size_t chosen = 0; chosen < parameters_.size(); ++chosen) {
      if (!sums_.has(below_it.definition, parameters_[chosen])) continue;
      std::vector<long> values(parameters_.size(), 0);
      values[chosen] = 1;
      if (auto found = ratio(values)) return found;
    }
    // Every single parameter alone makes it vanish, as in a product of two. A point may be a zero as well: for a
    // polynomial of degree d that of drawn integers is one with a chance of d over their range.
    std::vector<long> values(parameters_.size());
    std::iota(values.begin(), values.end(), 2L);
    std::mt19937_64 draw(1);
    for (int tried = 0; tried < most_points; ++tried) {
      if (auto found = ratio(values)) return found;
      for (long& value : values) value = 2 + static_cast<long>(draw() % drawn_range);
    }
    return std::nullopt;  // it stays a lump of its own
  }

  // Both arbitrary: at degree 100 all points are zeros with a chance of 1e-15.
  static constexpr int most_points = 16;
  static constexpr std::uint64_t drawn_range = 1000;

  std::size_t use(Candidate candidate) {
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (used_[i].name == candidate.name) return i;
    used_.push_back(std::move(candidate));
    return used_.size() - 1;
  }

  const Model& model_;
  FractionSums& sums_;
  std::vector<std::string> names_;  // of parameters, and of values at rest, which follow from them
  FractionPoint first_, second_;
  std::vector<std::size_t> parameters_;  // places of their symbols
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
  FractionTerms coefficient;  // free of detunings
  FactoredFraction
      detunings;       // in terms of the frequencies: sigma = (Omega - 2*omega0)/c for Omega = 2*omega0 + c*sigma
  std::string suffix;  // for names: "_sigma2"
};

// Detunings are known from measured frequencies, so that they belong to the columns and never to a lump.
std::vector<DetunedPart> without_detunings(const Derivation& d, FractionTerms coefficient, FractionSums& sums) {
  const auto fraction = [&](const ex& e) { return sums.sum(sums.terms(e).value()); };
  std::vector<DetunedPart> parts = {{std::move(coefficient), fraction(1), ""}};
  for (const ResonanceRelation& relation : d.resonance->relations) {
    if (relation.detuning.empty()) continue;
    const std::size_t sigma = sums.place(d.model->symbols.at(relation.detuning));
    std::vector<DetunedPart> next;
    for (DetunedPart& part : parts) {
      std::map<int, FractionTerms> by_power;
      for (FractionTerm& term : part.coefficient) {
        const int power = std::exchange(term.powers[sigma], 0);
        by_power[power].push_back(std::move(term));
      }
      for (auto& [power, alone] : by_power) {
        if (power == 0) {
          next.push_back({std::move(alone), part.detunings, part.suffix});
          continue;
        }
        ex value = 0;
        for (std::size_t i = 0; i < relation.multiples.size(); ++i)
          value += relation.multiples[i] * d.model->frequency(i);
        next.push_back({std::move(alone),
                        sums.product(part.detunings, fraction(GiNaC::pow(value / relation.coefficient, power))),
                        part.suffix + "_" + relation.detuning + (power == 1 ? "" : std::to_string(power))});
      }
    }
    parts = std::move(next);
  }
  return parts;
}

// A term of a field with its key, in a fixed order (by key). In the nominal derivation an excitation frequency that
// is left is one that no relation fixes; in the other one there are coefficients that are simpler without it.
bool append_terms(LumpEquation& block, LumpFinder& finder, const Derivation& d, FractionSums& sums,
                  const std::vector<std::pair<FieldKey, ex>>& terms, bool is_nominal) {
  for (const auto& [key, coefficient] : terms) {
    const std::optional<FractionTerms> whole = sums.terms(coefficient);
    if (!whole) throw std::logic_error("a coefficient is not rational in the model's symbols");
    for (const bool imaginary : {false, true}) {
      FractionTerms part = imaginary ? imaginary_part(*whole) : real_part(*whole);
      if (part.empty()) continue;
      const std::string kind = block.modulation ? (imaginary ? "conservative_" : "dissipative_")
                                                : (imaginary ? "harmonic_im_" : "harmonic_re_");
      const std::string name =
          kind + d.model->modes[block.mode].coordinate + "_" + powers_name(key, d.layout, *d.model);
      for (const DetunedPart& detuned : without_detunings(d, std::move(part), sums)) {
        auto splits = finder.split(detuned.coefficient, name + detuned.suffix, is_nominal);
        if (splits.empty()) return false;
        for (LumpFinder::Split& split : splits) {
          auto column = std::find_if(block.columns.begin(), block.columns.end(),
                                     [&](const LumpEquation::Column& c) { return c.lump == split.lump; });
          if (column == block.columns.end()) column = block.columns.insert(block.columns.end(), {split.lump, {}});
          for (FactoredFraction& factor : split.factor) factor = sums.product(factor, detuned.detunings);
          column->terms.push_back({std::move(split.factor), imaginary, key});
        }
      }
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

// Relation `r` joins excitations alone, as Omega2 = 2*Omega.
bool locks_excitations(const Derivation& d, std::size_t r) {
  const ResonanceRelation& relation = d.resonance->relations[r];
  const auto natural = relation.multiples.begin() + static_cast<std::ptrdiff_t>(d.layout.modes);
  return relation.detuning.empty() &&
         std::all_of(relation.multiples.begin(), natural, [](int m) { return m == 0; });
}

// Of every excitation its frequency, or those that it follows: the last one of a relation follows the others.
std::vector<std::vector<numeric>> excitation_rows(const Derivation& d) {
  const std::size_t all = d.layout.frequencies();
  std::vector<std::vector<numeric>> locks, result;
  for (std::size_t r = 0; r < d.layout.relations; ++r) {
    if (!locks_excitations(d, r)) continue;
    std::vector<numeric> backwards(all, 0);
    const std::vector<int>& multiples = d.resonance->relations[r].multiples;
    for (std::size_t i = 0; i < multiples.size(); ++i) backwards[all - 1 - i] = multiples[i];
    locks.push_back(std::move(backwards));
  }
  for (std::size_t i = d.layout.modes; i < all; ++i) {
    result.emplace_back(all, 0);
    result.back()[i] = 1;
  }
  for (const Pivot& pivot : reduce_rows(locks, 0, all)) {
    std::vector<numeric>& row = result[all - 1 - pivot.column - d.layout.modes];
    for (std::size_t i = 0; i < all; ++i) row[i] = i == all - 1 - pivot.column ? 0 : -locks[pivot.row][all - 1 - i];
  }
  return result;
}

}  // namespace

std::vector<numeric> ObservedFrequencies::of_phase(const Phase& phase) const {
  std::vector<numeric> row(phase.size(), 0);
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == 0) continue;
    const std::vector<numeric>& own = i < of_mode.size() ? of_mode[i] : of_excitation[i - of_mode.size()];
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = row[c] + phase[i] * own[c];
  }
  return row;
}

std::optional<ObservedFrequencies> observed_frequencies(const Derivation& d) {
  const FieldLayout& layout = d.layout;
  // Unknown x_k per relation: w_k = omega_k + sum_r x_kr * relation_r.
  std::vector<std::vector<numeric>> shifts(layout.modes, std::vector<numeric>(layout.relations, 0));
  for (std::size_t r = 0; r < layout.relations; ++r) {
    if (locks_excitations(d, r)) continue;  // its phase does not turn: no frame follows it
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
  ObservedFrequencies frequencies{{}, excitation_rows(d)};
  for (std::size_t k = 0; k < layout.modes; ++k) {
    std::vector<numeric> row(layout.frequencies(), 0);
    row[k] = 1;
    for (std::size_t r = 0; r < layout.relations; ++r) {
      std::vector<int> single(layout.relations, 0);
      single[r] = 1;
      const Phase relation = d.lattice.phase_of(single);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] + shifts[k][r] * relation[i];
    }
    for (std::size_t j = 0; j < layout.excitations; ++j) {
      const numeric share = std::exchange(row[layout.modes + j], numeric(0));
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] + share * frequencies.of_excitation[j][i];
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

LumpEquations lump_equations(const Derivation& nominal, const Derivation& kept, FractionSums& sums) {
  const Model& model = *nominal.model;
  const auto frequencies = observed_frequencies(nominal);
  if (!frequencies)
    throw InputError(
        model.file, "case " + nominal.resonance->name,
        "no rotating frame makes its modulation equations autonomous",
        "steady motion needs one: of two excitations that act on a mode, lock one to the other without a "
        "detuning, as in Omega2 = 2*Omega");
  LumpEquations result;
  result.frequencies = *frequencies;
  LumpFinder finder(model, sums);
  for (std::size_t k = 0; k < nominal.layout.modes; ++k) {
    if (nominal.resonance->mode_at_rest[k]) continue;
    LumpEquation block;
    block.mode = k;
    if (!append_terms(block, finder, nominal, sums, terms_of(nominal.modulation(k)), true))
      throw InputError(model.file, "case " + nominal.resonance->name,
                       "a coefficient stands in a divisor with an excitation frequency that no relation fixes",
                       "relate the excitation frequency to a natural one, or give that coefficient a higher order");
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
        if (append_terms(attempt, finder, kept, sums,
                         kept_terms[static_cast<std::size_t>(same - kept_blocks.begin())], false)) {
          result.blocks.push_back(std::move(attempt));
          continue;
        }
        finder.forget_after(lumps_before);
      }
      if (append_terms(nominal_blocks[b], finder, nominal, sums, nominal_terms[b], true))
        result.blocks.push_back(std::move(nominal_blocks[b]));
    }
  }
  result.lumps = finder.lumps();
  return result;
}

}  // namespace secular
