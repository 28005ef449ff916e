#include "diagnose/verdict/blows_alone.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "diagnose/evidence/record_directions.hpp"
#include "diagnose/inference/inference.hpp"
#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/comparison.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Symbols of the model as it was that move nothing where nothing drives: strengths of excitations. What free motion
// tells badly may be a law's.
std::vector<std::size_t> of_excitations(const Refit& fit, const std::vector<std::size_t>& own) {
  std::vector<std::size_t> open;
  for (const std::size_t symbol : own) {
    const auto place = std::find(fit.free.begin(), fit.free.end(), symbol);
    if (place != fit.free.end() && fit.scale(place - fit.free.begin()) == 0) open.push_back(symbol);
  }
  return open;
}

std::set<std::size_t> records_of(const Discrepancy& discrepancy) {
  std::set<std::size_t> records;
  for (const RowLabel& label : discrepancy.labels()) records.insert(label.record);
  return records;
}

BlowStrengths compared(std::size_t symbol, std::vector<BlowStrength> records) {
  const auto count = static_cast<Index>(records.size());
  VectorXd values(count), variances(count);
  for (Index r = 0; r < count; ++r) {
    values(r) = records[static_cast<std::size_t>(r)].value;
    variances(r) = records[static_cast<std::size_t>(r)].variance;
  }
  const Between between = between_records(values, variances, Eigen::MatrixXd::Ones(count, 1));
  const VectorXd weight = (variances.array() + between.sd * between.sd).inverse();
  return {symbol, std::move(records), weight.dot(values) / weight.sum(), between.sd, between.p_value};
}

}  // namespace

bool BlowsAlone::do_not_fit() const {
  return is_more_than_noise(left) || is_more_than_noise({left.freedom + squares_between_samples, left.freedom}) ||
         (most_different() != nullptr && most_different()->p_value < diagnose_thresholds().scatter_alarm);
}

const BlowStrengths* BlowsAlone::most_different() const {
  const auto least = std::min_element(strengths.begin(), strengths.end(),
                                      [](const auto& a, const auto& b) { return a.p_value < b.p_value; });
  return least == strengths.end() ? nullptr : &*least;
}

const BlowStrength* BlowStrengths::of(std::size_t record) const {
  const auto own = std::find_if(records.begin(), records.end(), [&](const auto& r) { return r.record == record; });
  return own == records.end() ? nullptr : &*own;
}

std::vector<bool> chosen_impacts(const Campaign& campaign, const Window& window) {
  std::vector<bool> chosen;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    chosen.push_back(campaign.records[r].kind == RecordKind::impact && window.takes(r, campaign.records[r].file));
  return chosen;
}

BlowsAlone fit_blows_alone(const CampaignAndModel& sides, DiagnosisOptions options, const KnownStructure& known) {
  const Campaign& campaign = sides.campaign;
  const std::vector<std::size_t> open = of_excitations(known.fit, sides.own);
  options.blows_as_decays = false;
  options.late = false;
  options.frequency_scatter = {};
  options.given = {};
  options.check = {};
  options.forces = known.forces;
  options.keeps_scales = true;
  BlowsAlone blows;
  options.window.chosen = chosen_impacts(campaign, options.window);
  const std::set<std::size_t> usable = records_of(compare(sides, {}, options).discrepancy);
  std::map<std::size_t, std::vector<BlowStrength>> of_symbols;
  for (const std::size_t r : usable) {
    options.window.chosen.assign(campaign.records.size(), false);
    options.window.chosen[r] = true;
    Comparison comparison = compare(sides, {}, options);
    InferenceOptions inference_options;
    inference_options.threads = options.threads;
    const Inference alone =
        infer(comparison.discrepancy, {}, known.fit.unknowns, comparison.fitted_beside(open), inference_options);
    const Refit& told = alone.null.fit;
    blows.records.push_back(r);
    blows.left.chi_squared += told.chi_squared;
    blows.left.freedom += alone.degrees_of_freedom;
    if (const BetweenSamples& between = comparison.of_records.of_blows; !between.records.empty()) {
      blows.between_samples = std::max(blows.between_samples, between.share);
      blows.squares_between_samples +=
          comparison.segment_evidence->between_samples(told.unknowns, between).squaredNorm();
    }
    const double dispersion = dispersion_of(told.chi_squared, alone.degrees_of_freedom);
    for (std::size_t f = 0; f < open.size(); ++f) {
      const double variance = told.covariance(static_cast<Index>(f), static_cast<Index>(f));
      if (told.identifiable[f] && variance > 0)
        of_symbols[open[f]].push_back({r, told.unknowns(static_cast<Index>(open[f])), dispersion * variance});
    }
  }
  for (auto& [symbol, records] : of_symbols)
    if (records.size() >= 2) blows.strengths.push_back(compared(symbol, std::move(records)));
  return blows;
}

}  // namespace secular
