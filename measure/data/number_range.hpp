#pragma once

#include <span>
#include <string>

namespace secular {

/// What is wrong with the size of samples, or "" if nothing is. Terms of a model are powers of samples up to the
/// fifth, and their squares are summed: the largest modulus of a channel must lie between 1e-30 and 1e30, so that
/// tenth powers are numbers of double precision (1e-308 to 1e308). Zeros alone are in range, and missing samples
/// (NaN) are passed over.
std::string number_range_fault(std::span<const double> samples);

/// Throws InputError where number_range_fault says something; `place`: "channel tip".
void require_number_range(std::span<const double> samples, const std::string& file, const std::string& place);

}  // namespace secular
