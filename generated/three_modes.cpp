// Model three_modes: generated code, never edited by hand.
// Holds tables. Made by: secular generate three_modes.
#include "three_modes.additive_combination.hpp"
#include "three_modes.free.hpp"
#include "three_modes.lump-gradients.hpp"
#include "three_modes.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::three_modes {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2", "v3"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{1, 1}, {-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{1, 1}, {0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_10[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_11[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_12[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_13[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_14[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_15[] = {{0, 1}, {0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"omega3", dimension_0},
  {"a113", dimension_1},
  {"a123", dimension_2},
  {"a223", dimension_1},
  {"a333", dimension_1},
  {"b1111", dimension_3},
  {"b1122", dimension_4},
  {"b2222", dimension_4},
  {"b1133", dimension_5},
  {"b2233", dimension_5},
  {"e12", dimension_6},
  {"mu1", dimension_0},
  {"e1", dimension_7},
  {"mu2", dimension_0},
  {"e2", dimension_8},
  {"mu3", dimension_0},
  {"e3", dimension_9},
};
constexpr double nominal[] = {78, 209, 340, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu1", "mu1", dimension_0},
  {"conservative_v1_A_v1_A_v2_conjA_v2",
   "(omega3^2*b1122 - 2*a113*a223)/(omega1*omega3^2) + a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 + "
   "omega2 - omega3)) + a123^2/(2*omega1*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", dimension_10},
  {"conservative_v1_A_v12_conjA_v1",
   "3*b1111/(2*omega1) + (-8*omega1^2*a113^2 + 3*omega3^2*a113^2)/(omega1*omega3^2*(2*omega1 + omega3)*(2*omega1 "
   "- omega3))", dimension_11},
  {"conservative_v1_conjA_v2_F", "-e12/(4*omega1) - a123*e3/(4*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3))", dimension_12},
  {"mu2", "mu2", dimension_0},
  {"conservative_v2_A_v22_conjA_v2",
   "3*b2222/(2*omega2) + (-8*omega2^2*a223^2 + 3*omega3^2*a223^2)/(omega2*omega3^2*(2*omega2 + omega3)*(2*omega2 "
   "- omega3))", dimension_10},
  {"e1", "e1", dimension_7},
  {"harmonic_re_v1_A_v2_conjA_v12",
   "(9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 + omega2^2*a113*a123 - 3*omega3^2*a113*a123)/((omega1 - "
   "omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(2*omega1 + omega3)*(2*omega1 - "
   "omega3)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F", "a113*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2",
   "(8*omega2^2*a123*a223 - 3*omega3^2*a123*a223)/(omega3^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega2 + "
   "omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1",
   "-b1122/(4*omega2*(omega1 - omega2)) - a123^2/(4*omega2*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 "
   "- omega2 - omega3)) - a113*a223/(2*omega2*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v1_A_v22",
   "b1122/(4*omega2*(omega1 + omega2)) + a123^2/(4*omega2*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + "
   "omega2 - omega3)) + a113*a223/(2*omega2*(omega1 + omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v13", "b1111/(8*omega1^2) + a113^2/(4*omega1^2*(2*omega1 + omega3)*(2*omega1 - omega3))", dimension_13},
  {"e2", "e2", dimension_8},
  {"harmonic_re_v2_A_v2_conjA_v12",
   "b1122/(4*omega1*(omega1 - omega2)) + a123^2/(4*omega1*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - "
   "omega2 - omega3)) + a113*a223/(2*omega1*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"harmonic_re_v2_conjA_v2_F", "-a223*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v23", "b2222/(8*omega2^2) + a223^2/(4*omega2^2*(2*omega2 + omega3)*(2*omega2 - omega3))", dimension_14},
  {"harmonic_re_v2_A_v12_A_v2",
   "b1122/(4*omega1*(omega1 + omega2)) + a123^2/(4*omega1*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + "
   "omega2 - omega3)) + a113*a223/(2*omega1*(omega1 + omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"a123", "a123", dimension_2},
  {"a223", "a223", dimension_1},
  {"a113", "a113", dimension_1},
  {"e3", "e3", dimension_9},
  {"harmonic_re_v3_conjA_v1_F",
   "-a123*e2/(2*omega1*(omega1 + 2*omega2)*(omega2 + omega3)*(omega2 - omega3)) - a113*e1/(omega2*(2*omega1 + "
   "omega2)*(omega2 + omega3)*(omega2 - omega3))", {}},
  {"harmonic_re_v3_conjA_v2_F",
   "-a223*e2/(omega1*(omega1 + 2*omega2)*(omega1 + omega3)*(omega1 - omega3)) - a123*e1/(2*omega2*(omega1 + "
   "omega3)*(omega1 - omega3)*(2*omega1 + omega2))", {}},
  {"conservative_v1_A_v1_A_v3_conjA_v3",
   "(omega3^2*b1133 - 2*a113*a333)/(omega1*omega3^2) + a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 - "
   "omega2 + omega3)) + a123^2/(2*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)) - "
   "4*a113^2/(omega1*(2*omega1 + omega3)*(2*omega1 - omega3))", dimension_15},
  {"conservative_v2_A_v2_A_v3_conjA_v3",
   "(omega3^2*b2233 - 2*a223*a333)/(omega2*omega3^2) - a123^2/(2*omega2*(omega1 + omega2 + omega3)*(omega1 - "
   "omega2 - omega3)) - a123^2/(2*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)) - "
   "4*a223^2/(omega2*(2*omega2 + omega3)*(2*omega2 - omega3))", dimension_15},
  {"mu3", "mu3", dimension_0},
  {"conservative_v3_A_v32_conjA_v3", "-5*a333^2/(3*omega3^3)", dimension_15},
  {"harmonic_re_v1_A_v32_conjA_v1",
   "(-3*omega3^2*b1133 - 2*a113*a333)/(12*omega3^3*(omega1 - omega3)) + a113^2/(omega3^2*(omega1 - "
   "omega3)*(2*omega1 - omega3)) - a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1 - omega2 - "
   "omega3)*(omega1 - omega3))", {}},
  {"harmonic_re_v1_A_v32_conjA_v2",
   "-a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)) + "
   "2*a123*a223/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega2 - omega3)) + "
   "2*a113*a123/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + omega3)*(omega1 - "
   "omega2 + 2*omega3))", {}},
  {"harmonic_re_v1_A_v2_A_v3_conjA_v3",
   "2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) + 4*a123*a223/((omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega2 + omega3)*(2*omega2 - omega3)) + (4*omega1^2*a113*a123 - 4*omega2^2*a113*a123 - "
   "4*omega3^2*a113*a123)/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - "
   "omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v1_A_v2_A_v32",
   "-a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)) - "
   "2*a123*a223/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) + "
   "2*a113*a123/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - omega3)*(omega1 - "
   "omega2 - 2*omega3))", {}},
  {"harmonic_re_v1_A_v1_A_v32",
   "(3*omega3^2*b1133 + 2*a113*a333)/(12*omega3^3*(omega1 + omega3)) + a113^2/(omega3^2*(omega1 + "
   "omega3)*(2*omega1 + omega3)) + a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1 - omega2 + "
   "omega3)*(omega1 + omega3))", {}},
  {"harmonic_re_v2_A_v32_conjA_v1",
   "a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)) - "
   "2*a113*a123/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega1 - omega3)) + "
   "2*a123*a223/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - omega3)*(omega1 - "
   "omega2 - 2*omega3))", {}},
  {"harmonic_re_v2_A_v32_conjA_v2",
   "(-3*omega3^2*b2233 - 2*a223*a333)/(12*omega3^3*(omega2 - omega3)) + a223^2/(omega3^2*(omega2 - "
   "omega3)*(2*omega2 - omega3)) + a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1 - omega2 + "
   "omega3)*(omega2 - omega3))", {}},
  {"harmonic_re_v2_A_v2_A_v32",
   "(3*omega3^2*b2233 + 2*a223*a333)/(12*omega3^3*(omega2 + omega3)) + a223^2/(omega3^2*(omega2 + "
   "omega3)*(2*omega2 + omega3)) - a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1 - omega2 - "
   "omega3)*(omega2 + omega3))", {}},
  {"harmonic_re_v2_A_v1_A_v3_conjA_v3",
   "-2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) - 4*a113*a123/((omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 + omega3)*(2*omega1 - omega3)) + (4*omega1^2*a123*a223 - 4*omega2^2*a123*a223 + "
   "4*omega3^2*a123*a223)/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - "
   "omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v2_A_v1_A_v32",
   "a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)) + "
   "2*a113*a123/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) + "
   "2*a123*a223/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + omega3)*(omega1 - "
   "omega2 + 2*omega3))", {}},
  {"a333", "a333", dimension_1},
  {"harmonic_re_v3_A_v3_conjA_v12",
   "b1133/(4*omega1*(omega1 - omega3)) - a113^2/(omega1*omega3*(omega1 - omega3)*(2*omega1 - omega3)) + "
   "a123^2/(4*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)*(omega1 - omega3)) + "
   "a113*a333/(2*omega1*(omega1 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
  {"harmonic_re_v3_A_v3_conjA_v1_conjA_v2",
   "-2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega1 - omega3)) - "
   "2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega2 - omega3)) + "
   "2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 + omega2 - "
   "2*omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 "
   "- omega2 + omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 - "
   "2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v2_A_v3_conjA_v1",
   "-2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega1 - omega3)) + "
   "2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) - "
   "2*a113*a123/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 - omega2 - "
   "2*omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 - "
   "omega2 - 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - "
   "omega3)*(omega1 - omega2 - 2*omega3))", {}},
  {"harmonic_re_v3_A_v22_conjA_v3",
   "b2233/(4*omega2*(omega2 - omega3)) - a223^2/(omega2*omega3*(omega2 - omega3)*(2*omega2 - omega3)) - "
   "a123^2/(4*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega2 - omega3)) + "
   "a223*a333/(2*omega2*(omega2 - omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v22_A_v3",
   "b2233/(4*omega2*(omega2 + omega3)) + a223^2/(omega2*omega3*(omega2 + omega3)*(2*omega2 + omega3)) - "
   "a123^2/(4*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)*(omega2 + omega3)) + "
   "a223*a333/(2*omega2*(omega2 + omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v1_A_v3_conjA_v2",
   "2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) - "
   "2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega2 - omega3)) + "
   "2*a123*a223/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 + "
   "2*omega3)) - 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - "
   "omega2 + 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 + "
   "2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v1_A_v2_A_v3",
   "2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega1 + omega3)) + "
   "2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega2 + omega3)) + "
   "2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 + omega2 - "
   "omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - "
   "omega2 + omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + "
   "2*omega3)*(omega1 - omega2 - omega3))", {}},
  {"harmonic_re_v3_A_v12_A_v3",
   "b1133/(4*omega1*(omega1 + omega3)) + a113^2/(omega1*omega3*(omega1 + omega3)*(2*omega1 + omega3)) + "
   "a123^2/(4*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)*(omega1 + omega3)) + "
   "a113*a333/(2*omega1*(omega1 + omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))", {}},
};

// Case additive_combination.
constexpr int case_0_relations[] = {-1, -1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {0, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1},
    {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false, true};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    21, 22, 23};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 4},
  {BlockKind::modulation, "modulation of v2", 1, 0, 4},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, 3},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic 0 of v3", 2, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v3", 2, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega2 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega1 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic -omega2+Omega of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v3", 2, 2, 1},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 1, 3, 4, 5, 6, 7, 7, 8, 9, 10, 3, 11, 9, 7, 8, 12, 13, 14, 9, 7,
    9, 15, 9, 15, 16, 3, 17, 7, 18, 19, 20, 18, 21, 19, 20, 22, 23, 23, 22};
