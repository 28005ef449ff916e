// Model internal_resonance: generated code, never edited by hand.
// Holds tables. Made by: secular generate internal_resonance.
#include "internal_resonance.one_to_one.hpp"
#include "internal_resonance.one_to_two.hpp"
#include "internal_resonance.one_to_three.hpp"
#include "internal_resonance.free_one_to_two.hpp"
#include "internal_resonance.lump-gradients.hpp"
#include "internal_resonance.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::internal_resonance {

namespace {

constexpr std::string_view coordinates[] = {"x", "y"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{1, 1}, {-3, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_10[] = {{-1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_12[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_13[] = {{1, 1}, {-3, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_14[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_15[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_16[] = {{0, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_17[] = {{0, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_18[] = {{0, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_19[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_20[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_21[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"a1", dimension_1},
  {"a2", dimension_2},
  {"a3", dimension_3},
  {"a4", dimension_2},
  {"b1", dimension_4},
  {"b2", dimension_5},
  {"b3", dimension_6},
  {"b4", dimension_7},
  {"b5", dimension_6},
  {"mu1", dimension_0},
  {"e1", dimension_8},
  {"mu2", dimension_0},
  {"e2", dimension_9},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"conservative_x_A_x2_conjA_y",
   "(9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2)) - "
   "2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_10},
  {"mu1", "mu1", dimension_0},
  {"conservative_x_A_x_A_y_conjA_y",
   "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^3*omega2^2) + 4*a3^2/(omega1*(omega1 + "
   "2*omega2)*(omega1 - 2*omega2)) - 4*a2^2/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_11},
  {"conservative_x_A_x2_conjA_x",
   "(9*omega1^2*b1 - 10*a1^2)/(6*omega1^3) + (-8*omega1^2*a2^2 + 3*omega2^2*a2^2)/(omega1*omega2^2*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", dimension_12},
  {"e1", "e1", dimension_8},
  {"conservative_x_A_y2_conjA_y",
   "(9*omega2^2*b4 - 10*a3*a4)/(6*omega1*omega2^2) + (-3*omega1^2*a2*a3 + 8*omega2^2*a2*a3)/(omega1^3*(omega1 + "
   "2*omega2)*(omega1 - 2*omega2))", dimension_13},
  {"conservative_x_A_x_A_y_conjA_x",
   "3*b2/omega1 + (-2*omega1^2*a2*a3 + 12*omega2^2*a2*a3)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 - "
   "2*omega2)) + (-12*omega1^2*a1*a2 + 2*omega2^2*a1*a2)/(omega1^3*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_10},
  {"conservative_x_A_y2_conjA_x",
   "(3*omega2^2*b3 + 2*a2*a4)/(6*omega1*omega2^2) + 2*a3^2/(omega1^2*(omega1 - 2*omega2)) - "
   "2*a2^2/(omega1*omega2*(2*omega1 - omega2)) - a1*a3/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_11},
  {"conservative_y_A_x2_conjA_y",
   "(3*omega1^2*b3 + 2*a1*a3)/(6*omega1^2*omega2) + 2*a3^2/(omega1*omega2*(omega1 - 2*omega2)) - "
   "2*a2^2/(omega2^2*(2*omega1 - omega2)) + a2*a4/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_11},
  {"conservative_y_A_x_A_y_conjA_y",
   "3*b4/omega2 + (-2*omega1^2*a3*a4 + 12*omega2^2*a3*a4)/(omega2^3*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + "
   "(-12*omega1^2*a2*a3 + 2*omega2^2*a2*a3)/(omega1^2*omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_13},
  {"conservative_y_A_x2_conjA_x",
   "(9*omega1^2*b2 - 10*a1*a2)/(6*omega1^2*omega2) + (-8*omega1^2*a2*a3 + 3*omega2^2*a2*a3)/(omega2^3*(2*omega1 "
   "+ omega2)*(2*omega1 - omega2))", dimension_10},
  {"e2", "e2", dimension_9},
  {"mu2", "mu2", dimension_0},
  {"conservative_y_A_y2_conjA_y",
   "(9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 + 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + "
   "2*omega2)*(omega1 - 2*omega2))", dimension_11},
  {"conservative_y_A_y2_conjA_x",
   "(9*omega2^2*b4 + 2*a3*a4)/(6*omega2^3) + 2*a3*a4/(omega1*omega2*(omega1 - 2*omega2)) - "
   "2*a2*a3/(omega2^2*(2*omega1 - omega2)) - a2*a3/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_13},
  {"a2", "a2", dimension_2},
  {"a3", "a3", dimension_3},
  {"a1", "a1", dimension_1},
  {"harmonic_re_x_A_y3",
   "(-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + 2*a2*a3/((omega1 + "
   "2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_x_A_x_A_y2",
   "(3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) + a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + "
   "2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) - a1*a3/(2*omega2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x2_A_y",
   "3*b2/((omega1 + omega2)*(3*omega1 + omega2)) + (12*omega1^2*a1*a2 + 4*omega1*omega2*a1*a2 + "
   "2*omega2^2*a1*a2)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + "
   "(18*omega1^2*a2*a3 + 4*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1*(omega1 + omega2)*(omega1 + "
   "2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3", "(3*omega1^2*b1 + 2*a1^2)/(24*omega1^4) + a2^2/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_14},
  {"a4", "a4", dimension_2},
  {"harmonic_re_y_A_y3", "(3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_15},
  {"harmonic_re_y_A_x_A_y2",
   "3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 + 4*omega1*omega2*a3*a4 + "
   "12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + "
   "(4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1 + "
   "2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_y_A_x2_A_y",
   "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 + omega2)) + a3^2/(omega1^2*(omega1 + omega2)*(omega1 + "
   "2*omega2)) + a2^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + a2*a4/(2*omega1*(omega1 + "
   "omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x3",
   "(3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + 2*a2*a3/((2*omega1 + "
   "omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"conservative_x_A_x", "-mu1^2/(2*omega1)", dimension_0},
  {"conservative_x_A_x_A_y_conjA_y",
   "(2*omega1^2*omega2^2*b3 - 4*omega1^2*a2*a4 - 4*omega2^2*a1*a3 + omega2^2*a2^2)/(2*omega1^3*omega2^2) + "
   "2*a2^2/(omega1*omega2*(2*omega1 + omega2)) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_11},
  {"conservative_x_A_x2_conjA_x",
   "(18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 - "
   "20*omega2^2*a1^2)/(12*omega1^3*omega2^2)", dimension_12},
  {"dissipative_x_A_y_conjA_x", "a2*mu2/(2*omega1^2)", dimension_16},
  {"conservative_x_conjA_x_F", "a2*e2/(8*omega1^2*omega2) + a1*e1/(2*omega1*(omega1 + omega2)*(omega1 - omega2))", dimension_17},
  {"dissipative_y_A_x2", "(2*a2*mu1 - a2*mu2)/(4*omega2^2)", dimension_16},
  {"conservative_y_A_y", "-mu2^2/(2*omega2)", dimension_0},
  {"conservative_y_A_x_A_y_conjA_x",
   "(omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 - 2*omega2^2*a1*a3)/(omega1^2*omega2^3) + (2*omega1*a2^2 - "
   "omega2*a2^2)/(2*omega1*omega2^2*(2*omega1 + omega2)) + 4*a3^2/(omega2*(omega1 + 2*omega2)*(omega1 - "
   "2*omega2))", dimension_11},
  {"dissipative_y_F", "mu2*e2/(8*omega2^2)", dimension_18},
  {"harmonic_re_x_A_y_conjA_x2",
   "(9*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + 4*a2*a3/(omega1*(omega1 - "
   "omega2)*(omega1 - 2*omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_x_conjA_y_F", "-a2*e1/(omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_im_x_F", "-omega2*mu1*e1/((omega1 + omega2)^2*(omega1 - omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_y",
   "(-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (6*omega1^2*a2*a3 - "
   "16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x",
   "-6*b2/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a1*a2 + 8*omega1*omega2*a1*a2 + "
   "4*omega2^2*a1*a2)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + "
   "(4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_x_A_x2", "-4*a1*mu1/(9*omega1^3)", dimension_19},
  {"harmonic_re_x_A_x2_A_y", "-4*a2*a3/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_im_x_A_y2", "(4*omega2*a3*mu1 - 8*omega2*a3*mu2)/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_x_A_y_F", "2*a3*e2/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_x_A_y2_conjA_x",
   "(-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) - a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - "
   "2*omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_F", "a1*e1/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_x_A_x3", "(-2*omega1*a2^2 - 2*omega2*a2^2)/(omega2^3*(2*omega1 + omega2)^2)", {}},
  {"harmonic_im_y_A_y_conjA_x", "(4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^2*(omega1 - 2*omega2)^2)", {}},
  {"harmonic_re_y_A_x_A_y_conjA_y",
   "6*b4/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 - 8*omega1*omega2*a2*a3 - "
   "4*omega2^2*a2*a3)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)) + "
   "(-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_y_A_x2_conjA_x",
   "(9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 - 10*omega2^2*a1*a2)/(3*omega1^2*omega2^2*(omega1 + "
   "omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_y_conjA_x2",
   "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) + a3^2/(omega1^2*(omega1 - omega2)*(omega1 - "
   "2*omega2))", {}},
  {"harmonic_re_y_conjA_y_F", "-a3*e1/(omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_y_A_x2_A_y", "-4*a2*a4/(9*omega2^4)", dimension_15},
  {"harmonic_im_y_A_y2", "-4*a4*mu2/(9*omega2^3)", dimension_20},
  {"harmonic_re_y_A_y_F", "2*a4*e2/(9*omega2^4)", dimension_21},
  {"harmonic_re_y_A_y2_conjA_x",
   "3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 - 4*omega1*omega2*a3*a4 + "
   "12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) - "
   "2*a2*a3/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"conservative_x_A_y_conjA_x2",
   "(9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2)) - "
   "2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_10},
  {"conservative_y_A_x3", "(3*omega1^2*b2 + 2*a1*a2)/(6*omega1^2*omega2) + a2*a3/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_10},
  {"harmonic_re_x_A_y2_conjA_x",
   "(-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) - a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - "
   "2*omega2)) + a2^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + a1*a3/(2*omega2*(omega1 + "
   "2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_x_A_x_A_y_conjA_x",
   "-6*b2/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (24*omega1^2*a1*a2 - "
   "4*omega2^2*a1*a2)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y_conjA_x2",
   "(3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) + a3^2/(omega1^2*(omega1 - omega2)*(omega1 - "
   "2*omega2)) - a2^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + a2*a4/(2*omega1*(omega1 - "
   "omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x_A_y_conjA_y",
   "6*b4/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^2*a2*a3 + "
   "4*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_x2_conjA_x",
   "(9*omega1^2*b2 - 10*a1*a2)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-16*omega1^2*a2*a3 + "
   "6*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_y_A_y2_conjA_x",
   "3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 - 4*omega1*omega2*a3*a4 + "
   "12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + "
   "(-4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 + 18*omega2^2*a2*a3)/(omega2*(omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
};

// Case one_to_one.
constexpr int case_0_relations[] = {-1, 1, 0, -1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    21, 22, 23, 24, 25, 26};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 8},
  {BlockKind::modulation, "modulation of y", 1, 0, 8},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, 4},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, 4},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 2, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 15, 16, 17,
    18, 19, 20, 21, 15, 16, 22, 15, 16, 22, 23, 24, 25, 26};
constexpr int case_0_phases[] = {0, 0, 0, 0, 2, 0, 0, 3, 0, 0, 0, 0, 0, 2, 0, 0, 3, 0};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, one_to_one::blocks, case_0_block_lumps,
    case_0_phases, 3);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, one_to_one::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case one_to_two.
constexpr int case_1_relations[] = {-2, 1, 0, 0, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {0, 1}, {1, 2}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr int case_1_lump_numbers[] = {1, 27, 28, 29, 30, 15, 31, 32, 12, 33, 13, 34, 35, 11, 16, 17, 36, 37, 4,
    38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 18, 19, 48, 49, 50, 22, 51, 52, 53, 54, 55, 56, 57, 23, 24};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 7},
  {BlockKind::modulation, "modulation of y", 1, 0, 8},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 4},
  {BlockKind::harmonic, "harmonic Omega of x", 0, 1, 6},
  {BlockKind::harmonic, "harmonic omega2+Omega of x", 0, 1, 5},
  {BlockKind::harmonic, "harmonic omega1+Omega of x", 0, 1, 5},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1 of y", 1, 1, 7},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, 4},
  {BlockKind::harmonic, "harmonic omega2+Omega of y", 1, 1, 5},
  {BlockKind::harmonic, "harmonic omega1+Omega of y", 1, 1, 7},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 15, 18, 19,
    20, 21, 22, 14, 17, 23, 24, 25, 4, 5, 26, 27, 28, 29, 30, 14, 17, 23, 25, 31, 32, 33, 5, 34, 35, 36, 34, 36,
    37, 38, 39, 14, 17, 23, 25, 31, 40, 41, 42, 43};
constexpr int case_1_phases[] = {0, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0, 1, 0, 3, 0, 1, 2, 0, 1, 0, 0, 0, 0, 0, 0, 1, 1,
    1, 0, 1, 0, 3, 0, 1, 2, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, one_to_two::blocks, case_1_block_lumps,
    case_1_phases, 3);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, one_to_two::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

// Case one_to_three.
constexpr int case_2_relations[] = {-3, 1, 0, -1, 0, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 1}, {3, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr int case_2_lump_numbers[] = {1, 2, 3, 4, 58, 59, 12, 13, 15, 17, 16, 60, 20, 39, 61, 21, 18, 19, 22, 62,
    11, 63, 64, 65, 25, 23, 24};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 5},
  {BlockKind::modulation, "modulation of y", 1, 0, 4},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+omega2 of x", 0, 1, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of x", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega2 of x", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of y", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega1+omega2 of y", 1, 1, 1},
  {BlockKind::harmonic, "harmonic Omega of y", 1, 2, 4},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of y", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 3, 4, 1, 5, 6, 7, 8, 9, 9, 10, 10, 8, 11, 12, 13, 14, 15, 16, 17,
    8, 10, 8, 18, 18, 10, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr int case_2_phases[] = {-1, 1, 0, 0, 0, 0, 0, 2, 0, 1, 1, 0, -1, 2, 0, 0, 1, 0, 0, 3, 0, 1, 2, 0, -1, 1,
    0, 0, 0, 0, 0, 2, 0, 1, 1, 0, 0, 0, 1, -1, 2, 0, 0, 3, 0, 1, 2, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, one_to_three::blocks, case_2_block_lumps,
    case_2_phases, 3);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, one_to_three::blocks, case_2_blocks,
    case_2_observed_frequency, case_2_mode_at_rest};

// Case free_one_to_two.
constexpr int case_3_relations[] = {-2, 1, 0};
constexpr Ratio case_3_observed_frequency[] = {{0, 1}, {1, 2}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_3_mode_at_rest[] = {false, false};
constexpr int case_3_lump_numbers[] = {1, 27, 28, 29, 30, 15, 32, 12, 33, 13, 34, 16, 17, 36, 42, 43, 45, 47, 39,
    40, 41, 18, 19, 48, 49, 50, 22, 51, 53, 54, 56, 57, 23, 24};
constexpr auto case_3_lumps = chosen_lumps(lump_table, case_3_lump_numbers);
constexpr BlockTable case_3_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 6},
  {BlockKind::modulation, "modulation of y", 1, 0, 6},
  {BlockKind::harmonic, "harmonic 0 of x", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of x", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+omega2 of x", 0, 1, 4},
  {BlockKind::harmonic, "harmonic omega2 of x", 0, 1, 4},
  {BlockKind::harmonic, "harmonic 3*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of x", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1 of y", 1, 1, 5},
  {BlockKind::harmonic, "harmonic 0 of y", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of y", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+omega2 of y", 1, 1, 5},
  {BlockKind::harmonic, "harmonic 3*omega2 of y", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of y", 1, 2, 1},
};
constexpr int case_3_block_lumps[] = {0, 1, 2, 3, 4, 5, 5, 6, 7, 8, 9, 10, 11, 12, 13, 11, 14, 15, 4, 5, 16, 17,
    12, 18, 19, 20, 21, 22, 11, 14, 23, 24, 25, 5, 26, 27, 26, 28, 29, 11, 14, 23, 30, 31, 32, 33};
constexpr int case_3_phases[] = {0, 0, 0, 0, 2, 0, 1, 1, 0, 0, 1, 0, 0, 3, 0, 1, 2, 0, 1, 0, 0, 0, 0, 0, 0, 2, 0,
    1, 1, 0, 0, 3, 0, 1, 2, 0};
constexpr auto case_3_blocks = regressor_blocks(case_3_block_table, free_one_to_two::blocks, case_3_block_lumps,
    case_3_phases, 3);
constexpr GeneratedCase case_3 = {&lump_functions, case_3_lump_numbers, free_one_to_two::blocks, case_3_blocks,
    case_3_observed_frequency, case_3_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("one_to_one", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("one_to_two", true, case_1_relations, case_1_lumps, case_1),
  compiled_case("one_to_three", true, case_2_relations, case_2_lumps, case_2),
  compiled_case("free_one_to_two", false, case_3_relations, case_3_lumps, case_3),
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
