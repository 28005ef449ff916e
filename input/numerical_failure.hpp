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
/// mend: who knows another way catches it; otherwise it ends the program with status 1. Input that gives it nothing
/// to work on (a campaign without a record that the model speaks of) is found before, and is an InputError (status
/// 2); so are motions of a virtual test that run away, because they do what its experiment file says.
class NumericalFailure : public std::runtime_error {
 public:
  NumericalFailure(Ending ending, const std::string& message) : std::runtime_error(message), ending_(ending) {}

  Ending ending() const { return ending_; }

 private:
  Ending ending_;
};

}  // namespace secular
