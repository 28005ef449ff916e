#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "measure/modal/eigensystem_realization.hpp"
#include "measure/modal/pole_support.hpp"

namespace secular {

/// One pole of one model order, and what the next lower order says of it.
struct StabilisationPole {
  int order = 0;              ///< 2n
  std::complex<double> pole;  ///< rad/s, upper half plane
  Eigen::VectorXcd shape;     ///< p, of arbitrary scale
  double strength = 0;        ///< largest |C_pr B_rq|: initial half amplitude, unit of the responses
  bool stable_frequency = false, stable_damping = false, stable_shape = false;
  int previous = -1;  ///< index of its nearest pole of the next lower order; -1: none stable in frequency
  bool stable() const { return stable_frequency && stable_damping && stable_shape; }
};

struct StabilisationOptions {
  int largest_order = 40;                ///< even
  double frequency_tolerance = 0.005;    ///< relative
  double damping_tolerance = 0.1;        ///< relative, of the damping ratio
  double shape_tolerance = 0.95;         ///< smallest MAC
  double lowest_hz = 0, highest_hz = 0;  ///< modes outside are not selected; 0: no limit
  double persistence = 0.5;              ///< a mode is stable over this share of the orders above its first
};

/// A mode that stands in the diagram: a chain of stable poles over consecutive orders.
struct StableMode {
  std::complex<double> pole;  ///< rad/s, median over the chain
  Eigen::VectorXcd shape;     ///< of the pole nearest to that
  double strength = 0;
  int orders = 0;                                   ///< length of the chain
  double frequency_spread = 0, damping_spread = 0;  ///< standard deviation over the chain: rad/s; of the ratio
  PoleSupport support;                              ///< once the free motions were asked
};

struct StabilisationDiagram {
  StabilisationOptions options;
  std::vector<StabilisationPole> poles;   ///< by order
  std::vector<StableMode> modes;          ///< by frequency
  std::vector<StableMode> others;         ///< that stand as well but were not selected
  std::vector<StableMode> no_resonances;  ///< motion that is no mode
  Eigen::VectorXd singular_values;
};

/// Realizations of every even order from 2 up to the largest one (or the rank of the data), compared order by
/// order.
StabilisationDiagram stabilisation_diagram(const EigensystemRealization& realization,
                                           const StabilisationOptions& options);

/// Whether two modes are one by the tolerances of the diagram: frequency, damping and shape.
bool same_pole(const StableMode& a, const StableMode& b, const StabilisationOptions& options);

}  // namespace secular
