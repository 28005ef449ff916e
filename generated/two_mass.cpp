// Model two_mass: generated code, never edited by hand.
// Holds tables. Made by: secular generate two_mass.
#include "two_mass.primary_1.hpp"
#include "two_mass.primary_2.hpp"
#include "two_mass.principal_parametric_1.hpp"
#include "two_mass.principal_parametric_2.hpp"
#include "two_mass.additive_combination.hpp"
#include "two_mass.free.hpp"
#include "two_mass.free_1.hpp"
#include "two_mass.lump-gradients.hpp"
#include "two_mass.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_3[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_7[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_8[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_9[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_10[] = {{-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_12[] = {{1, 1}, {-3, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_13[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_14[] = {{-1, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_15[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_16[] = {{1, 1}, {-3, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_17[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_18[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_19[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_20[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_21[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_22[] = {{-1, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_23[] = {{0, 1}, {0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio dimension_24[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_25[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_26[] = {{1, 1}, {-2, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_27[] = {{-1, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_28[] = {{0, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_29[] = {{0, 1}, {-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio dimension_30[] = {{0, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_31[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"mu11", dimension_0},
  {"mu12", dimension_1},
  {"mu13", dimension_2},
  {"alpha21", dimension_3},
  {"alpha22", dimension_4},
  {"alpha23", dimension_5},
  {"delta21", dimension_6},
  {"delta22", dimension_7},
  {"delta23", dimension_8},
  {"alpha31", dimension_9},
  {"alpha32", dimension_10},
  {"alpha33", dimension_11},
  {"alpha34", dimension_12},
  {"delta31", dimension_13},
  {"delta32", dimension_14},
  {"delta33", dimension_15},
  {"delta34", dimension_15},
  {"delta35", dimension_16},
  {"eta11", dimension_17},
  {"eta12", dimension_18},
  {"mu22", dimension_0},
  {"mu21", dimension_19},
  {"mu23", dimension_20},
  {"alpha24", dimension_4},
  {"delta24", dimension_7},
  {"alpha35", dimension_11},
  {"delta36", dimension_15},
  {"eta21", dimension_21},
  {"eta22", dimension_18},
};
constexpr double nominal[] = {77.85, 209.35, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"conservative_v1_A_v12_F", "(-3*omega1^2*delta21*eta12 + 5*alpha21*eta12)/(12*omega1^3)", dimension_22},
  {"mu11", "mu11", dimension_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_F2", "-eta12^2/(12*omega1^3)", dimension_23},
  {"conservative_v1_A_v1_A_v2_conjA_v2",
   "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - "
   "2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + "
   "2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + "
   "2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + "
   "(4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + "
   "4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - "
   "4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", dimension_24},
  {"mu13", "mu13", dimension_2},
  {"conservative_v1_A_v12_conjA_v1",
   "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - "
   "10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + "
   "16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + "
   "3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_25},
  {"eta11", "eta11", dimension_17},
  {"conservative_v1_A_v2_conjA_v2_F",
   "(-omega2^2*delta23*eta12 + alpha23*eta12)/(2*omega1^3) + (-omega2^2*delta23*eta22 - "
   "alpha23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_26},
  {"mu22", "mu22", dimension_0},
  {"conservative_v2_A_v2_F2", "eta22^2/(4*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu23", "mu23", dimension_20},
  {"conservative_v2_A_v22_conjA_v2",
   "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - "
   "10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - "
   "3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + "
   "8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_24},
  {"eta12", "eta12", dimension_18},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", dimension_8},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", dimension_6},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1",
   "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + "
   "2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + "
   "(-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + "
   "2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_F",
   "(-omega1*mu12*eta22 + omega2*mu12*eta22)/(2*omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) - "
   "mu12*eta12/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"mu12", "mu12", dimension_1},
  {"harmonic_re_v1_A_v2_conjA_v1_F",
   "omega1*delta22*eta12/(omega2*(omega1 + omega2)*(2*omega1 - omega2)) + (omega1*omega2*delta22*eta22 + "
   "alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1^2*alpha22*eta12 - "
   "2*omega1*omega2*alpha22*eta12 + omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2",
   "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 "
   "- 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + "
   "(-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - "
   "4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - "
   "16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - "
   "2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1",
   "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + "
   "8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - "
   "16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - "
   "24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - "
   "2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - "
   "4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - "
   "4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F",
   "-omega1*delta22*eta12/(omega2*(omega1 - omega2)*(2*omega1 + omega2)) + (-omega1*omega2*delta22*eta22 + "
   "alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (omega1^2*alpha22*eta12 - "
   "2*omega1*omega2*alpha22*eta12 - omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22",
   "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + "
   "(-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", dimension_6},
  {"harmonic_im_v1_A_v12",
   "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + "
   "(2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2",
   "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - "
   "2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + "
   "(2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + "
   "2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12",
   "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + "
   "(-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + "
   "4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + "
   "120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + "
   "36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - "
   "48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + "
   "18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + "
   "4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 "
   "- omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - "
   "4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - "
   "omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + "
   "8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - "
   "4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - "
   "2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1",
   "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + "
   "12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - "
   "3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - "
   "2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - "
   "omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + "
   "2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - "
   "omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - "
   "omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + "
   "2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + "
   "omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + "
   "2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22_F",
   "-delta23*eta22/(4*omega1*(omega1 - 2*omega2)) + alpha23*eta22/(4*omega1*omega2*(omega1 - omega2)*(omega1 - "
   "2*omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(8*omega2*(omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22",
   "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + "
   "12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + "
   "3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + "
   "2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - "
   "omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + "
   "2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + "
   "omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + "
   "omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + "
   "2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - "
   "omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 "
   "+ 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v23",
   "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 "
   "- 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + "
   "(-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + "
   "2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v12_F", "(17*omega1^2*delta21*eta12 - 3*alpha21*eta12)/(48*omega1^4)", dimension_27},
  {"harmonic_re_v1_A_v13",
   "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + "
   "2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + "
   "alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_13},
  {"harmonic_re_v1_A_v12_A_v2",
   "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + "
   "(8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - "
   "4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + "
   "120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - "
   "36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - "
   "48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - "
   "18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + "
   "4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 "
   "+ omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + "
   "4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + "
   "omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + "
   "8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + "
   "4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + "
   "2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"eta22", "eta22", dimension_18},
  {"harmonic_im_v2_A_v2_conjA_v1",
   "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + "
   "2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + "
   "(2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + "
   "2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + "
   "omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", dimension_7},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", dimension_7},
  {"harmonic_im_v2_conjA_v1_F", "-omega1*mu21*eta22/(2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2",
   "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + "
   "2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + "
   "(-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - "
   "2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", dimension_7},
  {"harmonic_im_v2_A_v22",
   "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + "
   "(-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", dimension_19},
  {"eta21", "eta21", dimension_21},
  {"harmonic_re_v2_A_v2_conjA_v2_F",
   "(omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 + 2*omega2^4*delta24*eta22 - "
   "6*omega2^2*alpha24*eta22)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - "
   "2*omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v1_F",
   "(-3*omega1^4*delta22*eta22 + 2*omega1^2*omega2^2*delta22*eta12 + 3*omega1^2*alpha22*eta22 + "
   "2*omega2^2*alpha22*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2",
   "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + "
   "(-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - "
   "8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + "
   "8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + "
   "16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + "
   "4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1",
   "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 "
   "+ 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + "
   "(-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - "
   "2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + "
   "6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2))", {}},
  {"harmonic_re_v2_A_v12_F",
   "alpha22*eta12/(omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-omega1^2*delta22*eta22 - "
   "alpha22*eta22)/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v1_F",
   "-eta12*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) - omega1*mu21*eta22/(2*(omega1 + "
   "omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12",
   "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + "
   "(-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12",
   "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + "
   "6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + "
   "3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + "
   "2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + "
   "3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + "
   "2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - "
   "omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - "
   "2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 "
   "+ 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + "
   "omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + "
   "alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1_F",
   "(-2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 - alpha23*eta12)/(12*omega1^3*(omega1 - omega2)) + "
   "(omega1*delta23*eta22 - omega2*delta23*eta22)/(2*omega1^2*(omega1 - 2*omega2)) - "
   "alpha23*eta22/(2*omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1",
   "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + "
   "(4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + "
   "4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + "
   "(-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + "
   "96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - "
   "16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + "
   "48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + "
   "36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + "
   "12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + "
   "(4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + "
   "8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - "
   "4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 "
   "+ 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_F",
   "(9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 - 24*omega1*omega2^3*delta24*eta22 + "
   "2*omega1*omega2*alpha24*eta22 + 18*omega2^4*delta24*eta22 - "
   "6*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F",
   "(2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 - alpha23*eta12)/(12*omega1^3*(omega1 + omega2)) + "
   "(omega1*delta23*eta22 + omega2*delta23*eta22)/(2*omega1^2*(omega1 + 2*omega2)) - "
   "alpha23*eta22/(2*omega1^2*(omega1 + omega2)*(omega1 + 2*omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2",
   "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + "
   "6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + "
   "3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + "
   "2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + "
   "3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - "
   "2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - "
   "omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + "
   "2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 "
   "- 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + "
   "omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + "
   "alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22",
   "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + "
   "(4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - "
   "4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + "
   "(24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + "
   "96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - "
   "16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - "
   "48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + "
   "36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + "
   "12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + "
   "(-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + "
   "2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - "
   "8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - "
   "4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 "
   "+ omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v23",
   "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + "
   "2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - "
   "alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_15},
  {"harmonic_re_v2_A_v13",
   "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 "
   "+ 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + "
   "(-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + "
   "2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"conservative_v1_A_v1_A_v2_F",
   "(-omega1^2*delta22*eta22 + alpha22*eta22)/(2*omega1*omega2^2) + (omega1^2*delta22*eta12 + "
   "alpha22*eta12)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_28},
  {"conservative_v1_A_v1_F2", "-eta12^2/(4*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"conservative_v2_A_v22_F", "(-3*omega2^2*delta24*eta22 + 5*alpha24*eta22)/(12*omega2^3)", dimension_28},
  {"conservative_v2_A_v2_F2", "-eta22^2/(12*omega2^3)", dimension_23},
  {"harmonic_im_v1_conjA_v2_F", "omega2*mu12*eta12/(2*omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2_F",
   "(-2*omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 + 3*omega2^4*delta23*eta12 - "
   "3*omega2^2*alpha23*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_conjA_v1_F",
   "(2*omega1^4*delta21*eta12 + omega1^2*omega2^2*delta21*eta12 - 6*omega1^2*alpha21*eta12 + "
   "omega2^2*alpha21*eta12)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2))", {}},
  {"harmonic_re_v1_A_v22_F",
   "-alpha23*eta22/(omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-omega2^2*delta23*eta12 - "
   "alpha23*eta12)/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v2_F",
   "mu12*eta22/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) - omega2*mu12*eta12/(2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_conjA_v12_F",
   "(-18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 - 9*omega1^2*omega2^2*delta21*eta12 + "
   "6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 + "
   "omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v1_F",
   "(-omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 + alpha22*eta22)/(12*omega2^3*(omega1 - omega2)) + "
   "(omega1*delta22*eta12 - omega2*delta22*eta12)/(2*omega2^2*(2*omega1 - omega2)) - "
   "alpha22*eta12/(2*omega2^2*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F",
   "(omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 - alpha22*eta22)/(12*omega2^3*(omega1 + omega2)) + "
   "(omega1*delta22*eta12 + omega2*delta22*eta12)/(2*omega2^2*(2*omega1 + omega2)) - "
   "alpha22*eta12/(2*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12_F",
   "(18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - "
   "6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 - "
   "omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_im_v2_conjA_v1_F",
   "(-omega1*eta12*mu21 + omega2*eta12*mu21)/(2*omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + "
   "mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v2_F",
   "-omega2*delta23*eta22/(omega1*(omega1 + omega2)*(omega1 - 2*omega2)) + (omega1^2*alpha23*eta22 - "
   "2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 + omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2)) + (-omega1*omega2*delta23*eta12 - alpha23*eta12)/(omega2*(omega1 + "
   "omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F",
   "omega2*delta23*eta22/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)) + (omega1^2*alpha23*eta22 + "
   "2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 + omega2)*(omega1 + "
   "2*omega2)*(omega1 - omega2)) + (-omega1*omega2*delta23*eta12 + alpha23*eta12)/(omega2*(omega1 + "
   "omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v1_F",
   "(-omega1*eta12*mu21 - omega2*eta12*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) - "
   "mu21*eta22/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_conjA_v12_F",
   "delta22*eta12/(4*omega2*(2*omega1 - omega2)) + alpha22*eta12/(4*omega1*omega2*(omega1 - omega2)*(2*omega1 - "
   "omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(8*omega1*(omega1 - omega2)*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1_F",
   "(-2*omega1^3*omega2*delta23*eta22 + 8*omega1^2*omega2^2*delta23*eta22 - omega1^2*alpha23*eta22 - "
   "11*omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 + 3*omega2^4*delta23*eta22 - "
   "3*omega2^2*alpha23*eta22)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + "
   "(omega1*omega2*delta23*eta12 - 2*omega2^2*delta23*eta12 + alpha23*eta12)/(omega2*(omega1 - omega2)*(omega1 - "
   "3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_F", "(17*omega2^2*delta24*eta22 - 3*alpha24*eta22)/(48*omega2^4)", dimension_29},
  {"harmonic_re_v2_A_v12_F",
   "-delta22*eta12/(4*omega2*(2*omega1 + omega2)) - alpha22*eta12/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + "
   "omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(8*omega1*(omega1 + omega2)*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", {}},
  {"conservative_v1_conjA_v1_F",
   "(6*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(12*omega1^3) + (-omega1^2*delta22*eta21 - "
   "alpha22*eta21)/(2*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_30},
  {"harmonic_im_v1_F", "-mu12*eta21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_F",
   "(4*omega1^2*delta22*eta11 - 2*omega1*omega2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 - "
   "omega2)*(3*omega1 - omega2)) + (2*omega1*omega2*delta23*eta21 - alpha23*eta21)/((omega1 - omega2)*(2*omega1 "
   "+ omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_F",
   "(14*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(48*omega1^4) + (3*omega1^2*delta22*eta21 - "
   "alpha22*eta21)/(8*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", dimension_31},
  {"harmonic_im_v2_F", "-eta11*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_conjA_v1_F",
   "(2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + "
   "(2*omega1^2*delta23*eta21 - alpha23*eta21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_F",
   "(-3*omega1^2*eta22 - 4*omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - "
   "2*alpha23*eta11)/(24*omega1^3*(omega1 - omega2)) + (4*omega1^2*delta24*eta21 - 2*omega1*omega2*delta24*eta21 "
   "+ omega2^2*delta24*eta21 - alpha24*eta21)/(4*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2))", {}},
  {"harmonic_re_v2_A_v1_F",
   "(-2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + "
   "(6*omega1^2*delta23*eta21 - alpha23*eta21)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + "
   "omega2)*(3*omega1 - omega2))", {}},
  {"conservative_v2_conjA_v2_F",
   "(6*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(12*omega2^3) + (omega2^2*delta23*eta11 + "
   "alpha23*eta11)/(2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_30},
  {"harmonic_im_v1_F", "mu12*eta21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_conjA_v2_F",
   "(-2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + "
   "(2*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 "
   "- 2*omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F",
   "(-2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 + 3*omega2^2*eta12 + "
   "2*alpha22*eta21)/(24*omega2^3*(omega1 - omega2)) + (omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 + "
   "4*omega2^2*delta21*eta11 - alpha21*eta11)/(4*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - "
   "2*omega2))", {}},
  {"harmonic_re_v1_A_v2_F",
   "(2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + "
   "(6*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - "
   "2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v1_F",
   "(2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 - 3*omega2^2*eta12 - "
   "2*alpha22*eta21)/(24*omega2^3*(omega1 + omega2)) + (-omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 "
   "- 4*omega2^2*delta21*eta11 + alpha21*eta11)/(4*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - "
   "2*omega2))", {}},
  {"harmonic_im_v2_F", "eta11*mu21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_conjA_v1_F",
   "(-2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 - alpha23*eta21)/(3*omega2^2*(omega1 - "
   "omega2)*(omega1 - 3*omega2)) + (-2*omega1*omega2*delta22*eta11 + alpha22*eta11)/((omega1 + 2*omega2)*(omega1 "
   "- omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v2_A_v2_F",
   "(14*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(48*omega2^4) + (-3*omega2^2*delta23*eta11 "
   "+ alpha23*eta11)/(8*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", dimension_31},
  {"harmonic_re_v2_A_v1_F",
   "(2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 - alpha23*eta21)/(3*omega2^2*(omega1 + "
   "omega2)*(omega1 + 3*omega2)) + (2*omega1*omega2*delta22*eta11 + alpha22*eta11)/((omega1 + omega2)*(omega1 + "
   "2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))", {}},
  {"conservative_v1_A_v1_F2", "-eta12^2/(4*omega1*(omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"dissipative_v1_conjA_v2_F", "(omega1*mu12*eta22 + omega2*mu12*eta12)/(4*omega1*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_conjA_v2_F",
   "(omega1*omega2*delta23*eta21 + omega2^2*delta23*eta21 - alpha23*eta21)/(2*omega1^2*(omega1 + 2*omega2)) + "
   "(omega1^2*delta22*eta11 + omega1*omega2*delta22*eta11 - alpha22*eta11)/(2*omega1*omega2*(2*omega1 + omega2))", {}},
  {"conservative_v2_A_v2_F2", "eta22^2/(4*omega2*(omega1 + 3*omega2)*(omega1 - omega2))", {}},
  {"dissipative_v2_conjA_v1_F", "(-omega1*mu21*eta22 - omega2*eta12*mu21)/(4*omega2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F",
   "(omega1*omega2*delta22*eta21 + alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - "
   "omega2)) + (-omega1^2*delta21*eta11 - omega1*omega2*delta21*eta11 - omega2^2*delta21*eta11 + "
   "alpha21*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_conjA_v12_F",
   "(3*omega1^4*delta21*eta12 - 6*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - "
   "5*omega1^2*alpha21*eta12 - omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(omega1 - "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_F",
   "(-omega1*omega2*delta23*eta22 + alpha23*eta22)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - "
   "omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*omega2*(omega1 + 2*omega2)*(omega1 - "
   "2*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v1_conjA_v2_F",
   "(-omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1^2*omega2*(2*omega1 + "
   "omega2)) + (-alpha22*eta12 + alpha22*eta22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_F2", "-eta11*eta12/(2*omega1^2*omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_F", "(-omega1*mu12*eta21 - omega2*mu12*eta21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2_F",
   "(-omega2^2*delta23*eta12 + alpha23*eta12)/(omega1^2*omega2*(2*omega1 + omega2)) + (-2*omega2^2*delta23*eta22 "
   "- 2*alpha23*eta22)/(omega2*(omega1 + 3*omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v1_conjA_v1_F",
   "(-3*omega1^4*delta21*eta12 - 2*omega1^3*omega2*delta21*eta12 - omega1^2*omega2^2*delta21*eta12 + "
   "5*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 - omega2^2*alpha21*eta12)/(omega1^2*omega2*(omega1 "
   "- omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v1_F",
   "(2*omega1*omega2*delta22*eta22 + alpha22*eta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + "
   "3*omega2)*(omega1 - 2*omega2)) + (omega1^4*delta22*eta12 - omega1^3*omega2*delta22*eta12 - "
   "omega1^2*omega2^2*delta22*eta12 - omega1^2*alpha22*eta12 + 5*omega1*omega2^3*delta22*eta12 - "
   "2*omega1*omega2*alpha22*eta12 - 2*omega2^4*delta22*eta12 + 2*omega2^2*alpha22*eta12)/(omega2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_F",
   "(2*omega1^2*delta22*eta21 + omega1*omega2*delta22*eta21 - alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + "
   "2*omega2)*(3*omega1 + omega2)) + (3*omega1^2*delta21*eta11 + 3*omega1*omega2*delta21*eta11 + "
   "omega2^2*delta21*eta11 - alpha21*eta11)/(omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v1_conjA_v2_F",
   "alpha22*eta12/(3*omega1^2*omega2*(2*omega1 - omega2)) + (2*omega1^2*delta22*eta22 - "
   "alpha22*eta22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) - alpha22*eta12/(3*omega1^2*(omega1 + "
   "omega2)*(3*omega1 + omega2)) + (-3*omega1^3*delta22*eta12 + 7*omega1^2*omega2*delta22*eta12 + "
   "3*omega1*omega2^2*delta22*eta12 - omega2^3*delta22*eta12)/(3*omega1*omega2*(omega1 + omega2)*(2*omega1 - "
   "omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_F",
   "-delta23*eta21/(4*omega1*(omega1 + 2*omega2)) + (omega1*delta22*eta11 + "
   "2*omega2*delta22*eta11)/(4*omega2^2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1*omega2*(omega1 + "
   "omega2)*(omega1 + 2*omega2)) - alpha22*eta11/(4*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v2_F",
   "(-omega1*mu12*eta22 - 2*omega2*mu12*eta22)/(8*omega2*(omega1 + omega2)^2*(omega1 + 3*omega2)) + "
   "mu12*eta12/(8*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F",
   "2*omega1*delta22*eta22/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2)) - "
   "alpha22*eta22/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2)) + "
   "(3*omega1^3*delta22*eta12 + 12*omega1^2*omega2*delta22*eta12 + 9*omega1*omega2^2*delta22*eta12 + "
   "2*omega2^3*delta22*eta12)/(omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + "
   "2*omega2)) + (-3*omega1^2*alpha22*eta12 - 6*omega1*omega2*alpha22*eta12 - "
   "2*omega2^2*alpha22*eta12)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + "
   "omega2)*(3*omega1 + 2*omega2))", {}},
  {"harmonic_re_v1_A_v12_F",
   "(51*omega1^4*delta21*eta12 + 42*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - "
   "9*omega1^2*alpha21*eta12 - 4*omega1*omega2*alpha21*eta12 - omega2^2*alpha21*eta12)/(6*omega1^2*(omega1 + "
   "omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(4*omega1 + omega2))", {}},
  {"harmonic_re_v2_conjA_v12_F",
   "(-omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - "
   "2*omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*omega1*(omega1 - 2*omega2)*(2*omega1 + "
   "omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_F",
   "(9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 - 6*omega1*omega2^3*delta24*eta22 + "
   "3*omega2^4*delta24*eta22 - 5*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 + omega2)*(omega1 - "
   "omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_conjA_v2_F",
   "(omega1^2*delta24*eta21 + omega1*omega2*delta24*eta21 + omega2^2*delta24*eta21 - "
   "alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + "
   "(-omega1*omega2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + "
   "omega2))", {}},
  {"harmonic_re_v2_conjA_v1_conjA_v2_F",
   "(-omega1*omega2*delta23*eta22 - omega2^2*delta23*eta22 + alpha23*eta22)/(omega1*omega2^2*(omega1 + "
   "2*omega2)) + (-alpha23*eta12 + alpha23*eta22)/(omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_F2", "-eta21*eta22/(2*omega1*omega2^2*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_F", "(-omega1*eta11*mu21 - omega2*eta11*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2_F",
   "(omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 + 2*omega1*omega2^3*delta24*eta22 + "
   "2*omega1*omega2*alpha24*eta22 + 3*omega2^4*delta24*eta22 - "
   "5*omega2^2*alpha24*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v1_F",
   "(-omega1^2*delta22*eta22 + alpha22*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)) + (2*omega1^2*delta22*eta12 "
   "+ 2*alpha22*eta12)/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_F",
   "(omega1^2*delta24*eta21 + 3*omega1*omega2*delta24*eta21 + 3*omega2^2*delta24*eta21 - "
   "alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + "
   "(omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 + "
   "3*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1_F",
   "-alpha23*eta22/(3*omega1*omega2^2*(omega1 - 2*omega2)) - alpha23*eta22/(3*omega2^2*(omega1 + omega2)*(omega1 "
   "+ 3*omega2)) + (-2*omega2^2*delta23*eta12 + alpha23*eta12)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) "
   "+ (omega1^3*delta23*eta22 - 3*omega1^2*omega2*delta23*eta22 - 7*omega1*omega2^2*delta23*eta22 + "
   "3*omega2^3*delta23*eta22)/(3*omega1*omega2*(omega1 + omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v2_F",
   "(-2*omega1*omega2*delta23*eta12 - alpha23*eta12)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - "
   "omega2)*(3*omega1 + omega2)) + (2*omega1^4*delta23*eta22 - 5*omega1^3*omega2*delta23*eta22 + "
   "omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 + omega1*omega2^3*delta23*eta22 + "
   "2*omega1*omega2*alpha23*eta22 - omega2^4*delta23*eta22 + omega2^2*alpha23*eta22)/(omega1*(omega1 + "
   "omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_F",
   "(2*omega1*delta23*eta21 + omega2*delta23*eta21)/(4*omega1^2*(omega1 + 2*omega2)) - "
   "delta22*eta11/(4*omega2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1^2*(omega1 + omega2)*(omega1 + "
   "2*omega2)) - alpha22*eta11/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_im_v2_A_v1_F",
   "-mu21*eta22/(8*(omega1 + omega2)^2*(omega1 - omega2)) + (-2*omega1*eta12*mu21 - "
   "omega2*eta12*mu21)/(8*omega1*(omega1 + omega2)^2*(3*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F",
   "2*omega2*delta23*eta12/((2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) - "
   "alpha23*eta12/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) + "
   "(2*omega1^3*delta23*eta22 + 9*omega1^2*omega2*delta23*eta22 + 12*omega1*omega2^2*delta23*eta22 + "
   "3*omega2^3*delta23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2)*(2*omega1 + "
   "3*omega2)) + (-2*omega1^2*alpha23*eta22 - 6*omega1*omega2*alpha23*eta22 - "
   "3*omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + "
   "omega2)*(2*omega1 + 3*omega2))", {}},
  {"harmonic_re_v2_A_v12_F",
   "(-2*omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 - alpha22*eta12)/(3*omega1*(omega1 + "
   "omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2)) + (-omega1^2*delta22*eta22 - "
   "alpha22*eta22)/(6*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + 2*omega2))", {}},
};

// Case primary_1.
constexpr int case_0_relations[] = {-1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47,
    48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 9},
  {BlockKind::modulation, "modulation of v2", 1, 0, 7},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega2-Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, 5},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic -omega1+omega2-Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega2-Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, 4},
  {BlockKind::harmonic, "harmonic omega1+omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega2-Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 7},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega2-2*Omega of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic 2*omega2-Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, 2},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 2, 4, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
    19, 20, 21, 22, 23, 24, 25, 13, 26, 27, 18, 28, 29, 20, 30, 31, 32, 32, 33, 34, 3, 5, 35, 36, 23, 37, 38, 39,
    40, 41, 42, 43, 39, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 10, 58, 59, 60, 61, 10, 62, 63,
    61, 64, 11, 65, 54, 66};
constexpr int case_0_phases[] = {0, 0, 0, 0, 1, -1, 0, 1, 0, 0, 2, 0, 1, 0, 1, 0, 1, 1, -1, 1, -1, 0, 2, -1, 0, 2,
    1, 0, 3, 0, 1, 0, 2, 1, 1, 1, 0, 1, -1, 0, 0, 0, 0, 1, 1, 0, 2, 0, 0, 0, 1, 1, 0, 1, 0, 1, -2, 0, 2, -1, 0, 1,
    2, 0, 2, 1, 0, 3, 0, 2, 0, 1};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, primary_1::blocks, case_0_block_lumps,
    case_0_phases, 3);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, primary_1::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case primary_2.
constexpr int case_1_relations[] = {0, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr int case_1_lump_numbers[] = {67, 1, 2, 68, 4, 5, 6, 69, 9, 70, 11, 12, 49, 13, 16, 17, 14, 15, 71, 19,
    7, 72, 73, 21, 22, 74, 24, 75, 25, 28, 29, 26, 27, 76, 30, 77, 31, 34, 78, 33, 79, 37, 36, 38, 80, 40, 39, 41,
    42, 46, 47, 48, 81, 52, 53, 82, 44, 83, 45, 55, 57, 84, 58, 85, 60, 86, 65, 64, 87, 63, 66};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 7},
  {BlockKind::modulation, "modulation of v2", 1, 0, 9},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 7},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+2*Omega of v1", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, 3},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 5},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, 4},
  {BlockKind::harmonic, "harmonic omega1+omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 0, 2, 4, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
    19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 13, 29, 30, 31, 32, 33, 34, 3, 35, 36, 25, 37, 3, 38, 39, 40, 41, 5,
    42, 43, 44, 45, 46, 47, 48, 46, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 9, 10, 65, 66,
    55, 67, 68, 69, 70};
constexpr int case_1_phases[] = {-1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0, 1, 2, 0, 0, -2, 0, 1, -1, 0, 2, 0, 2,
    1, 1, 0, 2, 2, 0, 1, 3, 0, 0, -1, 0, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 2, 0, 0, -2, 0, 1, -1, 1, 1, 0, 1,
    2, 1, 1, 1, 2, 0, 1, 3, 0, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, primary_2::blocks, case_1_block_lumps,
    case_1_phases, 3);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, primary_2::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

// Case principal_parametric_1.
constexpr int case_2_relations[] = {-2, 0, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {0, 1}, {1, 2}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr int case_2_lump_numbers[] = {1, 2, 4, 5, 6, 88, 9, 11, 12, 16, 17, 14, 15, 7, 26, 89, 27, 19, 21, 22,
    24, 25, 28, 29, 30, 90, 31, 37, 34, 91, 36, 33, 38, 40, 41, 42, 49, 55, 92, 57, 46, 47, 48, 93, 52, 53, 44,
    45, 58, 94, 60, 63, 65, 95, 66, 64};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 6},
  {BlockKind::modulation, "modulation of v2", 1, 0, 5},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 4},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega2-Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, 3},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 4},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 4},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic omega2-Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 3, 4, 5, 1, 2, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 21, 22, 23, 24, 25, 26, 25, 27, 28, 3, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45,
    46, 47, 48, 49, 50, 49, 51, 7, 52, 53, 54, 55};
constexpr int case_2_phases[] = {-1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 2, 0, 1, 1, 0, 0, 1, -1, -1, 2, 0, 0, 1,
    1, 0, 3, 0, 1, 0, 1, 1, 2, 0, -1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 1, 0, 0, 1, 1, 0, 0, 1, -1, -1, 2, 0, 0, 1,
    1, 0, 3, 0, 1, 0, 1, 1, 2, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, principal_parametric_1::blocks,
    case_2_block_lumps, case_2_phases, 3);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, principal_parametric_1::blocks,
    case_2_blocks, case_2_observed_frequency, case_2_mode_at_rest};

