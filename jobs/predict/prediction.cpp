#include "jobs/predict/prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

#include "jobs/predict/largest_response.hpp"
#include "jobs/predict/measured_points.hpp"
#include "jobs/predict/prediction_inputs.hpp"
#include "jobs/predict/prediction_spread.hpp"
#include "jobs/predict/range_marks.hpp"
#include "jobs/predict/simulated_sweep.hpp"
#include "jobs/shared/model_loading.hpp"
#include "motion/response/response_peaks.hpp"
#include "numerics/in_parallel.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

constexpr int backbone_points = 200;

/// A backbone is drawn so many times as far as its largest limit cycle.
constexpr double beyond_cycles = 1.1;

/// Share of the range within which places are one.
constexpr double same_place = 1e-6;

void add_backbones(const PredictionRequest& request, const ResponseField& field, RangeMarks& range,
                   Prediction& prediction) {
  double largest = request.largest / 2, searched = largest;
  if (largest == 0) {
    largest = amplitude_scale(field, prediction.parameters, 0, prediction.parameters(0),
                              1.0001 * prediction.parameters(0));
    searched = 4 * largest;  // as responses are
  }
  for (std::size_t k = 0; k < field.active().size(); ++k) {
    prediction.limit_cycles.push_back(limit_cycles(field, prediction.parameters, k, searched, 4 * backbone_points));
    double shown = largest;
    for (const LimitCycle& cycle : prediction.limit_cycles.back())
      if (request.largest == 0) shown = std::max(shown, beyond_cycles * cycle.at.amplitude);
    prediction.backbones.emplace_back(std::string(prediction.model->coordinates[field.active()[k]]),
                                      backbone(field, prediction.parameters, k, shown, backbone_points));
  }
  range.mark_backbones(field);
  spread_backbones(field, prediction);
}

// Jumps that lie farther than one step from every fold, threshold and other special point of the expansion.
void warn_of_other_jumps(Prediction& prediction) {
  for (const PredictedSweep& sweep : prediction.sweeps)
    for (const PredictedSweep::Jump& jump : sweep.jumps) {
      const double step = std::abs(jump.to - jump.from), middle = 0.5 * (jump.from + jump.to);
      std::optional<double> nearest;
      for (const ResponseBranch& branch : prediction.diagram.branches)
        for (const ResponseSpecial& special : branch.special)
          if (!nearest || std::abs(special.at.parameter - middle) < std::abs(*nearest - middle))
            nearest = special.at.parameter;
      if (nearest && std::abs(*nearest - middle) <= 1.5 * step) continue;
      const auto place = [&](double value) {
        return report::format_number(value / prediction.axis, 6) +
               (prediction.axis_unit.empty() ? "" : " " + prediction.axis_unit);
      };
      prediction.warnings.push_back(fmt::format(
          "the simulated sweep {} jumps between {} and {}, and {}: the full equations are right; jumps of "
          "the expansion are off there, or a disturbance leaves its motion before its end",
          sweep.direction, place(jump.from), place(jump.to),
          nearest ? "the nearest fold or threshold of the expansion is at " + place(*nearest)
                  : "the expansion has no fold or threshold"));
    }
}

bool differ_in_phase_alone(const ResponseSpecial& a, const ResponseSpecial& b, double largest) {
  if (a.kind != b.kind || std::abs(a.at.parameter - b.at.parameter) > 1e-6 * std::abs(b.at.parameter)) return false;
  for (std::size_t k = 0; k < a.at.modes.amplitude.size(); ++k) {
    const double one = std::abs(a.at.modes.amplitude[k]), other = std::abs(b.at.modes.amplitude[k]);
    if (std::abs(one - other) > 1e-4 * other + 1e-6 * largest) return false;
  }
  return true;
}

// Where a branch leaves the state of rest its amplitude grows with the root of the distance from there: a
// saddle-node that is nearer than that on both scales, as a small coefficient of |x'|x' makes one, is the threshold
// to whoever reads the list. So is the threshold itself, where the branch passes it.
bool is_threshold(const ResponseSpecial& special, const ResponseSpecial& threshold, double range, double scale) {
  if (!special.at.at_rest && special.kind != SpecialKind::saddle_node) return false;
  double largest = 0;
  for (const std::complex<double>& amplitude : special.at.modes.amplitude)
    largest = std::max(largest, std::abs(amplitude));
  return std::abs(special.at.parameter - threshold.at.parameter) < same_place * range &&
         largest < std::sqrt(same_place) * scale;
}

