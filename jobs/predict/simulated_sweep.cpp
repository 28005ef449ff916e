#include "jobs/predict/simulated_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimator/model/locked_excitations.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A change between two dwells by this share of the sweep's largest amplitude, and so many times the changes before
/// and after it, is a jump. A continuous onset like a square root changes 2.4 times as much in its first step as in
/// its second.
constexpr double share_of_a_jump = 0.2, ratio_of_a_jump = 3;

/// Share of the predicted typical amplitude with which every dwell of a simulated sweep is disturbed.
constexpr double disturbance_share = 2e-3;

}  // namespace

PredictedSweep simulated_sweep(const PredictionRequest& request, const Prediction& prediction,
                               const ResponseRequest& response, const std::string& direction,
                               const std::function<void()>& done) {
  const CompiledModel& model = *prediction.model;
  const auto symbols = static_cast<Index>(model.symbols.size());
  const auto excitations = static_cast<Index>(model.excitations.size());
  if (response.parameter < symbols)
    throw InputError("--sweep", "", "the varied parameter " + prediction.vary->name + " is not of the excitation",
                     "sweeps go over an excitation frequency or amplitude");
  const LockedExcitations locked(model, *prediction.resonance);
  PredictedSweep swept;
  swept.direction = direction;
  SteppedSweep steps;
  steps.parameters = response.parameters;
  steps.disturbance = disturbance_share * 2 * prediction.diagram.scale;
  for (int i = 0; i < request.sweep_steps; ++i) {
    const double share = static_cast<double>(i) / (request.sweep_steps - 1);
    VectorXd p = response.parameters;
    p(response.parameter) = direction == "up" ? response.lower + share * (response.upper - response.lower)
                                              : response.upper - share * (response.upper - response.lower);
    swept.parameter.push_back(p(response.parameter));
    locked.follow(p.data() + symbols);
    SweepStep step;
    for (Index j = 0; j < excitations; ++j) {
      step.frequency.push_back(p(symbols + j));
      step.forcing.push_back(p(symbols + excitations + j));
    }
    steps.steps.push_back(std::move(step));
  }
  swept.points = stepped_sweep(model, *prediction.resonance, steps, done);
  for (std::size_t k = 0; k < model.modes(); ++k) {
    double largest = 0;
    for (const SweepPoint& point : swept.points) largest = std::max(largest, point.amplitude[k]);
    for (std::size_t i = 1; i < swept.points.size(); ++i) {
      const auto change = [&](std::size_t to) {
        if (to < 1 || to >= swept.points.size()) return 0.0;
        return std::abs(swept.points[to].amplitude[k] - swept.points[to - 1].amplitude[k]);
      };
      const double before = swept.points[i - 1].amplitude[k], after = swept.points[i].amplitude[k];
      if (swept.points[i - 1].settled && change(i) > share_of_a_jump * largest &&
          change(i) > ratio_of_a_jump * std::max(change(i - 1), change(i + 1)))
        swept.jumps.push_back({swept.parameter[i - 1], swept.parameter[i], before, after, k});
    }
  }
  return swept;
}

}  // namespace secular
