// Model parametric_pair: generated code, never edited by hand.
// Holds tables. Made by: secular generate parametric_pair.
#include "parametric_pair.additive.hpp"
#include "parametric_pair.additive_second_order.hpp"
#include "parametric_pair.difference.hpp"
#include "parametric_pair.lump-gradients.hpp"
#include "parametric_pair.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::parametric_pair {

namespace {

constexpr std::string_view coordinates[] = {"x", "y"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{-1, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_9[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_10[] = {{-2, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_11[] = {{-4, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_12[] = {{1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_13[] = {{1, 1}, {-3, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_14[] = {{-1, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_15[] = {{-3, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_16[] = {{-2, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_17[] = {{0, 1}, {-4, 1}, {0, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"mu1", dimension_0},
  {"b1", dimension_1},
  {"b3", dimension_2},
  {"p", dimension_3},
  {"mu2", dimension_0},
  {"b5", dimension_2},
  {"q", dimension_4},
};
constexpr double nominal[] = {1, 2.7, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu1", "mu1", dimension_0},
  {"b3", "b3", dimension_2},
  {"b1", "b1", dimension_1},
  {"p", "p", dimension_3},
  {"mu2", "mu2", dimension_0},
  {"b5", "b5", dimension_2},
  {"q", "q", dimension_4},
  {"conservative_x_A_x2_A_y_F", "(-2*omega1*b3*q - 3*omega2*b1*p)/(16*omega1^3*omega2) - b3*p/(16*omega1^2*(omega1 + omega2))", dimension_5},
  {"conservative_x_A_x", "-mu1^2/(2*omega1)", dimension_0},
  {"conservative_x_A_x_F2", "(omega1*p*q + 2*omega2*p*q)/(32*omega1^2*omega2*(omega1 + omega2))", dimension_6},
  {"dissipative_x_A_x_A_y_conjA_y", "b3*mu2/omega1^2", dimension_7},
  {"conservative_x_A_x_A_y2_conjA_y2", "(-3*omega1^2*b3^2 + 2*omega2^2*b3^2)/(4*omega1^3*(omega1 + omega2)*(omega1 - omega2))", dimension_8},
  {"dissipative_x_A_x2_conjA_x", "3*mu1*b1/(2*omega1^2)", dimension_9},
  {"conservative_x_A_x2_A_y_conjA_x_conjA_y", "-3*b1*b3/(2*omega1^3) + b3^2/(2*omega1*(omega1 + omega2)*(omega1 - omega2))", dimension_10},
  {"conservative_x_A_x3_conjA_x2", "-15*b1^2/(16*omega1^3)", dimension_11},
  {"dissipative_x_conjA_y_F", "(mu1*p - p*mu2)/(8*omega1^2)", dimension_12},
  {"conservative_x_A_y_conjA_y2_F", "(-3*omega1*p*b5 + 2*omega2*b3*p)/(16*omega1^3*omega2) - b3*p/(16*omega1*omega2*(omega1 + omega2))", dimension_13},
  {"conservative_x_A_x_conjA_x_conjA_y_F", "(-omega1*b3*p + 3*omega2*b1*p)/(8*omega1^3*omega2) + b3*q/(8*omega1*omega2*(omega1 + omega2))", dimension_5},
  {"conservative_y_A_x_A_y2_F", "(-3*omega1*b5*q - 2*omega2*b3*p)/(16*omega1*omega2^3) - b3*q/(16*omega2^2*(omega1 + omega2))", dimension_5},
  {"conservative_y_A_y", "-mu2^2/(2*omega2)", dimension_0},
  {"dissipative_y_A_y2_conjA_y", "3*mu2*b5/(2*omega2^2)", dimension_7},
  {"conservative_y_A_y3_conjA_y2", "-15*b5^2/(16*omega2^3)", dimension_8},
  {"dissipative_y_A_x_A_y_conjA_x", "mu1*b3/omega2^2", dimension_7},
  {"conservative_y_A_x_A_y2_conjA_x_conjA_y", "-3*b3*b5/(2*omega2^3) - b3^2/(2*omega2*(omega1 + omega2)*(omega1 - omega2))", dimension_8},
  {"dissipative_y_conjA_x_F", "(-mu1*q + mu2*q)/(8*omega2^2)", dimension_14},
  {"conservative_y_A_y_conjA_x_conjA_y_F", "(3*omega1*b5*q - omega2*b3*q)/(8*omega1*omega2^3) + b3*p/(8*omega1*omega2*(omega1 + omega2))", dimension_5},
  {"conservative_y_A_x_conjA_x2_F", "(2*omega1*b3*q - 3*omega2*b1*q)/(16*omega1*omega2^3) - b3*q/(16*omega1*omega2*(omega1 + omega2))", dimension_15},
  {"harmonic_re_x_A_y_conjA_x2_F", "b3*p/(32*omega1*omega2*(omega1 - omega2)^2) + 3*b1*p/(32*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_y3_F", "(omega1*b3*p - 2*omega2*b3*p)/(32*omega1*omega2^2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y3_conjA_x_conjA_y", "(5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 + 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y2_conjA_x2",
   "(2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 - omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 - omega2)^2) + "
   "(6*omega1*b1*b3 + 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_y_F", "(3*omega1*p*b5 - 2*omega2*b3*p + 6*omega2*p*b5)/(32*omega2^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x_F",
   "(omega1^2*b3*p - 3*omega1*omega2*b1*p + 2*omega1*omega2*b3*p - omega2^2*b3*q)/(16*omega1*omega2^3*(omega1 + "
   "omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y3_conjA_y", "(-5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 - 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_x2_A_y2_conjA_x",
   "(-2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 + omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 + omega2)^2) + "
   "(-6*omega1*b1*b3 + 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_x2_conjA_y_F", "-b3*q/(32*omega1^3*(omega1 + omega2)) - b3*p/(64*omega1^3*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_x3_A_y_conjA_y", "-b1*b3/(4*omega1^4) + b3^2/(8*omega1^2*(omega1 + omega2)*(omega1 - omega2))", dimension_16},
  {"harmonic_re_x_A_y2_conjA_x3",
   "(-6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 - "
   "omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 - omega2)^2*(2*omega1 - omega2))", {}},
  {"harmonic_re_x_A_y4_conjA_x", "-b3*b5/(32*omega2^3*(omega1 - 2*omega2)) + b3^2/(32*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y4", "b3*b5/(32*omega2^3*(omega1 + 2*omega2)) + b3^2/(32*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2))", {}},
  {"harmonic_re_x_A_x2_A_y_F", "(-3*omega1*b1*p - omega2*b3*p - 2*omega2*b3*q)/(32*omega1*omega2*(omega1 + omega2)^2*(2*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3_A_y2",
   "(6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 + omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 "
   "+ omega2)^2*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_conjA_x3_F", "-b1*q/(64*omega1^3*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_y2_conjA_x2_conjA_y",
   "(-omega1^2*b3^2 - 4*omega1*omega2*b3^2 + 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 - omega2)^2) + "
   "(3*omega1*b3*b5 + 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)", {}},
  {"harmonic_re_y_A_x_A_y_conjA_x3", "(4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 + 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_y_A_y2_conjA_x_F", "b3*q/(32*omega1*omega2*(omega1 - omega2)^2) - 3*b5*q/(32*omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x_A_y3_conjA_x", "-b3*b5/(4*omega2^4) - b3^2/(8*omega2^2*(omega1 + omega2)*(omega1 - omega2))", dimension_17},
  {"harmonic_re_y_A_x_A_y_conjA_y_F",
   "(-omega1^2*b3*p + 2*omega1*omega2*b3*q - 3*omega1*omega2*b5*q + omega2^2*b3*q)/(16*omega1^3*omega2*(omega1 + "
   "omega2)^2)", {}},
  {"harmonic_re_y_A_x2_conjA_x_F", "(6*omega1*b1*q - 2*omega1*b3*q + 3*omega2*b1*q)/(32*omega1^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_y_A_x2_A_y2_conjA_y",
   "(omega1^2*b3^2 - 4*omega1*omega2*b3^2 - 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 + omega2)^2) + "
   "(-3*omega1*b3*b5 + 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x3_A_y_conjA_x", "(-4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 - 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 + omega2)^2)", {}},
  {"harmonic_re_y_A_y3_conjA_x2",
   "(omega1^2*b3*b5 - 4*omega1*omega2*b3^2 - omega1*omega2*b3*b5 + 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 "
   "- omega2)^2*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x_A_y2_F", "(-2*omega1*b3*p - omega1*b3*q - 3*omega2*b5*q)/(32*omega1*omega2*(omega1 + omega2)^2*(omega1 + 2*omega2))", {}},
  {"harmonic_re_y_A_x2_A_y3",
   "(omega1^2*b3*b5 + 4*omega1*omega2*b3^2 + omega1*omega2*b3*b5 + 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 "
   "+ omega2)^2*(omega1 + 2*omega2))", {}},
  {"harmonic_re_y_A_x3_F", "-b1*q/(128*omega1^3*(2*omega1 + omega2)) - b3*q/(64*omega1^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x4_A_y", "b1*b3/(32*omega1^3*(2*omega1 + omega2)) + b3^2/(32*omega1^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x4_conjA_y", "b1*b3/(32*omega1^3*(2*omega1 - omega2)) + b3^2/(32*omega1^2*(omega1 - omega2)*(2*omega1 - omega2))", {}},
};

// Case additive.
constexpr int case_0_relations[] = {-1, -1, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 4},
  {BlockKind::modulation, "modulation of y", 1, 0, 4},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of y", 1, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, 2},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 1, 4, 5, 6, 1, 1, 3, 2, 1, 5, 1, 6};
constexpr int case_0_phases[] = {-1, 2, 0, 0, 1, 1, 3, 0, 0, -2, 1, 0, 0, 3, 0, 1, 0, 1};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, additive::blocks, case_0_block_lumps,
    case_0_phases, 3);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, additive::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case additive_second_order.
constexpr int case_1_relations[] = {-1, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr int case_1_lump_numbers[] = {7, 0, 8, 9, 10, 1, 11, 12, 2, 13, 14, 15, 3, 16, 17, 18, 4, 19, 20, 5, 21,
    22, 23, 24, 6, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48,
    49, 50, 51, 52, 53, 54, 55, 56};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 15},
  {BlockKind::modulation, "modulation of y", 1, 0, 15},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 1, 6},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, 10},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, 5},
  {BlockKind::harmonic, "harmonic -3*omega1+2*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+4*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2+Omega of x", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of x", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 5*omega1 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of y", 1, 1, 7},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, 5},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, 10},
  {BlockKind::harmonic, "harmonic -2*omega1+3*omega2 of y", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of y", 1, 2, 3},
  {BlockKind::harmonic, "harmonic 5*omega2 of y", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1+Omega of y", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 4*omega1-omega2 of y", 1, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 3, 5, 6, 15, 16, 17, 18,
    19, 20, 21, 22, 23, 24, 25, 26, 4, 5, 27, 28, 29, 30, 3, 4, 5, 11, 12, 28, 31, 32, 33, 34, 7, 8, 10, 35, 36,
    37, 38, 28, 39, 3, 40, 41, 10, 5, 21, 28, 42, 43, 44, 45, 18, 19, 20, 45, 46, 3, 5, 21, 23, 24, 28, 47, 48,
    49, 50, 51, 3, 52, 53, 20, 54, 55, 56};
constexpr int case_1_phases[] = {-1, 2, 0, 0, 1, 1, 3, 0, 0, -3, 2, 0, -1, 4, 0, 0, 3, 1, 1, 0, 2, 5, 0, 0, -2, 1,
    0, 0, 3, 0, 1, 0, 1, -2, 3, 0, 0, 1, 2, 0, 5, 0, 3, 0, 1, 4, -1, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, additive_second_order::blocks,
    case_1_block_lumps, case_1_phases, 3);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, additive_second_order::blocks,
    case_1_blocks, case_1_observed_frequency, case_1_mode_at_rest};

// Case difference.
constexpr int case_2_relations[] = {1, -1, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {1, 1}, {-1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr int case_2_lump_numbers[] = {3, 0, 1, 2, 4, 5, 6};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 4},
  {BlockKind::modulation, "modulation of y", 1, 0, 4},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -omega1+Omega of y", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of y", 1, 1, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 3, 2, 4, 5, 6, 0, 2, 2, 3, 2, 6, 5, 2};
constexpr int case_2_phases[] = {0, 1, 1, 1, 2, 0, 3, 0, 0, -1, 0, 1, 0, 3, 0, 2, 1, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, difference::blocks, case_2_block_lumps,
    case_2_phases, 3);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, difference::blocks, case_2_blocks,
    case_2_observed_frequency, case_2_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("additive", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("additive_second_order", true, case_1_relations, case_1_lumps, case_1),
  compiled_case("difference", true, case_2_relations, case_2_lumps, case_2),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "parametric_pair",
  .source = "Two linear modes with parametric coupling and cubic stiffness",
  .fingerprint = "7977a3cae5fa7333",
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

}  // namespace secular::generated::parametric_pair