// Case principal_parametric_2.
constexpr int case_3_relations[] = {0, -2, 1};
constexpr Ratio case_3_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 2}};
constexpr bool case_3_mode_at_rest[] = {false, false};
constexpr int case_3_lump_numbers[] = {1, 2, 4, 5, 6, 9, 11, 12, 96, 16, 17, 14, 15, 7, 24, 97, 25, 19, 98, 21,
    22, 28, 29, 26, 27, 30, 99, 31, 100, 34, 101, 33, 37, 36, 38, 40, 41, 42, 49, 46, 102, 47, 48, 52, 53, 44, 45,
    55, 57, 58, 103, 60, 104, 65, 105, 64, 63, 66};
constexpr auto case_3_lumps = chosen_lumps(lump_table, case_3_lump_numbers);
constexpr BlockTable case_3_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 5},
  {BlockKind::modulation, "modulation of v2", 1, 0, 6},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 4},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, 4},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 4},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_3_block_lumps[] = {0, 1, 2, 3, 4, 1, 2, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 3, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46,
    47, 48, 49, 50, 51, 6, 52, 53, 54, 55, 56, 57};
constexpr int case_3_phases[] = {-1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 0, 2, 0, 0, -2, 1, 0, -1, 0, 1, 0, 1,
    1, 1, 0, 1, 2, 1, 0, 3, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 2, 0, 0, -2, 1, 0, -1, 0, 1, 0, 1,
    1, 1, 0, 1, 2, 1, 0, 3, 0, 0};
