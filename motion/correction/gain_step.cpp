#include "motion/correction/gain_step.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "estimator/identification/beyond_chance.hpp"
#include "estimator/thresholds.hpp"
#include "measure/observe/common_observations.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Windows on either side of a step: two thirds of a decay at most.
constexpr std::size_t fewest_beside = 3, most_beside = 8;
/// A slow course of third degree, and a step.
constexpr Index unknowns = 5;
/// Of a window's length, by which its neighbour may seem to overlap it.
constexpr double touching = 1e-3;

// Windows of one decay without a sample in common: logarithm of the amplitude (real part) and its phase, less what
// the full equations do.
struct Course {
  std::vector<double> time, length, sd;
  std::vector<std::complex<double>> value;
};

// From one window to the next by the rates of the full equations' motions, to fourth order.
std::complex<double> way_between(const std::vector<double>& time, const std::vector<std::complex<double>>& rate,
                                 std::size_t j) {
  const auto slope = [&](std::size_t i) {
    const std::size_t from = i > 0 ? i - 1 : i, to = std::min(i + 1, rate.size() - 1);
    return (rate[to] - rate[from]) / (time[to] - time[from]);
  };
  const double h = time[j + 1] - time[j];
  return 0.5 * h * (rate[j] + rate[j + 1]) + h * h / 12 * (slope(j) - slope(j + 1));
}

// Of the record whose windows begin at `begin`; moves that to the next record's.
Course course_of(const ObservationSet& set, const ObservationSet& replayed,
                 const std::vector<std::pair<std::size_t, std::size_t>>& common, std::size_t& begin) {
  const std::size_t record = set.observations[common[begin].first].record;
  const std::size_t mode = largest_mode(set.observations[common[begin].first]);
  Course course;
  std::vector<std::complex<double>> measured, rate;
  for (; begin < common.size(); ++begin) {
    const Observation &o = set.observations[common[begin].first],
                      &full = replayed.observations[common[begin].second];
    if (o.record != record) break;
    if (!course.time.empty() && o.centre_s - course.time.back() < (1 - touching) * o.length_s) continue;
    if (o.growth_sd[mode] < 0 || !(o.amplitude_sd[mode] > 0)) continue;
    course.time.push_back(o.centre_s);
    course.length.push_back(o.length_s);
    measured.emplace_back(std::log(std::abs(o.amplitude[mode])), std::arg(o.amplitude[mode]));
    course.sd.push_back(o.amplitude_sd[mode] / std::abs(o.amplitude[mode]));
    rate.push_back(full.rate[mode]);
  }
  for (std::size_t j = 0; j < measured.size(); ++j) {
    if (j == 0) {
      course.value.emplace_back(0);
      continue;
    }
    std::complex<double> more = measured[j] - measured[j - 1] - way_between(course.time, rate, j - 1);
    more.imag(std::remainder(more.imag(), 2 * std::numbers::pi));
    course.value.push_back(course.value.back() + more);
  }
  return course;
}

// Steps of amplitude and phase at window i, in their unit, and F of each with its degrees of freedom.
struct Step {
  double amplitude = 0, f_of_amplitude = 0, f_of_phase = 0, freedom = 0;
};

Step step_at(const Course& course, std::size_t i) {
  const std::size_t from = i > most_beside ? i - most_beside : 0,
                    to = std::min(course.time.size() - 1, i + most_beside);
  const auto rows = static_cast<Index>(to - from);
  MatrixXd matrix(rows, unknowns);
  MatrixXd target(rows, 2);
  Index at = 0;
  for (std::size_t j = from; j <= to; ++j) {
    if (j == i) continue;
    const double t = (course.time[j] - course.time[i]) / course.length[i];
    matrix.row(at) << 1, t, t * t, t * t * t, j > i ? 1 : 0;
    target.row(at) << course.value[j].real(), course.value[j].imag();
    matrix.row(at) /= course.sd[j];
    target.row(at++) /= course.sd[j];
  }
  const MatrixXd found = matrix.colPivHouseholderQr().solve(target);
  const double variance = (matrix.transpose() * matrix).inverse()(unknowns - 1, unknowns - 1);
  Step step;
  step.freedom = static_cast<double>(rows - unknowns);
  const auto f = [&](Index column) {
    const double scatter =
        std::max(1.0, (target.col(column) - matrix * found.col(column)).squaredNorm() / step.freedom);
    return found(unknowns - 1, column) * found(unknowns - 1, column) / (variance * scatter);
  };
  step.amplitude = found(unknowns - 1, 0);
  step.f_of_amplitude = f(0);
  step.f_of_phase = f(1);
  return step;
}

void scale(Observation& o, double by) {
  for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
    o.amplitude[k] *= by;
    o.amplitude_sd[k] *= by;
  }
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    o.harmonic[b] *= by;
    if (o.harmonic_sd[b] >= 0) o.harmonic_sd[b] *= by;
  }
  for (double& mean : o.mean) mean *= by;
}

}  // namespace

std::optional<GainStep> gain_step(const CorrectedEstimate& found) {
  struct Place {
    GainStep step;
    double over_chance = 0;  // F over its limit, but for the number of places
    double f = 0, freedom = 0;
  };
  std::vector<Place> places;
  for (std::size_t s = 0; s < found.corrected.size() && s < found.replayed.size(); ++s) {
    const ObservationSet &set = found.corrected[s], &replayed = found.replayed[s];
    if (set.resonance->excited) continue;
    std::vector<std::pair<std::size_t, std::size_t>> common;
    for_common_observations(set, replayed, [&](std::size_t i, std::size_t r) { common.emplace_back(i, r); });
    for (std::size_t begin = 0; begin < common.size();) {
      const std::size_t record = set.observations[common[begin].first].record;
      const Course course = course_of(set, replayed, common, begin);
      for (std::size_t i = fewest_beside; i + fewest_beside < course.time.size(); ++i) {
        const Step step = step_at(course, i);
        Place place{
            {record, course.time[i], course.length[i], step.amplitude, 1}, 0, step.f_of_amplitude, step.freedom};
        if (step.f_of_phase > step.f_of_amplitude) place.f = 0;  // a knock
        places.push_back(place);
      }
    }
  }
  const Place* most = nullptr;
  const double alarm = estimator_thresholds().contradiction_alarm / static_cast<double>(places.size());
  for (Place& place : places) {
    const double by_chance = f_upper_quantile(alarm, 1, place.freedom);
    place.over_chance = place.f / by_chance;
    if (most == nullptr || place.over_chance > most->over_chance) most = &place;
  }
  if (most == nullptr || !(most->over_chance > 1)) return std::nullopt;
  GainStep step = most->step;
  step.counts = beyond_chance(most->f, most->freedom, alarm);
  return step;
}

std::vector<ObservationSet> with_one_gain(std::vector<ObservationSet> sets, const GainStep& step, RightGain right) {
  for (ObservationSet& set : sets) {
    if (set.resonance->excited) continue;
    std::erase_if(set.observations, [&](const Observation& o) {
      return o.record == step.record && std::abs(o.centre_s - step.at_s) < 0.5 * (o.length_s + step.within_s);
    });
    for (Observation& o : set.observations) {
      if (o.record != step.record) continue;
      const bool before = o.centre_s < step.at_s;
      if (right == RightGain::before && !before) scale(o, std::exp(-step.size));
      if (right == RightGain::behind && before) scale(o, std::exp(step.size));
    }
  }
  return sets;
}

}  // namespace secular
