#include "estimator/identification/estimate.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/identifiability.hpp"
#include "estimator/identification/shared_parameters.hpp"
#include "estimator/identification/short_list.hpp"
#include "estimator/identification/unit_text.hpp"
#include "estimator/regression/confidence.hpp"
#include "estimator/regression/distribution.hpp"
#include "input/input_error.hpp"

namespace secular {

struct EstimationState {
  std::vector<std::vector<std::size_t>> blocks;  ///< by case with observations
  std::vector<RegressionState> regressions;
  std::vector<double> natural_frequency;
  std::map<std::string, double> shifts;  ///< lumps that were given what their symbols make of them
};

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Cases are fitted again with the natural frequencies of all of them; the columns depend on those weakly.
constexpr int case_rounds = 2;

/// Standard deviation, relative, of a natural frequency about the observed one where nothing else tells it.
constexpr double resonance_width = 0.005;

/// Moves of parameters, in units of their own size, that depend on one another to this share say nothing new.
constexpr double dependent_moves = 1e-3;

/// Percentiles of the bootstrap's interval.
constexpr double bootstrap_tail = 0.025;

bool significant(const EstimatedValue& value) {
  return value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
}

/// Combinations of columns that are orthogonal to everything lost are as good as these.
constexpr double lost_tolerance = 1e-8;

/// Probability that lumps of a model that holds contradict one another.
constexpr double contradiction_alarm = 1e-3;

/// A misfit counts as doubt where it may change a value by more than this share.
constexpr double material_share = 0.1;

// Combinations of the columns `lost`, one a row, that the fit knows although it knows none of them alone:
// orthogonal, in scaled coefficients, to every direction that is lost.
MatrixXd known_combinations(const LinearFit& fit, const std::vector<Index>& lost) {
  if (lost.empty() || fit.lost.cols() == 0) return {};
  const MatrixXd directions = fit.lost(lost, Eigen::all);
  const Eigen::JacobiSVD<MatrixXd> svd(directions, Eigen::ComputeFullU);
  Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > lost_tolerance) ++rank;
  const VectorXd scale = fit.scale(lost);
  return svd.matrixU().rightCols(static_cast<Index>(lost.size()) - rank).transpose() *
         scale.cwiseInverse().asDiagonal();
}

