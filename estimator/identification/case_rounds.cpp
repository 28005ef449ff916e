// Regressions of all cases, which share natural frequencies and what is known.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/identification/estimation.hpp"
#include "input/input_error.hpp"
#include "input/nearest_word.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Cases are fitted again with the natural frequencies of all of them; the columns depend on those weakly.
constexpr int case_rounds = 2;

// What is no symbol may be a lump. The name alone does not say which one: each case that has it is named with what
// it stands for there.
std::string what_else_it_is(const CompiledModel& model, const std::string& name) {
  std::string lumps;
  int count = 0;
  for (const CompiledCase& resonance : model.cases)
    for (std::size_t l = 0; l < resonance.lumps.size(); ++l) {
      const LumpKey key = key_of(resonance, l);
      if (key.name != name) continue;
      lumps += (++count == 1 ? "" : "; ") + text_of(key) + " = " + std::string(resonance.lumps[l].definition);
    }
  if (count == 0) return "";
  return (count == 1 ? ", but a lump: " : ", but a lump of each of several cases: ") + lumps;
}

// A lump of one of the sets' cases, given as CASE:NAME.
bool is_lump_of(const std::vector<const ObservationSet*>& sets, const std::string& name) {
  return std::any_of(sets.begin(), sets.end(), [&](const ObservationSet* set) {
    for (std::size_t l = 0; l < set->resonance->lumps.size(); ++l)
      if (text_of(key_of(*set->resonance, l)) == name) return true;
    return false;
  });
}

std::string cases_in_use(const Estimation& e) {
  std::string names;
  for (const ObservationSet* set : e.sets) names += (names.empty() ? "" : ", ") + std::string(set->resonance->name);
  return names;
}

void check_fixed(Estimation& e) {
  for (const auto& [name, value] : e.options.fixed) {
    std::vector<std::string> names;
    std::string known;
    bool found = false;
    for (const CompiledSymbol& symbol : e.model.symbols) {
      names.emplace_back(symbol.name);
      known += (known.empty() ? "" : ", ") + names.back();
      found = found || symbol.name == name;
    }
    if (found || is_lump_of(e.sets, name)) continue;
    if (is_lump_of(e.all, name))
      throw NothingObserved("--fix " + name + ": no observations are left of that case; those in use are " +
                            cases_in_use(e));
    if (name.find(':') != std::string::npos)
      throw InputError("--fix " + name, "", "is no lump of a case that records of this campaign are of",
                       "CASE:NAME of one of the cases " + cases_in_use(e) + ", named as estimate.json lists them");
    const std::string lump = what_else_it_is(e.model, name);
    throw InputError(
        "--fix " + name, "", "is no symbol of model " + std::string(e.model.name) + lump,
        (lump.empty() ? "" : "a lump is given as CASE:NAME=VALUE, or the parameters that make it are; ") +
            remedy_for_word("its symbols are " + known, name, names));
  }
  e.given.assign(e.model.symbols.size(), false);
  for (std::size_t p = 0; p < e.given.size(); ++p)
    e.given[p] = e.options.fixed.count(std::string(e.model.symbols[p].name)) != 0;
}

// A locked mode's frequency is the excitation's: close to the natural one by the resonance relation.
void start_frequencies(Estimation& e) {
  for (const ObservationSet* set : e.all)
    for (std::size_t l = 0; l < set->resonance->lumps.size(); ++l)
      if (const auto value = given_value(e, *set->resonance, l))
        e.knowledge.fixed[key_of(*set->resonance, l)] = *value;
  e.knowledge.errors_in_variables = e.options.refine;
  for (std::size_t k = 0; k < e.model.modes(); ++k) {
    const std::string name(e.model.symbols[k].name);
    double sum = 0, count = 0;
    for (const ObservationSet* set : e.sets) {
      if (!mode_frequencies(e.model, *set->resonance).oscillates[k]) continue;
      for (const Observation& o : set->observations) {
        if (o.growth_sd[k] < 0) continue;
        sum += o.rate[k].imag();
        ++count;
      }
    }
    double value = count > 0 ? sum / count : e.model.nominal[k];
    if (e.given[k]) {
      value = e.options.fixed.at(name);
      e.knowledge.fixed_frequency.insert(k);
    }
    if (!std::isfinite(value))
      throw NothingObserved("model " + std::string(e.model.name) + ", natural frequency " + name +
                            ": is not seen in this campaign and has no nominal value; give it with --fix " + name +
                            "=VALUE (rad/s) or in the model's [nominal]");
    e.knowledge.natural_frequency.push_back(value);
  }
}

std::vector<std::vector<std::size_t>> modulation_blocks(const Estimation& e) {
  std::vector<std::vector<std::size_t>> blocks;
  for (const ObservationSet* set : e.sets) {
    const ModeFrequencies modes = mode_frequencies(e.model, *set->resonance);
    blocks.emplace_back();
    for (std::size_t b = 0; b < set->resonance->blocks.size(); ++b) {
      const RegressorBlock& block = set->resonance->blocks[b];
      if (block.kind == BlockKind::modulation && modes.oscillates[static_cast<std::size_t>(block.mode)])
        blocks.back().push_back(b);
    }
  }
  return blocks;
}

