#pragma once

#include <string>

#include "tests/app/diagnosed_folder.hpp"

namespace secular::testing_support {

/// A folder with a model of one linear mode and campaigns that are simulated with it.
class PlainOscillator : public DiagnosedFolder {
 protected:
  /// How it is measured: the response, and each with noise (sd).
  struct Measured {
    double rate_hz = 320;
    std::string quantity = "velocity", unit = "m/s";
    double noise_sd = 0.0003;
    std::uint64_t seed = 5;
  };

  /// model.toml, and campaign/: these records of `parameters` (omega0, mu1, eta1), an effect that is not in the
  /// model after them.
  void simulate(const Measured& as, const std::string& parameters, const std::string& records) const {
    std::ofstream(folder_ / "model.toml") << R"toml(schema = 1
name = "plain"
[[mode]]
coordinate = "v"
frequency = "omega0"
equation = "D2(v) + omega0^2*v = -2*mu1*D(v) + eta1*F*cos(Omega*t)"
[[case]]
name = "free"
relations = []
order = { mu1 = 2, eta1 = 2 }
expand_to = 2
excitation = false
[[case]]
name = "primary"
relations = ["Omega = omega0 + eps^2*sigma"]
order = { mu1 = 2, eta1 = 2 }
expand_to = 2
[nominal]
omega0 = 66.0
)toml";
    std::ofstream(folder_ / "experiment.toml")
        << "schema = 1\nname = \"made\"\nmodel = \"" << path("model.toml") << "\"\nsample_rate_hz = " << as.rate_hz
        << ".0\n[parameters]\n"
        << parameters << R"toml([excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.001
[[response]]
name = "tip"
)toml"
        << "quantity = \"" << as.quantity << "\"\nunit = \"" << as.unit << "\"\nnoise_sd = " << as.noise_sd << '\n'
        << records;
    ASSERT_EQ(run("simulate " + path("experiment.toml") + " --seed " + std::to_string(as.seed) + " --force -o " +
                  path("campaign")),
              0)
        << printed();
  }
};

}  // namespace secular::testing_support
