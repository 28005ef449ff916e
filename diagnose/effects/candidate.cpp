#include "diagnose/effects/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// An extra mode has no more than this times the energy of what was measured: beside a larger one the model's own
/// modes would only have to cancel it, which explains anything.
constexpr double largest_extra = 4;

VectorXd one(double value) {
  return VectorXd::Constant(1, value);
}

// Largest value of a channel, either sign: a channel that saturates shows its level there.
double largest_value(const std::vector<Condition>& conditions, const std::vector<Segment>& segments,
                     std::size_t channel, std::size_t responses) {
  const bool response = channel < responses;
  const auto row = static_cast<Index>(response ? channel : channel - responses);
  double largest = 0;
  for (const Condition& c : conditions) {
    const Eigen::MatrixXcd& measured = response ? c.response : c.excitation;
    const std::vector<Index>& lines = response ? c.lines : c.excitation_lines;
    if (row >= measured.rows()) continue;
    Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(1, c.torus->lines());
    for (std::size_t l = 0; l < lines.size(); ++l) all(0, lines[l]) = measured(row, static_cast<Index>(l));
    largest = std::max(largest, c.torus->samples(all).cwiseAbs().maxCoeff());
  }
  for (const Segment& s : segments) {
    const Eigen::MatrixXd& measured = response ? s.response : s.excitation;
    if (row < measured.rows()) largest = std::max(largest, measured.row(row).cwiseAbs().maxCoeff());
  }
  return largest;
}

// The excitation's own line of a dwell, and the energy of all that its channels show.
struct DrivenLine {
  std::complex<double> rate, excitation;
  double response = 0;
};

std::vector<DrivenLine> driven_lines(const std::vector<Condition>& conditions) {
  std::vector<DrivenLine> lines;
  for (const Condition& c : conditions) {
    if (c.fundamental == 0 || c.excitation.rows() == 0) continue;
    const auto excitation = std::find(c.excitation_lines.begin(), c.excitation_lines.end(), c.fundamental);
    if (excitation == c.excitation_lines.end()) continue;
    DrivenLine line{c.line_rate(c.fundamental), c.excitation(0, excitation - c.excitation_lines.begin()), 0};
    for (std::size_t l = 0; l < c.lines.size(); ++l)
      if (c.lines[l] != 0) line.response += c.response.col(static_cast<Index>(l)).squaredNorm();
    lines.push_back(line);
  }
  return lines;
}

std::vector<VectorXd> extra_mode_starts(const std::vector<Condition>& conditions) {
  double low = INFINITY, high = 0;
  for (const Condition& c : conditions) {
    if (c.fundamental == 0) continue;
    const double w = c.line_rate(c.fundamental).imag();
    low = std::min(low, w);
    high = std::max(high, w);
  }
  std::vector<VectorXd> starts;
  if (!(high > 0)) return starts;
  // A few places inside and around the range that was excited.
  const double width = std::max(high - low, 0.02 * high);
  for (const double w : {low - 4 * width, low - width, low - 0.2 * width, low + 0.2 * width, 0.5 * (low + high),
                         high - 0.2 * width, high + 0.2 * width, high + width, high + 4 * width})
    if (w > 0) starts.push_back(Eigen::Vector2d(w, 0.01));
  return starts;
}

