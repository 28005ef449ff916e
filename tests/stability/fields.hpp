#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <initializer_list>

#include "motion/response/equilibrium.hpp"
#include "motion/response/vector_field.hpp"

// Vector fields with solutions known by hand.
namespace secular::testing_support {

using ConstVector = Eigen::Ref<const Eigen::VectorXd>;
using OutVector = Eigen::Ref<Eigen::VectorXd>;

inline Eigen::VectorXd vector(std::initializer_list<double> values) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) v(i++) = value;
  return v;
}

/// x' = p x - x^3
inline VectorField pitchfork_field() {
  return {1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            rate(0) = p(0) * x(0) - x(0) * x(0) * x(0);
          }};
}

/// x' = p x - x^2
inline VectorField transcritical_field() {
  return {1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            rate(0) = p(0) * x(0) - x(0) * x(0);
          }};
}

/// x' = p - x^2
inline VectorField saddle_node_field() {
  return {
      1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) { rate(0) = p(0) - x(0) * x(0); }};
}

/// x' = q + p x - x^3: saddle-nodes at 4 p^3 = 27 q^2, cusp at 0.
inline VectorField cusp_field() {
  return {1, {"p", "q"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            rate(0) = p(1) + p(0) * x(0) - x(0) * x(0) * x(0);
          }};
}

/// Brusselator x' = A - (B + 1) x + x^2 y, y' = B x - x^2 y: fixed point (A, B/A), Hopf at B = 1 + A^2, frequency
/// A.
inline VectorField brusselator() {
  return {2, {"A", "B"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            const double reaction = x(0) * x(0) * x(1);
            rate(0) = p(0) - (p(1) + 1) * x(0) + reaction;
            rate(1) = p(1) * x(0) - reaction;
          }};
}

/// Primary resonance of a Duffing oscillator, a' = -mu a + f sin g, a g' = sigma a - c a^3 + f cos g (Nayfeh & Mook
/// 1979, section 4.1), with z = a e^(-i g): z' = -(mu + i sigma) z + i c |z|^2 z - i f. Fixed points with s = a^2:
/// s (mu^2 + (sigma - c s)^2) = f^2. The Jacobian is given in closed form.
inline VectorField duffing() {
  using Complex = std::complex<double>;
  enum { mu, sigma, c, f };
  return {2,
          {"mu", "sigma", "c", "f"},
          [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            const Complex z(x(0), x(1)), i(0, 1);
            const Complex dz = -(p(mu) + i * p(sigma)) * z + i * p(c) * std::norm(z) * z - i * p(f);
            rate << dz.real(), dz.imag();
          },
          [](const ConstVector& x, const ConstVector& p, Eigen::Ref<Eigen::MatrixXd> jacobian) {
            const double s = x.squaredNorm(), xy = 2 * p(c) * x(0) * x(1);
            jacobian << -p(mu) - xy, p(sigma) - p(c) * (s + 2 * x(1) * x(1)),
                -p(sigma) + p(c) * (s + 2 * x(0) * x(0)), -p(mu) + xy;
          }};
}

/// Principal parametric resonance with B = z/2:
/// B' = -mu B - i d B + (4 i ae/w) B^2 B* - (i eta F/w) B* - (3/2) w^2 mu3 B^2 B*, d = sigma/2.
/// With z = a e^(i b): -mu - 3/8 w^2 mu3 a^2 = (eta F/w) sin 2b, -d + (ae/w) a^2 = (eta F/w) cos 2b, so fixed
/// points obey (ae a^2 - w sigma/2)^2 + (w mu + 3/8 w^3 mu3 a^2)^2 = eta^2 F^2, and the trivial one loses its
/// stability at (w mu)^2 + (w sigma/2)^2 = (eta F)^2.
struct Parametric {
  double w = 2, mu = 0.15, mu3 = 0.3, ae = 0.9, eta = 1.3;

  double kappa() const { return 3.0 / 8 * w * w * w * mu3; }
  double threshold(double sigma) const { return std::hypot(w * mu, w * sigma / 2) / std::abs(eta); }
  /// d F / d a^2 = 0 at ae (ae s - w sigma/2) + kappa (w mu + kappa s) = 0; negative: no saddle-node.
  double fold_square(double sigma) const {
    return (ae * w * sigma / 2 - kappa() * w * mu) / (ae * ae + kappa() * kappa());
  }
  double forcing(double square, double sigma) const {
    return std::hypot(ae * square - w * sigma / 2, w * mu + kappa() * square) / std::abs(eta);
  }

