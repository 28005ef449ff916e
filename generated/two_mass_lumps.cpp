// Model two_mass_lumps: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)
// Equation of motion: 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) +
// mu13*D(v1)^3 + D2(v1) - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
// Equation of motion: 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 +
// 2*mu22*D(v2) + mu23*D(v2)^3 + D2(v2)
// Case additive_combination: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that
// resonance for small amplitudes; what is left out is of order eps^2.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass_lumps
#include "generated/two_mass_lumps.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass_lumps {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {0, 1}, {-2, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_10[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_12[] = {{-1, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_1},
  {"mu11", dimension_2},
  {"mu13", dimension_3},
  {"lambda", dimension_4},
  {"alpha1", dimension_5},
  {"kappa", dimension_6},
  {"p", dimension_7},
  {"q1", dimension_8},
  {"mu22", dimension_9},
  {"mu23", dimension_10},
  {"alpha2", dimension_11},
  {"q2", dimension_12},
};
constexpr double nominal[] = {77.85, 209.35, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-1, -1, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr Ratio case_0_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_2[] = {{0, 1}, {0, 1}, {-2, 1}, {-2, 1}};
constexpr Ratio case_0_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_0_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_5[] = {{1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_0_lump_6[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_7[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_8[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_0_lump_9[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_10[] = {{-1, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu11", "mu11", case_0_lump_0},
  {"lambda", "lambda", case_0_lump_1},
  {"kappa", "kappa", case_0_lump_2},
  {"mu13", "mu13", case_0_lump_3},
  {"alpha1", "alpha1", case_0_lump_4},
  {"q1", "q1", case_0_lump_5},
  {"p", "p", case_0_lump_6},
  {"mu22", "mu22", case_0_lump_7},
  {"mu23", "mu23", case_0_lump_8},
  {"alpha2", "alpha2", case_0_lump_9},
  {"q2", "q2", case_0_lump_10},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6};
constexpr int case_0_block_1_lumps[] = {6, 7, 8, 9, 10};
constexpr int case_0_block_2_lumps[] = {2, 5, 6};
constexpr int case_0_block_2_phase[] = {0, 1, 1};
constexpr int case_0_block_3_lumps[] = {2};
constexpr int case_0_block_3_phase[] = {1, 0, 2};
constexpr int case_0_block_4_lumps[] = {3, 4};
constexpr int case_0_block_4_phase[] = {3, 0, 0};
constexpr int case_0_block_5_lumps[] = {8, 9};
constexpr int case_0_block_5_phase[] = {0, 3, 0};
constexpr int case_0_block_6_lumps[] = {6, 10};
constexpr int case_0_block_6_phase[] = {1, 0, 1};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_0_block_0_lumps, column_function<additive_combination::columns_0, 2, 1, 7>, column_slope_function<additive_combination::column_slopes_0, 2, 1, 7>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_0_block_1_lumps, column_function<additive_combination::columns_1, 2, 1, 5>, column_slope_function<additive_combination::column_slopes_1, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<additive_combination::columns_2, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_2, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 1, case_0_block_3_phase, case_0_block_3_lumps, column_function<additive_combination::columns_3, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_3, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 1, case_0_block_4_phase, case_0_block_4_lumps, column_function<additive_combination::columns_4, 2, 1, 2>, column_slope_function<additive_combination::column_slopes_4, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 1, case_0_block_5_phase, case_0_block_5_lumps, column_function<additive_combination::columns_5, 2, 1, 2>, column_slope_function<additive_combination::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, case_0_block_6_phase, case_0_block_6_lumps, column_function<additive_combination::columns_6, 2, 1, 2>, column_slope_function<additive_combination::column_slopes_6, 2, 1, 2>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "additive_combination",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = additive_combination::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = additive_combination::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<additive_combination::modulation<double>>,
    .modulation_jacobian = jacobian_function<additive_combination::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass_lumps",
  .source = "S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)",
  .fingerprint = "4500730079e6e7c2",
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

}  // namespace secular::generated::two_mass_lumps
