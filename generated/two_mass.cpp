// Model two_mass: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.1)-(6.2)
// Equation of motion: 0 = omega1^2*v1 + 2*delta32*v1*D(v1)*D(v2) + delta31*v1*D(v1)^2 + 2*delta21*v1*D2(v1) +
// 2*delta32*v1*v2*D2(v1) + 2*alpha22*v1*v2 + alpha33*v1*v2^2 - delta34*v1*D(v2)^2 - eta12*v1*F*cos(Omega*t) +
// alpha21*v1^2 + delta31*v1^2*D2(v1) + 3*alpha32*v1^2*v2 + alpha31*v1^3 + 2*mu11*D(v1) +
// 2*delta33*D(v1)*v2*D(v2) + 2*delta22*D(v1)*D(v2) + delta21*D(v1)^2 + delta32*D(v1)^2*v2 + mu13*D(v1)^3 +
// D2(v1) + 2*delta22*v2*D2(v1) + delta33*v2^2*D2(v1) - delta35*v2*D(v2)^2 + alpha23*v2^2 + alpha34*v2^3 +
// mu12*D(v2) - delta23*D(v2)^2 - eta11*F*cos(Omega*t)
// Equation of motion: 0 = 2*delta34*v1*D(v1)*D(v2) - delta32*v1*D(v1)^2 + 2*alpha23*v1*v2 +
// 2*delta35*v1*v2*D2(v2) + 3*alpha34*v1*v2^2 + delta35*v1*D(v2)^2 + 2*delta23*v1*D2(v2) + alpha22*v1^2 +
// alpha33*v1^2*v2 + delta34*v1^2*D2(v2) + alpha32*v1^3 + mu21*D(v1) + 2*delta35*D(v1)*v2*D(v2) +
// 2*delta23*D(v1)*D(v2) - delta22*D(v1)^2 - delta33*D(v1)^2*v2 + omega2^2*v2 + delta36*v2*D(v2)^2 +
// 2*delta24*v2*D2(v2) - eta22*v2*F*cos(Omega*t) + alpha24*v2^2 + delta36*v2^2*D2(v2) + alpha35*v2^3 +
// 2*mu22*D(v2) + delta24*D(v2)^2 + mu23*D(v2)^3 + D2(v2) - eta21*F*cos(Omega*t)
// Case primary_1: Omega = omega1 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case primary_2: Omega = omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case principal_parametric_1: Omega = 2*omega1 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case principal_parametric_2: Omega = 2*omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case additive_combination: Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case free_1: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass
#include "generated/two_mass.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_3[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_4[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_5[] = {{-1, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_7[] = {{1, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_8[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_10[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_11[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_12[] = {{-1, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_13[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_14[] = {{1, 1}, {-3, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_15[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_16[] = {{-1, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_17[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_18[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_19[] = {{1, 1}, {-3, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_20[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_21[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_22[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_23[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_24[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_25[] = {{0, 1}, {-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_26[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_27[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_28[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_29[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_30[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_1},
  {"mu11", dimension_2},
  {"mu12", dimension_3},
  {"mu13", dimension_4},
  {"alpha21", dimension_5},
  {"alpha22", dimension_6},
  {"alpha23", dimension_7},
  {"delta21", dimension_8},
  {"delta22", dimension_9},
  {"delta23", dimension_10},
  {"alpha31", dimension_11},
  {"alpha32", dimension_12},
  {"alpha33", dimension_13},
  {"alpha34", dimension_14},
  {"delta31", dimension_15},
  {"delta32", dimension_16},
  {"delta33", dimension_17},
  {"delta34", dimension_18},
  {"delta35", dimension_19},
  {"eta11", dimension_20},
  {"eta12", dimension_21},
  {"mu22", dimension_22},
  {"mu21", dimension_23},
  {"mu23", dimension_24},
  {"alpha24", dimension_25},
  {"delta24", dimension_26},
  {"alpha35", dimension_27},
  {"delta36", dimension_28},
  {"eta21", dimension_29},
  {"eta22", dimension_30},
};
constexpr double nominal[] = {77.85, 209.35, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-1, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {0, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr Ratio case_0_lump_0[] = {{-1, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_3[] = {{0, 1}, {0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_0_lump_4[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_5[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_0_lump_6[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_7[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_8[] = {{1, 1}, {-2, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_0_lump_9[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_11[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_0_lump_12[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_13[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_14[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_15[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_19[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_26[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_35[] = {{-1, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_0_lump_36[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_39[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_41[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_42[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_46[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_48[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_49[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_65[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"conservative_v1_A_v12_F", "(-3*omega1^2*delta21*eta12 + 5*alpha21*eta12)/(12*omega1^3)", case_0_lump_0},
  {"mu11", "mu11", case_0_lump_1},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_F2", "-eta12^2/(12*omega1^3)", case_0_lump_3},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_4},
  {"mu13", "mu13", case_0_lump_5},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_6},
  {"eta11", "eta11", case_0_lump_7},
  {"conservative_v1_A_v2_conjA_v2_F", "(-omega2^2*delta23*eta12 + alpha23*eta12)/(2*omega1^3) + (-omega2^2*delta23*eta22 - alpha23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_8},
  {"mu22", "mu22", case_0_lump_9},
  {"conservative_v2_A_v2_F2", "eta22^2/(4*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu23", "mu23", case_0_lump_11},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_12},
  {"eta12", "eta12", case_0_lump_13},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_0_lump_14},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_0_lump_15},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_F", "(-omega1*mu12*eta22 + omega2*mu12*eta22)/(2*omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) - mu12*eta12/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"mu12", "mu12", case_0_lump_19},
  {"harmonic_re_v1_A_v2_conjA_v1_F", "omega1*delta22*eta12/(omega2*(omega1 + omega2)*(2*omega1 - omega2)) + (omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 + omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F", "-omega1*delta22*eta12/(omega2*(omega1 - omega2)*(2*omega1 + omega2)) + (-omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 - omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_0_lump_26},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22_F", "-delta23*eta22/(4*omega1*(omega1 - 2*omega2)) + alpha23*eta22/(4*omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(8*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v12_F", "(17*omega1^2*delta21*eta12 - 3*alpha21*eta12)/(48*omega1^4)", case_0_lump_35},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_0_lump_36},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"eta22", "eta22", case_0_lump_39},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_0_lump_41},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_0_lump_42},
  {"harmonic_im_v2_conjA_v1_F", "-omega1*mu21*eta22/(2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_0_lump_46},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", case_0_lump_48},
  {"eta21", "eta21", case_0_lump_49},
  {"harmonic_re_v2_A_v2_conjA_v2_F", "(omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 + 2*omega2^4*delta24*eta22 - 6*omega2^2*alpha24*eta22)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v1_F", "(-3*omega1^4*delta22*eta22 + 2*omega1^2*omega2^2*delta22*eta12 + 3*omega1^2*alpha22*eta22 + 2*omega2^2*alpha22*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_F", "alpha22*eta12/(omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v1_F", "-eta12*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) - omega1*mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1_F", "(-2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 - alpha23*eta12)/(12*omega1^3*(omega1 - omega2)) + (omega1*delta23*eta22 - omega2*delta23*eta22)/(2*omega1^2*(omega1 - 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_F", "(9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 - 24*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 18*omega2^4*delta24*eta22 - 6*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F", "(2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 - alpha23*eta12)/(12*omega1^3*(omega1 + omega2)) + (omega1*delta23*eta22 + omega2*delta23*eta22)/(2*omega1^2*(omega1 + 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 + omega2)*(omega1 + 2*omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_0_lump_65},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr int case_0_block_1_lumps[] = {2, 4, 8, 9, 10, 11, 12};
constexpr int case_0_block_2_lumps[] = {13, 14, 15};
constexpr int case_0_block_2_phase[] = {0, 0, 0};
constexpr int case_0_block_3_lumps[] = {16, 17, 18};
constexpr int case_0_block_3_phase[] = {0, 1, -1};
constexpr int case_0_block_4_lumps[] = {19, 20, 21, 22, 23};
constexpr int case_0_block_4_phase[] = {0, 1, 0};
constexpr int case_0_block_5_lumps[] = {24, 25};
constexpr int case_0_block_5_phase[] = {0, 2, 0};
constexpr int case_0_block_6_lumps[] = {13, 26, 27};
constexpr int case_0_block_6_phase[] = {1, 0, 1};
constexpr int case_0_block_7_lumps[] = {18, 28, 29};
constexpr int case_0_block_7_phase[] = {0, 1, 1};
constexpr int case_0_block_8_lumps[] = {20, 30};
constexpr int case_0_block_8_phase[] = {-1, 1, -1};
constexpr int case_0_block_9_lumps[] = {31, 32};
constexpr int case_0_block_9_phase[] = {0, 2, -1};
constexpr int case_0_block_10_lumps[] = {32, 33};
constexpr int case_0_block_10_phase[] = {0, 2, 1};
constexpr int case_0_block_11_lumps[] = {34};
constexpr int case_0_block_11_phase[] = {0, 3, 0};
constexpr int case_0_block_12_lumps[] = {3, 5, 35, 36};
constexpr int case_0_block_12_phase[] = {1, 0, 2};
constexpr int case_0_block_13_lumps[] = {23, 37};
constexpr int case_0_block_13_phase[] = {1, 1, 1};
constexpr int case_0_block_14_lumps[] = {38, 39, 40};
constexpr int case_0_block_14_phase[] = {0, 1, -1};
constexpr int case_0_block_15_lumps[] = {41, 42, 43};
constexpr int case_0_block_15_phase[] = {0, 0, 0};
constexpr int case_0_block_16_lumps[] = {39, 44, 45};
constexpr int case_0_block_16_phase[] = {0, 1, 1};
constexpr int case_0_block_17_lumps[] = {46, 47};
constexpr int case_0_block_17_phase[] = {0, 2, 0};
constexpr int case_0_block_18_lumps[] = {48, 49, 50, 51, 52, 53, 54};
constexpr int case_0_block_18_phase[] = {0, 0, 1};
constexpr int case_0_block_19_lumps[] = {55, 56, 57};
constexpr int case_0_block_19_phase[] = {1, 0, 1};
constexpr int case_0_block_20_lumps[] = {10, 58, 59};
constexpr int case_0_block_20_phase[] = {0, 1, -2};
constexpr int case_0_block_21_lumps[] = {60, 61};
constexpr int case_0_block_21_phase[] = {0, 2, -1};
constexpr int case_0_block_22_lumps[] = {10, 62, 63};
constexpr int case_0_block_22_phase[] = {0, 1, 2};
constexpr int case_0_block_23_lumps[] = {61, 64};
constexpr int case_0_block_23_phase[] = {0, 2, 1};
constexpr int case_0_block_24_lumps[] = {11, 65};
constexpr int case_0_block_24_phase[] = {0, 3, 0};
constexpr int case_0_block_25_lumps[] = {54, 66};
constexpr int case_0_block_25_phase[] = {2, 0, 1};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_0_block_0_lumps, column_function<primary_1::columns_0, 2, 1, 9>, column_slope_function<primary_1::column_slopes_0, 2, 1, 9>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_0_block_1_lumps, column_function<primary_1::columns_1, 2, 1, 7>, column_slope_function<primary_1::column_slopes_1, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<primary_1::columns_2, 2, 1, 3>, column_slope_function<primary_1::column_slopes_2, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2-Omega of v1", 0, 1, case_0_block_3_phase, case_0_block_3_lumps, column_function<primary_1::columns_3, 2, 1, 3>, column_slope_function<primary_1::column_slopes_3, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, case_0_block_4_phase, case_0_block_4_lumps, column_function<primary_1::columns_4, 2, 1, 5>, column_slope_function<primary_1::column_slopes_4, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, case_0_block_5_phase, case_0_block_5_lumps, column_function<primary_1::columns_5, 2, 1, 2>, column_slope_function<primary_1::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, case_0_block_6_phase, case_0_block_6_lumps, column_function<primary_1::columns_6, 2, 1, 3>, column_slope_function<primary_1::column_slopes_6, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, case_0_block_7_phase, case_0_block_7_lumps, column_function<primary_1::columns_7, 2, 1, 3>, column_slope_function<primary_1::column_slopes_7, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic -omega1+omega2-Omega of v1", 0, 2, case_0_block_8_phase, case_0_block_8_lumps, column_function<primary_1::columns_8, 2, 1, 2>, column_slope_function<primary_1::column_slopes_8, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2-Omega of v1", 0, 2, case_0_block_9_phase, case_0_block_9_lumps, column_function<primary_1::columns_9, 2, 1, 2>, column_slope_function<primary_1::column_slopes_9, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, case_0_block_10_phase, case_0_block_10_lumps, column_function<primary_1::columns_10, 2, 1, 2>, column_slope_function<primary_1::column_slopes_10, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_0_block_11_phase, case_0_block_11_lumps, column_function<primary_1::columns_11, 2, 1, 1>, column_slope_function<primary_1::column_slopes_11, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, case_0_block_12_phase, case_0_block_12_lumps, column_function<primary_1::columns_12, 2, 1, 4>, column_slope_function<primary_1::column_slopes_12, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1+omega2+Omega of v1", 0, 2, case_0_block_13_phase, case_0_block_13_lumps, column_function<primary_1::columns_13, 2, 1, 2>, column_slope_function<primary_1::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2-Omega of v2", 1, 1, case_0_block_14_phase, case_0_block_14_lumps, column_function<primary_1::columns_14, 2, 1, 3>, column_slope_function<primary_1::column_slopes_14, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_0_block_15_phase, case_0_block_15_lumps, column_function<primary_1::columns_15, 2, 1, 3>, column_slope_function<primary_1::column_slopes_15, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, case_0_block_16_phase, case_0_block_16_lumps, column_function<primary_1::columns_16, 2, 1, 3>, column_slope_function<primary_1::column_slopes_16, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, case_0_block_17_phase, case_0_block_17_lumps, column_function<primary_1::columns_17, 2, 1, 2>, column_slope_function<primary_1::column_slopes_17, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, case_0_block_18_phase, case_0_block_18_lumps, column_function<primary_1::columns_18, 2, 1, 7>, column_slope_function<primary_1::column_slopes_18, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, case_0_block_19_phase, case_0_block_19_lumps, column_function<primary_1::columns_19, 2, 1, 3>, column_slope_function<primary_1::column_slopes_19, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2-2*Omega of v2", 1, 2, case_0_block_20_phase, case_0_block_20_lumps, column_function<primary_1::columns_20, 2, 1, 3>, column_slope_function<primary_1::column_slopes_20, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2-Omega of v2", 1, 2, case_0_block_21_phase, case_0_block_21_lumps, column_function<primary_1::columns_21, 2, 1, 2>, column_slope_function<primary_1::column_slopes_21, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, case_0_block_22_phase, case_0_block_22_lumps, column_function<primary_1::columns_22, 2, 1, 3>, column_slope_function<primary_1::column_slopes_22, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v2", 1, 2, case_0_block_23_phase, case_0_block_23_lumps, column_function<primary_1::columns_23, 2, 1, 2>, column_slope_function<primary_1::column_slopes_23, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_0_block_24_phase, case_0_block_24_lumps, column_function<primary_1::columns_24, 2, 1, 2>, column_slope_function<primary_1::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, case_0_block_25_phase, case_0_block_25_lumps, column_function<primary_1::columns_25, 2, 1, 2>, column_slope_function<primary_1::column_slopes_25, 2, 1, 2>},
};

constexpr int case_1_relations[] = {0, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_4[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_5[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_1_lump_6[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_7[] = {{0, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_1_lump_8[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_9[] = {{0, 1}, {0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_1_lump_10[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_1_lump_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_12[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_13[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_16[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_17[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_19[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_20[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_31[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_42[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_46[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_1_lump_47[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_48[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_49[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_51[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_65[] = {{0, 1}, {-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_1_lump_66[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"conservative_v1_A_v1_A_v2_F", "(-omega1^2*delta22*eta22 + alpha22*eta22)/(2*omega1*omega2^2) + (omega1^2*delta22*eta12 + alpha22*eta12)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_1_lump_0},
  {"mu11", "mu11", case_1_lump_1},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_F2", "-eta12^2/(4*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_1_lump_4},
  {"mu13", "mu13", case_1_lump_5},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_1_lump_6},
  {"conservative_v2_A_v22_F", "(-3*omega2^2*delta24*eta22 + 5*alpha24*eta22)/(12*omega2^3)", case_1_lump_7},
  {"mu22", "mu22", case_1_lump_8},
  {"conservative_v2_A_v2_F2", "-eta22^2/(12*omega2^3)", case_1_lump_9},
  {"mu23", "mu23", case_1_lump_10},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_11},
  {"eta21", "eta21", case_1_lump_12},
  {"eta12", "eta12", case_1_lump_13},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_1_lump_16},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_1_lump_17},
  {"harmonic_im_v1_conjA_v2_F", "omega2*mu12*eta12/(2*omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"mu12", "mu12", case_1_lump_19},
  {"eta11", "eta11", case_1_lump_20},
  {"harmonic_re_v1_A_v2_conjA_v2_F", "(-2*omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 + 3*omega2^4*delta23*eta12 - 3*omega2^2*alpha23*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_conjA_v1_F", "(2*omega1^4*delta21*eta12 + omega1^2*omega2^2*delta21*eta12 - 6*omega1^2*alpha21*eta12 + omega2^2*alpha21*eta12)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_F", "-alpha23*eta22/(omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v2_F", "mu12*eta22/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) - omega2*mu12*eta12/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_1_lump_31},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v12_F", "(-18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 - 9*omega1^2*omega2^2*delta21*eta12 + 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 + omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v1_F", "(-omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 + alpha22*eta22)/(12*omega2^3*(omega1 - omega2)) + (omega1*delta22*eta12 - omega2*delta22*eta12)/(2*omega2^2*(2*omega1 - omega2)) - alpha22*eta12/(2*omega2^2*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F", "(omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 - alpha22*eta22)/(12*omega2^3*(omega1 + omega2)) + (omega1*delta22*eta12 + omega2*delta22*eta12)/(2*omega2^2*(2*omega1 + omega2)) - alpha22*eta12/(2*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12_F", "(18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 - omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_1_lump_42},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_conjA_v1_F", "(-omega1*eta12*mu21 + omega2*eta12*mu21)/(2*omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"eta22", "eta22", case_1_lump_46},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_1_lump_47},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_1_lump_48},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_1_lump_49},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", case_1_lump_51},
  {"harmonic_re_v2_A_v1_conjA_v2_F", "-omega2*delta23*eta22/(omega1*(omega1 + omega2)*(omega1 - 2*omega2)) + (omega1^2*alpha23*eta22 - 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega1*omega2*delta23*eta12 - alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F", "omega2*delta23*eta22/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)) + (omega1^2*alpha23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1*omega2*delta23*eta12 + alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_F", "(-omega1*eta12*mu21 - omega2*eta12*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) - mu21*eta22/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_conjA_v12_F", "delta22*eta12/(4*omega2*(2*omega1 - omega2)) + alpha22*eta12/(4*omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(8*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1_F", "(-2*omega1^3*omega2*delta23*eta22 + 8*omega1^2*omega2^2*delta23*eta22 - omega1^2*alpha23*eta22 - 11*omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 + 3*omega2^4*delta23*eta22 - 3*omega2^2*alpha23*eta22)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (omega1*omega2*delta23*eta12 - 2*omega2^2*delta23*eta12 + alpha23*eta12)/(omega2*(omega1 - omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_F", "(17*omega2^2*delta24*eta22 - 3*alpha24*eta22)/(48*omega2^4)", case_1_lump_65},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_1_lump_66},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v12_F", "-delta22*eta12/(4*omega2*(2*omega1 + omega2)) - alpha22*eta12/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(8*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6};
constexpr int case_1_block_1_lumps[] = {0, 2, 4, 7, 8, 9, 10, 11, 12};
constexpr int case_1_block_2_lumps[] = {13, 14, 15};
constexpr int case_1_block_2_phase[] = {-1, 0, 1};
constexpr int case_1_block_3_lumps[] = {16, 17, 18};
constexpr int case_1_block_3_phase[] = {0, 0, 0};
constexpr int case_1_block_4_lumps[] = {19, 20, 21, 22, 23, 24, 25};
constexpr int case_1_block_4_phase[] = {0, 0, 1};
constexpr int case_1_block_5_lumps[] = {26, 27, 28};
constexpr int case_1_block_5_phase[] = {0, 1, 1};
constexpr int case_1_block_6_lumps[] = {13, 29, 30};
constexpr int case_1_block_6_phase[] = {1, 0, 1};
constexpr int case_1_block_7_lumps[] = {31, 32};
constexpr int case_1_block_7_phase[] = {2, 0, 0};
constexpr int case_1_block_8_lumps[] = {33, 34};
constexpr int case_1_block_8_phase[] = {-2, 0, 1};
constexpr int case_1_block_9_lumps[] = {3, 35, 36};
constexpr int case_1_block_9_phase[] = {-1, 0, 2};
constexpr int case_1_block_10_lumps[] = {25, 37};
constexpr int case_1_block_10_phase[] = {0, 2, 1};
constexpr int case_1_block_11_lumps[] = {3, 38, 39};
constexpr int case_1_block_11_phase[] = {1, 0, 2};
constexpr int case_1_block_12_lumps[] = {40, 41};
constexpr int case_1_block_12_phase[] = {2, 0, 1};
constexpr int case_1_block_13_lumps[] = {5, 42};
constexpr int case_1_block_13_phase[] = {3, 0, 0};
constexpr int case_1_block_14_lumps[] = {43, 44, 45};
constexpr int case_1_block_14_phase[] = {-1, 0, 1};
constexpr int case_1_block_15_lumps[] = {46, 47, 48};
constexpr int case_1_block_15_phase[] = {0, 0, 0};
constexpr int case_1_block_16_lumps[] = {46, 49, 50};
constexpr int case_1_block_16_phase[] = {0, 1, 1};
constexpr int case_1_block_17_lumps[] = {51, 52, 53, 54, 55};
constexpr int case_1_block_17_phase[] = {1, 0, 0};
constexpr int case_1_block_18_lumps[] = {56, 57, 58};
constexpr int case_1_block_18_phase[] = {1, 0, 1};
constexpr int case_1_block_19_lumps[] = {59, 60};
constexpr int case_1_block_19_phase[] = {2, 0, 0};
constexpr int case_1_block_20_lumps[] = {61, 62};
constexpr int case_1_block_20_phase[] = {-2, 0, 1};
constexpr int case_1_block_21_lumps[] = {63, 64};
constexpr int case_1_block_21_phase[] = {-1, 1, 1};
constexpr int case_1_block_22_lumps[] = {9, 10, 65, 66};
constexpr int case_1_block_22_phase[] = {0, 1, 2};
constexpr int case_1_block_23_lumps[] = {55, 67};
constexpr int case_1_block_23_phase[] = {1, 1, 1};
constexpr int case_1_block_24_lumps[] = {68, 69};
constexpr int case_1_block_24_phase[] = {2, 0, 1};
constexpr int case_1_block_25_lumps[] = {70};
constexpr int case_1_block_25_phase[] = {3, 0, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_1_block_0_lumps, column_function<primary_2::columns_0, 2, 1, 7>, column_slope_function<primary_2::column_slopes_0, 2, 1, 7>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_1_block_1_lumps, column_function<primary_2::columns_1, 2, 1, 9>, column_slope_function<primary_2::column_slopes_1, 2, 1, 9>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v1", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<primary_2::columns_2, 2, 1, 3>, column_slope_function<primary_2::column_slopes_2, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_1_block_3_phase, case_1_block_3_lumps, column_function<primary_2::columns_3, 2, 1, 3>, column_slope_function<primary_2::column_slopes_3, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, case_1_block_4_phase, case_1_block_4_lumps, column_function<primary_2::columns_4, 2, 1, 7>, column_slope_function<primary_2::column_slopes_4, 2, 1, 7>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, case_1_block_5_phase, case_1_block_5_lumps, column_function<primary_2::columns_5, 2, 1, 3>, column_slope_function<primary_2::column_slopes_5, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, case_1_block_6_phase, case_1_block_6_lumps, column_function<primary_2::columns_6, 2, 1, 3>, column_slope_function<primary_2::column_slopes_6, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, case_1_block_7_phase, case_1_block_7_lumps, column_function<primary_2::columns_7, 2, 1, 2>, column_slope_function<primary_2::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+Omega of v1", 0, 2, case_1_block_8_phase, case_1_block_8_lumps, column_function<primary_2::columns_8, 2, 1, 2>, column_slope_function<primary_2::column_slopes_8, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+2*Omega of v1", 0, 2, case_1_block_9_phase, case_1_block_9_lumps, column_function<primary_2::columns_9, 2, 1, 3>, column_slope_function<primary_2::column_slopes_9, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, case_1_block_10_phase, case_1_block_10_lumps, column_function<primary_2::columns_10, 2, 1, 2>, column_slope_function<primary_2::column_slopes_10, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, case_1_block_11_phase, case_1_block_11_lumps, column_function<primary_2::columns_11, 2, 1, 3>, column_slope_function<primary_2::column_slopes_11, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v1", 0, 2, case_1_block_12_phase, case_1_block_12_lumps, column_function<primary_2::columns_12, 2, 1, 2>, column_slope_function<primary_2::column_slopes_12, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_1_block_13_phase, case_1_block_13_lumps, column_function<primary_2::columns_13, 2, 1, 2>, column_slope_function<primary_2::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v2", 1, 1, case_1_block_14_phase, case_1_block_14_lumps, column_function<primary_2::columns_14, 2, 1, 3>, column_slope_function<primary_2::column_slopes_14, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_1_block_15_phase, case_1_block_15_lumps, column_function<primary_2::columns_15, 2, 1, 3>, column_slope_function<primary_2::column_slopes_15, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, case_1_block_16_phase, case_1_block_16_lumps, column_function<primary_2::columns_16, 2, 1, 3>, column_slope_function<primary_2::column_slopes_16, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_1_block_17_phase, case_1_block_17_lumps, column_function<primary_2::columns_17, 2, 1, 5>, column_slope_function<primary_2::column_slopes_17, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, case_1_block_18_phase, case_1_block_18_lumps, column_function<primary_2::columns_18, 2, 1, 3>, column_slope_function<primary_2::column_slopes_18, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, case_1_block_19_phase, case_1_block_19_lumps, column_function<primary_2::columns_19, 2, 1, 2>, column_slope_function<primary_2::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+Omega of v2", 1, 2, case_1_block_20_phase, case_1_block_20_lumps, column_function<primary_2::columns_20, 2, 1, 2>, column_slope_function<primary_2::column_slopes_20, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+omega2+Omega of v2", 1, 2, case_1_block_21_phase, case_1_block_21_lumps, column_function<primary_2::columns_21, 2, 1, 2>, column_slope_function<primary_2::column_slopes_21, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, case_1_block_22_phase, case_1_block_22_lumps, column_function<primary_2::columns_22, 2, 1, 4>, column_slope_function<primary_2::column_slopes_22, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1+omega2+Omega of v2", 1, 2, case_1_block_23_phase, case_1_block_23_lumps, column_function<primary_2::columns_23, 2, 1, 2>, column_slope_function<primary_2::column_slopes_23, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, case_1_block_24_phase, case_1_block_24_lumps, column_function<primary_2::columns_24, 2, 1, 2>, column_slope_function<primary_2::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_1_block_25_phase, case_1_block_25_lumps, column_function<primary_2::columns_25, 2, 1, 1>, column_slope_function<primary_2::column_slopes_25, 2, 1, 1>},
};

constexpr int case_2_relations[] = {-2, 0, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {0, 1}, {1, 2}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr Ratio case_2_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_2_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_5[] = {{0, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_2_lump_6[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_7[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_2_lump_8[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_11[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_12[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_13[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_14[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_17[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_29[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_2_lump_30[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_34[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_35[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_36[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_40[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_42[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_52[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_2_lumps[] = {
  {"mu11", "mu11", case_2_lump_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_2},
  {"mu13", "mu13", case_2_lump_3},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_4},
  {"conservative_v1_conjA_v1_F", "(6*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(12*omega1^3) + (-omega1^2*delta22*eta21 - alpha22*eta21)/(2*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_5},
  {"mu22", "mu22", case_2_lump_6},
  {"mu23", "mu23", case_2_lump_7},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_2_lump_8},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_2_lump_11},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_2_lump_12},
  {"eta11", "eta11", case_2_lump_13},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_2_lump_14},
  {"harmonic_im_v1_F", "-mu12*eta21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"mu12", "mu12", case_2_lump_17},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_F", "(4*omega1^2*delta22*eta11 - 2*omega1*omega2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + (2*omega1*omega2*delta23*eta21 - alpha23*eta21)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v1_F", "(14*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(48*omega1^4) + (3*omega1^2*delta22*eta21 - alpha22*eta21)/(8*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_29},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_2_lump_30},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_2_lump_34},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_2_lump_35},
  {"eta21", "eta21", case_2_lump_36},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_F", "-eta11*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_2_lump_40},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", case_2_lump_42},
  {"harmonic_re_v2_conjA_v1_F", "(2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*delta23*eta21 - alpha23*eta21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_F", "(-3*omega1^2*eta22 - 4*omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - 2*alpha23*eta11)/(24*omega1^3*(omega1 - omega2)) + (4*omega1^2*delta24*eta21 - 2*omega1*omega2*delta24*eta21 + omega2^2*delta24*eta21 - alpha24*eta21)/(4*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_2_lump_52},
  {"harmonic_re_v2_A_v1_F", "(-2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (6*omega1^2*delta23*eta21 - alpha23*eta21)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
};
constexpr int case_2_block_0_lumps[] = {0, 1, 2, 3, 4, 5};
constexpr int case_2_block_1_lumps[] = {1, 2, 6, 7, 8};
constexpr int case_2_block_2_lumps[] = {9, 10};
constexpr int case_2_block_2_phase[] = {-1, 1, 0};
constexpr int case_2_block_3_lumps[] = {11, 12};
constexpr int case_2_block_3_phase[] = {0, 0, 0};
constexpr int case_2_block_4_lumps[] = {13, 14, 15, 16};
constexpr int case_2_block_4_phase[] = {0, 0, 1};
constexpr int case_2_block_5_lumps[] = {17, 18, 19};
constexpr int case_2_block_5_phase[] = {0, 1, 0};
constexpr int case_2_block_6_lumps[] = {20, 21};
constexpr int case_2_block_6_phase[] = {0, 2, 0};
constexpr int case_2_block_7_lumps[] = {22, 23};
constexpr int case_2_block_7_phase[] = {1, 1, 0};
constexpr int case_2_block_8_lumps[] = {24, 25};
constexpr int case_2_block_8_phase[] = {0, 1, -1};
constexpr int case_2_block_9_lumps[] = {26};
constexpr int case_2_block_9_phase[] = {-1, 2, 0};
constexpr int case_2_block_10_lumps[] = {25, 27};
constexpr int case_2_block_10_phase[] = {0, 1, 1};
constexpr int case_2_block_11_lumps[] = {28};
constexpr int case_2_block_11_phase[] = {0, 3, 0};
constexpr int case_2_block_12_lumps[] = {3, 29, 30};
constexpr int case_2_block_12_phase[] = {1, 0, 1};
constexpr int case_2_block_13_lumps[] = {31};
constexpr int case_2_block_13_phase[] = {1, 2, 0};
constexpr int case_2_block_14_lumps[] = {32, 33};
constexpr int case_2_block_14_phase[] = {-1, 1, 0};
constexpr int case_2_block_15_lumps[] = {34, 35};
constexpr int case_2_block_15_phase[] = {0, 0, 0};
constexpr int case_2_block_16_lumps[] = {36, 37, 38, 39};
constexpr int case_2_block_16_phase[] = {0, 0, 1};
constexpr int case_2_block_17_lumps[] = {40, 41};
constexpr int case_2_block_17_phase[] = {0, 2, 0};
constexpr int case_2_block_18_lumps[] = {42, 43, 44, 45};
constexpr int case_2_block_18_phase[] = {1, 0, 0};
constexpr int case_2_block_19_lumps[] = {46, 47};
constexpr int case_2_block_19_phase[] = {1, 1, 0};
constexpr int case_2_block_20_lumps[] = {48, 49};
constexpr int case_2_block_20_phase[] = {0, 1, -1};
constexpr int case_2_block_21_lumps[] = {50};
constexpr int case_2_block_21_phase[] = {-1, 2, 0};
constexpr int case_2_block_22_lumps[] = {49, 51};
constexpr int case_2_block_22_phase[] = {0, 1, 1};
constexpr int case_2_block_23_lumps[] = {7, 52};
constexpr int case_2_block_23_phase[] = {0, 3, 0};
constexpr int case_2_block_24_lumps[] = {53, 54};
constexpr int case_2_block_24_phase[] = {1, 0, 1};
constexpr int case_2_block_25_lumps[] = {55};
constexpr int case_2_block_25_phase[] = {1, 2, 0};
constexpr RegressorBlock case_2_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_2_block_0_lumps, column_function<principal_parametric_1::columns_0, 2, 1, 6>, column_slope_function<principal_parametric_1::column_slopes_0, 2, 1, 6>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_2_block_1_lumps, column_function<principal_parametric_1::columns_1, 2, 1, 5>, column_slope_function<principal_parametric_1::column_slopes_1, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, case_2_block_2_phase, case_2_block_2_lumps, column_function<principal_parametric_1::columns_2, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_2, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_2_block_3_phase, case_2_block_3_lumps, column_function<principal_parametric_1::columns_3, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_3, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, case_2_block_4_phase, case_2_block_4_lumps, column_function<principal_parametric_1::columns_4, 2, 1, 4>, column_slope_function<principal_parametric_1::column_slopes_4, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, case_2_block_5_phase, case_2_block_5_lumps, column_function<principal_parametric_1::columns_5, 2, 1, 3>, column_slope_function<principal_parametric_1::column_slopes_5, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, case_2_block_6_phase, case_2_block_6_lumps, column_function<primary_1::columns_5, 2, 1, 2>, column_slope_function<primary_1::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, case_2_block_7_phase, case_2_block_7_lumps, column_function<principal_parametric_1::columns_7, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2-Omega of v1", 0, 2, case_2_block_8_phase, case_2_block_8_lumps, column_function<principal_parametric_1::columns_8, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_8, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, case_2_block_9_phase, case_2_block_9_lumps, column_function<principal_parametric_1::columns_9, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_9, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, case_2_block_10_phase, case_2_block_10_lumps, column_function<principal_parametric_1::columns_10, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_10, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_2_block_11_phase, case_2_block_11_lumps, column_function<primary_1::columns_11, 2, 1, 1>, column_slope_function<primary_1::column_slopes_11, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, case_2_block_12_phase, case_2_block_12_lumps, column_function<principal_parametric_1::columns_12, 2, 1, 3>, column_slope_function<principal_parametric_1::column_slopes_12, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, case_2_block_13_phase, case_2_block_13_lumps, column_function<principal_parametric_1::columns_13, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_13, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, case_2_block_14_phase, case_2_block_14_lumps, column_function<principal_parametric_1::columns_14, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_14, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_2_block_15_phase, case_2_block_15_lumps, column_function<principal_parametric_1::columns_15, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_15, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, case_2_block_16_phase, case_2_block_16_lumps, column_function<principal_parametric_1::columns_16, 2, 1, 4>, column_slope_function<principal_parametric_1::column_slopes_16, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, case_2_block_17_phase, case_2_block_17_lumps, column_function<primary_1::columns_17, 2, 1, 2>, column_slope_function<primary_1::column_slopes_17, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_2_block_18_phase, case_2_block_18_lumps, column_function<principal_parametric_1::columns_18, 2, 1, 4>, column_slope_function<principal_parametric_1::column_slopes_18, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, case_2_block_19_phase, case_2_block_19_lumps, column_function<principal_parametric_1::columns_19, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2-Omega of v2", 1, 2, case_2_block_20_phase, case_2_block_20_lumps, column_function<principal_parametric_1::columns_20, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_20, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, case_2_block_21_phase, case_2_block_21_lumps, column_function<principal_parametric_1::columns_21, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_21, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, case_2_block_22_phase, case_2_block_22_lumps, column_function<principal_parametric_1::columns_22, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_22, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_2_block_23_phase, case_2_block_23_lumps, column_function<primary_1::columns_24, 2, 1, 2>, column_slope_function<primary_1::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, case_2_block_24_phase, case_2_block_24_lumps, column_function<principal_parametric_1::columns_24, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, case_2_block_25_phase, case_2_block_25_lumps, column_function<principal_parametric_1::columns_25, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_25, 2, 1, 1>},
};

constexpr int case_3_relations[] = {0, -2, 1};
constexpr Ratio case_3_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 2}};
constexpr bool case_3_mode_at_rest[] = {false, false};
constexpr Ratio case_3_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_3_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_5[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_6[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_3_lump_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_8[] = {{0, 1}, {0, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_3_lump_11[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_12[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_13[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_3_lump_17[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_23[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_33[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_36[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_37[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_38[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_3_lump_39[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_3_lump_42[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_3_lump_52[] = {{0, 1}, {0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_3_lump_53[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_3_lumps[] = {
  {"mu11", "mu11", case_3_lump_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_3_lump_2},
  {"mu13", "mu13", case_3_lump_3},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_3_lump_4},
  {"mu22", "mu22", case_3_lump_5},
  {"mu23", "mu23", case_3_lump_6},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_7},
  {"conservative_v2_conjA_v2_F", "(6*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(12*omega2^3) + (omega2^2*delta23*eta11 + alpha23*eta11)/(2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_8},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_3_lump_11},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_3_lump_12},
  {"eta11", "eta11", case_3_lump_13},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_F", "mu12*eta21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"mu12", "mu12", case_3_lump_17},
  {"harmonic_re_v1_conjA_v2_F", "(-2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (2*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_3_lump_23},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F", "(-2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 + 3*omega2^2*eta12 + 2*alpha22*eta21)/(24*omega2^3*(omega1 - omega2)) + (omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 + 4*omega2^2*delta21*eta11 - alpha21*eta11)/(4*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v2_F", "(2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (6*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v1_F", "(2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 - 3*omega2^2*eta12 - 2*alpha22*eta21)/(24*omega2^3*(omega1 + omega2)) + (-omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 - 4*omega2^2*delta21*eta11 + alpha21*eta11)/(4*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_3_lump_33},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_3_lump_36},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_3_lump_37},
  {"eta21", "eta21", case_3_lump_38},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_3_lump_39},
  {"harmonic_im_v2_F", "eta11*mu21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", case_3_lump_42},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_conjA_v1_F", "(-2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 - alpha23*eta21)/(3*omega2^2*(omega1 - omega2)*(omega1 - 3*omega2)) + (-2*omega1*omega2*delta22*eta11 + alpha22*eta11)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_F", "(14*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(48*omega2^4) + (-3*omega2^2*delta23*eta11 + alpha23*eta11)/(8*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_52},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_3_lump_53},
  {"harmonic_re_v2_A_v1_F", "(2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 - alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1*omega2*delta22*eta11 + alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_3_block_0_lumps[] = {0, 1, 2, 3, 4};
constexpr int case_3_block_1_lumps[] = {1, 2, 5, 6, 7, 8};
constexpr int case_3_block_2_lumps[] = {9, 10};
constexpr int case_3_block_2_phase[] = {-1, 1, 0};
constexpr int case_3_block_3_lumps[] = {11, 12};
constexpr int case_3_block_3_phase[] = {0, 0, 0};
constexpr int case_3_block_4_lumps[] = {13, 14, 15, 16};
constexpr int case_3_block_4_phase[] = {0, 0, 1};
constexpr int case_3_block_5_lumps[] = {17, 18, 19, 20};
constexpr int case_3_block_5_phase[] = {0, 1, 0};
constexpr int case_3_block_6_lumps[] = {21, 22};
constexpr int case_3_block_6_phase[] = {1, 1, 0};
constexpr int case_3_block_7_lumps[] = {23, 24};
constexpr int case_3_block_7_phase[] = {2, 0, 0};
constexpr int case_3_block_8_lumps[] = {25};
constexpr int case_3_block_8_phase[] = {-2, 1, 0};
constexpr int case_3_block_9_lumps[] = {26, 27};
constexpr int case_3_block_9_phase[] = {-1, 0, 1};
constexpr int case_3_block_10_lumps[] = {28, 29};
constexpr int case_3_block_10_phase[] = {0, 1, 1};
constexpr int case_3_block_11_lumps[] = {30, 31};
constexpr int case_3_block_11_phase[] = {1, 0, 1};
constexpr int case_3_block_12_lumps[] = {32};
constexpr int case_3_block_12_phase[] = {2, 1, 0};
constexpr int case_3_block_13_lumps[] = {3, 33};
constexpr int case_3_block_13_phase[] = {3, 0, 0};
constexpr int case_3_block_14_lumps[] = {34, 35};
constexpr int case_3_block_14_phase[] = {-1, 1, 0};
constexpr int case_3_block_15_lumps[] = {36, 37};
constexpr int case_3_block_15_phase[] = {0, 0, 0};
constexpr int case_3_block_16_lumps[] = {38, 39, 40, 41};
constexpr int case_3_block_16_phase[] = {0, 0, 1};
constexpr int case_3_block_17_lumps[] = {42, 43, 44};
constexpr int case_3_block_17_phase[] = {1, 0, 0};
constexpr int case_3_block_18_lumps[] = {45, 46};
constexpr int case_3_block_18_phase[] = {1, 1, 0};
constexpr int case_3_block_19_lumps[] = {47, 48};
constexpr int case_3_block_19_phase[] = {2, 0, 0};
constexpr int case_3_block_20_lumps[] = {49};
constexpr int case_3_block_20_phase[] = {-2, 1, 0};
constexpr int case_3_block_21_lumps[] = {50, 51};
constexpr int case_3_block_21_phase[] = {-1, 0, 1};
constexpr int case_3_block_22_lumps[] = {6, 52, 53};
constexpr int case_3_block_22_phase[] = {0, 1, 1};
constexpr int case_3_block_23_lumps[] = {54, 55};
constexpr int case_3_block_23_phase[] = {1, 0, 1};
constexpr int case_3_block_24_lumps[] = {56};
constexpr int case_3_block_24_phase[] = {2, 1, 0};
constexpr int case_3_block_25_lumps[] = {57};
constexpr int case_3_block_25_phase[] = {3, 0, 0};
constexpr RegressorBlock case_3_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_3_block_0_lumps, column_function<principal_parametric_2::columns_0, 2, 1, 5>, column_slope_function<principal_parametric_2::column_slopes_0, 2, 1, 5>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_3_block_1_lumps, column_function<principal_parametric_2::columns_1, 2, 1, 6>, column_slope_function<principal_parametric_2::column_slopes_1, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, case_3_block_2_phase, case_3_block_2_lumps, column_function<principal_parametric_1::columns_2, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_2, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_3_block_3_phase, case_3_block_3_lumps, column_function<principal_parametric_1::columns_3, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_3, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, case_3_block_4_phase, case_3_block_4_lumps, column_function<principal_parametric_2::columns_4, 2, 1, 4>, column_slope_function<principal_parametric_2::column_slopes_4, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, case_3_block_5_phase, case_3_block_5_lumps, column_function<principal_parametric_2::columns_5, 2, 1, 4>, column_slope_function<principal_parametric_2::column_slopes_5, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, case_3_block_6_phase, case_3_block_6_lumps, column_function<principal_parametric_1::columns_7, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, case_3_block_7_phase, case_3_block_7_lumps, column_function<primary_2::columns_7, 2, 1, 2>, column_slope_function<primary_2::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, case_3_block_8_phase, case_3_block_8_lumps, column_function<principal_parametric_2::columns_8, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_8, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v1", 0, 2, case_3_block_9_phase, case_3_block_9_lumps, column_function<principal_parametric_2::columns_9, 2, 1, 2>, column_slope_function<principal_parametric_2::column_slopes_9, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, case_3_block_10_phase, case_3_block_10_lumps, column_function<principal_parametric_2::columns_10, 2, 1, 2>, column_slope_function<principal_parametric_2::column_slopes_10, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, case_3_block_11_phase, case_3_block_11_lumps, column_function<principal_parametric_2::columns_11, 2, 1, 2>, column_slope_function<principal_parametric_2::column_slopes_11, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, case_3_block_12_phase, case_3_block_12_lumps, column_function<principal_parametric_2::columns_12, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_3_block_13_phase, case_3_block_13_lumps, column_function<primary_2::columns_13, 2, 1, 2>, column_slope_function<primary_2::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, case_3_block_14_phase, case_3_block_14_lumps, column_function<principal_parametric_1::columns_14, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_14, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_3_block_15_phase, case_3_block_15_lumps, column_function<principal_parametric_1::columns_15, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_15, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, case_3_block_16_phase, case_3_block_16_lumps, column_function<principal_parametric_2::columns_16, 2, 1, 4>, column_slope_function<principal_parametric_2::column_slopes_16, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_3_block_17_phase, case_3_block_17_lumps, column_function<principal_parametric_2::columns_17, 2, 1, 3>, column_slope_function<principal_parametric_2::column_slopes_17, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, case_3_block_18_phase, case_3_block_18_lumps, column_function<principal_parametric_1::columns_19, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, case_3_block_19_phase, case_3_block_19_lumps, column_function<primary_2::columns_19, 2, 1, 2>, column_slope_function<primary_2::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, case_3_block_20_phase, case_3_block_20_lumps, column_function<principal_parametric_2::columns_20, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_20, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+Omega of v2", 1, 2, case_3_block_21_phase, case_3_block_21_lumps, column_function<principal_parametric_2::columns_21, 2, 1, 2>, column_slope_function<principal_parametric_2::column_slopes_21, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, case_3_block_22_phase, case_3_block_22_lumps, column_function<principal_parametric_2::columns_22, 2, 1, 3>, column_slope_function<principal_parametric_2::column_slopes_22, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, case_3_block_23_phase, case_3_block_23_lumps, column_function<principal_parametric_2::columns_23, 2, 1, 2>, column_slope_function<principal_parametric_2::column_slopes_23, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, case_3_block_24_phase, case_3_block_24_lumps, column_function<principal_parametric_2::columns_24, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_24, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_3_block_25_phase, case_3_block_25_lumps, column_function<primary_2::columns_25, 2, 1, 1>, column_slope_function<primary_2::column_slopes_25, 2, 1, 1>},
};

constexpr int case_4_relations[] = {-1, -1, 1};
constexpr Ratio case_4_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_4_mode_at_rest[] = {false, false};
constexpr Ratio case_4_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_3[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_4_lump_5[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_8[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_10[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_4_lump_11[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_13[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_4_lump_14[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_22[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_23[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_26[] = {{1, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_4_lump_37[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_48[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_53[] = {{0, 1}, {0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_4_lump_54[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_4_lump_58[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_59[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_62[] = {{0, 1}, {1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_4_lump_70[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_4_lump_82[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_4_lumps[] = {
  {"mu11", "mu11", case_4_lump_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_F2", "-eta12^2/(4*omega1*(omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_4_lump_3},
  {"mu13", "mu13", case_4_lump_4},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_4_lump_5},
  {"dissipative_v1_conjA_v2_F", "(omega1*mu12*eta22 + omega2*mu12*eta12)/(4*omega1*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_conjA_v2_F", "(omega1*omega2*delta23*eta21 + omega2^2*delta23*eta21 - alpha23*eta21)/(2*omega1^2*(omega1 + 2*omega2)) + (omega1^2*delta22*eta11 + omega1*omega2*delta22*eta11 - alpha22*eta11)/(2*omega1*omega2*(2*omega1 + omega2))", {}},
  {"mu22", "mu22", case_4_lump_8},
  {"conservative_v2_A_v2_F2", "eta22^2/(4*omega2*(omega1 + 3*omega2)*(omega1 - omega2))", {}},
  {"mu23", "mu23", case_4_lump_10},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_4_lump_11},
  {"dissipative_v2_conjA_v1_F", "(-omega1*mu21*eta22 - omega2*eta12*mu21)/(4*omega2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"eta12", "eta12", case_4_lump_13},
  {"mu12", "mu12", case_4_lump_14},
  {"harmonic_re_v1_conjA_v1_F", "(omega1*omega2*delta22*eta21 + alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1^2*delta21*eta11 - omega1*omega2*delta21*eta11 - omega2^2*delta21*eta11 + alpha21*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_conjA_v12_F", "(3*omega1^4*delta21*eta12 - 6*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - 5*omega1^2*alpha21*eta12 - omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_F", "(-omega1*omega2*delta23*eta22 + alpha23*eta22)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_4_lump_22},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_4_lump_23},
  {"harmonic_re_v1_conjA_v1_conjA_v2_F", "(-omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1^2*omega2*(2*omega1 + omega2)) + (-alpha22*eta12 + alpha22*eta22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_F2", "-eta11*eta12/(2*omega1^2*omega2*(2*omega1 + omega2))", {}},
  {"eta11", "eta11", case_4_lump_26},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_F", "(-omega1*mu12*eta21 - omega2*mu12*eta21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2_F", "(-omega2^2*delta23*eta12 + alpha23*eta12)/(omega1^2*omega2*(2*omega1 + omega2)) + (-2*omega2^2*delta23*eta22 - 2*alpha23*eta22)/(omega2*(omega1 + 3*omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v1_conjA_v1_F", "(-3*omega1^4*delta21*eta12 - 2*omega1^3*omega2*delta21*eta12 - omega1^2*omega2^2*delta21*eta12 + 5*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 - omega2^2*alpha21*eta12)/(omega1^2*omega2*(omega1 - omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v1_F", "(2*omega1*omega2*delta22*eta22 + alpha22*eta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (omega1^4*delta22*eta12 - omega1^3*omega2*delta22*eta12 - omega1^2*omega2^2*delta22*eta12 - omega1^2*alpha22*eta12 + 5*omega1*omega2^3*delta22*eta12 - 2*omega1*omega2*alpha22*eta12 - 2*omega2^4*delta22*eta12 + 2*omega2^2*alpha22*eta12)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_F", "(2*omega1^2*delta22*eta21 + omega1*omega2*delta22*eta21 - alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (3*omega1^2*delta21*eta11 + 3*omega1*omega2*delta21*eta11 + omega2^2*delta21*eta11 - alpha21*eta11)/(omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_4_lump_37},
  {"harmonic_re_v1_A_v1_conjA_v2_F", "alpha22*eta12/(3*omega1^2*omega2*(2*omega1 - omega2)) + (2*omega1^2*delta22*eta22 - alpha22*eta22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) - alpha22*eta12/(3*omega1^2*(omega1 + omega2)*(3*omega1 + omega2)) + (-3*omega1^3*delta22*eta12 + 7*omega1^2*omega2*delta22*eta12 + 3*omega1*omega2^2*delta22*eta12 - omega2^3*delta22*eta12)/(3*omega1*omega2*(omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_F", "-delta23*eta21/(4*omega1*(omega1 + 2*omega2)) + (omega1*delta22*eta11 + 2*omega2*delta22*eta11)/(4*omega2^2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) - alpha22*eta11/(4*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v2_F", "(-omega1*mu12*eta22 - 2*omega2*mu12*eta22)/(8*omega2*(omega1 + omega2)^2*(omega1 + 3*omega2)) + mu12*eta12/(8*(omega1 + omega2)^2*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_F", "2*omega1*delta22*eta22/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2)) - alpha22*eta22/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2)) + (3*omega1^3*delta22*eta12 + 12*omega1^2*omega2*delta22*eta12 + 9*omega1*omega2^2*delta22*eta12 + 2*omega2^3*delta22*eta12)/(omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2)) + (-3*omega1^2*alpha22*eta12 - 6*omega1*omega2*alpha22*eta12 - 2*omega2^2*alpha22*eta12)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v12_F", "(51*omega1^4*delta21*eta12 + 42*omega1^3*omega2*delta21*eta12 + 9*omega1^2*omega2^2*delta21*eta12 - 9*omega1^2*alpha21*eta12 - 4*omega1*omega2*alpha21*eta12 - omega2^2*alpha21*eta12)/(6*omega1^2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(4*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_4_lump_48},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_conjA_v12_F", "(-omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*omega1*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v22_F", "(9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 - 6*omega1*omega2^3*delta24*eta22 + 3*omega2^4*delta24*eta22 - 5*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"eta22", "eta22", case_4_lump_53},
  {"mu21", "mu21", case_4_lump_54},
  {"harmonic_re_v2_conjA_v2_F", "(omega1^2*delta24*eta21 + omega1*omega2*delta24*eta21 + omega2^2*delta24*eta21 - alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1*omega2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_4_lump_58},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_4_lump_59},
  {"harmonic_re_v2_conjA_v1_conjA_v2_F", "(-omega1*omega2*delta23*eta22 - omega2^2*delta23*eta22 + alpha23*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)) + (-alpha23*eta12 + alpha23*eta22)/(omega2^2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_F2", "-eta21*eta22/(2*omega1*omega2^2*(omega1 + 2*omega2))", {}},
  {"eta21", "eta21", case_4_lump_62},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_F", "(-omega1*eta11*mu21 - omega2*eta11*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2_F", "(omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 + 2*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 3*omega2^4*delta24*eta22 - 5*omega2^2*alpha24*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v1_F", "(-omega1^2*delta22*eta22 + alpha22*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)) + (2*omega1^2*delta22*eta12 + 2*alpha22*eta12)/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_F", "(omega1^2*delta24*eta21 + 3*omega1*omega2*delta24*eta21 + 3*omega2^2*delta24*eta21 - alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_4_lump_70},
  {"harmonic_re_v2_A_v2_conjA_v1_F", "-alpha23*eta22/(3*omega1*omega2^2*(omega1 - 2*omega2)) - alpha23*eta22/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (-2*omega2^2*delta23*eta12 + alpha23*eta12)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (omega1^3*delta23*eta22 - 3*omega1^2*omega2*delta23*eta22 - 7*omega1*omega2^2*delta23*eta22 + 3*omega2^3*delta23*eta22)/(3*omega1*omega2*(omega1 + omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_conjA_v2_F", "(-2*omega1*omega2*delta23*eta12 - alpha23*eta12)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (2*omega1^4*delta23*eta22 - 5*omega1^3*omega2*delta23*eta22 + omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 + omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^4*delta23*eta22 + omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_F", "(2*omega1*delta23*eta21 + omega2*delta23*eta21)/(4*omega1^2*(omega1 + 2*omega2)) - delta22*eta11/(4*omega2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) - alpha22*eta11/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_im_v2_A_v1_F", "-mu21*eta22/(8*(omega1 + omega2)^2*(omega1 - omega2)) + (-2*omega1*eta12*mu21 - omega2*eta12*mu21)/(8*omega1*(omega1 + omega2)^2*(3*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_F", "2*omega2*delta23*eta12/((2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) - alpha23*eta12/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) + (2*omega1^3*delta23*eta22 + 9*omega1^2*omega2*delta23*eta22 + 12*omega1*omega2^2*delta23*eta22 + 3*omega2^3*delta23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2)) + (-2*omega1^2*alpha23*eta22 - 6*omega1*omega2*alpha23*eta22 - 3*omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2))", {}},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_4_lump_82},
  {"harmonic_re_v2_A_v12_F", "(-2*omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 - alpha22*eta12)/(3*omega1*(omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(6*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + 2*omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_4_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr int case_4_block_1_lumps[] = {1, 3, 7, 8, 9, 10, 11, 12};
constexpr int case_4_block_2_lumps[] = {13, 14, 15, 16, 17};
constexpr int case_4_block_2_phase[] = {0, 1, 0};
constexpr int case_4_block_3_lumps[] = {18, 19, 20, 21};
constexpr int case_4_block_3_phase[] = {-1, 1, 0};
constexpr int case_4_block_4_lumps[] = {22, 23, 24, 25};
constexpr int case_4_block_4_phase[] = {0, 0, 0};
constexpr int case_4_block_5_lumps[] = {26, 27, 28, 29, 30, 31};
constexpr int case_4_block_5_phase[] = {0, 0, 1};
constexpr int case_4_block_6_lumps[] = {32, 33, 34};
constexpr int case_4_block_6_phase[] = {0, 2, 0};
constexpr int case_4_block_7_lumps[] = {13, 35, 36};
constexpr int case_4_block_7_phase[] = {1, 0, 1};
constexpr int case_4_block_8_lumps[] = {37, 38, 39};
constexpr int case_4_block_8_phase[] = {2, 0, 0};
constexpr int case_4_block_9_lumps[] = {40};
constexpr int case_4_block_9_phase[] = {-2, 1, 0};
constexpr int case_4_block_10_lumps[] = {2, 41, 42, 43};
constexpr int case_4_block_10_phase[] = {0, 1, 1};
constexpr int case_4_block_11_lumps[] = {44};
constexpr int case_4_block_11_phase[] = {-1, 2, 0};
constexpr int case_4_block_12_lumps[] = {25, 45};
constexpr int case_4_block_12_phase[] = {0, 0, 2};
constexpr int case_4_block_13_lumps[] = {21};
constexpr int case_4_block_13_phase[] = {0, 2, 1};
constexpr int case_4_block_14_lumps[] = {46};
constexpr int case_4_block_14_phase[] = {0, 3, 0};
constexpr int case_4_block_15_lumps[] = {2};
constexpr int case_4_block_15_phase[] = {1, 0, 2};
constexpr int case_4_block_16_lumps[] = {47};
constexpr int case_4_block_16_phase[] = {2, 0, 1};
constexpr int case_4_block_17_lumps[] = {4, 48};
constexpr int case_4_block_17_phase[] = {3, 0, 0};
constexpr int case_4_block_18_lumps[] = {49, 50, 51, 52};
constexpr int case_4_block_18_phase[] = {-1, 1, 0};
constexpr int case_4_block_19_lumps[] = {53, 54, 55, 56, 57};
constexpr int case_4_block_19_phase[] = {1, 0, 0};
constexpr int case_4_block_20_lumps[] = {58, 59, 60, 61};
constexpr int case_4_block_20_phase[] = {0, 0, 0};
constexpr int case_4_block_21_lumps[] = {62, 63, 64, 65, 66, 67};
constexpr int case_4_block_21_phase[] = {0, 0, 1};
constexpr int case_4_block_22_lumps[] = {53, 68, 69};
constexpr int case_4_block_22_phase[] = {0, 1, 1};
constexpr int case_4_block_23_lumps[] = {70, 71, 72};
constexpr int case_4_block_23_phase[] = {0, 2, 0};
constexpr int case_4_block_24_lumps[] = {73, 74, 75};
constexpr int case_4_block_24_phase[] = {2, 0, 0};
constexpr int case_4_block_25_lumps[] = {76};
constexpr int case_4_block_25_phase[] = {-2, 1, 0};
constexpr int case_4_block_26_lumps[] = {77};
constexpr int case_4_block_26_phase[] = {-1, 2, 0};
constexpr int case_4_block_27_lumps[] = {9, 78, 79, 80};
constexpr int case_4_block_27_phase[] = {1, 0, 1};
constexpr int case_4_block_28_lumps[] = {61, 81};
constexpr int case_4_block_28_phase[] = {0, 0, 2};
constexpr int case_4_block_29_lumps[] = {9};
constexpr int case_4_block_29_phase[] = {0, 1, 2};
constexpr int case_4_block_30_lumps[] = {52};
constexpr int case_4_block_30_phase[] = {0, 2, 1};
constexpr int case_4_block_31_lumps[] = {10, 82};
constexpr int case_4_block_31_phase[] = {0, 3, 0};
constexpr int case_4_block_32_lumps[] = {83};
constexpr int case_4_block_32_phase[] = {2, 0, 1};
constexpr int case_4_block_33_lumps[] = {84};
constexpr int case_4_block_33_phase[] = {3, 0, 0};
constexpr RegressorBlock case_4_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_4_block_0_lumps, column_function<additive_combination::columns_0, 2, 1, 8>, column_slope_function<additive_combination::column_slopes_0, 2, 1, 8>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_4_block_1_lumps, column_function<additive_combination::columns_1, 2, 1, 8>, column_slope_function<additive_combination::column_slopes_1, 2, 1, 8>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, case_4_block_2_phase, case_4_block_2_lumps, column_function<additive_combination::columns_2, 2, 1, 5>, column_slope_function<additive_combination::column_slopes_2, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, case_4_block_3_phase, case_4_block_3_lumps, column_function<additive_combination::columns_3, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_3, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_4_block_4_phase, case_4_block_4_lumps, column_function<additive_combination::columns_4, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_4, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, case_4_block_5_phase, case_4_block_5_lumps, column_function<additive_combination::columns_5, 2, 1, 6>, column_slope_function<additive_combination::column_slopes_5, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, case_4_block_6_phase, case_4_block_6_lumps, column_function<additive_combination::columns_6, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_6, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 1, case_4_block_7_phase, case_4_block_7_lumps, column_function<additive_combination::columns_7, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_7, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, case_4_block_8_phase, case_4_block_8_lumps, column_function<additive_combination::columns_8, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_8, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, case_4_block_9_phase, case_4_block_9_lumps, column_function<principal_parametric_2::columns_8, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_8, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, case_4_block_10_phase, case_4_block_10_lumps, column_function<additive_combination::columns_10, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_10, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, case_4_block_11_phase, case_4_block_11_lumps, column_function<principal_parametric_1::columns_9, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_9, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*Omega of v1", 0, 2, case_4_block_12_phase, case_4_block_12_lumps, column_function<additive_combination::columns_12, 2, 1, 2>, column_slope_function<additive_combination::column_slopes_12, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v1", 0, 2, case_4_block_13_phase, case_4_block_13_lumps, column_function<additive_combination::columns_13, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_13, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_4_block_14_phase, case_4_block_14_lumps, column_function<primary_1::columns_11, 2, 1, 1>, column_slope_function<primary_1::column_slopes_11, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 2, case_4_block_15_phase, case_4_block_15_lumps, column_function<additive_combination::columns_15, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_15, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v1", 0, 2, case_4_block_16_phase, case_4_block_16_lumps, column_function<additive_combination::columns_16, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_16, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_4_block_17_phase, case_4_block_17_lumps, column_function<primary_2::columns_13, 2, 1, 2>, column_slope_function<primary_2::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, case_4_block_18_phase, case_4_block_18_lumps, column_function<additive_combination::columns_18, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_18, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_4_block_19_phase, case_4_block_19_lumps, column_function<additive_combination::columns_19, 2, 1, 5>, column_slope_function<additive_combination::column_slopes_19, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_4_block_20_phase, case_4_block_20_lumps, column_function<additive_combination::columns_20, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_20, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, case_4_block_21_phase, case_4_block_21_lumps, column_function<additive_combination::columns_21, 2, 1, 6>, column_slope_function<additive_combination::column_slopes_21, 2, 1, 6>},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 1, case_4_block_22_phase, case_4_block_22_lumps, column_function<additive_combination::columns_22, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_22, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, case_4_block_23_phase, case_4_block_23_lumps, column_function<additive_combination::columns_23, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_23, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, case_4_block_24_phase, case_4_block_24_lumps, column_function<additive_combination::columns_24, 2, 1, 3>, column_slope_function<additive_combination::column_slopes_24, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, case_4_block_25_phase, case_4_block_25_lumps, column_function<principal_parametric_2::columns_20, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_20, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, case_4_block_26_phase, case_4_block_26_lumps, column_function<principal_parametric_1::columns_21, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_21, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, case_4_block_27_phase, case_4_block_27_lumps, column_function<additive_combination::columns_27, 2, 1, 4>, column_slope_function<additive_combination::column_slopes_27, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 2*Omega of v2", 1, 2, case_4_block_28_phase, case_4_block_28_lumps, column_function<additive_combination::columns_28, 2, 1, 2>, column_slope_function<additive_combination::column_slopes_28, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2+2*Omega of v2", 1, 2, case_4_block_29_phase, case_4_block_29_lumps, column_function<additive_combination::columns_29, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_29, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega2+Omega of v2", 1, 2, case_4_block_30_phase, case_4_block_30_lumps, column_function<additive_combination::columns_30, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_30, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_4_block_31_phase, case_4_block_31_lumps, column_function<primary_1::columns_24, 2, 1, 2>, column_slope_function<primary_1::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1+Omega of v2", 1, 2, case_4_block_32_phase, case_4_block_32_lumps, column_function<additive_combination::columns_32, 2, 1, 1>, column_slope_function<additive_combination::column_slopes_32, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_4_block_33_phase, case_4_block_33_lumps, column_function<primary_2::columns_25, 2, 1, 1>, column_slope_function<primary_2::column_slopes_25, 2, 1, 1>},
};

constexpr Ratio case_5_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_5_mode_at_rest[] = {false, false};
constexpr Ratio case_5_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_2[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_5_lump_4[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_5[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_6[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_5_lump_7[] = {{0, 1}, {-2, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_10[] = {{1, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_11[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_12[] = {{1, 1}, {-1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_19[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_26[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_29[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_30[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_31[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_5_lump_33[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_5_lump_42[] = {{0, 1}, {-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_5_lumps[] = {
  {"mu11", "mu11", case_5_lump_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"conservative_v1_A_v1_A_v2_conjA_v2", "(-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 + 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 + 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 - 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) + (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 + 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 - 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", case_5_lump_2},
  {"mu13", "mu13", case_5_lump_3},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_5_lump_4},
  {"mu22", "mu22", case_5_lump_5},
  {"mu23", "mu23", case_5_lump_6},
  {"conservative_v2_A_v22_conjA_v2", "(6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 + 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 + 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 - 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_5_lump_7},
  {"harmonic_re_v1_A_v2_conjA_v1", "(2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 - omega2))", {}},
  {"harmonic_im_v1_A_v2_conjA_v1", "(2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 + 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v2", "(2*omega2^2*delta23 - 2*alpha23)/omega1^2", case_5_lump_10},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_5_lump_11},
  {"mu12", "mu12", case_5_lump_12},
  {"harmonic_re_v1_A_v22_conjA_v2", "(-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 - 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 + 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23 - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 + 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1", "(2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 + 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 + 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22 - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 - 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22", "(-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v1_A_v22", "(6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2", "(-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 + omega2))", {}},
  {"harmonic_im_v1_A_v1_A_v2", "(-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 + 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 + 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 - 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_5_lump_19},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_conjA_v12", "(-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 - omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 + 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 + 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 + 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 - 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 - 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1", "(-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 + 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 - 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 - omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 + omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v23", "(12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 - 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 + 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v22", "(6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 - 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 - 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 + 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 - omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 + 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 + omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 + omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 + 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 - omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2", "(-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 + omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 - 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 + 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 - 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 - 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 - 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 + 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 + 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 + 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 + 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_5_lump_26},
  {"harmonic_re_v2_A_v2_conjA_v1", "(2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 - 2*omega2))", {}},
  {"harmonic_im_v2_A_v2_conjA_v1", "(-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 - 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 + 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v2", "(2*omega2^2*delta24 - 2*alpha24)/omega2^2", case_5_lump_29},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_5_lump_30},
  {"harmonic_re_v2_A_v22", "(-3*omega2^2*delta24 + alpha24)/(3*omega2^2)", case_5_lump_31},
  {"harmonic_im_v2_A_v22", "(4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 - omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", {}},
  {"mu21", "mu21", case_5_lump_33},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2", "(-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 - 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 + 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 + 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 + 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2", "(-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_im_v2_A_v1_A_v2", "(-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 - 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 - 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 - 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12", "(3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 + 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) + (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 + 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 + 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1", "(2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 - omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 + 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) + (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 + 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 + 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v23", "(42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 + 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 - alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))", case_5_lump_42},
  {"harmonic_re_v2_A_v1_A_v22", "(-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 + omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 - 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) + (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 + 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 - 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 - 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 + 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 + 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) + (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 - 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 - 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2", "(3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 - 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 - 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 - 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) + (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 - 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 - omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 - 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 + omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 + alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_5_block_0_lumps[] = {0, 1, 2, 3, 4};
constexpr int case_5_block_1_lumps[] = {1, 2, 5, 6, 7};
constexpr int case_5_block_2_lumps[] = {8, 9};
constexpr int case_5_block_2_phase[] = {-1, 1, 0};
constexpr int case_5_block_3_lumps[] = {10, 11};
constexpr int case_5_block_3_phase[] = {0, 0, 0};
constexpr int case_5_block_4_lumps[] = {12, 13, 14};
constexpr int case_5_block_4_phase[] = {0, 1, 0};
constexpr int case_5_block_5_lumps[] = {15, 16};
constexpr int case_5_block_5_phase[] = {0, 2, 0};
constexpr int case_5_block_6_lumps[] = {17, 18};
constexpr int case_5_block_6_phase[] = {1, 1, 0};
constexpr int case_5_block_7_lumps[] = {19, 20};
constexpr int case_5_block_7_phase[] = {2, 0, 0};
constexpr int case_5_block_8_lumps[] = {21};
constexpr int case_5_block_8_phase[] = {-2, 1, 0};
constexpr int case_5_block_9_lumps[] = {22};
constexpr int case_5_block_9_phase[] = {-1, 2, 0};
constexpr int case_5_block_10_lumps[] = {23};
constexpr int case_5_block_10_phase[] = {0, 3, 0};
constexpr int case_5_block_11_lumps[] = {24};
constexpr int case_5_block_11_phase[] = {1, 2, 0};
constexpr int case_5_block_12_lumps[] = {25};
constexpr int case_5_block_12_phase[] = {2, 1, 0};
constexpr int case_5_block_13_lumps[] = {3, 26};
constexpr int case_5_block_13_phase[] = {3, 0, 0};
constexpr int case_5_block_14_lumps[] = {27, 28};
constexpr int case_5_block_14_phase[] = {-1, 1, 0};
constexpr int case_5_block_15_lumps[] = {29, 30};
constexpr int case_5_block_15_phase[] = {0, 0, 0};
constexpr int case_5_block_16_lumps[] = {31, 32};
constexpr int case_5_block_16_phase[] = {0, 2, 0};
constexpr int case_5_block_17_lumps[] = {33, 34, 35};
constexpr int case_5_block_17_phase[] = {1, 0, 0};
constexpr int case_5_block_18_lumps[] = {36, 37};
constexpr int case_5_block_18_phase[] = {1, 1, 0};
constexpr int case_5_block_19_lumps[] = {38, 39};
constexpr int case_5_block_19_phase[] = {2, 0, 0};
constexpr int case_5_block_20_lumps[] = {40};
constexpr int case_5_block_20_phase[] = {-2, 1, 0};
constexpr int case_5_block_21_lumps[] = {41};
constexpr int case_5_block_21_phase[] = {-1, 2, 0};
constexpr int case_5_block_22_lumps[] = {6, 42};
constexpr int case_5_block_22_phase[] = {0, 3, 0};
constexpr int case_5_block_23_lumps[] = {43};
constexpr int case_5_block_23_phase[] = {1, 2, 0};
constexpr int case_5_block_24_lumps[] = {44};
constexpr int case_5_block_24_phase[] = {2, 1, 0};
constexpr int case_5_block_25_lumps[] = {45};
constexpr int case_5_block_25_phase[] = {3, 0, 0};
constexpr RegressorBlock case_5_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_5_block_0_lumps, column_function<principal_parametric_2::columns_0, 2, 1, 5>, column_slope_function<principal_parametric_2::column_slopes_0, 2, 1, 5>},
  {BlockKind::modulation, "modulation of v2", 1, 0, {}, case_5_block_1_lumps, column_function<principal_parametric_1::columns_1, 2, 1, 5>, column_slope_function<principal_parametric_1::column_slopes_1, 2, 1, 5>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v1", 0, 1, case_5_block_2_phase, case_5_block_2_lumps, column_function<principal_parametric_1::columns_2, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_2, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_5_block_3_phase, case_5_block_3_lumps, column_function<principal_parametric_1::columns_3, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_3, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 1, case_5_block_4_phase, case_5_block_4_lumps, column_function<principal_parametric_1::columns_5, 2, 1, 3>, column_slope_function<principal_parametric_1::column_slopes_5, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v1", 0, 1, case_5_block_5_phase, case_5_block_5_lumps, column_function<primary_1::columns_5, 2, 1, 2>, column_slope_function<primary_1::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v1", 0, 1, case_5_block_6_phase, case_5_block_6_lumps, column_function<principal_parametric_1::columns_7, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, case_5_block_7_phase, case_5_block_7_lumps, column_function<primary_2::columns_7, 2, 1, 2>, column_slope_function<primary_2::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, case_5_block_8_phase, case_5_block_8_lumps, column_function<principal_parametric_2::columns_8, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_8, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, case_5_block_9_phase, case_5_block_9_lumps, column_function<principal_parametric_1::columns_9, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_9, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, case_5_block_10_phase, case_5_block_10_lumps, column_function<primary_1::columns_11, 2, 1, 1>, column_slope_function<primary_1::column_slopes_11, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, case_5_block_11_phase, case_5_block_11_lumps, column_function<principal_parametric_1::columns_13, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_13, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, case_5_block_12_phase, case_5_block_12_lumps, column_function<principal_parametric_2::columns_12, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_12, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_5_block_13_phase, case_5_block_13_lumps, column_function<primary_2::columns_13, 2, 1, 2>, column_slope_function<primary_2::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -omega1+omega2 of v2", 1, 1, case_5_block_14_phase, case_5_block_14_lumps, column_function<principal_parametric_1::columns_14, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_14, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_5_block_15_phase, case_5_block_15_lumps, column_function<principal_parametric_1::columns_15, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_15, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega2 of v2", 1, 1, case_5_block_16_phase, case_5_block_16_lumps, column_function<primary_1::columns_17, 2, 1, 2>, column_slope_function<primary_1::column_slopes_17, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_5_block_17_phase, case_5_block_17_lumps, column_function<principal_parametric_2::columns_17, 2, 1, 3>, column_slope_function<principal_parametric_2::column_slopes_17, 2, 1, 3>},
  {BlockKind::harmonic, "harmonic omega1+omega2 of v2", 1, 1, case_5_block_18_phase, case_5_block_18_lumps, column_function<principal_parametric_1::columns_19, 2, 1, 2>, column_slope_function<principal_parametric_1::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, case_5_block_19_phase, case_5_block_19_lumps, column_function<primary_2::columns_19, 2, 1, 2>, column_slope_function<primary_2::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, case_5_block_20_phase, case_5_block_20_lumps, column_function<principal_parametric_2::columns_20, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_20, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, case_5_block_21_phase, case_5_block_21_lumps, column_function<principal_parametric_1::columns_21, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_21, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, case_5_block_22_phase, case_5_block_22_lumps, column_function<primary_1::columns_24, 2, 1, 2>, column_slope_function<primary_1::column_slopes_24, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, case_5_block_23_phase, case_5_block_23_lumps, column_function<principal_parametric_1::columns_25, 2, 1, 1>, column_slope_function<principal_parametric_1::column_slopes_25, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, case_5_block_24_phase, case_5_block_24_lumps, column_function<principal_parametric_2::columns_24, 2, 1, 1>, column_slope_function<principal_parametric_2::column_slopes_24, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_5_block_25_phase, case_5_block_25_lumps, column_function<primary_2::columns_25, 2, 1, 1>, column_slope_function<primary_2::column_slopes_25, 2, 1, 1>},
};

constexpr Ratio case_6_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_6_mode_at_rest[] = {false, true};
constexpr Ratio case_6_lump_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_6_lump_2[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_6_lump_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_6_lump_4[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_6_lump_5[] = {{-1, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_6_lump_7[] = {{-2, 1}, {0, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_6_lump_8[] = {{0, 1}, {-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_6_lump_9[] = {{-1, 1}, {1, 1}, {0, 1}, {-1, 1}};
constexpr CompiledLump case_6_lumps[] = {
  {"mu11", "mu11", case_6_lump_0},
  {"conservative_v1_A_v1", "-omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"mu13", "mu13", case_6_lump_2},
  {"conservative_v1_A_v12_conjA_v1", "(6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 + 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 + 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 + 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_6_lump_3},
  {"harmonic_re_v1_A_v1_conjA_v1", "(2*omega1^2*delta21 - 2*alpha21)/omega1^2", case_6_lump_4},
  {"harmonic_re_v1_A_v12", "(-3*omega1^2*delta21 + alpha21)/(3*omega1^2)", case_6_lump_5},
  {"harmonic_im_v1_A_v12", "(-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 - omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v13", "(42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 + 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 + alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))", case_6_lump_7},
  {"harmonic_re_v2_A_v1_conjA_v1", "(2*omega1^2*delta22 - 2*alpha22)/omega2^2", case_6_lump_8},
  {"mu21", "mu21", case_6_lump_9},
  {"harmonic_re_v2_A_v12_conjA_v1", "(12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 - 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 - 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 - 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12", "(omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_im_v2_A_v12", "(-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v13", "(-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 - 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 + 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
};
constexpr int case_6_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_6_block_1_lumps[] = {4};
constexpr int case_6_block_1_phase[] = {0, 0, 0};
constexpr int case_6_block_2_lumps[] = {5, 6};
constexpr int case_6_block_2_phase[] = {2, 0, 0};
constexpr int case_6_block_3_lumps[] = {2, 7};
constexpr int case_6_block_3_phase[] = {3, 0, 0};
constexpr int case_6_block_4_lumps[] = {8};
constexpr int case_6_block_4_phase[] = {0, 0, 0};
constexpr int case_6_block_5_lumps[] = {9, 10};
constexpr int case_6_block_5_phase[] = {1, 0, 0};
constexpr int case_6_block_6_lumps[] = {11, 12};
constexpr int case_6_block_6_phase[] = {2, 0, 0};
constexpr int case_6_block_7_lumps[] = {13};
constexpr int case_6_block_7_phase[] = {3, 0, 0};
constexpr RegressorBlock case_6_blocks[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, {}, case_6_block_0_lumps, column_function<free_1::columns_0, 2, 1, 4>, column_slope_function<free_1::column_slopes_0, 2, 1, 4>},
  {BlockKind::harmonic, "harmonic 0 of v1", 0, 1, case_6_block_1_phase, case_6_block_1_lumps, column_function<free_1::columns_1, 2, 1, 1>, column_slope_function<free_1::column_slopes_1, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v1", 0, 1, case_6_block_2_phase, case_6_block_2_lumps, column_function<primary_2::columns_7, 2, 1, 2>, column_slope_function<primary_2::column_slopes_7, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, case_6_block_3_phase, case_6_block_3_lumps, column_function<primary_2::columns_13, 2, 1, 2>, column_slope_function<primary_2::column_slopes_13, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 0 of v2", 1, 1, case_6_block_4_phase, case_6_block_4_lumps, column_function<free_1::columns_4, 2, 1, 1>, column_slope_function<free_1::column_slopes_4, 2, 1, 1>},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 1, case_6_block_5_phase, case_6_block_5_lumps, column_function<free_1::columns_5, 2, 1, 2>, column_slope_function<free_1::column_slopes_5, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 2*omega1 of v2", 1, 1, case_6_block_6_phase, case_6_block_6_lumps, column_function<primary_2::columns_19, 2, 1, 2>, column_slope_function<primary_2::column_slopes_19, 2, 1, 2>},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, case_6_block_7_phase, case_6_block_7_lumps, column_function<primary_2::columns_25, 2, 1, 1>, column_slope_function<primary_2::column_slopes_25, 2, 1, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "primary_1",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = primary_1::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = primary_1::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<primary_1::modulation<double>>,
    .modulation_jacobian = jacobian_function<primary_1::modulation_jacobian<double>>,
  },
  {
    .name = "primary_2",
    .excited = true,
    .relations = case_1_relations,
    .observed_frequency = case_1_observed_frequency,
    .mode_at_rest = case_1_mode_at_rest,
    .lumps = case_1_lumps,
    .blocks = case_1_blocks,
    .evaluate_lumps = primary_2::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = primary_2::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<primary_2::modulation<double>>,
    .modulation_jacobian = jacobian_function<primary_2::modulation_jacobian<double>>,
  },
  {
    .name = "principal_parametric_1",
    .excited = true,
    .relations = case_2_relations,
    .observed_frequency = case_2_observed_frequency,
    .mode_at_rest = case_2_mode_at_rest,
    .lumps = case_2_lumps,
    .blocks = case_2_blocks,
    .evaluate_lumps = principal_parametric_1::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = principal_parametric_1::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<principal_parametric_1::modulation<double>>,
    .modulation_jacobian = jacobian_function<principal_parametric_1::modulation_jacobian<double>>,
  },
  {
    .name = "principal_parametric_2",
    .excited = true,
    .relations = case_3_relations,
    .observed_frequency = case_3_observed_frequency,
    .mode_at_rest = case_3_mode_at_rest,
    .lumps = case_3_lumps,
    .blocks = case_3_blocks,
    .evaluate_lumps = principal_parametric_2::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = principal_parametric_2::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<principal_parametric_2::modulation<double>>,
    .modulation_jacobian = jacobian_function<principal_parametric_2::modulation_jacobian<double>>,
  },
  {
    .name = "additive_combination",
    .excited = true,
    .relations = case_4_relations,
    .observed_frequency = case_4_observed_frequency,
    .mode_at_rest = case_4_mode_at_rest,
    .lumps = case_4_lumps,
    .blocks = case_4_blocks,
    .evaluate_lumps = additive_combination::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = additive_combination::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<additive_combination::modulation<double>>,
    .modulation_jacobian = jacobian_function<additive_combination::modulation_jacobian<double>>,
  },
  {
    .name = "free",
    .excited = false,
    .relations = {},
    .observed_frequency = case_5_observed_frequency,
    .mode_at_rest = case_5_mode_at_rest,
    .lumps = case_5_lumps,
    .blocks = case_5_blocks,
    .evaluate_lumps = free::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free::modulation<double>>,
    .modulation_jacobian = jacobian_function<free::modulation_jacobian<double>>,
  },
  {
    .name = "free_1",
    .excited = false,
    .relations = {},
    .observed_frequency = case_6_observed_frequency,
    .mode_at_rest = case_6_mode_at_rest,
    .lumps = case_6_lumps,
    .blocks = case_6_blocks,
    .evaluate_lumps = free_1::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = free_1::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<free_1::modulation<double>>,
    .modulation_jacobian = jacobian_function<free_1::modulation_jacobian<double>>,
  },
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