const std::map<std::string, GapComponent>& effect_components() {
  static const std::map<std::string, GapComponent> components = {
      {"viscous_damping", GapComponent::dissipative},
      {"quadratic_damping", GapComponent::dissipative},
      {"cubic_damping", GapComponent::dissipative},
      {"coulomb_friction", GapComponent::dissipative},
      {"amplitude_dependent_damping", GapComponent::dissipative},
      {"hysteresis", GapComponent::dissipative},
      {"quadratic_stiffness", GapComponent::conservative},
      {"cubic_stiffness", GapComponent::conservative},
      {"quintic_stiffness", GapComponent::conservative},
      {"bilinear_stiffness", GapComponent::conservative},
      {"freeplay", GapComponent::conservative},
      {"quadratic_inertia", GapComponent::conservative},
      {"cubic_inertia", GapComponent::conservative},
      {"natural_frequency_drift", GapComponent::conservative},
      {"direct_excitation", GapComponent::direct_excitation},
      {"shaker_harmonics", GapComponent::direct_excitation},
      {"extra_mode", GapComponent::direct_excitation},
      {"parametric_excitation", GapComponent::parametric_excitation},
      {"damping_coupling", GapComponent::coupling},
      {"quadratic_coupling", GapComponent::coupling},
      {"cubic_coupling", GapComponent::coupling},
      {"parametric_coupling", GapComponent::coupling},
      {"sensor_gain", GapComponent::measurement},
      {"sensor_offset", GapComponent::measurement},
      {"sensor_cross_axis", GapComponent::measurement},
      {"channel_skew", GapComponent::measurement},
      {"clipping", GapComponent::measurement},
      {"mode_shape_error", GapComponent::measurement},
  };
  return components;
}

const std::map<std::string, GapComponent>& open_law_components() {
  static const std::map<std::string, GapComponent> components = {
      {"open_damping", GapComponent::dissipative},
      {"open_loss", GapComponent::dissipative},
      {"open_one_sided_damping", GapComponent::dissipative},
      {"open_stiffness", GapComponent::conservative},
  };
  return components;
}

}  // namespace

VectorXd largest_displacements(const std::vector<Condition>& conditions, const std::vector<Segment>& segments,
                               const SensorModel& sensors, const std::vector<double>& natural_frequency) {
  VectorXd largest = VectorXd::Zero(sensors.shapes.cols());
  for (const Condition& c : conditions)
    for (const MasterLine& m : c.masters) {
      const auto mode = static_cast<Index>(m.mode);
      const Eigen::VectorXd shape = sensors.shapes.col(mode);
      const auto column = static_cast<Index>(std::find(c.lines.begin(), c.lines.end(), m.line) - c.lines.begin());
      const double modal = std::abs((shape.transpose().cast<std::complex<double>>() * c.response.col(column))(0)) /
                           shape.squaredNorm() / std::pow(std::abs(c.line_rate(m.line)), sensors.derivatives);
      largest(mode) = std::max(largest(mode), 2 * modal);
    }
  for (const Segment& s : segments)
    for (Index k = 0; k < largest.size(); ++k) {
      const double frequency = natural_frequency[static_cast<std::size_t>(k)];
      const double peak = (sensors.filter.row(k) * s.response).cwiseAbs().maxCoeff();
      largest(k) = std::max(largest(k), peak / std::pow(frequency, sensors.derivatives));
    }
  return largest;
}

GapComponent component_of(const std::string& effect) {
  const auto open = open_law_components().find(effect);
  return open != open_law_components().end() ? open->second : effect_components().at(effect);
}

std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  for (const auto& [name, component] : effect_components()) names.push_back(name);
  return names;
}

