#include "measure/signal/circular_hyperbolic.hpp"

#include <stdexcept>

#include "measure/signal/decomposition.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct PolesAndAmplitudes {
  std::vector<Pole> poles;
  std::vector<double> amplitudes;
};

PolesAndAmplitudes listed(const CircularHyperbolicFit& fit) {
  PolesAndAmplitudes all;
  const auto add = [&](PoleFamily family, double frequency, double rate, std::initializer_list<double> values) {
    all.poles.push_back({family, frequency, rate, false});
    all.amplitudes.insert(all.amplitudes.end(), values);
  };
  for (const CircularTerm& t : fit.circular) add(PoleFamily::circular, t.frequency, 0, {t.p, t.q});
  for (const HyperbolicTerm& t : fit.hyperbolic) add(PoleFamily::hyperbolic, 0, t.rate, {t.a, t.b});
  for (const NyquistHyperbolicTerm& t : fit.nyquist) add(PoleFamily::nyquist_hyperbolic, 0, t.rate, {t.c, t.d});
  for (const ProductTerm& t : fit.products) add(PoleFamily::product, t.frequency, t.rate, {t.e, t.f, t.g, t.h});
  return all;
}

}  // namespace

VectorXd CircularHyperbolicFit::reconstruct(Index samples) const {
  const PolesAndAmplitudes all = listed(*this);
  return pole_functions(all.poles, samples, sample_rate_hz, 0) *
         Eigen::Map<const VectorXd>(all.amplitudes.data(), static_cast<Index>(all.amplitudes.size()));
}

CircularHyperbolicFit circular_hyperbolic_decomposition(const Eigen::Ref<const VectorXd>& samples,
                                                        double sample_rate_hz, int order) {
  DecompositionOptions options;
  options.order = order;
  options.method = PolynomialMethod::least_squares;
  const Decomposition d = decompose(samples, sample_rate_hz, options);
  CircularHyperbolicFit fit;
  fit.sample_rate_hz = sample_rate_hz;
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
