#include "numerics/confidence.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace secular {

Interval confidence_interval(double value, double sd, double degrees_of_freedom, double level) {
  const double tail = 0.5 + 0.5 * level;
  const double quantile = std::isinf(degrees_of_freedom)
                              ? boost::math::quantile(boost::math::normal(), tail)
                              : boost::math::quantile(boost::math::students_t(degrees_of_freedom), tail);
  return {value - quantile * sd, value + quantile * sd};
}

double two_sided_p_value(double t, double degrees_of_freedom) {
  const double size = std::abs(t);
  if (std::isinf(size)) return 0;
  if (std::isinf(degrees_of_freedom))
    return 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), size));
  return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees_of_freedom), size));
}

}  // namespace secular
