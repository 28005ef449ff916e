#include "diagnose/effects/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// An extra mode has no more than this times the energy of what was measured: beside a larger one the model's own
/// modes would only have to cancel it, which explains anything.
constexpr auto& largest_extra = diagnose_thresholds().largest_extra;

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

// Values of one shape parameter to begin with. Those of an exponent and of displacements that a law ends at lie
// closer than two of them can be told apart; a search goes the rest.
std::vector<double> starts_of(const EffectForm::Shape& shape, const LargestMotions& largest, Index mode) {
  using Kind = EffectForm::Shape::Kind;
  const auto times = [](double unit, std::vector<double> shares) {
    for (double& share : shares) share *= unit;
    return shares;
  };
  switch (shape.kind) {
    case Kind::exponent:
      return shape.most > 0 ? times(shape.most / 4, {0.5, 1.5, 2.5, 3.5})
                            : std::vector<double>{0.5, 2.0, 3.0, 4.5, 7.0, 10.0};
    case Kind::level:
      return times(largest.displacement(mode), {0.1, 0.25, 0.6, 1.5});
    case Kind::speed:
      return times(largest.speed(mode), {0.03, 0.1, 0.3, 0.8});
    case Kind::time:
      return times(1 / largest.frequency(mode), {0.1, 0.3, 1, 3, 10});
    case Kind::share:
      return {1.0};
    case Kind::displacement:
    case Kind::gap:
      break;
  }
  return times(largest.displacement(mode), {0.02, 0.06, 0.15, 0.3, 0.5, 0.75, 0.95});
}

// Values of all shape parameters to begin with: every one with every other.
std::vector<VectorXd> shape_starts(const EffectForm& form, std::size_t shapes, const LargestMotions& largest,
                                   Index mode) {
  std::vector<VectorXd> starts = {VectorXd()};
  for (std::size_t s = 0; s < shapes; ++s) {
    std::vector<VectorXd> longer;
    for (const VectorXd& start : starts)
      for (const double value : starts_of(form.shape(s), largest, mode)) {
        longer.emplace_back(start.size() + 1);
        longer.back() << start, value;
      }
    starts = std::move(longer);
  }
  return starts;
}

// Whether shapes are what they are called; empty: any number is.
std::function<bool(const VectorXd&)> shapes_within(const EffectForm& form, const std::vector<std::size_t>& shapes) {
  struct Limit {
    std::size_t unknown;
    double most;
  };
  std::vector<Limit> limits;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const EffectForm::Shape shape = form.shape(s);
    const bool any = shape.kind == EffectForm::Shape::Kind::displacement ||
                     (shape.kind == EffectForm::Shape::Kind::exponent && !(shape.most > 0));
    if (!any) limits.push_back({shapes[s], shape.most > 0 ? shape.most : INFINITY});
  }
  if (limits.empty()) return {};
  return [limits](const VectorXd& unknowns) {
    return std::all_of(limits.begin(), limits.end(), [&](const Limit& limit) {
      const double value = unknowns(static_cast<Index>(limit.unknown));
      return value > 0 && value < limit.most;
    });
  };
}

// Candidates by kind, each with the unknowns that carry it: symbols of the augmented model, then faults.
class CandidateList {
 public:
  CandidateList(const EffectCatalogue& catalogue, const CandidateData& data)
      : catalogue_(catalogue),
        data_(data),
        first_fault_(data.model.symbols.size()),
        responses_(data.sensors.responses.size()),
        channels_(responses_ + data.sensors.excitations.size()) {}

  std::vector<Candidate> take() { return std::move(all_); }

  void add_equation_effects(const std::vector<EquationEffect>& effects) {
    for (const EquationEffect& e : effects) {
      const EffectForm* form = catalogue_.find_form(e.effect, e.form);
      if (form == nullptr) throw std::invalid_argument("candidates_of: no effect " + e.effect);
      Candidate c;
      c.subject = e.subject;
      c.mode = e.mode;
      c.equation = true;
      c.strengths = {e.strength};
      c.shapes = e.shapes;
      c.shape_starts = shape_starts(*form, e.shapes.size(), data_.largest, static_cast<Index>(e.mode));
      c.plausible = shapes_within(*form, e.shapes);
      add(*catalogue_.find(e.effect), std::move(c));
    }
  }

