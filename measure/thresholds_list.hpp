#pragma once

#include <array>
#include <cstddef>

#include "measure/thresholds.hpp"

namespace secular {

/// What docs/thresholds.md prints, in its order.
inline constexpr std::array measure_threshold_list = {
    Threshold<MeasureThresholds>{"clipping_false_alarm", &MeasureThresholds::clipping_false_alarm,
                                 ThresholdKind::alarm, "probability",
                                 "short runs at an extreme are called clipping",
                                 "per end of the range of a channel", "data/clipping.cpp, data/clipping.hpp"},
    Threshold<MeasureThresholds>{"jitter_false_alarm", &MeasureThresholds::jitter_false_alarm, ThresholdKind::alarm,
                                 "probability", "noise that grows with the frequency is called jitter",
                                 "per channel", "data/jitter.cpp"},
    Threshold<MeasureThresholds>{
        "disturbance_false_alarm", &MeasureThresholds::disturbance_false_alarm, ThresholdKind::alarm, "probability",
        "a record that holds nothing of a kind is said to hold it", "per campaign and row of the catalogue",
        "app/shared/scatter_output.cpp, observe/decay_observation.cpp, diagnose/verdict/decay_scatter.cpp, "
        "diagnose/verdict/told_disturbances.cpp, "
        "data/false_alarm.cpp"},
    Threshold<MeasureThresholds>{"weak_partner", &MeasureThresholds::weak_partner, ThresholdKind::alarm,
                                 "probability", "noise is taken for the partner that a motion would have",
                                 "per foreign tone", "disturbances/motion_tones.cpp"},
    Threshold<MeasureThresholds>{"spikes_not_told", &MeasureThresholds::spikes_not_told, ThresholdKind::alarm,
                                 "probability",
                                 "a wrong sample among many is not distinguished from a corner of the motion",
                                 "per wrong sample; of all of them, that places at random seem fixed phases",
                                 "disturbances/impulses.cpp, disturbances/motion_events.cpp"},
    Threshold<MeasureThresholds>{"combination_by_chance", &MeasureThresholds::combination_by_chance,
                                 ThresholdKind::alarm, "probability",
                                 "a mode is at the frequency of a combination of others by chance",
                                 "per mode, over all combinations listed", "modal/survey_tones.cpp"},
    Threshold<MeasureThresholds>{"offset_sd", &MeasureThresholds::offset_sd, ThresholdKind::alarm,
                                 "standard deviations", "a mean below it is no offset", "probability 6e-5",
                                 "data/data_quality.cpp"},
    Threshold<MeasureThresholds>{"dwell_drift_sd", &MeasureThresholds::dwell_drift_sd, ThresholdKind::alarm,
                                 "standard deviations", "change of amplitude over a dwell that has not settled",
                                 "probability 6e-5", "observe/dwell_observation.cpp"},
    Threshold<MeasureThresholds>{"motion_false_alarm", &MeasureThresholds::motion_false_alarm, ThresholdKind::alarm,
                                 "probability", "noise is taken for a motion",
                                 "per mode and ensemble: 5.3 standard deviations, by Rayleigh's law",
                                 "signal/tone_fit.cpp"},
    Threshold<MeasureThresholds>{"same_setting", &MeasureThresholds::same_setting, ThresholdKind::tuned, "relative",
                                 "frequencies of sampling or excitation that were meant to be one",
                                 "no draws: clocks of two instruments differ by less",
                                 "data/import_files.cpp, data/inspection.cpp, data/read_record.cpp, "
                                 "data/rounded_stamps.cpp, data/table_repeats.cpp, data/write_campaign.cpp"},
    Threshold<MeasureThresholds>{"rarest_share", &MeasureThresholds::rarest_share, ThresholdKind::tuned, "steps",
                                 "the rarer of two lengths of rounded steps comes once in so many at least",
                                 "no draws: a buffer loses samples more rarely", "data/rounded_stamps.cpp"},
    Threshold<MeasureThresholds>{"same_sample", &MeasureThresholds::same_sample, ThresholdKind::tuned, "steps",
                                 "first samples of two channels that are at one time",
                                 "no draws: rounding of stamps", "data/channel_times.cpp, data/import_files.cpp"},
    Threshold<MeasureThresholds>{"clipped_run", &MeasureThresholds::clipped_run, ThresholdKind::tuned, "samples",
                                 "a run at an extreme that is judged by itself", "no record of the draws",
                                 "data/clipping.cpp"},
    Threshold<MeasureThresholds>{"two_level_share", &MeasureThresholds::two_level_share, ThresholdKind::tuned,
                                 "share of samples", "so many at either extreme are a square wave",
                                 "no record of the draws", "data/clipping.cpp"},
    Threshold<MeasureThresholds>{"coarse_levels", &MeasureThresholds::coarse_levels, ThresholdKind::tuned,
                                 "steps of the converter",
                                 "a range with fewer is called coarse, and clipping is not looked for",
                                 "no draws: 3 % of the amplitude", "data/clipping.cpp, data/data_quality.cpp"},
    Threshold<MeasureThresholds>{"smallest_offset", &MeasureThresholds::smallest_offset, ThresholdKind::tuned,
                                 "rms", "a mean below it is no offset worth a line", "no record of the draws",
                                 "data/data_quality.cpp"},
    Threshold<MeasureThresholds>{"softest", &MeasureThresholds::softest, ThresholdKind::tuned,
                                 "ratio of frequencies",
                                 "a decay swings slower than its line by this factor at most",
                                 "a pendulum at 160 degrees", "disturbances/motion_tones.cpp"},
    Threshold<MeasureThresholds>{
        "local_samples", &MeasureThresholds::local_samples, ThresholdKind::tuned, "samples",
        "samples, or values in order, that tell a local scale",
        "standard deviation of a median: 1.17/sqrt(n), 15 %",
        "data/recorded_span.cpp, disturbances/held_samples.cpp, disturbances/impulses.cpp, "
        "disturbances/lost_marks.cpp, disturbances/ringing.cpp, disturbances/roughness.cpp"},
    Threshold<MeasureThresholds>{"slow_terms", &MeasureThresholds::slow_terms, ThresholdKind::tuned, "cosines",
                                 "of the wander of a zero: two periods a record", "no record of the draws",
                                 "disturbances/offset_wander.cpp"},
    Threshold<MeasureThresholds>{"zero_level", &MeasureThresholds::zero_level, ThresholdKind::tuned,
                                 "largest excursion", "a decay crosses zero where it passes this band",
                                 "no record of the draws", "signal/free_decay.cpp"},
    Threshold<MeasureThresholds>{"usual_residual", &MeasureThresholds::usual_residual, ThresholdKind::tuned,
                                 "median residual of later windows", "a decay begins where a window leaves less",
                                 "no record of the draws", "signal/free_decay.cpp"},
    Threshold<MeasureThresholds>{
        "disturbed_noise", &MeasureThresholds::disturbed_noise, ThresholdKind::tuned,
        "noise of the quietest neighbours",
        "a window of a decay that leaves more, beside what chance makes of it, is disturbed",
        "no record of the draws", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"disturbed_end", &MeasureThresholds::disturbed_end, ThresholdKind::tuned,
                                 "noise of the quietest neighbours", "the same at the ends of a decay",
                                 "no record of the draws", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"disturbed_share", &MeasureThresholds::disturbed_share, ThresholdKind::tuned,
                                 "share of windows",
                                 "a decay of which more is disturbed is cut into the shortest windows",
                                 "no record of the draws", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"windows_in_a_stretch", &MeasureThresholds::windows_in_a_stretch,
                                 ThresholdKind::tuned, "windows", "windows of one condition, over two lengths",
                                 "no draws: they overlap by three quarters", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"windows_in_a_decay", &MeasureThresholds::windows_in_a_decay, ThresholdKind::tuned,
                                 "windows", "lengths of a window in a decay", "no record of the draws",
                                 "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"largest_fall", &MeasureThresholds::largest_fall, ThresholdKind::tuned,
                                 "share of the amplitude", "change within a window",
                                 "bias of a rate 1/40 of its square: 0.6 %", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"largest_bend", &MeasureThresholds::largest_bend, ThresholdKind::tuned,
                                 "share of the amplitude", "curvature within a window", "no record of the draws",
                                 "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"decayed_share", &MeasureThresholds::decayed_share, ThresholdKind::tuned,
                                 "share of the motion", "another mode with less has decayed",
                                 "no record of the draws", "observe/decay_observation.cpp"},
    Threshold<MeasureThresholds>{"seen_above_noise", &MeasureThresholds::seen_above_noise, ThresholdKind::tuned,
                                 "noise levels", "a mode is seen in a window", "no record of the draws",
                                 "observe/decay_lines.cpp, observe/decay_window.cpp"},
    Threshold<MeasureThresholds>{
        "largest_detuning", &MeasureThresholds::largest_detuning, ThresholdKind::tuned, "relative",
        "a frequency is near to another: a dwell to a resonance, a tone to where it is expected, a harmonic to a "
        "mode",
        "detuning that an expansion counts as small",
        "app/shared/record_assignment.cpp, observe/dwell_observation.cpp, "
        "observe/decay_lines.cpp, observe/decay_observation.cpp, observe/decay_window.cpp, "
        "observe/dwell_resonance.cpp, observe/natural_frequency_starts.cpp, signal/free_decay.cpp"},
    Threshold<MeasureThresholds>{
        "same_level", &MeasureThresholds::same_level, ThresholdKind::tuned, "relative",
        "levels that were meant to be one: of rows with one label, of an excitation and its nominal amplitude",
        "no draws: a level that is controlled; wrong units make it far larger",
        "data/table_repeats.cpp, observe/dwell_observation.cpp"},
    Threshold<MeasureThresholds>{"dwell_drift", &MeasureThresholds::dwell_drift, ThresholdKind::tuned, "relative",
                                 "of the amplitude over a dwell that has settled", "no record of the draws",
                                 "observe/dwell_observation.cpp"},
};
static_assert(sizeof(MeasureThresholds) == 8 * measure_threshold_list.size(), "each has its row");

}  // namespace secular
