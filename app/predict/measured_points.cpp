#include "app/predict/measured_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "app/shared/record_selection.hpp"
#include "input/input_error.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular::app {
namespace {

constexpr double same_amplitude = 0.05, same_frequency = 5e-4;

// Sums over the ensembles of one dwell.
struct Dwell {
  std::size_t ensembles = 0, record = 0;
  std::vector<double> frequency, forcing, amplitude, squared_amplitude;
};

void add(std::vector<double>& sums, const std::vector<double>& values) {
  sums.resize(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

}  // namespace

std::vector<MeasuredPoint> measured_points(const PredictionRequest& request, const Prediction& prediction,
                                           std::vector<std::string>& warnings) {
  const CompiledModel& model = *prediction.model;
  const auto excitation_named = [&](std::span<const std::string_view> names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), prediction.vary->name) - names.begin());
  };
  const std::size_t count = model.excitations.size();
  const std::size_t by_frequency = excitation_named(model.excitation_frequencies),
                    by_amplitude = excitation_named(model.excitations);
  if (by_frequency == count && by_amplitude == count)
    throw InputError("--measured " + request.measured, "",
                     "'" + prediction.vary->name + "' is not what dwells vary",
                     "measured dwells are drawn over an excitation frequency or amplitude");
  const Campaign campaign = read_campaign(request.measured);
  SelectedRecords reader(campaign, request.window);
  const ObservationSet set = observe_dwells(
      campaign, [&](std::size_t r) { return reader.read(r); }, model, *prediction.resonance, request.window);
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
  std::vector<MeasuredPoint> points;
  const auto symbols = static_cast<Eigen::Index>(model.symbols.size());
  for (auto& [condition, dwell] : dwells) {
    const auto ensembles = static_cast<double>(dwell.ensembles);
    for (auto* list : {&dwell.frequency, &dwell.forcing, &dwell.amplitude, &dwell.squared_amplitude})
      for (double& sum : *list) sum /= ensembles;
    bool same = true;
    for (std::size_t j = 0; j < count; ++j) {
      // The order of ResponseField::parameter_names: symbols, excitation frequencies, excitation amplitudes.
      const double frequency = prediction.parameters(symbols + static_cast<Eigen::Index>(j)),
                   amplitude = prediction.parameters(symbols + static_cast<Eigen::Index>(count + j));
      if (j != by_frequency) same = same && std::abs(dwell.frequency[j] - frequency) <= same_frequency * frequency;
      if (j != by_amplitude) same = same && std::abs(dwell.forcing[j] - amplitude) <= same_amplitude * amplitude;
    }
    if (!same) continue;
    MeasuredPoint point;
    point.record = campaign.records[dwell.record].file;
    point.group = campaign.records[dwell.record].group;
    point.parameter = by_frequency < count ? dwell.frequency[by_frequency] : dwell.forcing[by_amplitude];
    point.amplitude = dwell.amplitude;
    for (std::size_t k = 0; k < model.modes(); ++k)
      point.spread.push_back(
          std::sqrt(std::max(0.0, dwell.squared_amplitude[k] - dwell.amplitude[k] * dwell.amplitude[k])));
    points.push_back(std::move(point));
  }
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

}  // namespace secular::app
