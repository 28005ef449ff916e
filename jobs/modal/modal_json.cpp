#include "jobs/modal/modal_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "jobs/shared/json_numbers.hpp"
#include "measure/modal/modal_mass.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/confidence.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

// Where it is one for all modes: bands of a survey have windows of their own.
std::optional<double> window_of_all(const ModalSurvey& survey) {
  std::optional<double> length;
  for (const SurveyMode& mode : survey.modes) {
    if (length && *length != mode.window_s) return std::nullopt;
    if (mode.window_s > 0) length = mode.window_s;
  }
  return length;
}

Json rows(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Json array = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) array.push_back(list_json(matrix.row(r).transpose()));
  return array;
}

// Infinite: normal law.
void add_freedom(Json& entry, double degrees_of_freedom) {
  entry["degrees_of_freedom"] = std::isinf(degrees_of_freedom) ? Json("infinite") : Json(degrees_of_freedom);
}

Json interval_json(const std::optional<Interval>& interval) {
  return interval ? Json{interval->low, interval->high} : Json();
}

Json line_json(const StraightLine& line) {
  Json entry = {{"intercept", line.intercept}, {"intercept_sd", line.intercept_sd}, {"slope", line.slope},
                {"slope_sd", line.slope_sd},   {"scatter", line.scatter},           {"excess_sd", line.excess_sd}};
  add_freedom(entry, line.degrees_of_freedom);
  entry["covariance"] = line.clustered       ? "clustered by record"
                        : line.excess_sd > 0 ? "noise of the windows and excess scatter"
                                             : "noise of the windows";
  entry["curvature_p_value"] = line.curvature_p;
  return entry;
}

Json law_json(const AmplitudeLaw& law) {
  static const char* const names[] = {"constant", "straight line", "parabola"};
  return {{"law", names[law.degree]},
          {"coefficients", {law.coefficients[0], law.coefficients[1], law.coefficients[2]}},
          {"intercept_sd", law.intercept_sd},
          {"probabilities", {law.probability[0], law.probability[1], law.probability[2]}}};
}

Json mode_json(const ModalSurvey& survey, std::size_t r) {
  const SurveyMode& mode = survey.modes[r];
  Json entry = {{"name", fmt::format("v{}", r + 1)},
                {"natural_frequency_hz", mode.natural_frequency_hz},
                {"natural_frequency_sd_hz", mode.natural_frequency_sd_hz},
                {"damping_ratio", mode.damping_ratio},
                {"damping_ratio_sd", mode.damping_ratio_sd}};
  add_freedom(entry, mode.degrees_of_freedom);
  entry["natural_frequency_interval_hz"] = interval_json(mode.frequency_interval_hz());
  entry["damping_ratio_interval"] = interval_json(mode.damping_interval());
  entry["motion"] = to_string(mode.trend());
  entry["from"] = mode.from;
  entry["pole_rad_per_s"] = {mode.pole.real(), mode.pole.imag()};
  const Eigen::VectorXd real = mode.shape.mean.real(), imaginary = mode.shape.mean.imag();
  entry["mode_shape"] = {{"scaling", "sum of squares one"},
                         {"real", list_json(real)},
                         {"real_sd", list_json(mode.shape.real_sd)},
                         {"imaginary", list_json(imaginary)},
                         {"imaginary_sd", list_json(mode.shape.imaginary_sd)},
                         {"estimates", mode.shape.windows},
                         {"phase_collinearity", mode.phase_collinearity}};
  entry["stabilisation"] = {{"natural_frequency_hz", natural_frequency(mode.diagram.pole) * to_hz},
                            {"damping_ratio", damping_ratio(mode.diagram.pole)},
                            {"orders", mode.diagram.orders},
                            {"frequency_spread_hz", mode.diagram.frequency_spread * to_hz},
                            {"damping_ratio_spread", mode.diagram.damping_spread}};
  if (mode.window_s > 0) entry["window_s"] = mode.window_s;
  if (mode.amplitude)
    entry["amplitude_dependence"] = {{"windows", mode.amplitude->windows},
                                     {"amplitude_unit", survey.unit},
                                     {"smallest_amplitude", mode.amplitude->smallest_amplitude},
                                     {"largest_amplitude", mode.amplitude->largest_amplitude},
                                     {"damped_natural_frequency_hz", line_json(mode.amplitude->frequency_hz)},
                                     {"damping_factor_hz", line_json(mode.amplitude->damping_factor_hz)},
                                     {"frequency_law", law_json(mode.amplitude->frequency_law)},
                                     {"damping_law", law_json(mode.amplitude->damping_law)},
                                     {"zero_amplitude",
                                      {{"natural_frequency_hz", mode.amplitude->natural_frequency_hz},
                                       {"natural_frequency_sd_hz", mode.amplitude->natural_frequency_sd_hz},
                                       {"damping_ratio", mode.amplitude->damping_ratio},
                                       {"damping_ratio_sd", mode.amplitude->damping_ratio_sd}}}};
  if (mode.mass) {
    entry["modal_mass_kg"] = *mode.mass;
    entry["modal_mass_sd_kg"] = mode.mass_sd;
  }
  if (!mode.masses.empty()) {
    entry["modal_mass_by_reference"] = Json::array();
    for (const MassEstimate& estimate : mode.masses)
      entry["modal_mass_by_reference"].push_back(
          {{"group", estimate.group}, {"mass_kg", estimate.mass}, {"used", estimate.used}});
  }
  return entry;
}

