#include "measure/data/chance_of_repeat.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

double chance_of_repeat(double gap, double scatter, double slope) {
  if (!std::isfinite(gap)) return 1;
  const double s = std::hypot(scatter, gap), y = slope - gap;
  double density = 1 / s;
  if (y > 0) density = std::min(density, 16.0 / 9 * s * s / (y * y * y));
  return std::min(1.0, gap * density);
}

}  // namespace secular
