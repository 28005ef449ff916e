// Model pendulum: generated code, never edited by hand.
// Source: Rigid pendulum; damping laws as in A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, section 3.3
// Equation of motion: 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) +
// mu2*D(theta)*abs(D(theta)) + D2(theta) + fc*sgn(D(theta))
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate pendulum
#include "generated/pendulum.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::pendulum {

namespace {

constexpr std::string_view coordinates[] = {"theta"};
constexpr Ratio dimension_0[] = {{0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{-4, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{0, 1}, {-1, 1}};
constexpr Ratio dimension_4[] = {{-1, 1}, {0, 1}};
constexpr Ratio dimension_5[] = {{1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"alpha3", dimension_1},
  {"alpha5", dimension_2},
  {"mu1", dimension_3},
  {"mu2", dimension_4},
  {"fc", dimension_5},
};
constexpr double nominal[] = {5.77, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr Ratio case_0_observed_frequency[] = {{1, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr Ratio case_0_lump_0[] = {{1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_2[] = {{-1, 1}, {0, 1}};
constexpr Ratio case_0_lump_3[] = {{-2, 1}, {-2, 1}};
constexpr Ratio case_0_lump_4[] = {{-4, 1}, {-2, 1}};
constexpr Ratio case_0_lump_5[] = {{-4, 1}, {0, 1}};
constexpr Ratio case_0_lump_6[] = {{-4, 1}, {0, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"fc", "fc", case_0_lump_0},
  {"mu1", "mu1", case_0_lump_1},
  {"mu2", "mu2", case_0_lump_2},
  {"alpha3", "alpha3", case_0_lump_3},
  {"beta5", "(16*omega0^2*alpha5 - 3*alpha3^2)/(16*omega0^2)", case_0_lump_4},
  {"harmonic_re_theta_A_theta4_conjA_theta", "(40*omega0^2*alpha5 - 21*alpha3^2)/(64*omega0^4)", case_0_lump_5},
  {"harmonic_re_theta_A_theta5", "(8*omega0^2*alpha5 + 3*alpha3^2)/(192*omega0^4)", case_0_lump_6},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4};
constexpr int case_0_block_1_lumps[] = {0, 2, 3, 5};
constexpr int case_0_block_1_phase[] = {3};
constexpr int case_0_block_2_lumps[] = {0, 2, 6};
constexpr int case_0_block_2_phase[] = {5};
constexpr int case_0_block_3_lumps[] = {0, 2};
constexpr int case_0_block_3_phase[] = {7};
constexpr int case_0_block_4_lumps[] = {0, 2};
constexpr int case_0_block_4_phase[] = {9};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of theta", 0, 0, {}, case_0_block_0_lumps, column_function<free::columns_0, 1, 0, 5>, column_slope_function<free::column_slopes_0, 1, 0, 5>},
  {BlockKind::harmonic, "harmonic 3*omega0 of theta", 0, 1, case_0_block_1_phase, case_0_block_1_lumps, column_function<free::columns_1, 1, 0, 4>, column_slope_function<free::column_slopes_1, 1, 0, 4>},
  {BlockKind::harmonic, "harmonic 5*omega0 of theta", 0, 2, case_0_block_2_phase, case_0_block_2_lumps, column_function<free::columns_2, 1, 0, 3>, column_slope_function<free::column_slopes_2, 1, 0, 3>},
  {BlockKind::harmonic, "harmonic 7*omega0 of theta", 0, 2, case_0_block_3_phase, case_0_block_3_lumps, column_function<free::columns_3, 1, 0, 2>, column_slope_function<free::column_slopes_3, 1, 0, 2>},
  {BlockKind::harmonic, "harmonic 9*omega0 of theta", 0, 2, case_0_block_4_phase, case_0_block_4_lumps, column_function<free::columns_4, 1, 0, 2>, column_slope_function<free::column_slopes_4, 1, 0, 2>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "free",
    .excited = false,
    .relations = {},
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = free::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free::modulation<double>>,
    .modulation_jacobian = jacobian_function<free::modulation_jacobian<double>>,
  },
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
