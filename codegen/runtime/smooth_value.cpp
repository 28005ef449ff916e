#include "codegen/runtime/smooth_value.hpp"

#include "estimator/model/smooth_functions.hpp"

namespace secular {

double smooth_value(SmoothKind kind, double exponent, double argument) {
  switch (kind) {
    case SmoothKind::sine:
      return sin_of(argument);
    case SmoothKind::cosine:
      return cos_of(argument);
    case SmoothKind::tangent:
      return tan_of(argument);
    case SmoothKind::exponential:
      return exp_of(argument);
    case SmoothKind::hyperbolic_sine:
      return sinh_of(argument);
    case SmoothKind::hyperbolic_cosine:
      return cosh_of(argument);
    case SmoothKind::hyperbolic_tangent:
      return tanh_of(argument);
    case SmoothKind::logarithm:
      return log_of(argument);
    case SmoothKind::arc_tangent:
      return atan_of(argument);
    case SmoothKind::power:
      break;
  }
  return power_of(argument, exponent);
}

}  // namespace secular
