#include "measure/modal/mode_windows.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "measure/modal/eigensystem_realization.hpp"
#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/pole_fit.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

ResponseSequence single_reference(const Eigen::Ref<const MatrixXd>& samples) {
  ResponseSequence sequence(static_cast<std::size_t>(samples.rows()));
  for (Index k = 0; k < samples.rows(); ++k) sequence[static_cast<std::size_t>(k)] = samples.row(k).transpose();
  return sequence;
}

// Whether a pole may be the expected mode's: a resonance within the search, or within the half bandwidth of a mode
// whose resonance is wider.
bool within_reach(Complex pole, Complex expected, double search) {
  const double reach = std::max(search * expected.imag(), std::abs(expected.real()));
  return has_peak(pole) && std::abs(pole.imag() - expected.imag()) <= reach;
}

// Whether samples at this rate over a time show a mode of the pole at all.
bool can_be_fitted(Complex pole, double rate, double duration_s) {
  return pole.imag() > 0 && pole.imag() <= std::numbers::pi * rate && representable(pole, duration_s);
}

// The modes' poles in this window: the realization's nearest ones, or where it has none the expected one. None of a
// window without any motion.
VectorXcd starting_poles(const Eigen::Ref<const MatrixXd>& samples, double rate, const VectorXcd& expected,
                         double search) {
  const int order = static_cast<int>(2 * expected.size() + 4);
  const HankelSize size = hankel_size(samples.rows(), samples.cols(), 1, order, false, 1200);
  const EigensystemRealization era(single_reference(samples), rate, false, size);
  if (era.rank() < 1) return {};
  const Realization realization = era.realize(std::min<Index>(order, era.rank()));
  const double duration_s = static_cast<double>(samples.rows()) / rate;
  VectorXcd start = expected;
  std::vector<bool> taken(static_cast<std::size_t>(realization.poles.size()), false);
  for (Index r = 0; r < expected.size(); ++r) {
    Index best = -1;
    for (Index i = 0; i < realization.poles.size(); ++i) {
      const Complex pole = realization.poles(i);
      if (taken[static_cast<std::size_t>(i)] || !within_reach(pole, expected(r), search) ||
          !can_be_fitted(pole, rate, duration_s))
        continue;
      if (best < 0 || std::abs(pole - expected(r)) < std::abs(realization.poles(best) - expected(r))) best = i;
    }
    if (best < 0) continue;
    taken[static_cast<std::size_t>(best)] = true;
    start(r) = realization.poles(best);
  }
  return start;
}

bool audible(const PoleFit& fit, Index mode, double level) {
  for (Index c = 0; c < fit.noise_sd.size(); ++c)
    if (std::abs(fit.residues(mode, c)) > 0 && 2 * std::abs(fit.residues(mode, c)) >= level * fit.noise_sd(c))
      return true;
  return false;
}

// Covariances of each mode's poles between windows that overlap.
class Overlaps {
 public:
  // `count` windows may overlap with the one before them.
  Overlaps(Index modes, std::size_t count) : earlier_(static_cast<std::size_t>(modes)), count_(count) {}

  std::vector<SharedSamples> add(Index mode, std::size_t place, Index first, PoleInfluence influence) {
    std::deque<Earlier>& earlier = earlier_[static_cast<std::size_t>(mode)];
    const Index length = influence.growth.rows();
    std::vector<SharedSamples> shared;
    for (const Earlier& other : earlier) {
      const Index both = length - (first - other.first);
      if (both <= 0) break;
      const auto product = [&](const MatrixXd& now, const MatrixXd& then) {
        return now.topRows(both).cwiseProduct(then.bottomRows(both)).sum();
      };
      shared.push_back({other.place, static_cast<double>(both) / static_cast<double>(length),
                        product(influence.growth, other.influence.growth),
                        product(influence.omega, other.influence.omega)});
    }
    earlier.push_front({place, first, std::move(influence)});
    if (earlier.size() > count_) earlier.pop_back();
    return shared;
  }

 private:
  struct Earlier {
    std::size_t place;
    Index first;
    PoleInfluence influence;
  };
  std::vector<std::deque<Earlier>> earlier_;  // by mode, the latest first
  std::size_t count_;
};

}  // namespace

bool window_fits(Index rows, double sample_rate_hz, Index modes, double length_s) {
  const double length = std::round(length_s * sample_rate_hz);
  return length >= static_cast<double>(8 + 4 * modes) && length <= static_cast<double>(rows);
}

