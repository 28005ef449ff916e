#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/derivation.hpp"
#include "perturb/nonsmooth.hpp"
#include "perturb/ordered_equation.hpp"
#include "perturb/prime_field.hpp"

namespace secular {
namespace {

class MultipleScales {
 public:
  explicit MultipleScales(Derivation& derivation)
      : d_(derivation),
        layout_(derivation.layout),
        equations_(ordered_equations(*derivation.model, *derivation.resonance)),
        highest_(derivation.resonance->expand_to) {
    for (std::size_t i = 0; i < layout_.modes; ++i) frequencies_.push_back(d_.model->frequency(i));
    for (std::size_t j = 0; j < layout_.excitations; ++j)
      frequencies_.push_back(nominal() ? d_.lattice.resonant_frequency(j) : d_.model->frequency(layout_.modes + j));
  }

  void run() {
    const auto size = static_cast<std::size_t>(highest_) + 1;
    d_.response.assign(layout_.modes, FieldSeries(size));
    d_.slow_derivative.assign(layout_.modes, FieldSeries(size));
    for (std::size_t k = 0; k < layout_.modes; ++k) leading_order(k);
    for (std::size_t k = 0; k < layout_.modes; ++k) set_quadratures_apart(k);
    limit_nonsmooth_harmonics();
    SeriesCache cache(*this);
    for (int order = 1; order <= highest_; ++order) {
      if (order > 1) cache.update(*this, order - 1);  // now that it is solved
      cache.update(*this, order);
      std::vector<Field> forcing(layout_.modes);
      for (std::size_t k = 0; k < layout_.modes; ++k)
        forcing[k] = right_hand_side(k, order, cache).with_moduli_joined(layout_);
      for (std::size_t k = 0; k < layout_.modes; ++k) solve(k, order, forcing[k]);
    }
    write_out_divisors();
  }

 private:
  bool nominal() const { return d_.policy == OmegaPolicy::nominal; }

  // Every mode and excitation with its first two time derivatives, as far as they are known.
  struct SeriesCache {
    explicit SeriesCache(const MultipleScales& m) {
      const FieldSeries nothing(static_cast<std::size_t>(m.highest_) + 1);
      coordinate.assign(m.layout_.modes, std::vector<FieldSeries>(3, nothing));
      update(m, 0);
      for (std::size_t j = 0; j < m.layout_.excitations; ++j) {
        excitation.emplace_back(3, nothing);
        std::vector<FieldSeries>& wave = excitation.back();
        wave[0][0] = m.harmonic_wave(j, 1, GiNaC::numeric(1, 2), true);
        for (std::size_t derivative = 1; derivative < wave.size(); ++derivative)
          for (int order = 0; order <= m.highest_; ++order)
            wave[derivative][static_cast<std::size_t>(order)] = m.time_derivative(wave[derivative - 1], order);
      }
    }

    // What the response is by now at eps^order. Lower orders, once solved, stay as they are.
    void update(const MultipleScales& m, int order) {
      const auto n = static_cast<std::size_t>(order);
      for (std::size_t k = 0; k < coordinate.size(); ++k) {
        coordinate[k][0][n] = m.d_.response[k][n];
        for (std::size_t derivative = 1; derivative < coordinate[k].size(); ++derivative)
          coordinate[k][derivative][n] = m.time_derivative(coordinate[k][derivative - 1], order);
      }
    }

    std::vector<std::vector<FieldSeries>> coordinate, excitation;  // [index][derivative]
  };

  // coefficient*exp(i*multiple*Omega*t) + conjugate, with or without the amplitude F.
  Field harmonic_wave(std::size_t excitation, int multiple, const GiNaC::ex& coefficient, bool amplitude) const {
    Field wave;
    for (const int sign : {1, -1}) {
      FieldKey key(layout_.size(), 0);
      key[layout_.modes + excitation] = sign * multiple;
      if (amplitude) key[layout_.forcing(excitation)] = 1;
      wave.add(key, sign > 0 ? coefficient : coefficient.conjugate());
    }
    return wave;
  }

  GiNaC::ex fast_frequency(const FieldKey& key) const {
    GiNaC::ex sum = 0;
    for (std::size_t i = 0; i < layout_.frequencies(); ++i)
      if (key[i] != 0) sum += key[i] * frequencies_[i];
    return sum.expand();
  }