constexpr auto case_3_blocks = regressor_blocks(case_3_block_table, principal_parametric_2::blocks,
    case_3_block_lumps, case_3_phases, 3);
constexpr GeneratedCase case_3 = {&lump_functions, case_3_lump_numbers, principal_parametric_2::blocks,
    case_3_blocks, case_3_observed_frequency, case_3_mode_at_rest};

// Case additive_combination.
constexpr int case_4_relations[] = {-1, -1, 1};
constexpr Ratio case_4_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_4_mode_at_rest[] = {false, false};
constexpr int case_4_lump_numbers[] = {1, 2, 106, 4, 5, 6, 107, 108, 9, 109, 11, 12, 110, 13, 19, 111, 21, 22, 16,
    112, 17, 113, 14, 15, 114, 115, 7, 28, 116, 117, 118, 29, 24, 119, 25, 120, 37, 26, 121, 27, 30, 122, 123, 33,
    31, 124, 34, 125, 36, 38, 126, 40, 127, 39, 48, 128, 52, 53, 41, 42, 129, 130, 49, 44, 131, 132, 133, 45, 134,
    64, 46, 135, 47, 55, 136, 57, 58, 60, 137, 138, 63, 139, 65, 140, 66};
constexpr auto case_4_lumps = chosen_lumps(lump_table, case_4_lump_numbers);
constexpr BlockTable case_4_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 8},
  {BlockKind::modulation, "modulation of v2", 1, 0, 8},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, 5},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, 4},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 4},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 6},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, 4},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 2*Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, 4},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 5},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 4},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 6},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, 4},
  {BlockKind::harmonic, "harmonic 2*Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_4_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 1, 3, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
    19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 13, 35, 36, 37, 38, 39, 40, 2, 41, 42, 43, 44,
    25, 45, 21, 46, 2, 47, 4, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 53,
    68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 9, 78, 79, 80, 61, 81, 9, 52, 10, 82, 83, 84};
