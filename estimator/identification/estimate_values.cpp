// Parameters and lumps as numbers with error bars, or with the reason why there is none.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/estimation.hpp"
#include "estimator/identification/unit_text.hpp"
#include "estimator/identification/value_errors.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Percentiles of the bootstrap's interval.
constexpr auto& bootstrap_tail = estimator_thresholds().interval_tail;

void set_errors(EstimatedValue& value, double variance, double open_variance) {
  value.sd = std::sqrt(std::max(0.0, variance));
  value.open_sd = std::sqrt(std::clamp(open_variance, 0.0, std::max(0.0, variance)));
  value.noise_sd = std::sqrt(std::max(0.0, variance - open_variance));
}

BootstrapInterval interval_of(VectorXd draws) {
  std::sort(draws.data(), draws.data() + draws.size());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(draws.size() - 1);
    const auto below = static_cast<Index>(std::floor(place));
    const Index above = std::min(below + 1, draws.size() - 1);
    return draws(below) + (place - std::floor(place)) * (draws(above) - draws(below));
  };
  const double mean = draws.mean();
  return {at(bootstrap_tail), at(1 - bootstrap_tail),
          std::sqrt((draws.array() - mean).square().sum() /
                    std::max<double>(1, static_cast<double>(draws.size() - 1)))};
}

std::vector<std::size_t> blocks_of(const CaseFit& fit, std::size_t column) {
  const CaseColumn& c = fit.columns[column];
  std::vector<std::size_t> found;
  for (const std::size_t b : fit.blocks) {
    const RegressorBlock& block = fit.set->resonance->blocks[b];
    const bool here =
        c.kind == CaseColumn::Kind::lump
            ? std::find(block.lumps.begin(), block.lumps.end(), static_cast<int>(c.index)) != block.lumps.end()
            : block.kind == BlockKind::modulation && static_cast<int>(c.index) == block.mode;
    if (here) found.push_back(b);
  }
  return found;
}

// What part of a parameter's variance a case's lump, or combination of lumps, has to make to count as its source.
constexpr double least_part = 1e-6;

bool moves(const Estimation& e, std::size_t s, Index row, Index p) {
  const MatrixXd& slope = e.shared.slope[s];
  return slope(p, row) * slope(p, row) * e.lump_estimates[s].plain(row, row) >
         least_part * e.shared.covariance(p, p);
}

// Cases whose lumps move the parameter.
std::vector<std::string> cases_of(const Estimation& e, Index p) {
  std::vector<std::string> cases;
  for (std::size_t s = 0; s < e.fits.size(); ++s) {
    bool any = false;
    for (Index row = 0; row < e.shared.slope[s].cols(); ++row) any = any || moves(e, s, row, p);
    if (any) cases.emplace_back(e.fits[s].set->resonance->name);
  }
  return cases;
}

// The blocks of the cases whose lumps move the parameter, by their share of its weight.
std::string source_of(const Estimation& e, Index p) {
  std::string text;
  for (std::size_t s = 0; s < e.fits.size(); ++s) {
    if (e.shared.slope[s].rows() == 0) continue;
    std::set<std::size_t> blocks;
    const MatrixXd& combination = e.lump_estimates[s].combination;
    for (Index row = 0; row < combination.rows(); ++row) {
      if (!moves(e, s, row, p)) continue;
      for (Index i = 0; i < combination.cols(); ++i)
        if (combination(row, i) != 0)
          for (const std::size_t b :
               blocks_of(e.fits[s], static_cast<std::size_t>(e.used[s][static_cast<std::size_t>(i)])))
            blocks.insert(b);
    }
    if (blocks.empty()) continue;
    std::string names;
    for (const std::size_t b : blocks)
      names += (names.empty() ? "" : ", ") + std::string(e.sets[s]->resonance->blocks[b].name);
    text += (text.empty() ? "" : "; ") +
            (e.fits.size() > 1 ? std::string(e.sets[s]->resonance->name) + ": " + names : names);
  }
  return text;
}

// Near dependencies of the lump that is the parameter itself.
std::vector<std::string> near_parameters(const Estimation& e, const std::string& name) {
  if (e.fits.size() != 1) return {};
  const auto near = nearly_entangled(e.fits.front());
  for (std::size_t c = 0; c < near.size(); ++c)
    if (const CaseColumn& column = e.fits.front().columns[c];
        column.kind == CaseColumn::Kind::lump &&
        is_symbol(e.fits.front().set->resonance->lumps[column.index], name))
      return near[c];
  return {};
}

// Of the case that tells it from most records.
std::optional<ScatterBetweenRecords> scatter_of_frequency(const Estimation& e, std::size_t mode) {
  const ScatterBetweenRecords* found = nullptr;
  for (const CaseFit& fit : e.fits)
    for (const ScatterBetweenRecords& scatter : fit.record_scatter)
      if (scatter.mode == mode && (found == nullptr || scatter.records.size() > found->records.size()))
        found = &scatter;
  return found == nullptr ? std::nullopt : std::optional(*found);
}

/// By column of a case's regression.
struct ColumnQuality {
  std::vector<std::optional<PartialF>> partial_f;
  std::vector<std::vector<std::string>> nearly_entangled_with;
};

