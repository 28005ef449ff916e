// Model mathieu_duffing: generated code, never edited by hand.
// Holds tables. Made by: secular generate mathieu_duffing.
#include "mathieu_duffing.principal.hpp"
#include "mathieu_duffing.fundamental.hpp"
#include "mathieu_duffing.lump-gradients.hpp"
#include "mathieu_duffing.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::mathieu_duffing {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_5[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_6[] = {{-4, 1}, {0, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_0},
  {"a3", dimension_1},
  {"h", dimension_2},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"conservative_x_A_x3_F", "7*a3*h/(32*omega0^3)", dimension_3},
  {"mu", "mu", dimension_0},
  {"conservative_x_A_x", "-mu^2/(2*omega0)", dimension_0},
  {"conservative_x_A_x_F2", "3*h^2/(64*omega0^3)", dimension_4},
  {"dissipative_x_A_x2_conjA_x", "3*mu*a3/(2*omega0^2)", dimension_5},
  {"a3", "a3", dimension_1},
  {"conservative_x_A_x3_conjA_x2", "-15*a3^2/(16*omega0^3)", dimension_6},
  {"h", "h", dimension_2},
  {"conservative_x_A_x_F2", "-h^2/(12*omega0^3)", dimension_4},
};

// Case principal.
constexpr int case_0_relations[] = {-2, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {1, 2}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 8},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, 6},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 2, 3},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 3, 4, 5, 6, 7, 0, 3, 6};
constexpr int case_0_phases[] = {1, 1, 1, 2};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, principal::blocks, case_0_block_lumps,
    case_0_phases, 2);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, principal::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case fundamental.
constexpr int case_1_relations[] = {-1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr int case_1_lump_numbers[] = {1, 8, 5, 7};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 3},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 2, 2},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 3, 1, 2};
constexpr int case_1_phases[] = {0, 0, 1, 1, 1, 2};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, fundamental::blocks, case_1_block_lumps,
    case_1_phases, 2);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, fundamental::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("principal", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("fundamental", true, case_1_relations, case_1_lumps, case_1),
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