// The misfit joins the error bar.
void add_misfit(EstimatedValue& value, double misfit) {
  if (!(misfit > 0) || !value.value) return;
  value.misfit = misfit;
  value.doubtful = misfit > 2 * value.sd && misfit > material_share * std::abs(*value.value);
  value.sd = std::hypot(value.sd, 0.5 * misfit);
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

class Estimator {
 public:
  Estimator(std::span<const ObservationSet> sets, const MeasuredUnits& units, const EstimateOptions& options)
      : model_(*sets.front().model), units_(units), options_(options) {
    for (const ObservationSet& set : sets) {
      result_.warnings.insert(result_.warnings.end(), set.warnings.begin(), set.warnings.end());
      if (!set.observations.empty()) sets_.push_back(&set);
      result_.cases.push_back(set.resonance);
      all_.push_back(&set);
    }
    units_.excitation.resize(model_.excitations.size(), "1");
    check_fixed();
    start_frequencies();
  }

  Estimate run() {
    // One case alone finds its own natural frequencies.
    const int rounds = sets_.size() > 1 ? case_rounds : 1;
    std::vector<std::vector<std::size_t>> blocks;
    if (options_.start && options_.start->blocks.size() == sets_.size()) {
      blocks = options_.start->blocks;
      states_ = options_.start->regressions;
      shifts_ = options_.start->shifts;
      for (const auto& [name, value] : shifts_) knowledge_.fixed[name] = value;
      for (std::size_t k = 0; k < model_.modes(); ++k)
        if (!given_[k]) knowledge_.natural_frequency[k] = options_.start->natural_frequency[k];
      for (int round = 0; round < (options_.keep_weights ? 1 : rounds); ++round) fit_cases(blocks);
    } else {
      blocks = modulation_blocks();
      fit_cases(blocks);
      const bool more = add_useful_harmonics(blocks);
      for (int round = more ? 0 : 1; round < rounds; ++round) fit_cases(blocks);
    }
    shared();
    if (!shifts_.empty()) {
      follow_shifts();
    } else if (know_shifts()) {
      fit_cases(blocks);
      lump_estimates_.clear();
      bootstrap_lumps_.clear();
      used_.clear();
      truncation_slope_.clear();
      single_.clear();
      shared();
    }
    place_along_unseen();
    hidden_.resize(fits_.size());
    if (options_.judge_fit) {
      test_fit();
      test_consistency();
    }
    report_parameters();
    report_lumps();
    report_quality();
    result_.state = std::make_shared<const EstimationState>(
        EstimationState{std::move(blocks), std::move(states_), knowledge_.natural_frequency, std::move(shifts_)});
    return std::move(result_);
  }

 private:
  void check_fixed() {
    for (const auto& [name, value] : options_.fixed) {
      std::string known;
      bool found = false;
      for (const CompiledSymbol& symbol : model_.symbols) {
        known += (known.empty() ? "" : ", ") + std::string(symbol.name);
        found = found || symbol.name == name;
      }
      if (!found)
        throw InputError("--fix " + name, "", "is no symbol of model " + std::string(model_.name),
                         "its symbols are " + known);
    }
    given_.assign(model_.symbols.size(), false);
    for (std::size_t p = 0; p < given_.size(); ++p)
      given_[p] = options_.fixed.count(std::string(model_.symbols[p].name)) != 0;
  }

  // A locked mode's frequency is the excitation's: close to the natural one by the resonance relation.
  void start_frequencies() {
    knowledge_.fixed = options_.fixed;
    knowledge_.errors_in_variables = options_.refine;
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      const std::string name(model_.symbols[k].name);
      double sum = 0, count = 0;
      for (const ObservationSet* set : sets_) {
        if (!mode_frequencies(model_, *set->resonance).oscillates[k]) continue;
        for (const Observation& o : set->observations) {
          if (o.growth_sd[k] < 0) continue;
          sum += o.rate[k].imag();
          ++count;
        }
      }
      double value = count > 0 ? sum / count : model_.nominal[k];
      if (given_[k]) {
        value = options_.fixed.at(name);
        knowledge_.fixed_frequency.insert(k);
      }
      if (!std::isfinite(value))
        throw InputError("model " + std::string(model_.name), "natural frequency " + name,
                         "is not seen in this campaign and has no nominal value",
                         "give it with --fix " + name + "=VALUE (rad/s) or in the model's [nominal]");
      knowledge_.natural_frequency.push_back(value);
    }
  }

  std::vector<std::vector<std::size_t>> modulation_blocks() const {
    std::vector<std::vector<std::size_t>> blocks;
    for (const ObservationSet* set : sets_) {
      const ModeFrequencies modes = mode_frequencies(model_, *set->resonance);
      blocks.emplace_back();
      for (std::size_t b = 0; b < set->resonance->blocks.size(); ++b) {
        const RegressorBlock& block = set->resonance->blocks[b];
        if (block.kind == BlockKind::modulation && modes.oscillates[static_cast<std::size_t>(block.mode)])
          blocks.back().push_back(b);
      }
    }
    return blocks;
  }

  void fit_cases(const std::vector<std::vector<std::size_t>>& blocks) {
    fits_.clear();
    states_.resize(sets_.size());
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      const bool start = !states_[s].weight.empty();
      fits_.push_back(fit_case(*sets_[s], blocks[s], knowledge_,
                               {start ? &states_[s] : nullptr, start && options_.keep_weights, options_.threads}));
      states_[s] = fits_.back().state;
    }
    // What all cases say of each natural frequency, each by its weight.
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (given_[k]) continue;
      double sum = 0, weights = 0;
      for (const CaseFit& fit : fits_)
        for (std::size_t c = 0; c < fit.columns.size(); ++c) {
          if (fit.columns[c].kind != CaseColumn::Kind::natural_frequency || fit.columns[c].index != k) continue;
          if (fit.fit.coefficients.size() == 0 || !fit.fit.identifiable[c]) continue;
          const auto at = static_cast<Index>(c);
          const double weight = 1 / (fit.fit.plain_covariance(at, at) + 1e-300);
          sum += weight * fit.fit.coefficients(at);
          weights += weight;
        }
      if (weights > 0) knowledge_.natural_frequency[k] = sum / weights;
    }
  }

  // Where damping is of the first order, the second one shifts the frequency by a lump of its own (-mu^2/(2
  // omega)), whose column is that of the natural frequency: neither can be told. The lump's symbols are known from
  // elsewhere, though, and it depends on the natural frequency weakly: it is given its value, and the frequency can
  // be.
  bool know_shifts() {
    CampaignKnowledge known = campaign_knowledge();
    for (std::size_t k = 0; k < model_.modes(); ++k) known.parameters[k] = true;
    const Identifiability what = identifiability(known);
    const std::size_t symbols = model_.symbols.size();
    bool found = false;
    for (const CaseFit& fit : fits_) {
      if (fit.fit.coefficients.size() == 0) continue;
      const CompiledCase& resonance = *fit.set->resonance;
      std::vector<double> lumps(resonance.lumps.size()), slope(lumps.size() * symbols);
      resonance.evaluate_lumps(shared_.values.data(), lumps.data());
      resonance.evaluate_lumps_jacobian(shared_.values.data(), slope.data());
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
        shifts_[std::string(resonance.lumps[l].name)] = knowledge_.fixed[std::string(resonance.lumps[l].name)] =
            lumps[l];
        found = true;
      }
    }
    return found;
  }

  // What they are at the parameters that were found with them, for the next estimate.
  void follow_shifts() {
    for (const CaseFit& fit : fits_) {
      const CompiledCase& resonance = *fit.set->resonance;
      std::vector<double> lumps(resonance.lumps.size());
      if (!lumps.empty()) resonance.evaluate_lumps(shared_.values.data(), lumps.data());
      for (std::size_t l = 0; l < lumps.size(); ++l)
        if (const auto shift = shifts_.find(std::string(resonance.lumps[l].name)); shift != shifts_.end())
          shift->second = lumps[l];
    }
  }

  CampaignKnowledge campaign_knowledge() const {
    CampaignKnowledge known;
    known.model = &model_;
    known.parameters = given_;
    for (const CaseFit& fit : fits_) {
      KnownLumps part{fit.set->resonance, std::vector<bool>(fit.set->resonance->lumps.size(), false)};
      for (std::size_t l = 0; l < part.lumps.size(); ++l)
        part.lumps[l] = options_.fixed.count(std::string(part.resonance->lumps[l].name)) != 0;
      for (std::size_t c = 0; c < fit.columns.size(); ++c) {
        if (fit.fit.coefficients.size() == 0 || !fit.fit.identifiable[c]) continue;
        if (fit.columns[c].kind == CaseColumn::Kind::lump) part.lumps[fit.columns[c].index] = true;
        if (fit.columns[c].kind == CaseColumn::Kind::natural_frequency)
          known.parameters[fit.columns[c].index] = true;
      }
      known.cases.push_back(std::move(part));
    }
    return known;
  }

  // First-order harmonics whose lumps say something about the parameters that the modulation equations do not. (A
  // harmonic that only repeats what they say would bring its own truncation error and nothing else.)
  bool add_useful_harmonics(std::vector<std::vector<std::size_t>>& blocks) {
    CampaignKnowledge known = campaign_knowledge();
    // Coefficients take natural frequencies as known: from this campaign or from the model's nominal values.
    for (std::size_t k = 0; k < model_.modes(); ++k) known.parameters[k] = true;
    const VectorXd point = generic_point(static_cast<Index>(model_.symbols.size()));
    const Index rank = scaled_rank(known_jacobian(known, point));
    bool added = false;
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      const CompiledCase& resonance = *sets_[s]->resonance;
      for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
        const RegressorBlock& block = resonance.blocks[b];
        if (block.kind != BlockKind::harmonic || block.order > 1) continue;
        const bool measured = std::any_of(sets_[s]->observations.begin(), sets_[s]->observations.end(),
                                          [&](const Observation& o) { return o.harmonic_sd[b] >= 0; });
        if (!measured) continue;
        CampaignKnowledge further = known;
        for (const int l : block.lumps) further.cases[s].lumps[static_cast<std::size_t>(l)] = true;
        if (scaled_rank(known_jacobian(further, point)) <= rank) continue;
        blocks[s].push_back(b);
        added = true;
      }
    }
    return added;
  }

  void shared() {
    for (const CaseFit& fit : fits_) {
      LumpEstimates part;
      part.resonance = fit.set->resonance;
      truncation_slope_.emplace_back();
      std::vector<Index> used, lost;
      for (std::size_t c = 0; c < fit.columns.size() && fit.fit.coefficients.size() > 0; ++c)
        if (fit.columns[c].kind != CaseColumn::Kind::sensor_offset)
          (fit.fit.identifiable[c] ? used : lost).push_back(static_cast<Index>(c));
      const auto single = static_cast<Index>(used.size());
      const MatrixXd together = known_combinations(fit.fit, lost);
      used.insert(used.end(), lost.begin(), lost.end());
      for (const Index c : used) {
        const CaseColumn& column = fit.columns[static_cast<std::size_t>(c)];
        part.index.push_back(column.kind == CaseColumn::Kind::lump ? static_cast<int>(column.index)
                                                                   : -1 - static_cast<int>(column.index));
      }
      const Index size = single + together.rows(), entries = static_cast<Index>(used.size());
      part.combination = MatrixXd::Zero(size, entries);
      part.combination.topLeftCorner(single, single).setIdentity();
      if (together.size() > 0) part.combination.bottomRightCorner(together.rows(), together.cols()) = together;
      if (size > 0) {
        part.values = part.combination * fit.fit.coefficients(used);
        part.plain =
            part.combination * MatrixXd(fit.fit.plain_covariance(used, used)) * part.combination.transpose();
        part.influence = MatrixXd(fit.fit.influence(Eigen::all, used)) * part.combination.transpose();
        part.truncation_effect = fit.truncation_effect(used, Eigen::all);
        truncation_slope_.back() = truncation_slope(fit);
        part.truncation_slope = truncation_slope_.back()(used, Eigen::all);
        part.truncation_at = options_.corrected_at;
        if (!options_.rough_errors) part.rows = rows_of(fit, used);
      }
      part.clustered = fit.fit.covariance_kind == CovarianceKind::clustered;
      part.degrees_of_freedom = fit.fit.degrees_of_freedom;
      lump_estimates_.push_back(std::move(part));
      used_.push_back(std::move(used));
      single_.push_back(static_cast<std::size_t>(single));
    }
    add_resonance_widths();
    VectorXd start = VectorXd::Zero(static_cast<Index>(model_.symbols.size()));
    for (Index p = 0; p < start.size(); ++p) {
      const std::string name(model_.symbols[static_cast<std::size_t>(p)].name);
      if (p < static_cast<Index>(model_.modes()))
        start(p) = knowledge_.natural_frequency[static_cast<std::size_t>(p)];
      for (std::size_t s = 0; s < fits_.size(); ++s)
        for (std::size_t i = 0; i < single_[s]; ++i)
          if (const LumpEstimates& part = lump_estimates_[s];
              part.index[i] >= 0 && part.resonance->lumps[static_cast<std::size_t>(part.index[i])].name == name)
            start(p) = part.values(static_cast<Index>(i));
      if (given_[static_cast<std::size_t>(p)]) start(p) = options_.fixed.at(name);
    }
    shared_ = shared_parameters(lump_estimates_, start, given_, options_.shift, options_.rough_errors);
    result_.parameter_values = shared_.values;
    result_.parameter_sd = shared_.covariance.diagonal().cwiseMax(0).cwiseSqrt();
    if (options_.bootstrap > 0) draw_bootstrap();
  }

  // `used`: columns that parameters make. What the case has lost may be anything.
  static ConditionRows rows_of(const CaseFit& fit, const std::vector<Index>& used) {
    const LinearFit& regression = fit.fit;
    const MatrixXd coordinates = regression.orthonormal.transpose() * fit.system.design;  // of each column
    std::vector<Index> rest;
    for (Index c = 0; c < coordinates.cols(); ++c)
      if (std::find(used.begin(), used.end(), c) == used.end()) rest.push_back(c);
    ConditionRows rows;
    rows.entries = coordinates(Eigen::all, used);
    rows.others.resize(coordinates.rows(), static_cast<Index>(rest.size()) + regression.lost.cols());
    rows.others << MatrixXd(coordinates(Eigen::all, rest)),
        coordinates * regression.scale.asDiagonal() * regression.lost;
    rows.reference = fit.reference(used);
    rows.estimate = coordinates * (regression.coefficients - fit.reference);
    rows.kept = regression.kept;
    rows.residual_sd = regression.residual_sd;
    rows.gram = regression.cluster_gram;
    rows.score = regression.cluster_score;
    return rows;
  }

  // Columns x symbols: how a case's coefficients change with the parameters that the truncation was taken out with,
  // along EstimateOptions::moves.
  MatrixXd truncation_slope(const CaseFit& fit) const {
    const Index symbols = static_cast<Index>(model_.symbols.size()), count = options_.moves.cols();
    if (count == 0 || fit.moves_effect.cols() != count) return MatrixXd::Zero(fit.fit.coefficients.size(), 0);
    VectorXd size = options_.moves.rowwise().norm();
    for (Index p = 0; p < symbols; ++p) size(p) = size(p) > 0 ? 1 / size(p) : 0;
    MatrixXd moves = size.asDiagonal() * options_.moves;
    const VectorXd length = moves.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
    moves = moves * length.cwiseInverse().asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(dependent_moves);
    solver.compute(moves);
    return fit.moves_effect * length.cwiseInverse().asDiagonal() * solver.pseudoInverse() * size.asDiagonal();
  }

  // The lumps of case s, and what the bootstrap drew of them.
  void move(std::size_t s, const VectorXd& change) {
    fits_[s].fit.coefficients += change;
    if (s < bootstrap_lumps_.size() && bootstrap_lumps_[s].rows() == change.size())
      bootstrap_lumps_[s].colwise() += change;
  }

  // Lumps as they would be corrected for the truncation at the parameters found. Of parameters that no lump can
  // tell, where they are as far as all lumps together tell it moves each lump, too, and what they leave open is
  // part of its error bar.
  void place_along_unseen() {
    result_.unseen = shared_.unseen;
    result_.unseen_coordinate = shared_.unseen_coordinate;
    result_.shift = shared_.shift;
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      const CaseFit& fit = fits_[s];
      const Index columns = fit.fit.coefficients.size();
      if (columns == 0 || shared_.slope[s].size() == 0) continue;
      const MatrixXd& effect = fit.truncation_effect;
      const MatrixXd& by_values = truncation_slope_[s];
      // Of a change of the coefficients by noise, what comes back by way of the values.
      MatrixXd back = MatrixXd::Zero(columns, columns), left = MatrixXd::Zero(columns, columns);
      const auto add = [&](const MatrixXd& moves, const MatrixXd& slope) {
        back(Eigen::all, used_[s]) += moves * (slope * lump_estimates_[s].combination);
      };
      if (by_values.cols() > 0) {
        add(by_values, shared_.slope[s]);
        move(s, by_values * (shared_.values - options_.corrected_at));
      }
      if (effect.cols() > 0 && shared_.shift_slope[s].size() > 0) {
        add(effect, shared_.shift_slope[s]);
        const MatrixXd open = effect * shared_.shift_prior;
        left = open * open.transpose();
        const VectorXd& from = options_.shift.corrected_at;
        move(s, effect * (from.size() > 0 ? VectorXd(shared_.shift - from) : shared_.shift));
      }
      const MatrixXd map = MatrixXd::Identity(columns, columns) + back;
      LinearFit& regression = fits_[s].fit;
      regression.influence = regression.influence * map.transpose();
      regression.covariance = map * regression.covariance * map.transpose() + left;
      regression.plain_covariance = map * regression.plain_covariance * map.transpose() + left;
    }
  }

  // A natural frequency that no regression separates from other changes of stiffness is still near the observed
  // one: that is what the resonance means. Without it, coefficients that hold it weakly would have to determine it.
  void add_resonance_widths() {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      bool estimated = false;
      for (std::size_t s = 0; s < fits_.size(); ++s) {
        const std::vector<int>& index = lump_estimates_[s].index;
        const auto end = index.begin() + static_cast<std::ptrdiff_t>(single_[s]);
        estimated = estimated || std::find(index.begin(), end, -1 - static_cast<int>(k)) != end;
      }
      if (estimated || given_[k]) continue;
      LumpEstimates near;
      near.resonance = sets_.front()->resonance;
      near.index = {-1 - static_cast<int>(k)};
      near.combination = MatrixXd::Identity(1, 1);
      near.values = VectorXd::Constant(1, knowledge_.natural_frequency[k]);
      near.plain = MatrixXd::Constant(1, 1, std::pow(resonance_width * near.values(0), 2));
      near.degrees_of_freedom = std::numeric_limits<double>::infinity();
      lump_estimates_.push_back(std::move(near));
    }
  }

  void test_fit() {
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      const CaseFit& fit = fits_[s];
      CaseLackOfFit tests{std::string(fit.set->resonance->name), lack_of_fit(fit)};
      hidden_[s] = hidden_misfit(fit, tests.equations);
      std::string worst;
      double largest = 0;
      for (const LackOfFit& test : tests.equations) {
        if (!test.significant) continue;
        largest = std::max(largest, test.misfit);
        worst += fmt::format("{}{} ({:.1f} times)", worst.empty() ? "" : "; ", test.name, test.misfit);
      }
      if (!worst.empty())
        result_.warnings.push_back(fmt::format(
            "case {}: the model does not fit as well as repeats of one condition agree: {}. It lacks "
            "something there, and its parameters have absorbed part of it: error bars are widened by as "
            "much again as is seen to be wrong",
            tests.resonance, worst));
      if (!tests.equations.empty()) result_.lack_of_fit.push_back(std::move(tests));
    }
  }

  // What parameters may be off by: through the lumps, and because no parameters give all lumps.
  double misfit_of_parameter(Index p) const {
    double square = 0;
    for (std::size_t s = 0; s < fits_.size(); ++s)
      if (hidden_[s].cols() > 0 && shared_.slope[s].rows() > p)
        square += (shared_.slope[s].row(p) * lump_estimates_[s].combination * hidden_[s](used_[s], Eigen::all))
                      .squaredNorm();
    if (result_.consistency.significant)
      square += shared_.plain_covariance(p, p) *
                std::max(0.0, result_.consistency.chi_squared - result_.consistency.degrees_of_freedom);
    return std::sqrt(square);
  }

  void test_consistency() {
    LumpConsistency& c = result_.consistency;
    c.chi_squared = shared_.misfit;
    c.degrees_of_freedom = static_cast<double>(shared_.surplus);
    if (c.degrees_of_freedom < 1 || !std::isfinite(c.chi_squared)) return;
    c.p_value = chi_squared_upper_tail(c.chi_squared, c.degrees_of_freedom);
    c.significant = c.p_value < contradiction_alarm;
    if (c.significant)
      result_.warnings.push_back(fmt::format(
          "the lumps contradict one another: no values of the parameters give all of them (chi-squared {:.0f} on "
          "{:.0f} degrees of freedom); the parameters' error bars are widened by as much",
          c.chi_squared, c.degrees_of_freedom));
  }

  void draw_bootstrap() {
    const Index count = shared_.values.size();
    bootstrap_ = shared_.values.replicate(1, options_.bootstrap);
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      if (fits_[s].fit.coefficients.size() == 0) {
        bootstrap_lumps_.emplace_back();
        continue;
      }
      bootstrap_lumps_.push_back(bootstrap_coefficients(fits_[s], options_.bootstrap, options_.seed + s));
      MatrixXd change(static_cast<Index>(used_[s].size()), options_.bootstrap);
      for (std::size_t i = 0; i < used_[s].size(); ++i)
        change.row(static_cast<Index>(i)) =
            bootstrap_lumps_[s].row(used_[s][i]).array() - fits_[s].fit.coefficients(used_[s][i]);
      if (shared_.slope[s].rows() == count)
        bootstrap_ += shared_.slope[s] * (lump_estimates_[s].combination * change);
    }
  }

  void report_parameters() {
    const CampaignKnowledge known = campaign_knowledge();
    const Identifiability what = identifiability(known);
    for (std::size_t p = 0; p < model_.symbols.size(); ++p) {
      const auto at = static_cast<Index>(p);
      EstimatedValue value;
      value.name = std::string(model_.symbols[p].name);
      value.unit = unit_text(model_.symbols[p].dimension,
                             std::vector<std::string>(model_.modes(), units_.coordinate), units_.excitation);
      if (given_[p]) {
        value.fixed = value.identifiable = true;
        value.value = shared_.values(at);
        value.from = "given";
      } else if (what.determined[p] && shared_.covariance(at, at) > 0) {
        value.identifiable = true;
        value.value = shared_.values(at);
        value.sd = std::sqrt(shared_.covariance(at, at));
        add_misfit(value, misfit_of_parameter(at));
        value.degrees_of_freedom = shared_.degrees_of_freedom(at);
        value.from = source_of(at);
        value.significant = significant(value);
        value.nearly_entangled_with = near_parameters(value.name);
        if (bootstrap_.cols() > 0) value.bootstrap = interval_of(bootstrap_.row(at).transpose());
      } else {
        value.from = "not determined by this campaign";
        for (const int other : what.entangled_with[p])
          value.entangled_with.emplace_back(model_.symbols[static_cast<std::size_t>(other)].name);
      }
      result_.parameters.push_back(std::move(value));
    }
    result_.null_directions = null_directions(known);
  }

  // The blocks of the cases whose lumps move the parameter, by their share of its weight.
  std::string source_of(Index p) const {
    std::string text;
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      const MatrixXd& slope = shared_.slope[s];
      if (slope.rows() == 0) continue;
      std::set<std::size_t> blocks;
      const MatrixXd& combination = lump_estimates_[s].combination;
      for (Index row = 0; row < combination.rows(); ++row) {
        const double part = slope(p, row) * slope(p, row) * lump_estimates_[s].plain(row, row);
        if (!(part > 1e-6 * shared_.covariance(p, p))) continue;
        for (Index i = 0; i < combination.cols(); ++i)
          if (combination(row, i) != 0)
            for (const std::size_t b :
                 blocks_of(fits_[s], static_cast<std::size_t>(used_[s][static_cast<std::size_t>(i)])))
              blocks.insert(b);
      }
      if (blocks.empty()) continue;
      std::string names;
      for (const std::size_t b : blocks)
        names += (names.empty() ? "" : ", ") + std::string(sets_[s]->resonance->blocks[b].name);
      text += (text.empty() ? "" : "; ") +
              (fits_.size() > 1 ? std::string(sets_[s]->resonance->name) + ": " + names : names);
    }
    return text;
  }

  static std::vector<std::size_t> blocks_of(const CaseFit& fit, std::size_t column) {
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

  // Near dependencies of the lump that is the parameter itself.
  std::vector<std::string> near_parameters(const std::string& name) const {
    if (fits_.size() != 1) return {};
    const auto near = nearly_entangled(fits_.front());
    for (std::size_t c = 0; c < near.size(); ++c)
      if (fits_.front().columns[c].kind == CaseColumn::Kind::lump && column_name(fits_.front(), c) == name)
        return near[c];
    return {};
  }

  void report_lumps() {
    for (const ObservationSet* set : all_) {
      const auto fitted = std::find_if(fits_.begin(), fits_.end(), [&](const CaseFit& f) { return f.set == set; });
      for (std::size_t l = 0; l < set->resonance->lumps.size(); ++l) {
        EstimatedValue value;
        value.name = std::string(set->resonance->lumps[l].name);
        value.definition = std::string(set->resonance->lumps[l].definition);
        value.resonance = std::string(set->resonance->name);
        value.unit = unit_text(set->resonance->lumps[l].dimension,
                               std::vector<std::string>(model_.modes(), units_.coordinate), units_.excitation);
        value.from = knowledge_.fixed.count(value.name) != 0 ? "follows from its symbols" : "not used";
        const auto given = options_.fixed.find(value.name);
        if (given != options_.fixed.end()) {
          value.fixed = value.identifiable = true;
          value.value = given->second;
          value.from = "given";
        } else if (fitted != fits_.end() && fitted->fit.coefficients.size() > 0) {
          fill_lump(*fitted, static_cast<std::size_t>(fitted - fits_.begin()), l, value);
        }
        result_.lumps.push_back(std::move(value));
      }
    }
  }

  void fill_lump(const CaseFit& fit, std::size_t s, std::size_t l, EstimatedValue& value) const {
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
      value.value = fit.fit.coefficients(at);
      value.sd = std::sqrt(std::max(0.0, fit.fit.covariance(at, at)));
      if (hidden_[s].cols() > 0) add_misfit(value, hidden_[s].row(at).norm());
      value.degrees_of_freedom = fit.fit.degrees_of_freedom;
      value.significant = significant(value);
      value.partial_f = partial_f(fit)[c];
      value.nearly_entangled_with = nearly_entangled(fit)[c];
      if (s < bootstrap_lumps_.size() && bootstrap_lumps_[s].cols() > 0)
        value.bootstrap = interval_of(bootstrap_lumps_[s].row(at).transpose());
    }
  }

  void report_quality() {
    const auto append = [](auto& to, auto from) {
      to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    for (const CaseFit& fit : fits_) {
      if (fit.fit.coefficients.size() == 0) continue;
      const std::string name(fit.set->resonance->name);
      append(result_.blocks, block_quality(fit));
      append(result_.conditions, condition_quality(fit));
      append(result_.outliers, outlying_ensembles(fit));
      if (options_.damping_laws) append(result_.damping, compare_damping(fit));
      const std::size_t conditions = fit.fit.cluster_labels.size();
      if (fit.fit.covariance_kind != CovarianceKind::clustered)
        result_.warnings.push_back(
            fmt::format("case {}: too few conditions ({} for {} unknowns) for error bars from their scatter; they "
                        "come from the residuals and may be too small",
                        name, conditions, fit.fit.rank));
      std::vector<std::string> near;
      const auto entangled = nearly_entangled(fit);
      for (std::size_t c = 0; c < entangled.size(); ++c)
        if (!entangled[c].empty()) near.push_back(column_name(fit, c));
      if (!near.empty())
        result_.warnings.push_back(fmt::format(
            "case {}: {} act nearly alike on these conditions, their error bars say how little is known of "
            "each; conditions with other levels and other ratios of the amplitudes would part them",
            name, short_list(near)));
      std::vector<std::string> lost;
      for (std::size_t c = 0; c < fit.columns.size(); ++c)
        if (!fit.fit.identifiable[c]) lost.push_back(column_name(fit, c));
      if (!lost.empty())
        result_.warnings.push_back(fmt::format(
            "case {}: {} cannot be told apart on {} condition{} (their columns differ by noise or not at "
            "all); no numbers are given for them",
            name, short_list(lost), conditions, conditions == 1 ? "" : "s"));
    }
    std::vector<std::string> doubtful;
    for (const auto* list : {&result_.parameters, &result_.lumps})
      for (const EstimatedValue& value : *list)
        if (value.doubtful && std::find(doubtful.begin(), doubtful.end(), value.name) == doubtful.end())
          doubtful.push_back(value.name);
    if (!doubtful.empty())
      result_.warnings.push_back("doubtful because the model does not fit: " + short_list(doubtful));
    warn_of_outliers();
  }

  void warn_of_outliers() {
    if (result_.outliers.empty()) return;
    const OutlyingEnsemble& worst =
        *std::max_element(result_.outliers.begin(), result_.outliers.end(),
                          [](const auto& a, const auto& b) { return a.distance < b.distance; });
    std::size_t all = 0;
    for (const CaseFit& fit : fits_) all += fit.set->observations.size();
    const bool one = result_.outliers.size() == 1;
    result_.warnings.push_back(fmt::format(
        "{} of {} ensembles stand{} out from the others of {} condition and count{} less; {}record {}, ensemble at "
        "{:.1f} s: {:.1f} times the usual distance from its condition, weight {:.2g}",
        result_.outliers.size(), all, one ? "s" : "", one ? "its" : "their", one ? "s" : "", one ? "" : "worst ",
        worst.record + 1, worst.centre_s, worst.distance, worst.weight));
  }

  const CompiledModel& model_;
  MeasuredUnits units_;
  const EstimateOptions& options_;
  std::vector<const ObservationSet*> sets_, all_;  // those with observations, and all
  std::vector<bool> given_;
  CaseKnowledge knowledge_;
  std::map<std::string, double> shifts_;  // know_shifts
  std::vector<CaseFit> fits_;
  std::vector<RegressionState> states_;  // by fit; without weights: none yet
  std::vector<LumpEstimates> lump_estimates_;
  std::vector<std::vector<Index>> used_;    // by fit: columns that are in lump_estimates_, identifiable ones first
  std::vector<MatrixXd> truncation_slope_;  // by fit: see truncation_slope
  std::vector<std::size_t> single_;         // by fit: how many of them are identifiable
  std::vector<MatrixXd> hidden_;            // by fit: hidden_misfit
  SharedParameters shared_;
  MatrixXd bootstrap_;
  std::vector<MatrixXd> bootstrap_lumps_;
  Estimate result_;
};

}  // namespace

Estimate estimate(std::span<const ObservationSet> sets, const MeasuredUnits& units,
                  const EstimateOptions& options) {
  const bool any =
      std::any_of(sets.begin(), sets.end(), [](const ObservationSet& s) { return !s.observations.empty(); });
  if (!any) {
    std::string names, why = "the campaign has no record of the kind it needs";
    for (auto set = sets.rbegin(); set != sets.rend(); ++set) {
      names = std::string(set->resonance->name) + (names.empty() ? "" : ", ") + names;
      if (!set->warnings.empty()) why = set->warnings.front();
    }
    throw InputError("case " + names, "", "no observations are left to identify it from", why);
  }
  return Estimator(sets, units, options).run();
}

Estimate estimate(const ObservationSet& set, const std::string& coordinate_unit,
                  const std::vector<std::string>& excitation_units, const EstimateOptions& options) {
  return estimate(std::span(&set, 1), {coordinate_unit, excitation_units}, options);
}

}  // namespace secular
