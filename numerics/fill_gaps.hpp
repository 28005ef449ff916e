#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace secular {

/// Samples in a row that are filled at most: what an autoregression of twice as many coefficients still carries
/// over from both sides.
inline constexpr std::size_t longest_filled = 16;

/// Replaces samples by those that an autoregressive model of what surrounds them makes likeliest (A. Janssen,
/// R. Veldhuis and L. Vries, IEEE Transactions on Acoustics, Speech and Signal Processing 34, 1986): coefficients
/// by least squares over samples about the gap that no gap has a part in, then the missing samples that make the
/// errors of prediction smallest; near the beginning of a record backwards. `missing`: their places, rising.
/// Returns the places that could not be filled, since their gap is too long, too many gaps hang together or too
/// little is left around them; these stay as they are.
std::vector<std::size_t> fill_gaps(std::span<double> samples, const std::vector<std::size_t>& missing);

}  // namespace secular
