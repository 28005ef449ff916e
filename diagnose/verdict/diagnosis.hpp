#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/steadiness.hpp"
#include "diagnose/inference/residual_structure.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/cause_report.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "diagnose/verdict/fitted_numbers.hpp"
#include "diagnose/verdict/frequency_scatter.hpp"
#include "diagnose/verdict/gap_shares.hpp"
#include "diagnose/verdict/late_records.hpp"
#include "diagnose/verdict/model_alone.hpp"
#include "diagnose/verdict/proposal.hpp"
#include "diagnose/verdict/simulated_check.hpp"
#include "measure/data/time_span.hpp"

namespace secular {

struct GapReport {
  Judged judged = Judged::fitted;
  bool detected = false;
  double p_value = 1;
  double before = 0, after = 0, floor = 1;
  double closed = 0, closed_low = 0, closed_high = 0;
  std::optional<double> left_share;  ///< of the gap, where the verdict is approximate
  bool noise_misjudged = false;      ///< the rows scatter far less than the repeatability that they are measured in
  std::string metric;
  double wrong_cause_closed = 0;  ///< by the best explanation outside the set
  std::string wrong_cause;
  std::optional<double> placebo_closed;  ///< see secular::placebo_closed
};

struct Diagnosis {
  GapReport gap;
  Unsteadiness unsteady;
  std::vector<GapShare> where;
  std::string verdict, cause;
  std::string unknown_because;  ///< where the verdict is unknown
  std::vector<std::string> set;
  std::vector<std::string> together;   ///< two effects that act at once, each by name, the leading one first
  std::vector<std::string> second_or;  ///< effects that the data cannot tell from the second of them
  std::optional<OpenLaw> open_law;  ///< where it is a better explanation than any effect or pair of the catalogue
  std::vector<CauseReport> causes;
  std::vector<ParameterMove> parameters_moved;
  FittedNumbers fitted;              ///< of the best explanation, or of the model as it is where there is no gap
  double data_used = 0;              ///< see Comparison
  bool decays_in_one_piece = false;  ///< free decays have one state each; else one a segment
  ResidualStructure residual_structure;
  LateRecords late;                       ///< beside the explanation, where dwells may be
  FrequencyScatter frequency_scatter;     ///< about the explanation, where it was admitted
  std::map<std::size_t, TimeSpan> spans;  ///< of the records that were read, within the window
  NextExperiment next_experiment;
  std::optional<SimulatedCheck> simulated;  ///< where a gap was found
  std::vector<std::string> warnings;
  // For figures and later questions:
  std::vector<RowLabel> labels;
  Eigen::VectorXd rows_before, rows_after;
  std::size_t conditions = 0;
};

/// Whether nothing beyond repeatability is left: there is no gap, or it is explained.
bool is_told(const Diagnosis& diagnosis);

/// A diagnosis up to its verdict, for those who compare several before they ask one for all that it has to say.
/// Arguments and errors as of diagnose(); `near`: see InferenceOptions.
class OpenDiagnosis {
 public:
  OpenDiagnosis(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                const DiagnosisOptions& options, const Inference* near = nullptr);
  OpenDiagnosis(OpenDiagnosis&&) noexcept;
  OpenDiagnosis& operator=(OpenDiagnosis&&) noexcept;
  ~OpenDiagnosis();

  /// Whether what the verdict is about leaves no more than noise.
  bool leaves_noise_alone() const;
  /// Whether natural frequencies of each record's own were admitted at last: where none are found to differ, they
  /// are not, and the diagnosis is that of a campaign whose frequencies are all the same.
  bool admits_scatter() const;
  const Diagnosis& so_far() const;  ///< without next_experiment (but its reason where there is no gap), simulated
  /// Whether natural frequencies of each record's own beside the model alone, a fit of the same records that admits
  /// them, keep a twentieth of the odds of what the verdict is about (docs/inference.md (26a)).
  bool has_as_credible(const ModelAlone& scatter) const;
  void make_unknown(const std::string& why);
  /// Of the explanation that the verdict is about, or of the model as it is.
  const Refit& fit() const;
  /// Of all explanations.
  const Inference& inference() const;
  bool holds_decays() const;
  /// With the scales that its strengths are of.
  const std::vector<StateForce>& forces() const;
  /// Adds what no verdict waits for, and much time goes into: the next experiment, and motions simulated before and
  /// after.
  Diagnosis finish() &&;

 private:
  class Stages;
  std::unique_ptr<Stages> stages_;
};

/// Diagnoses the gap between a model and a campaign; `effects`: of the model, those that it is tried with. Throws
/// InputError where the campaign holds nothing that the model can be compared with.
Diagnosis diagnose(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options);

}  // namespace secular