  // D_0: every term times i*(phase.f).
  Field fast_derivative(const Field& field) const {
    Field result;
    for (const auto& [key, coefficient] : field.terms()) {
      const GiNaC::ex frequency = fast_frequency(key);
      if (!frequency.is_zero()) result.add(key, (coefficient * GiNaC::I * frequency).expand());
    }
    return result;
  }

  // Rate of the explicit slow phases on scale T_n: detunings in the slow part, and (nominal policy) what each
  // excitation frequency has beyond its resonant value.
  GiNaC::ex explicit_slow_rate(const FieldKey& key, int n) const {
    GiNaC::ex rate = 0;
    for (std::size_t r = 0; r < layout_.relations; ++r) {
      const ResonanceRelation& relation = d_.resonance->relations[r];
      if (relation.detuning.empty() || relation.order != n) continue;
      GiNaC::numeric multiple = relation.coefficient * key[layout_.slow(r)];
      if (nominal())
        for (std::size_t j = 0; j < layout_.excitations; ++j)
          multiple += d_.lattice.resonant_offset(j)[r] * key[layout_.modes + j];
      if (!multiple.is_zero()) rate += multiple * d_.model->symbols.at(relation.detuning);
    }
    return rate;
  }

  // D_n for n >= 1: chain rule through A, conj A, |A| with the D_n A known so far, and the explicit slow phases.
  Field slow_derivative(const Field& field, int n) const {
    Field result;
    const auto scale = static_cast<std::size_t>(n);
    for (const auto& [key, coefficient] : field.terms()) {
      const GiNaC::ex rate = explicit_slow_rate(key, n);
      if (!rate.is_zero()) result.add(key, (coefficient * GiNaC::I * rate).expand());
      for (std::size_t k = 0; k < layout_.modes; ++k) {
        const Field& forward = d_.slow_derivative[k][scale];
        if (forward.empty()) continue;
        const auto chain = [&](std::size_t lowered, int by, const GiNaC::ex& factor, const Field& derivative,
                               std::size_t raised) {
          Field one;
          FieldKey lower = key;
          lower[lowered] -= by;
          if (raised != lowered) ++lower[raised];
          one.add(lower, (coefficient * factor).expand());
          result += one * derivative;
        };
        if (const int power = key[layout_.amplitude(k)])
          chain(layout_.amplitude(k), 1, power, forward, layout_.amplitude(k));
        const int conjugate_power = key[layout_.conjugate(k)], modulus_power = key[layout_.modulus(k)];
        if (conjugate_power == 0 && modulus_power == 0) continue;
        const Field backward = forward.conjugated(layout_);
        if (conjugate_power) chain(layout_.conjugate(k), 1, conjugate_power, backward, layout_.conjugate(k));
        if (modulus_power) {
          // D|A| = (conj(A) DA + A D conj(A)) / (2|A|)
          const GiNaC::ex half = GiNaC::numeric(modulus_power, 2);
          chain(layout_.modulus(k), 2, half, forward, layout_.conjugate(k));
          chain(layout_.modulus(k), 2, half, backward, layout_.amplitude(k));
        }
      }
    }
    return result.with_moduli_joined(layout_);
  }

  // The time derivative's part at eps^order: sum of D_n of the parts at eps^(order - n).
  Field time_derivative(const FieldSeries& series, int order) const {
    Field result = fast_derivative(series[static_cast<std::size_t>(order)]);
    for (int n = 1; n <= order; ++n) {
      const Field& lower = series[static_cast<std::size_t>(order - n)];
      if (!lower.empty()) result += slow_derivative(lower, n);
    }
    return result;
  }

  void leading_order(std::size_t k) {
    Field& field = d_.response[k][0];
    if (!d_.resonance->mode_at_rest[k])
      for (const int sign : {1, -1}) {
        FieldKey key(layout_.size(), 0);
        key[k] = sign;
        key[sign > 0 ? layout_.amplitude(k) : layout_.conjugate(k)] = 1;
        field.add(key, 1);
      }
    // Hard forcing: excitation terms at order 0.
    const SeriesCache cache(*this);
    const Field forcing = right_hand_side(k, 0, cache);
    for (const auto& [key, coefficient] : forcing.terms()) {
      if (d_.lattice.slow_multipliers(relative_phase(key, k)))
        throw InputError(d_.model->file, place(),
                         "forcing of order eps^0 excites mode '" + d_.model->modes[k].coordinate + "' at resonance",
                         "give the coefficient of the direct excitation a positive order");
      field.add(key, coefficient * inverse_divisor(key, k));
    }
  }

