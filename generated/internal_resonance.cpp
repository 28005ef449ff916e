// Model internal_resonance: generated code, never edited by hand.
// Source: Two coupled modes with a potential of fourth degree
// Equation of motion: 0 = omega1^2*x + 2*a2*x*y + b3*x*y^2 + a1*x^2 + 3*b2*x^2*y + b1*x^3 + 2*mu1*D(x) + D2(x)
// + a3*y^2 + b4*y^3 - e1*F*cos(Omega*t)
// Equation of motion: 0 = 2*a3*x*y + 3*b4*x*y^2 + a2*x^2 + b3*x^2*y + b2*x^3 + omega2^2*y + a4*y^2 + b5*y^3 +
// 2*mu2*D(y) + D2(y) - e2*F*cos(Omega*t)
// Case one_to_one: omega2 = omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2.
// Valid near that resonance for small amplitudes; what is left out is of order eps^3.
// Case one_to_two: omega2 = 2*omega1 + eps*sigma1; Omega = omega2 + eps*sigma2, multiple scales to eps^2. Valid
// near that resonance for small amplitudes; what is left out is of order eps^3.
// Case one_to_three: omega2 = 3*omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2.
// Valid near that resonance for small amplitudes; what is left out is of order eps^3.
// Case free_one_to_two: omega2 = 2*omega1 + eps*sigma1, multiple scales to eps^2. Valid near that resonance for
// small amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate internal_resonance
#include "generated/internal_resonance.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::internal_resonance {

