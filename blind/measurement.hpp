#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "blind/motion.hpp"
#include "blind/structure.hpp"

namespace secular::blind {

/// What is wrong with one channel.
struct ChannelFault {
  double gain = 0;        ///< reads (1 + gain) times the truth
  double offset = 0;      ///< in the channel's unit
  double cross_axis = 0;  ///< of the excitation, added
  double late = 0;        ///< s
  double range = 0;       ///< saturates at this absolute value; 0: never
};

/// Sensors of a structure: the base acceleration and `shapes.size()` response channels.
struct Measurement {
  std::vector<std::string> names;  ///< "base", then the response channels
  bool of_displacement = false;    ///< the response channels; otherwise of acceleration
  bool with_modal_basis = false;
  std::vector<std::vector<double>> shapes;  ///< response channels x modes, as campaign.toml states them
  std::array<double, most_modes> leak{};    ///< into mode k from the other: true shapes = shapes (1 + leak)
  std::vector<ChannelFault> fault;          ///< by channel
};

/// Noise-free samples of all channels; `clipped` false leaves saturation for later (it follows the noise).
std::vector<std::vector<double>> measured(const Measurement& measurement, const Drive& drive, const Motion& motion,
                                          bool clipped);
/// Cuts every channel at the range of its fault, in channel units; without a range it stays.
void clip(const Measurement& measurement, std::vector<std::vector<double>>& channels);

/// Samples of a signal that is `late` seconds behind, by Lagrange's polynomial through eight samples.
std::vector<double> delayed(const std::vector<double>& samples, double late);

}  // namespace secular::blind