  void add_channel_faults() {
    const SensorModel& sensors = data_.sensors;
    for (std::size_t i = 0; i < channels_; ++i) {
      const bool response = i < responses_;
      const std::string& name = response ? sensors.response_names[i] : sensors.excitation_names[i - responses_];
      // Free motion seen by one channel: its gain is the unit of the motion.
      if (channels_ > 1) add_channel_fault(ChannelFault::gain, fault(name, data_.faults.gain(i)));
      // That of a velocity or acceleration is fitted beside every explanation (Comparison::nuisances).
      if (!response || sensors.derivatives == 0)
        add_channel_fault(ChannelFault::offset, fault(name, data_.faults.offset(i)));
      add_channel_fault(ChannelFault::skew, fault(name, data_.faults.delay(i)));
      if (response && !sensors.excitations.empty())
        add_channel_fault(ChannelFault::cross_axis, fault(name, data_.faults.cross(i)));
      const double peak = largest_value(data_.conditions, data_.segments, i, responses_);
      for (const double share : {0.997, 0.97, 0.9, 0.75, 0.6, 0.45}) {
        if (!(peak > 0)) break;
        Candidate clipping = fault(name, data_.faults.inverse_level(i));
        clipping.least_strength = 1 / (share * peak);
        add_channel_fault(ChannelFault::clipping, std::move(clipping));
      }
    }
  }

  void add_mode_shape_error() {
    const Effect* mixing = catalogue_.find(Effect::Kind::mode_shape_error);
    const std::size_t modes = data_.model.modes();
    if (!mixing || modes < 2 || responses_ < 2) return;
    Candidate c = fault("modal basis", 0);
    c.strengths.clear();
    for (std::size_t i = 0; i < modes; ++i)
      for (std::size_t k = 0; k < modes; ++k)
        if (i != k) c.strengths.push_back(first_fault_ + data_.faults.mixing(i, k));
    add(*mixing, std::move(c));
  }

  void add_frequency_drifts() {
    for (const Effect& effect : catalogue_.effects)
      for (std::size_t k = 0; effect.is_of_time() && k < data_.model.modes(); ++k) {
        Candidate drift = fault(std::string(data_.model.coordinates[k]), data_.faults.frequency_drift(k));
        drift.mode = k;
        drift.equation = true;
        add(effect, std::move(drift));
      }
  }

  void add_shaker_harmonics() {
    const Effect* effect = catalogue_.find(Effect::Kind::shaker_harmonics);
    if (!effect) return;
    Candidate harmonics = fault(data_.sensors.excitation_names[0], 0);
    harmonics.strengths.clear();
    for (std::size_t part = 0; part < 4; ++part)
      harmonics.strengths.push_back(first_fault_ + data_.faults.shaker_harmonic(part));
    add(*effect, std::move(harmonics));
  }

  void add_extra_mode() {
    const Effect* extra_mode = catalogue_.find(Effect::Kind::extra_mode);
    std::vector<VectorXd> starts = extra_mode_starts(data_.conditions);
    if (!extra_mode || starts.empty()) return;
    const FaultTable& faults = data_.faults;
    Candidate extra = fault("beyond the model", 0);
    extra.strengths.clear();
    for (std::size_t c = 0; c < responses_; ++c)
      extra.strengths.push_back(first_fault_ + faults.extra_amplitude(c));
    extra.shapes = {first_fault_ + faults.extra_frequency(), first_fault_ + faults.extra_damping()};
    extra.shape_starts = std::move(starts);
    extra.plausible = [lines = driven_lines(data_.conditions), first_fault = first_fault_, faults,
                       responses = responses_, derivatives = data_.sensors.derivatives](const VectorXd& unknowns) {
      const Faults set = faults.faults(unknowns.data() + first_fault);
      double measured = 0, beyond = 0;
      for (const DrivenLine& line : lines) {
        measured += line.response;
        for (std::size_t c = 0; c < responses; ++c)
          beyond += std::norm(set.extra.response(c, line.rate, derivatives, line.excitation));
      }
      return beyond <= largest_extra * measured;
    };
    add(*extra_mode, std::move(extra));
  }

