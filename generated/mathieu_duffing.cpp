// Model mathieu_duffing: generated code, never edited by hand.
// Source: E. Mathieu, Journal de Mathematiques 13, 137 (1868), with a cubic term
// Equation of motion: 0 = omega0^2*x + h*x*F*cos(Omega*t) + a3*x^3 + 2*mu*D(x) + D2(x)
// Case principal: Omega = 2*omega0 + eps*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case fundamental: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate mathieu_duffing
#include "generated/mathieu_duffing.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::mathieu_duffing {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_1},
  {"a3", dimension_2},
  {"h", dimension_3},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-2, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {1, 2}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr Ratio case_0_lump_0[] = {{-2, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_2[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_3[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_0_lump_4[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_5[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_6[] = {{-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_7[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"conservative_x_A_x3_F", "7*a3*h/(32*omega0^3)", case_0_lump_0},
  {"mu", "mu", case_0_lump_1},
  {"conservative_x_A_x", "-mu^2/(2*omega0)", case_0_lump_2},
  {"conservative_x_A_x_F2", "3*h^2/(64*omega0^3)", case_0_lump_3},
  {"dissipative_x_A_x2_conjA_x", "3*mu*a3/(2*omega0^2)", case_0_lump_4},
  {"a3", "a3", case_0_lump_5},
  {"conservative_x_A_x3_conjA_x2", "-15*a3^2/(16*omega0^3)", case_0_lump_6},
  {"h", "h", case_0_lump_7},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr int case_0_block_1_lumps[] = {0, 3, 4, 5, 6, 7};
constexpr int case_0_block_1_phase[] = {1, 1};
constexpr int case_0_block_2_lumps[] = {0, 3, 6};
constexpr int case_0_block_2_phase[] = {1, 2};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_0_block_0_lumps, column_function<principal::columns_0, 1, 1, 8>, column_slope_function<principal::column_slopes_0, 1, 1, 8>},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, case_0_block_1_phase, case_0_block_1_lumps, column_function<principal::columns_1, 1, 1, 6>, column_slope_function<principal::column_slopes_1, 1, 1, 6>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 2, case_0_block_2_phase, case_0_block_2_lumps, column_function<principal::columns_2, 1, 1, 3>, column_slope_function<principal::column_slopes_2, 1, 1, 3>},
};

constexpr int case_1_relations[] = {-1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_3[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu", "mu", case_1_lump_0},
  {"conservative_x_A_x_F2", "-h^2/(12*omega0^3)", case_1_lump_1},
  {"a3", "a3", case_1_lump_2},
  {"h", "h", case_1_lump_3},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2};
constexpr int case_1_block_1_lumps[] = {3};
constexpr int case_1_block_1_phase[] = {0, 0};
constexpr int case_1_block_2_lumps[] = {3};
constexpr int case_1_block_2_phase[] = {1, 1};
constexpr int case_1_block_3_lumps[] = {1, 2};
constexpr int case_1_block_3_phase[] = {1, 2};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_1_block_0_lumps, column_function<fundamental::columns_0, 1, 1, 3>, column_slope_function<fundamental::column_slopes_0, 1, 1, 3>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_1_block_1_phase, case_1_block_1_lumps, column_function<fundamental::columns_1, 1, 1, 1>, column_slope_function<fundamental::column_slopes_1, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<fundamental::columns_2, 1, 1, 1>, column_slope_function<fundamental::column_slopes_2, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 2, case_1_block_3_phase, case_1_block_3_lumps, column_function<fundamental::columns_3, 1, 1, 2>, column_slope_function<fundamental::column_slopes_3, 1, 1, 2>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "principal",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = principal::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = principal::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<principal::modulation<double>>,
    .modulation_jacobian = jacobian_function<principal::modulation_jacobian<double>>,
  },
  {
    .name = "fundamental",
    .excited = true,
    .relations = case_1_relations,
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = fundamental::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = fundamental::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<fundamental::modulation<double>>,
    .modulation_jacobian = jacobian_function<fundamental::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "mathieu_duffing",
  .source = "E. Mathieu, Journal de Mathematiques 13, 137 (1868), with a cubic term",
  .fingerprint = "fa7c337e55458ed5",
  .coordinates = coordinates,
  .excitations = excitations,
  .excitation_frequencies = excitation_frequencies,
  .symbols = symbols,
  .nominal = nominal,
  .cases = cases,
  .mass_matrix = mass_matrix<double>,
  .acceleration = accelerations<double>,
  .acceleration_of_lanes = accelerations<Lanes>,
  .acceleration_by_state = acceleration_by_state<double>,
  .acceleration_by_parameters = acceleration_by_parameters<double>,
};

}  // namespace secular::generated::mathieu_duffing
