#include "measure/modal/stabilisation.hpp"

#include <algorithm>
#include <cmath>

#include "input/stop_request.hpp"
#include "measure/modal/modal_assurance.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;

double spread(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean);
  return values.size() > 1 ? std::sqrt(square / static_cast<double>(values.size() - 1)) : 0;
}

void add_order(StabilisationDiagram& diagram, const Realization& realization, int order) {
  std::vector<StabilisationPole>& poles = diagram.poles;
  const std::size_t end = poles.size();
  std::size_t begin = end;
  while (begin > 0 && poles[begin - 1].order == order - 2) --begin;
  for (Index i = 0; i < realization.z.size(); ++i) {
    const std::complex<double> pole = realization.poles(i);
    const double damping = damping_ratio(pole);
    if (!has_peak(pole) || !(std::abs(realization.z(i).imag()) > 1e-12)) continue;
    StabilisationPole found;
    found.order = order;
    found.pole = pole;
    found.shape = realization.C.col(i);
    found.strength = found.shape.cwiseAbs().maxCoeff() * realization.B.row(i).cwiseAbs().maxCoeff();
    double best = -1;
    for (std::size_t k = begin; k < end; ++k) {
      const double apart = std::abs(natural_frequency(poles[k].pole) / natural_frequency(pole) - 1);
      if (apart > diagram.options.frequency_tolerance) continue;
      // Close modes are told apart by their shapes.
      const double mac = modal_assurance(poles[k].shape, found.shape);
      const double likeness = mac - apart / diagram.options.frequency_tolerance;
      if (found.previous >= 0 && likeness <= best) continue;
      best = likeness;
      found.previous = static_cast<int>(k);
      found.stable_frequency = true;
      found.stable_damping =
          std::abs(damping_ratio(poles[k].pole) / damping - 1) <= diagram.options.damping_tolerance;
      found.stable_shape = mac >= diagram.options.shape_tolerance;
    }
    poles.push_back(std::move(found));
  }
}

StableMode mode_of(const StabilisationDiagram& diagram, const std::vector<std::size_t>& chain) {
  std::vector<double> growth, omega, frequency, damping;
  for (const std::size_t k : chain) {
    const std::complex<double> pole = diagram.poles[k].pole;
    growth.push_back(pole.real());
    omega.push_back(pole.imag());
    frequency.push_back(natural_frequency(pole));
    damping.push_back(damping_ratio(pole));
  }
  StableMode mode;
  mode.pole = {upper_median(growth), upper_median(omega)};
  mode.orders = static_cast<int>(chain.size());
  mode.frequency_spread = spread(frequency);
  mode.damping_spread = spread(damping);
  const auto nearest = std::min_element(chain.begin(), chain.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(diagram.poles[a].pole - mode.pole) < std::abs(diagram.poles[b].pole - mode.pole);
  });
  mode.shape = diagram.poles[*nearest].shape;
  mode.strength = diagram.poles[*nearest].strength;
  return mode;
}

// One physical mode that the orders show twice: same shape, and same frequency within the tolerance or within the
// half-power bandwidths. A decay whose damping changes with amplitude is a sum of several such poles. One channel
// alone has no shape, and the bandwidths do not count.
bool same_mode(const StableMode& a, const StableMode& b, const StabilisationOptions& options) {
  const double apart = std::abs(natural_frequency(a.pole) - natural_frequency(b.pole));
  const double tolerance = options.frequency_tolerance * natural_frequency(b.pole);
  const double bandwidths = a.shape.size() > 1 ? std::abs(a.pole.real()) + std::abs(b.pole.real()) : 0;
  return apart <= std::max(tolerance, bandwidths) && modal_assurance(a.shape, b.shape) >= options.shape_tolerance;
}

// Of two chains of one mode the longer one, but of two that decay with different damping the one that rings longer:
// the other poles make up for the beginning of the decay.
bool better(const StableMode& a, const StableMode& b, const StabilisationOptions& options) {
  const double ratio = damping_ratio(a.pole) / damping_ratio(b.pole);
  const bool both_decay = damping_ratio(a.pole) > 0 && damping_ratio(b.pole) > 0;
  return both_decay && std::abs(ratio - 1) > options.damping_tolerance ? ratio < 1 : a.orders > b.orders;
}

}  // namespace

bool same_pole(const StableMode& a, const StableMode& b, const StabilisationOptions& options) {
  return std::abs(natural_frequency(a.pole) / natural_frequency(b.pole) - 1) <= options.frequency_tolerance &&
         std::abs(damping_ratio(a.pole) / damping_ratio(b.pole) - 1) <= options.damping_tolerance &&
         modal_assurance(a.shape, b.shape) >= options.shape_tolerance;
}

StabilisationDiagram stabilisation_diagram(const EigensystemRealization& realization,
                                           const StabilisationOptions& options) {
  StabilisationDiagram diagram;
  diagram.options = options;
  diagram.singular_values = realization.singular_values();
  const int largest = static_cast<int>(std::min<Index>(options.largest_order, realization.rank())) / 2 * 2;
  for (int order = 2; order <= largest; order += 2) {
    end_if_stopped();
    add_order(diagram, realization.realize(order), order);
  }
  // Chains are followed down from their last pole; each ends in the diagram where no higher order continues it.
  std::vector<bool> continued(diagram.poles.size(), false);
  for (const StabilisationPole& pole : diagram.poles)
    if (pole.stable()) continued[static_cast<std::size_t>(pole.previous)] = true;
  std::vector<StableMode> modes;
  for (std::size_t k = diagram.poles.size(); k-- > 0;) {
    if (continued[k] || (!diagram.poles[k].stable() && diagram.poles[k].order < largest)) continue;
    std::vector<std::size_t> chain = {k};
    while (diagram.poles[chain.back()].stable())
      chain.push_back(static_cast<std::size_t>(diagram.poles[chain.back()].previous));
    const int first = diagram.poles[chain.back()].order;
    const auto possible = static_cast<double>((largest - first) / 2 + 1);
    if (static_cast<double>(chain.size()) < options.persistence * possible) continue;
    // Exact data end at their rank, where a mode may stand for the first time; otherwise it takes three orders.
    const bool exact = largest < options.largest_order / 2 * 2;
    if (chain.size() < 3 && !(exact && static_cast<double>(chain.size()) >= possible)) continue;
    StableMode mode = mode_of(diagram, chain);
    const auto twin =
        std::find_if(modes.begin(), modes.end(), [&](const StableMode& m) { return same_mode(m, mode, options); });
    if (twin == modes.end())
      modes.push_back(std::move(mode));
    else if (better(mode, *twin, options))
      *twin = std::move(mode);
  }
  std::sort(modes.begin(), modes.end(), [](const StableMode& a, const StableMode& b) {
    return natural_frequency(a.pole) < natural_frequency(b.pole);
  });
  for (StableMode& mode : modes) {
    const double hz = natural_frequency(mode.pole) * to_hz;
    const bool outside = hz < options.lowest_hz || (options.highest_hz > 0 && hz > options.highest_hz);
    (outside ? diagram.others : diagram.modes).push_back(std::move(mode));
  }
  return diagram;
}

}  // namespace secular
