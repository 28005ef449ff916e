// Model two_mass_mode1: generated code, never edited by hand.
// Holds tables. Made by: secular generate two_mass_mode1.
#include "two_mass_mode1.principal_parametric.hpp"
#include "two_mass_mode1.free.hpp"
#include "two_mass_mode1.primary.hpp"
#include "two_mass_mode1.lump-gradients.hpp"
#include "two_mass_mode1.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass_mode1 {

namespace {

constexpr std::string_view coordinates[] = {"v"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_2[] = {{-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_3[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_6[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_9[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_10[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_11[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu1", dimension_0},
  {"mu2", dimension_1},
  {"mu3", dimension_2},
  {"alpha2", dimension_3},
  {"alpha3", dimension_4},
  {"delta2", dimension_1},
  {"delta3", dimension_5},
  {"eta1", dimension_6},
  {"eta2", dimension_7},
};
constexpr double nominal[] = {77.85, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu1", "mu1", dimension_0},
  {"mu2", "mu2", dimension_1},
  {"mu3", "mu3", dimension_2},
  {"alpha_e",
   "(6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3 - "
   "10*alpha2^2)/(24*omega0^2)", dimension_4},
  {"eta_e", "(-6*omega0^2*delta2*eta1 + 3*omega0^2*eta2 + 2*alpha2*eta1)/(12*omega0^2)", dimension_7},
  {"alpha_0", "-omega0^2*delta2 + alpha2", dimension_3},
  {"eta1", "eta1", dimension_6},
  {"alpha_q", "-3*omega0^2*delta2 + alpha2", dimension_3},
  {"harmonic_re_v_A_v_F", "(14*omega0^2*delta2*eta1 - 3*omega0^2*eta2 - 2*alpha2*eta1)/(48*omega0^4)", dimension_8},
  {"harmonic_re_v_A_v3",
   "(42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 + 3*omega0^2*alpha3 + "
   "2*alpha2^2)/(24*omega0^4)", dimension_5},
  {"conservative_v_A_v2_F", "(-3*omega0^2*delta2*eta2 + 5*alpha2*eta2)/(12*omega0^3)", dimension_9},
  {"conservative_v_A_v_F2", "-eta2^2/(12*omega0^3)", dimension_10},
  {"eta2", "eta2", dimension_7},
  {"harmonic_re_v_A_v2_F", "(17*omega0^2*delta2*eta2 - 3*alpha2*eta2)/(48*omega0^4)", dimension_11},
};

// Case principal_parametric.
constexpr int case_0_relations[] = {-2, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {1, 2}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, 5},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, 1},
  {BlockKind::harmonic, "harmonic Omega of v", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega0+Omega of v", 0, 2, 4},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, 1},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 1, 2, 8, 9, 1, 1, 1};
constexpr int case_0_phases[] = {0, 0, 0, 1, 1, 1, 5, 0, 7, 0, 9, 0};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, principal_parametric::blocks,
    case_0_block_lumps, case_0_phases, 2);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, principal_parametric::blocks,
    case_0_blocks, case_0_observed_frequency, case_0_mode_at_rest};

// Case free.
constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr int case_1_lump_numbers[] = {0, 1, 2, 3, 5, 7, 9};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, 4},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega0 of v", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega0 of v", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 4, 5, 1, 2, 6, 1, 1, 1};
constexpr int case_1_phases[] = {0, 0, 2, 0, 3, 0, 5, 0, 7, 0, 9, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, free::blocks, case_1_block_lumps,
    case_1_phases, 2);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, free::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

// Case primary.
constexpr int case_2_relations[] = {-1, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_2_mode_at_rest[] = {false};
constexpr int case_2_lump_numbers[] = {10, 0, 11, 1, 2, 3, 6, 12, 5, 7, 13, 9};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, 7},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega0+Omega of v", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of v", 0, 2, 5},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 7, 9, 2, 3, 4, 10, 11, 3, 3, 3};
constexpr int case_2_phases[] = {0, 0, 1, 1, 1, 2, 5, 0, 7, 0, 9, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, primary::blocks, case_2_block_lumps,
    case_2_phases, 2);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, primary::blocks, case_2_blocks,
    case_2_observed_frequency, case_2_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("principal_parametric", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("free", false, {}, case_1_lumps, case_1),
  compiled_case("primary", true, case_2_relations, case_2_lumps, case_2),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass_mode1",
  .source = "S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (5.1)-(5.5)",
  .fingerprint = "a3346d9e677791b0",
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

}  // namespace secular::generated::two_mass_mode1
