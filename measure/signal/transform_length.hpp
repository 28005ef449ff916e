#pragma once

#include <Eigen/Core>

namespace secular {

/// Lengths that a fast Fourier transform is fast at: products of 2, 3 and 5. A length with a large prime factor p
/// costs p times as much per sample (a record of 60 s and one sample at 1024 Hz: hundreds of times). The shortest
/// such length that is not below `samples`, for padding; 1 for none.
Eigen::Index padded_transform_length(Eigen::Index samples);
/// The longest even such length that is not above `samples`, for cutting; 0 for fewer than two.
Eigen::Index cut_transform_length(Eigen::Index samples);

}  // namespace secular
