#include "thesis/procedures/thesis_tables.hpp"

namespace secular::app {
namespace {

// S. O'F. Fahey, dissertation, Virginia Tech, 2000. Quadratic lumps of (5.38) are printed over 6 w0^2, with w0 from
// 12.39 Hz; Table 5.4 halves Table 5.2's lump and
// quarters Table 5.3's alpha_e, as amplitudes twice as large do, but keeps mu3, which they would quarter as well.
constexpr double six_w2 = 6 * 77.84866595595507 * 77.84866595595507;

constexpr PrintedValue values[] = {
    {"5.1", "5.37", "mu1/|eta_e|", 0.1155, {}},
    {"5.1", "5.37", "mu3/|eta_e|", 19.18, {}},
    {"5.4", "5.40", "mu1", 0.222, {}},
    {"5.4", "5.40", "mu3", 36.87, {}},
    {"5.4", "5.40", "alpha_e", -10.62e6, {}},
    {"5.4", "5.40", "|eta_e|", 1.922, {}},
    {"5.4", "5.38", "alpha2 - 3 delta2 w0^2", -0.535 * six_w2, 1.011 * six_w2},
    {"5.4", "5.38", "eta1", -17.99e-3, 0.877e-3},
    {"2.4", "", "omega0", 77.84866595595507, {}},  // section 5.5: 12.39 Hz
    {"6.1", "6.43", "mu12", -0.1547, 0.564},
    {"6.1", "6.43", "eta12", 11.07, 5.96},
    {"6.1", "6.44", "alpha22 - w1 w2 delta22 - w1^2 delta22", 121.3e6, 265e6},
    {"6.1", "6.44", "eta11", -0.0280, 0.000864},
    {"6.1", "6.45", "eta12", 7.62, 3.36},
    {"6.1", "6.46", "mu21", -0.569, 4.33},
    {"6.1", "6.46", "eta22", 55.8, 49.1},
    {"6.1", "6.47", "alpha23 - w1 w2 delta23 - w2^2 delta23", 162.0e6, 353e6},
    {"6.1", "6.47", "eta21", -0.001287, 0.0001652},
    {"6.1", "6.48", "eta22", 49.2, 16.31},
    {"6.2", "6.51", "mu11", 0.273, {}},
    {"6.2", "6.51", "mu22", 0.293, {}},
    {"6.2", "6.51", "mu13", 229, {}},
    {"6.2", "6.51", "mu23", 1006, {}},
    {"6.2", "6.51", "Gamma_5", 1.651, {}},
    {"6.2", "6.51", "Gamma_6", -0.1351, {}},
    {"6.2", "6.51", "Gamma_12", -0.342, {}},
    {"6.2", "6.51", "w2 Gamma_1 + w1 Gamma_7", -587, {}},
    {"6.2", "6.51", "w2 Gamma_2 + w1 Gamma_9", -111.8e9, {}},
    {"6.2", "6.51", "w2 Gamma_3 + w1 Gamma_8", 353e9, {}},
    {"6.2", "6.51", "w2 Gamma_4 + w1 Gamma_10", 7.77, {}},
};

}  // namespace

std::optional<PrintedValue> printed_value(std::string_view equation, std::string_view name) {
  for (const PrintedValue& value : values)
    if (value.equation == equation && value.name == name) return value;
  return {};
}

}  // namespace secular::app
