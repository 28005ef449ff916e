// Model parametric_pair: generated code, never edited by hand.
// Source: Two linear modes with parametric coupling and cubic stiffness
// Equation of motion: 0 = omega1^2*x + b3*x*y^2 + b1*x^3 + 2*mu1*D(x) + D2(x) - p*y*F*cos(Omega*t)
// Equation of motion: 0 = -q*x*F*cos(Omega*t) + b3*x^2*y + omega2^2*y + b5*y^3 + 2*mu2*D(y) + D2(y)
// Case additive: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case additive_second_order: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case difference: Omega = omega2 - omega1 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate parametric_pair
#include "generated/parametric_pair.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::parametric_pair {

namespace {

constexpr std::string_view coordinates[] = {"x", "y"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{-1, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_1},
  {"mu1", dimension_2},
  {"b1", dimension_3},
  {"b3", dimension_4},
  {"p", dimension_5},
  {"mu2", dimension_6},
  {"b5", dimension_7},
  {"q", dimension_8},
};
constexpr double nominal[] = {1, 2.7, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-1, -1, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr Ratio case_0_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_2[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_3[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_4[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_5[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_6[] = {{-1, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu1", "mu1", case_0_lump_0},
  {"b3", "b3", case_0_lump_1},
  {"b1", "b1", case_0_lump_2},
  {"p", "p", case_0_lump_3},
  {"mu2", "mu2", case_0_lump_4},
  {"b5", "b5", case_0_lump_5},
  {"q", "q", case_0_lump_6},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_0_block_1_lumps[] = {1, 4, 5, 6};
constexpr int case_0_block_2_lumps[] = {1};
constexpr int case_0_block_2_phase[] = {-1, 2, 0};
constexpr int case_0_block_3_lumps[] = {1, 3};
constexpr int case_0_block_3_phase[] = {0, 1, 1};
constexpr int case_0_block_4_lumps[] = {2};
constexpr int case_0_block_4_phase[] = {3, 0, 0};
constexpr int case_0_block_5_lumps[] = {1};
constexpr int case_0_block_5_phase[] = {-2, 1, 0};
constexpr int case_0_block_6_lumps[] = {5};
constexpr int case_0_block_6_phase[] = {0, 3, 0};
constexpr int case_0_block_7_lumps[] = {1, 6};
constexpr int case_0_block_7_phase[] = {1, 0, 1};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_0_block_0_lumps, column_function<additive::columns_0, 2, 1, 4>, column_slope_function<additive::column_slopes_0, 2, 1, 4>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_0_block_1_lumps, column_function<additive::columns_1, 2, 1, 4>, column_slope_function<additive::column_slopes_1, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<additive::columns_2, 2, 1, 1>, column_slope_function<additive::column_slopes_2, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, case_0_block_3_phase, case_0_block_3_lumps, column_function<additive::columns_3, 2, 1, 2>, column_slope_function<additive::column_slopes_3, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, case_0_block_4_phase, case_0_block_4_lumps, column_function<additive::columns_4, 2, 1, 1>, column_slope_function<additive::column_slopes_4, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of y", 1, 1, case_0_block_5_phase, case_0_block_5_lumps, column_function<additive::columns_5, 2, 1, 1>, column_slope_function<additive::column_slopes_5, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, case_0_block_6_phase, case_0_block_6_lumps, column_function<additive::columns_6, 2, 1, 1>, column_slope_function<additive::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, case_0_block_7_phase, case_0_block_7_lumps, column_function<additive::columns_7, 2, 1, 2>, column_slope_function<additive::column_slopes_7, 2, 1, 2>},
};

constexpr int case_1_relations[] = {-1, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr Ratio case_1_lump_0[] = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_3[] = {{0, 1}, {0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_1_lump_4[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_5[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_6[] = {{0, 1}, {-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_7[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_8[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_9[] = {{-2, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_10[] = {{-4, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_11[] = {{1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_12[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_13[] = {{1, 1}, {-3, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_14[] = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_15[] = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_16[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_17[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_18[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_19[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_20[] = {{0, 1}, {-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_21[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_22[] = {{0, 1}, {-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_23[] = {{-1, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_24[] = {{-1, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_25[] = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_26[] = {{-3, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_36[] = {{-2, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_46[] = {{0, 1}, {-4, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"conservative_x_A_x2_A_y_F", "(-2*omega1*b3*q - 3*omega2*b1*p)/(16*omega1^3*omega2) - b3*p/(16*omega1^2*(omega1 + omega2))", case_1_lump_0},
  {"mu1", "mu1", case_1_lump_1},
  {"conservative_x_A_x", "-mu1^2/(2*omega1)", case_1_lump_2},
  {"conservative_x_A_x_F2", "(omega1*p*q + 2*omega2*p*q)/(32*omega1^2*omega2*(omega1 + omega2))", case_1_lump_3},
  {"dissipative_x_A_x_A_y_conjA_y", "b3*mu2/omega1^2", case_1_lump_4},
  {"b3", "b3", case_1_lump_5},
  {"conservative_x_A_x_A_y2_conjA_y2", "(-3*omega1^2*b3^2 + 2*omega2^2*b3^2)/(4*omega1^3*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_6},
  {"dissipative_x_A_x2_conjA_x", "3*mu1*b1/(2*omega1^2)", case_1_lump_7},
  {"b1", "b1", case_1_lump_8},
  {"conservative_x_A_x2_A_y_conjA_x_conjA_y", "-3*b1*b3/(2*omega1^3) + b3^2/(2*omega1*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_9},
  {"conservative_x_A_x3_conjA_x2", "-15*b1^2/(16*omega1^3)", case_1_lump_10},
  {"dissipative_x_conjA_y_F", "(mu1*p - p*mu2)/(8*omega1^2)", case_1_lump_11},
  {"p", "p", case_1_lump_12},
  {"conservative_x_A_y_conjA_y2_F", "(-3*omega1*p*b5 + 2*omega2*b3*p)/(16*omega1^3*omega2) - b3*p/(16*omega1*omega2*(omega1 + omega2))", case_1_lump_13},
  {"conservative_x_A_x_conjA_x_conjA_y_F", "(-omega1*b3*p + 3*omega2*b1*p)/(8*omega1^3*omega2) + b3*q/(8*omega1*omega2*(omega1 + omega2))", case_1_lump_14},
  {"conservative_y_A_x_A_y2_F", "(-3*omega1*b5*q - 2*omega2*b3*p)/(16*omega1*omega2^3) - b3*q/(16*omega2^2*(omega1 + omega2))", case_1_lump_15},
  {"mu2", "mu2", case_1_lump_16},
  {"conservative_y_A_y", "-mu2^2/(2*omega2)", case_1_lump_17},
  {"dissipative_y_A_y2_conjA_y", "3*mu2*b5/(2*omega2^2)", case_1_lump_18},
  {"b5", "b5", case_1_lump_19},
  {"conservative_y_A_y3_conjA_y2", "-15*b5^2/(16*omega2^3)", case_1_lump_20},
  {"dissipative_y_A_x_A_y_conjA_x", "mu1*b3/omega2^2", case_1_lump_21},
  {"conservative_y_A_x_A_y2_conjA_x_conjA_y", "-3*b3*b5/(2*omega2^3) - b3^2/(2*omega2*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_22},
  {"dissipative_y_conjA_x_F", "(-mu1*q + mu2*q)/(8*omega2^2)", case_1_lump_23},
  {"q", "q", case_1_lump_24},
  {"conservative_y_A_y_conjA_x_conjA_y_F", "(3*omega1*b5*q - omega2*b3*q)/(8*omega1*omega2^3) + b3*p/(8*omega1*omega2*(omega1 + omega2))", case_1_lump_25},
  {"conservative_y_A_x_conjA_x2_F", "(2*omega1*b3*q - 3*omega2*b1*q)/(16*omega1*omega2^3) - b3*q/(16*omega1*omega2*(omega1 + omega2))", case_1_lump_26},
  {"harmonic_re_x_A_y_conjA_x2_F", "b3*p/(32*omega1*omega2*(omega1 - omega2)^2) + 3*b1*p/(32*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_y3_F", "(omega1*b3*p - 2*omega2*b3*p)/(32*omega1*omega2^2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y3_conjA_x_conjA_y", "(5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 + 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y2_conjA_x2", "(2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 - omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 - omega2)^2) + (6*omega1*b1*b3 + 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_y_F", "(3*omega1*p*b5 - 2*omega2*b3*p + 6*omega2*p*b5)/(32*omega2^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x_F", "(omega1^2*b3*p - 3*omega1*omega2*b1*p + 2*omega1*omega2*b3*p - omega2^2*b3*q)/(16*omega1*omega2^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_x_A_y3_conjA_y", "(-5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 - 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_x_A_x2_A_y2_conjA_x", "(-2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 + omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 + omega2)^2) + (-6*omega1*b1*b3 + 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_x2_conjA_y_F", "-b3*q/(32*omega1^3*(omega1 + omega2)) - b3*p/(64*omega1^3*(omega1 - omega2))", {}},
  {"harmonic_re_x_A_x3_A_y_conjA_y", "-b1*b3/(4*omega1^4) + b3^2/(8*omega1^2*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_36},
  {"harmonic_re_x_A_y2_conjA_x3", "(-6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 - omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 - omega2)^2*(2*omega1 - omega2))", {}},
  {"harmonic_re_x_A_y4_conjA_x", "-b3*b5/(32*omega2^3*(omega1 - 2*omega2)) + b3^2/(32*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y4", "b3*b5/(32*omega2^3*(omega1 + 2*omega2)) + b3^2/(32*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2))", {}},
  {"harmonic_re_x_A_x2_A_y_F", "(-3*omega1*b1*p - omega2*b3*p - 2*omega2*b3*q)/(32*omega1*omega2*(omega1 + omega2)^2*(2*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3_A_y2", "(6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 + omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 + omega2)^2*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_conjA_x3_F", "-b1*q/(64*omega1^3*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_y2_conjA_x2_conjA_y", "(-omega1^2*b3^2 - 4*omega1*omega2*b3^2 + 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 - omega2)^2) + (3*omega1*b3*b5 + 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)", {}},
  {"harmonic_re_y_A_x_A_y_conjA_x3", "(4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 + 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_y_A_y2_conjA_x_F", "b3*q/(32*omega1*omega2*(omega1 - omega2)^2) - 3*b5*q/(32*omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x_A_y3_conjA_x", "-b3*b5/(4*omega2^4) - b3^2/(8*omega2^2*(omega1 + omega2)*(omega1 - omega2))", case_1_lump_46},
  {"harmonic_re_y_A_x_A_y_conjA_y_F", "(-omega1^2*b3*p + 2*omega1*omega2*b3*q - 3*omega1*omega2*b5*q + omega2^2*b3*q)/(16*omega1^3*omega2*(omega1 + omega2)^2)", {}},
  {"harmonic_re_y_A_x2_conjA_x_F", "(6*omega1*b1*q - 2*omega1*b3*q + 3*omega2*b1*q)/(32*omega1^3*(omega1 + omega2)^2)", {}},
  {"harmonic_re_y_A_x2_A_y2_conjA_y", "(omega1^2*b3^2 - 4*omega1*omega2*b3^2 - 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 + omega2)^2) + (-3*omega1*b3*b5 + 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x3_A_y_conjA_x", "(-4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 - 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 + omega2)^2)", {}},
  {"harmonic_re_y_A_y3_conjA_x2", "(omega1^2*b3*b5 - 4*omega1*omega2*b3^2 - omega1*omega2*b3*b5 + 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 - omega2)^2*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x_A_y2_F", "(-2*omega1*b3*p - omega1*b3*q - 3*omega2*b5*q)/(32*omega1*omega2*(omega1 + omega2)^2*(omega1 + 2*omega2))", {}},
  {"harmonic_re_y_A_x2_A_y3", "(omega1^2*b3*b5 + 4*omega1*omega2*b3^2 + omega1*omega2*b3*b5 + 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 + omega2)^2*(omega1 + 2*omega2))", {}},
  {"harmonic_re_y_A_x3_F", "-b1*q/(128*omega1^3*(2*omega1 + omega2)) - b3*q/(64*omega1^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x4_A_y", "b1*b3/(32*omega1^3*(2*omega1 + omega2)) + b3^2/(32*omega1^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x4_conjA_y", "b1*b3/(32*omega1^3*(2*omega1 - omega2)) + b3^2/(32*omega1^2*(omega1 - omega2)*(2*omega1 - omega2))", {}},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
constexpr int case_1_block_1_lumps[] = {3, 5, 6, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr int case_1_block_2_lumps[] = {4, 5, 27, 28, 29, 30};
constexpr int case_1_block_2_phase[] = {-1, 2, 0};
constexpr int case_1_block_3_lumps[] = {3, 4, 5, 11, 12, 28, 31, 32, 33, 34};
constexpr int case_1_block_3_phase[] = {0, 1, 1};
constexpr int case_1_block_4_lumps[] = {7, 8, 10, 35, 36};
constexpr int case_1_block_4_phase[] = {3, 0, 0};
constexpr int case_1_block_5_lumps[] = {37};
constexpr int case_1_block_5_phase[] = {-3, 2, 0};
constexpr int case_1_block_6_lumps[] = {38};
constexpr int case_1_block_6_phase[] = {-1, 4, 0};
constexpr int case_1_block_7_lumps[] = {28, 39};
constexpr int case_1_block_7_phase[] = {0, 3, 1};
constexpr int case_1_block_8_lumps[] = {3, 40, 41};
constexpr int case_1_block_8_phase[] = {1, 0, 2};
constexpr int case_1_block_9_lumps[] = {10};
constexpr int case_1_block_9_phase[] = {5, 0, 0};
constexpr int case_1_block_10_lumps[] = {5, 21, 28, 42, 43, 44, 45};
constexpr int case_1_block_10_phase[] = {-2, 1, 0};
constexpr int case_1_block_11_lumps[] = {18, 19, 20, 45, 46};
constexpr int case_1_block_11_phase[] = {0, 3, 0};
constexpr int case_1_block_12_lumps[] = {3, 5, 21, 23, 24, 28, 47, 48, 49, 50};
constexpr int case_1_block_12_phase[] = {1, 0, 1};
constexpr int case_1_block_13_lumps[] = {51};
constexpr int case_1_block_13_phase[] = {-2, 3, 0};
constexpr int case_1_block_14_lumps[] = {3, 52, 53};
constexpr int case_1_block_14_phase[] = {0, 1, 2};
constexpr int case_1_block_15_lumps[] = {20};
constexpr int case_1_block_15_phase[] = {0, 5, 0};
constexpr int case_1_block_16_lumps[] = {54, 55};
constexpr int case_1_block_16_phase[] = {3, 0, 1};
constexpr int case_1_block_17_lumps[] = {56};
constexpr int case_1_block_17_phase[] = {4, -1, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_1_block_0_lumps, column_function<additive_second_order::columns_0, 2, 1, 15>, column_slope_function<additive_second_order::column_slopes_0, 2, 1, 15>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_1_block_1_lumps, column_function<additive_second_order::columns_1, 2, 1, 15>, column_slope_function<additive_second_order::column_slopes_1, 2, 1, 15>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<additive_second_order::columns_2, 2, 1, 6>, column_slope_function<additive_second_order::column_slopes_2, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, case_1_block_3_phase, case_1_block_3_lumps, column_function<additive_second_order::columns_3, 2, 1, 10>, column_slope_function<additive_second_order::column_slopes_3, 2, 1, 10>},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, case_1_block_4_phase, case_1_block_4_lumps, column_function<additive_second_order::columns_4, 2, 1, 5>, column_slope_function<additive_second_order::column_slopes_4, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic -3*omega1+2*omega2 of x", 0, 2, case_1_block_5_phase, case_1_block_5_lumps, column_function<additive_second_order::columns_5, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_5, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+4*omega2 of x", 0, 2, case_1_block_6_phase, case_1_block_6_lumps, column_function<additive_second_order::columns_6, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2+Omega of x", 0, 2, case_1_block_7_phase, case_1_block_7_lumps, column_function<additive_second_order::columns_7, 2, 1, 2>, column_slope_function<additive_second_order::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of x", 0, 2, case_1_block_8_phase, case_1_block_8_lumps, column_function<additive_second_order::columns_8, 2, 1, 3>, column_slope_function<additive_second_order::column_slopes_8, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 5*omega1 of x", 0, 2, case_1_block_9_phase, case_1_block_9_lumps, column_function<additive_second_order::columns_9, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_9, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of y", 1, 1, case_1_block_10_phase, case_1_block_10_lumps, column_function<additive_second_order::columns_10, 2, 1, 7>, column_slope_function<additive_second_order::column_slopes_10, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, case_1_block_11_phase, case_1_block_11_lumps, column_function<additive_second_order::columns_11, 2, 1, 5>, column_slope_function<additive_second_order::column_slopes_11, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, case_1_block_12_phase, case_1_block_12_lumps, column_function<additive_second_order::columns_12, 2, 1, 10>, column_slope_function<additive_second_order::column_slopes_12, 2, 1, 10>},
  {BlockKind::harmonic, "harmonic -2*omega1+3*omega2 of y", 1, 2, case_1_block_13_phase, case_1_block_13_lumps, column_function<additive_second_order::columns_13, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_13, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of y", 1, 2, case_1_block_14_phase, case_1_block_14_lumps, column_function<additive_second_order::columns_14, 2, 1, 3>, column_slope_function<additive_second_order::column_slopes_14, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 5*omega2 of y", 1, 2, case_1_block_15_phase, case_1_block_15_lumps, column_function<additive_second_order::columns_15, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_15, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1+Omega of y", 1, 2, case_1_block_16_phase, case_1_block_16_lumps, column_function<additive_second_order::columns_16, 2, 1, 2>, column_slope_function<additive_second_order::column_slopes_16, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 4*omega1-omega2 of y", 1, 2, case_1_block_17_phase, case_1_block_17_lumps, column_function<additive_second_order::columns_17, 2, 1, 1>, column_slope_function<additive_second_order::column_slopes_17, 2, 1, 1>},
};

constexpr int case_2_relations[] = {1, -1, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {1, 1}, {-1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr Ratio case_2_lump_0[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_4[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_5[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_6[] = {{-1, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledLump case_2_lumps[] = {
  {"p", "p", case_2_lump_0},
  {"mu1", "mu1", case_2_lump_1},
  {"b3", "b3", case_2_lump_2},
  {"b1", "b1", case_2_lump_3},
  {"mu2", "mu2", case_2_lump_4},
  {"b5", "b5", case_2_lump_5},
  {"q", "q", case_2_lump_6},
};
constexpr int case_2_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_2_block_1_lumps[] = {2, 4, 5, 6};
constexpr int case_2_block_2_lumps[] = {0, 2};
constexpr int case_2_block_2_phase[] = {0, 1, 1};
constexpr int case_2_block_3_lumps[] = {2};
constexpr int case_2_block_3_phase[] = {1, 2, 0};
constexpr int case_2_block_4_lumps[] = {3};
constexpr int case_2_block_4_phase[] = {3, 0, 0};
constexpr int case_2_block_5_lumps[] = {2, 6};
constexpr int case_2_block_5_phase[] = {-1, 0, 1};
constexpr int case_2_block_6_lumps[] = {5};
constexpr int case_2_block_6_phase[] = {0, 3, 0};
constexpr int case_2_block_7_lumps[] = {2};
constexpr int case_2_block_7_phase[] = {2, 1, 0};
constexpr RegressorBlock case_2_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_2_block_0_lumps, column_function<difference::columns_0, 2, 1, 4>, column_slope_function<difference::column_slopes_0, 2, 1, 4>},
  {BlockKind::modulation, "modulation of y", 1, 0, {}, case_2_block_1_lumps, column_function<difference::columns_1, 2, 1, 4>, column_slope_function<difference::column_slopes_1, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, case_2_block_2_phase, case_2_block_2_lumps, column_function<difference::columns_2, 2, 1, 2>, column_slope_function<difference::column_slopes_2, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 1, case_2_block_3_phase, case_2_block_3_lumps, column_function<difference::columns_3, 2, 1, 1>, column_slope_function<difference::column_slopes_3, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of x", 0, 1, case_2_block_4_phase, case_2_block_4_lumps, column_function<additive::columns_4, 2, 1, 1>, column_slope_function<additive::column_slopes_4, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of y", 1, 1, case_2_block_5_phase, case_2_block_5_lumps, column_function<difference::columns_5, 2, 1, 2>, column_slope_function<difference::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 1, case_2_block_6_phase, case_2_block_6_lumps, column_function<additive::columns_6, 2, 1, 1>, column_slope_function<additive::column_slopes_6, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of y", 1, 1, case_2_block_7_phase, case_2_block_7_lumps, column_function<difference::columns_7, 2, 1, 1>, column_slope_function<difference::column_slopes_7, 2, 1, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "additive",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = additive::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = additive::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<additive::modulation<double>>,
    .modulation_jacobian = jacobian_function<additive::modulation_jacobian<double>>,
  },
  {
    .name = "additive_second_order",
    .excited = true,
    .relations = case_1_relations,
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = additive_second_order::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = additive_second_order::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<additive_second_order::modulation<double>>,
    .modulation_jacobian = jacobian_function<additive_second_order::modulation_jacobian<double>>,
  },
  {
    .name = "difference",
    .excited = true,
    .relations = case_2_relations,
    .observed_frequency = case_2_observed_frequency,
    .mode_at_rest = case_2_mode_at_rest,
    .lumps = case_2_lumps,
    .blocks = case_2_blocks,
    .evaluate_lumps = difference::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = difference::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<difference::modulation<double>>,
    .modulation_jacobian = jacobian_function<difference::modulation_jacobian<double>>,
  },
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
