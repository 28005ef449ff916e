#pragma once

#include <complex>

#include "measure/data/campaign.hpp"

namespace secular {

/// Which derivative of the displacement an impulse response is: displacement, velocity, acceleration over force.
enum class ResponseForm { receptance = 0, mobility = 1, accelerance = 2 };

/// The form of a channel's response to a force. Throws std::invalid_argument for a quantity that is no motion;
/// angle and strain count as displacements.
ResponseForm response_form(Quantity quantity);

/// Table B.1: the residue of the same mode in another form, residue * pole^(to - from); pole in rad/s.
std::complex<double> convert_residue(std::complex<double> residue, std::complex<double> pole, ResponseForm from,
                                     ResponseForm to);

}  // namespace secular
