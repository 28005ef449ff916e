#include "jobs/predict/range_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {

RangeMarks::RangeMarks(const ModelSource& source, Prediction& prediction, unsigned threads)
    : prediction_(prediction), locked_(*prediction.model, *prediction.resonance), threads_(threads) {
  try {
    range_.emplace(*prediction.model, *prediction.resonance,
                   source.expansion_sizes(std::string(prediction.resonance->name)));
  } catch (const InputError& error) {  // a compiled model without its file
    prediction.warnings.push_back(std::string("where the expansion ends is not known: ") + error.what());
  }
}

// A motion at rest is one of the full equations.
void RangeMarks::mark(std::vector<Place> places) {
  if (!range_) return;
  std::erase_if(places, [](const Place& place) {
    return std::all_of(place.amplitude->begin(), place.amplitude->end(),
                       [](const std::complex<double>& a) { return a == 0.0; });
  });
  in_parallel(places.size(), threads_, [&](std::size_t i) {
    *places[i].outside = range_->excludes(places[i].parameters, *places[i].amplitude);
  });
  warn_of_moved_rest(places);
  const auto outside = std::count_if(places.begin(), places.end(),
                                     [](const Place& place) { return place.counts && *place.outside; });
  if (outside == 0) return;
  prediction_.warnings.push_back(fmt::format(
      "{} of {} points lie outside of the expansion's range: there its last order, or what the full equations add "
      "to it, exceeds every order before. The full equations need not have such a motion. These points are marked "
      "(outside_expansion)",
      outside, std::count_if(places.begin(), places.end(), [](const Place& place) { return place.counts; })));
}

// At the largest response, which is near resonance: far from it the expansion in the detuning lacks as much.
void RangeMarks::warn_of_moved_rest(const std::vector<Place>& places) {
  const auto largest = std::max_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
    const auto size = [](const Place& place) {
      double sum = 0;
      for (const std::complex<double>& one : *place.amplitude) sum += std::norm(one);
      return sum;
    };
    return size(a) < size(b);
  });
  if (largest == places.end()) return;
  if (const std::optional<double> shift = range_->rest_shift(largest->parameters, *largest->amplitude))
    prediction_.warnings.push_back(
        fmt::format("a constant force moves the rest position, and the expansion is not made about it. That shifts "
                    "the rate of a small motion by {:.2g} 1/s, which these responses lack. Where it is not small "
                    "beside damping, write reference = \"rest\" at the head of the model file",
                    *shift));
}

void RangeMarks::mark_diagram(const ResponseRequest& response) {
  std::vector<Place> places;
  const auto add = [&](ResponsePoint& point, bool counts) {
    Eigen::VectorXd parameters = response.parameters;
    parameters(response.parameter) = point.parameter;
    locked_.follow(parameters.data() + prediction_.model->symbols.size());
    places.push_back({std::move(parameters), &point.modes.amplitude, &point.outside, counts});
  };
  for (ResponseBranch& branch : prediction_.diagram.branches) {
    for (ResponsePoint& point : branch.points) add(point, true);
    for (ResponseSpecial& special : branch.special) add(special.at, false);
  }
  mark(std::move(places));
}

void RangeMarks::mark_curves(const CurveRequest& request) {
  std::vector<Place> places;
  const auto add = [&](ResponseCurvePoint& point, bool counts) {
    Eigen::VectorXd parameters = request.response.parameters;
    parameters(request.response.parameter) = point.first;
    parameters(request.second) = point.second;
    locked_.follow(parameters.data() + prediction_.model->symbols.size());
    places.push_back({std::move(parameters), &point.modes.amplitude, &point.outside, counts});
  };
  for (ResponseCurve& curve : prediction_.curves) {
    for (ResponseCurvePoint& point : curve.points) add(point, true);
    for (auto& [kind, at] : curve.special) add(at, false);
  }
  mark(std::move(places));
}

void RangeMarks::mark_backbones(const ResponseField& field) {
  std::vector<std::pair<std::size_t, BackbonePoint*>> points;
  for (std::size_t k = 0; k < prediction_.backbones.size(); ++k) {
    for (BackbonePoint& point : prediction_.backbones[k].second) points.emplace_back(k, &point);
    for (LimitCycle& cycle : prediction_.limit_cycles[k]) points.emplace_back(k, &cycle.at);
  }
  std::vector<std::vector<std::complex<double>>> amplitudes;
  for (const auto& [k, point] : points) {
    amplitudes.emplace_back(prediction_.model->modes());
    amplitudes.back()[field.active()[k]] = point->amplitude;
  }
  std::vector<Place> places;
  for (const auto& [k, point] : points)
    places.push_back({prediction_.parameters, &amplitudes[places.size()], &point->outside, true});
  mark(std::move(places));
}

}  // namespace secular
