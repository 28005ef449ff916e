#pragma once

#include "tests/runtime/compare_models.hpp"

namespace secular::test {

/// A model's accelerations of several motions at once are those of each, to the last bit; parameters of some
/// motions may be zero where those of others are not.
inline void expect_lanes_of_each(const CompiledModel& model, const std::vector<Point>& points) {
  ASSERT_TRUE(static_cast<bool>(model.acceleration_of_lanes)) << model.name;
  ASSERT_EQ(points.size(), Lanes::count);
  std::vector<LaneParameter> parameters(model.symbols.size());
  std::vector<LaneSample> excitation(model.excitations.size());
  std::vector<Lanes> displacement(model.modes()), velocity(model.modes()), acceleration(model.modes());
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    const Point& p = points[lane];
    for (std::size_t s = 0; s < parameters.size(); ++s) {
      parameters[s].set(lane, p.parameters[s]);
      parameters[s].is_nonzero = parameters[s].is_nonzero || p.parameters[s] != 0;
    }
    for (std::size_t j = 0; j < excitation.size(); ++j) {
      excitation[j].value.set(lane, p.excitation[j].value);
      excitation[j].first_derivative.set(lane, p.excitation[j].first_derivative);
      excitation[j].second_derivative.set(lane, p.excitation[j].second_derivative);
    }
    for (std::size_t k = 0; k < model.modes(); ++k) {
      displacement[k].set(lane, p.displacement[k]);
      velocity[k].set(lane, p.velocity[k]);
    }
  }
  model.acceleration_of_lanes(parameters.data(), excitation.data(), displacement.data(), velocity.data(),
                              acceleration.data());
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    const Point& p = points[lane];
    std::vector<double> alone(model.modes());
    model.acceleration(p.parameters.data(), p.excitation.data(), p.displacement.data(), p.velocity.data(),
                       alone.data());
    for (std::size_t k = 0; k < model.modes(); ++k)
      EXPECT_EQ(acceleration[k][lane], alone[k]) << model.name << " motion " << lane << " mode " << k;
  }
}

inline std::vector<Point> points_of_lanes(const CompiledModel& model, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> points;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) points.push_back(random_point(model, random));
  return points;
}

}  // namespace secular::test
