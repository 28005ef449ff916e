#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// From response channels to the model's coordinates: pinv(mode shapes) (thesis Eq. (5.32)), or one channel for
/// every coordinate, in order.
struct ModalProjection {
  std::vector<std::size_t> channels;  ///< indices into Campaign::channels
  Eigen::MatrixXd matrix;             ///< coordinates x channels
  int derivatives = 0;                ///< how often the channels' quantity is differentiated: 2 for accelerations
  std::string unit;                   ///< of the coordinates
};

/// What turns a line of a displacement at this frequency (rad/s) into that of a quantity which is differentiated so
/// often: (i w)^derivatives.
inline std::complex<double> derived(double frequency, int derivatives) {
  return std::pow(std::complex<double>(0, frequency), derivatives);
}

/// Throws InputError where channels and coordinates do not fit together.
ModalProjection modal_projection(const Campaign& campaign, const CompiledModel& model);

/// Index of the excitation channel of every excitation of the model. Throws InputError if one is missing.
std::vector<std::size_t> excitation_channels(const Campaign& campaign, const CompiledModel& model);

}  // namespace secular
