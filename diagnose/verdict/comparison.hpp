#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/evidence/condition_rows.hpp"
#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/evidence/steadiness.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "measure/data/time_span.hpp"

namespace secular {

/// A campaign made comparable with a model: everything that was measured, as rows that are functions of the
/// unknowns (symbols of the augmented model, then the faults of the table), and what may explain them.
struct Comparison {
  std::vector<StateForce> forces;  ///< with scales from the data
  SensorModel sensors;
  FaultTable faults;
  /// Unknowns that disturb and explain nothing, the offsets of velocities and accelerations: fitted beside the
  /// model as it is and beside every explanation of a gap. Where a displacement rests is the motion's, too.
  std::vector<std::size_t> nuisances;
  Eigen::VectorXd start;  ///< given or nominal values; zero where there is neither
  std::vector<Condition> conditions;
  std::size_t segments = 0;
  double data_used = 0;  ///< of the samples that the records hold within the window
  std::vector<Candidate> candidates;
  Discrepancy discrepancy;
  RecordNuisances of_records;                         ///< that `discrepancy` admits
  const SegmentEvidence* segment_evidence = nullptr;  ///< part of `discrepancy`; null: there is none
  std::optional<SegmentEvidence> apart;               ///< of the window to check on
  Unsteadiness unsteady;
  std::map<std::size_t, TimeSpan> spans;  ///< of the records that were read, within the window
  std::vector<std::string> warnings;

  /// The model's own symbols and the nuisances.
  std::vector<std::size_t> fitted_beside(std::vector<std::size_t> own) const;
  ConditionModel condition_model(const CompiledModel& model) const;
  std::vector<std::string> unknown_names(const CompiledModel& model) const;
};

/// Throws InputError where options name what is not there, where the model has no rough natural frequency, and
/// where the campaign holds nothing that the model can be compared with. See diagnose() for the arguments.
Comparison compare(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options);

/// What the unknowns leave of the records that are compared sample by sample: of their samples one behind the
/// other, from the begin of each, as many as evidence of lines needs.
std::vector<SegmentEvidence::Left> left_of_records(const CampaignAndModel& sides, const Comparison& comparison,
                                                   const DiagnosisOptions& options,
                                                   const Eigen::VectorXd& unknowns);

/// Records whose segments depart from every law of the amplitude, a warning each.
std::vector<std::string> disturbed_records(const Comparison& comparison, const Campaign& campaign);

}  // namespace secular
