#pragma once

namespace secular {

/// The excitation signal at one instant: value, first and second time derivative.
struct ExcitationSample {
  double value = 0, first_derivative = 0, second_derivative = 0;
};

}  // namespace secular
