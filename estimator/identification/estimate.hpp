#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/identification/estimate_pass.hpp"
#include "estimator/identification/estimate_quality.hpp"
#include "estimator/identification/lack_of_fit.hpp"
#include "estimator/identification/scatter_between_records.hpp"
#include "estimator/identification/shared_parameters.hpp"
#include "input/numerical_failure.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// A number with its error bar, or the reason why there is none.
struct EstimatedValue {
  std::string name;
  std::string definition;  ///< lumps: the combination of symbols
  std::string resonance;   ///< lumps: the case
  std::optional<double> value;
  double sd = 0, degrees_of_freedom = 0;
  double noise_sd = 0;  ///< the part of `sd` that another measurement would draw anew
  /// The part that it would not: what entangled parameters do beyond the expansion, as far as the data leave it
  /// open.
  double open_sd = 0;
  double truncation = 0;  ///< what was subtracted for the expansion's truncation
  /// By how much an effect that the model lacks may have moved it, judged by what no parameter explains; counts as
  /// two standard deviations in sd. 0: the equations fit as well as repeats of a condition agree.
  double misfit = 0;
  /// May be off by more than its error bar: `misfit` is more than two standard deviations without it, or something
  /// else that a warning of the estimate names.
  bool doubtful = false;
  std::vector<std::string> doubtful_because;  ///< each reason once; none where it is not doubtful
  std::string unit;
  bool identifiable = false;
  bool significant = false;          ///< differs from zero at 95 %
  bool fixed = false;                ///< given by the user
  std::string from;                  ///< the equations it comes from
  std::vector<std::string> told_by;  ///< cases
  std::vector<std::string> entangled_with;
  /// Of the same case: those it is hard to tell from on this data (condition index above 30, variance shared).
  std::vector<std::string> nearly_entangled_with;
  std::optional<PartialF> partial_f;           ///< lumps
  std::optional<BootstrapInterval> bootstrap;  ///< if asked for
  /// Natural frequencies that several records of free vibration tell; of several cases the one with most records.
  std::optional<ScatterBetweenRecords> between_records;
};

/// Lack of fit of one case's equations (lack_of_fit).
struct CaseLackOfFit {
  std::string resonance;
  std::vector<LackOfFit> equations;
};

/// Do the lumps of all cases go together with one set of parameters? Chi-squared of what is left of them.
struct LumpConsistency {
  double chi_squared = 0, degrees_of_freedom = 0, p_value = 1;
  bool significant = false;
};

/// Noise of a mode's lines that their tables do not say.
struct UnstatedNoise {
  std::string resonance, mode;
  double sd = 0;                  ///< of a line's real part, peak, modal displacement
  double degrees_of_freedom = 0;  ///< of what the model leaves of the rows
  std::size_t rows = 0;           ///< of tables
};

/// What an estimate ended with: where another one of nearly the same equations may start.
struct EstimationState;

struct Estimate {
  std::vector<const CompiledCase*> cases;         ///< in the order of their lumps
  std::vector<EstimatedValue> parameters, lumps;  ///< lumps of all cases, one after the other
  std::vector<BlockQuality> blocks;
  std::vector<CaseLackOfFit> lack_of_fit;
  LumpConsistency consistency;
  std::vector<ConditionQuality> conditions;
  std::vector<OutlyingEnsemble> outliers;
  std::vector<DampingComparison> damping;
  std::vector<NullDirection> null_directions;  ///< what the campaign leaves open
  Eigen::VectorXd parameter_values;  ///< by CompiledModel::symbols: a representative that reproduces the lumps
  /// Symbols x directions: SharedParameters::null_space.
  Eigen::MatrixXd null_space;
  Eigen::MatrixXd null_space_coordinate;  ///< directions x symbols: SharedParameters::null_space_coordinate
  /// How far parameters are along the directions of ObservationSet::truncation_change:
  /// SharedParameters::null_coordinate.
  Eigen::VectorXd null_coordinate, null_coordinate_sd;
  /// Symbols x independent directions: how far representative_parameters may be along each, one standard deviation,
  /// by the noise of the measurement, and by what it leaves open.
  Eigen::MatrixXd noise, open;
  /// Symbols x symbols: of parameters with a number. Without what misfits and doubts add to single error bars.
  Eigen::MatrixXd covariance;
  Eigen::VectorXd parameter_sd;  ///< of `parameter_values` by the noise of the lumps; 0 where they say nothing
  std::vector<UnstatedNoise> unstated_noise;
  bool correction_settled = true;  ///< no value moved by more than its error bar: with_unsettled_correction()
  std::vector<std::string> warnings;
  std::shared_ptr<const EstimationState> state;
};

