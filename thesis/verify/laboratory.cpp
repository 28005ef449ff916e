#include "thesis/verify/laboratory.hpp"

#include <cmath>
#include <complex>

#include "perturb/prime_field.hpp"
#include "thesis/verify/full_equations.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;
using Complex = std::complex<double>;

ex exact(Complex z) {
  return z.real() + GiNaC::I * z.imag();
}

// A number between 0.5 and 1.5 that belongs to a name.
double ordinary(const std::string& name) {
  return 0.5 + random_value(name, 31).fraction();
}

std::map<std::string, double> parameter_values(const Derivation& derivation, double eps,
                                               const std::set<std::string>& without) {
  const Model& model = *derivation.model;
  const std::map<std::string, int>& order = derivation.resonance->order;
  std::map<std::string, double> values;
  // Powers of the golden section keep combinations of two frequencies apart from one another.
  for (std::size_t k = 0; k < model.modes.size(); ++k)
    values[model.modes[k].frequency] = std::pow(1.618033988749895, 2.0 * static_cast<double>(k));
  for (const std::string& name : model.parameters) {
    const auto entry = order.find(name);
    const double sign = random_value(name, 32).fraction() < 0.5 && name.rfind("mu", 0) != 0 ? -1 : 1;
    values[name] =
        without.count(name) ? 0 : sign * ordinary(name) * std::pow(eps, entry == order.end() ? 0 : entry->second);
  }
  for (const Excitation& excitation : model.excitations)
    values[excitation.amplitude] = ordinary(excitation.amplitude);
  for (const ResonanceRelation& relation : derivation.resonance->relations)
    values[relation.detuning] = ordinary(relation.detuning) * std::pow(eps, relation.order);
  GiNaC::exmap natural;
  for (const Mode& mode : model.modes) natural[model.symbols.at(mode.frequency)] = values[mode.frequency];
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    const ex resonant = derivation.lattice.resonant_frequency(j).subs(natural).evalf();
    double omega = GiNaC::ex_to<GiNaC::numeric>(resonant).to_double();
    for (std::size_t r = 0; r < derivation.resonance->relations.size(); ++r)
      omega += derivation.lattice.resonant_offset(j)[r].to_double() *
               values[derivation.resonance->relations[r].detuning];
    values[model.excitations[j].frequency] = omega;
  }
  return values;
}

}  // namespace

const Measurement& Laboratory::measure(double eps, const std::set<std::string>& without) {
  const auto [entry, fresh] = done_.try_emplace({eps, without});
  Measurement& m = entry->second;
  if (!fresh) return m;
  const Model& model = *derivation_.model;
  const std::size_t modes = model.modes.size();
  std::map<std::string, double> values = parameter_values(derivation_, eps, without);
  std::vector<double> frequencies, start, rest(modes, 0.0);
  for (std::size_t k = 0; k < modes; ++k) {
    frequencies.push_back(values[model.modes[k].frequency]);
    start.push_back(0.9 - 0.2 * static_cast<double>(k));
  }
  const double step = modes == 1 ? 0.1 : 0.12;
  const std::size_t samples = modes == 1 ? 900 : 1400;
  const auto record = integrated(FullEquations(model, values), start, rest, step, samples);
  for (const std::vector<double>& one : record)
    m.mode.push_back(demodulated(one, step, frequencies, modes == 1 ? 6 : 4, 5));
  for (const auto& [name, value] : values) m.values[model.symbols.at(name)] = value;
  m.values[formula_.symbol("eps")] = 1;
  ex gamma_rate = 0;
  for (std::size_t r = 0; r < derivation_.resonance->relations.size(); ++r) {
    const double sigma = values[derivation_.resonance->relations[r].detuning];
    m.values[formula_.slow_wave(r)] = exact(std::polar(1.0, sigma * m.mode[0].time));
    gamma_rate += formula_.gamma_slow()[r] * sigma;
  }
  for (std::size_t k = 0; k < modes; ++k) {
    std::vector<int> own(modes, 0);
    own[k] = 1;
    const Complex a = m.mode[k].harmonic.at(own), rate = m.mode[k].rate.at(own);
    m.values[formula_.amplitude(k)] = exact(a);
    m.values[formula_.conjugate_amplitude(k)] = exact(std::conj(a));
    m.values[formula_.modulus(k)] = std::abs(a);
    m.values[formula_.phase_factor(k)] = exact(a / std::abs(a));
    m.values[formula_.polar_amplitude(k)] = 2 * std::abs(a);
    m.values[formula_.amplitude_rate(k)] = 2 * (rate * std::conj(a)).real() / std::abs(a);
    m.values[formula_.phase_rate(k)] = (rate / a).imag();
    gamma_rate += formula_.gamma_phases()[k] * (rate / a).imag();
    // The last order's derivative stands for the whole measured rate: lower ones are zero in these cases.
    for (int n = 1; n <= derivation_.resonance->expand_to; ++n) {
      const bool last = n == derivation_.resonance->expand_to;
      m.values[formula_.slow_derivative(k, n)] = last ? exact(rate) : ex(0);
      m.values[formula_.slow_derivative_conjugate(k, n)] = last ? exact(std::conj(rate)) : ex(0);
    }
  }
  m.values[formula_.symbol("dgamma")] = gamma_rate;
  m.values[formula_.symbol("ghat")] = 0;  // the quadratic damping is zero here
  return m;
}

}  // namespace secular::verify