  Phase relative_phase(const FieldKey& key, std::size_t k) const {
    Phase phase = d_.full_phase(key);
    --phase[k];
    return phase;
  }

  // 1/(omega_k^2 - (phase.f)^2), factored so that it stays small.
  GiNaC::ex inverse_divisor(const FieldKey& key, std::size_t k) {
    const GiNaC::ex frequency = fast_frequency(key);
    const GiNaC::ex low = (frequencies_[k] - frequency).expand(), high = (frequencies_[k] + frequency).expand();
    if (low.is_zero() || high.is_zero())
      throw InputError(d_.model->file, place(), "division by zero for mode '" + d_.model->modes[k].coordinate + "'",
                       "the relations hide a resonance: list it");
    return inverse(low) * inverse(high);
  }

  // 1/frequency. While the expansion runs a symbol stands for the inverse of a sum: GiNaC goes through the sum at
  // every evaluation of a product with it, a third of all time.
  GiNaC::ex inverse(const GiNaC::ex& frequency) {
    const GiNaC::ex reciprocal = 1 / frequency;  // number * (sum with coefficients in lowest terms)^-1
    if (!GiNaC::is_a<GiNaC::add>(frequency)) return reciprocal;
    const bool scaled = GiNaC::is_a<GiNaC::mul>(reciprocal);
    const GiNaC::ex power = scaled ? reciprocal.op(0) : reciprocal;
    const auto [position, added] = inverse_of_sum_.try_emplace(power);
    if (added) {
      const GiNaC::realsymbol symbol;
      position->second = symbol;
      sum_behind_[symbol] = power;
      point_.define(symbol, power);
    }
    return (scaled ? reciprocal.op(1) : GiNaC::ex(1)) * position->second;
  }

  void write_out_divisors() {
    if (sum_behind_.empty()) return;
    for (auto* fields : {&d_.response, &d_.slow_derivative})
      for (FieldSeries& series : *fields)
        for (Field& field : series) field = field.with_symbols(sum_behind_);
  }

  // What the equation of mode k has at eps^order besides its own oscillator and D_order A, all moved to the right.
  Field right_hand_side(std::size_t k, int order, const SeriesCache& cache) const {
    Field sum;
    if (order > 0) sum += cache.coordinate[k][2][static_cast<std::size_t>(order)].scaled(-1);
    for (const OrderedTerm& term : equations_[k].right_hand_side) {
      if (term.order > order) continue;
      sum += product(term.factors, order - term.order, cache).scaled(term.coefficient);
    }
    return sum;
  }

  Field product(const FactorProduct& factors, int order, const SeriesCache& cache) const {
    std::vector<FieldSeries> made;  // clocks and nonsmooth factors, not in the cache
    made.reserve(factors.size());
    std::vector<const FieldSeries*> series;
    bool nonsmooth = false;
    for (const auto& [factor, power] : factors) {
      const auto index = static_cast<std::size_t>(factor.index);
      const auto derivative = static_cast<std::size_t>(factor.derivative);
      const FieldSeries* one = nullptr;
      switch (factor.kind) {
        case Factor::Kind::coordinate:
          one = &cache.coordinate[index][derivative];
          break;
        case Factor::Kind::excitation:
          one = &cache.excitation[index][derivative];
          break;
        case Factor::Kind::clock_cos:
          made.push_back({harmonic_wave(index, factor.multiple, GiNaC::numeric(1, 2), false)});
          break;
        case Factor::Kind::clock_sin:
          made.push_back({harmonic_wave(index, factor.multiple, -GiNaC::I / 2, false)});
          break;
        case Factor::Kind::absolute:
        case Factor::Kind::sign:
          nonsmooth = true;
          break;
      }
      if (factor.nonsmooth()) continue;
      if (!one) one = &made.back();
      series.insert(series.end(), static_cast<std::size_t>(power), one);
    }
    if (!nonsmooth) {
      if (series.empty()) {
        Field unit;
        if (order == 0) unit.add(FieldKey(layout_.size(), 0), 1);
        return unit;
      }
      return product_at_order(series, order);
    }
    return nonsmooth_product(factors, std::move(series), order, cache);
  }