constexpr int case_4_phases[] = {0, 1, 0, -1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 1, 0, 1, 2, 0, 0, -2, 1, 0, 0, 1,
    1, -1, 2, 0, 0, 0, 2, 0, 2, 1, 0, 3, 0, 1, 0, 2, 2, 0, 1, 3, 0, 0, -1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1,
    1, 0, 2, 0, 2, 0, 0, -2, 1, 0, -1, 2, 0, 1, 0, 1, 0, 0, 2, 0, 1, 2, 0, 2, 1, 0, 3, 0, 2, 0, 1, 3, 0, 0};
constexpr auto case_4_blocks = regressor_blocks(case_4_block_table, additive_combination::blocks,
    case_4_block_lumps, case_4_phases, 3);
constexpr GeneratedCase case_4 = {&lump_functions, case_4_lump_numbers, additive_combination::blocks,
    case_4_blocks, case_4_observed_frequency, case_4_mode_at_rest};

// Case free.
constexpr Ratio case_5_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_5_mode_at_rest[] = {false, false};
constexpr int case_5_lump_numbers[] = {1, 2, 4, 5, 6, 9, 11, 12, 16, 17, 14, 15, 19, 21, 22, 24, 25, 28, 29, 26,
    27, 30, 31, 34, 33, 37, 36, 38, 40, 41, 42, 46, 47, 48, 52, 53, 44, 45, 55, 57, 58, 60, 65, 64, 63, 66};
