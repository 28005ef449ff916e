// Model van_der_pol: generated code, never edited by hand.
// Source: B. van der Pol, Philosophical Magazine 2, 978 (1926)
// Equation of motion: 0 = omega0^2*x + mu*x^2*D(x) - mu*D(x) + D2(x)
// Case free: no resonance, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case free_third_order: no resonance, multiple scales to eps^3. Valid near that resonance for small
// amplitudes; what is left out is of order eps^4.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate van_der_pol
#include "generated/van_der_pol.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::van_der_pol {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr Ratio dimension_0[] = {{0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_1},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr Ratio case_0_observed_frequency[] = {{1, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr Ratio case_0_lump_0[] = {{-2, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{-4, 1}, {-1, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu", "mu", case_0_lump_0},
  {"conservative_x_A_x", "-mu^2/(8*omega0)", case_0_lump_1},
};
constexpr int case_0_block_0_lumps[] = {0, 1};
constexpr int case_0_block_1_lumps[] = {0, 1};
constexpr int case_0_block_1_phase[] = {3};
constexpr int case_0_block_2_lumps[] = {1};
constexpr int case_0_block_2_phase[] = {5};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_0_block_0_lumps, column_function<free::columns_0, 1, 0, 2>, column_slope_function<free::column_slopes_0, 1, 0, 2>},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, case_0_block_1_phase, case_0_block_1_lumps, column_function<free::columns_1, 1, 0, 2>, column_slope_function<free::column_slopes_1, 1, 0, 2>},
  {BlockKind::harmonic, "harmonic 5*omega0 of x", 0, 2, case_0_block_2_phase, case_0_block_2_lumps, column_function<free::columns_2, 1, 0, 1>, column_slope_function<free::column_slopes_2, 1, 0, 1>},
};

constexpr Ratio case_1_observed_frequency[] = {{1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr Ratio case_1_lump_0[] = {{-2, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{-4, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{-6, 1}, {-1, 1}};
constexpr Ratio case_1_lump_3[] = {{-6, 1}, {-1, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu", "mu", case_1_lump_0},
  {"conservative_x_A_x", "-mu^2/(8*omega0)", case_1_lump_1},
  {"dissipative_x_A_x2_conjA_x", "(-2*omega0^2*mu - mu^3)/(4*omega0^2)", case_1_lump_2},
  {"dissipative_x_A_x3_conjA_x2", "35*mu^3/(64*omega0^2)", case_1_lump_3},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_1_block_1_lumps[] = {0, 1, 3};
constexpr int case_1_block_1_phase[] = {3};
constexpr int case_1_block_2_lumps[] = {1, 3};
constexpr int case_1_block_2_phase[] = {5};
constexpr int case_1_block_3_lumps[] = {3};
constexpr int case_1_block_3_phase[] = {7};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_1_block_0_lumps, column_function<free_third_order::columns_0, 1, 0, 4>, column_slope_function<free_third_order::column_slopes_0, 1, 0, 4>},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, case_1_block_1_phase, case_1_block_1_lumps, column_function<free_third_order::columns_1, 1, 0, 3>, column_slope_function<free_third_order::column_slopes_1, 1, 0, 3>},
  {BlockKind::harmonic, "harmonic 5*omega0 of x", 0, 2, case_1_block_2_phase, case_1_block_2_lumps, column_function<free_third_order::columns_2, 1, 0, 2>, column_slope_function<free_third_order::column_slopes_2, 1, 0, 2>},
  {BlockKind::harmonic, "harmonic 7*omega0 of x", 0, 3, case_1_block_3_phase, case_1_block_3_lumps, column_function<free_third_order::columns_3, 1, 0, 1>, column_slope_function<free_third_order::column_slopes_3, 1, 0, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "free",
    .excited = true,
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
  {
    .name = "free_third_order",
    .excited = true,
    .relations = {},
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = free_third_order::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free_third_order::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free_third_order::modulation<double>>,
    .modulation_jacobian = jacobian_function<free_third_order::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "van_der_pol",
  .source = "B. van der Pol, Philosophical Magazine 2, 978 (1926)",
  .fingerprint = "63ba806d60fd9151",
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

}  // namespace secular::generated::van_der_pol
