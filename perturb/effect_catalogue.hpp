#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace secular {

struct Model;

/// An effect of the catalogue at one mode. `mode` and `other` are indices into Model::modes.
struct EffectTerm {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::string effect = {};
  std::size_t mode = 0;      ///< of no meaning for extra_mode
  std::size_t other = none;  ///< second mode of couplings
  std::size_t form = 0;      ///< which of the effect's terms, where the catalogue has several (cubic_coupling)
  bool operator==(const EffectTerm&) const = default;
};

/// What an effect brought into a model.
struct AddedEffect {
  EffectTerm term;
  /// Symbols added to the model. The first is the strength, which multiplies the whole term (0: no effect); further
  /// ones are shape parameters. freeplay: gap; hysteresis: slip displacement, which enters no equation and is there
  /// for whoever integrates z(t); extra_mode: natural frequency (rad/s) and viscous damping mu1 (1/s).
  std::vector<std::string> parameters;
  /// hysteresis, natural_frequency_drift, open laws: index of the excitation whose signal the caller supplies: the
  /// value (not an amplitude) of the elastic displacement z(t), of the time or of the law. EffectTerm::none for all
  /// others.
  std::size_t memory = EffectTerm::none;
  /// extra_mode: index of the mode that was added.
  std::size_t added_mode = EffectTerm::none;
};

/// One term that an effect adds to the equations of motion, as text. In `term` and `other_term` stand
///   {v} and {u}   the coordinate of the mode and of the other mode,
///   {w}           the mode's natural frequency,
///   {F}           the model's first excitation, F*cos(Omega*t),
///   {s}           an excitation of its own, whose signal the caller supplies (see Memory),
///   {0}, {1}, ... its parameters: the strength, which multiplies the whole term, then shape parameters.
struct CatalogueEntry {
  /// What the caller has to supply as signal of the excitation {s}.
  enum class Memory {
    none,
    time,                  ///< the time in s since the strength's reference instant
    elastic_displacement,  ///< z(t) of a slider and spring in series: dz/dt = D(v), |z| <= slip
    spread_displacement,   ///< mean of those of many such sliders, their slips evenly spread between 0 and slip
    smooth_displacement,   ///< dz/dt = D(v) - abs(D(v))*z*abs(z)/slip^2
    displacement_power,    ///< sgn(v)*|v|^exponent, in whatever scale
    velocity_power,        ///< sgn(D(v))*|D(v)|^exponent, in whatever scale
    loss_power,            ///< |v|^exponent*D(v), in whatever scale
    speed_power,           ///< |D(v)|^exponent, in whatever scale
  };
  /// Order of eps in a case, cut at the case's expand_to.
  enum class Order {
    first,
    second,
    last,             ///< expand_to: nonsmooth terms are not expanded further
    unless_resonant,  ///< first, but last where the excitation is resonant through this very term
    outside,          ///< beyond expand_to: the term is in the equations of motion only
  };
  std::string_view effect = {};
  std::size_t form = 0;
  std::string_view parameters = {};  ///< stems of the symbols, separated by blanks
  std::string_view term = {};        ///< on the right-hand side of the mode's equation
  std::string_view other_term = {};  ///< on that of the other mode's; empty: none
  int degree = 1;                    ///< in coordinates and velocities, as ResonanceCase::degree_ordering counts
  Order order = Order::second;
  bool couples = false;    ///< needs another mode
  bool symmetric = false;  ///< (mode, other) and (other, mode) are the same term
  Memory memory = Memory::none;
};

/// All effects that are terms of an equation of motion, but extra_mode, which adds an equation. A new effect costs
/// one entry.
std::span<const CatalogueEntry> effect_catalogue();

/// Forces of one mode with an exponent of their own, open_stiffness, open_damping, open_loss and
/// open_one_sided_damping: what stands for single laws that the catalogue does not hold. They enter no experiment
/// and are never a cause.
bool is_open_law(const std::string& effect);

/// The entry of an effect and form, open laws among them; nullptr if there is none (extra_mode has none).
const CatalogueEntry* find_catalogue_entry(const std::string& effect, std::size_t form = 0);

/// Every effect of the catalogue for every mode, and pair of modes, that it fits: those that need an excitation
/// only for a model that has one. Effects whose term the model already holds are listed too.
std::vector<EffectTerm> applicable_effects(const Model& model);

/// Every open law for every mode.
std::vector<EffectTerm> open_law_terms(const Model& model);

/// NAME[:MODE[:OTHER[:FORM]]] with coordinates for MODE and OTHER; MODE may be left out where there is one mode,
/// OTHER where there are two. Throws InputError.
EffectTerm parse_effect_term(const std::string& text, const Model& model);

}  // namespace secular