  // One nonsmooth factor times smooth ones. Harmonics up to highest_nonsmooth_harmonic are exact, because the
  // nonsmooth factor is taken further by as much as the smooth ones can shift it. With x = x0 + eps x1 + ...:
  // |x| = |x0| + eps sgn(x0) x1 + ...
  Field nonsmooth_product(const FactorProduct& factors, std::vector<const FieldSeries*> series, int order,
                          const SeriesCache& cache) const {
    for (const auto& [factor, power] : factors) {
      if (!factor.nonsmooth()) continue;
      const auto mode = static_cast<std::size_t>(factor.index);
      if (d_.resonance->mode_at_rest[mode]) return {};
      const FieldSeries& argument = cache.coordinate[mode][static_cast<std::size_t>(factor.derivative)];
      int shift = 0;
      for (const FieldSeries* smooth : series) shift += largest_harmonic(*smooth, mode, order);
      const int highest =
          highest_nonsmooth_harmonic + shift + (order > 0 ? largest_harmonic(argument, mode, order) : 0);
      FieldSeries nonsmooth{nonsmooth_harmonics(factor, layout_, frequencies_[mode], highest)};
      if (order > 0) {
        Factor slope = factor;
        slope.kind = Factor::Kind::sign;
        nonsmooth.push_back(nonsmooth_harmonics(slope, layout_, frequencies_[mode], highest) * argument[1]);
      }
      series.push_back(&nonsmooth);
      Field exact;
      const Field product = product_at_order(series, order);
      for (const auto& [key, coefficient] : product.terms())
        if (std::abs(key[mode]) <= highest_nonsmooth_harmonic) exact.add(key, coefficient);
      return exact.with_moduli_joined(layout_);
    }
    return {};
  }

  static int largest_harmonic(const FieldSeries& series, std::size_t mode, int order) {
    int largest = 0;
    for (std::size_t n = 0; n <= static_cast<std::size_t>(order) && n < series.size(); ++n)
      for (const auto& [key, ignored] : series[n].terms()) largest = std::max(largest, std::abs(key[mode]));
    return largest;
  }

  // Moves nonsmooth terms without a closed Fourier series from the equation to the quadratures; refuses those that
  // would have to be expanded further.
  void set_quadratures_apart(std::size_t k) {
    std::vector<OrderedTerm> kept;
    for (const OrderedTerm& term : equations_[k].right_hand_side) {
      int count = 0;
      const Factor* nonsmooth = nullptr;
      for (const auto& [factor, power] : term.factors)
        if (factor.nonsmooth()) {
          count += power;
          nonsmooth = &factor;
        }
      if (count == 0) {
        kept.push_back(term);
        continue;
      }
      const std::string text = to_string(term.factors, *d_.model);
      if (count > 1)
        throw InputError(d_.model->file, place(), "term " + text + " multiplies nonsmooth functions",
                         "write abs(x)^2 as x^2, sgn(x)^2 as 1 and abs(x)*sgn(x) as x");
      const auto refuse_before_highest_order = [&](const std::string& why) {
        if (term.order < highest_)
          throw InputError(
              d_.model->file, place(),
              fmt::format("nonsmooth term {} enters at eps^{}, below the order of expansion {}, and {}", text,
                          term.order, highest_, why),
              fmt::format("give its coefficient order {}, or set expand_to = {}", highest_, term.order));
      };
      if (nonsmooth->compound() || has_several_harmonics(static_cast<std::size_t>(nonsmooth->index))) {
        refuse_before_highest_order("goes to quadrature, which is not expanded further");
        d_.quadratures.push_back({k, term.order, term.coefficient, term.factors});
        continue;
      }
      if (highest_ - term.order > 1) refuse_before_highest_order("its second derivative is not a function");
      if (nonsmooth->kind == Factor::Kind::sign)
        refuse_before_highest_order("the derivative of sgn is not a function");
      if (term.order < 2) refuse_before_highest_order("its correction is a sum over infinitely many harmonics");
      kept.push_back(term);
    }
    equations_[k].right_hand_side = std::move(kept);
  }