std::vector<ModeWindow> mode_windows(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                                     const std::vector<Complex>& poles, const ModeWindowOptions& options) {
  const auto modes = static_cast<Index>(poles.size());
  if (!window_fits(samples.rows(), sample_rate_hz, modes, options.length_s))
    throw std::invalid_argument("mode_windows: the window does not fit");
  const auto length = static_cast<Index>(std::lround(options.length_s * sample_rate_hz));
  const auto step = std::max<Index>(
      1, static_cast<Index>(std::lround((1 - options.overlap) * options.length_s * sample_rate_hz)));
  std::vector<Index> followed;
  for (Index r = 0; r < modes; ++r) followed.push_back(r);
  // One that grows comes out of the noise at some time: until then it is waited for.
  std::vector<bool> seen(poles.size(), false);
  const auto awaited = [&](Index mode) {
    return poles[static_cast<std::size_t>(mode)].real() > 0 && !seen[static_cast<std::size_t>(mode)];
  };
  std::vector<Complex> expected = poles;
  std::vector<ModeWindow> windows;
  Overlaps overlaps(modes, static_cast<std::size_t>((length - 1) / step));
  for (Index first = 0; first + length <= samples.rows() && !followed.empty(); first += step) {
    const auto place = static_cast<std::size_t>(first / step);
    std::erase_if(followed, [&](Index mode) {
      return !can_be_fitted(expected[static_cast<std::size_t>(mode)], sample_rate_hz,
                            static_cast<double>(length) / sample_rate_hz);
    });
    if (followed.empty()) break;
    VectorXcd near(static_cast<Index>(followed.size()));
    for (Index i = 0; i < near.size(); ++i)
      near(i) = expected[static_cast<std::size_t>(followed[static_cast<std::size_t>(i)])];
    const MatrixXd window = samples.middleRows(first, length);
    VectorXcd start = starting_poles(window, sample_rate_hz, near, options.search);
    if (start.size() == 0) {
      std::erase_if(followed, [&](Index mode) { return !awaited(mode); });
      continue;
    }
    // Poles that are not refined yet leave more than noise: only what is lost for good is left out here.
    const PoleFit first_fit = fit_residues(window, sample_rate_hz, start);
    std::vector<Index> heard, left, still;
    for (Index i = 0; i < near.size(); ++i) {
      const Index mode = followed[static_cast<std::size_t>(i)];
      if (audible(first_fit, i, 0.1 * options.end_at_noise)) {
        heard.push_back(i);
        left.push_back(mode);
      } else if (awaited(mode)) {
        still.push_back(mode);
      }
    }
    followed = heard.empty() ? still : left;
    if (heard.empty()) continue;
    start = start(heard).eval();
    near = near(heard).eval();
    const PoleFit fit = refine_poles(window, sample_rate_hz, start);
    std::vector<PoleInfluence> influences = pole_influences(window, sample_rate_hz, fit);
    for (Index i = 0; i < near.size(); ++i) {
      const Index mode = followed[static_cast<std::size_t>(i)];
      const Complex pole = fit.poles(i);
      // A pole that has run away has no mode left to follow.
      if (!audible(fit, i, options.end_at_noise) || !within_reach(pole, near(i), options.search) ||
          !std::isfinite(fit.omega_sd(i))) {
        if (awaited(mode)) still.push_back(mode);
        continue;
      }
      still.push_back(mode);
      seen[static_cast<std::size_t>(mode)] = true;
      const ScaledShape scaled = scale_shape(fit.residues.row(i).transpose());
      const double gained = pole.real() * static_cast<double>(length) / sample_rate_hz;
      const double mean = std::abs(gained) > 1e-12 ? std::expm1(gained) / gained : 1;
      windows.push_back({0, place, mode,
                         (static_cast<double>(first) + 0.5 * static_cast<double>(length - 1)) / sample_rate_hz,
                         pole, fit.growth_sd(i), fit.omega_sd(i), 2 * std::abs(scaled.factor) * mean, scaled.shape,
                         overlaps.add(mode, place, first, std::move(influences[static_cast<std::size_t>(i)]))});
      expected[static_cast<std::size_t>(mode)] = pole;
    }
    followed = std::move(still);
  }
  return windows;
}

}  // namespace secular