// Whether the excitation moves something in the leading order (hard excitation): what is not small makes harmonics
// of the first order as large as the terms of the modulation equations.
bool is_hard(const CompiledCase& resonance) {
  return std::any_of(resonance.blocks.begin(), resonance.blocks.end(), [](const RegressorBlock& block) {
    return block.kind == BlockKind::harmonic && block.order == 0;
  });
}

// Whether what is known depends on a symbol where that is zero, and all others are as at the point.
bool has_slope_at_zero(const CampaignKnowledge& known, VectorXd point, Index symbol) {
  point(symbol) = 0;
  return !known_jacobian(known, point).col(symbol).isZero(0);
}

// Symbols on which all that is known depends by even powers alone, as (b v^2) by b^2 where the modulation has no
// other quadratic term: that tells little of it near zero, and not its sign.
std::vector<Index> told_by_even_powers(const CampaignKnowledge& known, const VectorXd& point) {
  const Eigen::MatrixXd slopes = known_jacobian(known, point);
  std::vector<Index> even;
  for (Index p = 0; p < point.size(); ++p)
    if (!slopes.col(p).isZero(0) && !has_slope_at_zero(known, point, p)) even.push_back(p);
  return even;
}

// Under hard excitation all harmonics of the leading and the first order: they are as exact as the modulation
// equations, and that these determine a coefficient as well (by way of a small term, or by its square, which tells
// nothing where it is near zero) says nothing of how well. Else first-order ones whose lumps say something about
// the parameters that the modulation equations do not, or that these hold by even powers alone: a harmonic that
// only repeats what they say would bring its own truncation error and nothing else.
bool add_useful_harmonics(Estimation& e) {
  CampaignKnowledge known = campaign_knowledge(e);
  // Coefficients take natural frequencies as known: from this campaign or from the model's nominal values.
  for (std::size_t k = 0; k < e.model.modes(); ++k) known.parameters[k] = true;
  const VectorXd point = generic_point(static_cast<Index>(e.model.symbols.size()));
  const Index rank = scaled_rank(known_jacobian(known, point));
  const std::vector<Index> even = told_by_even_powers(known, point);
  bool added = false;
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const CompiledCase& resonance = *e.sets[s]->resonance;
    const bool hard = is_hard(resonance);
    for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
      const RegressorBlock& block = resonance.blocks[b];
      if (block.kind != BlockKind::harmonic || block.order > 1) continue;
      const bool measured = std::any_of(e.sets[s]->observations.begin(), e.sets[s]->observations.end(),
                                        [&](const Observation& o) { return o.harmonic_sd[b] >= 0; });
      if (!measured) continue;
      CampaignKnowledge further = known;
      for (const int l : block.lumps) further.cases[s].lumps[static_cast<std::size_t>(l)] = true;
      const bool linear =
          std::any_of(even.begin(), even.end(), [&](Index p) { return has_slope_at_zero(further, point, p); });
      if (!hard && !linear && scaled_rank(known_jacobian(further, point)) <= rank) continue;
      e.blocks[s].push_back(b);
      added = true;
    }
  }
  return added;
}

}  // namespace

Estimation::Estimation(std::span<const ObservationSet> measured, const MeasuredUnits& measured_units,
                       const EstimateOptions& asked, const EstimatePass& asked_pass)
    : model(*measured.front().model), units(measured_units), options(asked), pass(asked_pass) {
  for (const ObservationSet& set : measured) {
    result.warnings.insert(result.warnings.end(), set.warnings.begin(), set.warnings.end());
    if (!set.observations.empty()) sets.push_back(&set);
    result.cases.push_back(set.resonance);
    all.push_back(&set);
  }
  units.excitation.resize(model.excitations.size(), "1");
  check_fixed(*this);
  start_frequencies(*this);
}

std::string text_of(const LumpKey& key) {
  return key.resonance + ":" + key.name;
}

std::optional<double> given_value(const Estimation& e, const CompiledCase& resonance, std::size_t lump) {
  if (is_given_itself(e, resonance, lump)) return e.options.fixed.at(text_of(key_of(resonance, lump)));
  const CompiledLump& meant = resonance.lumps[lump];
  const auto given = e.options.fixed.find(std::string(meant.name));
  if (given == e.options.fixed.end() || !is_symbol(meant, given->first)) return std::nullopt;
  return given->second;
}

bool is_given_itself(const Estimation& e, const CompiledCase& resonance, std::size_t lump) {
  return e.options.fixed.count(text_of(key_of(resonance, lump))) != 0;
}

