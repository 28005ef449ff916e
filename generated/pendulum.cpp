// Model pendulum: generated code, never edited by hand.
// Holds tables. Made by: secular generate pendulum.
#include "pendulum.free.hpp"
#include "pendulum.lump-gradients.hpp"
#include "pendulum.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::pendulum {

namespace {

constexpr std::string_view coordinates[] = {"theta"};
constexpr Ratio dimension_0[] = {{0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{-4, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{-1, 1}, {0, 1}};
constexpr Ratio dimension_4[] = {{1, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-4, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"alpha3", dimension_1},
  {"alpha5", dimension_2},
  {"mu1", dimension_0},
  {"mu2", dimension_3},
  {"fc", dimension_4},
};
constexpr double nominal[] = {5.77, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"fc", "fc", dimension_4},
  {"mu1", "mu1", dimension_0},
  {"mu2", "mu2", dimension_3},
  {"alpha3", "alpha3", dimension_1},
  {"beta5", "(16*omega0^2*alpha5 - 3*alpha3^2)/(16*omega0^2)", dimension_2},
  {"harmonic_re_theta_A_theta4_conjA_theta", "(40*omega0^2*alpha5 - 21*alpha3^2)/(64*omega0^4)", dimension_5},
  {"harmonic_re_theta_A_theta5", "(8*omega0^2*alpha5 + 3*alpha3^2)/(192*omega0^4)", dimension_5},
};

// Case free.
constexpr Ratio case_0_observed_frequency[] = {{1, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of theta", 0, 0, 5},
  {BlockKind::harmonic, "harmonic 3*omega0 of theta", 0, 1, 4},
  {BlockKind::harmonic, "harmonic 5*omega0 of theta", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 7*omega0 of theta", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 9*omega0 of theta", 0, 2, 2},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 0, 2, 3, 5, 0, 2, 6, 0, 2, 0, 2};
constexpr int case_0_phases[] = {3, 5, 7, 9};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, free::blocks, case_0_block_lumps,
    case_0_phases, 1);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, free::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("free", false, {}, case_0_lumps, case_0),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "pendulum",
  .source = "Rigid pendulum; damping laws as in A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, section 3.3",
  .fingerprint = "d85d6c19f128eeb3",
  .coordinates = coordinates,
  .excitations = {},
  .excitation_frequencies = {},
  .symbols = symbols,
  .nominal = nominal,
  .cases = cases,
  .mass_matrix = mass_matrix<double>,
  .acceleration = accelerations<double>,
  .acceleration_of_lanes = accelerations<Lanes>,
  .acceleration_by_state = acceleration_by_state<double>,
  .acceleration_by_parameters = acceleration_by_parameters<double>,
};

}  // namespace secular::generated::pendulum
