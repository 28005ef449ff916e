#include "effects/catalogue.hpp"

#include <algorithm>
#include <sstream>

namespace secular {
namespace {

using Component = EffectComponent;
using Kind = Effect::Kind;
using Order = EffectForm::Order;
using Shape = EffectForm::Shape;

constexpr Shape any_exponent{Shape::Kind::exponent};

/// Tuned: leaves room above the shares that are reported, so that their errors are not cut off.
constexpr double most_excess_at_rest = 5;

// A table, as long as there are effects: one row each.
// Couplings are Lagrangian: from V = c v^2 u, V = c v^2 u^2/2 and V = c v^3 u, and of inertia from T = c u D(v)^2/2
// and T = c v D(v) D(u).
std::vector<Effect> rows() {
  return {
      {.name = "viscous_damping",
       .component = Component::dissipative,
       .forms = {{.parameters = "mu1", .term = "-2*{0}*D({v})"}}},
      {.name = "quadratic_damping",
       .component = Component::dissipative,
       .forms = {{.parameters = "mu2", .term = "-{0}*abs(D({v}))*D({v})", .degree = 2, .order = Order::last}},
       .sign_known = true},
      {.name = "cubic_damping",
       .component = Component::dissipative,
       .forms = {{.parameters = "mu3", .term = "-{0}*D({v})^3", .degree = 3}}},
      {.name = "coulomb_friction",
       .component = Component::dissipative,
       .forms = {{.parameters = "fc", .term = "-{0}*sgn(D({v}))", .order = Order::last}},
       .sign_known = true},
      // What friction at rest is more than at speeds far beyond v0, as a share of the latter: one or less
      // (Armstrong-Helouvry, Dupont and Canudas de Wit 1994). Far more is a knock at every reversal.
      {.name = "stribeck_friction",
       .component = Component::dissipative,
       .forms = {{.parameters = "fk s v0",
                  .term = "-{0}*(1 + {1}*{s})*sgn(D({v}))",
                  .order = Order::outside,
                  .law = force_law::decay_with_speed,
                  .shapes = {{Shape::Kind::share, most_excess_at_rest}, {Shape::Kind::speed}}}},
       .sign_known = true,
       .contains = {"coulomb_friction"}},
      {.name = "power_damping",
       .component = Component::dissipative,
       .forms = {{.parameters = "cp p",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::velocity_power,
                  .shapes = {{Shape::Kind::exponent, 4}}}},
       .sign_known = true,
       .contains = {"viscous_damping", "quadratic_damping", "cubic_damping", "coulomb_friction"}},
      {.name = "amplitude_dependent_damping",
       .component = Component::dissipative,
       .forms = {{.parameters = "mu4", .term = "-{0}*{v}^2*D({v})", .degree = 3}},
       .mistaken_for = {"cubic_damping"}},
      {.name = "quadratic_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "alpha2", .term = "-{0}*{v}^2", .degree = 2, .order = Order::first}}},
      {.name = "cubic_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "alpha3", .term = "-{0}*{v}^3", .degree = 3}}},
      {.name = "quintic_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "alpha5", .term = "-{0}*{v}^5", .degree = 5}}},
      {.name = "bilinear_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "kb", .term = "-{0}*max({v}, 0)", .order = Order::last}}},
      // The stiffness kf that is lost within the gap: kf*(v - max(v - gap, 0) - min(v + gap, 0)).
      {.name = "freeplay",
       .component = Component::conservative,
       .forms = {{.parameters = "kf gap",
                  .term = "+{0}/2*(abs({v} + {1}) - abs({v} - {1}))",
                  .order = Order::last}},
       .sign_known = true},
      // A contact behind a clearance, on the one side or on the other: a shape's sign is the campaign's choice.
      {.name = "one_sided_stop",
       .component = Component::conservative,
       .forms = {{.parameters = "ks gap",
                  .term = "-{0}*max({v} - {1}, 0)",
                  .order = Order::last,
                  .shapes = {{Shape::Kind::gap}}},
                 {.parameters = "kn gap",
                  .term = "-{0}*min({v} + {1}, 0)",
                  .order = Order::last,
                  .shapes = {{Shape::Kind::gap}}}},
       .sign_known = true,
       .contains = {"bilinear_stiffness"}},
      // Freeplay in a structure whose stiffness is that within the gap.
      {.name = "two_sided_stop",
       .component = Component::conservative,
       .forms = {{.parameters = "kb2 gap",
                  .term = "-{0}*({v} - (abs({v} + {1}) - abs({v} - {1}))/2)",
                  .order = Order::last,
                  .shapes = {{Shape::Kind::gap}}}},
       .sign_known = true,
       .mistaken_for = {"freeplay", "cubic_stiffness"}},
      // Gives no more than strength times level: cubic as long as displacements are far below the level.
      {.name = "saturating_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "kt v0",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::saturation,
                  .shapes = {{Shape::Kind::level}}}},
       .sign_known = true,
       .contains = {"cubic_stiffness"}},
      {.name = "quadratic_inertia",
       .component = Component::conservative,
       .forms = {{.parameters = "delta2",
                  .term = "-{0}*(2*{v}*D2({v}) + D({v})^2)",
                  .degree = 2,
                  .order = Order::first}},
       .mistaken_for = {"quadratic_stiffness"}},
      {.name = "cubic_inertia",
       .component = Component::conservative,
       .forms = {{.parameters = "delta3", .term = "-{0}*({v}^2*D2({v}) + {v}*D({v})^2)", .degree = 3}},
       .mistaken_for = {"cubic_stiffness"}},
      // A joint that slips at once, little by little, and ever more the further it is loaded. Where it gives way
      // far below the motion, dry friction of as much force.
      {.name = "hysteresis",
       .component = Component::dissipative,
       .forms = {{.parameters = "kh slip", .term = "-{0}*{s}", .order = Order::outside, .law = force_law::slider},
                 {.parameters = "ki spread",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::spread_slider},
                 {.parameters = "kz yield",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::smooth_slider}},
       .sign_known = true,
       .contains = {"coulomb_friction"}},
      // A spring and a damper in series: at one frequency viscous damping and a stiffness.
      {.name = "relaxation",
       .component = Component::dissipative,
       .forms = {{.parameters = "kr tau",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::relaxation,
                  .shapes = {{Shape::Kind::time}}}},
       .sign_known = true,
       .mistaken_for = {"hysteresis"},
       .contains = {"viscous_damping"}},
      {.name = "direct_excitation",
       .component = Component::direct_excitation,
       .forms = {{.parameters = "eta1", .term = "+{0}*{F}", .order = Order::unless_resonant}}},
      {.name = "parametric_excitation",
       .component = Component::parametric_excitation,
       .forms = {{.parameters = "eta2", .term = "+{0}*{v}*{F}", .order = Order::unless_resonant}}},
      // A stiffness that the level of the excitation sets: a suspension that warms, a joint that loosens with it.
      {.name = "level_stiffness",
       .component = Component::conservative,
       .forms = {{.parameters = "kl", .term = "-{0}*{s}*{v}", .order = Order::outside, .law = force_law::level}}},
      {.name = "cubic_base_excitation",
       .component = Component::parametric_excitation,
       .forms = {{.parameters = "eta3", .term = "+{0}*{v}^3*{F}", .degree = 3, .order = Order::first}}},
      {.name = "damping_coupling",
       .component = Component::coupling,
       .forms = {{.parameters = "mu12", .term = "-{0}*D({u})", .order = Order::first}}},
      {.name = "quadratic_coupling",
       .component = Component::coupling,
       .forms = {{.parameters = "c21",
                  .term = "-2*{0}*{v}*{u}",
                  .other_term = "-{0}*{v}^2",
                  .degree = 2,
                  .order = Order::first}}},
      {.name = "cubic_coupling",
       .component = Component::coupling,
       .forms = {{.parameters = "c22",
                  .term = "-{0}*{v}*{u}^2",
                  .other_term = "-{0}*{v}^2*{u}",
                  .degree = 3,
                  .symmetric = true},
                 {.parameters = "c31", .term = "-3*{0}*{v}^2*{u}", .other_term = "-{0}*{v}^3", .degree = 3}}},
      {.name = "inertia_coupling",
       .component = Component::coupling,
       .forms = {{.parameters = "d12",
                  .term = "-{0}*({u}*D2({v}) + D({u})*D({v}))",
                  .other_term = "+{0}/2*D({v})^2",
                  .degree = 2,
                  .order = Order::first},
                 {.parameters = "d21",
                  .term = "-{0}*{v}*D2({u})",
                  .other_term = "-{0}*(D({v})^2 + {v}*D2({v}))",
                  .degree = 2,
                  .order = Order::first}},
       .mistaken_for = {"quadratic_coupling"}},
      // The second form: through an energy -F*eta*v*u, as every parametric excitation of elastic or gravitational
      // origin.
      {.name = "parametric_coupling",
       .component = Component::coupling,
       .forms = {{.parameters = "eta12", .term = "+{0}*{u}*{F}", .order = Order::unless_resonant},
                 {.parameters = "eta12_sym",
                  .term = "+{0}*{u}*{F}",
                  .other_term = "+{0}*{v}*{F}",
                  .order = Order::unless_resonant,
                  .symmetric = true}}},
      {.name = "extra_mode", .component = Component::direct_excitation, .kind = Kind::extra_mode},
      // omega = omega0*(1 + drift*t): omega^2 grows by 2*omega0^2*drift*t.
      {.name = "natural_frequency_drift",
       .component = Component::conservative,
       .forms = {{.parameters = "drift",
                  .term = "-2*{w}^2*{0}*{v}*{s}",
                  .order = Order::outside,
                  .law = force_law::time}}},
      {.name = "shaker_harmonics", .component = Component::direct_excitation, .kind = Kind::shaker_harmonics},
      {.name = "sensor_gain", .kind = Kind::channel_fault, .fault = ChannelFault::gain},
      {.name = "sensor_offset", .kind = Kind::channel_fault, .fault = ChannelFault::offset},
      {.name = "sensor_cross_axis",
       .kind = Kind::channel_fault,
       .fault = ChannelFault::cross_axis,
       .mistaken_for = {"extra_mode"}},
      {.name = "channel_skew", .kind = Kind::channel_fault, .fault = ChannelFault::skew},
      {.name = "clipping", .kind = Kind::channel_fault, .sign_known = true, .fault = ChannelFault::clipping},
      {.name = "mode_shape_error", .kind = Kind::mode_shape_error, .mistaken_for = {"sensor_gain"}},
      {.name = "parameters", .kind = Kind::parameters, .mistaken_for = {"sensor_gain"}},
      {.name = "open_stiffness",
       .component = Component::conservative,
       .kind = Kind::open_law,
       .forms = {{.parameters = "ku pu",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::displacement_power,
                  .shapes = {any_exponent}}},
       .in_words = "a force of {mode} that grows as |displacement|^{exponent}"},
      {.name = "open_damping",
       .component = Component::dissipative,
       .kind = Kind::open_law,
       .forms = {{.parameters = "cu qu",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::velocity_power,
                  .shapes = {any_exponent}}},
       .in_words = "a force of {mode} that grows as |velocity|^{exponent}"},
      {.name = "open_loss",
       .component = Component::dissipative,
       .kind = Kind::open_law,
       .forms = {{.parameters = "lu ru",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::loss_power,
                  .shapes = {any_exponent}}},
       .in_words = "a viscous damping of {mode} that grows as |displacement|^{exponent}"},
      {.name = "open_one_sided_damping",
       .component = Component::dissipative,
       .kind = Kind::open_law,
       .forms = {{.parameters = "su tu",
                  .term = "-{0}*{s}",
                  .order = Order::outside,
                  .law = force_law::speed_power,
                  .shapes = {any_exponent}}},
       .in_words = "a force of {mode} that grows as |velocity|^{exponent} in either direction of motion with the "
                   "same sign (a damping of one direction, beside a viscous one)"},
  };
}

template <class Rows, class Match>
const Effect* first(const Rows& effects, const Match& match) {
  const auto found = std::find_if(effects.begin(), effects.end(), match);
  return found == effects.end() ? nullptr : &*found;
}

}  // namespace

std::string to_string(EffectComponent component) {
  switch (component) {
    case EffectComponent::conservative:
      return "conservative";
    case EffectComponent::dissipative:
      return "dissipative";
    case EffectComponent::direct_excitation:
      return "direct_excitation";
    case EffectComponent::parametric_excitation:
      return "parametric_excitation";
    case EffectComponent::coupling:
      return "coupling";
    case EffectComponent::measurement:
      break;
  }
  return "measurement";
}

bool EffectForm::couples() const {
  return term.find("{u}") != std::string::npos;
}

bool EffectForm::needs_excitation() const {
  return term.find("{F}") != std::string::npos || law.kind == ForceLaw::Kind::level;
}

std::vector<std::string> EffectForm::parameter_names() const {
  std::istringstream stream(parameters);
  std::vector<std::string> names;
  for (std::string name; stream >> name;) names.push_back(name);
  return names;
}

EffectForm::Shape EffectForm::shape(std::size_t parameter) const {
  return parameter < shapes.size() ? shapes[parameter] : Shape{};
}

bool Effect::is_of_time() const {
  return !forms.empty() && forms.front().law.kind == ForceLaw::Kind::time;
}

const Effect* EffectCatalogue::find(std::string_view name) const {
  return first(effects, [&](const Effect& effect) { return effect.name == name; });
}

const Effect* EffectCatalogue::find(Effect::Kind kind) const {
  return first(effects, [&](const Effect& effect) { return effect.kind == kind; });
}

const Effect* EffectCatalogue::find(ChannelFault fault) const {
  return first(effects, [&](const Effect& effect) { return effect.fault == fault; });
}

std::vector<std::string> EffectCatalogue::look_alikes(std::string_view name) const {
  const auto names_it = [](const Effect& effect, std::string_view other) {
    const auto holds = [other](const std::vector<std::string>& list) {
      return std::find(list.begin(), list.end(), other) != list.end();
    };
    return holds(effect.mistaken_for) || holds(effect.contains);
  };
  const Effect* effect = find(name);
  std::vector<std::string> alike;
  for (const Effect& other : effects)
    if (names_it(other, name) || (effect && names_it(*effect, other.name))) alike.push_back(other.name);
  return alike;
}

const EffectForm* EffectCatalogue::find_form(std::string_view name, std::size_t form) const {
  const Effect* effect = find(name);
  return effect && form < effect->forms.size() ? &effect->forms[form] : nullptr;
}

const EffectCatalogue& effect_catalogue() {
  static const EffectCatalogue catalogue{rows()};
  return catalogue;
}

}  // namespace secular
