#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/candidate.hpp"
#include "diagnose/gap_shares.hpp"
#include "diagnose/inference.hpp"
#include "diagnose/next_experiment.hpp"
#include "diagnose/simulated_check.hpp"
#include "estimator/identification/observation_set.hpp"

namespace secular {

struct DiagnosisOptions {
  Window window;
  /// The user's numbers by symbol; the gap of these is diagnosed. Empty: every parameter is the campaign's to
  /// choose.
  std::map<std::string, double> parameters;
  std::map<std::string, double> parameter_sd;  ///< where the numbers came with error bars
  std::set<std::string> open;                  ///< of `parameters`: only starts, nothing was said of these
  std::vector<StateForce> forces;              ///< scales are set from the data
  std::set<std::string> left_out;              ///< effects that are not to be considered
  std::optional<Band> band;     ///< free decays pass through it, so that other modes do not count as a gap
  std::optional<Window> check;  ///< part of the records on which the explanation is tried, whatever was fitted
  bool fit_check = false;       ///< and once more with the numbers that fit that part best
  unsigned threads = 1;
};

struct CauseReport {
  std::string effect, subject;
  double probability = 0;
  double coefficient = 0, sd = 0;
  std::string coefficient_name;
  std::optional<double> closed;
};

/// Whose gap it is.
enum class Judged {
  fitted,            ///< the model with whatever parameters fit best
  given,             ///< the numbers that were given
  within_error_bars  ///< the numbers that were given, as far as their error bars reach
};

std::string to_string(Judged judged);

struct GapReport {
  Judged judged = Judged::fitted;
  bool detected = false;
  double p_value = 1;
  double before = 0, after = 0, floor = 1;
  double closed = 0, closed_low = 0, closed_high = 0;
  std::string metric;
  double wrong_cause_closed = 0;  ///< by the best explanation outside the set
  std::string wrong_cause;
  std::optional<double> placebo_closed;  ///< see secular::placebo_closed
};

/// Settled motions that vary within dwells by more than noise though the excitation is steady: a force that no
/// channel records, or a structure that changes from minute to minute. No effect of the catalogue does that.
struct Unsteadiness {
  bool detected = false;
  double p_value = 1;
  double ratio = 1;    ///< variation of resonant lines over that of the noise beside them
  std::string record;  ///< where it is largest
};

/// The test that should come next.
struct NextExperiment {
  std::optional<ProposedDwell> dwell;  ///< the best one, whether it is good enough to be proposed or not
  bool proposed = false;
  std::vector<std::string> separates;  ///< effects that the test tells apart
  std::string reason;                  ///< why none is proposed
};

/// What the best explanation leaves.
struct RemainderReport {
  double p_value = 1;         ///< of the sum of squares of all rows
  double smooth_p_value = 1;  ///< of smooth_remainder
  double smooth_share = 0;    ///< what that is beyond noise of all that there was to explain, as amplitudes
};

/// A force outside of the catalogue that explains the gap.
struct OpenLaw {
  std::string mode;
  std::string law;  ///< see secular::open_laws
  double exponent = 0, sd = 0;
  double probability = 0;
};

struct ParameterMove {
  std::string name;
  double from = 0, to = 0, sd = 0;
};

struct Diagnosis {
  GapReport gap;
  Unsteadiness unsteady;
  std::vector<GapShare> where;
  std::string verdict, cause;
  std::vector<std::string> set;
  std::vector<std::string> together;   ///< two effects that act at once, each by name, the leading one first
  std::vector<std::string> second_or;  ///< effects that the data cannot tell from the second of them
  std::optional<OpenLaw> open_law;  ///< where it is a better explanation than any effect or pair of the catalogue
  std::vector<CauseReport> causes;
  std::vector<ParameterMove> parameters_moved;
  RemainderReport remainder;
  NextExperiment next_experiment;
  std::optional<SimulatedCheck> simulated;  ///< where a gap was found
  std::vector<std::string> warnings;
  // For figures and later questions:
  std::vector<RowLabel> labels;
  Eigen::VectorXd rows_before, rows_after;
  std::size_t conditions = 0;
};

/// Diagnoses the gap between a model and a campaign. `model` is the augmented model, `own` lists the symbols of the
/// model as it was. Throws InputError where the campaign holds nothing that the model can be compared with.
Diagnosis diagnose(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
                   const std::vector<std::size_t>& own, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options);

}  // namespace secular
