#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observation_set.hpp"

// Small steps shared by the observations of dwells and of decays.
namespace secular {

/// samples x channels from sample `first` on.
Eigen::MatrixXd samples_of(const Record& record, const std::vector<std::size_t>& channels, Eigen::Index first,
                           Eigen::Index count);

/// Samples of the record inside the window.
struct SampleRange {
  Eigen::Index first = 0, count = 0;
};
/// Where rows of it are unusable, the stretch between them that holds most of the motion: the largest sum, over
/// the channels that tell it (Record::moving), of its share in the squares about the mean of usable rows. One
/// stretch, not several: what a stretch tells of a motion's phase and decay needs time without a break.
SampleRange range_of(const Record& record, const Window& window);

/// The same of so many samples from `start_s` on.
SampleRange range_of(double start_s, double sample_rate_hz, std::size_t samples, const Window& window);

/// Why a dwell holds no ensemble of so many samples, in words; empty where it does. Without ensembles the whole
/// record is one, and what unusable rows leave must be most of it. `usable`: samples of range_of(record, window);
/// `fewest`: of an ensemble.
std::string too_short(const Record& record, const Window& window, Eigen::Index usable,
                      std::optional<Eigen::Index> ensemble, Eigen::Index fewest);

/// Complex amplitude of a tone that changes slowly, and what changes it, at one instant.
struct SlowAmplitude {
  std::complex<double> value, slope = 0, curvature = 0;
};

/// A tone of the measured quantity, the displacement's derivative, as displacement: (i*frequency +
/// d/dt)^-derivatives by its series to second order.
SlowAmplitude to_displacement(const SlowAmplitude& measured, double frequency, int derivatives);

/// Modal value of channel amplitudes, and the standard deviation of its real (or imaginary) part.
std::complex<double> project(const ModalProjection& projection, std::size_t mode,
                             const Eigen::RowVectorXcd& amplitudes);
double project_sd(const ModalProjection& projection, std::size_t mode, const Eigen::RowVectorXd& sds);

}  // namespace secular
