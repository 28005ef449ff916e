#include "app/diagnose/lateness.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/shared/identification.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/thresholds.hpp"
#include "numerics/explained_variation.hpp"

namespace secular::app {
namespace {

/// That lateness which comes at random is taken to follow the settings: in doubt it does.
constexpr double structure_alarm = 0.05;

// Whether lateness is a smooth function of level, frequency and order of the records beyond what chance makes of it
// (F law), as what a missing law does to phases is; of as many records as functions nobody can tell.
bool follows_settings(const Campaign& campaign, const std::map<std::size_t, double>& late_s) {
  const auto count = static_cast<Eigen::Index>(late_s.size());
  Eigen::MatrixXd functions(count, 7);
  Eigen::VectorXd late(count);
  Eigen::Index row = 0;
  for (const auto& [record, seconds] : late_s) {
    const RecordEntry& entry = campaign.records[record];
    const double level = entry.excitation_amplitude.value_or(0), hz = entry.excitation_frequency_hz.value_or(0);
    functions.row(row) << 1, level, level * level, hz, hz * hz, level * hz, static_cast<double>(record);
    late(row++) = seconds;
  }
  for (Eigen::Index c = 1; c < functions.cols(); ++c) {
    functions.col(c).array() -= functions.col(c).mean();
    if (const double size = functions.col(c).norm(); size > 0) functions.col(c) /= size;
  }
  const ExplainedVariation explained = explained_variation(late, functions);
  if (explained.freedom < explained.rank) return true;
  if (!(explained.left > 0) || explained.rank < 2) return explained.all > 0;
  return explained.p_value() < structure_alarm;
}

// Of natural frequencies that differ more than their decays leave open, at the level of all disturbances.
Eigen::VectorXd scatter_of_decays(const Identification& id) {
  Eigen::VectorXd sd;
  for (const EstimatedValue& value : id.estimate.parameters) {
    if (!value.value || !value.between_records) continue;
    const ScatterBetweenRecords& scatter = *value.between_records;
    const auto mode = static_cast<Eigen::Index>(scatter.mode);
    if (sd.size() <= mode) sd.conservativeResizeLike(Eigen::VectorXd::Zero(mode + 1));
    if (scatter.p_value < measure_thresholds().disturbance_false_alarm)
      sd(mode) = scatter.sd / std::abs(*value.value);
  }
  return sd;
}

}  // namespace

bool can_be_late(const Campaign& campaign, const CompiledModel& model) {
  const bool one_excitation =
      std::count_if(campaign.channels.begin(), campaign.channels.end(),
                    [](const Channel& channel) { return channel.role == ChannelRole::excitation; }) == 1;
  return one_excitation && !model.excitations.empty() &&
         std::any_of(campaign.records.begin(), campaign.records.end(),
                     [](const RecordEntry& record) { return record.kind == RecordKind::dwell; });
}

Lateness find_lateness(const DiagnosisRequest& request) {
  IdentificationRequest wanted;
  wanted.campaign = request.campaign;
  wanted.model = request.model;
  wanted.interpret = request.interpret;
  wanted.window = request.window;
  wanted.threads = request.threads;
  Identification id;
  const auto not_found_out = [](const std::exception& error) -> Lateness {
    return {{}, {}, {}, false, {}, fmt::format("whether records are late was not found out: {}", error.what())};
  };
  try {
    id = identify(wanted);
  } catch (const InputError& error) {
    return not_found_out(error);
  } catch (const NumericalFailure& failure) {
    return not_found_out(failure);
  }
  Lateness result;
  result.frequency_sd = scatter_of_decays(id);
  Lateness in_step;
  in_step.frequency_sd = result.frequency_sd;
  for (const CaseLateness& of_case : id.freed) {
    if (of_case.finding == PhaseFinding::like_a_law) return in_step;
    if (of_case.finding != PhaseFinding::shifted) continue;
    for (const RecordLateness& record : of_case.records) {
      result.late_s[record.record] = record.late_s;
      result.period_s[record.record] = record.period_s;
      if (!of_case.assumed_positive.empty()) result.sign_open.insert(record.record);
    }
  }
  // identify keeps a case as shifted where the equations of all hold then.
  result.holds = std::any_of(id.lateness.begin(), id.lateness.end(),
                             [](const CaseLateness& of_case) { return of_case.finding == PhaseFinding::shifted; });
  if (result.late_s.empty() || (!result.holds && follows_settings(id.campaign, result.late_s))) return in_step;
  return result;
}

}  // namespace secular::app
