#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blind/random.hpp"
#include "blind/structure.hpp"

namespace secular::blind {

/// What the records of a campaign are.
enum class Programme {
  dwells,     ///< dwells; one-mode structures have three free decays besides
  decays,     ///< four free decays
  one_decay,  ///< one
  sweeps,     ///< through the resonance, upwards at three levels and downwards at the highest
  broadband,  ///< noise about the resonance at three levels
  impacts     ///< five blows
};

/// As `secular blind generate --records` and labels write it.
const std::string& name_of(Programme programme);
bool is_programme(const std::string& name);
Programme programme_named(const std::string& name);
const std::vector<std::string>& programme_names();

/// Families whose structures a programme is run on.
std::vector<std::string> families_of(Programme programme);

/// A record whose motion is not settled.
struct Stretch {
  std::string kind;  ///< of the campaign file: free_decay, sweep, broadband or impact
  Drive drive;
  State state{};  ///< at its begin
  std::size_t samples = 0;

  bool is_driven() const { return drive.course != nullptr; }
};

/// Amplitude of the first mode's motion, and the drive that makes it at resonance, that stretches are sized by.
struct Size {
  double amplitude = 1, drive = 1;
};

/// The stretches of a programme on the first mode of a structure, which rests before what drives it; none of
/// `dwells`.
std::vector<Stretch> draw_stretches(Programme programme, const ModeTerms& mode, double decay_rate, const Size& size,
                                    Random& random);
/// A free decay from a displacement.
Stretch decay_from(double displacement, std::size_t samples);

}  // namespace secular::blind
