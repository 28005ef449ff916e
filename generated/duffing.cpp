// Model duffing: generated code, never edited by hand.
// Source: Duffing oscillator with a quadratic term
// Equation of motion: 0 = omega0^2*x + a2*x^2 + a3*x^3 + 2*mu*D(x) + D2(x) - e*F*cos(Omega*t)
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case primary: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case superharmonic_3: 3*Omega = omega0 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case subharmonic_3: Omega = 3*omega0 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case subharmonic_3_second_order: Omega = 3*omega0 + eps*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate duffing
#include "generated/duffing.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::duffing {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_1},
  {"a2", dimension_2},
  {"a3", dimension_3},
  {"e", dimension_4},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr Ratio case_0_observed_frequency[] = {{1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr Ratio case_0_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_2[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu", "mu", case_0_lump_0},
  {"conservative_x_A_x2_conjA_x", "(9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)", case_0_lump_1},
  {"a2", "a2", case_0_lump_2},
  {"harmonic_re_x_A_x3", "(3*omega0^2*a3 + 2*a2^2)/(24*omega0^4)", case_0_lump_3},
};
constexpr int case_0_block_0_lumps[] = {0, 1};
constexpr int case_0_block_1_lumps[] = {2};
constexpr int case_0_block_1_phase[] = {0, 0};
constexpr int case_0_block_2_lumps[] = {2};
constexpr int case_0_block_2_phase[] = {2, 0};
constexpr int case_0_block_3_lumps[] = {3};
constexpr int case_0_block_3_phase[] = {3, 0};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_0_block_0_lumps, column_function<free::columns_0, 1, 1, 2>, column_slope_function<free::column_slopes_0, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_0_block_1_phase, case_0_block_1_lumps, column_function<free::columns_1, 1, 1, 1>, column_slope_function<free::column_slopes_1, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<free::columns_2, 1, 1, 1>, column_slope_function<free::column_slopes_2, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 2, case_0_block_3_phase, case_0_block_3_lumps, column_function<free::columns_3, 1, 1, 1>, column_slope_function<free::column_slopes_3, 1, 1, 1>},
};