constexpr int case_0_phases[] = {0, 0, 0, 1, -2, 1, 0, 0, 0, 1, 0, 0, -1, 2, 0, 0, 0, 1, 0, 1, 0, 3, 0, 0, 1, 0,
    0, 1, 3, 0, 0, 0, 0, 0, 0, 1, -2, 1, 0, 0, -1, 2, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 3, 0, 0, 1, 0, 0, 1, 3, 0,
    0, 0, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 0, 0, 0, -1, 0, 0, 1, 0, -1, 0, 1, 0, 1, 0, 1, 1, 0,
    0, 1};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, additive_combination::blocks,
    case_0_block_lumps, case_0_phases, 4);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, additive_combination::blocks,
    case_0_blocks, case_0_observed_frequency, case_0_mode_at_rest};

// Case free.
constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1},
    {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false, false};
constexpr int case_1_lump_numbers[] = {0, 24, 1, 2, 4, 25, 5, 26, 27, 20, 18, 7, 28, 10, 29, 30, 9, 31, 32, 11,
    12, 19, 14, 33, 34, 35, 16, 36, 37, 17, 38, 39, 40, 41, 42, 43, 44, 45, 46};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 4},
  {BlockKind::modulation, "modulation of v2", 1, 0, 4},
  {BlockKind::modulation, "modulation of v3", 2, 0, 4},
  {BlockKind::harmonic, "harmonic -omega1+omega3 of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -omega2+omega3 of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega2+omega3 of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+omega3 of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega3 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega2+2*omega3 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, 3},
  {BlockKind::harmonic, "harmonic omega2+2*omega3 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega3 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega3 of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic -omega2+omega3 of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega2+omega3 of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+omega3 of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega3 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega2+2*omega3 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+2*omega3 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic omega1+2*omega3 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic 0 of v3", 2, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega3 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega2 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega1 of v3", 2, 1, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1-omega2+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega2+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega2-omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega2+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic omega1-omega2+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+omega2+omega3 of v3", 2, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega3 of v3", 2, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 2, 4, 5, 6, 1, 5, 7, 8, 9, 10, 10, 9, 11, 12, 13, 14, 11, 15,
    16, 17, 16, 18, 19, 11, 20, 10, 21, 21, 10, 22, 23, 16, 24, 25, 26, 11, 16, 27, 28, 16, 29, 11, 10, 9, 21, 30,
    30, 21, 10, 9, 31, 32, 33, 8, 34, 35, 36, 37, 38};
constexpr int case_1_phases[] = {-1, 0, 1, 0, 0, -1, 1, 0, 0, 1, 1, 0, 1, 0, 1, 0, -2, 1, 0, 0, -1, 0, 2, 0, -1,
    2, 0, 0, 0, -1, 2, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 1, 0, 2, 0, 1, 2, 0, 0, 2, 1, 0, 0, 3, 0, 0, 0, -1,
    0, 1, 0, 0, -1, 1, 0, 0, 1, 1, 0, 1, 0, 1, 0, -2, 1, 0, 0, -1, 0, 2, 0, -1, 2, 0, 0, 0, -1, 2, 0, 0, 1, 2, 0,
    0, 3, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 1, 2, 0, 0, 2, 1, 0, 0, 3, 0, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0,
    0, 2, 0, 0, 1, 1, 0, 0, 2, 0, 0, 0, -2, 0, 1, 0, -1, -1, 1, 0, -1, 1, 1, 0, 0, 0, 3, 0, 0, 2, -1, 0, 0, 2, 1,
    0, 1, -1, 1, 0, 1, 1, 1, 0, 2, 0, 1, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, free::blocks, case_1_block_lumps,
    case_1_phases, 4);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, free::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("additive_combination", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("free", false, {}, case_1_lumps, case_1),
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
