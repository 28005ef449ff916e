#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace secular {

/// Where a structure's points are, the lines between them and what its channels measure there. For drawings: no
/// number of an analysis depends on it.
struct Geometry {
  struct Point {
    std::string name;
    std::array<double, 3> at{};  ///< in one unit of length, whichever
  };
  struct Sensor {
    std::string channel;  ///< a response of the campaign
    std::size_t point = 0;
    std::array<double, 3> direction{};  ///< of positive samples; a unit vector
  };
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> lines;  ///< points along each, two or more
  std::vector<Sensor> sensors;                  ///< in order of the channels, each at most once
};

}  // namespace secular
