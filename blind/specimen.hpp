#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "blind/measurement.hpp"
#include "blind/motion.hpp"
#include "blind/programme.hpp"
#include "blind/random.hpp"
#include "blind/structure.hpp"

namespace secular::blind {

/// A term that the model file contains: an effect's name, the mode it acts at, the symbol of its coefficient.
struct OwnTerm {
  std::string effect;
  std::size_t mode = 0;
  std::string symbol;
};

struct Dwell {
  Drive drive;
  State state{};  ///< settled, of the structure without anything withheld
  std::string group;
};

/// A structure, what the model knows of it, its sensors and the programme of its test.
struct Specimen {
  std::string family;  ///< primary | principal_parametric | asymmetric | two_modes
  std::vector<std::string> coordinates;
  std::vector<std::string> frequency_symbols;
  Structure structure;  ///< own terms only
  std::vector<OwnTerm> own;
  std::array<double, most_modes> typical_amplitude{};  ///< of q, kg^(1/2) m
  std::array<double, most_modes> decay_rate{};         ///< 1/s at the typical amplitude
  double typical_drive = 1;                            ///< m/s^2
  Measurement measurement;
  Settling settling;
  std::vector<Dwell> dwells;       ///< settled: those that rest are left out
  std::vector<Stretch> stretches;  ///< after them
};

/// Draws a structure of a family that has none of the `withheld` effects, nor one of its own that is the same thing
/// to the data, with about `dwells` dwells where there are any.
Specimen draw_specimen(const std::string& family, const std::set<std::string>& withheld, std::size_t dwells,
                       Random& random, Programme programme = Programme::dwells);

/// The coefficient at which an effect's force at the typical amplitude is `share` of the linear damping force 2 mu
/// omega a, the force that a half-bandwidth is worth.
double coefficient_of_share(const Specimen& specimen, const std::string& effect, std::size_t mode, double share);

}  // namespace secular::blind