constexpr int case_1_relations[] = {-1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_2[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_3[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu", "mu", case_1_lump_0},
  {"conservative_x_A_x2_conjA_x", "(9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)", case_1_lump_1},
  {"e", "e", case_1_lump_2},
  {"a2", "a2", case_1_lump_3},
  {"harmonic_re_x_A_x3", "(3*omega0^2*a3 + 2*a2^2)/(24*omega0^4)", case_1_lump_4},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2};
constexpr int case_1_block_1_lumps[] = {3};
constexpr int case_1_block_1_phase[] = {0, 0};
constexpr int case_1_block_2_lumps[] = {3};
constexpr int case_1_block_2_phase[] = {2, 0};
constexpr int case_1_block_3_lumps[] = {4};
constexpr int case_1_block_3_phase[] = {3, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_1_block_0_lumps, column_function<primary::columns_0, 1, 1, 3>, column_slope_function<primary::column_slopes_0, 1, 1, 3>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_1_block_1_phase, case_1_block_1_lumps, column_function<free::columns_1, 1, 1, 1>, column_slope_function<free::column_slopes_1, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<free::columns_2, 1, 1, 1>, column_slope_function<free::column_slopes_2, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 2, case_1_block_3_phase, case_1_block_3_lumps, column_function<free::columns_3, 1, 1, 1>, column_slope_function<free::column_slopes_3, 1, 1, 1>},
};

constexpr int case_2_relations[] = {-1, 3};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {3, 1}};
constexpr bool case_2_mode_at_rest[] = {false};
constexpr Ratio case_2_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_1[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_2_lump_2[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_3[] = {{1, 1}, {-3, 1}, {-1, 1}};
constexpr Ratio case_2_lump_4[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_5[] = {{1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_2_lump_6[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_2_lump_7[] = {{1, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_2_lump_8[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_9[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr CompiledLump case_2_lumps[] = {
  {"mu", "mu", case_2_lump_0},
  {"conservative_x_A_x_F2", "243*a3*e^2/(256*omega0^5)", case_2_lump_1},
  {"a3", "a3", case_2_lump_2},
  {"conservative_x_F3", "729*a3*e^3/(8192*omega0^7)", case_2_lump_3},
  {"e", "e", case_2_lump_4},
  {"harmonic_im_x_F", "-27*mu*e/(64*omega0^3)", case_2_lump_5},
  {"harmonic_re_x_A_x_conjA_x_F", "-243*a3*e/(64*omega0^4)", case_2_lump_6},
  {"harmonic_re_x_F2", "-81*a2*e^2/(128*omega0^6)", case_2_lump_7},
  {"a2", "a2", case_2_lump_8},
  {"harmonic_re_x_A_x_F", "-81*a2*e/(40*omega0^4)", case_2_lump_9},
};
constexpr int case_2_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_2_block_1_lumps[] = {1, 3, 4, 5, 6};
constexpr int case_2_block_1_phase[] = {0, 1};
constexpr int case_2_block_2_lumps[] = {7, 8};
constexpr int case_2_block_2_phase[] = {0, 0};
constexpr int case_2_block_3_lumps[] = {7, 9};
constexpr int case_2_block_3_phase[] = {0, 2};
constexpr int case_2_block_4_lumps[] = {9};
constexpr int case_2_block_4_phase[] = {1, 1};
constexpr int case_2_block_5_lumps[] = {1, 6};
constexpr int case_2_block_5_phase[] = {1, 2};
constexpr int case_2_block_6_lumps[] = {8};
constexpr int case_2_block_6_phase[] = {2, 0};
constexpr int case_2_block_7_lumps[] = {6};
constexpr int case_2_block_7_phase[] = {2, 1};
constexpr int case_2_block_8_lumps[] = {2};
constexpr int case_2_block_8_phase[] = {3, 0};
constexpr RegressorBlock case_2_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_2_block_0_lumps, column_function<superharmonic_3::columns_0, 1, 1, 4>, column_slope_function<superharmonic_3::column_slopes_0, 1, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, case_2_block_1_phase, case_2_block_1_lumps, column_function<superharmonic_3::columns_1, 1, 1, 5>, column_slope_function<superharmonic_3::column_slopes_1, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_2_block_2_phase, case_2_block_2_lumps, column_function<superharmonic_3::columns_2, 1, 1, 2>, column_slope_function<superharmonic_3::column_slopes_2, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, case_2_block_3_phase, case_2_block_3_lumps, column_function<superharmonic_3::columns_3, 1, 1, 2>, column_slope_function<superharmonic_3::column_slopes_3, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, case_2_block_4_phase, case_2_block_4_lumps, column_function<superharmonic_3::columns_4, 1, 1, 1>, column_slope_function<superharmonic_3::column_slopes_4, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, case_2_block_5_phase, case_2_block_5_lumps, column_function<superharmonic_3::columns_5, 1, 1, 2>, column_slope_function<superharmonic_3::column_slopes_5, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega0 of x", 0, 1, case_2_block_6_phase, case_2_block_6_lumps, column_function<free::columns_2, 1, 1, 1>, column_slope_function<free::column_slopes_2, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega0+Omega of x", 0, 1, case_2_block_7_phase, case_2_block_7_lumps, column_function<superharmonic_3::columns_7, 1, 1, 1>, column_slope_function<superharmonic_3::column_slopes_7, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, case_2_block_8_phase, case_2_block_8_lumps, column_function<superharmonic_3::columns_8, 1, 1, 1>, column_slope_function<superharmonic_3::column_slopes_8, 1, 1, 1>},
};

constexpr int case_3_relations[] = {-3, 1};
constexpr Ratio case_3_observed_frequency[] = {{0, 1}, {1, 3}};
constexpr bool case_3_mode_at_rest[] = {false};
constexpr Ratio case_3_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_1[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_3_lump_2[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_3[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_3_lump_4[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_3_lump_5[] = {{1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_3_lump_6[] = {{1, 1}, {-3, 1}, {0, 1}};
constexpr Ratio case_3_lump_7[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_3_lump_8[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_3_lump_9[] = {{1, 1}, {-2, 1}, {0, 1}};
constexpr CompiledLump case_3_lumps[] = {
  {"mu", "mu", case_3_lump_0},
  {"conservative_x_A_x_F2", "3*a3*e^2/(256*omega0^5)", case_3_lump_1},
  {"a3", "a3", case_3_lump_2},
  {"conservative_x_conjA_x2_F", "-3*a3*e/(32*omega0^3)", case_3_lump_3},
  {"e", "e", case_3_lump_4},
  {"harmonic_im_x_F", "-3*mu*e/(64*omega0^3)", case_3_lump_5},
  {"harmonic_re_x_F3", "-3*a3*e^3/(32768*omega0^8)", case_3_lump_6},
  {"harmonic_re_x_conjA_x_F", "-a2*e/(24*omega0^4)", case_3_lump_7},
  {"a2", "a2", case_3_lump_8},
  {"harmonic_re_x_F2", "-a2*e^2/(128*omega0^6)", case_3_lump_9},
};
constexpr int case_3_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_3_block_1_lumps[] = {2, 3, 4, 5, 6};
constexpr int case_3_block_1_phase[] = {0, 1};
constexpr int case_3_block_2_lumps[] = {7, 8};
constexpr int case_3_block_2_phase[] = {-1, 1};
constexpr int case_3_block_3_lumps[] = {1, 3};
constexpr int case_3_block_3_phase[] = {-1, 2};
constexpr int case_3_block_4_lumps[] = {8, 9};
constexpr int case_3_block_4_phase[] = {0, 0};
constexpr int case_3_block_5_lumps[] = {9};
constexpr int case_3_block_5_phase[] = {0, 2};
constexpr int case_3_block_6_lumps[] = {6};
constexpr int case_3_block_6_phase[] = {0, 3};
constexpr int case_3_block_7_lumps[] = {7};
constexpr int case_3_block_7_phase[] = {1, 1};
constexpr int case_3_block_8_lumps[] = {1};
constexpr int case_3_block_8_phase[] = {1, 2};
constexpr RegressorBlock case_3_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_3_block_0_lumps, column_function<subharmonic_3::columns_0, 1, 1, 4>, column_slope_function<subharmonic_3::column_slopes_0, 1, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, case_3_block_1_phase, case_3_block_1_lumps, column_function<subharmonic_3::columns_1, 1, 1, 5>, column_slope_function<subharmonic_3::column_slopes_1, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic -omega0+Omega of x", 0, 1, case_3_block_2_phase, case_3_block_2_lumps, column_function<subharmonic_3::columns_2, 1, 1, 2>, column_slope_function<subharmonic_3::column_slopes_2, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega0+2*Omega of x", 0, 1, case_3_block_3_phase, case_3_block_3_lumps, column_function<subharmonic_3::columns_3, 1, 1, 2>, column_slope_function<subharmonic_3::column_slopes_3, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_3_block_4_phase, case_3_block_4_lumps, column_function<subharmonic_3::columns_4, 1, 1, 2>, column_slope_function<subharmonic_3::column_slopes_4, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, case_3_block_5_phase, case_3_block_5_lumps, column_function<subharmonic_3::columns_5, 1, 1, 1>, column_slope_function<subharmonic_3::column_slopes_5, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*Omega of x", 0, 1, case_3_block_6_phase, case_3_block_6_lumps, column_function<subharmonic_3::columns_6, 1, 1, 1>, column_slope_function<subharmonic_3::column_slopes_6, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, case_3_block_7_phase, case_3_block_7_lumps, column_function<subharmonic_3::columns_7, 1, 1, 1>, column_slope_function<subharmonic_3::column_slopes_7, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, case_3_block_8_phase, case_3_block_8_lumps, column_function<subharmonic_3::columns_8, 1, 1, 1>, column_slope_function<subharmonic_3::column_slopes_8, 1, 1, 1>},
};

constexpr int case_4_relations[] = {-3, 1};
constexpr Ratio case_4_observed_frequency[] = {{0, 1}, {1, 3}};
constexpr bool case_4_mode_at_rest[] = {false};
constexpr Ratio case_4_lump_0[] = {{-3, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_4_lump_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_2[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_3[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_4_lump_4[] = {{0, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_4_lump_5[] = {{0, 1}, {-4, 1}, {-1, 1}};
constexpr Ratio case_4_lump_6[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_7[] = {{-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_8[] = {{-2, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_4_lump_9[] = {{-4, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_10[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_4_lump_11[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_4_lump_12[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_13[] = {{-1, 1}, {-3, 1}, {-1, 1}};
constexpr Ratio case_4_lump_14[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_4_lump_15[] = {{1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_16[] = {{1, 1}, {-3, 1}, {0, 1}};
constexpr Ratio case_4_lump_17[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_4_lump_18[] = {{1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_19[] = {{1, 1}, {-3, 1}, {0, 1}};
constexpr Ratio case_4_lump_20[] = {{1, 1}, {-5, 1}, {0, 1}};
constexpr Ratio case_4_lump_21[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_22[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_23[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_24[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_4_lump_25[] = {{-1, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_4_lump_26[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_27[] = {{0, 1}, {-3, 1}, {0, 1}};
constexpr Ratio case_4_lump_28[] = {{-2, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_4_lump_29[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_30[] = {{-3, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_31[] = {{0, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_4_lump_32[] = {{0, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_4_lump_33[] = {{1, 1}, {-2, 1}, {0, 1}};
constexpr Ratio case_4_lump_34[] = {{1, 1}, {-4, 1}, {0, 1}};
constexpr Ratio case_4_lump_35[] = {{1, 1}, {-2, 1}, {0, 1}};
constexpr CompiledLump case_4_lumps[] = {
  {"conservative_x_A_x4_F", "-3*a3^2*e/(32*omega0^5)", case_4_lump_0},
  {"mu", "mu", case_4_lump_1},
  {"conservative_x_A_x", "-mu^2/(2*omega0)", case_4_lump_2},
  {"conservative_x_A_x_F2", "(15*omega0^2*a3*e^2 - 6*a2^2*e^2)/(1280*omega0^7)", case_4_lump_3},
  {"conservative_x_A_x_F2_sigma", "-9*a3*e^2/(512*omega0^6)", case_4_lump_4},
  {"conservative_x_A_x_F4", "-63*a3^2*e^4/(2097152*omega0^11)", case_4_lump_5},
  {"dissipative_x_A_x2_conjA_x", "3*mu*a3/(2*omega0^2)", case_4_lump_6},
  {"conservative_x_A_x2_conjA_x", "(9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)", case_4_lump_7},
  {"conservative_x_A_x2_conjA_x_F2", "21*a3^2*e^2/(2048*omega0^7)", case_4_lump_8},
  {"conservative_x_A_x3_conjA_x2", "-15*a3^2/(16*omega0^3)", case_4_lump_9},
  {"dissipative_x_conjA_x2_F", "3*mu*a3*e/(128*omega0^4)", case_4_lump_10},
  {"conservative_x_conjA_x2_F", "(-3*omega0^2*a3*e - 2*a2^2*e)/(32*omega0^5)", case_4_lump_11},
  {"conservative_x_conjA_x2_F_sigma", "15*a3*e/(128*omega0^4)", case_4_lump_12},
  {"conservative_x_conjA_x2_F3", "-27*a3^2*e^3/(32768*omega0^9)", case_4_lump_13},
  {"e", "e", case_4_lump_14},
  {"harmonic_im_x_F", "-3*mu*e/(64*omega0^3)", case_4_lump_15},
  {"harmonic_re_x_F3", "-3*a3*e^3/(32768*omega0^8)", case_4_lump_16},
  {"a3", "a3", case_4_lump_17},
  {"harmonic_re_x_F", "9*mu^2*e/(256*omega0^4)", case_4_lump_18},
  {"harmonic_im_x_F3", "-9*mu*a3*e^3/(65536*omega0^9)", case_4_lump_19},
  {"harmonic_re_x_F5", "-273*a3^2*e^5/(671088640*omega0^14)", case_4_lump_20},
  {"harmonic_re_x_A_x_conjA_x_F", "3*a2^2*e/(160*omega0^6)", case_4_lump_21},
  {"harmonic_re_x_A_x3", "a2^2/(12*omega0^4)", case_4_lump_22},
  {"harmonic_re_x_conjA_x_F", "-a2*e/(24*omega0^4)", case_4_lump_23},
  {"a2", "a2", case_4_lump_24},
  {"harmonic_re_x_A_x2_F2", "a2*a3*e^2/(192*omega0^8)", case_4_lump_25},
  {"harmonic_im_x_conjA_x_F", "-mu*a2*e/(32*omega0^5)", case_4_lump_26},
  {"harmonic_re_x_conjA_x_F3", "-11*a2*a3*e^3/(86016*omega0^10)", case_4_lump_27},
  {"harmonic_re_x_A_x_conjA_x2_F", "a2*a3*e/(480*omega0^6)", case_4_lump_28},
  {"harmonic_im_x_A_x2", "-4*mu*a2/(9*omega0^3)", case_4_lump_29},
  {"harmonic_re_x_A_x3_conjA_x", "-31*a2*a3/(12*omega0^4)", case_4_lump_30},
  {"harmonic_re_x_conjA_x_F2", "73*a2^2*e^2/(322560*omega0^8)", case_4_lump_31},
  {"harmonic_im_x_conjA_x_F2", "3*mu*a3*e^2/(4096*omega0^7)", case_4_lump_32},
  {"harmonic_re_x_F2", "-a2*e^2/(128*omega0^6)", case_4_lump_33},
  {"harmonic_re_x_F4", "723*a2*a3*e^4/(4587520*omega0^12)", case_4_lump_34},
  {"harmonic_im_x_F2", "129*mu*a2*e^2/(627200*omega0^7)", case_4_lump_35},
};
constexpr int case_4_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
constexpr int case_4_block_1_lumps[] = {0, 6, 8, 9, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22};
constexpr int case_4_block_1_phase[] = {0, 1};
constexpr int case_4_block_2_lumps[] = {23, 24, 25, 26, 27, 28, 29, 30};
constexpr int case_4_block_2_phase[] = {-1, 1};
constexpr int case_4_block_3_lumps[] = {4, 5, 8, 9, 10, 12, 13, 21, 31, 32};
constexpr int case_4_block_3_phase[] = {-1, 2};
constexpr int case_4_block_4_lumps[] = {24, 25, 28, 30, 33, 34};
constexpr int case_4_block_4_phase[] = {0, 0};
constexpr int case_4_block_5_lumps[] = {25, 28, 33, 34, 35};
constexpr int case_4_block_5_phase[] = {0, 2};
constexpr int case_4_block_6_lumps[] = {8, 13, 16, 19, 20};
constexpr int case_4_block_6_phase[] = {0, 3};
constexpr int case_4_block_7_lumps[] = {23, 25, 26, 27, 28, 30};
constexpr int case_4_block_7_phase[] = {1, 1};
constexpr int case_4_block_8_lumps[] = {0, 4, 5, 8, 13, 31, 32};
constexpr int case_4_block_8_phase[] = {1, 2};
constexpr int case_4_block_9_lumps[] = {25, 27};
constexpr int case_4_block_9_phase[] = {-1, 3};
constexpr int case_4_block_10_lumps[] = {5, 13};
constexpr int case_4_block_10_phase[] = {-1, 4};
constexpr int case_4_block_11_lumps[] = {34};
constexpr int case_4_block_11_phase[] = {0, 4};
constexpr int case_4_block_12_lumps[] = {20};
constexpr int case_4_block_12_phase[] = {0, 5};
constexpr int case_4_block_13_lumps[] = {27};
constexpr int case_4_block_13_phase[] = {1, 3};
constexpr int case_4_block_14_lumps[] = {5};
constexpr int case_4_block_14_phase[] = {1, 4};
constexpr RegressorBlock case_4_blocks[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, {}, case_4_block_0_lumps, column_function<subharmonic_3_second_order::columns_0, 1, 1, 14>, column_slope_function<subharmonic_3_second_order::column_slopes_0, 1, 1, 14>},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 0, case_4_block_1_phase, case_4_block_1_lumps, column_function<subharmonic_3_second_order::columns_1, 1, 1, 15>, column_slope_function<subharmonic_3_second_order::column_slopes_1, 1, 1, 15>},
  {BlockKind::harmonic, "harmonic -omega0+Omega of x", 0, 1, case_4_block_2_phase, case_4_block_2_lumps, column_function<subharmonic_3_second_order::columns_2, 1, 1, 8>, column_slope_function<subharmonic_3_second_order::column_slopes_2, 1, 1, 8>},
  {BlockKind::harmonic, "harmonic -omega0+2*Omega of x", 0, 1, case_4_block_3_phase, case_4_block_3_lumps, column_function<subharmonic_3_second_order::columns_3, 1, 1, 10>, column_slope_function<subharmonic_3_second_order::column_slopes_3, 1, 1, 10>},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, case_4_block_4_phase, case_4_block_4_lumps, column_function<subharmonic_3_second_order::columns_4, 1, 1, 6>, column_slope_function<subharmonic_3_second_order::column_slopes_4, 1, 1, 6>},
  {BlockKind::harmonic, "harmonic 2*Omega of x", 0, 1, case_4_block_5_phase, case_4_block_5_lumps, column_function<subharmonic_3_second_order::columns_5, 1, 1, 5>, column_slope_function<subharmonic_3_second_order::column_slopes_5, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic 3*Omega of x", 0, 1, case_4_block_6_phase, case_4_block_6_lumps, column_function<subharmonic_3_second_order::columns_6, 1, 1, 5>, column_slope_function<subharmonic_3_second_order::column_slopes_6, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic omega0+Omega of x", 0, 1, case_4_block_7_phase, case_4_block_7_lumps, column_function<subharmonic_3_second_order::columns_7, 1, 1, 6>, column_slope_function<subharmonic_3_second_order::column_slopes_7, 1, 1, 6>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of x", 0, 1, case_4_block_8_phase, case_4_block_8_lumps, column_function<subharmonic_3_second_order::columns_8, 1, 1, 7>, column_slope_function<subharmonic_3_second_order::column_slopes_8, 1, 1, 7>},
  {BlockKind::harmonic, "harmonic -omega0+3*Omega of x", 0, 2, case_4_block_9_phase, case_4_block_9_lumps, column_function<subharmonic_3_second_order::columns_9, 1, 1, 2>, column_slope_function<subharmonic_3_second_order::column_slopes_9, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega0+4*Omega of x", 0, 2, case_4_block_10_phase, case_4_block_10_lumps, column_function<subharmonic_3_second_order::columns_10, 1, 1, 2>, column_slope_function<subharmonic_3_second_order::column_slopes_10, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic 4*Omega of x", 0, 2, case_4_block_11_phase, case_4_block_11_lumps, column_function<subharmonic_3_second_order::columns_11, 1, 1, 1>, column_slope_function<subharmonic_3_second_order::column_slopes_11, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 5*Omega of x", 0, 2, case_4_block_12_phase, case_4_block_12_lumps, column_function<subharmonic_3_second_order::columns_12, 1, 1, 1>, column_slope_function<subharmonic_3_second_order::column_slopes_12, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+3*Omega of x", 0, 2, case_4_block_13_phase, case_4_block_13_lumps, column_function<subharmonic_3_second_order::columns_13, 1, 1, 1>, column_slope_function<subharmonic_3_second_order::column_slopes_13, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic omega0+4*Omega of x", 0, 2, case_4_block_14_phase, case_4_block_14_lumps, column_function<subharmonic_3_second_order::columns_14, 1, 1, 1>, column_slope_function<subharmonic_3_second_order::column_slopes_14, 1, 1, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "free",
    .excited = false,
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
    .name = "primary",
    .excited = true,
    .relations = case_1_relations,
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = primary::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = primary::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<primary::modulation<double>>,
    .modulation_jacobian = jacobian_function<primary::modulation_jacobian<double>>,
  },
  {
    .name = "superharmonic_3",
    .excited = true,
    .relations = case_2_relations,
    .observed_frequency = case_2_observed_frequency,
    .mode_at_rest = case_2_mode_at_rest,
    .lumps = case_2_lumps,
    .blocks = case_2_blocks,
    .evaluate_lumps = superharmonic_3::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = superharmonic_3::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<superharmonic_3::modulation<double>>,
    .modulation_jacobian = jacobian_function<superharmonic_3::modulation_jacobian<double>>,
  },
  {
    .name = "subharmonic_3",
    .excited = true,
    .relations = case_3_relations,
    .observed_frequency = case_3_observed_frequency,
    .mode_at_rest = case_3_mode_at_rest,
    .lumps = case_3_lumps,
    .blocks = case_3_blocks,
    .evaluate_lumps = subharmonic_3::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = subharmonic_3::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<subharmonic_3::modulation<double>>,
    .modulation_jacobian = jacobian_function<subharmonic_3::modulation_jacobian<double>>,
  },
  {
    .name = "subharmonic_3_second_order",
    .excited = true,
    .relations = case_4_relations,
    .observed_frequency = case_4_observed_frequency,
    .mode_at_rest = case_4_mode_at_rest,
    .lumps = case_4_lumps,
    .blocks = case_4_blocks,
    .evaluate_lumps = subharmonic_3_second_order::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = subharmonic_3_second_order::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<subharmonic_3_second_order::modulation<double>>,
    .modulation_jacobian = jacobian_function<subharmonic_3_second_order::modulation_jacobian<double>>,
  },
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