 private:
  void add(const Effect& effect, Candidate c) {
    c.effect = effect.name;
    c.component = effect.component;
    c.passive = effect.sign_known;
    c.open_law = effect.kind == Effect::Kind::open_law;
    c.in_words = effect.in_words;
    c.contains = effect.contains;
    all_.push_back(std::move(c));
  }

  // With one unknown, at `place` of the table of faults.
  Candidate fault(const std::string& subject, std::size_t place) const {
    Candidate c;
    c.subject = subject;
    c.strengths = {first_fault_ + place};
    c.shape_starts = {VectorXd()};
    return c;
  }

  void add_channel_fault(ChannelFault kind, Candidate c) {
    if (const Effect* effect = catalogue_.find(kind)) add(*effect, std::move(c));
  }

  const EffectCatalogue& catalogue_;
  const CandidateData& data_;
  std::size_t first_fault_, responses_, channels_;
  std::vector<Candidate> all_;
};

}  // namespace

Candidate::Strength Candidate::strength_of_term(const VectorXd& unknowns) const {
  const double strength = unknowns(static_cast<Index>(strengths.front()));
  if (slip_scale != 0) {
    const double slip = unknowns(static_cast<Index>(shapes.front())), factor = slip_scale / std::abs(slip);
    return {strength * factor, factor, -strength * factor / slip};
  }
  if (power_scale == 0) return {strength};
  const double factor = std::pow(power_scale, 1 - unknowns(static_cast<Index>(shapes.front())));
  return {strength * factor, factor, -strength * factor * std::log(power_scale)};
}

double Candidate::sign_of_shapes(const VectorXd& unknowns) const {
  return slip_scale != 0 && unknowns(static_cast<Index>(shapes.front())) < 0 ? -1 : 1;
}

LargestMotions largest_motions(const std::vector<Condition>& conditions, const std::vector<Segment>& segments,
                               const SensorModel& sensors, const std::vector<double>& natural_frequency) {
  LargestMotions all;
  all.frequency = Eigen::Map<const VectorXd>(natural_frequency.data(), sensors.shapes.cols());
  all.displacement = all.speed = VectorXd::Zero(sensors.shapes.cols());
  const auto take = [&](Index mode, double displacement, double frequency) {
    all.displacement(mode) = std::max(all.displacement(mode), displacement);
    all.speed(mode) = std::max(all.speed(mode), displacement * frequency);
  };
  for (const Condition& c : conditions)
    for (const MasterLine& m : c.masters) {
      const auto mode = static_cast<Index>(m.mode);
      const Eigen::VectorXd shape = sensors.shapes.col(mode);
      const auto column = static_cast<Index>(std::find(c.lines.begin(), c.lines.end(), m.line) - c.lines.begin());
      const double modal = std::abs((shape.transpose().cast<std::complex<double>>() * c.response.col(column))(0)) /
                           shape.squaredNorm() / std::pow(std::abs(c.line_rate(m.line)), sensors.derivatives);
      take(mode, 2 * modal, std::abs(c.line_rate(m.line)));
    }
  for (const Segment& s : segments)
    for (Index k = 0; k < all.frequency.size(); ++k) {
      const double frequency = all.frequency(k);
      const double peak = (sensors.filter.row(k) * s.response).cwiseAbs().maxCoeff();
      take(k, peak / std::pow(frequency, sensors.derivatives), frequency);
    }
  return all;
}

std::vector<std::string> effect_names(const EffectCatalogue& catalogue) {
  std::vector<std::string> names;
  for (const Effect& effect : catalogue.effects)
    if (effect.kind != Effect::Kind::open_law && effect.kind != Effect::Kind::parameters)
      names.push_back(effect.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Candidate> candidates_of(const EffectCatalogue& catalogue, const std::vector<EquationEffect>& effects,
                                     const CandidateData& data) {
  CandidateList list(catalogue, data);
  list.add_equation_effects(effects);
  list.add_channel_faults();
  list.add_mode_shape_error();
  list.add_frequency_drifts();
  if (!data.sensors.excitations.empty()) {
    list.add_shaker_harmonics();
    list.add_extra_mode();
  }
  return list.take();
}

}  // namespace secular
