#include "thesis/verify/demodulation.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>

namespace secular::verify {
namespace {

// One of every pair n, -n with |n| up to `highest`, zero first.
std::vector<std::vector<int>> half_lattice(std::size_t dimensions, int highest) {
  std::vector<std::vector<int>> result;
  std::vector<int> n(dimensions, -highest);
  while (true) {
    int size = 0, first = 0;
    for (const int x : n) {
      size += std::abs(x);
      if (first == 0) first = x;
    }
    if (size <= highest && first >= 0) result.push_back(n);
    std::size_t at = 0;
    while (at < dimensions && n[at] == highest) n[at++] = -highest;
    if (at == dimensions) break;
    ++n[at];
  }
  return result;
}

}  // namespace

Demodulation demodulated(const std::vector<double>& record, double step, const std::vector<double>& frequencies,
                         int highest, int degree) {
  const std::vector<std::vector<int>> lattice = half_lattice(frequencies.size(), highest);
  const auto rows = static_cast<Eigen::Index>(record.size());
  const double half = 0.5 * step * static_cast<double>(record.size() - 1);
  const Eigen::Index powers = degree + 1;
  Eigen::MatrixXd design(rows, static_cast<Eigen::Index>(2 * lattice.size()) * powers);
  Eigen::Index columns = 0;
  struct Place {
    std::vector<int> n;
    Eigen::Index cosine, sine;
  };
  std::vector<Place> places;
  for (const std::vector<int>& n : lattice) {
    double omega = 0;
    for (std::size_t k = 0; k < frequencies.size(); ++k) omega += n[k] * frequencies[k];
    const bool constant = omega == 0;
    places.push_back({n, columns, constant ? -1 : columns + powers});
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double t = step * static_cast<double>(i), x = (t - half) / half;
      double before = 1, chebyshev = x;
      for (Eigen::Index p = 0; p < powers; ++p) {
        const double basis = p == 0 ? 1 : chebyshev;
        design(i, columns + p) = basis * std::cos(omega * t);
        if (!constant) design(i, columns + powers + p) = -basis * std::sin(omega * t);
        if (p > 0) {
          const double next = 2 * x * chebyshev - before;
          before = chebyshev;
          chebyshev = next;
        }
      }
    }
    columns += constant ? powers : 2 * powers;
  }
  const Eigen::MatrixXd used = design.leftCols(columns);
  const Eigen::Map<const Eigen::VectorXd> samples(record.data(), rows);
  const Eigen::VectorXd solution = used.householderQr().solve(samples);
  Demodulation result;
  result.time = half;
  const Eigen::VectorXd misfit = used * solution - samples;
  result.residual = misfit.cwiseAbs().maxCoeff();
  // T_p(0) = 0, +-1 and T_p'(0) = +-p for odd p.
  const auto at_middle = [&](Eigen::Index from, bool slope) {
    double sum = 0;
    for (Eigen::Index p = 0; p < powers; ++p) {
      const double sign = (p / 2) % 2 == 0 ? 1 : -1;
      if (!slope && p % 2 == 0) sum += sign * solution(from + p);
      if (slope && p % 2 == 1) sum += sign * static_cast<double>(p) * solution(from + p) / half;
    }
    return sum;
  };
  for (const Place& place : places) {
    const bool constant = place.sine < 0;
    // c exp(i w t) + conj = 2 Re(c) cos - 2 Im(c) sin; a constant stands once.
    const auto complex = [&](bool slope) {
      return constant ? std::complex<double>(at_middle(place.cosine, slope))
                      : 0.5 * std::complex<double>(at_middle(place.cosine, slope), at_middle(place.sine, slope));
    };
    result.harmonic[place.n] = complex(false);
    result.rate[place.n] = complex(true);
    if (constant) continue;
    std::vector<int> opposite = place.n;
    for (int& x : opposite) x = -x;
    result.harmonic[opposite] = std::conj(complex(false));
    result.rate[opposite] = std::conj(complex(true));
  }
  return result;
}

}  // namespace secular::verify
