#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Standard deviation of what is independent from one value to the next, whatever smooth law is beside it.
double roughness(const std::vector<double>& values);

/// What a quarter of the values stays below.
double lower_quartile(std::vector<double> values);

/// Variance of what is white in a series, channel after channel of `samples` each: anything sampled this densely is
/// smooth. Samples that do not count, `silent`, are zero in all channels, and leave differences that much less.
double white_variance(const Eigen::VectorXd& error, Eigen::Index samples, const std::vector<Eigen::Index>& silent);

/// Standard deviation of what is white in the errors, whatever the channel's noise floor was taken for, from the
/// variances of segments.
double white_level(const std::vector<double>& variances);

}  // namespace secular