struct EstimateOptions {
  std::map<std::string, double> fixed;  ///< by symbol: parameters that are not estimated
  int bootstrap = 0;                    ///< resamples of the conditions; 0: none
  std::uint64_t seed = 1;               ///< of the bootstrap
  bool damping_laws = true;             ///< compare them
  bool refine = false;                  ///< maximum likelihood with errors in everything measured
  unsigned threads = 1;                 ///< the result does not depend on it
};

/// What a value is called in a list of several. CASE:NAME where the name alone does not say which one: a lump that
/// is no symbol, of one of several cases.
std::string label_of(const EstimatedValue& value, const Estimate& estimate);

/// Units of what was measured, for the units of what is estimated.
struct MeasuredUnits {
  std::string coordinate;
  std::vector<std::string> excitation;
};

/// Of what was measured nothing is left to estimate from, or to begin at. Of a campaign as it was measured that is
/// for its user to mend; of what equations make of it, a way that does not lead further.
class NothingObserved : public NumericalFailure {
 public:
  explicit NothingObserved(const std::string& message) : NumericalFailure(Ending::out_of_range, message) {}
};

/// One-step regression of all observations of all cases of one model on the generated rows. In each case the
/// modulation equations, natural frequencies with them, together with those first-order harmonics (the component at
/// zero frequency too, where displacements are measured) that see something which the modulation equations of all
/// cases leave open. Every equation is whitened by the joint noise of everything measured in it. Physical
/// parameters, shared by all cases, follow from the lumps of all cases by nonlinear least squares weighted with
/// their full covariance, as far as the lumps determine them; error bars come from the scatter between conditions
/// (jackknife) carried through that map. Throws NothingObserved where no observations are left or a natural
/// frequency is neither observed nor known, InputError where a fixed name is unknown.
Estimate estimate(std::span<const ObservationSet> sets, const MeasuredUnits& units, const EstimateOptions& options,
                  const EstimatePass& pass = {});

/// The same for one case.
Estimate estimate(const ObservationSet& set, const std::string& coordinate_unit,
                  const std::vector<std::string>& excitation_units, const EstimateOptions& options,
                  const EstimatePass& pass = {});

/// The sets with what the truncated equations leave at the `replayed` motions of the full equations at `parameters`
/// (ObservationSet::truncation): regressing them gives estimates without that bias. Observations that were not
/// replayed are left out.
std::vector<ObservationSet> with_truncation(std::span<const ObservationSet> sets,
                                            std::span<const ObservationSet> replayed,
                                            const Eigen::VectorXd& parameters, unsigned threads = 1);

/// By set and observation: how the truncation of the `corrected` sets changes from the parameters they were
/// corrected at to other `parameters`, with which the full equations make the `replayed` motions. Observations that
/// were not replayed do not change.
std::vector<Eigen::MatrixXcd> truncation_difference(std::span<const ObservationSet> corrected,
                                                    std::span<const ObservationSet> replayed,
                                                    const Eigen::VectorXd& parameters, unsigned threads = 1);

/// The changes of `from` along with the observations of `to`.
void keep_truncation_change(std::span<ObservationSet> to, std::span<const ObservationSet> from);

/// `corrected`, the estimate from sets with_truncation, with its difference to the `raw` one as the correction.
Estimate with_correction_shown(Estimate corrected, const Estimate& raw);

/// `latest`, corrected for the truncation at the parameters `before`, with the step to the parameters `next`, at
/// which it would be corrected once more, in its error bars: what has not come to rest is not known. Values that it
/// moves by more than their error bar are doubtful, and a warning names them.
Estimate with_unsettled_correction(Estimate latest, const Eigen::VectorXd& before, const Eigen::VectorXd& next);

/// An estimate whose parameters do not make the measured motion when put into the full equations, for the reason
/// `why`: nothing that was estimated can be relied upon, and a warning says so. Values whose error bars do not come
/// from the scatter between conditions are taken out.
Estimate with_failed_correction(Estimate raw, const std::string& why);

}  // namespace secular
