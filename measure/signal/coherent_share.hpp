#pragma once

#include <Eigen/Core>
#include <optional>

namespace secular {

/// What any linear filter can make of a response, as far as windows of a record tell it.
struct CoherentShare {
  double share = 0;         ///< of the response's variance, between 0 and 1
  Eigen::Index window = 0;  ///< samples: filters that remember longer are not seen
};

/// The response's spectrum times its coherence with the excitation, over the response's variance: averages (P. D.
/// Welch, IEEE Transactions on Audio and Electroacoustics 15, 1967) over 64 Hann windows of an eighth of the
/// record, their means removed. Windows begin anywhere, since tones of different frequencies would seem coherent in
/// windows that begin whole periods apart. What chance makes coherent in so few windows is taken off: the mean
/// square correlation of two of them. Where the structure rings on for more than a tenth of a window, the share is too low.
/// Nothing for fewer than 512 samples and for a signal without variance. Throws
/// std::invalid_argument for signals of different lengths.
std::optional<CoherentShare> coherent_share(const Eigen::Ref<const Eigen::VectorXd>& excitation,
                                            const Eigen::Ref<const Eigen::VectorXd>& response);

}  // namespace secular