// A closed branch passes through solutions that differ in phase alone one behind the other: special points of all
// of them are one. Thresholds are said with the state of rest, where that is a branch.
void say_special_points_once(ResponseDiagram& diagram, double range) {
  std::vector<ResponseSpecial> thresholds;
  for (const ResponseBranch& branch : diagram.branches)
    if (branch.at_rest) thresholds.insert(thresholds.end(), branch.special.begin(), branch.special.end());
  for (ResponseBranch& branch : diagram.branches) {
    std::vector<ResponseSpecial> once;
    for (ResponseSpecial& special : branch.special) {
      const auto is_said = [&](const ResponseSpecial& said) {
        return differ_in_phase_alone(said, special, diagram.scale);
      };
      const auto is_at = [&](const ResponseSpecial& threshold) {
        return !branch.at_rest && is_threshold(special, threshold, range, diagram.scale);
      };
      if (std::none_of(once.begin(), once.end(), is_said) &&
          std::none_of(thresholds.begin(), thresholds.end(), is_at))
        once.push_back(std::move(special));
    }
    branch.special = std::move(once);
  }
}

void add_diagram(const PredictionRequest& request, const ResponseField& field, const ResponseRequest& response,
                 RangeMarks& range, const SweepProgress& progress, Prediction& prediction) {
  prediction.diagram = response_diagram(field, response);
  add_peaks(field, response, prediction.diagram);
  say_special_points_once(prediction.diagram, response.upper - response.lower);
  range.mark_diagram(response);
  spread_diagram(field, response, request.threads, prediction);
  prediction.largest = largest_responses(prediction);
  if (prediction.diagram.status != DiagramStatus::complete)
    prediction.warnings.push_back("some responses may be missing: " + prediction.diagram.reason);
  if (!request.measured.empty()) prediction.measured = measured_points(request, prediction, prediction.warnings);
  std::vector<std::string> directions;
  if (request.sweep_up) directions.emplace_back("up");
  if (request.sweep_down) directions.emplace_back("down");
  const std::size_t total = directions.size() * static_cast<std::size_t>(request.sweep_steps);
  prediction.sweeps.resize(directions.size());
  std::atomic<std::size_t> done{0};
  in_parallel(directions.size(), request.threads, [&](std::size_t s) {
    prediction.sweeps[s] = simulated_sweep(request, prediction, response, directions[s], [&] {
      const std::size_t finished = ++done;
      if (progress) progress(finished, total);
    });
  });
  for (const PredictedSweep& swept : prediction.sweeps)
    if (!std::all_of(swept.points.begin(), swept.points.end(), [](const SweepPoint& p) { return p.settled; }))
      prediction.warnings.push_back("the simulated sweep " + swept.direction +
                                    " has dwells that did not settle within their time");
  warn_of_other_jumps(prediction);
}

void add_curves(const PredictionRequest& request, const ResponseField& field, const ResponseRequest& response,
                RangeMarks& range, Prediction& prediction) {
  CurveRequest curves;
  curves.response = response;
  curves.second = index_of(prediction, prediction.against->name);
  curves.second_lower = prediction.against->from;
  curves.second_upper = prediction.against->to;
  curves.kind = request.curve == "saddle_node" ? CurveKind::saddle_node
                : request.curve == "threshold" ? CurveKind::threshold
                : request.curve == "peak"      ? CurveKind::peak
                                               : CurveKind::hopf;
  prediction.curves = response_curves(field, curves);
  range.mark_curves(curves);
  prediction.diagram.notes.push_back(field.description());
  if (prediction.curves.empty())
    prediction.warnings.push_back("no point of kind " + request.curve + " was found in these ranges");
}

}  // namespace

Prediction predict(const PredictionRequest& request, const SweepProgress& progress) {
  const ModelSource source(request.model, false, request.note);
  Prediction prediction;
  LoadedCase loaded = source.load_case(request.resonance);
  prediction.model = std::move(loaded.model);
  prediction.resonance = loaded.resonance;
  read_prediction_inputs(source, request, prediction);
  const ResponseField field(*prediction.model, *prediction.resonance);
  RangeMarks range(source, prediction, request.threads);
  if (!prediction.resonance->excited) {
    add_backbones(request, field, range, prediction);
    return prediction;
  }
  ResponseRequest response;
  response.parameters = prediction.parameters;
  response.parameter = index_of(prediction, prediction.vary->name);
  response.lower = prediction.vary->from;
  response.upper = prediction.vary->to;
  response.largest = request.largest / 2;
  if (prediction.against)
    add_curves(request, field, response, range, prediction);
  else
    add_diagram(request, field, response, range, progress, prediction);
  return prediction;
}

}  // namespace secular