namespace {

constexpr std::string_view coordinates[] = {"x", "y"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{1, 1}, {-3, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_10[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_12[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_13[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_14[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_1},
  {"a1", dimension_2},
  {"a2", dimension_3},
  {"a3", dimension_4},
  {"a4", dimension_5},
  {"b1", dimension_6},
  {"b2", dimension_7},
  {"b3", dimension_8},
  {"b4", dimension_9},
  {"b5", dimension_10},
  {"mu1", dimension_11},
  {"e1", dimension_12},
  {"mu2", dimension_13},
  {"e2", dimension_14},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-1, 1, 0, -1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr Ratio case_0_lump_0[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_4[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_5[] = {{1, 1}, {-3, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_6[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_8[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_9[] = {{1, 1}, {-3, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_10[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_11[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_12[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_13[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_14[] = {{1, 1}, {-3, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_15[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_16[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_17[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_21[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_22[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_23[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"conservative_x_A_x2_conjA_y", "(9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2)) - 2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_0},
  {"mu1", "mu1", case_0_lump_1},
  {"conservative_x_A_x_A_y_conjA_y", "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^3*omega2^2) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) - 4*a2^2/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_2},
  {"conservative_x_A_x2_conjA_x", "(9*omega1^2*b1 - 10*a1^2)/(6*omega1^3) + (-8*omega1^2*a2^2 + 3*omega2^2*a2^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_3},
  {"e1", "e1", case_0_lump_4},
  {"conservative_x_A_y2_conjA_y", "(9*omega2^2*b4 - 10*a3*a4)/(6*omega1*omega2^2) + (-3*omega1^2*a2*a3 + 8*omega2^2*a2*a3)/(omega1^3*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_5},
  {"conservative_x_A_x_A_y_conjA_x", "3*b2/omega1 + (-2*omega1^2*a2*a3 + 12*omega2^2*a2*a3)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a1*a2 + 2*omega2^2*a1*a2)/(omega1^3*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_6},
  {"conservative_x_A_y2_conjA_x", "(3*omega2^2*b3 + 2*a2*a4)/(6*omega1*omega2^2) + 2*a3^2/(omega1^2*(omega1 - 2*omega2)) - 2*a2^2/(omega1*omega2*(2*omega1 - omega2)) - a1*a3/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_7},
  {"conservative_y_A_x2_conjA_y", "(3*omega1^2*b3 + 2*a1*a3)/(6*omega1^2*omega2) + 2*a3^2/(omega1*omega2*(omega1 - 2*omega2)) - 2*a2^2/(omega2^2*(2*omega1 - omega2)) + a2*a4/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_8},
  {"conservative_y_A_x_A_y_conjA_y", "3*b4/omega2 + (-2*omega1^2*a3*a4 + 12*omega2^2*a3*a4)/(omega2^3*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a2*a3 + 2*omega2^2*a2*a3)/(omega1^2*omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_9},
  {"conservative_y_A_x2_conjA_x", "(9*omega1^2*b2 - 10*a1*a2)/(6*omega1^2*omega2) + (-8*omega1^2*a2*a3 + 3*omega2^2*a2*a3)/(omega2^3*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_10},
  {"e2", "e2", case_0_lump_11},
  {"mu2", "mu2", case_0_lump_12},
  {"conservative_y_A_y2_conjA_y", "(9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 + 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_13},
  {"conservative_y_A_y2_conjA_x", "(9*omega2^2*b4 + 2*a3*a4)/(6*omega2^3) + 2*a3*a4/(omega1*omega2*(omega1 - 2*omega2)) - 2*a2*a3/(omega2^2*(2*omega1 - omega2)) - a2*a3/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_14},
  {"a2", "a2", case_0_lump_15},
  {"a3", "a3", case_0_lump_16},
  {"a1", "a1", case_0_lump_17},
  {"harmonic_re_x_A_y3", "(-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_x_A_x_A_y2", "(3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) + a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x2_A_y", "3*b2/((omega1 + omega2)*(3*omega1 + omega2)) + (12*omega1^2*a1*a2 + 4*omega1*omega2*a1*a2 + 2*omega2^2*a1*a2)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (18*omega1^2*a2*a3 + 4*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3", "(3*omega1^2*b1 + 2*a1^2)/(24*omega1^4) + a2^2/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_21},
  {"a4", "a4", case_0_lump_22},
  {"harmonic_re_y_A_y3", "(3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_23},
  {"harmonic_re_y_A_x_A_y2", "3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 + 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x2_A_y", "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 + omega2)) + a3^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + a2*a4/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + 2*a2*a3/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr int case_0_block_1_lumps[] = {2, 8, 9, 10, 11, 12, 13, 14};
constexpr int case_0_block_2_lumps[] = {15, 16, 17};
constexpr int case_0_block_2_phase[] = {0, 0, 0};
constexpr int case_0_block_3_lumps[] = {15, 16, 17};
constexpr int case_0_block_3_phase[] = {0, 2, 0};
constexpr int case_0_block_4_lumps[] = {18, 19, 20, 21};
constexpr int case_0_block_4_phase[] = {0, 3, 0};
constexpr int case_0_block_5_lumps[] = {15, 16, 22};
constexpr int case_0_block_5_phase[] = {0, 0, 0};
constexpr int case_0_block_6_lumps[] = {15, 16, 22};
constexpr int case_0_block_6_phase[] = {0, 2, 0};
constexpr int case_0_block_7_lumps[] = {23, 24, 25, 26};
constexpr int case_0_block_7_phase[] = {0, 3, 0};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_0_block_0_lumps, column_function<one_to_one::columns_0, 2, 1, 8>, column_slope_function<one_to_one::column_slopes_0, 2, 1, 8>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_0_block_1_lumps, column_function<one_to_one::columns_1, 2, 1, 8>, column_slope_function<one_to_one::column_slopes_1, 2, 1, 8>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<one_to_one::columns_2, 2, 1, 3>, column_slope_function<one_to_one::column_slopes_2, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, case_0_block_3_phase, case_0_block_3_lumps, column_function<one_to_one::columns_3, 2, 1, 3>, column_slope_function<one_to_one::column_slopes_3, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, case_0_block_4_phase, case_0_block_4_lumps, column_function<one_to_one::columns_4, 2, 1, 4>, column_slope_function<one_to_one::column_slopes_4, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, case_0_block_5_phase, case_0_block_5_lumps, column_function<one_to_one::columns_5, 2, 1, 3>, column_slope_function<one_to_one::column_slopes_5, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, case_0_block_6_phase, case_0_block_6_lumps, column_function<one_to_one::columns_6, 2, 1, 3>, column_slope_function<one_to_one::column_slopes_6, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, case_0_block_7_phase, case_0_block_7_lumps, column_function<one_to_one::columns_7, 2, 1, 4>, column_slope_function<one_to_one::column_slopes_7, 2, 1, 4>},
};

constexpr int case_1_relations[] = {-2, 1, 0, 0, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {0, 1}, {1, 2}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_4[] = {{0, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_5[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_6[] = {{0, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_7[] = {{0, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_8[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_9[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_10[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_12[] = {{0, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_13[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_14[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_15[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_18[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_22[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_34[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_37[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_38[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_39[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_1_lump_42[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu1", "mu1", case_1_lump_0},
  {"conservative_x_A_x", "-mu1^2/(2*omega1)", case_1_lump_1},
  {"conservative_x_A_x_A_y_conjA_y", "(2*omega1^2*omega2^2*b3 - 4*omega1^2*a2*a4 - 4*omega2^2*a1*a3 + omega2^2*a2^2)/(2*omega1^3*omega2^2) + 2*a2^2/(omega1*omega2*(2*omega1 + omega2)) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_2},
  {"conservative_x_A_x2_conjA_x", "(18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 - 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)", case_1_lump_3},
  {"dissipative_x_A_y_conjA_x", "a2*mu2/(2*omega1^2)", case_1_lump_4},
  {"a2", "a2", case_1_lump_5},
  {"conservative_x_conjA_x_F", "a2*e2/(8*omega1^2*omega2) + a1*e1/(2*omega1*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_6},
  {"dissipative_y_A_x2", "(2*a2*mu1 - a2*mu2)/(4*omega2^2)", case_1_lump_7},
  {"mu2", "mu2", case_1_lump_8},
  {"conservative_y_A_y", "-mu2^2/(2*omega2)", case_1_lump_9},
  {"conservative_y_A_y2_conjA_y", "(9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 + 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_10},
  {"conservative_y_A_x_A_y_conjA_x", "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^2*omega2^3) + (2*omega1*a2^2 - omega2*a2^2)/(2*omega1*omega2^2*(2*omega1 + omega2)) + 4*a3^2/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_11},
  {"dissipative_y_F", "mu2*e2/(8*omega2^2)", case_1_lump_12},
  {"e2", "e2", case_1_lump_13},
  {"a3", "a3", case_1_lump_14},
  {"a1", "a1", case_1_lump_15},
  {"harmonic_re_x_A_y_conjA_x2", "(9*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + 4*a2*a3/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_x_conjA_y_F", "-a2*e1/(omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"e1", "e1", case_1_lump_18},
  {"harmonic_im_x_F", "-omega2*mu1*e1/((omega1 + omega2)^2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_y", "(-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (6*omega1^2*a2*a3 - 16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x", "-6*b2/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a1*a2 + 8*omega1*omega2*a1*a2 + 4*omega2^2*a1*a2)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_x_A_x2", "-4*a1*mu1/(9*omega1^3)", case_1_lump_22},
  {"harmonic_re_x_A_x2_A_y", "-4*a2*a3/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_im_x_A_y2", "(4*omega2*a3*mu1 - 8*omega2*a3*mu2)/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_x_A_y_F", "2*a3*e2/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_x", "(-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) - a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_F", "a1*e1/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3", "(-2*omega1*a2^2 - 2*omega2*a2^2)/(omega2^3*(2*omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_y3", "(-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_x_A_x_A_y2", "(3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) + a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_y_A_y_conjA_x", "(4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_y_A_x_A_y_conjA_y", "6*b4/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 - 8*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x2_conjA_x", "(9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 - 10*omega2^2*a1*a2)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"a4", "a4", case_1_lump_34},
  {"harmonic_re_y_A_y_conjA_x2", "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) + a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_conjA_y_F", "-a3*e1/(omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x2_A_y", "-4*a2*a4/(9*omega2^4)", case_1_lump_37},
  {"harmonic_im_y_A_y2", "-4*a4*mu2/(9*omega2^3)", case_1_lump_38},
  {"harmonic_re_y_A_y_F", "2*a4*e2/(9*omega2^4)", case_1_lump_39},
  {"harmonic_re_y_A_y2_conjA_x", "3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 - 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) - 2*a2*a3/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y3", "(3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_42},
  {"harmonic_re_y_A_x_A_y2", "3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 + 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6};
constexpr int case_1_block_1_lumps[] = {5, 7, 8, 9, 10, 11, 12, 13};
constexpr int case_1_block_2_lumps[] = {14, 15, 16, 17};
constexpr int case_1_block_2_phase[] = {0, 0, 0};
constexpr int case_1_block_3_lumps[] = {15, 18, 19, 20, 21, 22};
constexpr int case_1_block_3_phase[] = {0, 0, 1};
constexpr int case_1_block_4_lumps[] = {14, 17, 23, 24, 25};
constexpr int case_1_block_4_phase[] = {0, 1, 1};
constexpr int case_1_block_5_lumps[] = {4, 5, 26, 27, 28};
constexpr int case_1_block_5_phase[] = {1, 0, 1};
constexpr int case_1_block_6_lumps[] = {29};
constexpr int case_1_block_6_phase[] = {0, 3, 0};
constexpr int case_1_block_7_lumps[] = {30};
constexpr int case_1_block_7_phase[] = {1, 2, 0};
constexpr int case_1_block_8_lumps[] = {14, 17, 23, 25, 31, 32, 33};
constexpr int case_1_block_8_phase[] = {1, 0, 0};
constexpr int case_1_block_9_lumps[] = {5, 34, 35, 36};
constexpr int case_1_block_9_phase[] = {0, 0, 0};
constexpr int case_1_block_10_lumps[] = {34, 36, 37, 38, 39};
constexpr int case_1_block_10_phase[] = {0, 1, 1};
constexpr int case_1_block_11_lumps[] = {14, 17, 23, 25, 31, 40, 41};
constexpr int case_1_block_11_phase[] = {1, 0, 1};
constexpr int case_1_block_12_lumps[] = {42};
constexpr int case_1_block_12_phase[] = {0, 3, 0};
constexpr int case_1_block_13_lumps[] = {43};
constexpr int case_1_block_13_phase[] = {1, 2, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_1_block_0_lumps, column_function<one_to_two::columns_0, 2, 1, 7>, column_slope_function<one_to_two::column_slopes_0, 2, 1, 7>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_1_block_1_lumps, column_function<one_to_two::columns_1, 2, 1, 8>, column_slope_function<one_to_two::column_slopes_1, 2, 1, 8>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<one_to_two::columns_2, 2, 1, 4>, column_slope_function<one_to_two::column_slopes_2, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 1, case_1_block_3_phase, case_1_block_3_lumps, column_function<one_to_two::columns_3, 2, 1, 6>, column_slope_function<one_to_two::column_slopes_3, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, case_1_block_4_phase, case_1_block_4_lumps, column_function<one_to_two::columns_4, 2, 1, 5>, column_slope_function<one_to_two::column_slopes_4, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic omega1+Omega of x", 0, 1, case_1_block_5_phase, case_1_block_5_lumps, column_function<one_to_two::columns_5, 2, 1, 5>, column_slope_function<one_to_two::column_slopes_5, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, case_1_block_6_phase, case_1_block_6_lumps, column_function<one_to_two::columns_6, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, case_1_block_7_phase, case_1_block_7_lumps, column_function<one_to_two::columns_7, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_7, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1 of y", 1, 1, case_1_block_8_phase, case_1_block_8_lumps, column_function<one_to_two::columns_8, 2, 1, 7>, column_slope_function<one_to_two::column_slopes_8, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, case_1_block_9_phase, case_1_block_9_lumps, column_function<one_to_two::columns_9, 2, 1, 4>, column_slope_function<one_to_two::column_slopes_9, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega2+Omega of y", 1, 1, case_1_block_10_phase, case_1_block_10_lumps, column_function<one_to_two::columns_10, 2, 1, 5>, column_slope_function<one_to_two::column_slopes_10, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, case_1_block_11_phase, case_1_block_11_lumps, column_function<one_to_two::columns_11, 2, 1, 7>, column_slope_function<one_to_two::column_slopes_11, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, case_1_block_12_phase, case_1_block_12_lumps, column_function<one_to_two::columns_12, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, case_1_block_13_phase, case_1_block_13_lumps, column_function<one_to_two::columns_13, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_13, 2, 1, 1>},
};

constexpr int case_2_relations[] = {-3, 1, 0, -1, 0, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {3, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr Ratio case_2_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_1[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_2[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_3[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_4[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_5[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_6[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_8[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_9[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_10[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_15[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_18[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_20[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_25[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_2_lumps[] = {
  {"mu1", "mu1", case_2_lump_0},
  {"conservative_x_A_x_A_y_conjA_y", "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^3*omega2^2) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) - 4*a2^2/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_1},
  {"conservative_x_A_x2_conjA_x", "(9*omega1^2*b1 - 10*a1^2)/(6*omega1^3) + (-8*omega1^2*a2^2 + 3*omega2^2*a2^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_2},
  {"e1", "e1", case_2_lump_3},
  {"conservative_x_A_y_conjA_x2", "(9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2)) - 2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_4},
  {"conservative_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(6*omega1^2*omega2) + a2*a3/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_5},
  {"mu2", "mu2", case_2_lump_6},
  {"conservative_y_A_y2_conjA_y", "(9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 + 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_2_lump_7},
  {"a2", "a2", case_2_lump_8},
  {"a1", "a1", case_2_lump_9},
  {"a3", "a3", case_2_lump_10},
  {"harmonic_re_x_A_y2_conjA_x", "(-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) - a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a2^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x2_A_y", "3*b2/((omega1 + omega2)*(3*omega1 + omega2)) + (12*omega1^2*a1*a2 + 4*omega1*omega2*a1*a2 + 2*omega2^2*a1*a2)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (18*omega1^2*a2*a3 + 4*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_x_A_y2_conjA_y", "(-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (6*omega1^2*a2*a3 - 16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x", "-6*b2/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (24*omega1^2*a1*a2 - 4*omega2^2*a1*a2)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_x_A_x3", "(3*omega1^2*b1 + 2*a1^2)/(24*omega1^4) + a2^2/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_15},
  {"harmonic_re_x_A_y3", "(-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_x_A_x_A_y2", "(3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) + a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"a4", "a4", case_2_lump_18},
  {"harmonic_re_y_A_y_conjA_x2", "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) + a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - a2^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + a2*a4/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"e2", "e2", case_2_lump_20},
  {"harmonic_re_y_A_x_A_y_conjA_y", "6*b4/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^2*a2*a3 + 4*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x2_conjA_x", "(9*omega1^2*b2 - 10*a1*a2)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-16*omega1^2*a2*a3 + 6*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y2_conjA_x", "3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 - 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 + 18*omega2^2*a2*a3)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x2_A_y", "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 + omega2)) + a3^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + a2*a4/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y3", "(3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_2_lump_25},
  {"harmonic_re_y_A_x_A_y2", "3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 + 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
};
constexpr int case_2_block_0_lumps[] = {0, 1, 2, 3, 4};
constexpr int case_2_block_1_lumps[] = {1, 5, 6, 7};
constexpr int case_2_block_2_lumps[] = {8, 9};
constexpr int case_2_block_2_phase[] = {-1, 1, 0};
constexpr int case_2_block_3_lumps[] = {9, 10};
constexpr int case_2_block_3_phase[] = {0, 0, 0};
constexpr int case_2_block_4_lumps[] = {10};
constexpr int case_2_block_4_phase[] = {0, 2, 0};
constexpr int case_2_block_5_lumps[] = {8};
constexpr int case_2_block_5_phase[] = {1, 1, 0};
constexpr int case_2_block_6_lumps[] = {11, 12};
constexpr int case_2_block_6_phase[] = {-1, 2, 0};
constexpr int case_2_block_7_lumps[] = {13, 14, 15};
constexpr int case_2_block_7_phase[] = {0, 1, 0};
constexpr int case_2_block_8_lumps[] = {16};
constexpr int case_2_block_8_phase[] = {0, 3, 0};
constexpr int case_2_block_9_lumps[] = {17};
constexpr int case_2_block_9_phase[] = {1, 2, 0};
constexpr int case_2_block_10_lumps[] = {8, 10};
constexpr int case_2_block_10_phase[] = {-1, 1, 0};
constexpr int case_2_block_11_lumps[] = {8, 18};
constexpr int case_2_block_11_phase[] = {0, 0, 0};
constexpr int case_2_block_12_lumps[] = {18};
constexpr int case_2_block_12_phase[] = {0, 2, 0};
constexpr int case_2_block_13_lumps[] = {10};
constexpr int case_2_block_13_phase[] = {1, 1, 0};
constexpr int case_2_block_14_lumps[] = {19, 20, 21, 22};
constexpr int case_2_block_14_phase[] = {0, 0, 1};
constexpr int case_2_block_15_lumps[] = {23, 24};
constexpr int case_2_block_15_phase[] = {-1, 2, 0};
constexpr int case_2_block_16_lumps[] = {25};
constexpr int case_2_block_16_phase[] = {0, 3, 0};
constexpr int case_2_block_17_lumps[] = {26};
constexpr int case_2_block_17_phase[] = {1, 2, 0};
constexpr RegressorBlock case_2_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_2_block_0_lumps, column_function<one_to_three::columns_0, 2, 1, 5>, column_slope_function<one_to_three::column_slopes_0, 2, 1, 5>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_2_block_1_lumps, column_function<one_to_three::columns_1, 2, 1, 4>, column_slope_function<one_to_three::column_slopes_1, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of x", 0, 1, case_2_block_2_phase, case_2_block_2_lumps, column_function<one_to_three::columns_2, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_2, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_2_block_3_phase, case_2_block_3_lumps, column_function<one_to_three::columns_3, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_3, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, case_2_block_4_phase, case_2_block_4_lumps, column_function<one_to_three::columns_4, 2, 1, 1>, column_slope_function<one_to_three::column_slopes_4, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of x", 0, 1, case_2_block_5_phase, case_2_block_5_lumps, column_function<one_to_three::columns_5, 2, 1, 1>, column_slope_function<one_to_three::column_slopes_5, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 2, case_2_block_6_phase, case_2_block_6_lumps, column_function<one_to_three::columns_6, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_6, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2 of x", 0, 2, case_2_block_7_phase, case_2_block_7_lumps, column_function<one_to_three::columns_7, 2, 1, 3>, column_slope_function<one_to_three::column_slopes_7, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, case_2_block_8_phase, case_2_block_8_lumps, column_function<one_to_two::columns_6, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, case_2_block_9_phase, case_2_block_9_lumps, column_function<one_to_two::columns_7, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_7, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of y", 1, 1, case_2_block_10_phase, case_2_block_10_lumps, column_function<one_to_three::columns_10, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_10, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, case_2_block_11_phase, case_2_block_11_lumps, column_function<one_to_three::columns_11, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_11, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, case_2_block_12_phase, case_2_block_12_lumps, column_function<one_to_three::columns_12, 2, 1, 1>, column_slope_function<one_to_three::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of y", 1, 1, case_2_block_13_phase, case_2_block_13_lumps, column_function<one_to_three::columns_13, 2, 1, 1>, column_slope_function<one_to_three::column_slopes_13, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic Omega of y", 1, 2, case_2_block_14_phase, case_2_block_14_lumps, column_function<one_to_three::columns_14, 2, 1, 4>, column_slope_function<one_to_three::column_slopes_14, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of y", 1, 2, case_2_block_15_phase, case_2_block_15_lumps, column_function<one_to_three::columns_15, 2, 1, 2>, column_slope_function<one_to_three::column_slopes_15, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, case_2_block_16_phase, case_2_block_16_lumps, column_function<one_to_two::columns_12, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, case_2_block_17_phase, case_2_block_17_lumps, column_function<one_to_two::columns_13, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_13, 2, 1, 1>},
};

constexpr int case_3_relations[] = {-2, 1, 0};
constexpr Ratio case_3_observed_frequency[] = {{0, 1}, {1, 2}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_3_mode_at_rest[] = {false, false};
constexpr Ratio case_3_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_4[] = {{0, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_5[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_6[] = {{0, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_7[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_8[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_9[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_10[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_11[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_12[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_20[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_26[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_28[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_29[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_32[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_3_lumps[] = {
  {"mu1", "mu1", case_3_lump_0},
  {"conservative_x_A_x", "-mu1^2/(2*omega1)", case_3_lump_1},
  {"conservative_x_A_x_A_y_conjA_y", "(2*omega1^2*omega2^2*b3 - 4*omega1^2*a2*a4 - 4*omega2^2*a1*a3 + omega2^2*a2^2)/(2*omega1^3*omega2^2) + 2*a2^2/(omega1*omega2*(2*omega1 + omega2)) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_2},
  {"conservative_x_A_x2_conjA_x", "(18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 - 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)", case_3_lump_3},
  {"dissipative_x_A_y_conjA_x", "a2*mu2/(2*omega1^2)", case_3_lump_4},
  {"a2", "a2", case_3_lump_5},
  {"dissipative_y_A_x2", "(2*a2*mu1 - a2*mu2)/(4*omega2^2)", case_3_lump_6},
  {"mu2", "mu2", case_3_lump_7},
  {"conservative_y_A_y", "-mu2^2/(2*omega2)", case_3_lump_8},
  {"conservative_y_A_y2_conjA_y", "(9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 + 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_9},
  {"conservative_y_A_x_A_y_conjA_x", "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^2*omega2^3) + (2*omega1*a2^2 - omega2*a2^2)/(2*omega1*omega2^2*(2*omega1 + omega2)) + 4*a3^2/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_10},
  {"a3", "a3", case_3_lump_11},
  {"a1", "a1", case_3_lump_12},
  {"harmonic_re_x_A_y_conjA_x2", "(9*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + 4*a2*a3/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_x_A_x2_A_y", "-4*a2*a3/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_im_x_A_y2", "(4*omega2*a3*mu1 - 8*omega2*a3*mu2)/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_x", "(-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) - a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x3", "(-2*omega1*a2^2 - 2*omega2*a2^2)/(omega2^3*(2*omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_y", "(-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (6*omega1^2*a2*a3 - 16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x", "-6*b2/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a1*a2 + 8*omega1*omega2*a1*a2 + 4*omega2^2*a1*a2)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_x_A_x2", "-4*a1*mu1/(9*omega1^3)", case_3_lump_20},
  {"harmonic_re_x_A_y3", "(-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_x_A_x_A_y2", "(3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) + a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_y_A_y_conjA_x", "(4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_y_A_x_A_y_conjA_y", "6*b4/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 - 8*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x2_conjA_x", "(9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 - 10*omega2^2*a1*a2)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"a4", "a4", case_3_lump_26},
  {"harmonic_re_y_A_y_conjA_x2", "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) + a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x2_A_y", "-4*a2*a4/(9*omega2^4)", case_3_lump_28},
  {"harmonic_im_y_A_y2", "-4*a4*mu2/(9*omega2^3)", case_3_lump_29},
  {"harmonic_re_y_A_y2_conjA_x", "3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 - 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) - 2*a2*a3/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y3", "(3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_32},
  {"harmonic_re_y_A_x_A_y2", "3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 + 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
};
constexpr int case_3_block_0_lumps[] = {0, 1, 2, 3, 4, 5};
constexpr int case_3_block_1_lumps[] = {5, 6, 7, 8, 9, 10};
constexpr int case_3_block_2_lumps[] = {11, 12, 13};
constexpr int case_3_block_2_phase[] = {0, 0, 0};
constexpr int case_3_block_3_lumps[] = {11, 14, 15};
constexpr int case_3_block_3_phase[] = {0, 2, 0};
constexpr int case_3_block_4_lumps[] = {4, 5, 16, 17};
constexpr int case_3_block_4_phase[] = {1, 1, 0};
constexpr int case_3_block_5_lumps[] = {12, 18, 19, 20};
constexpr int case_3_block_5_phase[] = {0, 1, 0};
constexpr int case_3_block_6_lumps[] = {21};
constexpr int case_3_block_6_phase[] = {0, 3, 0};
constexpr int case_3_block_7_lumps[] = {22};
constexpr int case_3_block_7_phase[] = {1, 2, 0};
constexpr int case_3_block_8_lumps[] = {11, 14, 23, 24, 25};
constexpr int case_3_block_8_phase[] = {1, 0, 0};
constexpr int case_3_block_9_lumps[] = {5, 26, 27};
constexpr int case_3_block_9_phase[] = {0, 0, 0};
constexpr int case_3_block_10_lumps[] = {26, 28, 29};
constexpr int case_3_block_10_phase[] = {0, 2, 0};
constexpr int case_3_block_11_lumps[] = {11, 14, 23, 30, 31};
constexpr int case_3_block_11_phase[] = {1, 1, 0};
constexpr int case_3_block_12_lumps[] = {32};
constexpr int case_3_block_12_phase[] = {0, 3, 0};
constexpr int case_3_block_13_lumps[] = {33};
constexpr int case_3_block_13_phase[] = {1, 2, 0};
constexpr RegressorBlock case_3_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_3_block_0_lumps, column_function<free_one_to_two::columns_0, 2, 1, 6>, column_slope_function<free_one_to_two::column_slopes_0, 2, 1, 6>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_3_block_1_lumps, column_function<free_one_to_two::columns_1, 2, 1, 6>, column_slope_function<free_one_to_two::column_slopes_1, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_3_block_2_phase, case_3_block_2_lumps, column_function<free_one_to_two::columns_2, 2, 1, 3>, column_slope_function<free_one_to_two::column_slopes_2, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, case_3_block_3_phase, case_3_block_3_lumps, column_function<free_one_to_two::columns_3, 2, 1, 3>, column_slope_function<free_one_to_two::column_slopes_3, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of x", 0, 1, case_3_block_4_phase, case_3_block_4_lumps, column_function<free_one_to_two::columns_4, 2, 1, 4>, column_slope_function<free_one_to_two::column_slopes_4, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega2 of x", 0, 1, case_3_block_5_phase, case_3_block_5_lumps, column_function<free_one_to_two::columns_5, 2, 1, 4>, column_slope_function<free_one_to_two::column_slopes_5, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, case_3_block_6_phase, case_3_block_6_lumps, column_function<one_to_two::columns_6, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, case_3_block_7_phase, case_3_block_7_lumps, column_function<one_to_two::columns_7, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_7, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1 of y", 1, 1, case_3_block_8_phase, case_3_block_8_lumps, column_function<free_one_to_two::columns_8, 2, 1, 5>, column_slope_function<free_one_to_two::column_slopes_8, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, case_3_block_9_phase, case_3_block_9_lumps, column_function<free_one_to_two::columns_9, 2, 1, 3>, column_slope_function<free_one_to_two::column_slopes_9, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, case_3_block_10_phase, case_3_block_10_lumps, column_function<free_one_to_two::columns_10, 2, 1, 3>, column_slope_function<free_one_to_two::column_slopes_10, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of y", 1, 1, case_3_block_11_phase, case_3_block_11_lumps, column_function<free_one_to_two::columns_11, 2, 1, 5>, column_slope_function<free_one_to_two::column_slopes_11, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, case_3_block_12_phase, case_3_block_12_lumps, column_function<one_to_two::columns_12, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, case_3_block_13_phase, case_3_block_13_lumps, column_function<one_to_two::columns_13, 2, 1, 1>, column_slope_function<one_to_two::column_slopes_13, 2, 1, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "one_to_one",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = one_to_one::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = one_to_one::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<one_to_one::modulation<double>>,
    .modulation_jacobian = jacobian_function<one_to_one::modulation_jacobian<double>>,
  },
  {
    .name = "one_to_two",
    .excited = true,
    .relations = case_1_relations,
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = one_to_two::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = one_to_two::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<one_to_two::modulation<double>>,
    .modulation_jacobian = jacobian_function<one_to_two::modulation_jacobian<double>>,
  },
  {
    .name = "one_to_three",
    .excited = true,
    .relations = case_2_relations,
    .observed_frequency = case_2_observed_frequency,
    .mode_at_rest = case_2_mode_at_rest,
    .lumps = case_2_lumps,
    .blocks = case_2_blocks,
    .evaluate_lumps = one_to_three::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = one_to_three::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<one_to_three::modulation<double>>,
    .modulation_jacobian = jacobian_function<one_to_three::modulation_jacobian<double>>,
  },
  {
    .name = "free_one_to_two",
    .excited = false,
    .relations = case_3_relations,
    .observed_frequency = case_3_observed_frequency,
    .mode_at_rest = case_3_mode_at_rest,
    .lumps = case_3_lumps,
    .blocks = case_3_blocks,
    .evaluate_lumps = free_one_to_two::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free_one_to_two::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free_one_to_two::modulation<double>>,
    .modulation_jacobian = jacobian_function<free_one_to_two::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "internal_resonance",
  .source = "Two coupled modes with a potential of fourth degree",
  .fingerprint = "6ceeab7e703755f6",
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

}  // namespace secular::generated::internal_resonance
