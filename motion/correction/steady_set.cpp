#include "motion/correction/steady_set.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "measure/observe/record_ranges.hpp"
#include "motion/correction/mean_motion.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Balanced = std::optional<BalancedMotions::Balanced>;

/// A motion is steady whose amplitudes change by less than this share in a radian.
constexpr double steady = 1e-10;

constexpr int most_steps = 40;

/// The derivative is found anew where a step leaves more than this share of the growth before it.
constexpr double enough_progress = 0.2;

/// Differences are taken over this share of an amplitude, of a turn in radians and of a frequency.
constexpr double difference = 1e-6;

/// An amplitude changes by no more than this share in one step, and a frequency by no more than the second.
constexpr double longest_stride = 0.2, longest_detuning = 1e-3;

// The unknowns of a steady motion: the logarithm of every complex amplitude, real and imaginary part, then the
// frequencies that the resonance leaves free, relative. The phase that it leaves free with each of them moves
// nothing.
class Unknowns {
 public:
  Unknowns(const BalancedMotions& motions, const ModeFrequencies& modes, const VectorXd& parameters)
      : motions_(motions), modes_(modes), parameters_(parameters) {
    for (std::size_t k = 0; k < modes.oscillates.size(); ++k)
      if (modes.oscillates[k]) oscillating_.push_back(k);
  }

  Index count() const { return 2 * oscillating() + free(); }

  Observation stepped(Observation o, const VectorXd& step) const {
    for (Index i = 0; i < oscillating(); ++i)
      o.amplitude[oscillating_[static_cast<std::size_t>(i)]] *= std::exp(Complex(step(2 * i), step(2 * i + 1)));
    VectorXd frequency(free());
    for (Index f = 0; f < free(); ++f)
      frequency(f) = o.rate[modes_.free[static_cast<std::size_t>(f)]].imag() * (1 + step(2 * oscillating() + f));
    const VectorXd observed = modes_.observed(frequency, o.excitation_frequency);
    for (std::size_t k = 0; k < o.rate.size(); ++k) o.rate[k] = Complex(0, observed(static_cast<Index>(k)));
    return o;
  }

  // A step made no longer than the amplitudes and frequencies allow.
  VectorXd bounded(const VectorXd& step) const {
    const double amplitudes = step.head(2 * oscillating()).cwiseAbs().maxCoeff() / longest_stride,
                 detuning = free() > 0 ? step.tail(free()).cwiseAbs().maxCoeff() / longest_detuning : 0;
    return step / std::max({1.0, amplitudes, detuning});
  }

  /// By which each amplitude would grow and turn in a radian, real and imaginary part. `latest`: a motion nearby,
  /// to begin with, and then the one found.
  std::optional<VectorXd> growth(const Observation& o, Balanced& latest) const {
    Balanced balanced = motions_.at(parameters_, o, latest ? &latest->motion : nullptr);
    if (!balanced && latest) balanced = motions_.at(parameters_, o);
    if (!balanced) return std::nullopt;
    VectorXd growth(2 * oscillating());
    for (Index i = 0; i < oscillating(); ++i) {
      const std::size_t k = oscillating_[static_cast<std::size_t>(i)];
      const std::optional<Complex> rate = motions_.rate_of(k, *balanced);
      if (!rate) return std::nullopt;
      const Complex left = (*rate - o.rate[k]) / std::abs(o.rate[k]);
      growth(2 * i) = left.real();
      growth(2 * i + 1) = left.imag();
    }
    latest = std::move(balanced);
    return growth;
  }

  std::optional<MatrixXd> inverse_derivative(const Observation& o, const VectorXd& growth_here,
                                             const Balanced& here) const {
    MatrixXd derivative(growth_here.size(), count());
    for (Index u = 0; u < count(); ++u) {
      Balanced beside = here;
      const std::optional<VectorXd> moved = growth(stepped(o, difference * VectorXd::Unit(count(), u)), beside);
      if (!moved) return std::nullopt;
      derivative.col(u) = (*moved - growth_here) / difference;
    }
    if (!derivative.allFinite()) return std::nullopt;
    return derivative.completeOrthogonalDecomposition().pseudoInverse();
  }

 private:
  Index oscillating() const { return static_cast<Index>(oscillating_.size()); }
  Index free() const { return modes_.coupling.cols(); }

  const BalancedMotions& motions_;
  const ModeFrequencies& modes_;
  const VectorXd& parameters_;
  std::vector<std::size_t> oscillating_;
};

}  // namespace

SteadySet::SteadySet(const ObservationSet& measured, unsigned threads)
    : measured_(measured),
      motions_(*measured.model, *measured.resonance),
      modes_(mode_frequencies(*measured.model, *measured.resonance)),
      threads_(threads) {
  if (!measured.resonance->excited) throw std::invalid_argument("a free decay has no steady motion");
  const std::span<const Observation> all = measured.observations;
  for (const RecordRange& range : ranges_of_records(all)) {
    Dwell dwell;
    dwell.begin = range.begin;
    dwell.end = range.end;
    dwell.latest = mean_motion(range.of(all), *measured.model, *measured.resonance);
    dwells_.push_back(std::move(dwell));
  }
}

std::optional<ObservationSet> SteadySet::at(const VectorXd& parameters) {
  ObservationSet result = measured_;
  std::vector<char> found(dwells_.size(), false);  // not of bool, whose elements share bytes
  in_parallel(dwells_.size(), threads_, [&](std::size_t d) {
    Dwell& dwell = dwells_[d];
    if (!find(dwell, parameters)) return;
    for (std::size_t i = dwell.begin; i < dwell.end; ++i) take_motion(dwell.latest, result.observations[i]);
    found[d] = true;
  });
  if (std::find(found.begin(), found.end(), false) != found.end()) return std::nullopt;
  return result;
}

// Newton's method with the derivative of the step before, or of the motion found last, as long as that leads on.
bool SteadySet::find(Dwell& dwell, const VectorXd& parameters) const {
  const Unknowns unknowns(motions_, modes_, parameters);
  const VectorXd still = VectorXd::Zero(unknowns.count());
  Observation o = unknowns.stepped(dwell.latest, still);
  Balanced balanced = dwell.balanced;
  MatrixXd inverse = dwell.inverse;
  double before = INFINITY;
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<VectorXd> growth = unknowns.growth(o, balanced);
    if (!growth) return false;
    const double size = growth->cwiseAbs().maxCoeff();
    if (size < steady) {
      motions_.show(*balanced, o);
      dwell.latest = unknowns.stepped(std::move(o), still);
      dwell.balanced = std::move(balanced);
      dwell.inverse = std::move(inverse);
      return true;
    }
    if (inverse.size() == 0 || size > enough_progress * before) {
      std::optional<MatrixXd> anew = unknowns.inverse_derivative(o, *growth, balanced);
      if (!anew) return false;
      inverse = std::move(*anew);
    }
    before = size;
    const VectorXd step = -inverse * *growth;
    if (!step.allFinite()) return false;
    o = unknowns.stepped(std::move(o), unknowns.bounded(step));
  }
  return false;
}

}  // namespace secular
