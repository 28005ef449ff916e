#include "jobs/identify/decay_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "estimator/identification/identified_lumps.hpp"
#include "motion/response/response_curve.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

constexpr int band_points = 60;

/// docs/inference.md (R3): standard deviations of frequency (rad/s) and decay rate (1/s) at amplitudes |B| of
/// largest/band_points, 2 largest/band_points, ...; empty where the modulation equations do not say.
struct BackboneBand {
  double largest = 0;
  std::vector<double> frequency_sd, decay_sd;
  /// Linear between the points.
  double at(const std::vector<double>& sd, double amplitude) const {
    const double place = std::clamp(amplitude / largest * static_cast<double>(sd.size()) - 1, 0.0,
                                    static_cast<double>(sd.size() - 1));
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sd.size() - 1);
    return sd[low] + (place - static_cast<double>(low)) * (sd[high] - sd[low]);
  }
};

BackboneBand band_of(const CaseView& view, std::size_t own, double largest) {
  const Estimate& estimate = view.estimate;
  const ResponseField field(*view.model, *view.resonance);
  const auto active = std::find(field.active().begin(), field.active().end(), own);
  const Eigen::VectorXd parameters = representative_parameters(estimate);
  if (active == field.active().end() || !(largest > 0) || !parameters.allFinite()) return {};
  const auto mode = static_cast<std::size_t>(active - field.active().begin());
  const auto rest = static_cast<Eigen::Index>(ResponseField::parameter_names(*view.model).size());
  const auto curve = [&](const Eigen::VectorXd& symbols) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rest);
    all.head(symbols.size()) = symbols;
    return backbone(field, all, mode, largest, band_points);
  };
  const std::vector<BackbonePoint> best = curve(parameters);
  std::vector<double> frequency(best.size(), 0), decay(best.size(), 0);
  for (const Eigen::MatrixXd* part : {&estimate.noise, &estimate.open})
    for (Eigen::Index d = 0; d < part->cols(); ++d) {
      const std::vector<BackbonePoint> moved = curve(parameters + part->col(d));
      for (std::size_t i = 0; i < best.size(); ++i) {
        frequency[i] += std::pow(moved[i].frequency - best[i].frequency, 2);
        decay[i] += std::pow(moved[i].growth - best[i].growth, 2);
      }
    }
  for (std::size_t i = 0; i < best.size(); ++i) {
    frequency[i] = std::sqrt(frequency[i]);
    decay[i] = std::sqrt(decay[i]);
  }
  if (frequency.empty() || !std::isfinite(frequency.back()) || !std::isfinite(decay.back())) return {};
  return {largest, std::move(frequency), std::move(decay)};
}

/// Of the replayed windows, by rising amplitude: line and band of frequency and of decay rate.
struct ComputedCurves {
  Series frequency, decay, frequency_band, decay_band;
};

ComputedCurves computed_curves(const CaseView& view, std::size_t own) {
  std::vector<const Observation*> windows;
  for (const Observation& o : view.replayed.observations)
    if (o.growth_sd[own] >= 0) windows.push_back(&o);
  std::sort(windows.begin(), windows.end(), [own](const Observation* a, const Observation* b) {
    return std::abs(a->amplitude[own]) < std::abs(b->amplitude[own]);
  });
  ComputedCurves curves;
  curves.frequency.name = curves.decay.name = "full equations, estimated parameters";
  curves.frequency_band.style = curves.decay_band.style = SeriesStyle::band;
  curves.frequency_band.name = curves.decay_band.name = "two standard deviations of the parameters";
  const BackboneBand band =
      windows.empty() ? BackboneBand{} : band_of(view, own, std::abs(windows.back()->amplitude[own]));
  const auto add = [](Series& series, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
  };
  for (const Observation* o : windows) {
    const double amplitude = std::abs(o->amplitude[own]);
    add(curves.frequency, 2 * amplitude, o->rate[own].imag() * to_hz);
    add(curves.decay, 2 * amplitude, -o->rate[own].real());
    if (band.frequency_sd.empty()) continue;
    add(curves.frequency_band, 2 * amplitude, o->rate[own].imag() * to_hz);
    curves.frequency_band.y_error.push_back(2 * band.at(band.frequency_sd, amplitude) * to_hz);
    add(curves.decay_band, 2 * amplitude, -o->rate[own].real());
    curves.decay_band.y_error.push_back(2 * band.at(band.decay_sd, amplitude));
  }
  return curves;
}

}  // namespace

