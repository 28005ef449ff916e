#pragma once

namespace secular {

struct Interval {
  double low = 0, high = 0;
};

/// value -/+ sd times the quantile of Student's t; infinite degrees of freedom give the normal distribution.
Interval confidence_interval(double value, double sd, double degrees_of_freedom, double level = 0.95);

/// Probability of a |t| at least this large where the true value is zero.
double two_sided_p_value(double t, double degrees_of_freedom);

}  // namespace secular
