#include "numerics/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>

namespace secular {

using boost::math::complement;

double chi_squared_upper_tail(double chi_squared, double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0)) return 1;
  if (!std::isfinite(chi_squared)) return 0;
  return boost::math::cdf(complement(boost::math::chi_squared(degrees_of_freedom), std::max(0.0, chi_squared)));
}

double chi_squared_upper_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(complement(boost::math::chi_squared(degrees_of_freedom), probability));
}

double f_upper_tail(double ratio, double numerator, double denominator) {
  if (!std::isfinite(ratio)) return 0;
  if (!(denominator > 0)) return 1;
  if (std::isinf(denominator)) return chi_squared_upper_tail(ratio * numerator, numerator);
  return boost::math::cdf(complement(boost::math::fisher_f(numerator, denominator), std::max(0.0, ratio)));
}

double f_upper_quantile(double probability, double numerator, double denominator) {
  return boost::math::quantile(complement(boost::math::fisher_f(numerator, denominator), probability));
}

double normal_upper_tail(double value) {
  return 0.5 * std::erfc(value / std::sqrt(2.0));
}

double gamma_upper_tail(double value, double shape, double scale) {
  return boost::math::cdf(complement(boost::math::gamma_distribution<>(shape, scale), std::max(0.0, value)));
}

double poisson_upper_tail(std::size_t events, double mean) {
  // The waiting time of that event is below the mean.
  return events == 0 ? 1 : 1 - gamma_upper_tail(mean, static_cast<double>(events), 1);
}

double binomial_upper_tail(double successes, double trials, double probability) {
  if (successes <= 0 || probability >= 1) return 1;
  if (successes > trials) return 0;
  return boost::math::cdf(complement(boost::math::binomial(trials, probability), successes - 1));
}

}  // namespace secular