Figure decay_response(const CaseView& view, std::size_t own) {
  const std::string name(view.model->coordinates[own]);
  Figure figure;
  figure.title = fmt::format("Free decay of {}: frequency and damping against amplitude", name);
  figure.x = {fmt::format("Peak amplitude of {}", name), view.coordinate_unit, false, {}};
  Series frequency, damping;
  frequency.name = damping.name = "measured, windows";
  frequency.style = damping.style = SeriesStyle::error_bars;
  frequency.role = damping.role = SeriesRole::data;
  for (const Observation& o : view.measured.observations) {
    if (o.growth_sd[own] < 0) continue;
    const double peak = 2 * std::abs(o.amplitude[own]);
    frequency.x.push_back(peak);
    frequency.y.push_back(o.rate[own].imag() * to_hz);
    frequency.y_error.push_back(2 * o.frequency_sd[own] * to_hz);
    damping.x.push_back(peak);
    damping.y.push_back(-o.rate[own].real());
    damping.y_error.push_back(2 * o.growth_sd[own]);
  }
  ComputedCurves computed = computed_curves(view, own);
  figure.panels.push_back(
      {"Backbone",
       {"Frequency", "Hz", false, {}},
       {std::move(computed.frequency_band), std::move(frequency), std::move(computed.frequency)}});
  figure.panels.push_back({"Decay rate",
                           {"Decay rate", "1/s", false, {}},
                           {std::move(computed.decay_band), std::move(damping), std::move(computed.decay)}});
  return figure;
}

Figure decay_residuals(const CaseView& view, std::size_t own) {
  Figure figure;
  figure.title = fmt::format("Measured minus computed, {}", view.model->coordinates[own]);
  figure.x = {"Time in the record", "s", false, {}};
  Series frequency, damping;
  frequency.style = damping.style = SeriesStyle::error_bars;
  frequency.role = damping.role = SeriesRole::data;
  for (std::size_t i = 0; i < view.replayed.observations.size(); ++i) {
    const Observation &seen = view.measured.observations[i], &computed = view.replayed.observations[i];
    if (seen.growth_sd[own] < 0) continue;
    const std::complex<double> difference = seen.rate[own] - computed.rate[own];
    frequency.x.push_back(seen.centre_s);
    frequency.y.push_back(difference.imag() * to_hz);
    frequency.y_error.push_back(2 * seen.frequency_sd[own] * to_hz);
    damping.x.push_back(seen.centre_s);
    damping.y.push_back(-difference.real());
    damping.y_error.push_back(2 * seen.growth_sd[own]);
  }
  figure.panels.push_back({"", {"Frequency difference", "Hz", false, {}}, {frequency}, true});
  figure.panels.push_back({"", {"Decay rate difference", "1/s", false, {}}, {damping}, true});
  return figure;
}

Figure decay_in_time(const CaseView& view, const HeldOutPrediction& decay, const std::string& title) {
  Figure figure;
  figure.title = title;
  figure.x = {"Time in the record", "s", false, {}};
  Series measured, predicted, difference;
  measured.name = "measured";
  measured.role = SeriesRole::data;
  predicted.name = "full equations";
  predicted.role = SeriesRole::model;
  difference.role = SeriesRole::data;
  measured.x = predicted.x = difference.x = decay.time;
  measured.y = decay.measured;
  predicted.y = decay.predicted;
  for (std::size_t i = 0; i < decay.time.size(); ++i)
    difference.y.push_back(decay.measured[i] - decay.predicted[i]);
  const std::string name(view.model->coordinates[first_mode(view)]);
  figure.panels.push_back({"", {name, view.coordinate_unit, false, {}}, {measured, predicted}});
  figure.panels.push_back({"", {"Measured minus computed", view.coordinate_unit, false, {}}, {difference}, true});
  return figure;
}

}  // namespace secular
