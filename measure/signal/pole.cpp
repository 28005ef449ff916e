#include "measure/signal/pole.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

// Samples of a pair by the addition theorem: exact values at every 32nd sample and for the 32 offsets in between,
// so that rounding does not grow along the record. `sign` is -1 for (cos, sin) and +1 for (cosh, sinh).
void fill_pair(double exponent, double first, double step, int sign, Eigen::Ref<MatrixXd> pair) {
  constexpr Index block = 32;
  const auto even = [&](double t) { return sign < 0 ? std::cos(exponent * t) : std::cosh(exponent * t); };
  const auto odd = [&](double t) { return sign < 0 ? std::sin(exponent * t) : std::sinh(exponent * t); };
  Eigen::Array<double, block, 1> even_offset, odd_offset;
  even_offset(0) = 1;
  odd_offset(0) = 0;
  // Offsets by doubling: five exact values, and no more than four sums of angles on the way to any other.
  for (Index size = 1; size < block; size *= 2) {
    const double c = even(static_cast<double>(size) * step), s = odd(static_cast<double>(size) * step);
    for (Index j = 0; j < size; ++j) {
      even_offset(size + j) = c * even_offset(j) + static_cast<double>(sign) * s * odd_offset(j);
      odd_offset(size + j) = s * even_offset(j) + c * odd_offset(j);
    }
  }
  const Index samples = pair.rows();
  for (Index begin = 0; begin < samples; begin += block) {
    const Index count = std::min(block, samples - begin);
    const double t = first + static_cast<double>(begin) * step;
    const double c = even(t), s = odd(t);
    pair.col(0).segment(begin, count) =
        (c * even_offset.head(count) + static_cast<double>(sign) * s * odd_offset.head(count)).matrix();
    pair.col(1).segment(begin, count) = (s * even_offset.head(count) + c * odd_offset.head(count)).matrix();
  }
}

}  // namespace

Index function_count(const Pole& pole) {
  switch (pole.family) {
    case PoleFamily::constant:
      return 1;
    case PoleFamily::product:
      return 4;
    default:
      return 2;
  }
}

Index function_count(std::span<const Pole> poles) {
  Index count = 0;
  for (const Pole& pole : poles) count += function_count(pole);
  return count;
}

Index parameter_count(const Pole& pole) {
  if (pole.imposed || pole.family == PoleFamily::constant) return 0;
  return pole.family == PoleFamily::product ? 2 : 1;
}

Index parameter_count(std::span<const Pole> poles) {
  Index count = 0;
  for (const Pole& pole : poles) count += parameter_count(pole);
  return count;
}

PoleMatrix generator(const Pole& pole, Index parameter) {
  PoleMatrix x(function_count(pole), function_count(pole));
  switch (pole.family) {
    case PoleFamily::constant:
      x.setZero();
      break;
    case PoleFamily::circular:
      x << 0, 1, -1, 0;
      break;
    case PoleFamily::hyperbolic:
    case PoleFamily::nyquist_hyperbolic:
      x << 0, 1, 1, 0;
      break;
    case PoleFamily::product:
      if (parameter == 0)
        x << 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0;
      else
        x << 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0;
      break;
  }
  return x;
}

PoleMatrix shift_matrix(const Pole& pole, double shift) {
  PoleMatrix x = PoleMatrix::Identity(function_count(pole), function_count(pole));
  const double c = std::cos(pole.frequency * shift), s = std::sin(pole.frequency * shift);
  const double ch = std::cosh(pole.rate * shift), sh = std::sinh(pole.rate * shift);
  switch (pole.family) {
    case PoleFamily::constant:
      break;
    case PoleFamily::circular:
      x << c, s, -s, c;
      break;
    case PoleFamily::hyperbolic:
    case PoleFamily::nyquist_hyperbolic:
      x << ch, sh, sh, ch;
      break;
    case PoleFamily::product:
      x << c * ch, s * ch, c * sh, s * sh, -s * ch, c * ch, -s * sh, c * sh, c * sh, s * sh, c * ch, s * ch,
          -s * sh, c * sh, -s * ch, c * ch;
      break;
  }
  return x;
}

MatrixXd pole_functions(std::span<const Pole> poles, Index samples, double sample_rate_hz, double first) {
  MatrixXd functions(samples, function_count(poles));
  const double step = 1 / sample_rate_hz;
  Index column = 0;
  for (const Pole& pole : poles) {
    switch (pole.family) {
      case PoleFamily::constant:
        functions.col(column).setOnes();
        break;
      case PoleFamily::circular:
        fill_pair(pole.frequency, first, step, -1, functions.middleCols(column, 2));
        break;
      case PoleFamily::hyperbolic:
      case PoleFamily::nyquist_hyperbolic:
        fill_pair(pole.rate, first, step, 1, functions.middleCols(column, 2));
        if (pole.family == PoleFamily::nyquist_hyperbolic)
          for (Index l = 1; l < samples; l += 2) functions.row(l).segment(column, 2) *= -1;
        break;
      case PoleFamily::product: {
        MatrixXd circular(samples, 2), hyperbolic(samples, 2);
        fill_pair(pole.frequency, first, step, -1, circular);
        fill_pair(pole.rate, first, step, 1, hyperbolic);
        functions.middleCols(column, 2) = circular.array().colwise() * hyperbolic.col(0).array();
        functions.middleCols(column + 2, 2) = circular.array().colwise() * hyperbolic.col(1).array();
        break;
      }
    }
    column += function_count(pole);
  }
  return functions;
}

}  // namespace secular
