#pragma once

#include <stdexcept>
#include <string>

namespace secular {

/// How a computation ended that came to no result.
enum class Ending {
  stalled,      ///< no further progress
  ran_away,     ///< numbers beyond bounds
  out_of_range  ///< where it was asked there is no result
};

/// A computation that ran and came to no result. No fault of the program's, and none that a better input is sure to
/// mend: who knows another way catches it; otherwise it ends the program with status 1. The one exception is a
/// virtual test whose motions run away: they do what its experiment file says, and that is bad input (InputError,
/// status 2).
class NumericalFailure : public std::runtime_error {
 public:
  NumericalFailure(Ending ending, const std::string& message) : std::runtime_error(message), ending_(ending) {}

  Ending ending() const { return ending_; }

 private:
  Ending ending_;
};

}  // namespace secular
