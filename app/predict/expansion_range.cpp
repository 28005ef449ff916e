#include "app/predict/expansion_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "input/input_error.hpp"

namespace secular::app {
namespace {

using Eigen::VectorXd;

}  // namespace

ExpansionRange::ExpansionRange(const ModelSource& source, Prediction& prediction) : prediction_(prediction) {
  try {
    outside_ = source.outside_expansion(std::string(prediction.resonance->name));
  } catch (const InputError& error) {  // a compiled model without its file
    prediction.warnings.push_back(std::string("where the expansion ends is not known: ") + error.what());
  }
}

bool ExpansionRange::is_outside(const VectorXd& parameters,
                                const std::vector<std::complex<double>>& amplitude) const {
  const double* const frequency = parameters.data() + prediction_.model->symbols.size();
  const std::size_t excitations = prediction_.model->excitations.size();
  std::vector<std::complex<double>> forcing(std::max<std::size_t>(1, excitations));
  for (std::size_t j = 0; j < excitations && prediction_.resonance->excited; ++j)
    forcing[j] = frequency[excitations + j];
  return outside_ && outside_(parameters.data(), frequency, amplitude.data(), forcing.data());
}

void ExpansionRange::warn_of_outside(std::size_t outside, std::size_t all) {
  if (outside == 0) return;
  prediction_.warnings.push_back(fmt::format(
      "{} of {} points lie outside of the expansion's range: there its last order exceeds every order before, "
      "and the full equations need not have such a motion. They are marked (outside_expansion)",
      outside, all));
}

void ExpansionRange::mark_diagram(const ResponseRequest& response) {
  std::size_t outside = 0, all = 0;
  const auto mark = [&](ResponsePoint& point) {
    VectorXd parameters = response.parameters;
    parameters(response.parameter) = point.parameter;
    point.outside = !point.at_rest && is_outside(parameters, point.modes.amplitude);
  };
  for (ResponseBranch& branch : prediction_.diagram.branches) {
    for (ResponsePoint& point : branch.points) {
      mark(point);
      outside += point.outside;
    }
    all += branch.points.size();
    for (ResponseSpecial& special : branch.special) mark(special.at);
  }
  warn_of_outside(outside, all);
}

void ExpansionRange::mark_curves(const CurveRequest& request) {
  std::size_t outside = 0, all = 0;
  const auto mark = [&](ResponseCurvePoint& point) {
    VectorXd parameters = request.response.parameters;
    parameters(request.response.parameter) = point.first;
    parameters(request.second) = point.second;
    const bool at_rest = std::all_of(point.modes.amplitude.begin(), point.modes.amplitude.end(),
                                     [](const std::complex<double>& b) { return b == 0.0; });
    point.outside = !at_rest && is_outside(parameters, point.modes.amplitude);
  };
  for (ResponseCurve& curve : prediction_.curves) {
    for (ResponseCurvePoint& point : curve.points) {
      mark(point);
      outside += point.outside;
    }
    all += curve.points.size();
    for (auto& [kind, at] : curve.special) mark(at);
  }
  warn_of_outside(outside, all);
}

void ExpansionRange::mark_backbones(const ResponseField& field) {
  std::size_t outside = 0, all = 0;
  for (std::size_t k = 0; k < prediction_.backbones.size(); ++k)
    for (BackbonePoint& point : prediction_.backbones[k].second) {
      std::vector<std::complex<double>> amplitude(prediction_.model->modes());
      amplitude[field.active()[k]] = point.amplitude;
      point.outside = is_outside(prediction_.parameters, amplitude);
      outside += point.outside;
      ++all;
    }
  warn_of_outside(outside, all);
}

}  // namespace secular::app
