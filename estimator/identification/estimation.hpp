#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/estimate.hpp"
#include "estimator/identification/identifiability.hpp"
#include "estimator/identification/lump_key.hpp"
#include "estimator/identification/shared_parameters.hpp"

namespace secular {

struct EstimationState {
  std::vector<std::vector<std::size_t>> blocks;  ///< by case with observations
  std::vector<RegressionState> regressions;
  std::vector<double> natural_frequency;
  LumpValues frequency_lumps;  ///< lumps that were given what their symbols make of them
};

/// An estimate on its way: what each stage has found for the next ones.
struct Estimation {
  /// Throws InputError for a fixed name that is no symbol, NothingObserved for one of a case that is no longer seen
  /// and for a natural frequency that nothing tells.
  Estimation(std::span<const ObservationSet> measured, const MeasuredUnits& measured_units,
             const EstimateOptions& asked, const EstimatePass& asked_pass = {});

  const CompiledModel& model;
  MeasuredUnits units;
  const EstimateOptions& options;
  const EstimatePass pass;
  std::vector<const ObservationSet*> sets, all;  ///< those with observations, and all
  std::vector<bool> given;                       ///< by symbol
  // Of the cases, see fit_rounds.
  CaseKnowledge knowledge;
  LumpValues frequency_lumps;                    ///< see know_frequency_lumps
  std::vector<std::vector<std::size_t>> blocks;  ///< by fit: equations that are regressed
  std::vector<CaseFit> fits;
  std::vector<RegressionState> states;  ///< by fit; without weights: none yet
  // Of the parameters, see share_parameters.
  std::vector<LumpEstimates> lump_estimates;
  std::vector<std::vector<Eigen::Index>> used;    ///< by fit: columns in lump_estimates, identifiable ones first
  std::vector<Eigen::MatrixXd> truncation_slope;  ///< by fit: of the coefficients, by parameters
  std::vector<std::size_t> single;                ///< by fit: how many of `used` are identifiable
  SharedParameters shared;
  std::vector<Eigen::VectorXd>
      open_variance;  ///< by fit: of the coefficients, SharedParameters::open_variance's kin
  /// How far along EstimatePass::moves, then along the directions of ObservationSet::truncation_change,
  /// parameters may be: (moves, directions) x independent unknowns. Empty: not known.
  Eigen::MatrixXd truncation_unknown;
  Eigen::MatrixXd bootstrap;
  std::vector<Eigen::MatrixXd> bootstrap_lumps;
  // Of what does not fit, see test_fit.
  std::vector<Eigen::MatrixXd> hidden;  ///< by fit: hidden_misfit
  Estimate result;
};

/// How far a regression's weights are followed.
enum class Precision { rough, full };

/// Regresses every case, with the harmonics that say something new and natural frequencies that go together: from
/// what an earlier estimate ended with, or else roughly, for fit_cases to go on from.
Precision fit_rounds(Estimation& e);
/// Regresses every case once.
void fit_cases(Estimation& e, Precision precision);
/// Where damping is of the first order, the second one shifts the frequency by a lump of its own (-mu^2/(2 omega)),
/// whose column is that of the natural frequency: neither can be determined. The lump's symbols are known from
/// elsewhere, though, and it depends on the natural frequency weakly: it is given its value, and the frequency can
/// be. Whether there is one.
bool know_frequency_lumps(Estimation& e);
/// These lumps as they are at the parameters that were found with them, for the next estimate.
void follow_frequency_lumps(Estimation& e);
/// CASE:NAME
std::string text_of(const LumpKey& key);
/// The value of a lump that is given itself, CASE:NAME, or is a given symbol.
std::optional<double> given_value(const Estimation& e, const CompiledCase& resonance, std::size_t lump);
/// Whether it is given itself.
bool is_given_itself(const Estimation& e, const CompiledCase& resonance, std::size_t lump);
/// Which lumps and natural frequencies the fits tell.
CampaignKnowledge campaign_knowledge(const Estimation& e);

/// Parameters from the lumps of all cases.
void share_parameters(Estimation& e);
/// What resampled conditions give for parameters and lumps.
void draw_bootstrap(Estimation& e);
/// Lumps as they would be corrected for the truncation at the parameters found. Of parameters that no lump can
/// tell, where they are as far as all lumps together tell it moves each lump, too, and what they leave open is part
/// of its error bar.
void place_along_null_space(Estimation& e);

/// Whether equations hold as well as repeats agree, and the lumps of all cases with one another; else warnings.
void test_fit(Estimation& e);
void test_consistency(Estimation& e);
/// What a parameter may be off by: through the lumps, and because no parameters give all lumps.
double misfit_of_parameter(const Estimation& e, Eigen::Index parameter);

/// Fill Estimation::result: values with errors, intervals and units; lumps likewise, by case; what regressions say
/// of their fit. Last of all.
void report_parameters(Estimation& e);
void report_lumps(Estimation& e);
void report_quality(Estimation& e);

}  // namespace secular