  // A nonsmooth term's harmonics end at highest_nonsmooth_harmonic. A later term of degree d that holds one of them
  // and d - 1 leading oscillations is complete up to d - 1 harmonics less.
  void limit_nonsmooth_harmonics() {
    const auto size = static_cast<std::size_t>(highest_) + 1;
    std::vector<bool> present(size, false);
    d_.nonsmooth_harmonics.assign(size, highest_nonsmooth_harmonic);
    for (std::size_t n = 0; n < size; ++n)
      for (const OrderedEquation& equation : equations_)
        for (const OrderedTerm& term : equation.right_hand_side) {
          const auto order = static_cast<std::size_t>(term.order);
          int degree = 0;
          bool nonsmooth = false;
          for (const auto& [factor, power] : term.factors) {
            nonsmooth = nonsmooth || factor.nonsmooth();
            if (factor.kind == Factor::Kind::coordinate) degree += power;
          }
          if (nonsmooth) present[n] = present[n] || order <= n;
          if (order == 0 || order > n || !present[n - order]) continue;
          present[n] = true;
          d_.nonsmooth_harmonics[n] =
              std::min(d_.nonsmooth_harmonics[n], d_.nonsmooth_harmonics[n - order] - std::max(0, degree - 1));
          if (d_.nonsmooth_harmonics[n] < 1)
            throw InputError(d_.model->file, place(),
                             fmt::format("at eps^{} nonsmooth terms need harmonics above the {}th", n,
                                         highest_nonsmooth_harmonic),
                             "expand to a lower order");
        }
  }

  bool beyond_nonsmooth_harmonics(const FieldKey& key, std::size_t order) const {
    bool nonsmooth = false, beyond = false;
    for (std::size_t k = 0; k < layout_.modes; ++k) {
      nonsmooth = nonsmooth || key[layout_.modulus(k)] % 2 != 0;
      beyond = beyond || std::abs(key[k]) > d_.nonsmooth_harmonics[order];
    }
    return nonsmooth && beyond;
  }

  bool has_several_harmonics(std::size_t mode) const {
    const std::map<FieldKey, GiNaC::ex>& leading = d_.response[mode][0].terms();
    return leading.size() > (d_.resonance->mode_at_rest[mode] ? 0U : 2U);
  }

  void solve(std::size_t k, int order, const Field& forcing) {
    const auto n = static_cast<std::size_t>(order);
    for (const auto& [key, raw] : forcing.terms()) {
      const GiNaC::ex coefficient = cleaned(raw);
      if (coefficient.is_zero()) continue;
      if (const auto multipliers = d_.lattice.slow_multipliers(relative_phase(key, k))) {
        if (d_.resonance->mode_at_rest[k])
          throw InputError(
              d_.model->file, place(),
              "mode '" + d_.model->modes[k].coordinate + "' is listed in modes_at_rest but is excited at resonance",
              "remove it from modes_at_rest");
        FieldKey slow = key;
        for (std::size_t i = 0; i < layout_.frequencies(); ++i) slow[i] = 0;
        for (std::size_t r = 0; r < layout_.relations; ++r) slow[layout_.slow(r)] = (*multipliers)[r];
        // -2 i omega_k D_n A_k + coefficient = 0
        d_.slow_derivative[k][n].add(slow, (coefficient / (2 * GiNaC::I * frequencies_[k])).expand());
        continue;
      }
      Phase opposite = d_.full_phase(key);
      for (int& multiple : opposite) multiple = -multiple;
      --opposite[k];
      if (d_.lattice.slow_multipliers(opposite)) continue;  // conjugate of a secular term
      if (beyond_nonsmooth_harmonics(key, n)) continue;
      warn_if_nearly_resonant(key, k, order);
      d_.response[k][n].add(key, cleaned(coefficient * inverse_divisor(key, k)));
    }
  }

  // A zero may hide behind different denominators.
  GiNaC::ex cleaned(const GiNaC::ex& coefficient) {
    const GiNaC::ex expanded = coefficient.expand();
    return point_.vanishes(expanded) ? GiNaC::ex(0) : expanded;
  }

