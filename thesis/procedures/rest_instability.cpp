#include "thesis/procedures/rest_instability.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "motion/response/response_field.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Looked for within this share of exact resonance, first at this many places.
constexpr double width = 0.02;
constexpr int places = 401;

/// Amplitude that stands for zero, in the coordinates' units: damping that grows with it has not begun.
constexpr double vanishing = 1e-12;

double growth_of_rest(const ResponseField& field, const VectorXd& parameters) {
  const auto modes = static_cast<Index>(field.active().size());
  MatrixXd slope(2 * modes, 2 * modes);
  for (Index column = 0; column < 2 * modes; ++column) {
    VectorXcd amplitude = VectorXcd::Zero(modes);
    amplitude(column / 2) = column % 2 == 0 ? std::complex<double>(vanishing) : std::complex<double>(0, vanishing);
    const VectorXcd rate = field.modulation(parameters, amplitude) / vanishing;
    for (Index k = 0; k < modes; ++k) {
      slope(2 * k, column) = rate(k).real();
      slope(2 * k + 1, column) = rate(k).imag();
    }
  }
  return slope.eigenvalues().real().maxCoeff();
}

}  // namespace

double most_unstable_excitation(const CompiledModel& model, const CompiledCase& resonance,
                                const Eigen::Ref<const VectorXd>& parameters, double forcing) {
  const std::size_t modes = model.modes();
  if (model.excitations.size() != 1 || resonance.relations.size() != modes + 1)
    throw std::invalid_argument("jump frequencies need one relation and one excitation");
  double exact = 0;
  for (std::size_t k = 0; k < modes; ++k)
    exact -= resonance.relations[k] * parameters(static_cast<Index>(k)) / resonance.relations[modes];
  const ResponseField field(model, resonance);
  VectorXd all(parameters.size() + 2);
  all << parameters, exact, forcing;
  const auto decay_of_rest = [&](double excitation) {
    all(parameters.size()) = excitation;
    return -growth_of_rest(field, all);
  };
  int best = 0;
  double least = INFINITY;
  const auto place = [&](int i) { return exact * (1 + width * (2.0 * i / (places - 1) - 1)); };
  for (int i = 0; i < places; ++i)
    if (const double decay = decay_of_rest(place(i)); decay < least) {
      least = decay;
      best = i;
    }
  std::uintmax_t iterations = 100;
  return boost::math::tools::brent_find_minima(decay_of_rest, place(best - 1), place(best + 1),
                                               std::numeric_limits<double>::digits / 2, iterations)
      .first;
}

}  // namespace secular
