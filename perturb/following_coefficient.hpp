#pragma once

#include <map>
#include <string>

namespace secular {

/// A coefficient that follows from the rest position of a model and its natural frequencies, in numbers.
struct FollowingCoefficient {
  std::string name;
  double value = 0;
  std::map<std::string, double> slopes = {};  ///< its derivatives by the numbers that it follows from
};

}  // namespace secular