void fill_lump(const Estimation& e, std::size_t s, std::size_t l, const ColumnQuality& quality,
               EstimatedValue& value) {
  const CaseFit& fit = e.fits[s];
  for (std::size_t c = 0; c < fit.columns.size(); ++c) {
    if (fit.columns[c].kind != CaseColumn::Kind::lump || fit.columns[c].index != l) continue;
    const auto at = static_cast<Index>(c);
    value.from.clear();
    for (const std::size_t b : blocks_of(fit, c))
      value.from += (value.from.empty() ? "" : ", ") + std::string(fit.set->resonance->blocks[b].name);
    if (!fit.fit.identifiable[c]) {
      value.from = "not determined by this campaign";
      for (const int other : fit.fit.entangled_with[c])
        value.entangled_with.push_back(column_name(fit, static_cast<std::size_t>(other)));
      return;
    }
    value.identifiable = true;
    value.told_by = {value.resonance};
    value.value = fit.fit.coefficients(at);
    const bool open = s < e.open_variance.size() && e.open_variance[s].size() > 0;
    set_errors(value, fit.fit.covariance(at, at), open ? e.open_variance[s](at) : 0);
    if (e.hidden[s].cols() > 0) add_misfit(value, e.hidden[s].row(at).norm());
    value.degrees_of_freedom = fit.fit.degrees_of_freedom;
    value.significant = is_significant(value);
    value.partial_f = quality.partial_f[c];
    value.nearly_entangled_with = quality.nearly_entangled_with[c];
    if (s < e.bootstrap_lumps.size() && e.bootstrap_lumps[s].cols() > 0)
      value.bootstrap = interval_of(e.bootstrap_lumps[s].row(at).transpose());
  }
}

}  // namespace

bool is_significant(const EstimatedValue& value) {
  return value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
}

void doubt(EstimatedValue& value, const std::string& why) {
  value.doubtful = true;
  std::vector<std::string>& reasons = value.doubtful_because;
  if (std::find(reasons.begin(), reasons.end(), why) == reasons.end()) reasons.push_back(why);
}

void add_misfit(EstimatedValue& value, double misfit, const std::string& why) {
  if (!(misfit > 0) || !value.value) return;
  value.misfit = std::hypot(value.misfit, misfit);
  if (misfit > 2 * value.sd) doubt(value, why);
  value.sd = std::hypot(value.sd, 0.5 * misfit);
}

void report_parameters(Estimation& e) {
  const CampaignKnowledge known = campaign_knowledge(e);
  const Identifiability what = identifiability(known);
  for (std::size_t p = 0; p < e.model.symbols.size(); ++p) {
    const auto at = static_cast<Index>(p);
    EstimatedValue value;
    value.name = std::string(e.model.symbols[p].name);
    value.unit = unit_text(e.model.symbols[p].dimension,
                           std::vector<std::string>(e.model.modes(), e.units.coordinate), e.units.excitation);
    if (e.given[p]) {
      value.fixed = value.identifiable = true;
      value.value = e.options.fixed.at(value.name);
      value.from = "given";
    } else if (what.determined[p] && e.shared.covariance(at, at) > 0) {
      value.identifiable = true;
      value.value = e.shared.values(at);
      set_errors(value, e.shared.covariance(at, at), e.shared.open_variance(at));
      add_misfit(value, misfit_of_parameter(e, at));
      value.degrees_of_freedom = e.shared.degrees_of_freedom(at);
      value.from = source_of(e, at);
      value.told_by = cases_of(e, at);
      value.significant = is_significant(value);
      value.nearly_entangled_with = near_parameters(e, value.name);
      if (p < e.model.modes()) value.between_records = scatter_of_frequency(e, p);
      if (e.bootstrap.cols() > 0) value.bootstrap = interval_of(e.bootstrap.row(at).transpose());
    } else {
      value.from = "not determined by this campaign";
      for (const int other : what.entangled_with[p])
        value.entangled_with.emplace_back(e.model.symbols[static_cast<std::size_t>(other)].name);
    }
    e.result.parameters.push_back(std::move(value));
  }
  e.result.null_directions = null_directions(known);
  e.result.covariance = e.shared.covariance;
}

void report_lumps(Estimation& e) {
  for (const ObservationSet* set : e.all) {
    const auto fitted = std::find_if(e.fits.begin(), e.fits.end(), [&](const CaseFit& f) {
      return f.set == set && f.fit.coefficients.size() > 0;
    });
    ColumnQuality quality;
    if (fitted != e.fits.end()) quality = {partial_f(*fitted), nearly_entangled(*fitted)};
    for (std::size_t l = 0; l < set->resonance->lumps.size(); ++l) {
      EstimatedValue value;
      value.name = std::string(set->resonance->lumps[l].name);
      value.definition = std::string(set->resonance->lumps[l].definition);
      value.resonance = std::string(set->resonance->name);
      value.unit = unit_text(set->resonance->lumps[l].dimension,
                             std::vector<std::string>(e.model.modes(), e.units.coordinate), e.units.excitation);
      value.from =
          e.knowledge.fixed.count(key_of(*set->resonance, l)) != 0 ? "follows from its symbols" : "not used";
      if (const auto given = given_value(e, *set->resonance, l)) {
        value.fixed = value.identifiable = true;
        value.value = given;
        value.from = "given";
      } else if (fitted != e.fits.end()) {
        fill_lump(e, static_cast<std::size_t>(fitted - e.fits.begin()), l, quality, value);
      }
      e.result.lumps.push_back(std::move(value));
    }
  }
}

}  // namespace secular