  void warn_if_nearly_resonant(const FieldKey& key, std::size_t k, int order) {
    const auto nominal_value = [&](std::size_t i) {
      const auto entry = d_.model->nominal.find(d_.model->frequency_name(i));
      return entry == d_.model->nominal.end() ? std::numeric_limits<double>::quiet_NaN() : entry->second;
    };
    double phase_frequency = 0;
    std::string text;
    const Phase phase = d_.full_phase(key);
    for (std::size_t i = 0; i < phase.size(); ++i) {
      if (phase[i] == 0) continue;
      double value = nominal_value(i);
      if (i >= layout_.modes && std::isnan(value)) {
        GiNaC::exmap numbers;
        for (std::size_t j = 0; j < layout_.modes; ++j)
          if (!std::isnan(nominal_value(j))) numbers[d_.model->frequency(j)] = nominal_value(j);
        const GiNaC::ex resonant = d_.lattice.resonant_frequency(i - layout_.modes).subs(numbers).evalf();
        if (GiNaC::is_a<GiNaC::numeric>(resonant)) value = GiNaC::ex_to<GiNaC::numeric>(resonant).to_double();
      }
      phase_frequency += phase[i] * value;
      text += fmt::format("{}{}*{}", phase[i] < 0 ? " - " : (text.empty() ? "" : " + "), std::abs(phase[i]),
                          d_.model->frequency_name(i));
    }
    const double omega = nominal_value(k), ratio = 1 - std::abs(phase_frequency) / omega;
    if (!(std::abs(ratio) < 0.05)) return;
    const std::string warning = fmt::format(
        "at order eps^{} the phase {} excites mode {} within {:.1f} % of its natural frequency: its small divisor "
        "makes "
        "the expansion unreliable. If it is a resonance, list it: relations = [{}\"{}\"]",
        order, text, d_.model->modes[k].coordinate, 100 * std::abs(ratio), listed_relations(),
        missing_relation(phase, k, phase_frequency < 0));
    if (std::find(d_.warnings.begin(), d_.warnings.end(), warning) == d_.warnings.end())
      d_.warnings.push_back(warning);
  }

  std::string listed_relations() const {
    std::string list;
    for (const ResonanceRelation& relation : d_.resonance->relations) list += "\"" + relation.text + "\", ";
    return list;
  }

  // The relation that a near resonance phase.f = omega_k (or -omega_k) lacks, solved for its last frequency.
  std::string missing_relation(Phase relation, std::size_t k, bool opposite) const {
    if (opposite)
      for (int& multiple : relation) multiple = -multiple;
    --relation[k];
    std::size_t last = relation.size() - 1;
    while (last > 0 && relation[last] == 0) --last;
    if (relation[last] > 0)
      for (int& multiple : relation) multiple = -multiple;
    std::string right;
    for (std::size_t i = 0; i < last; ++i) {
      if (relation[i] == 0) continue;
      right += (relation[i] < 0 ? (right.empty() ? "-" : " - ") : (right.empty() ? "" : " + "));
      right += (std::abs(relation[i]) == 1 ? "" : std::to_string(std::abs(relation[i])) + "*") +
               d_.model->frequency_name(i);
    }
    std::string detuning = "sigma";
    for (int n = 2; d_.model->symbols.contains(detuning); ++n) detuning = "sigma" + std::to_string(n);
    return fmt::format("{}{} = {} + eps^{}*{}", relation[last] == -1 ? "" : std::to_string(-relation[last]) + "*",
                       d_.model->frequency_name(last), right, highest_, detuning);
  }

  std::string place() const {
    return "line " + std::to_string(d_.resonance->line) + ", case " + d_.resonance->name;
  }

  Derivation& d_;
  FieldLayout layout_;
  std::vector<OrderedEquation> equations_;
  int highest_;
  std::vector<GiNaC::ex> frequencies_;
  RandomPoint point_;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> inverse_of_sum_;  // power -1 of a sum to its symbol
  GiNaC::exmap sum_behind_;                                           // and back
};

}  // namespace

Field Derivation::modulation(std::size_t mode) const {
  Field sum;
  for (const Field& field : slow_derivative[mode]) sum += field;
  return sum;
}

GiNaC::ex Derivation::quadrature_rate(const QuadratureTerm& quadrature) const {
  return (quadrature.coefficient / (2 * GiNaC::I * model->frequency(quadrature.mode))).expand();
}

Phase Derivation::full_phase(const FieldKey& key) const {
  std::vector<int> multipliers(layout.relations);
  for (std::size_t r = 0; r < layout.relations; ++r) multipliers[r] = key[layout.slow(r)];
  Phase phase = lattice.phase_of(multipliers);
  for (std::size_t i = 0; i < phase.size(); ++i) phase[i] += key[i];
  return phase;
}

Derivation derive(const Model& model, const ResonanceCase& resonance, OmegaPolicy policy) {
  Derivation derivation{&model,
                        &resonance,
                        policy,
                        FieldLayout{model.modes.size(), model.excitations.size(), resonance.relations.size()},
                        ResonanceLattice(model, resonance),
                        {},
                        {},
                        {},
                        {},
                        {}};
  MultipleScales(derivation).run();
  return derivation;
}

}  // namespace secular
