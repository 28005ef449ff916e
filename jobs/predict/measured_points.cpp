#include "jobs/predict/measured_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "estimator/model/locked_excitations.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {
namespace {

constexpr double same_amplitude = 0.05, same_frequency = 5e-4;

// Means over the ensembles of one dwell.
struct Dwell {
  std::size_t ensembles = 0, record = 0;
  std::vector<double> frequency, forcing, amplitude, squared_amplitude;
};

void add(std::vector<double>& sums, const std::vector<double>& values) {
  sums.resize(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

std::map<int, Dwell> dwells_of(const std::vector<Observation>& seen) {
  std::map<int, Dwell> dwells;
  for (const Observation& o : seen) {
    Dwell& dwell = dwells[o.condition];
    ++dwell.ensembles;
    dwell.record = o.record;
    std::vector<double> forcing, amplitude, squared;
    for (const auto& f : o.forcing) forcing.push_back(std::abs(f));
    for (const auto& a : o.amplitude) {
      amplitude.push_back(2 * std::abs(a));
      squared.push_back(4 * std::norm(a));
    }
    add(dwell.frequency, o.excitation_frequency);
    add(dwell.forcing, forcing);
    add(dwell.amplitude, amplitude);
    add(dwell.squared_amplitude, squared);
  }
  for (auto& [condition, dwell] : dwells)
    for (auto* list : {&dwell.frequency, &dwell.forcing, &dwell.amplitude, &dwell.squared_amplitude})
      for (double& sum : *list) sum /= static_cast<double>(dwell.ensembles);
  return dwells;
}

// Which excitation's frequency or amplitude a prediction varies; the number of excitations: none of them.
struct Varied {
  std::size_t frequency, amplitude;
};

Varied varied_excitation(const PredictionRequest& request, const Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  const auto excitation_named = [&](std::span<const std::string_view> names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), prediction.vary->name) - names.begin());
  };
  const Varied varied{excitation_named(model.excitation_frequencies), excitation_named(model.excitations)};
  if (varied.frequency == model.excitations.size() && varied.amplitude == model.excitations.size())
    throw InputError("--measured " + request.measured, "",
                     "'" + prediction.vary->name + "' is not what dwells vary",
                     "measured dwells are drawn over an excitation frequency or amplitude");
  return varied;
}

// Whether all that the prediction does not vary of the excitation is the dwell's.
bool excited_as_predicted(const Dwell& dwell, const Varied& varied, const Prediction& prediction) {
  const std::size_t count = prediction.model->excitations.size();
  const auto symbols = static_cast<Eigen::Index>(prediction.model->symbols.size());
  // The order of ResponseField::parameter_names: symbols, excitation frequencies, excitation amplitudes.
  Eigen::VectorXd frequencies = prediction.parameters.segment(symbols, static_cast<Eigen::Index>(count));
  if (varied.frequency < count)
    frequencies(static_cast<Eigen::Index>(varied.frequency)) = dwell.frequency[varied.frequency];
  LockedExcitations(*prediction.model, *prediction.resonance).follow(frequencies.data());
  for (std::size_t j = 0; j < count; ++j) {
    const double frequency = frequencies(static_cast<Eigen::Index>(j)),
                 amplitude = prediction.parameters(symbols + static_cast<Eigen::Index>(count + j));
    if (j != varied.frequency && !(std::abs(dwell.frequency[j] - frequency) <= same_frequency * frequency))
      return false;
    if (j != varied.amplitude && !(std::abs(dwell.forcing[j] - amplitude) <= same_amplitude * amplitude))
      return false;
  }
  return true;
}

std::vector<Observation> observed(const PredictionRequest& request, const Prediction& prediction,
                                  const Campaign& campaign, std::vector<std::string>& warnings) {
  SelectedRecords reader(campaign, request.window);
  reader.leave_clipped_out();
  const ObservationSet set = observe_dwells(
      campaign, [&](std::size_t r) { return reader.read(r); }, *prediction.model, *prediction.resonance,
      request.window);
  for (std::string& warning : reader.warnings()) warnings.push_back(std::move(warning));
  // Dwells at rest are points too, on the axis: they are not left out here.
  const auto drawn = [&](const std::string& warning) {
    return std::any_of(set.at_rest.begin(), set.at_rest.end(), [&](const Observation& o) {
      return warning.starts_with(campaign.records[o.record].file + ":");
    });
  };
  std::copy_if(set.warnings.begin(), set.warnings.end(), std::back_inserter(warnings),
               [&](const std::string& warning) { return !drawn(warning); });
  std::vector<Observation> seen = set.observations;
  seen.insert(seen.end(), set.at_rest.begin(), set.at_rest.end());
  return seen;
}

MeasuredPoint point_of(const Dwell& dwell, const Varied& varied, const RecordEntry& entry) {
  MeasuredPoint point;
  point.record = entry.file;
  point.group = entry.group;
  point.parameter = varied.frequency < dwell.frequency.size() ? dwell.frequency[varied.frequency]
                                                              : dwell.forcing[varied.amplitude];
  point.amplitude = dwell.amplitude;
  for (std::size_t k = 0; k < dwell.amplitude.size(); ++k)
    point.spread.push_back(
        std::sqrt(std::max(0.0, dwell.squared_amplitude[k] - dwell.amplitude[k] * dwell.amplitude[k])));
  return point;
}

}  // namespace

std::vector<MeasuredPoint> measured_points(const PredictionRequest& request, const Prediction& prediction,
                                           std::vector<std::string>& warnings) {
  const Varied varied = varied_excitation(request, prediction);
  const Campaign campaign = request.campaign ? *request.campaign : read_campaign(request.measured);
  const std::map<int, Dwell> dwells = dwells_of(observed(request, prediction, campaign, warnings));
  std::vector<MeasuredPoint> points;
  for (const auto& [condition, dwell] : dwells)
    if (excited_as_predicted(dwell, varied, prediction))
      points.push_back(point_of(dwell, varied, campaign.records[dwell.record]));
  if (points.empty())
    throw InputError(
        "--measured " + request.measured, "",
        fmt::format("none of its {} dwells was made at the excitation of this prediction", dwells.size()),
        "give their excitation with --at: amplitudes agree within 5 %, frequencies within 0.05 %");
  if (points.size() < dwells.size())
    warnings.push_back(fmt::format("{} of {} dwells of {} were made at another excitation and are not drawn",
                                   dwells.size() - points.size(), dwells.size(), request.measured));
  std::stable_sort(points.begin(), points.end(),
                   [](const MeasuredPoint& a, const MeasuredPoint& b) { return a.parameter < b.parameter; });
  return points;
}

}  // namespace secular
