#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/inference/held_out.hpp"
#include "diagnose/verdict/rivals.hpp"
#include "effects/catalogue.hpp"

namespace secular {

/// What the best rival names, and what the data cannot tell from it.
struct Naming {
  std::vector<std::string> set;        ///< the leading effect, then those that could stand in its place
  std::vector<std::string> together;   ///< two effects that act at once, the leading one first
  std::vector<std::string> second_or;  ///< effects that could stand in the place of the second of them

  /// Whether it is in the set, or one of two that act at once.
  bool names(const std::string& effect) const;
};

/// `rivals`: ranked, none of them an open law; throws std::invalid_argument where there are none.
Naming name_effects(const std::vector<Rival>& rivals, const Inference& inference);

/// Whether conditions that were held out repeat it that an explanation leaves less than `limit`.
using StepIsShown = std::function<bool(const Explanation& limit, const Explanation& explanation)>;

/// Adds the limits of the effects that are named, where a rival has them in their place and nothing shows that the
/// law itself is needed (docs/inference.md (31)): however much likelier it is, it names no more than its limit
/// then.
void keep_limits(Naming& naming, const std::vector<Rival>& rivals, const EffectCatalogue& catalogue,
                 const StepIsShown& is_shown);

/// What an explanation leaves on conditions that were held out, as ClosedShare::after.
using LeftBy = std::function<double(const Explanation&)>;

/// Adds what acts as much like the best explanation, where that is not all: how much likelier it is than others
/// rests on a model that does not hold then. An effect in the place of one of its own does if it closes nine tenths
/// of what that one closes beside the other. `closing`: of the best rival.
void add_neighbours(Naming& naming, const std::vector<Rival>& rivals, const ClosedShare& closing,
                    const LeftBy& left_by);

}  // namespace secular
