#include "estimator/identification/unsupported_values.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/short_list.hpp"
#include "estimator/identification/value_errors.hpp"

namespace secular {
namespace {

// Lumps of the modulation equations whose columns change with the force.
std::set<std::string> lumps_of_force(const CaseFit& fit) {
  const CompiledCase& resonance = *fit.set->resonance;
  ObservationSet one;
  one.model = fit.set->model;
  one.resonance = fit.set->resonance;
  one.observations = {fit.set->observations.front()};
  ObservationSet free = one;
  for (std::complex<double>& force : free.observations.front().forcing) force = 0;
  std::vector<std::size_t> blocks;
  for (const std::size_t b : fit.blocks)
    if (resonance.blocks[b].kind == BlockKind::modulation) blocks.push_back(b);
  const auto design = [&](const ObservationSet& set) {
    EquationData data(set, blocks, EquationData::Errors::none);
    data.evaluate(fit.state.at.natural_frequency);
    return data.rows(0, fit.columns, fit.state.at, fit.state.at.natural_frequency).design;
  };
  const Eigen::MatrixXd change = design(one) - design(free);
  std::set<std::string> names;
  for (std::size_t c = 0; c < fit.columns.size(); ++c)
    if (fit.columns[c].kind == CaseColumn::Kind::lump && change.col(static_cast<Eigen::Index>(c)).squaredNorm() > 0)
      names.emplace(resonance.lumps[fit.columns[c].index].name);
  return names;
}

// Numbers that were estimated.
template <class Do>
void for_each_number(Estimate& estimate, const Do& act) {
  for (std::vector<EstimatedValue>* values : {&estimate.parameters, &estimate.lumps})
    for (EstimatedValue& value : *values)
      if (value.value && !value.fixed) act(value);
}

// A number that no lump moves (what it is comes of others that are open) is told by none of the other cases,
// either.
bool told_by_these_alone(const EstimatedValue& value, const std::set<std::string>& cases) {
  return !cases.empty() && std::all_of(value.told_by.begin(), value.told_by.end(),
                                       [&](const std::string& name) { return cases.contains(name); });
}

bool leaves_open(const CaseFit& fit) {
  for (std::size_t c = 0; c < fit.columns.size() && c < fit.fit.identifiable.size(); ++c)
    if (fit.columns[c].kind == CaseColumn::Kind::lump && !fit.fit.identifiable[c]) return true;
  return false;
}

}  // namespace

std::set<std::string> cases_with_lack_of_fit(const Estimate& estimate) {
  std::set<std::string> cases;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    if (std::any_of(tests.equations.begin(), tests.equations.end(),
                    [](const LackOfFit& test) { return test.significant; }))
      cases.insert(tests.resonance);
  return cases;
}

std::set<std::string> cases_of_few_conditions(const Estimate& estimate) {
  std::set<std::string> cases;
  for (const BlockQuality& block : estimate.blocks)
    if (!block.clustered) cases.insert(block.resonance);
  return cases;
}

void take_out(Estimate& estimate, const std::set<std::string>& cases, const std::string& why) {
  std::vector<std::string> names;
  for_each_number(estimate, [&](EstimatedValue& value) {
    if (!told_by_these_alone(value, cases)) return;
    const std::string label = label_of(value, estimate);
    if (std::find(names.begin(), names.end(), label) == names.end()) names.push_back(label);
    value.value.reset();
    value.identifiable = value.significant = value.doubtful = false;
    value.doubtful_because.clear();
    value.from = "not determined: " + why;
  });
  if (!names.empty()) estimate.warnings.push_back(why + ": no numbers are given for " + short_list(names));
}

void take_out_unsupported(Estimate& estimate, std::span<const CaseFit> fits) {
  std::set<std::string> cases = cases_of_few_conditions(estimate), open;
  for (const CaseFit& fit : fits)
    if (const std::string name(fit.set->resonance->name); cases.contains(name) && leaves_open(fit))
      open.insert(name);
  if (estimate.null_space.cols() > 0)
    take_out(estimate, open,
             "of too few conditions, which leave coefficients open that the expansion's truncation depends on");
  if (!estimate.consistency.significant) {
    const std::set<std::string> not_fitting = cases_with_lack_of_fit(estimate);
    std::erase_if(cases, [&](const std::string& resonance) { return !not_fitting.contains(resonance); });
  }
  take_out(estimate, cases, "of too few conditions, and the equations do not hold");
}

void doubt_without_force(Estimate& estimate, std::span<const CaseFit> fits) {
  for (const CaseFit& fit : fits) {
    const CompiledCase& resonance = *fit.set->resonance;
    if (!resonance.excited || fit.fit.coefficients.size() == 0) continue;
    const std::set<std::string> of_force = lumps_of_force(fit);
    bool any = of_force.empty();
    for (const EstimatedValue& value : estimate.lumps)
      if (value.resonance == resonance.name && of_force.contains(value.name))
        any = any || !value.value || value.fixed || value.significant;
    if (any) continue;
    const std::set<std::string> this_one{std::string(resonance.name)};
    for_each_number(estimate, [&](EstimatedValue& value) {
      if (told_by_these_alone(value, this_one))
        doubt(value, "no coefficient of the excitation differs from zero, although the motion is excited");
    });
    estimate.warnings.push_back(
        "case " + std::string(resonance.name) +
        ": no coefficient of the excitation differs from zero, although the motion is excited. No damping and no "
        "force satisfy the equations at any phase: every value of the case is doubtful. Are the records in step "
        "with "
        "their excitation?");
  }
}

void doubt_what_differs(Estimate& estimate, const Estimate& other, const std::string& why) {
  const auto compare = [&why](std::vector<EstimatedValue>& values, const std::vector<EstimatedValue>& others) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      EstimatedValue& value = values[i];
      if (!value.value || value.fixed) continue;
      const EstimatedValue& free = others[i];
      if (!free.value || std::abs(*value.value - *free.value) > 2 * std::hypot(value.sd, free.sd))
        doubt(value, why);
    }
  };
  compare(estimate.parameters, other.parameters);
  compare(estimate.lumps, other.lumps);
}

void doubt_all(Estimate& estimate, const std::string& why) {
  for_each_number(estimate, [&why](EstimatedValue& value) { doubt(value, why); });
}

}  // namespace secular