Precision fit_rounds(Estimation& e) {
  // One case alone finds its own natural frequencies.
  const int rounds = e.sets.size() > 1 ? case_rounds : 1;
  const EstimationState* start = e.pass.start.get();
  if (start && start->blocks.size() == e.sets.size()) {
    e.blocks = start->blocks;
    e.states = start->regressions;
    e.frequency_lumps = start->frequency_lumps;
    for (const auto& [lump, value] : e.frequency_lumps) e.knowledge.fixed[lump] = value;
    for (std::size_t k = 0; k < e.model.modes(); ++k)
      if (!e.given[k]) e.knowledge.natural_frequency[k] = start->natural_frequency[k];
    for (int round = 0; round < (e.pass.keep_weights ? 1 : rounds); ++round) fit_cases(e, Precision::full);
    return Precision::full;
  }
  e.blocks = modulation_blocks(e);
  fit_cases(e, Precision::rough);
  const bool more = add_useful_harmonics(e);
  for (int round = more ? 0 : 1; round < rounds; ++round) fit_cases(e, Precision::rough);
  return Precision::rough;
}

void fit_cases(Estimation& e, Precision precision) {
  e.fits.clear();
  e.states.resize(e.sets.size());
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const bool start = !e.states[s].weight.empty();
    e.fits.push_back(fit_case(*e.sets[s], e.blocks[s], e.knowledge,
                              {start ? &e.states[s] : nullptr, start && e.pass.keep_weights,
                               precision == Precision::rough, e.options.threads}));
    e.states[s] = e.fits.back().state;
  }
  // What all cases say of each natural frequency, each by its weight.
  for (std::size_t k = 0; k < e.model.modes(); ++k) {
    if (e.given[k]) continue;
    double sum = 0, weights = 0;
    for (const CaseFit& fit : e.fits)
      for (std::size_t c = 0; c < fit.columns.size(); ++c) {
        if (fit.columns[c].kind != CaseColumn::Kind::natural_frequency || fit.columns[c].index != k) continue;
        if (fit.fit.coefficients.size() == 0 || !fit.fit.identifiable[c]) continue;
        const auto at = static_cast<Index>(c);
        const double weight = 1 / (fit.fit.plain_covariance(at, at) + 1e-300);
        sum += weight * fit.fit.coefficients(at);
        weights += weight;
      }
    if (weights > 0) e.knowledge.natural_frequency[k] = sum / weights;
  }
}

bool know_frequency_lumps(Estimation& e) {
  CampaignKnowledge known = campaign_knowledge(e);
  for (std::size_t k = 0; k < e.model.modes(); ++k) known.parameters[k] = true;
  const Identifiability what = identifiability(known);
  const std::size_t symbols = e.model.symbols.size();
  bool found = false;
  for (const CaseFit& fit : e.fits) {
    if (fit.fit.coefficients.size() == 0) continue;
    const CompiledCase& resonance = *fit.set->resonance;
    std::vector<double> lumps(resonance.lumps.size()), slope(lumps.size() * symbols);
    resonance.evaluate_lumps(e.shared.values.data(), lumps.data());
    resonance.evaluate_lumps_jacobian(e.shared.values.data(), slope.data());
    for (std::size_t c = 0; c < fit.columns.size(); ++c) {
      if (fit.columns[c].kind != CaseColumn::Kind::lump || fit.fit.identifiable[c]) continue;
      const std::vector<int>& others = fit.fit.entangled_with[c];
      const bool with_frequency = !others.empty() && std::all_of(others.begin(), others.end(), [&](int other) {
        return fit.columns[static_cast<std::size_t>(other)].kind == CaseColumn::Kind::natural_frequency;
      });
      const std::size_t l = fit.columns[c].index;
      bool follows = with_frequency;
      for (std::size_t p = 0; p < symbols; ++p)
        if (slope[l * symbols + p] != 0 && !what.determined[p]) follows = false;
      if (!follows) continue;
      const LumpKey key = key_of(resonance, l);
      e.frequency_lumps[key] = e.knowledge.fixed[key] = lumps[l];
      found = true;
    }
  }
  return found;
}

void follow_frequency_lumps(Estimation& e) {
  for (const CaseFit& fit : e.fits) {
    const CompiledCase& resonance = *fit.set->resonance;
    std::vector<double> lumps(resonance.lumps.size());
    if (!lumps.empty()) resonance.evaluate_lumps(e.shared.values.data(), lumps.data());
    for (std::size_t l = 0; l < lumps.size(); ++l)
      if (const auto known = e.frequency_lumps.find(key_of(resonance, l)); known != e.frequency_lumps.end())
        known->second = lumps[l];
  }
}

CampaignKnowledge campaign_knowledge(const Estimation& e) {
  CampaignKnowledge known;
  known.model = &e.model;
  known.parameters = e.given;
  for (const CaseFit& fit : e.fits) {
    KnownLumps part{fit.set->resonance, std::vector<bool>(fit.set->resonance->lumps.size(), false)};
    for (std::size_t l = 0; l < part.lumps.size(); ++l)
      part.lumps[l] = given_value(e, *part.resonance, l).has_value();
    for (std::size_t c = 0; c < fit.columns.size(); ++c) {
      if (fit.fit.coefficients.size() == 0 || !fit.fit.identifiable[c]) continue;
      if (fit.columns[c].kind == CaseColumn::Kind::lump) part.lumps[fit.columns[c].index] = true;
      if (fit.columns[c].kind == CaseColumn::Kind::natural_frequency) known.parameters[fit.columns[c].index] = true;
    }
    known.cases.push_back(std::move(part));
  }
  return known;
}

}  // namespace secular
