#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

namespace secular::report {

/// A structure in one of its motions x + Re(motion exp(i phase)): points in space (z up) and the lines between
/// them.
struct StructureDrawing {
  std::string title;                                        ///< also the accessible name
  std::string id;                                           ///< of the page's element: letters, digits, underscores; SMIL reads a dash as a minus
  std::vector<std::array<double, 3>> points;                ///< at rest
  std::vector<std::array<std::complex<double>, 3>> motion;  ///< of each point, in any one scale
  std::vector<std::vector<std::size_t>> lines;              ///< points along each
};

/// One <svg> element: at rest, at both ends of the motion, and in motion for ten seconds after a click (SMIL, no
/// script). Seen along (-1, 2, -1), without perspective; the largest motion is drawn as 15 % of the structure's
/// size. Throws std::invalid_argument where sizes differ or there are no points.
std::string structure_drawing(const StructureDrawing& drawing);

}  // namespace secular::report
