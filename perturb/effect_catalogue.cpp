#include "perturb/effect_catalogue.hpp"

#include <algorithm>
#include <array>

#include "input/input_error.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

using Order = CatalogueEntry::Order;
using Memory = CatalogueEntry::Memory;

// Couplings are Lagrangian: from V = c v^2 u, V = c v^2 u^2/2 and V = c v^3 u.
constexpr std::array catalogue = std::to_array<CatalogueEntry>({
    {.effect = "viscous_damping", .parameters = "mu1", .term = "-2*{0}*D({v})"},
    {.effect = "quadratic_damping",
     .parameters = "mu2",
     .term = "-{0}*abs(D({v}))*D({v})",
     .degree = 2,
     .order = Order::last},
    {.effect = "cubic_damping", .parameters = "mu3", .term = "-{0}*D({v})^3", .degree = 3},
    {.effect = "coulomb_friction", .parameters = "fc", .term = "-{0}*sgn(D({v}))", .order = Order::last},
    {.effect = "amplitude_dependent_damping", .parameters = "mu4", .term = "-{0}*{v}^2*D({v})", .degree = 3},
    {.effect = "quadratic_stiffness",
     .parameters = "alpha2",
     .term = "-{0}*{v}^2",
     .degree = 2,
     .order = Order::first},
    {.effect = "cubic_stiffness", .parameters = "alpha3", .term = "-{0}*{v}^3", .degree = 3},
    {.effect = "quintic_stiffness", .parameters = "alpha5", .term = "-{0}*{v}^5", .degree = 5},
    {.effect = "bilinear_stiffness", .parameters = "kb", .term = "-{0}*max({v}, 0)", .order = Order::last},
    // The stiffness kf that is lost within the gap: kf*(v - max(v - gap, 0) - min(v + gap, 0)).
    {.effect = "freeplay",
     .parameters = "kf gap",
     .term = "+{0}/2*(abs({v} + {1}) - abs({v} - {1}))",
     .order = Order::last},
    {.effect = "quadratic_inertia",
     .parameters = "delta2",
     .term = "-{0}*(2*{v}*D2({v}) + D({v})^2)",
     .degree = 2,
     .order = Order::first},
    {.effect = "cubic_inertia", .parameters = "delta3", .term = "-{0}*({v}^2*D2({v}) + {v}*D({v})^2)", .degree = 3},
    {.effect = "hysteresis",
     .parameters = "kh slip",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::elastic_displacement},
    // Micro-slip: a joint gives way little by little (Iwan 1966).
    {.effect = "hysteresis",
     .form = 1,
     .parameters = "ki spread",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::spread_displacement},
    // A slider that gives way ever more the further it is loaded (Bouc 1967, Wen 1976, with exponent 2).
    {.effect = "hysteresis",
     .form = 2,
     .parameters = "kz yield",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::smooth_displacement},
    {.effect = "direct_excitation", .parameters = "eta1", .term = "+{0}*{F}", .order = Order::unless_resonant},
    {.effect = "parametric_excitation",
     .parameters = "eta2",
     .term = "+{0}*{v}*{F}",
     .order = Order::unless_resonant},
    {.effect = "damping_coupling",
     .parameters = "mu12",
     .term = "-{0}*D({u})",
     .order = Order::first,
     .couples = true},
    {.effect = "quadratic_coupling",
     .parameters = "c21",
     .term = "-2*{0}*{v}*{u}",
     .other_term = "-{0}*{v}^2",
     .degree = 2,
     .order = Order::first,
     .couples = true},
    {.effect = "cubic_coupling",
     .parameters = "c22",
     .term = "-{0}*{v}*{u}^2",
     .other_term = "-{0}*{v}^2*{u}",
     .degree = 3,
     .couples = true,
     .symmetric = true},
    {.effect = "cubic_coupling",
     .form = 1,
     .parameters = "c31",
     .term = "-3*{0}*{v}^2*{u}",
     .other_term = "-{0}*{v}^3",
     .degree = 3,
     .couples = true},
    {.effect = "parametric_coupling",
     .parameters = "eta12",
     .term = "+{0}*{u}*{F}",
     .order = Order::unless_resonant,
     .couples = true},
    // Through an energy -F*eta*v*u, as every parametric excitation of elastic or gravitational origin.
    {.effect = "parametric_coupling",
     .form = 1,
     .parameters = "eta12_sym",
     .term = "+{0}*{u}*{F}",
     .other_term = "+{0}*{v}*{F}",
     .order = Order::unless_resonant,
     .couples = true,
     .symmetric = true},
    // omega = omega0*(1 + drift*t): omega^2 grows by 2*omega0^2*drift*t.
    {.effect = "natural_frequency_drift",
     .parameters = "drift",
     .term = "-2*{w}^2*{0}*{v}*{s}",
     .order = Order::outside,
     .memory = Memory::time},
});

