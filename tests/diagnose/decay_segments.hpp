#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "diagnose/evidence/segment.hpp"
#include "motion/integrate/motion_integrator.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular::testing_support {

// A free decay of one mode, measured without other error than noise of 1e-4 of its start.
inline std::vector<Segment> decay(const Laboratory& lab, const Eigen::VectorXd& unknowns, std::uint64_t seed) {
  constexpr Eigen::Index samples = 64;
  constexpr int count = 6;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Segment> segments;
  MotionStart start{{unknowns.data(), unknowns.data() + lab.compiled.symbols.size()},
                    Eigen::Vector2d(1e-3, 0),
                    std::make_shared<const DrivingSignal>(DrivingSignal{{}, 2e-3 * 80 / natural}),
                    samples + 1,
                    4};
  for (int i = 0; i < count; ++i) {
    Segment s;
    s.fold = i;
    s.sample_s = start.signal->sample_s;
    s.time_s = s.in_record_s = i * samples * s.sample_s;
    const StretchOfMotion motion = MotionIntegrator(lab.compiled, {}).motion(start);
    s.response = motion.acceleration.leftCols(samples);
    s.noise_sd = Eigen::VectorXd::Constant(1, 1e-4 * 1e-3 * natural * natural);
    for (double& reading : s.response.row(0)) reading += s.noise_sd(0) * normal(random);
    s.substeps = 4;
    start.state << motion.displacement(0, samples), motion.velocity(0, samples);
    segments.push_back(std::move(s));
  }
  return segments;
}

}  // namespace secular::testing_support