std::vector<Candidate> candidates_of(const std::vector<EquationEffect>& effects, const CompiledModel& model,
                                     const SensorModel& sensors, const FaultTable& faults,
                                     const std::vector<Condition>& conditions, const std::vector<Segment>& segments,
                                     const VectorXd& largest) {
  std::vector<Candidate> all;
  const std::size_t first_fault = model.symbols.size();
  for (const EquationEffect& e : effects) {
    Candidate c;
    c.effect = e.effect;
    c.subject = e.subject;
    c.component = component_of(e.effect);
    c.mode = e.mode;
    c.equation = true;
    c.passive = e.effect == "coulomb_friction" || e.effect == "hysteresis" || e.effect == "freeplay" ||
                e.effect == "quadratic_damping";
    c.strengths = {e.strength};
    c.shapes = e.shapes;
    c.open_law = e.open_law;
    if (e.shapes.empty())
      c.shape_starts = {VectorXd()};
    else if (c.open_law)
      for (const double exponent : {0.5, 2.0, 3.0, 4.5, 7.0, 10.0}) c.shape_starts.push_back(one(exponent));
    else
      for (const double share : {0.02, 0.06, 0.15, 0.3, 0.5, 0.75, 0.95})
        c.shape_starts.push_back(one(share * largest(static_cast<Index>(e.mode))));
    all.push_back(std::move(c));
  }
  const std::size_t responses = sensors.responses.size(), channels = responses + sensors.excitations.size();
  const auto fault = [&](const char* effect, const std::string& subject, std::size_t place) {
    Candidate c;
    c.effect = effect;
    c.subject = subject;
    c.component = component_of(effect);
    c.strengths = {first_fault + place};
    c.shape_starts = {VectorXd()};
    return c;
  };
  for (std::size_t i = 0; i < channels; ++i) {
    const std::string& name = i < responses ? sensors.response_names[i] : sensors.excitation_names[i - responses];
    // Free motion seen by one channel: its gain is the unit of the motion.
    if (channels > 1) all.push_back(fault("sensor_gain", name, faults.gain(i)));
    all.push_back(fault("sensor_offset", name, faults.offset(i)));
    all.push_back(fault("channel_skew", name, faults.delay(i)));
    if (i < responses && !sensors.excitations.empty())
      all.push_back(fault("sensor_cross_axis", name, faults.cross(i)));
    const double peak = largest_value(conditions, segments, i, responses);
    for (const double share : {0.997, 0.97, 0.9, 0.75, 0.6, 0.45}) {
      if (!(peak > 0)) break;
      Candidate clipping = fault("clipping", name, faults.inverse_level(i));
      clipping.least_strength = 1 / (share * peak);
      clipping.passive = true;  // a level below nothing cuts nothing
      all.push_back(std::move(clipping));
    }
  }
  if (model.modes() > 1 && responses > 1) {
    Candidate mixing = fault("mode_shape_error", "modal basis", 0);
    mixing.strengths.clear();
    for (std::size_t i = 0; i < model.modes(); ++i)
      for (std::size_t k = 0; k < model.modes(); ++k)
        if (i != k) mixing.strengths.push_back(first_fault + faults.mixing(i, k));
    all.push_back(std::move(mixing));
  }
  for (std::size_t k = 0; k < model.modes(); ++k) {
    Candidate drift = fault("natural_frequency_drift", std::string(model.coordinates[k]), faults.drift(k));
    drift.mode = k;
    drift.equation = true;
    all.push_back(std::move(drift));
  }
  if (!sensors.excitations.empty()) {
    Candidate harmonics = fault("shaker_harmonics", sensors.excitation_names[0], 0);
    harmonics.strengths.clear();
    for (std::size_t part = 0; part < 4; ++part)
      harmonics.strengths.push_back(first_fault + faults.shaker_harmonic(part));
    all.push_back(std::move(harmonics));
    const std::vector<VectorXd> starts = extra_mode_starts(conditions);
    if (!starts.empty()) {
      Candidate extra = fault("extra_mode", "beyond the model", 0);
      extra.strengths.clear();
      for (std::size_t c = 0; c < responses; ++c)
        extra.strengths.push_back(first_fault + faults.extra_amplitude(c));
      extra.shapes = {first_fault + faults.extra_frequency(), first_fault + faults.extra_damping()};
      extra.shape_starts = starts;
      extra.plausible = [lines = driven_lines(conditions), first_fault, faults, responses,
                         derivatives = sensors.derivatives](const VectorXd& unknowns) {
        const Faults set = faults.faults(unknowns.data() + first_fault);
        double measured = 0, beyond = 0;
        for (const DrivenLine& line : lines) {
          measured += line.response;
          for (std::size_t c = 0; c < responses; ++c)
            beyond += std::norm(set.extra.response(c, line.rate, derivatives, line.excitation));
        }
        return beyond <= largest_extra * measured;
      };
      all.push_back(std::move(extra));
    }
  }
  return all;
}

}  // namespace secular
