#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/verdict/blows_alone.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/decay_scatter.hpp"
#include "diagnose/verdict/diagnosis.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

/// What several diagnoses of one campaign, each beside other things that its records may have of their own, make of
/// it.
struct StepwiseDiagnosis {
  Diagnosis diagnosis;                    ///< the answer
  std::vector<Disturbance> disturbances;  ///< found in the records, and told by the answer
  bool numbers_were_a_start = false;      ///< those given (are_rough_frequencies): all parameters are fitted
  std::string decays_warning;             ///< DecayScatter::warning
  std::optional<BlowsAlone> blows;        ///< whose excitation does not count in the answer; nothing: all do
  std::string blows_warning;              ///< where there are such
};

/// What `secular diagnose` answers. Foreign content of the readings is allowed for before anything is tried, then
/// what differs from record to record is, one allowance after the other (find_allowances); each counts where the
/// diagnosis then accounts for more than without, and blows last of all count only by what follows them. Doubts
/// turn an answer into "unknown".
///
/// `effects`: of the model, those that it is tried with. `options`: of diagnose(); what records are allowed to have
/// of their own is set here. `found`: what their samples hold beside the motion. `identified`: asked at most once;
/// none: decays are not asked whether their frequencies differ. Errors as of diagnose().
StepwiseDiagnosis diagnose_step_by_step(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                                        DiagnosisOptions options, std::vector<Disturbance> found,
                                        const EstimatedParameters& identified);

}  // namespace secular
