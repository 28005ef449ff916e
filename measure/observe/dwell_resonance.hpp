#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// A case as far as it tells which records are its own: integer relations over the natural frequencies and then the
/// excitations' frequencies.
struct Resonance {
  bool excited = true;
  std::vector<std::vector<int>> relations;
};

/// How far natural frequencies (rad/s, by mode) and an excitation frequency are from fulfilling the relations,
/// relative; infinite where that cannot be determined.
double mismatch(const Resonance& resonance, const std::vector<double>& natural, double excitation);

/// A part of the excitation frequency at which a mode may answer, numerator/denominator < 1.
struct Subharmonic {
  int numerator = 1, denominator = 2;
  friend bool operator==(const Subharmonic&, const Subharmonic&) = default;
  friend auto operator<=>(const Subharmonic&, const Subharmonic&) = default;
};

/// What a dwell shows of the resonance that it excites.
struct DwellTones {
  std::size_t record = 0;
  double excitation = 0;                  ///< rad/s
  std::vector<Subharmonic> subharmonics;  ///< those of the cases that the response has, in order
};

/// Every dwell that says its excitation frequency. Responses are read where the cases differ in their subharmonics.
std::vector<DwellTones> dwell_tones(const Campaign& campaign, const RecordReader& read,
                                    const std::vector<Resonance>& cases, const Window& window);

/// The case that a dwell belongs to, and whether the dwell's response agrees.
struct DwellCase {
  std::size_t resonance = 0;  ///< index, or the number of cases: none
  enum class Response {
    agrees,       ///< it has the subharmonics of the case
    at_rest,      ///< it lacks some of them
    contradicts,  ///< it has one that the case has not
  };
  Response response = Response::agrees;
};

/// Of the excited cases within the resonance width, one that the response agrees with, else one in which it may be
/// at rest, else one that it contradicts; of several the nearest.
DwellCase case_of_dwell(const DwellTones& dwell, const std::vector<Resonance>& cases,
                        const std::vector<double>& natural);

}  // namespace secular
