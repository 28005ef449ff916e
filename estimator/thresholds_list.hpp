#pragma once

#include <array>
#include <cstddef>

#include "estimator/thresholds.hpp"

namespace secular {

/// What docs/thresholds.md prints, in its order.
inline constexpr std::array estimator_threshold_list = {
    Threshold<EstimatorThresholds>{
        "contradiction_alarm", &EstimatorThresholds::contradiction_alarm, ThresholdKind::alarm, "probability",
        "lumps of a model that holds contradict one another", "per campaign; docs/inference.md, Contradiction",
        "identification/fit_judgement.cpp"},
    Threshold<EstimatorThresholds>{"sign_alarm", &EstimatorThresholds::sign_alarm, ThresholdKind::alarm,
                                   "probability", "the lateness of the right minimum looks impossible",
                                   "docs/inference.md (20)", "identification/lateness_sign.cpp"},
    Threshold<EstimatorThresholds>{"common_delay_alarm", &EstimatorThresholds::common_delay_alarm,
                                   ThresholdKind::alarm, "probability",
                                   "the same for a delay that all records share", "docs/inference.md (21)",
                                   "identification/lateness_sign.cpp"},
    Threshold<EstimatorThresholds>{"false_lateness", &EstimatorThresholds::false_lateness, ThresholdKind::alarm,
                                   "probability", "records whose phases hold are said to be late",
                                   "docs/inference.md (18), (19)", "identification/record_lateness.cpp"},
    Threshold<EstimatorThresholds>{"phase_alarm", &EstimatorThresholds::phase_alarm, ThresholdKind::alarm,
                                   "probability", "noise makes a minimum higher than it is by what tells it apart",
                                   "docs/inference.md (17)", "identification/phase_fit.cpp"},
    Threshold<EstimatorThresholds>{"false_lack_of_fit", &EstimatorThresholds::false_lack_of_fit,
                                   ThresholdKind::alarm, "probability", "equations that hold show a lack of fit",
                                   "per case; docs/inference.md (14)", "identification/lack_of_fit.cpp"},
    Threshold<EstimatorThresholds>{"excluding_probability", &EstimatorThresholds::excluding_probability,
                                   ThresholdKind::alarm, "probability", "the better damping law is excluded",
                                   "signed ranks (Wilcoxon)", "identification/case_quality.cpp"},
    Threshold<EstimatorThresholds>{
        "outlier_false_alarm", &EstimatorThresholds::outlier_false_alarm, ThresholdKind::alarm, "probability",
        "an ensemble of a clean campaign is down-weighted", "per campaign; docs/inference.md, Outlying ensembles",
        "identification/case_regression.cpp"},
    Threshold<EstimatorThresholds>{"interval_tail", &EstimatorThresholds::interval_tail, ThresholdKind::alarm,
                                   "probability", "the truth is beyond one end of an interval", "95 % intervals",
                                   "identification/estimate_values.cpp, identification/record_scatter.cpp"},
    Threshold<EstimatorThresholds>{"setting_alarm", &EstimatorThresholds::setting_alarm, ThresholdKind::alarm,
                                   "probability", "departures at random follow the settings",
                                   "per campaign; docs/inference.md (26), (52), (58)",
                                   "identification/setting_functions.cpp, motion/correction/own_frequencies.cpp"},
    Threshold<EstimatorThresholds>{
        "fewest_freedom", &EstimatorThresholds::fewest_freedom, ThresholdKind::tuned, "degrees of freedom",
        "that tell a scatter: of windows of decays, of conditions, of rows of tables",
        "a standard deviation is known to 1/sqrt(2 n), a third; docs/inference.md (6), (14)",
        "identification/lack_of_fit.cpp, identification/residual_information.cpp, regression/linear_fit.cpp, "
        "measure/observe/tabled_tones.cpp"},
    Threshold<EstimatorThresholds>{
        "freedom_beside_settings", &EstimatorThresholds::freedom_beside_settings, ThresholdKind::tuned,
        "degrees of freedom", "that tell a law of frequencies from scatter",
        "docs/inference.md (26): 0.8 of the variance with two functions", "identification/setting_functions.cpp"},
    Threshold<EstimatorThresholds>{"repeats_of_short_decays", &EstimatorThresholds::repeats_of_short_decays,
                                   ThresholdKind::tuned, "measured noise", "scatter where windows do not tell it",
                                   "draws of three short decays: right models 1.2 to 3.4, one without friction 21; "
                                   "alarm from 2.3 times this on",
                                   "identification/lack_of_fit.cpp"},
    Threshold<EstimatorThresholds>{"near_dependency", &EstimatorThresholds::near_dependency, ThresholdKind::tuned,
                                   "condition index", "columns that a warning calls dependent",
                                   "Belsley, Kuh and Welsch 1980", "identification/case_quality.cpp"},
    Threshold<EstimatorThresholds>{"shared_variance", &EstimatorThresholds::shared_variance, ThresholdKind::tuned,
                                   "share of the variance", "rests mainly on a direction",
                                   "Belsley, Kuh and Welsch 1980",
                                   "identification/case_quality.cpp, regression/linear_fit.cpp"},
    Threshold<EstimatorThresholds>{"replicates_needed", &EstimatorThresholds::replicates_needed,
                                   ThresholdKind::tuned, "ensembles", "of a condition, that tell an outlier",
                                   "no record of the draws", "identification/case_regression.cpp"},
    Threshold<EstimatorThresholds>{
        "frequency_prior_sd", &EstimatorThresholds::frequency_prior_sd, ThresholdKind::tuned, "relative",
        "a natural frequency about the observed one where nothing else tells it (disclosed)",
        "no record of the draws", "identification/parameter_stage.cpp"},
    Threshold<EstimatorThresholds>{
        "noise_ratio", &EstimatorThresholds::noise_ratio, ThresholdKind::tuned, "errors of the columns, squared",
        "a direction with less differs by its own errors", "docs/inference.md (5)", "regression/linear_fit.cpp"},
};
static_assert(sizeof(EstimatorThresholds) == 8 * estimator_threshold_list.size(), "each has its row");

}  // namespace secular
