#include "jobs/predict/prediction_spread.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

#include "motion/response/response_spread.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of a covariance: columns whose outer products add up to it. Symbols are scaled by their standard deviations
// first, as units differ by many powers of ten; what rounding makes negative is none.
MatrixXd factor_of_covariance(const MatrixXd& covariance) {
  const VectorXd sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd inverse = sd.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  const MatrixXd correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(correlation);
  return sd.asDiagonal() * solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

bool takes_representative(const PredictionRequest& request, const GivenParameters& given,
                          const Prediction& prediction) {
  return given.identified_cases.contains(std::string(prediction.resonance->name)) &&
         std::any_of(given.representative.begin(), given.representative.end(),
                     [&](const auto& value) { return !request.at.contains(value.first); });
}

// Places among Prediction::names of what has an error bar, and in the covariance.
std::vector<std::pair<Index, Index>> uncertain_places(const PredictionRequest& request,
                                                      const NamedCovariance& covariance,
                                                      const Prediction& prediction) {
  std::vector<std::pair<Index, Index>> places;
  for (std::size_t i = 0; i < covariance.names.size(); ++i) {
    const std::string& name = covariance.names[i];
    const auto found = std::find(prediction.names.begin(), prediction.names.end(), name);
    const auto is_varied = [&](const auto& parameter) { return parameter && parameter->name == name; };
    const auto row = static_cast<Index>(i);
    if (found == prediction.names.end() || request.at.contains(name) || is_varied(prediction.vary) ||
        is_varied(prediction.against) || covariance.matrix(row, row) == 0)
      continue;
    places.emplace_back(found - prediction.names.begin(), row);
  }
  return places;
}

void warn_of_doubts(const PredictionRequest& request, const GivenParameters& given, Prediction& prediction) {
  std::vector<std::string> doubtful;
  std::copy_if(prediction.uncertain.begin(), prediction.uncertain.end(), std::back_inserter(doubtful),
               [&](const std::string& name) { return given.doubtful.contains(name); });
  if (doubtful.empty()) return;
  prediction.warnings.push_back(
      fmt::format("{} marks {} as doubtful: bands and error bars of the prediction are as doubtful",
                  request.parameters, fmt::join(doubtful, ", ")));
}

}  // namespace

void find_uncertainty(const PredictionRequest& request, const GivenParameters& given, bool moved,
                      Prediction& prediction) {
  const bool open = takes_representative(request, given, prediction);
  const NamedCovariance& covariance = open ? given.representative_covariance : given.covariance;
  const auto refuse = [&](std::string reason) { prediction.no_spread_because = std::move(reason); };
  if (prediction.against) return refuse("curves in two parameters have none");
  if (given.covariance.names.empty()) return refuse(request.parameters + " holds no covariance");
  if (open && covariance.names.empty())
    return refuse(request.parameters +
                  " leaves symbols open and holds no covariance of all together: identify anew");
  if (moved)
    return refuse("the rest position and natural frequencies follow from the numbers of " + request.parameters);
  const auto places = uncertain_places(request, covariance, prediction);
  const auto count = static_cast<Index>(places.size());
  MatrixXd matrix(count, count);
  for (Index r = 0; r < count; ++r)
    for (Index c = 0; c < count; ++c)
      matrix(r, c) =
          covariance.matrix(places[static_cast<std::size_t>(r)].second, places[static_cast<std::size_t>(c)].second);
  if (count == 0) return refuse("no parameter of " + request.parameters + " that acts here has an error bar");
  if (!matrix.allFinite())
    return refuse("the covariance of " + request.parameters + " has entries that are no numbers");
  const MatrixXd factor = factor_of_covariance(matrix);
  prediction.directions = MatrixXd::Zero(prediction.parameters.size(), factor.cols());
  for (Index r = 0; r < count; ++r) {
    const Index place = places[static_cast<std::size_t>(r)].first;
    prediction.directions.row(place) = factor.row(r);
    prediction.uncertain.push_back(prediction.names[static_cast<std::size_t>(place)]);
  }
  warn_of_doubts(request, given, prediction);
}

void spread_diagram(const ResponseField& field, const ResponseRequest& response, unsigned threads,
                    Prediction& prediction) {
  if (prediction.uncertain.empty()) return;
  const ResponseSpread spread(field, {response.parameters, prediction.directions}, response.parameter,
                              response.upper - response.lower, prediction.diagram.scale);
  std::vector<ResponsePoint*> points;
  std::vector<ResponseSpecial*> special;
  for (ResponseBranch& branch : prediction.diagram.branches) {
    for (ResponsePoint& point : branch.points)
      if (!point.outside) points.push_back(&point);
    for (ResponseSpecial& point : branch.special)
      if (!point.at.outside) special.push_back(&point);
  }
  in_parallel(points.size(), threads, [&](std::size_t i) {
    points[i]->spread = spread.of(*points[i]);
    for (ResponsePeak& peak : points[i]->peaks) peak.place_sd = spread.of_peak(*points[i], peak.mode);
  });
  in_parallel(special.size(), threads, [&](std::size_t i) {
    special[i]->sd = spread.of(*special[i]);
    special[i]->at.spread = spread.of(special[i]->at);
  });
}

void spread_backbones(const ResponseField& field, Prediction& prediction) {
  if (prediction.uncertain.empty()) return;
  const UncertainParameters uncertain{prediction.parameters, prediction.directions};
  for (std::size_t k = 0; k < prediction.backbones.size(); ++k) {
    const std::vector<BackbonePoint>& points = prediction.backbones[k].second;
    prediction.backbone_spread.push_back(
        backbone_spread(field, uncertain, k, points.back().amplitude, static_cast<int>(points.size())));
    prediction.limit_cycle_spread.emplace_back();
    for (const LimitCycle& cycle : prediction.limit_cycles[k])
      prediction.limit_cycle_spread.back().push_back(limit_cycle_spread(field, uncertain, k, cycle));
  }
}

}  // namespace secular
