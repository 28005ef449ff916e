#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "effects/force_law.hpp"

namespace secular {

/// What of the equations of motion an effect changes, or the measurement.
enum class EffectComponent {
  conservative,
  dissipative,
  direct_excitation,
  parametric_excitation,
  coupling,
  measurement
};

/// As in diagnosis.json.
std::string to_string(EffectComponent component);

/// What is wrong with one channel.
enum class ChannelFault {
  none,
  gain,        ///< the channel times the strength
  offset,      ///< plus the strength
  cross_axis,  ///< plus the strength times the excitation
  skew,        ///< late by the strength, in seconds
  clipping,    ///< saturates at +- the strength
};

/// A term of the equations of motion, as text. In `term` and `other_term` stand
///   {v} and {u}   the coordinate of the mode and of the other mode,
///   {w}           the mode's natural frequency,
///   {F}           the model's first excitation, F*cos(Omega*t),
///   {s}           the signal of `law`,
///   {0}, {1}, ... its parameters: the strength, which multiplies the whole term, then shape parameters.
struct EffectForm {
  /// Order of eps in a case, cut at the case's expand_to.
  enum class Order {
    first,
    second,
    last,             ///< expand_to: nonsmooth terms are not expanded further
    unless_resonant,  ///< first, but last where the excitation is resonant through this very term
    outside,          ///< beyond expand_to: the term is in the equations of motion only
  };
  /// What a shape parameter is: where a search for it begins, and within which limits it is what it is called.
  struct Shape {
    enum class Kind {
      displacement,  ///< any number; a share of the largest displacement to begin with
      gap,           ///< a displacement, > 0
      level,         ///< a displacement that may be beyond the largest one, > 0
      speed,         ///< > 0
      time,          ///< > 0; about a period
      share,         ///< without unit, between 0 and `most`
      exponent,      ///< the same; without `most`, any number
    };
    Kind kind = Kind::displacement;
    double most = 0;  ///< 0: no bound
  };
  /// Names, separated by blanks: of the strength's symbol, then of the shape parameters, which are keys of an
  /// experiment file, too.
  std::string parameters = {};
  std::string term = {};        ///< on the right-hand side of the mode's equation
  std::string other_term = {};  ///< on that of the other mode's; empty: none
  int degree = 1;               ///< in coordinates and velocities, as ResonanceCase::degree_ordering counts
  Order order = Order::second;
  bool symmetric = false;  ///< (mode, other) and (other, mode) are the same term
  ForceLaw law = {};
  std::vector<Shape> shapes = {};  ///< of the shape parameters, in their order; empty: displacements

  bool couples() const;                              ///< needs another mode
  bool needs_excitation() const;                     ///< its term or law holds {F}
  std::vector<std::string> parameter_names() const;  ///< of `parameters`: the strength first
  Shape shape(std::size_t parameter) const;          ///< of a shape parameter, counted from 0
};

/// One effect: a row of the catalogue.
struct Effect {
  /// How the program makes it. All kinds but terms and channel faults are there once.
  enum class Kind {
    term,        ///< `forms`, in the equations of motion
    open_law,    ///< the same, with an exponent of its own: what stands for single laws that the catalogue does
                 ///< not hold. In no experiment, and never a cause
    extra_mode,  ///< an equation of motion more
    shaker_harmonics,  ///< the excitation's amplitudes at 2, 3, ... times its frequency
    channel_fault,     ///< `fault`
    mode_shape_error,  ///< the shapes of two modes are turned into each other
    parameters,        ///< nothing is missing: one of the model's own numbers is off
  };
  std::string name = {};
  EffectComponent component = EffectComponent::measurement;
  Kind kind = Kind::term;
  std::vector<EffectForm> forms = {};
  bool sign_known = false;  ///< can only oppose or give way: no negative strength
  ChannelFault fault = ChannelFault::none;
  /// Effects that some data cannot tell from it, near one resonance for example, as far as neither their rows nor
  /// `contains` say so (EffectCatalogue::look_alikes).
  std::vector<std::string> mistaken_for = {};
  /// Simpler effects that it becomes at an end, or a value, of its shape: where it explains no better than they do,
  /// they are named.
  std::vector<std::string> contains = {};
  /// Of an open law, as what the structure acts like: {mode} stands for the mode's name and {exponent} for the
  /// exponent with its error bar.
  std::string in_words = {};

  /// Whether it changes with time, so that no line of a steady motion shows it.
  bool is_of_time() const;
};

/// All that the program knows of effects: derivations, simulated experiments and diagnoses read their terms, keys,
/// candidates and names here.
struct EffectCatalogue {
  std::vector<Effect> effects;

  /// nullptr where there is none.
  const Effect* find(std::string_view name) const;
  const Effect* find(Effect::Kind kind) const;
  const Effect* find(ChannelFault fault) const;
  /// Effects that some data cannot tell from it: one of the two rows says so. In the catalogue's order.
  std::vector<std::string> look_alikes(std::string_view name) const;
  const EffectForm* find_form(std::string_view name, std::size_t form) const;
};

/// The catalogue of this program. A new effect costs one row.
const EffectCatalogue& effect_catalogue();

}  // namespace secular
