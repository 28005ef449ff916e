#pragma once

namespace secular::testing_support {

/// An experiment without its records: an oscillator of 20 Hz that hardens, on a base that moves.
constexpr const char* hardening_oscillator = R"toml(schema = 1
name = "duff"
model = "duffing"
sample_rate_hz = 256.0
[parameters]
omega0 = 125.66370614359172
mu = 1.0
a2 = 0.0
a3 = 2.5e8
e = 1.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.01
[[response]]
name = "tip"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.02
)toml";

}  // namespace secular::testing_support