constexpr auto case_5_lumps = chosen_lumps(lump_table, case_5_lump_numbers);
constexpr BlockTable case_5_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 5},
  {BlockKind::modulation, "modulation of v2", 1, 0, 5},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_5_block_lumps[] = {0, 1, 2, 3, 4, 1, 2, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 21, 22, 23, 24, 25, 3, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 6, 42, 43, 44, 45};
constexpr int case_5_phases[] = {-1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 1, 0, 2, 0, 0, -2, 1, 0, -1, 2, 0, 0, 3,
    0, 1, 2, 0, 2, 1, 0, 3, 0, 0, -1, 1, 0, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, -2, 1, 0, -1, 2, 0, 0, 3,
    0, 1, 2, 0, 2, 1, 0, 3, 0, 0};
constexpr auto case_5_blocks = regressor_blocks(case_5_block_table, free::blocks, case_5_block_lumps,
    case_5_phases, 3);
constexpr GeneratedCase case_5 = {&lump_functions, case_5_lump_numbers, free::blocks, case_5_blocks,
    case_5_observed_frequency, case_5_mode_at_rest};

// Case free_1.
constexpr Ratio case_6_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_6_mode_at_rest[] = {false, true};
constexpr int case_6_lump_numbers[] = {1, 2, 5, 6, 15, 26, 27, 36, 42, 48, 53, 55, 57, 66};
constexpr auto case_6_lumps = chosen_lumps(lump_table, case_6_lump_numbers);
constexpr BlockTable case_6_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 4},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_6_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 2, 7, 8, 9, 10, 11, 12, 13};
constexpr int case_6_phases[] = {0, 0, 0, 2, 0, 0, 3, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
constexpr auto case_6_blocks = regressor_blocks(case_6_block_table, free_1::blocks, case_6_block_lumps,
    case_6_phases, 3);
constexpr GeneratedCase case_6 = {&lump_functions, case_6_lump_numbers, free_1::blocks, case_6_blocks,
    case_6_observed_frequency, case_6_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("primary_1", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("primary_2", true, case_1_relations, case_1_lumps, case_1),
  compiled_case("principal_parametric_1", true, case_2_relations, case_2_lumps, case_2),
  compiled_case("principal_parametric_2", true, case_3_relations, case_3_lumps, case_3),
  compiled_case("additive_combination", true, case_4_relations, case_4_lumps, case_4),
  compiled_case("free", false, {}, case_5_lumps, case_5),
  compiled_case("free_1", false, {}, case_6_lumps, case_6),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass",
  .source = "S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.1)-(6.2)",
  .fingerprint = "97bcdfeef992100b",
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

}  // namespace secular::generated::two_mass
