#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>

#include "diagnose/evidence/segment.hpp"
#include "motion/integrate/motion_integrator.hpp"
#include "tests/diagnose/laboratory.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular::testing_support {

/// Samples, and by time what drives them.
struct Drive {
  Eigen::Index samples = 0;
  double spacing_s = 0;
  std::function<double(double)> base;
};

/// A stretch of a record that is driven, from this state on; the base is read without noise.
inline Segment driven_segment(const Laboratory& lab, const Eigen::VectorXd& unknowns, const Drive& drive,
                              const Eigen::VectorXd& state, double response_noise, Gaussian& gaussian) {
  Segment s;
  s.sample_s = drive.spacing_s;
  s.substeps = 4;
  s.excitation.resize(1, 2 * drive.samples - 1);
  for (Eigen::Index i = 0; i < s.excitation.cols(); ++i)
    s.excitation(0, i) = drive.base(0.5 * drive.spacing_s * static_cast<double>(i));
  const MotionStart start{{unknowns.data(), unknowns.data() + lab.compiled.symbols.size()},
                          state,
                          std::make_shared<const DrivingSignal>(DrivingSignal{s.excitation, drive.spacing_s}),
                          drive.samples,
                          s.substeps};
  s.response = MotionIntegrator(lab.compiled, {}).motion(start).acceleration +
               response_noise * gaussian.vector(drive.samples).transpose();
  s.noise_sd = Eigen::VectorXd::Constant(1, response_noise);
  s.excitation_noise_sd = Eigen::VectorXd::Zero(1);
  return s;
}

}  // namespace secular::testing_support
