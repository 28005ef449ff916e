#pragma once

#include <string>

namespace secular::testing_support {

/// An experiment: one free decay of the shipped model duffing, a minute at 32 samples a second. `a3`: cubic stiffness.
inline std::string duffing_decay(const std::string& a3 = "10") {
  return "schema = 1\nname = \"test\"\nmodel = \"duffing\"\nsample_rate_hz = 32.0\n"
         "[parameters]\nomega0 = 6.28\nmu = 0.02\na2 = 0\na3 = " +
         a3 +
         "\ne = 1\n"
         "[[response]]\nname = \"x\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = 1e-3\n"
         "[[free_decay]]\ninitial_displacement = [0.5]\nduration_s = 60.0\n";
}

}  // namespace secular::testing_support