constexpr std::array laws = std::to_array<CatalogueEntry>({
    {.effect = "open_stiffness",
     .parameters = "ku pu",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::displacement_power},
    {.effect = "open_damping",
     .parameters = "cu qu",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::velocity_power},
    {.effect = "open_loss",
     .parameters = "lu ru",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::loss_power},
    {.effect = "open_one_sided_damping",
     .parameters = "su tu",
     .term = "-{0}*{s}",
     .order = Order::outside,
     .memory = Memory::speed_power},
});

constexpr const char* extra_mode = "extra_mode";

std::string known_effects() {
  std::string names;
  for (const CatalogueEntry& entry : catalogue)
    if (entry.form == 0) names += std::string(entry.effect) + ", ";
  return names + extra_mode;
}

bool needs_excitation(const CatalogueEntry& entry) {
  return entry.term.find("{F}") != std::string_view::npos;
}

[[noreturn]] void refuse(const std::string& text, const std::string& wrong, const std::string& right) {
  throw InputError("effect " + text, "", wrong, right);
}

const CatalogueEntry* find_among(std::span<const CatalogueEntry> entries, const std::string& effect,
                                 std::size_t form) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const CatalogueEntry& entry) {
    return entry.effect == effect && entry.form == form;
  });
  return found == entries.end() ? nullptr : &*found;
}

std::size_t mode_index(const std::string& coordinate, const std::string& text, const Model& model) {
  std::string coordinates;
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    if (model.modes[k].coordinate == coordinate) return k;
    coordinates += (k == 0 ? "" : ", ") + model.modes[k].coordinate;
  }
  refuse(text, "'" + coordinate + "' is no coordinate of " + model.name, "its coordinates are " + coordinates);
}

}  // namespace

std::span<const CatalogueEntry> effect_catalogue() {
  return catalogue;
}

bool is_open_law(const std::string& effect) {
  return find_among(laws, effect, 0) != nullptr;
}

const CatalogueEntry* find_catalogue_entry(const std::string& effect, std::size_t form) {
  const CatalogueEntry* entry = find_among(catalogue, effect, form);
  return entry != nullptr ? entry : find_among(laws, effect, form);
}

std::vector<EffectTerm> applicable_effects(const Model& model) {
  std::vector<EffectTerm> terms;
  for (const CatalogueEntry& entry : catalogue) {
    if (needs_excitation(entry) && model.excitations.empty()) continue;
    for (std::size_t k = 0; k < model.modes.size(); ++k) {
      if (!entry.couples) {
        terms.push_back({std::string(entry.effect), k, EffectTerm::none, entry.form});
        continue;
      }
      for (std::size_t j = entry.symmetric ? k + 1 : 0; j < model.modes.size(); ++j)
        if (j != k) terms.push_back({std::string(entry.effect), k, j, entry.form});
    }
  }
  if (!model.excitations.empty()) terms.push_back({extra_mode, 0, EffectTerm::none, 0});
  return terms;
}

std::vector<EffectTerm> open_law_terms(const Model& model) {
  std::vector<EffectTerm> terms;
  for (const CatalogueEntry& entry : laws)
    for (std::size_t k = 0; k < model.modes.size(); ++k)
      terms.push_back({std::string(entry.effect), k, EffectTerm::none, entry.form});
  return terms;
}

EffectTerm parse_effect_term(const std::string& text, const Model& model) {
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  EffectTerm term{pieces[0], 0, EffectTerm::none, 0};
  const auto spare = [&](std::size_t most) {
    if (pieces.size() > most) refuse(text, "has more parts than this effect takes", "NAME[:MODE[:OTHER[:FORM]]]");
  };
  if (term.effect == extra_mode) {
    spare(1);
    return term;
  }
  const CatalogueEntry* entry = find_among(catalogue, term.effect, 0);
  if (entry == nullptr) refuse(text, "is not known", "known are " + known_effects());
  spare(entry->couples ? 4 : 2);
  if (pieces.size() > 1)
    term.mode = mode_index(pieces[1], text, model);
  else if (model.modes.size() > 1)
    refuse(text, "does not say at which mode", "write " + text + ":" + model.modes[0].coordinate);
  if (pieces.size() > 2)
    term.other = mode_index(pieces[2], text, model);
  else if (entry->couples && model.modes.size() == 2)
    term.other = 1 - term.mode;
  else if (entry->couples)
    refuse(text, "does not say which mode it joins", "write NAME:MODE:OTHER");
  if (pieces.size() > 3) {
    const bool digit = pieces[3].size() == 1 && pieces[3][0] >= '0' && pieces[3][0] <= '9';
    term.form = digit ? static_cast<std::size_t>(pieces[3][0] - '0') : EffectTerm::none;
    if (find_among(catalogue, term.effect, term.form) == nullptr)
      refuse(text, "has no form '" + pieces[3] + "'", "the catalogue counts an effect's forms from 0");
  }
  return term;
}

}  // namespace secular
