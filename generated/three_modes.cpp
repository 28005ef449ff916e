// Model three_modes: generated code, never edited by hand.
// Source: Generic; the case of S. O'F. Fahey, dissertation, Virginia Tech, 2000, section 3.2.3, with the third
// mode kept
// Equation of motion: 0 = omega1^2*v1 + b1122*v1*v2^2 + 2*a113*v1*v3 + b1133*v1*v3^2 + b1111*v1^3 + 2*mu1*D(v1)
// + D2(v1) + a123*v2*v3 - e12*v2*F*cos(Omega*t) - e1*F*cos(Omega*t)
// Equation of motion: 0 = a123*v1*v3 - e12*v1*F*cos(Omega*t) + b1122*v1^2*v2 + omega2^2*v2 + 2*a223*v2*v3 +
// b2233*v2*v3^2 + b2222*v2^3 + 2*mu2*D(v2) + D2(v2) - e2*F*cos(Omega*t)
// Equation of motion: 0 = a123*v1*v2 + a113*v1^2 + b1133*v1^2*v3 + a223*v2^2 + b2233*v2^2*v3 + omega3^2*v3 +
// a333*v3^2 + 2*mu3*D(v3) + D2(v3) - e3*F*cos(Omega*t)
// Case additive_combination: Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate three_modes
#include "generated/three_modes.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::three_modes {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2", "v3"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_3[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{1, 1}, {-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_10[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_12[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_13[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_14[] = {{1, 1}, {0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_15[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_16[] = {{0, 1}, {1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_17[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_18[] = {{0, 1}, {0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_1},
  {"omega3", dimension_2},
  {"a113", dimension_3},
  {"a123", dimension_4},
  {"a223", dimension_5},
  {"a333", dimension_6},
  {"b1111", dimension_7},
  {"b1122", dimension_8},
  {"b2222", dimension_9},
  {"b1133", dimension_10},
  {"b2233", dimension_11},
  {"e12", dimension_12},
  {"mu1", dimension_13},
  {"e1", dimension_14},
  {"mu2", dimension_15},
  {"e2", dimension_16},
  {"mu3", dimension_17},
  {"e3", dimension_18},
};
constexpr double nominal[] = {78, 209, 340, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-1, -1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {0, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false, true};
constexpr Ratio case_0_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_2[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_3[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_0_lump_4[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_5[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_6[] = {{1, 1}, {0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_12[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_13[] = {{0, 1}, {1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_16[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_18[] = {{1, 1}, {-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_19[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_20[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_21[] = {{0, 1}, {0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu1", "mu1", case_0_lump_0},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(omega3^2*b1122 - 2*a113*a223)/(omega1*omega3^2) + a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a123^2/(2*omega1*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", case_0_lump_1},
  {"conservative_v1_A_v12_conjA_v1", "3*b1111/(2*omega1) + (-8*omega1^2*a113^2 + 3*omega3^2*a113^2)/(omega1*omega3^2*(2*omega1 + omega3)*(2*omega1 - omega3))", case_0_lump_2},
  {"conservative_v1_conjA_v2_F", "-e12/(4*omega1) - a123*e3/(4*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3))", case_0_lump_3},
  {"mu2", "mu2", case_0_lump_4},
  {"conservative_v2_A_v22_conjA_v2", "3*b2222/(2*omega2) + (-8*omega2^2*a223^2 + 3*omega3^2*a223^2)/(omega2*omega3^2*(2*omega2 + omega3)*(2*omega2 - omega3))", case_0_lump_5},
  {"e1", "e1", case_0_lump_6},
  {"harmonic_re_v1_A_v2_conjA_v12", "(9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 + omega2^2*a113*a123 - 3*omega3^2*a113*a123)/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F", "a113*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(8*omega2^2*a123*a223 - 3*omega3^2*a123*a223)/(omega3^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "-b1122/(4*omega2*(omega1 - omega2)) - a123^2/(4*omega2*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) - a113*a223/(2*omega2*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "b1122/(4*omega2*(omega1 + omega2)) + a123^2/(4*omega2*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega2*(omega1 + omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v13", "b1111/(8*omega1^2) + a113^2/(4*omega1^2*(2*omega1 + omega3)*(2*omega1 - omega3))", case_0_lump_12},
  {"e2", "e2", case_0_lump_13},
  {"harmonic_re_v2_A_v2_conjA_v12", "b1122/(4*omega1*(omega1 - omega2)) + a123^2/(4*omega1*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) + a113*a223/(2*omega1*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"harmonic_re_v2_conjA_v2_F", "-a223*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v23", "b2222/(8*omega2^2) + a223^2/(4*omega2^2*(2*omega2 + omega3)*(2*omega2 - omega3))", case_0_lump_16},
  {"harmonic_re_v2_A_v12_A_v2", "b1122/(4*omega1*(omega1 + omega2)) + a123^2/(4*omega1*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega1*(omega1 + omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"a123", "a123", case_0_lump_18},
  {"a223", "a223", case_0_lump_19},
  {"a113", "a113", case_0_lump_20},
  {"e3", "e3", case_0_lump_21},
  {"harmonic_re_v3_conjA_v1_F", "-a123*e2/(2*omega1*(omega1 + 2*omega2)*(omega2 + omega3)*(omega2 - omega3)) - a113*e1/(omega2*(2*omega1 + omega2)*(omega2 + omega3)*(omega2 - omega3))", {}},
  {"harmonic_re_v3_conjA_v2_F", "-a223*e2/(omega1*(omega1 + 2*omega2)*(omega1 + omega3)*(omega1 - omega3)) - a123*e1/(2*omega2*(omega1 + omega3)*(omega1 - omega3)*(2*omega1 + omega2))", {}},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_0_block_1_lumps[] = {1, 3, 4, 5};
constexpr int case_0_block_2_lumps[] = {6};
constexpr int case_0_block_2_phase[] = {0, 0, 0, 1};
constexpr int case_0_block_3_lumps[] = {7};
constexpr int case_0_block_3_phase[] = {-2, 1, 0, 0};
constexpr int case_0_block_4_lumps[] = {7, 8, 9};
constexpr int case_0_block_4_phase[] = {0, 1, 0, 0};
constexpr int case_0_block_5_lumps[] = {10};
constexpr int case_0_block_5_phase[] = {-1, 2, 0, 0};
constexpr int case_0_block_6_lumps[] = {3, 11};
constexpr int case_0_block_6_phase[] = {0, 1, 0, 1};
constexpr int case_0_block_7_lumps[] = {9};
constexpr int case_0_block_7_phase[] = {0, 3, 0, 0};
constexpr int case_0_block_8_lumps[] = {7, 8};
constexpr int case_0_block_8_phase[] = {1, 0, 0, 1};
constexpr int case_0_block_9_lumps[] = {12};
constexpr int case_0_block_9_phase[] = {3, 0, 0, 0};
constexpr int case_0_block_10_lumps[] = {13};
constexpr int case_0_block_10_phase[] = {0, 0, 0, 1};
constexpr int case_0_block_11_lumps[] = {14};
constexpr int case_0_block_11_phase[] = {-2, 1, 0, 0};
constexpr int case_0_block_12_lumps[] = {9};
constexpr int case_0_block_12_phase[] = {-1, 2, 0, 0};
constexpr int case_0_block_13_lumps[] = {7, 9, 15};
constexpr int case_0_block_13_phase[] = {1, 0, 0, 0};
constexpr int case_0_block_14_lumps[] = {9, 15};
constexpr int case_0_block_14_phase[] = {0, 1, 0, 1};
constexpr int case_0_block_15_lumps[] = {16};
constexpr int case_0_block_15_phase[] = {0, 3, 0, 0};
constexpr int case_0_block_16_lumps[] = {3, 17};
constexpr int case_0_block_16_phase[] = {1, 0, 0, 1};
constexpr int case_0_block_17_lumps[] = {7};
constexpr int case_0_block_17_phase[] = {3, 0, 0, 0};
constexpr int case_0_block_18_lumps[] = {18};
constexpr int case_0_block_18_phase[] = {-1, 1, 0, 0};
constexpr int case_0_block_19_lumps[] = {19, 20};
constexpr int case_0_block_19_phase[] = {0, 0, 0, 0};
constexpr int case_0_block_20_lumps[] = {18, 21};
constexpr int case_0_block_20_phase[] = {0, 0, 0, 1};
constexpr int case_0_block_21_lumps[] = {19};
constexpr int case_0_block_21_phase[] = {0, 2, 0, 0};
constexpr int case_0_block_22_lumps[] = {20};
constexpr int case_0_block_22_phase[] = {2, 0, 0, 0};
constexpr int case_0_block_23_lumps[] = {22};
constexpr int case_0_block_23_phase[] = {-1, 0, 0, 1};
constexpr int case_0_block_24_lumps[] = {23};
constexpr int case_0_block_24_phase[] = {0, -1, 0, 1};
constexpr int case_0_block_25_lumps[] = {23};
constexpr int case_0_block_25_phase[] = {0, 1, 0, 1};
constexpr int case_0_block_26_lumps[] = {22};
constexpr int case_0_block_26_phase[] = {1, 0, 0, 1};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_0_block_0_lumps, column_function<additive_combination::columns_0, 3, 1, 4>, column_slope_function<additive_combination::column_slopes_0, 3, 1, 4>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_0_block_1_lumps, column_function<additive_combination::columns_1, 3, 1, 4>, column_slope_function<additive_combination::column_slopes_1, 3, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<additive_combination::columns_2, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_2, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, case_0_block_3_phase, case_0_block_3_lumps, column_function<additive_combination::columns_3, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_3, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, case_0_block_4_phase, case_0_block_4_lumps, column_function<additive_combination::columns_4, 3, 1, 3>, column_slope_function<additive_combination::column_slopes_4, 3, 1, 3>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, case_0_block_5_phase, case_0_block_5_lumps, column_function<additive_combination::columns_5, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_5, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, case_0_block_6_phase, case_0_block_6_lumps, column_function<additive_combination::columns_6, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_6, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_0_block_7_phase, case_0_block_7_lumps, column_function<additive_combination::columns_7, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_7, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, case_0_block_8_phase, case_0_block_8_lumps, column_function<additive_combination::columns_8, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_8, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_0_block_9_phase, case_0_block_9_lumps, column_function<additive_combination::columns_9, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_9, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, case_0_block_10_phase, case_0_block_10_lumps, column_function<additive_combination::columns_10, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_10, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, case_0_block_11_phase, case_0_block_11_lumps, column_function<additive_combination::columns_11, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_11, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, case_0_block_12_phase, case_0_block_12_lumps, column_function<additive_combination::columns_12, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_12, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, case_0_block_13_phase, case_0_block_13_lumps, column_function<additive_combination::columns_13, 3, 1, 3>, column_slope_function<additive_combination::column_slopes_13, 3, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, case_0_block_14_phase, case_0_block_14_lumps, column_function<additive_combination::columns_14, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_14, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_0_block_15_phase, case_0_block_15_lumps, column_function<additive_combination::columns_15, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_15, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, case_0_block_16_phase, case_0_block_16_lumps, column_function<additive_combination::columns_16, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_16, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_0_block_17_phase, case_0_block_17_lumps, column_function<additive_combination::columns_17, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_17, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v3", 2, 1, case_0_block_18_phase, case_0_block_18_lumps, column_function<additive_combination::columns_18, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_18, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 0 of v3", 2, 1, case_0_block_19_phase, case_0_block_19_lumps, column_function<additive_combination::columns_19, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_19, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v3", 2, 1, case_0_block_20_phase, case_0_block_20_lumps, column_function<additive_combination::columns_20, 3, 1, 2>, column_slope_function<additive_combination::column_slopes_20, 3, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v3", 2, 1, case_0_block_21_phase, case_0_block_21_lumps, column_function<additive_combination::columns_21, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_21, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v3", 2, 1, case_0_block_22_phase, case_0_block_22_lumps, column_function<additive_combination::columns_22, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_22, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v3", 2, 2, case_0_block_23_phase, case_0_block_23_lumps, column_function<additive_combination::columns_23, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_23, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega2+Omega of v3", 2, 2, case_0_block_24_phase, case_0_block_24_lumps, column_function<additive_combination::columns_24, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_24, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v3", 2, 2, case_0_block_25_phase, case_0_block_25_lumps, column_function<additive_combination::columns_25, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_25, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v3", 2, 2, case_0_block_26_phase, case_0_block_26_lumps, column_function<additive_combination::columns_26, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_26, 3, 1, 1>},
};

constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false, false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_4[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_5[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_6[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_7[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_8[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_9[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_10[] = {{1, 1}, {-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_20[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_21[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_26[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_30[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu1", "mu1", case_1_lump_0},
  {"conservative_v1_A_v1_A_v3_conjA_v3", "(omega3^2*b1133 - 2*a113*a333)/(omega1*omega3^2) + a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)) + a123^2/(2*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)) - 4*a113^2/(omega1*(2*omega1 + omega3)*(2*omega1 - omega3))", case_1_lump_1},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(omega3^2*b1122 - 2*a113*a223)/(omega1*omega3^2) + a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a123^2/(2*omega1*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", case_1_lump_2},
  {"conservative_v1_A_v12_conjA_v1", "3*b1111/(2*omega1) + (-8*omega1^2*a113^2 + 3*omega3^2*a113^2)/(omega1*omega3^2*(2*omega1 + omega3)*(2*omega1 - omega3))", case_1_lump_3},
  {"mu2", "mu2", case_1_lump_4},
  {"conservative_v2_A_v2_A_v3_conjA_v3", "(omega3^2*b2233 - 2*a223*a333)/(omega2*omega3^2) - a123^2/(2*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)) - a123^2/(2*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)) - 4*a223^2/(omega2*(2*omega2 + omega3)*(2*omega2 - omega3))", case_1_lump_5},
  {"conservative_v2_A_v22_conjA_v2", "3*b2222/(2*omega2) + (-8*omega2^2*a223^2 + 3*omega3^2*a223^2)/(omega2*omega3^2*(2*omega2 + omega3)*(2*omega2 - omega3))", case_1_lump_6},
  {"mu3", "mu3", case_1_lump_7},
  {"conservative_v3_A_v32_conjA_v3", "-5*a333^2/(3*omega3^3)", case_1_lump_8},
  {"a113", "a113", case_1_lump_9},
  {"a123", "a123", case_1_lump_10},
  {"harmonic_re_v1_A_v2_conjA_v12", "(9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 + omega2^2*a113*a123 - 3*omega3^2*a113*a123)/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v32_conjA_v1", "(-3*omega3^2*b1133 - 2*a113*a333)/(12*omega3^3*(omega1 - omega3)) + a113^2/(omega3^2*(omega1 - omega3)*(2*omega1 - omega3)) - a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)*(omega1 - omega3))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "-b1122/(4*omega2*(omega1 - omega2)) - a123^2/(4*omega2*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) - a113*a223/(2*omega2*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v32_conjA_v2", "-a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)) + 2*a123*a223/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega2 - omega3)) + 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 + 2*omega3))", {}},
  {"harmonic_re_v1_A_v2_A_v3_conjA_v3", "2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) + 4*a123*a223/((omega1 + omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3)) + (4*omega1^2*a113*a123 - 4*omega2^2*a113*a123 - 4*omega3^2*a113*a123)/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(8*omega2^2*a123*a223 - 3*omega3^2*a123*a223)/(omega3^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v2_A_v32", "-a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)) - 2*a123*a223/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) + 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - omega3)*(omega1 - omega2 - 2*omega3))", {}},
  {"harmonic_re_v1_A_v1_A_v32", "(3*omega3^2*b1133 + 2*a113*a333)/(12*omega3^3*(omega1 + omega3)) + a113^2/(omega3^2*(omega1 + omega3)*(2*omega1 + omega3)) + a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)*(omega1 + omega3))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "b1122/(4*omega2*(omega1 + omega2)) + a123^2/(4*omega2*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega2*(omega1 + omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v13", "b1111/(8*omega1^2) + a113^2/(4*omega1^2*(2*omega1 + omega3)*(2*omega1 - omega3))", case_1_lump_20},
  {"a223", "a223", case_1_lump_21},
  {"harmonic_re_v2_A_v2_conjA_v12", "b1122/(4*omega1*(omega1 - omega2)) + a123^2/(4*omega1*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) + a113*a223/(2*omega1*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"harmonic_re_v2_A_v32_conjA_v1", "a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)) - 2*a113*a123/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega1 - omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - omega3)*(omega1 - omega2 - 2*omega3))", {}},
  {"harmonic_re_v2_A_v32_conjA_v2", "(-3*omega3^2*b2233 - 2*a223*a333)/(12*omega3^3*(omega2 - omega3)) + a223^2/(omega3^2*(omega2 - omega3)*(2*omega2 - omega3)) + a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega2 - omega3))", {}},
  {"harmonic_re_v2_A_v2_A_v32", "(3*omega3^2*b2233 + 2*a223*a333)/(12*omega3^3*(omega2 + omega3)) + a223^2/(omega3^2*(omega2 + omega3)*(2*omega2 + omega3)) - a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)*(omega2 + omega3))", {}},
  {"harmonic_re_v2_A_v23", "b2222/(8*omega2^2) + a223^2/(4*omega2^2*(2*omega2 + omega3)*(2*omega2 - omega3))", case_1_lump_26},
  {"harmonic_re_v2_A_v1_A_v3_conjA_v3", "-2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) - 4*a113*a123/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3)) + (4*omega1^2*a123*a223 - 4*omega2^2*a123*a223 + 4*omega3^2*a123*a223)/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v2_A_v1_A_v32", "a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)) + 2*a113*a123/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) + 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 + 2*omega3))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "b1122/(4*omega1*(omega1 + omega2)) + a123^2/(4*omega1*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega1*(omega1 + omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"a333", "a333", case_1_lump_30},
  {"harmonic_re_v3_A_v3_conjA_v12", "b1133/(4*omega1*(omega1 - omega3)) - a113^2/(omega1*omega3*(omega1 - omega3)*(2*omega1 - omega3)) + a123^2/(4*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)*(omega1 - omega3)) + a113*a333/(2*omega1*(omega1 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"harmonic_re_v3_A_v3_conjA_v1_conjA_v2", "-2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega1 - omega3)) - 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega2 - omega3)) + 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v2_A_v3_conjA_v1", "-2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega1 - omega3)) + 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) - 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 - omega2 - 2*omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 - omega2 - 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(omega1 - omega2 - 2*omega3))", {}},
  {"harmonic_re_v3_A_v22_conjA_v3", "b2233/(4*omega2*(omega2 - omega3)) - a223^2/(omega2*omega3*(omega2 - omega3)*(2*omega2 - omega3)) - a123^2/(4*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega2 - omega3)) + a223*a333/(2*omega2*(omega2 - omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v22_A_v3", "b2233/(4*omega2*(omega2 + omega3)) + a223^2/(omega2*omega3*(omega2 + omega3)*(2*omega2 + omega3)) - a123^2/(4*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)*(omega2 + omega3)) + a223*a333/(2*omega2*(omega2 + omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v1_A_v3_conjA_v2", "2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) - 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega2 - omega3)) + 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 + 2*omega3)) - 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 + 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 + 2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v1_A_v2_A_v3", "2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega1 + omega3)) + 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega2 + omega3)) + 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 + omega2 - omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v12_A_v3", "b1133/(4*omega1*(omega1 + omega3)) + a113^2/(omega1*omega3*(omega1 + omega3)*(2*omega1 + omega3)) + a123^2/(4*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)*(omega1 + omega3)) + a113*a333/(2*omega1*(omega1 + omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_1_block_1_lumps[] = {2, 4, 5, 6};
constexpr int case_1_block_2_lumps[] = {1, 5, 7, 8};
constexpr int case_1_block_3_lumps[] = {9};
constexpr int case_1_block_3_phase[] = {-1, 0, 1, 0};
constexpr int case_1_block_4_lumps[] = {10};
constexpr int case_1_block_4_phase[] = {0, -1, 1, 0};
constexpr int case_1_block_5_lumps[] = {10};
constexpr int case_1_block_5_phase[] = {0, 1, 1, 0};
constexpr int case_1_block_6_lumps[] = {9};
constexpr int case_1_block_6_phase[] = {1, 0, 1, 0};
constexpr int case_1_block_7_lumps[] = {11};
constexpr int case_1_block_7_phase[] = {-2, 1, 0, 0};
constexpr int case_1_block_8_lumps[] = {12};
constexpr int case_1_block_8_phase[] = {-1, 0, 2, 0};
constexpr int case_1_block_9_lumps[] = {13};
constexpr int case_1_block_9_phase[] = {-1, 2, 0, 0};
constexpr int case_1_block_10_lumps[] = {14};
constexpr int case_1_block_10_phase[] = {0, -1, 2, 0};
constexpr int case_1_block_11_lumps[] = {11, 15, 16};
constexpr int case_1_block_11_phase[] = {0, 1, 0, 0};
constexpr int case_1_block_12_lumps[] = {17};
constexpr int case_1_block_12_phase[] = {0, 1, 2, 0};
constexpr int case_1_block_13_lumps[] = {16};
constexpr int case_1_block_13_phase[] = {0, 3, 0, 0};
constexpr int case_1_block_14_lumps[] = {18};
constexpr int case_1_block_14_phase[] = {1, 0, 2, 0};
constexpr int case_1_block_15_lumps[] = {19};
constexpr int case_1_block_15_phase[] = {1, 2, 0, 0};
constexpr int case_1_block_16_lumps[] = {11};
constexpr int case_1_block_16_phase[] = {2, 1, 0, 0};
constexpr int case_1_block_17_lumps[] = {20};
constexpr int case_1_block_17_phase[] = {3, 0, 0, 0};
constexpr int case_1_block_18_lumps[] = {10};
constexpr int case_1_block_18_phase[] = {-1, 0, 1, 0};
constexpr int case_1_block_19_lumps[] = {21};
constexpr int case_1_block_19_phase[] = {0, -1, 1, 0};
constexpr int case_1_block_20_lumps[] = {21};
constexpr int case_1_block_20_phase[] = {0, 1, 1, 0};
constexpr int case_1_block_21_lumps[] = {10};
constexpr int case_1_block_21_phase[] = {1, 0, 1, 0};
constexpr int case_1_block_22_lumps[] = {22};
constexpr int case_1_block_22_phase[] = {-2, 1, 0, 0};
constexpr int case_1_block_23_lumps[] = {23};
constexpr int case_1_block_23_phase[] = {-1, 0, 2, 0};
constexpr int case_1_block_24_lumps[] = {16};
constexpr int case_1_block_24_phase[] = {-1, 2, 0, 0};
constexpr int case_1_block_25_lumps[] = {24};
constexpr int case_1_block_25_phase[] = {0, -1, 2, 0};
constexpr int case_1_block_26_lumps[] = {25};
constexpr int case_1_block_26_phase[] = {0, 1, 2, 0};
constexpr int case_1_block_27_lumps[] = {26};
constexpr int case_1_block_27_phase[] = {0, 3, 0, 0};
constexpr int case_1_block_28_lumps[] = {11, 16, 27};
constexpr int case_1_block_28_phase[] = {1, 0, 0, 0};
constexpr int case_1_block_29_lumps[] = {28};
constexpr int case_1_block_29_phase[] = {1, 0, 2, 0};
constexpr int case_1_block_30_lumps[] = {16};
constexpr int case_1_block_30_phase[] = {1, 2, 0, 0};
constexpr int case_1_block_31_lumps[] = {29};
constexpr int case_1_block_31_phase[] = {2, 1, 0, 0};
constexpr int case_1_block_32_lumps[] = {11};
constexpr int case_1_block_32_phase[] = {3, 0, 0, 0};
constexpr int case_1_block_33_lumps[] = {10};
constexpr int case_1_block_33_phase[] = {-1, 1, 0, 0};
constexpr int case_1_block_34_lumps[] = {9, 21, 30};
constexpr int case_1_block_34_phase[] = {0, 0, 0, 0};
constexpr int case_1_block_35_lumps[] = {30};
constexpr int case_1_block_35_phase[] = {0, 0, 2, 0};
constexpr int case_1_block_36_lumps[] = {21};
constexpr int case_1_block_36_phase[] = {0, 2, 0, 0};
constexpr int case_1_block_37_lumps[] = {10};
constexpr int case_1_block_37_phase[] = {1, 1, 0, 0};
constexpr int case_1_block_38_lumps[] = {9};
constexpr int case_1_block_38_phase[] = {2, 0, 0, 0};
constexpr int case_1_block_39_lumps[] = {31};
constexpr int case_1_block_39_phase[] = {-2, 0, 1, 0};
constexpr int case_1_block_40_lumps[] = {32};
constexpr int case_1_block_40_phase[] = {-1, -1, 1, 0};
constexpr int case_1_block_41_lumps[] = {33};
constexpr int case_1_block_41_phase[] = {-1, 1, 1, 0};
constexpr int case_1_block_42_lumps[] = {8};
constexpr int case_1_block_42_phase[] = {0, 0, 3, 0};
constexpr int case_1_block_43_lumps[] = {34};
constexpr int case_1_block_43_phase[] = {0, 2, -1, 0};
constexpr int case_1_block_44_lumps[] = {35};
constexpr int case_1_block_44_phase[] = {0, 2, 1, 0};
constexpr int case_1_block_45_lumps[] = {36};
constexpr int case_1_block_45_phase[] = {1, -1, 1, 0};
constexpr int case_1_block_46_lumps[] = {37};
constexpr int case_1_block_46_phase[] = {1, 1, 1, 0};
constexpr int case_1_block_47_lumps[] = {38};
constexpr int case_1_block_47_phase[] = {2, 0, 1, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_1_block_0_lumps, column_function<free::columns_0, 3, 1, 4>, column_slope_function<free::column_slopes_0, 3, 1, 4>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_1_block_1_lumps, column_function<free::columns_1, 3, 1, 4>, column_slope_function<free::column_slopes_1, 3, 1, 4>},
  {BlockKind::modulation, "modulation of v3", 2, 0, {}, case_1_block_2_lumps, column_function<free::columns_2, 3, 1, 4>, column_slope_function<free::column_slopes_2, 3, 1, 4>},
  {BlockKind::harmonic, "harmonic -omega1+omega3 of v1", 0, 1, case_1_block_3_phase, case_1_block_3_lumps, column_function<free::columns_3, 3, 1, 1>, column_slope_function<free::column_slopes_3, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega2+omega3 of v1", 0, 1, case_1_block_4_phase, case_1_block_4_lumps, column_function<free::columns_4, 3, 1, 1>, column_slope_function<free::column_slopes_4, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+omega3 of v1", 0, 1, case_1_block_5_phase, case_1_block_5_lumps, column_function<free::columns_5, 3, 1, 1>, column_slope_function<free::column_slopes_5, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega3 of v1", 0, 1, case_1_block_6_phase, case_1_block_6_lumps, column_function<free::columns_6, 3, 1, 1>, column_slope_function<free::column_slopes_6, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, case_1_block_7_phase, case_1_block_7_lumps, column_function<additive_combination::columns_3, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_3, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega3 of v1", 0, 2, case_1_block_8_phase, case_1_block_8_lumps, column_function<free::columns_8, 3, 1, 1>, column_slope_function<free::column_slopes_8, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, case_1_block_9_phase, case_1_block_9_lumps, column_function<additive_combination::columns_5, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_5, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega2+2*omega3 of v1", 0, 2, case_1_block_10_phase, case_1_block_10_lumps, column_function<free::columns_10, 3, 1, 1>, column_slope_function<free::column_slopes_10, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, case_1_block_11_phase, case_1_block_11_lumps, column_function<free::columns_11, 3, 1, 3>, column_slope_function<free::column_slopes_11, 3, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2+2*omega3 of v1", 0, 2, case_1_block_12_phase, case_1_block_12_lumps, column_function<free::columns_12, 3, 1, 1>, column_slope_function<free::column_slopes_12, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_1_block_13_phase, case_1_block_13_lumps, column_function<additive_combination::columns_7, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_7, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega3 of v1", 0, 2, case_1_block_14_phase, case_1_block_14_lumps, column_function<free::columns_14, 3, 1, 1>, column_slope_function<free::column_slopes_14, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, case_1_block_15_phase, case_1_block_15_lumps, column_function<free::columns_15, 3, 1, 1>, column_slope_function<free::column_slopes_15, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, case_1_block_16_phase, case_1_block_16_lumps, column_function<free::columns_16, 3, 1, 1>, column_slope_function<free::column_slopes_16, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_1_block_17_phase, case_1_block_17_lumps, column_function<additive_combination::columns_9, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_9, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega3 of v2", 1, 1, case_1_block_18_phase, case_1_block_18_lumps, column_function<free::columns_18, 3, 1, 1>, column_slope_function<free::column_slopes_18, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega2+omega3 of v2", 1, 1, case_1_block_19_phase, case_1_block_19_lumps, column_function<free::columns_19, 3, 1, 1>, column_slope_function<free::column_slopes_19, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+omega3 of v2", 1, 1, case_1_block_20_phase, case_1_block_20_lumps, column_function<free::columns_20, 3, 1, 1>, column_slope_function<free::column_slopes_20, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega3 of v2", 1, 1, case_1_block_21_phase, case_1_block_21_lumps, column_function<free::columns_21, 3, 1, 1>, column_slope_function<free::column_slopes_21, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, case_1_block_22_phase, case_1_block_22_lumps, column_function<additive_combination::columns_11, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_11, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega3 of v2", 1, 2, case_1_block_23_phase, case_1_block_23_lumps, column_function<free::columns_23, 3, 1, 1>, column_slope_function<free::column_slopes_23, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, case_1_block_24_phase, case_1_block_24_lumps, column_function<additive_combination::columns_12, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_12, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega2+2*omega3 of v2", 1, 2, case_1_block_25_phase, case_1_block_25_lumps, column_function<free::columns_25, 3, 1, 1>, column_slope_function<free::column_slopes_25, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+2*omega3 of v2", 1, 2, case_1_block_26_phase, case_1_block_26_lumps, column_function<free::columns_26, 3, 1, 1>, column_slope_function<free::column_slopes_26, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_1_block_27_phase, case_1_block_27_lumps, column_function<additive_combination::columns_15, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_15, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, case_1_block_28_phase, case_1_block_28_lumps, column_function<free::columns_28, 3, 1, 3>, column_slope_function<free::column_slopes_28, 3, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+2*omega3 of v2", 1, 2, case_1_block_29_phase, case_1_block_29_lumps, column_function<free::columns_29, 3, 1, 1>, column_slope_function<free::column_slopes_29, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, case_1_block_30_phase, case_1_block_30_lumps, column_function<free::columns_30, 3, 1, 1>, column_slope_function<free::column_slopes_30, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, case_1_block_31_phase, case_1_block_31_lumps, column_function<free::columns_31, 3, 1, 1>, column_slope_function<free::column_slopes_31, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_1_block_32_phase, case_1_block_32_lumps, column_function<additive_combination::columns_17, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_17, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v3", 2, 1, case_1_block_33_phase, case_1_block_33_lumps, column_function<additive_combination::columns_18, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_18, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 0 of v3", 2, 1, case_1_block_34_phase, case_1_block_34_lumps, column_function<free::columns_34, 3, 1, 3>, column_slope_function<free::column_slopes_34, 3, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega3 of v3", 2, 1, case_1_block_35_phase, case_1_block_35_lumps, column_function<free::columns_35, 3, 1, 1>, column_slope_function<free::column_slopes_35, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v3", 2, 1, case_1_block_36_phase, case_1_block_36_lumps, column_function<additive_combination::columns_21, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_21, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v3", 2, 1, case_1_block_37_phase, case_1_block_37_lumps, column_function<free::columns_37, 3, 1, 1>, column_slope_function<free::column_slopes_37, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v3", 2, 1, case_1_block_38_phase, case_1_block_38_lumps, column_function<additive_combination::columns_22, 3, 1, 1>, column_slope_function<additive_combination::column_slopes_22, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega3 of v3", 2, 2, case_1_block_39_phase, case_1_block_39_lumps, column_function<free::columns_39, 3, 1, 1>, column_slope_function<free::column_slopes_39, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1-omega2+omega3 of v3", 2, 2, case_1_block_40_phase, case_1_block_40_lumps, column_function<free::columns_40, 3, 1, 1>, column_slope_function<free::column_slopes_40, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega2+omega3 of v3", 2, 2, case_1_block_41_phase, case_1_block_41_lumps, column_function<free::columns_41, 3, 1, 1>, column_slope_function<free::column_slopes_41, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega3 of v3", 2, 2, case_1_block_42_phase, case_1_block_42_lumps, column_function<free::columns_42, 3, 1, 1>, column_slope_function<free::column_slopes_42, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega2-omega3 of v3", 2, 2, case_1_block_43_phase, case_1_block_43_lumps, column_function<free::columns_43, 3, 1, 1>, column_slope_function<free::column_slopes_43, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega2+omega3 of v3", 2, 2, case_1_block_44_phase, case_1_block_44_lumps, column_function<free::columns_44, 3, 1, 1>, column_slope_function<free::column_slopes_44, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1-omega2+omega3 of v3", 2, 2, case_1_block_45_phase, case_1_block_45_lumps, column_function<free::columns_45, 3, 1, 1>, column_slope_function<free::column_slopes_45, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+omega2+omega3 of v3", 2, 2, case_1_block_46_phase, case_1_block_46_lumps, column_function<free::columns_46, 3, 1, 1>, column_slope_function<free::column_slopes_46, 3, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega3 of v3", 2, 2, case_1_block_47_phase, case_1_block_47_lumps, column_function<free::columns_47, 3, 1, 1>, column_slope_function<free::column_slopes_47, 3, 1, 1>},
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
  {
    .name = "free",
    .excited = false,
    .relations = {},
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = free::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free::modulation<double>>,
    .modulation_jacobian = jacobian_function<free::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "three_modes",
  .source = "Generic; the case of S. O'F. Fahey, dissertation, Virginia Tech, 2000, section 3.2.3, with the third mode kept",
  .fingerprint = "206925ca958c0335",
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

}  // namespace secular::generated::three_modes
