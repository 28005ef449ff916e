#include "motion/simulate/anti_alias_filter.hpp"

#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

// Poles in the upper half plane and their zeros' squared frequencies (0: at infinity), for a cut-off of 1 rad/s.
struct Prototype {
  std::vector<Complex> poles;
  std::vector<double> zero_frequencies;
};

Prototype butterworth(std::size_t order) {
  Prototype prototype;
  for (std::size_t i = 0; i < order / 2; ++i) {
    const double angle = pi * (0.5 + static_cast<double>(2 * i + 1) / static_cast<double>(2 * order));
    prototype.poles.push_back(std::polar(1.0, angle));
    prototype.zero_frequencies.push_back(0);
  }
  return prototype;
}

// Elliptic functions by descending Landen transformations, S. J. Orfanidis, "Lecture notes on elliptic filter
// design", 2006: arguments in units of the quarter period.
std::vector<double> landen(double k) {
  std::vector<double> moduli;
  while (k > 1e-16) {
    const double root = k / (1 + std::sqrt((1 - k) * (1 + k)));
    k = root * root;
    moduli.push_back(k);
  }
  return moduli;
}

Complex ascended(Complex w, double k) {
  const std::vector<double> moduli = landen(k);
  for (std::size_t n = moduli.size(); n-- > 0;) w = (1 + moduli[n]) * w / (1.0 + moduli[n] * w * w);
  return w;
}
Complex cd(Complex u, double k) {
  return ascended(std::cos(u * (pi / 2)), k);
}
double sn(double u, double k) {
  return ascended(std::sin(u * (pi / 2)), k).real();
}

Complex inverse_sn(Complex w, double k) {
  double before = k;
  for (const double modulus : landen(k)) {
    w = 2.0 * w / ((1 + modulus) * (1.0 + std::sqrt(1.0 - w * w * before * before)));
    before = modulus;
  }
  return 2 / pi * std::asin(w);
}

Prototype elliptic(std::size_t order) {
  constexpr double ripple_db = 0.1, attenuation_db = 80;
  const double ep = std::sqrt(std::pow(10, ripple_db / 10) - 1),
               es = std::sqrt(std::pow(10, attenuation_db / 10) - 1);
  const double k1 = ep / es, complement1 = std::sqrt(1 - k1 * k1);
  // Degree equation for the modulus k of the frequency variable.
  double complement = std::pow(complement1, static_cast<double>(order));
  for (std::size_t i = 0; i < order / 2; ++i)
    complement *= std::pow(sn(static_cast<double>(2 * i + 1) / static_cast<double>(order), complement1), 4);
  const double k = std::sqrt(1 - complement * complement);
  const Complex v0 = Complex(0, -1) * inverse_sn(Complex(0, 1 / ep), k1) / static_cast<double>(order);
  Prototype prototype;
  for (std::size_t i = 0; i < order / 2; ++i) {
    const double u = static_cast<double>(2 * i + 1) / static_cast<double>(order);
    const double zero = 1 / (k * cd(u, k).real());
    prototype.poles.push_back(Complex(0, 1) * cd(u - Complex(0, 1) * v0, k));
    prototype.zero_frequencies.push_back(zero * zero);
  }
  return prototype;
}

}  // namespace

FilterCascade::FilterCascade(const AntiAliasFilter& filter, double sample_rate_hz) {
  const Prototype prototype =
      filter.kind == AntiAliasFilter::Kind::butterworth ? butterworth(filter.poles) : elliptic(filter.poles);
  // s = (1 - 1/z)/(1 + 1/z)/tan(pi fc/fs), in units of the cut-off.
  const double c = 1 / std::tan(pi * filter.cut_off_hz / sample_rate_hz);
  for (std::size_t i = 0; i < prototype.poles.size(); ++i) {
    const double d1 = -2 * prototype.poles[i].real(), d0 = std::norm(prototype.poles[i]);
    const double zero = prototype.zero_frequencies[i];
    // (n2 s^2 + d0)/(s^2 + d1 s + d0)
    const double n2 = zero > 0 ? d0 / zero : 0;
    const double lead = c * c + d1 * c + d0;
    Section section;
    section.b0 = section.b2 = (n2 * c * c + d0) / lead;
    section.b1 = 2 * (d0 - n2 * c * c) / lead;
    section.a1 = 2 * (d0 - c * c) / lead;
    section.a2 = (c * c - d1 * c + d0) / lead;
    sections_.push_back(section);
  }
}

FilterCascade FilterCascade::high_pass(double corner_hz, double sample_rate_hz) {
  FilterCascade filter;
  const double c = 1 / std::tan(pi * corner_hz / sample_rate_hz);
  Section section;
  section.b0 = c / (c + 1);
  section.b1 = -section.b0;
  section.a1 = (1 - c) / (1 + c);
  filter.sections_.push_back(section);
  return filter;
}

void FilterCascade::settle(double input) {
  for (Section& s : sections_) {
    const double output = input * (s.b0 + s.b1 + s.b2) / (1 + s.a1 + s.a2);
    s.z2 = s.b2 * input - s.a2 * output;
    s.z1 = s.b1 * input - s.a1 * output + s.z2;
    input = output;
  }
}

double FilterCascade::operator()(double input) {
  for (Section& s : sections_) {
    const double output = s.b0 * input + s.z1;
    s.z1 = s.b1 * input - s.a1 * output + s.z2;
    s.z2 = s.b2 * input - s.a2 * output;
    input = output;
  }
  return input;
}

}  // namespace secular
