#include "numerics/fourier_transform.hpp"

#include <unsupported/Eigen/FFT>

namespace secular {
namespace {

Eigen::FFT<double>& transform_of_halves() {
  thread_local Eigen::FFT<double> transform(Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
  return transform;
}

}  // namespace

Eigen::VectorXcd half_spectrum(const Eigen::Ref<const Eigen::VectorXd>& samples) {
  if (samples.size() < 2) return samples;  // Eigen's transform of one value crashes
  Eigen::VectorXcd lines(samples.size() / 2 + 1);
  transform_of_halves().fwd(lines.data(), samples.data(), samples.size());
  return lines;
}

Eigen::VectorXcd whole_spectrum(const Eigen::Ref<const Eigen::VectorXcd>& samples) {
  if (samples.size() < 2) return samples;
  thread_local Eigen::FFT<double> transform;
  Eigen::VectorXcd lines(samples.size());
  transform.fwd(lines.data(), samples.data(), samples.size());
  return lines;
}

Eigen::VectorXd samples_of(const Eigen::Ref<const Eigen::VectorXcd>& half_spectrum) {
  if (half_spectrum.size() < 2) return half_spectrum.real();
  Eigen::VectorXd samples(2 * (half_spectrum.size() - 1));
  transform_of_halves().inv(samples.data(), half_spectrum.data(), samples.size());
  return samples;
}

}  // namespace secular