  /// Parameters sigma, F.
  VectorField field() const {
    const Parametric m = *this;
    return {2, {"sigma", "F"}, [m](const ConstVector& x, const ConstVector& p, OutVector rate) {
              using Complex = std::complex<double>;
              const Complex i(0, 1), b(x(0) / 2, x(1) / 2);
              const Complex cubic = b * b * std::conj(b);
              const Complex db = -m.mu * b - i * (p(0) / 2) * b + 4.0 * i * m.ae / m.w * cubic -
                                 i * m.eta * p(1) / m.w * std::conj(b) - 1.5 * m.w * m.w * m.mu3 * cubic;
              rate << 2 * db.real(), 2 * db.imag();
            }};
  }
};

/// Additive combination resonance Omega = w1 + w2 + sigma, linear part, parameters sigma and F:
/// z1' = -(mu1 + i sigma/2) z1 - i F z2*, z2' = -(mu2 + i sigma/2) z2 - i F z1*.
/// With exp(i nu t) for (z1, z2*): (mu1 + i (nu + sigma/2)) (mu2 + i (nu - sigma/2)) = F^2, so the trivial solution
/// loses its stability at F^2 = mu1 mu2 (1 + sigma^2/(mu1 + mu2)^2) with the frequency
/// nu = sigma/2 (mu1 - mu2)/(mu1 + mu2). The phase of z1 z2* is free: a cubic term would give circles of solutions.
struct Combination {
  double mu1 = 0.1, mu2 = 0.3, cubic = 0;

  double threshold(double sigma) const {
    const double ratio = sigma / (mu1 + mu2);
    return std::sqrt(mu1 * mu2 * (1 + ratio * ratio));
  }
  double frequency(double sigma) const { return std::abs(sigma / 2 * (mu1 - mu2) / (mu1 + mu2)); }

  VectorField field() const {
    const Combination m = *this;
    return {4, {"sigma", "F"}, [m](const ConstVector& x, const ConstVector& p, OutVector rate) {
              using Complex = std::complex<double>;
              const Complex i(0, 1), z1(x(0), x(1)), z2(x(2), x(3));
              const Complex d1 =
                  -(m.mu1 + i * p(0) / 2.0) * z1 - i * p(1) * std::conj(z2) + i * m.cubic * std::norm(z1) * z1;
              const Complex d2 =
                  -(m.mu2 + i * p(0) / 2.0) * z2 - i * p(1) * std::conj(z1) + i * m.cubic * std::norm(z2) * z2;
              rate << d1.real(), d1.imag(), d2.real(), d2.imag();
            }};
  }
};

/// Two modes in 1:1 internal resonance, the first one forced; parameter sigma. Mirrored in the second mode.
inline VectorField coupled_modes() {
  return {4, {"sigma"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            using Complex = std::complex<double>;
            const Complex i(0, 1), z1(x(0), x(1)), z2(x(2), x(3));
            const Complex d1 = -(0.12 + i * p(0)) * z1 - 0.35 * i + 0.8 * i * std::norm(z1) * z1 +
                               i * (0.9 * std::norm(z2) * z1 + 0.5 * z2 * z2 * std::conj(z1));
            const Complex d2 = -(0.1 + i * (p(0) + 0.1)) * z2 + 0.6 * i * std::norm(z2) * z2 +
                               i * (0.9 * std::norm(z1) * z2 + 0.5 * z1 * z1 * std::conj(z2));
            rate << d1.real(), d1.imag(), d2.real(), d2.imag();
          }};
}

/// Bogdanov-Takens normal form x' = y, y' = b1 + b2 x + x^2 - x y: saddle-nodes at 4 b1 = b2^2, Hopf points at
/// b1 = 0, b2 < 0 with frequency sqrt(-b2) (Kuznetsov, section 8.4, with s = -1).
inline VectorField bogdanov_takens() {
  return {2, {"b1", "b2"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
            rate(0) = x(1);
            rate(1) = p(0) + p(1) * x(0) + x(0) * x(0) - x(0) * x(1);
          }};
}

}  // namespace secular::testing_support
