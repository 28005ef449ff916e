#pragma once

#include <string>

// A beam with one mode and a cubic spring on a moving base, as texts of a model and of its experiments.
namespace secular::testing_support {

inline std::string beam_model(const std::string& nominal_frequency) {
  return R"toml(schema = 1
name = "beam"
[[mode]]
coordinate = "q"
frequency = "omega0"
equation = "D2(q) + omega0^2*q = -2*mu1*D(q) - alpha3*q^3 + eta1*F*cos(Omega*t)"
[nominal]
omega0 = )toml" +
         nominal_frequency + R"toml(
[[case]]
name = "primary"
relations = ["Omega = omega0 + eps^2*sigma"]
order = { mu1 = 2, alpha3 = 2, eta1 = 2 }
expand_to = 2
)toml";
}

/// Of a beam of 40 rad/s: what it is and what drives it.
inline constexpr const char* slow_beam = R"toml(sample_rate_hz = 128.0
[parameters]
omega0 = 40.3
mu1 = 0.3
alpha3 = 1.5e4
eta1 = 0.8
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.005
)toml";

}  // namespace secular::testing_support
