#include "perturb/nonsmooth.hpp"

namespace secular {

Field nonsmooth_harmonics(const Factor& factor, const FieldLayout& layout, const GiNaC::ex& natural_frequency,
                          int highest) {
  const auto mode = static_cast<std::size_t>(factor.index);
  const bool absolute = factor.kind == Factor::Kind::absolute;
  // x = 2 |A| cos(theta) or, for the velocity, 2 w |A| cos(theta + pi/2): harmonic n turns by i^n.
  const GiNaC::ex scale = absolute ? (factor.derivative == 1 ? GiNaC::ex(2 * natural_frequency) : GiNaC::ex(2)) : 1;
  Field field;
  for (int n = absolute ? 0 : 1; n <= highest; n += 2) {
    GiNaC::ex half_amplitude;  // of exp(i n theta), for the cosine
    if (absolute) {
      const int m = n / 2;
      half_amplitude = m == 0 ? GiNaC::ex(2) / GiNaC::Pi
                              : GiNaC::ex(GiNaC::numeric(m % 2 == 1 ? 2 : -2, 4 * m * m - 1)) / GiNaC::Pi;
    } else {
      const int m = (n - 1) / 2;
      half_amplitude = GiNaC::ex(GiNaC::numeric(m % 2 == 0 ? 2 : -2, n)) / GiNaC::Pi;
    }
    for (const int sign : {1, -1}) {
      if (n == 0 && sign < 0) continue;
      FieldKey key(layout.size(), 0);
      key[mode] = sign * n;
      key[sign > 0 ? layout.amplitude(mode) : layout.conjugate(mode)] = n;
      key[layout.modulus(mode)] = absolute ? 1 - n : -n;
      const GiNaC::ex turn = factor.derivative == 1 ? GiNaC::pow(GiNaC::I, sign * n) : GiNaC::ex(1);
      field.add(key, (scale * half_amplitude * turn).expand());
    }
  }
  return field;
}

}  // namespace secular
