#include "measure/signal/circular_hyperbolic.hpp"

#include <stdexcept>

#include "measure/signal/decomposition.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

CircularHyperbolicFit circular_hyperbolic_decomposition(const Eigen::Ref<const VectorXd>& samples,
                                                        double sample_rate_hz, int order) {
  DecompositionOptions options;
  options.order = order;
  options.method = PolynomialMethod::least_squares;
  const Decomposition d = decompose(samples, sample_rate_hz, options);
  CircularHyperbolicFit fit;
  fit.correlation = d.correlation(0);
  fit.signal_to_noise_db = d.signal_to_noise_db(0);
  Index row = 0;
  for (const Pole& pole : d.poles) {
    const auto amplitude = [&](Index i) { return d.amplitudes(row + i, 0); };
    switch (pole.family) {
      case PoleFamily::circular:
        fit.circular.push_back({pole.frequency, amplitude(0), amplitude(1)});
        break;
      case PoleFamily::hyperbolic:
        fit.hyperbolic.push_back({pole.rate, amplitude(0), amplitude(1)});
        break;
      case PoleFamily::nyquist_hyperbolic:
        fit.nyquist.push_back({pole.rate, amplitude(0), amplitude(1)});
        break;
      case PoleFamily::product:
        fit.products.push_back({pole.rate, pole.frequency, amplitude(0), amplitude(1), amplitude(2), amplitude(3)});
        break;
      case PoleFamily::constant:
        break;
    }
    row += function_count(pole);
  }
  return fit;
}

}  // namespace secular
