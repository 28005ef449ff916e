// Model duffing: generated code, never edited by hand.
// Holds tables. Made by: secular generate duffing.
#include "duffing.free.hpp"
#include "duffing.primary.hpp"
#include "duffing.superharmonic_3.hpp"
#include "duffing.subharmonic_3.hpp"
#include "duffing.subharmonic_3_second_order.hpp"
#include "duffing.lump-gradients.hpp"
#include "duffing.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::duffing {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_5[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_7[] = {{1, 1}, {-3, 1}, {-1, 1}};
constexpr Ratio dimension_8[] = {{1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_9[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_10[] = {{1, 1}, {-2, 1}, {0, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_12[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_13[] = {{1, 1}, {-3, 1}, {0, 1}};
constexpr Ratio dimension_14[] = {{-3, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_15[] = {{0, 1}, {-2, 1}, {0, 1}};
constexpr Ratio dimension_16[] = {{0, 1}, {-4, 1}, {-1, 1}};
constexpr Ratio dimension_17[] = {{-2, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_18[] = {{-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_19[] = {{-1, 1}, {-3, 1}, {-1, 1}};
constexpr Ratio dimension_20[] = {{1, 1}, {-5, 1}, {0, 1}};
constexpr Ratio dimension_21[] = {{-1, 1}, {-2, 1}, {0, 1}};
constexpr Ratio dimension_22[] = {{0, 1}, {-3, 1}, {0, 1}};
constexpr Ratio dimension_23[] = {{-2, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_24[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_25[] = {{-3, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_26[] = {{1, 1}, {-4, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_0},
  {"a2", dimension_1},
  {"a3", dimension_2},
  {"e", dimension_3},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu", "mu", dimension_0},
  {"conservative_x_A_x2_conjA_x", "(9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)", dimension_4},
  {"a2", "a2", dimension_1},
  {"harmonic_re_x_A_x3", "(3*omega0^2*a3 + 2*a2^2)/(24*omega0^4)", dimension_5},
  {"e", "e", dimension_3},
  {"conservative_x_A_x_F2", "243*a3*e^2/(256*omega0^5)", dimension_6},
  {"a3", "a3", dimension_2},
  {"conservative_x_F3", "729*a3*e^3/(8192*omega0^7)", dimension_7},
  {"harmonic_im_x_F", "-27*mu*e/(64*omega0^3)", dimension_8},
  {"harmonic_re_x_A_x_conjA_x_F", "-243*a3*e/(64*omega0^4)", dimension_9},
  {"harmonic_re_x_F2", "-81*a2*e^2/(128*omega0^6)", dimension_10},
  {"harmonic_re_x_A_x_F", "-81*a2*e/(40*omega0^4)", dimension_11},
  {"conservative_x_A_x_F2", "3*a3*e^2/(256*omega0^5)", dimension_6},
  {"conservative_x_conjA_x2_F", "-3*a3*e/(32*omega0^3)", dimension_12},
  {"harmonic_im_x_F", "-3*mu*e/(64*omega0^3)", dimension_8},
  {"harmonic_re_x_F3", "-3*a3*e^3/(32768*omega0^8)", dimension_13},
  {"harmonic_re_x_conjA_x_F", "-a2*e/(24*omega0^4)", dimension_11},
  {"harmonic_re_x_F2", "-a2*e^2/(128*omega0^6)", dimension_10},
  {"conservative_x_A_x4_F", "-3*a3^2*e/(32*omega0^5)", dimension_14},
  {"conservative_x_A_x", "-mu^2/(2*omega0)", dimension_0},
  {"conservative_x_A_x_F2", "(15*omega0^2*a3*e^2 - 6*a2^2*e^2)/(1280*omega0^7)", dimension_6},
  {"conservative_x_A_x_F2_sigma", "-9*a3*e^2/(512*omega0^6)", dimension_15},
  {"conservative_x_A_x_F4", "-63*a3^2*e^4/(2097152*omega0^11)", dimension_16},
  {"dissipative_x_A_x2_conjA_x", "3*mu*a3/(2*omega0^2)", dimension_4},
  {"conservative_x_A_x2_conjA_x_F2", "21*a3^2*e^2/(2048*omega0^7)", dimension_17},
  {"conservative_x_A_x3_conjA_x2", "-15*a3^2/(16*omega0^3)", dimension_18},
  {"dissipative_x_conjA_x2_F", "3*mu*a3*e/(128*omega0^4)", dimension_12},
  {"conservative_x_conjA_x2_F", "(-3*omega0^2*a3*e - 2*a2^2*e)/(32*omega0^5)", dimension_12},
  {"conservative_x_conjA_x2_F_sigma", "15*a3*e/(128*omega0^4)", dimension_9},
  {"conservative_x_conjA_x2_F3", "-27*a3^2*e^3/(32768*omega0^9)", dimension_19},
  {"harmonic_re_x_F", "9*mu^2*e/(256*omega0^4)", dimension_8},
  {"harmonic_im_x_F3", "-9*mu*a3*e^3/(65536*omega0^9)", dimension_13},
  {"harmonic_re_x_F5", "-273*a3^2*e^5/(671088640*omega0^14)", dimension_20},
  {"harmonic_re_x_A_x_conjA_x_F", "3*a2^2*e/(160*omega0^6)", dimension_9},
  {"harmonic_re_x_A_x3", "a2^2/(12*omega0^4)", dimension_5},
  {"harmonic_re_x_A_x2_F2", "a2*a3*e^2/(192*omega0^8)", dimension_21},
  {"harmonic_im_x_conjA_x_F", "-mu*a2*e/(32*omega0^5)", dimension_11},
  {"harmonic_re_x_conjA_x_F3", "-11*a2*a3*e^3/(86016*omega0^10)", dimension_22},
  {"harmonic_re_x_A_x_conjA_x2_F", "a2*a3*e/(480*omega0^6)", dimension_23},
  {"harmonic_im_x_A_x2", "-4*mu*a2/(9*omega0^3)", dimension_24},
  {"harmonic_re_x_A_x3_conjA_x", "-31*a2*a3/(12*omega0^4)", dimension_25},
  {"harmonic_re_x_conjA_x_F2", "73*a2^2*e^2/(322560*omega0^8)", dimension_15},
  {"harmonic_im_x_conjA_x_F2", "3*mu*a3*e^2/(4096*omega0^7)", dimension_15},
  {"harmonic_re_x_F4", "723*a2*a3*e^4/(4587520*omega0^12)", dimension_26},
  {"harmonic_im_x_F2", "129*mu*a2*e^2/(627200*omega0^7)", dimension_10},
};

// Case free.
constexpr Ratio case_0_observed_frequency[] = {{1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 2},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 2, 1},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 2, 3};
constexpr int case_0_phases[] = {0, 0, 2, 0, 3, 0};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, free::blocks, case_0_block_lumps,
    case_0_phases, 2);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, free::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case primary.
constexpr int case_1_relations[] = {-1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr int case_1_lump_numbers[] = {0, 1, 4, 2, 3};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 3},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 3, 4};
constexpr int case_1_phases[] = {0, 0, 2, 0, 3, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, primary::blocks, case_1_block_lumps,
    case_1_phases, 2);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, primary::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

// Case superharmonic_3.
constexpr int case_2_relations[] = {-1, 3};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {3, 1}};
constexpr bool case_2_mode_at_rest[] = {false};
constexpr int case_2_lump_numbers[] = {0, 5, 6, 7, 4, 8, 9, 10, 2, 11};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 4},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, 5},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega0+Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 3, 1, 3, 4, 5, 6, 7, 8, 7, 9, 9, 1, 6, 8, 6, 2};
constexpr int case_2_phases[] = {0, 1, 0, 0, 0, 2, 1, 1, 1, 2, 2, 0, 2, 1, 3, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, superharmonic_3::blocks, case_2_block_lumps,
    case_2_phases, 2);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, superharmonic_3::blocks, case_2_blocks,
    case_2_observed_frequency, case_2_mode_at_rest};

// Case subharmonic_3.
constexpr int case_3_relations[] = {-3, 1};
constexpr Ratio case_3_observed_frequency[] = {{0, 1}, {1, 3}};
constexpr bool case_3_mode_at_rest[] = {false};
constexpr int case_3_lump_numbers[] = {0, 12, 6, 13, 4, 14, 15, 16, 2, 17};
constexpr auto case_3_lumps = chosen_lumps(lump_table, case_3_lump_numbers);
constexpr BlockTable case_3_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 4},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, 5},
  {BlockKind::harmonic, "harmonic -omega0+Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic -omega0+2*Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, 1},
};
constexpr int case_3_block_lumps[] = {0, 1, 2, 3, 2, 3, 4, 5, 6, 7, 8, 1, 3, 8, 9, 9, 6, 7, 1};
constexpr int case_3_phases[] = {0, 1, -1, 1, -1, 2, 0, 0, 0, 2, 0, 3, 1, 1, 1, 2};
constexpr auto case_3_blocks = regressor_blocks(case_3_block_table, subharmonic_3::blocks, case_3_block_lumps,
    case_3_phases, 2);
constexpr GeneratedCase case_3 = {&lump_functions, case_3_lump_numbers, subharmonic_3::blocks, case_3_blocks,
    case_3_observed_frequency, case_3_mode_at_rest};

// Case subharmonic_3_second_order.
constexpr int case_4_relations[] = {-3, 1};
constexpr Ratio case_4_observed_frequency[] = {{0, 1}, {1, 3}};
constexpr bool case_4_mode_at_rest[] = {false};
constexpr int case_4_lump_numbers[] = {18, 0, 19, 20, 21, 22, 23, 1, 24, 25, 26, 27, 28, 29, 4, 14, 15, 6, 30, 31,
    32, 33, 34, 16, 2, 35, 36, 37, 38, 39, 40, 41, 42, 17, 43, 44};
constexpr auto case_4_lumps = chosen_lumps(lump_table, case_4_lump_numbers);
constexpr BlockTable case_4_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 14},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, 15},
  {BlockKind::harmonic, "harmonic -omega0+Omega of x", 0, 1, 8},
  {BlockKind::harmonic, "harmonic -omega0+2*Omega of x", 0, 1, 10},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 6},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, 5},
  {BlockKind::harmonic, "harmonic 3*Omega of x", 0, 1, 5},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, 6},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, 7},
  {BlockKind::harmonic, "harmonic -omega0+3*Omega of x", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega0+4*Omega of x", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 4*Omega of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 5*Omega of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega0+3*Omega of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega0+4*Omega of x", 0, 2, 1},
};
constexpr int case_4_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 0, 6, 8, 9, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 4, 5, 8, 9, 10, 12, 13, 21, 31, 32, 24, 25, 28,
    30, 33, 34, 25, 28, 33, 34, 35, 8, 13, 16, 19, 20, 23, 25, 26, 27, 28, 30, 0, 4, 5, 8, 13, 31, 32, 25, 27, 5,
    13, 34, 20, 27, 5};
constexpr int case_4_phases[] = {0, 1, -1, 1, -1, 2, 0, 0, 0, 2, 0, 3, 1, 1, 1, 2, -1, 3, -1, 4, 0, 4, 0, 5, 1, 3,
    1, 4};
constexpr auto case_4_blocks = regressor_blocks(case_4_block_table, subharmonic_3_second_order::blocks,
    case_4_block_lumps, case_4_phases, 2);
constexpr GeneratedCase case_4 = {&lump_functions, case_4_lump_numbers, subharmonic_3_second_order::blocks,
    case_4_blocks, case_4_observed_frequency, case_4_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("free", false, {}, case_0_lumps, case_0),
  compiled_case("primary", true, case_1_relations, case_1_lumps, case_1),
  compiled_case("superharmonic_3", true, case_2_relations, case_2_lumps, case_2),
  compiled_case("subharmonic_3", true, case_3_relations, case_3_lumps, case_3),
  compiled_case("subharmonic_3_second_order", true, case_4_relations, case_4_lumps, case_4),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "duffing",
  .source = "Duffing oscillator with a quadratic term",
  .fingerprint = "182e356c564d1d03",
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

}  // namespace secular::generated::duffing