Json tone_json(const SurveyTone& tone) {
  Json entry = {{"natural_frequency_hz", tone.found.natural_frequency_hz},
                {"natural_frequency_sd_hz", tone.found.natural_frequency_sd_hz},
                {"damping_ratio", tone.found.damping_ratio},
                {"damping_ratio_sd", tone.found.damping_ratio_sd},
                {"is", tone.name()}};
  entry["of"] = Json::array();
  for (std::size_t i = 0; i < 2; ++i)
    if (tone.times[i] != 0)
      entry["of"].push_back({{"mode", fmt::format("v{}", tone.modes[i] + 1)}, {"times", tone.times[i]}});
  entry["expected_frequency_hz"] = {tone.expected_hz.low, tone.expected_hz.high};
  entry["expected_rate_per_s"] = {tone.expected_rate.low, tone.expected_rate.high};
  entry["chance_of_a_mode"] = tone.chance;
  entry["reason"] = tone.reason();
  return entry;
}

}  // namespace

std::string modal_json(const ModalSurvey& survey) {
  Json result = {{"schema", 1}, {"campaign", survey.campaign.name}};
  Json names = Json::array();
  for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(survey.channels.size()); ++c)
    names.push_back(survey.channel_name(c));
  result["channels"] = names;
  result["unit"] = survey.unit;
  result["modes"] = Json::array();
  for (std::size_t r = 0; r < survey.modes.size(); ++r) result["modes"].push_back(mode_json(survey, r));
  result["combination_tones"] = Json::array();
  for (const SurveyTone& tone : survey.tones) result["combination_tones"].push_back(tone_json(tone));
  result["dropped_poles"] = Json::array();
  for (const DroppedPole& dropped : survey.dropped)
    result["dropped_poles"].push_back({{"natural_frequency_hz", natural_frequency(dropped.pole) * to_hz},
                                       {"damping_ratio", damping_ratio(dropped.pole)},
                                       {"reason", dropped.reason}});
  result["modal_assurance"] = rows(survey.mac);
  if (const std::optional<Eigen::MatrixXd> shapes = survey.mass_normalised()) {
    result["mass_normalised_shapes"] = rows(*shapes);
    if (shapes->cols() <= shapes->rows()) {
      Eigen::VectorXcd poles(shapes->cols());
      for (Eigen::Index r = 0; r < poles.size(); ++r) poles(r) = survey.modes[static_cast<std::size_t>(r)].pole;
      const DynamicMatrices matrices = dynamic_matrices(*shapes, poles);
      result["matrices"] = {{"mass_kg", rows(matrices.mass)},
                            {"damping_kg_per_s", rows(matrices.damping)},
                            {"stiffness_kg_per_s2", rows(matrices.stiffness)}};
    }
  }
  if (!survey.references.empty()) {
    result["references"] = Json::array();
    for (const SurveyReference& reference : survey.references) {
      Json entry = {{"group", reference.group}, {"impacts", reference.response.impacts}};
      if (reference.driving_channel >= 0)
        entry["driving_point"] = {{"channel", survey.channel_name(reference.driving_channel)},
                                  {"sign", reference.sign}};
      entry["force_window_s"] = reference.response.windows.force_s;
      entry["exponential_window_per_s"] = reference.response.windows.decay;
      result["references"].push_back(std::move(entry));
    }
  }
  result["stabilisation"] = Json::array();
  for (const StabilisationPole& pole : survey.diagram.poles)
    result["stabilisation"].push_back({{"order", pole.order},
                                       {"natural_frequency_hz", natural_frequency(pole.pole) * to_hz},
                                       {"damping_ratio", damping_ratio(pole.pole)},
                                       {"stable_frequency", pole.stable_frequency},
                                       {"stable_damping", pole.stable_damping},
                                       {"stable_shape", pole.stable_shape}});
  if (const std::optional<double> length = window_of_all(survey)) result["window_s"] = *length;
  result["windows"] = Json::array();
  for (const ModeWindow& window : survey.windows)
    result["windows"].push_back({{"record", survey.campaign.records[window.record].file},
                                 {"mode", fmt::format("v{}", window.mode + 1)},
                                 {"centre_s", window.centre_s},
                                 {"amplitude", window.amplitude},
                                 {"natural_frequency_hz", natural_frequency(window.pole) * to_hz},
                                 {"natural_frequency_sd_hz", window.omega_sd * to_hz},
                                 {"damping_ratio", damping_ratio(window.pole)},
                                 {"damping_ratio_sd", window.growth_sd / natural_frequency(window.pole)}});
  result["warnings"] = survey.warnings;
  return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace secular
