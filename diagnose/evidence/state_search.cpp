#include "diagnose/evidence/state_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 10, most_halvings = 5;

// Displacements and velocities at the first sample by a sinusoid at every natural frequency over the first turns.
VectorXd guessed_state(const SensorModel& sensors, const Segment& s, const VectorXd& unknowns, Index modes) {
  const MatrixXd modal = sensors.filter * s.response;
  VectorXd state = VectorXd::Zero(2 * modes);
  for (Index k = 0; k < modes; ++k) {
    const double w = unknowns(k);
    const auto samples = static_cast<Index>(
        std::min(static_cast<double>(s.response.cols()), std::floor(1.2 * two_pi / w / s.sample_s) + 3));
    const Eigen::ArrayXd phase =
        Eigen::ArrayXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)) * (w * s.sample_s);
    MatrixXd waves(samples, 3);
    waves.col(0) = phase.cos();
    waves.col(1) = phase.sin();
    waves.col(2).setOnes();
    const VectorXd fit = waves.colPivHouseholderQr().solve(VectorXd(modal.row(k).head(samples).transpose()));
    // Of the measured quantity; divided by i w as often as it is differentiated.
    std::complex<double> amplitude(fit(0), -fit(1));
    for (int d = 0; d < sensors.derivatives; ++d) amplitude /= std::complex<double>(0, w);
    state(k) = amplitude.real();
    state(modes + k) = (amplitude * std::complex<double>(0, w)).real();
  }
  return state;
}

// One search on its way.
struct Walk {
  StateSearch& search;
  VectorXd unit;   // of a step: scales of displacement and velocity
  VectorXd error;  // where it is
  VectorXd change = {};
  double factor = 1, gain = -1;

  VectorXd moved() const { return search.state + factor * change.cwiseProduct(unit); }
};

class Walks {
 public:
  Walks(const SegmentModel& model, const VectorXd& unknowns, std::vector<StateSearch>& searches)
      : model_(model), unknowns_(unknowns), size_(static_cast<Index>(2 * model.modes())) {
    for (StateSearch& search : searches) walks_.push_back({search, unit_of(search.segment), {}});
    for (Walk& walk : walks_) going_.push_back(&walk);
    std::vector<VectorXd> errors = errors_at(going_, [](const Walk& walk) { return walk.search.state; });
    for (std::size_t i = 0; i < walks_.size(); ++i) walks_[i].error = std::move(errors[i]);
  }

  void run() {
    for (int i = 0; i < most_steps && !going_.empty(); ++i) {
      find_changes();
      take_steps();
      std::erase_if(going_, [](const Walk* walk) { return walk->gain < 1e-3 + 1e-6 * walk->error.squaredNorm(); });
    }
    for (Walk& walk : walks_) walk.search.squared_error = walk.error.squaredNorm();
  }

 private:
  // From the channels.
  VectorXd unit_of(const Segment& s) const {
    const SensorModel& sensors = model_.sensors();
    const double frequency = unknowns_(0);
    const double largest = s.response.cwiseAbs().maxCoeff() /
                           std::max(1e-300, sensors.shapes.cwiseAbs().maxCoeff()) /
                           std::pow(frequency, sensors.derivatives);
    VectorXd unit(size_);
    unit.head(size_ / 2).setConstant(1e-4 * largest);
    unit.tail(size_ / 2).setConstant(1e-4 * largest * frequency);
    return unit;
  }

  template <class State>
  std::vector<VectorXd> errors_at(const std::vector<Walk*>& walks, const State& state) const {
    std::vector<SegmentTrial> trials;
    for (const Walk* walk : walks)
      trials.push_back({walk->search.segment, walk->search.samples, unknowns_, state(*walk)});
    std::vector<VectorXd> errors = model_.errors(trials);
    for (std::size_t i = 0; i < errors.size(); ++i)
      errors[i] = silenced(std::move(errors[i]), walks[i]->search.samples, walks[i]->search.without);
    return errors;
  }

  // A search without a finite step is at its end.
  void find_changes() {
    std::vector<SegmentTrial> trials;
    for (const Walk* walk : going_)
      for (Index k = 0; k < size_; ++k) {
        trials.push_back({walk->search.segment, walk->search.samples, unknowns_, walk->search.state});
        trials.back().state(k) += walk->unit(k);
      }
    std::vector<VectorXd> moved = model_.errors(trials);
    for (std::size_t i = 0; i < going_.size(); ++i) {
      Walk& walk = *going_[i];
      MatrixXd slope(walk.error.size(), size_);
      for (Index k = 0; k < size_; ++k)
        slope.col(k) = silenced(std::move(moved[i * static_cast<std::size_t>(size_) + static_cast<std::size_t>(k)]),
                                walk.search.samples, walk.search.without) -
                       walk.error;
      walk.change = -VectorXd(slope.colPivHouseholderQr().solve(walk.error));
    }
    std::erase_if(going_, [](const Walk* walk) { return !walk->change.allFinite(); });
  }

  void take_steps() {
    for (Walk* walk : going_) {
      walk->factor = 1;
      walk->gain = -1;
    }
    std::vector<Walk*> open = going_;
    for (int half = 0; half < most_halvings && !open.empty(); ++half) {
      std::vector<VectorXd> errors = errors_at(open, [](const Walk& walk) { return walk.moved(); });
      for (std::size_t i = 0; i < open.size(); ++i) {
        Walk& walk = *open[i];
        if (errors[i].squaredNorm() < walk.error.squaredNorm()) {
          walk.gain = walk.error.squaredNorm() - errors[i].squaredNorm();
          walk.search.state = walk.moved();
          walk.error = std::move(errors[i]);
        }
        walk.factor *= 0.3;
      }
      std::erase_if(open, [](const Walk* walk) { return !(walk->gain < 0); });
    }
  }

  const SegmentModel& model_;
  const VectorXd& unknowns_;
  Index size_;
  std::vector<Walk> walks_;
  std::vector<Walk*> going_;
};

}  // namespace

void improve_states(const SegmentModel& model, const VectorXd& unknowns, std::vector<StateSearch>& searches) {
  Walks(model, unknowns, searches).run();
}

// A long stretch has many minima: a new state is found from its beginning on, and the better one stays.
void find_states(const SegmentModel& model, const VectorXd& unknowns, std::vector<StateSearch>& searches) {
  std::vector<StateSearch> fresh;
  for (const StateSearch& search : searches) {
    const Segment& s = search.segment;
    fresh.push_back(
        {s, guessed_state(model.sensors(), s, unknowns, static_cast<Index>(model.modes())), 0, search.without});
  }
  for (const Index parts : {8, 3}) {
    std::vector<StateSearch> begun;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      fresh[i].samples = searches[i].samples / parts;
      if (fresh[i].samples > 8) begun.push_back(fresh[i]);
    }
    improve_states(model, unknowns, begun);
    auto next = begun.begin();
    for (StateSearch& search : fresh)
      if (search.samples > 8) search.state = (next++)->state;
  }
  for (std::size_t i = 0; i < searches.size(); ++i) {
    fresh[i].samples = searches[i].samples;
    if (searches[i].state.size() > 0) fresh.push_back(searches[i]);
  }
  improve_states(model, unknowns, fresh);
  auto known = fresh.begin() + static_cast<std::ptrdiff_t>(searches.size());
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const bool was_known = searches[i].state.size() > 0;
    const StateSearch& best = was_known && known->squared_error <= fresh[i].squared_error ? *known : fresh[i];
    searches[i].state = best.state;
    searches[i].squared_error = best.squared_error;
    if (was_known) ++known;
  }
}

}  // namespace secular
