#include "thesis/procedures/engine_lumps.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <stdexcept>

namespace secular {

using Complex = std::complex<double>;

bool is_additive_combination(const CompiledModel& model, const CompiledCase& resonance) {
  if (model.modes() != 2 || model.excitations.size() != 1 || resonance.relations.size() != 3) return false;
  const std::span<const int> r = resonance.relations;
  return std::abs(r[0]) == 1 && r[1] == r[0] && r[2] == -r[0];
}

Eigen::VectorXd two_mode_lumps(const CompiledModel& model, const CompiledCase& resonance,
                               const Eigen::Ref<const Eigen::VectorXd>& parameters) {
  if (!is_additive_combination(model, resonance))
    throw std::invalid_argument("the lumps of two modes are those of an additive combination resonance");
  const double w[2] = {parameters(0), parameters(1)};
  const double excitation = w[0] + w[1];
  const auto rate = [&](Complex a1, Complex a2, double force) {
    const Complex amplitude[2] = {a1, a2}, forcing[1] = {force};
    std::array<Complex, 2> derivative;
    resonance.modulation(parameters.data(), &excitation, amplitude, forcing, derivative.data());
    return derivative;
  };
  // Polynomials in the amplitudes: values at 0 (by a tiny amplitude), 1 and with the other mode or the force give
  // every coefficient exactly.
  struct Mode {
    double mu, cubic, linear, own, other, force;
    Complex direct;
  } mode[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const auto at = [&](double own, double other, double force) {
      return k == 0 ? rate(own, other, force)[0] : rate(other, own, force)[1];
    };
    constexpr double tiny = 1e-12;
    const Complex rest = at(tiny, 0, 0) / tiny;
    const Complex cubic = at(1, 0, 0) - rest;
    mode[k].mu = -rest.real();
    mode[k].linear = w[k] * rest.imag();
    mode[k].cubic = -cubic.real() / (1.5 * w[k] * w[k]);
    mode[k].own = w[k] * cubic.imag() / 4;
    // The other mode also comes in through F; without force it is |A2|^2 alone.
    mode[k].other = w[k] * (at(tiny, 1, 0) / tiny - rest).imag() / 4;
    mode[k].force = w[k] * (at(tiny, 0, 1) / tiny - rest).imag();
    mode[k].direct = at(0, 1, 1) * w[k] / Complex(0, 1);
  }
  Eigen::VectorXd lumps(static_cast<Eigen::Index>(TwoModeLump::count));
  lumps << mode[0].mu, mode[1].mu, mode[0].cubic, mode[1].cubic, mode[0].direct.real(), mode[0].direct.imag(),
      mode[1].direct.imag(), w[1] * mode[0].linear + w[0] * mode[1].linear,
      w[1] * mode[0].own + w[0] * mode[1].other, w[1] * mode[0].other + w[0] * mode[1].own,
      w[1] * mode[0].force + w[0] * mode[1].force;
  return lumps;
}

}  // namespace secular
