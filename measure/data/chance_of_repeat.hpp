#pragma once

namespace secular {

/// Probability, at most, that a sample equals the one before it: the smallest gap between values there times the
/// density of their difference at zero. Let `scatter` be the sd of that difference about the slope of the signal
/// (per sample): the density is at most 1/scatter, and by Gauss's inequality for laws with one mode
/// 16/9 scatter^2/slope^3.
double chance_of_repeat(double gap, double scatter, double slope);

}  // namespace secular
