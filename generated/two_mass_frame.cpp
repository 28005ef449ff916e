// Model two_mass_frame: generated code, never edited by hand.
// Holds tables. Made by: secular generate two_mass_frame.
#include "two_mass_frame.principal_parametric_1.hpp"
#include "two_mass_frame.additive_combination.hpp"
#include "two_mass_frame.free.hpp"
#include "two_mass_frame.lump-gradients.hpp"
#include "two_mass_frame.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass_frame {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"m1", {}},
  {"p11", {}},
  {"p12", {}},
  {"h1", {}},
  {"m2", {}},
  {"p21", {}},
  {"p22", {}},
  {"h2", {}},
  {"k1", {}},
  {"k2", {}},
  {"g", {}},
  {"lift", {}},
  {"mu1", dimension_0},
  {"tilt", {}},
  {"mu2", dimension_0},
};
constexpr double nominal[] = {77.85, 209.35, 0.5, 0.7336, 1.1428, 0.07, 0.5, 1.1603, -0.7199, 0.07, 7870, 7870,
    9.81, 1, std::numeric_limits<double>::quiet_NaN(), 0, std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu1", "mu1", dimension_0},
  {"conservative_v1_A_v1_A_v2_conjA_v2",
   "(-252*omega1^2*m1*p11^2*p12^2*h1*h2^3 - 252*omega1^2*p11^2*p12^2*h1^3*m2*h2 - "
   "504*omega1^2*p11^2*p12^2*h1^2*m2*h2^2 - 252*omega1^2*p11^2*p12^2*h1*m2*h2^3 + "
   "504*omega1^2*p11^2*p12*h1^3*m2*p22*h2 + 504*omega1^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "252*omega1^2*p11^2*h1^3*m2*p22^2*h2 + 504*omega1^2*p11*p12^2*h1^3*m2*p21*h2 + "
   "504*omega1^2*p11*p12^2*h1^2*m2*p21*h2^2 - 1008*omega1^2*p11*p12*h1^3*m2*p21*p22*h2 - "
   "504*omega1^2*p11*p12*h1^2*m2*p21*p22*h2^2 + 504*omega1^2*p11*h1^3*m2*p21*p22^2*h2 - "
   "252*omega1^2*p12^2*h1^3*m2*p21^2*h2 + 504*omega1^2*p12*h1^3*m2*p21^2*p22*h2 - "
   "252*omega1^2*h1^3*m2*p21^2*p22^2*h2 - 252*omega2^2*m1*p11^2*p12^2*h1*h2^3 - "
   "252*omega2^2*p11^2*p12^2*h1^3*m2*h2 - 504*omega2^2*p11^2*p12^2*h1^2*m2*h2^2 - "
   "252*omega2^2*p11^2*p12^2*h1*m2*h2^3 + 504*omega2^2*p11^2*p12*h1^3*m2*p22*h2 + "
   "504*omega2^2*p11^2*p12*h1^2*m2*p22*h2^2 - 252*omega2^2*p11^2*h1^3*m2*p22^2*h2 + "
   "504*omega2^2*p11*p12^2*h1^3*m2*p21*h2 + 504*omega2^2*p11*p12^2*h1^2*m2*p21*h2^2 - "
   "1008*omega2^2*p11*p12*h1^3*m2*p21*p22*h2 - 504*omega2^2*p11*p12*h1^2*m2*p21*p22*h2^2 + "
   "504*omega2^2*p11*h1^3*m2*p21*p22^2*h2 - 252*omega2^2*p12^2*h1^3*m2*p21^2*h2 + "
   "504*omega2^2*p12*h1^3*m2*p21^2*p22*h2 - 252*omega2^2*h1^3*m2*p21^2*p22^2*h2 - 540*m1*p11^2*p12^2*h2^3*g - "
   "540*p11^2*p12^2*h1^3*m2*g + 540*p11^2*p12^2*h1^3*h2*k2 + 540*p11^2*p12^2*h1*h2^3*k1 - "
   "540*p11^2*p12^2*m2*h2^3*g + 1080*p11^2*p12*h1^3*m2*p22*g - 1080*p11^2*p12*h1^3*p22*h2*k2 - "
   "540*p11^2*h1^3*m2*p22^2*g + 540*p11^2*h1^3*p22^2*h2*k2 + 1080*p11*p12^2*h1^3*m2*p21*g - "
   "1080*p11*p12^2*h1^3*p21*h2*k2 - 2160*p11*p12*h1^3*m2*p21*p22*g + 2160*p11*p12*h1^3*p21*p22*h2*k2 + "
   "1080*p11*h1^3*m2*p21*p22^2*g - 1080*p11*h1^3*p21*p22^2*h2*k2 - 540*p12^2*h1^3*m2*p21^2*g + "
   "540*p12^2*h1^3*p21^2*h2*k2 + 1080*p12*h1^3*m2*p21^2*p22*g - 1080*p12*h1^3*p21^2*p22*h2*k2 - "
   "540*h1^3*m2*p21^2*p22^2*g + 540*h1^3*p21^2*p22^2*h2*k2)/(175*omega1*h1^3*h2^3)", {}},
  {"conservative_v1_A_v12_conjA_v1",
   "(-252*omega1^2*m1*p11^4*h1*h2^3 - 252*omega1^2*p11^4*h1^3*m2*h2 - 504*omega1^2*p11^4*h1^2*m2*h2^2 - "
   "252*omega1^2*p11^4*h1*m2*h2^3 + 1008*omega1^2*p11^3*h1^3*m2*p21*h2 + 1008*omega1^2*p11^3*h1^2*m2*p21*h2^2 - "
   "1512*omega1^2*p11^2*h1^3*m2*p21^2*h2 - 504*omega1^2*p11^2*h1^2*m2*p21^2*h2^2 + "
   "1008*omega1^2*p11*h1^3*m2*p21^3*h2 - 252*omega1^2*h1^3*m2*p21^4*h2 - 270*m1*p11^4*h2^3*g - "
   "270*p11^4*h1^3*m2*g + 270*p11^4*h1^3*h2*k2 + 270*p11^4*h1*h2^3*k1 - 270*p11^4*m2*h2^3*g + "
   "1080*p11^3*h1^3*m2*p21*g - 1080*p11^3*h1^3*p21*h2*k2 - 1620*p11^2*h1^3*m2*p21^2*g + "
   "1620*p11^2*h1^3*p21^2*h2*k2 + 1080*p11*h1^3*m2*p21^3*g - 1080*p11*h1^3*p21^3*h2*k2 - 270*h1^3*m2*p21^4*g + "
   "270*h1^3*p21^4*h2*k2)/(175*omega1*h1^3*h2^3)", {}},
  {"conservative_v1_conjA_v1_F",
   "(-3*m1*p11^2*h2*lift - 3*p11^2*h1*m2*lift - 3*p11^2*m2*h2*lift + 6*p11*h1*m2*p21*lift - "
   "3*h1*m2*p21^2*lift)/(10*omega1*h1*h2)", {}},
  {"mu2", "mu2", dimension_0},
  {"conservative_v2_A_v22_conjA_v2",
   "(-252*omega2^2*m1*p12^4*h1*h2^3 - 252*omega2^2*p12^4*h1^3*m2*h2 - 504*omega2^2*p12^4*h1^2*m2*h2^2 - "
   "252*omega2^2*p12^4*h1*m2*h2^3 + 1008*omega2^2*p12^3*h1^3*m2*p22*h2 + 1008*omega2^2*p12^3*h1^2*m2*p22*h2^2 - "
   "1512*omega2^2*p12^2*h1^3*m2*p22^2*h2 - 504*omega2^2*p12^2*h1^2*m2*p22^2*h2^2 + "
   "1008*omega2^2*p12*h1^3*m2*p22^3*h2 - 252*omega2^2*h1^3*m2*p22^4*h2 - 270*m1*p12^4*h2^3*g - "
   "270*p12^4*h1^3*m2*g + 270*p12^4*h1^3*h2*k2 + 270*p12^4*h1*h2^3*k1 - 270*p12^4*m2*h2^3*g + "
   "1080*p12^3*h1^3*m2*p22*g - 1080*p12^3*h1^3*p22*h2*k2 - 1620*p12^2*h1^3*m2*p22^2*g + "
   "1620*p12^2*h1^3*p22^2*h2*k2 + 1080*p12*h1^3*m2*p22^3*g - 1080*p12*h1^3*p22^3*h2*k2 - 270*h1^3*m2*p22^4*g + "
   "270*h1^3*p22^4*h2*k2)/(175*omega2*h1^3*h2^3)", {}},
  {"harmonic_re_v1_F", "(-m1*p11*tilt - m2*p21*tilt)/(6*omega1^2)", {}},
  {"harmonic_re_v1_A_v2_conjA_v12",
   "(-756*omega1^2*m1*p11^3*p12*h1*h2^3 - 756*omega1^2*p11^3*p12*h1^3*m2*h2 - "
   "1512*omega1^2*p11^3*p12*h1^2*m2*h2^2 - 756*omega1^2*p11^3*p12*h1*m2*h2^3 + 756*omega1^2*p11^3*h1^3*m2*p22*h2 "
   "+ 756*omega1^2*p11^3*h1^2*m2*p22*h2^2 + 2268*omega1^2*p11^2*p12*h1^3*m2*p21*h2 + "
   "2268*omega1^2*p11^2*p12*h1^2*m2*p21*h2^2 - 2268*omega1^2*p11^2*h1^3*m2*p21*p22*h2 - "
   "756*omega1^2*p11^2*h1^2*m2*p21*p22*h2^2 - 2268*omega1^2*p11*p12*h1^3*m2*p21^2*h2 - "
   "756*omega1^2*p11*p12*h1^2*m2*p21^2*h2^2 + 2268*omega1^2*p11*h1^3*m2*p21^2*p22*h2 + "
   "756*omega1^2*p12*h1^3*m2*p21^3*h2 - 756*omega1^2*h1^3*m2*p21^3*p22*h2 + "
   "504*omega1*omega2*m1*p11^3*p12*h1*h2^3 + 504*omega1*omega2*p11^3*p12*h1^3*m2*h2 + "
   "1008*omega1*omega2*p11^3*p12*h1^2*m2*h2^2 + 504*omega1*omega2*p11^3*p12*h1*m2*h2^3 - "
   "504*omega1*omega2*p11^3*h1^3*m2*p22*h2 - 504*omega1*omega2*p11^3*h1^2*m2*p22*h2^2 - "
   "1512*omega1*omega2*p11^2*p12*h1^3*m2*p21*h2 - 1512*omega1*omega2*p11^2*p12*h1^2*m2*p21*h2^2 + "
   "1512*omega1*omega2*p11^2*h1^3*m2*p21*p22*h2 + 504*omega1*omega2*p11^2*h1^2*m2*p21*p22*h2^2 + "
   "1512*omega1*omega2*p11*p12*h1^3*m2*p21^2*h2 + 504*omega1*omega2*p11*p12*h1^2*m2*p21^2*h2^2 - "
   "1512*omega1*omega2*p11*h1^3*m2*p21^2*p22*h2 - 504*omega1*omega2*p12*h1^3*m2*p21^3*h2 + "
   "504*omega1*omega2*h1^3*m2*p21^3*p22*h2 - 252*omega2^2*m1*p11^3*p12*h1*h2^3 - "
   "252*omega2^2*p11^3*p12*h1^3*m2*h2 - 504*omega2^2*p11^3*p12*h1^2*m2*h2^2 - 252*omega2^2*p11^3*p12*h1*m2*h2^3 "
   "+ 252*omega2^2*p11^3*h1^3*m2*p22*h2 + 252*omega2^2*p11^3*h1^2*m2*p22*h2^2 + "
   "756*omega2^2*p11^2*p12*h1^3*m2*p21*h2 + 756*omega2^2*p11^2*p12*h1^2*m2*p21*h2^2 - "
   "756*omega2^2*p11^2*h1^3*m2*p21*p22*h2 - 252*omega2^2*p11^2*h1^2*m2*p21*p22*h2^2 - "
   "756*omega2^2*p11*p12*h1^3*m2*p21^2*h2 - 252*omega2^2*p11*p12*h1^2*m2*p21^2*h2^2 + "
   "756*omega2^2*p11*h1^3*m2*p21^2*p22*h2 + 252*omega2^2*p12*h1^3*m2*p21^3*h2 - "
   "252*omega2^2*h1^3*m2*p21^3*p22*h2 - 540*m1*p11^3*p12*h2^3*g - 540*p11^3*p12*h1^3*m2*g + "
   "540*p11^3*p12*h1^3*h2*k2 + 540*p11^3*p12*h1*h2^3*k1 - 540*p11^3*p12*m2*h2^3*g + 540*p11^3*h1^3*m2*p22*g - "
   "540*p11^3*h1^3*p22*h2*k2 + 1620*p11^2*p12*h1^3*m2*p21*g - 1620*p11^2*p12*h1^3*p21*h2*k2 - "
   "1620*p11^2*h1^3*m2*p21*p22*g + 1620*p11^2*h1^3*p21*p22*h2*k2 - 1620*p11*p12*h1^3*m2*p21^2*g + "
   "1620*p11*p12*h1^3*p21^2*h2*k2 + 1620*p11*h1^3*m2*p21^2*p22*g - 1620*p11*h1^3*p21^2*p22*h2*k2 + "
   "540*p12*h1^3*m2*p21^3*g - 540*p12*h1^3*p21^3*h2*k2 - 540*h1^3*m2*p21^3*p22*g + "
   "540*h1^3*p21^3*p22*h2*k2)/(175*h1^3*h2^3*(omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v2_F",
   "(-3*m1*p11*p12*h2*lift - 3*p11*p12*h1*m2*lift - 3*p11*p12*m2*h2*lift + 3*p11*h1*m2*p22*lift + "
   "3*p12*h1*m2*p21*lift - 3*h1*m2*p21*p22*lift)/(5*h1*h2*(omega1 - omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v1",
   "(18*omega1*p11*p12*m2*p21*p22 - 18*omega2*p11*p12*m2*p21*p22)/(25*omega2*h1*h2) + "
   "(63*omega1^2*m1*p11^2*p12^2*h1*h2^3 + 63*omega1^2*p11^2*p12^2*h1^3*m2*h2 + "
   "126*omega1^2*p11^2*p12^2*h1^2*m2*h2^2 + 63*omega1^2*p11^2*p12^2*h1*m2*h2^3 - "
   "126*omega1^2*p11^2*p12*h1^3*m2*p22*h2 - 126*omega1^2*p11^2*p12*h1^2*m2*p22*h2^2 + "
   "63*omega1^2*p11^2*h1^3*m2*p22^2*h2 - 126*omega1^2*p11*p12^2*h1^3*m2*p21*h2 - "
   "126*omega1^2*p11*p12^2*h1^2*m2*p21*h2^2 + 252*omega1^2*p11*p12*h1^3*m2*p21*p22*h2 - "
   "126*omega1^2*p11*h1^3*m2*p21*p22^2*h2 + 63*omega1^2*p12^2*h1^3*m2*p21^2*h2 - "
   "126*omega1^2*p12*h1^3*m2*p21^2*p22*h2 + 63*omega1^2*h1^3*m2*p21^2*p22^2*h2 - "
   "126*omega1*omega2*m1*p11^2*p12^2*h1*h2^3 - 126*omega1*omega2*p11^2*p12^2*h1^3*m2*h2 - "
   "252*omega1*omega2*p11^2*p12^2*h1^2*m2*h2^2 - 126*omega1*omega2*p11^2*p12^2*h1*m2*h2^3 + "
   "252*omega1*omega2*p11^2*p12*h1^3*m2*p22*h2 + 252*omega1*omega2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "126*omega1*omega2*p11^2*h1^3*m2*p22^2*h2 + 252*omega1*omega2*p11*p12^2*h1^3*m2*p21*h2 + "
   "252*omega1*omega2*p11*p12^2*h1^2*m2*p21*h2^2 - 504*omega1*omega2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "252*omega1*omega2*p11*h1^3*m2*p21*p22^2*h2 - 126*omega1*omega2*p12^2*h1^3*m2*p21^2*h2 + "
   "252*omega1*omega2*p12*h1^3*m2*p21^2*p22*h2 - 126*omega1*omega2*h1^3*m2*p21^2*p22^2*h2 + "
   "189*omega2^2*m1*p11^2*p12^2*h1*h2^3 + 189*omega2^2*p11^2*p12^2*h1^3*m2*h2 + "
   "378*omega2^2*p11^2*p12^2*h1^2*m2*h2^2 + 189*omega2^2*p11^2*p12^2*h1*m2*h2^3 - "
   "378*omega2^2*p11^2*p12*h1^3*m2*p22*h2 - 378*omega2^2*p11^2*p12*h1^2*m2*p22*h2^2 + "
   "189*omega2^2*p11^2*h1^3*m2*p22^2*h2 + 126*omega2^2*p11^2*h1^2*m2*p22^2*h2^2 - "
   "378*omega2^2*p11*p12^2*h1^3*m2*p21*h2 - 378*omega2^2*p11*p12^2*h1^2*m2*p21*h2^2 + "
   "756*omega2^2*p11*p12*h1^3*m2*p21*p22*h2 - 378*omega2^2*p11*h1^3*m2*p21*p22^2*h2 + "
   "189*omega2^2*p12^2*h1^3*m2*p21^2*h2 + 126*omega2^2*p12^2*h1^2*m2*p21^2*h2^2 - "
   "378*omega2^2*p12*h1^3*m2*p21^2*p22*h2 + 189*omega2^2*h1^3*m2*p21^2*p22^2*h2 + 135*m1*p11^2*p12^2*h2^3*g + "
   "135*p11^2*p12^2*h1^3*m2*g - 135*p11^2*p12^2*h1^3*h2*k2 - 135*p11^2*p12^2*h1*h2^3*k1 + "
   "135*p11^2*p12^2*m2*h2^3*g - 270*p11^2*p12*h1^3*m2*p22*g + 270*p11^2*p12*h1^3*p22*h2*k2 + "
   "135*p11^2*h1^3*m2*p22^2*g - 135*p11^2*h1^3*p22^2*h2*k2 - 270*p11*p12^2*h1^3*m2*p21*g + "
   "270*p11*p12^2*h1^3*p21*h2*k2 + 540*p11*p12*h1^3*m2*p21*p22*g - 540*p11*p12*h1^3*p21*p22*h2*k2 - "
   "270*p11*h1^3*m2*p21*p22^2*g + 270*p11*h1^3*p21*p22^2*h2*k2 + 135*p12^2*h1^3*m2*p21^2*g - "
   "135*p12^2*h1^3*p21^2*h2*k2 - 270*p12*h1^3*m2*p21^2*p22*g + 270*p12*h1^3*p21^2*p22*h2*k2 + "
   "135*h1^3*m2*p21^2*p22^2*g - 135*h1^3*p21^2*p22^2*h2*k2)/(175*omega2*h1^3*h2^3*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v22_conjA_v2",
   "(504*omega2^2*m1*p11*p12^3*h1*h2^3 + 504*omega2^2*p11*p12^3*h1^3*m2*h2 + "
   "1008*omega2^2*p11*p12^3*h1^2*m2*h2^2 + 504*omega2^2*p11*p12^3*h1*m2*h2^3 - "
   "1512*omega2^2*p11*p12^2*h1^3*m2*p22*h2 - 1512*omega2^2*p11*p12^2*h1^2*m2*p22*h2^2 + "
   "1512*omega2^2*p11*p12*h1^3*m2*p22^2*h2 + 504*omega2^2*p11*p12*h1^2*m2*p22^2*h2^2 - "
   "504*omega2^2*p11*h1^3*m2*p22^3*h2 - 504*omega2^2*p12^3*h1^3*m2*p21*h2 - 504*omega2^2*p12^3*h1^2*m2*p21*h2^2 "
   "+ 1512*omega2^2*p12^2*h1^3*m2*p21*p22*h2 + 504*omega2^2*p12^2*h1^2*m2*p21*p22*h2^2 - "
   "1512*omega2^2*p12*h1^3*m2*p21*p22^2*h2 + 504*omega2^2*h1^3*m2*p21*p22^3*h2 + 540*m1*p11*p12^3*h2^3*g + "
   "540*p11*p12^3*h1^3*m2*g - 540*p11*p12^3*h1^3*h2*k2 - 540*p11*p12^3*h1*h2^3*k1 + 540*p11*p12^3*m2*h2^3*g - "
   "1620*p11*p12^2*h1^3*m2*p22*g + 1620*p11*p12^2*h1^3*p22*h2*k2 + 1620*p11*p12*h1^3*m2*p22^2*g - "
   "1620*p11*p12*h1^3*p22^2*h2*k2 - 540*p11*h1^3*m2*p22^3*g + 540*p11*h1^3*p22^3*h2*k2 - 540*p12^3*h1^3*m2*p21*g "
   "+ 540*p12^3*h1^3*p21*h2*k2 + 1620*p12^2*h1^3*m2*p21*p22*g - 1620*p12^2*h1^3*p21*p22*h2*k2 - "
   "1620*p12*h1^3*m2*p21*p22^2*g + 1620*p12*h1^3*p21*p22^2*h2*k2 + 540*h1^3*m2*p21*p22^3*g - "
   "540*h1^3*p21*p22^3*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v1_A_v2_conjA_v1",
   "(504*omega1^2*m1*p11^3*p12*h1*h2^3 + 504*omega1^2*p11^3*p12*h1^3*m2*h2 + "
   "1008*omega1^2*p11^3*p12*h1^2*m2*h2^2 + 504*omega1^2*p11^3*p12*h1*m2*h2^3 - 504*omega1^2*p11^3*h1^3*m2*p22*h2 "
   "- 504*omega1^2*p11^3*h1^2*m2*p22*h2^2 - 1512*omega1^2*p11^2*p12*h1^3*m2*p21*h2 - "
   "1512*omega1^2*p11^2*p12*h1^2*m2*p21*h2^2 + 1512*omega1^2*p11^2*h1^3*m2*p21*p22*h2 + "
   "504*omega1^2*p11^2*h1^2*m2*p21*p22*h2^2 + 1512*omega1^2*p11*p12*h1^3*m2*p21^2*h2 + "
   "504*omega1^2*p11*p12*h1^2*m2*p21^2*h2^2 - 1512*omega1^2*p11*h1^3*m2*p21^2*p22*h2 - "
   "504*omega1^2*p12*h1^3*m2*p21^3*h2 + 504*omega1^2*h1^3*m2*p21^3*p22*h2 + 504*omega2^2*m1*p11^3*p12*h1*h2^3 + "
   "504*omega2^2*p11^3*p12*h1^3*m2*h2 + 1008*omega2^2*p11^3*p12*h1^2*m2*h2^2 + 504*omega2^2*p11^3*p12*h1*m2*h2^3 "
   "- 504*omega2^2*p11^3*h1^3*m2*p22*h2 - 504*omega2^2*p11^3*h1^2*m2*p22*h2^2 - "
   "1512*omega2^2*p11^2*p12*h1^3*m2*p21*h2 - 1512*omega2^2*p11^2*p12*h1^2*m2*p21*h2^2 + "
   "1512*omega2^2*p11^2*h1^3*m2*p21*p22*h2 + 504*omega2^2*p11^2*h1^2*m2*p21*p22*h2^2 + "
   "1512*omega2^2*p11*p12*h1^3*m2*p21^2*h2 + 504*omega2^2*p11*p12*h1^2*m2*p21^2*h2^2 - "
   "1512*omega2^2*p11*h1^3*m2*p21^2*p22*h2 - 504*omega2^2*p12*h1^3*m2*p21^3*h2 + "
   "504*omega2^2*h1^3*m2*p21^3*p22*h2 + 1080*m1*p11^3*p12*h2^3*g + 1080*p11^3*p12*h1^3*m2*g - "
   "1080*p11^3*p12*h1^3*h2*k2 - 1080*p11^3*p12*h1*h2^3*k1 + 1080*p11^3*p12*m2*h2^3*g - 1080*p11^3*h1^3*m2*p22*g "
   "+ 1080*p11^3*h1^3*p22*h2*k2 - 3240*p11^2*p12*h1^3*m2*p21*g + 3240*p11^2*p12*h1^3*p21*h2*k2 + "
   "3240*p11^2*h1^3*m2*p21*p22*g - 3240*p11^2*h1^3*p21*p22*h2*k2 + 3240*p11*p12*h1^3*m2*p21^2*g - "
   "3240*p11*p12*h1^3*p21^2*h2*k2 - 3240*p11*h1^3*m2*p21^2*p22*g + 3240*p11*h1^3*p21^2*p22*h2*k2 - "
   "1080*p12*h1^3*m2*p21^3*g + 1080*p12*h1^3*p21^3*h2*k2 + 1080*h1^3*m2*p21^3*p22*g - "
   "1080*h1^3*p21^3*p22*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v1_A_v12_A_v2",
   "(-756*omega1^2*m1*p11^3*p12*h1*h2^3 - 756*omega1^2*p11^3*p12*h1^3*m2*h2 - "
   "1512*omega1^2*p11^3*p12*h1^2*m2*h2^2 - 756*omega1^2*p11^3*p12*h1*m2*h2^3 + 756*omega1^2*p11^3*h1^3*m2*p22*h2 "
   "+ 756*omega1^2*p11^3*h1^2*m2*p22*h2^2 + 2268*omega1^2*p11^2*p12*h1^3*m2*p21*h2 + "
   "2268*omega1^2*p11^2*p12*h1^2*m2*p21*h2^2 - 2268*omega1^2*p11^2*h1^3*m2*p21*p22*h2 - "
   "756*omega1^2*p11^2*h1^2*m2*p21*p22*h2^2 - 2268*omega1^2*p11*p12*h1^3*m2*p21^2*h2 - "
   "756*omega1^2*p11*p12*h1^2*m2*p21^2*h2^2 + 2268*omega1^2*p11*h1^3*m2*p21^2*p22*h2 + "
   "756*omega1^2*p12*h1^3*m2*p21^3*h2 - 756*omega1^2*h1^3*m2*p21^3*p22*h2 - "
   "504*omega1*omega2*m1*p11^3*p12*h1*h2^3 - 504*omega1*omega2*p11^3*p12*h1^3*m2*h2 - "
   "1008*omega1*omega2*p11^3*p12*h1^2*m2*h2^2 - 504*omega1*omega2*p11^3*p12*h1*m2*h2^3 + "
   "504*omega1*omega2*p11^3*h1^3*m2*p22*h2 + 504*omega1*omega2*p11^3*h1^2*m2*p22*h2^2 + "
   "1512*omega1*omega2*p11^2*p12*h1^3*m2*p21*h2 + 1512*omega1*omega2*p11^2*p12*h1^2*m2*p21*h2^2 - "
   "1512*omega1*omega2*p11^2*h1^3*m2*p21*p22*h2 - 504*omega1*omega2*p11^2*h1^2*m2*p21*p22*h2^2 - "
   "1512*omega1*omega2*p11*p12*h1^3*m2*p21^2*h2 - 504*omega1*omega2*p11*p12*h1^2*m2*p21^2*h2^2 + "
   "1512*omega1*omega2*p11*h1^3*m2*p21^2*p22*h2 + 504*omega1*omega2*p12*h1^3*m2*p21^3*h2 - "
   "504*omega1*omega2*h1^3*m2*p21^3*p22*h2 - 252*omega2^2*m1*p11^3*p12*h1*h2^3 - "
   "252*omega2^2*p11^3*p12*h1^3*m2*h2 - 504*omega2^2*p11^3*p12*h1^2*m2*h2^2 - 252*omega2^2*p11^3*p12*h1*m2*h2^3 "
   "+ 252*omega2^2*p11^3*h1^3*m2*p22*h2 + 252*omega2^2*p11^3*h1^2*m2*p22*h2^2 + "
   "756*omega2^2*p11^2*p12*h1^3*m2*p21*h2 + 756*omega2^2*p11^2*p12*h1^2*m2*p21*h2^2 - "
   "756*omega2^2*p11^2*h1^3*m2*p21*p22*h2 - 252*omega2^2*p11^2*h1^2*m2*p21*p22*h2^2 - "
   "756*omega2^2*p11*p12*h1^3*m2*p21^2*h2 - 252*omega2^2*p11*p12*h1^2*m2*p21^2*h2^2 + "
   "756*omega2^2*p11*h1^3*m2*p21^2*p22*h2 + 252*omega2^2*p12*h1^3*m2*p21^3*h2 - "
   "252*omega2^2*h1^3*m2*p21^3*p22*h2 - 540*m1*p11^3*p12*h2^3*g - 540*p11^3*p12*h1^3*m2*g + "
   "540*p11^3*p12*h1^3*h2*k2 + 540*p11^3*p12*h1*h2^3*k1 - 540*p11^3*p12*m2*h2^3*g + 540*p11^3*h1^3*m2*p22*g - "
   "540*p11^3*h1^3*p22*h2*k2 + 1620*p11^2*p12*h1^3*m2*p21*g - 1620*p11^2*p12*h1^3*p21*h2*k2 - "
   "1620*p11^2*h1^3*m2*p21*p22*g + 1620*p11^2*h1^3*p21*p22*h2*k2 - 1620*p11*p12*h1^3*m2*p21^2*g + "
   "1620*p11*p12*h1^3*p21^2*h2*k2 + 1620*p11*h1^3*m2*p21^2*p22*g - 1620*p11*h1^3*p21^2*p22*h2*k2 + "
   "540*p12*h1^3*m2*p21^3*g - 540*p12*h1^3*p21^3*h2*k2 - 540*h1^3*m2*p21^3*p22*g + "
   "540*h1^3*p21^3*p22*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(3*omega1 + omega2))", {}},
  {"harmonic_re_v1_A_v23",
   "(504*omega2^2*m1*p11*p12^3*h1*h2^3 + 504*omega2^2*p11*p12^3*h1^3*m2*h2 + "
   "1008*omega2^2*p11*p12^3*h1^2*m2*h2^2 + 504*omega2^2*p11*p12^3*h1*m2*h2^3 - "
   "1512*omega2^2*p11*p12^2*h1^3*m2*p22*h2 - 1512*omega2^2*p11*p12^2*h1^2*m2*p22*h2^2 + "
   "1512*omega2^2*p11*p12*h1^3*m2*p22^2*h2 + 504*omega2^2*p11*p12*h1^2*m2*p22^2*h2^2 - "
   "504*omega2^2*p11*h1^3*m2*p22^3*h2 - 504*omega2^2*p12^3*h1^3*m2*p21*h2 - 504*omega2^2*p12^3*h1^2*m2*p21*h2^2 "
   "+ 1512*omega2^2*p12^2*h1^3*m2*p21*p22*h2 + 504*omega2^2*p12^2*h1^2*m2*p21*p22*h2^2 - "
   "1512*omega2^2*p12*h1^3*m2*p21*p22^2*h2 + 504*omega2^2*h1^3*m2*p21*p22^3*h2 + 180*m1*p11*p12^3*h2^3*g + "
   "180*p11*p12^3*h1^3*m2*g - 180*p11*p12^3*h1^3*h2*k2 - 180*p11*p12^3*h1*h2^3*k1 + 180*p11*p12^3*m2*h2^3*g - "
   "540*p11*p12^2*h1^3*m2*p22*g + 540*p11*p12^2*h1^3*p22*h2*k2 + 540*p11*p12*h1^3*m2*p22^2*g - "
   "540*p11*p12*h1^3*p22^2*h2*k2 - 180*p11*h1^3*m2*p22^3*g + 180*p11*h1^3*p22^3*h2*k2 - 180*p12^3*h1^3*m2*p21*g "
   "+ 180*p12^3*h1^3*p21*h2*k2 + 540*p12^2*h1^3*m2*p21*p22*g - 540*p12^2*h1^3*p21*p22*h2*k2 - "
   "540*p12*h1^3*m2*p21*p22^2*g + 540*p12*h1^3*p21*p22^2*h2*k2 + 180*h1^3*m2*p21*p22^3*g - "
   "180*h1^3*p21*p22^3*h2*k2)/(175*h1^3*h2^3*(omega1 + 3*omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v1_A_v13",
   "(-126*omega1^2*m1*p11^4*h1*h2^3 - 126*omega1^2*p11^4*h1^3*m2*h2 - 252*omega1^2*p11^4*h1^2*m2*h2^2 - "
   "126*omega1^2*p11^4*h1*m2*h2^3 + 504*omega1^2*p11^3*h1^3*m2*p21*h2 + 504*omega1^2*p11^3*h1^2*m2*p21*h2^2 - "
   "756*omega1^2*p11^2*h1^3*m2*p21^2*h2 - 252*omega1^2*p11^2*h1^2*m2*p21^2*h2^2 + "
   "504*omega1^2*p11*h1^3*m2*p21^3*h2 - 126*omega1^2*h1^3*m2*p21^4*h2 - 45*m1*p11^4*h2^3*g - 45*p11^4*h1^3*m2*g "
   "+ 45*p11^4*h1^3*h2*k2 + 45*p11^4*h1*h2^3*k1 - 45*p11^4*m2*h2^3*g + 180*p11^3*h1^3*m2*p21*g - "
   "180*p11^3*h1^3*p21*h2*k2 - 270*p11^2*h1^3*m2*p21^2*g + 270*p11^2*h1^3*p21^2*h2*k2 + 180*p11*h1^3*m2*p21^3*g "
   "- 180*p11*h1^3*p21^3*h2*k2 - 45*h1^3*m2*p21^4*g + 45*h1^3*p21^4*h2*k2)/(350*omega1^2*h1^3*h2^3)", {}},
  {"harmonic_re_v1_A_v1_A_v22",
   "(-18*omega1*p11*p12*m2*p21*p22 - 18*omega2*p11*p12*m2*p21*p22)/(25*omega2*h1*h2) + "
   "(-63*omega1^2*m1*p11^2*p12^2*h1*h2^3 - 63*omega1^2*p11^2*p12^2*h1^3*m2*h2 - "
   "126*omega1^2*p11^2*p12^2*h1^2*m2*h2^2 - 63*omega1^2*p11^2*p12^2*h1*m2*h2^3 + "
   "126*omega1^2*p11^2*p12*h1^3*m2*p22*h2 + 126*omega1^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "63*omega1^2*p11^2*h1^3*m2*p22^2*h2 + 126*omega1^2*p11*p12^2*h1^3*m2*p21*h2 + "
   "126*omega1^2*p11*p12^2*h1^2*m2*p21*h2^2 - 252*omega1^2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "126*omega1^2*p11*h1^3*m2*p21*p22^2*h2 - 63*omega1^2*p12^2*h1^3*m2*p21^2*h2 + "
   "126*omega1^2*p12*h1^3*m2*p21^2*p22*h2 - 63*omega1^2*h1^3*m2*p21^2*p22^2*h2 - "
   "126*omega1*omega2*m1*p11^2*p12^2*h1*h2^3 - 126*omega1*omega2*p11^2*p12^2*h1^3*m2*h2 - "
   "252*omega1*omega2*p11^2*p12^2*h1^2*m2*h2^2 - 126*omega1*omega2*p11^2*p12^2*h1*m2*h2^3 + "
   "252*omega1*omega2*p11^2*p12*h1^3*m2*p22*h2 + 252*omega1*omega2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "126*omega1*omega2*p11^2*h1^3*m2*p22^2*h2 + 252*omega1*omega2*p11*p12^2*h1^3*m2*p21*h2 + "
   "252*omega1*omega2*p11*p12^2*h1^2*m2*p21*h2^2 - 504*omega1*omega2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "252*omega1*omega2*p11*h1^3*m2*p21*p22^2*h2 - 126*omega1*omega2*p12^2*h1^3*m2*p21^2*h2 + "
   "252*omega1*omega2*p12*h1^3*m2*p21^2*p22*h2 - 126*omega1*omega2*h1^3*m2*p21^2*p22^2*h2 - "
   "189*omega2^2*m1*p11^2*p12^2*h1*h2^3 - 189*omega2^2*p11^2*p12^2*h1^3*m2*h2 - "
   "378*omega2^2*p11^2*p12^2*h1^2*m2*h2^2 - 189*omega2^2*p11^2*p12^2*h1*m2*h2^3 + "
   "378*omega2^2*p11^2*p12*h1^3*m2*p22*h2 + 378*omega2^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "189*omega2^2*p11^2*h1^3*m2*p22^2*h2 - 126*omega2^2*p11^2*h1^2*m2*p22^2*h2^2 + "
   "378*omega2^2*p11*p12^2*h1^3*m2*p21*h2 + 378*omega2^2*p11*p12^2*h1^2*m2*p21*h2^2 - "
   "756*omega2^2*p11*p12*h1^3*m2*p21*p22*h2 + 378*omega2^2*p11*h1^3*m2*p21*p22^2*h2 - "
   "189*omega2^2*p12^2*h1^3*m2*p21^2*h2 - 126*omega2^2*p12^2*h1^2*m2*p21^2*h2^2 + "
   "378*omega2^2*p12*h1^3*m2*p21^2*p22*h2 - 189*omega2^2*h1^3*m2*p21^2*p22^2*h2 - 135*m1*p11^2*p12^2*h2^3*g - "
   "135*p11^2*p12^2*h1^3*m2*g + 135*p11^2*p12^2*h1^3*h2*k2 + 135*p11^2*p12^2*h1*h2^3*k1 - "
   "135*p11^2*p12^2*m2*h2^3*g + 270*p11^2*p12*h1^3*m2*p22*g - 270*p11^2*p12*h1^3*p22*h2*k2 - "
   "135*p11^2*h1^3*m2*p22^2*g + 135*p11^2*h1^3*p22^2*h2*k2 + 270*p11*p12^2*h1^3*m2*p21*g - "
   "270*p11*p12^2*h1^3*p21*h2*k2 - 540*p11*p12*h1^3*m2*p21*p22*g + 540*p11*p12*h1^3*p21*p22*h2*k2 + "
   "270*p11*h1^3*m2*p21*p22^2*g - 270*p11*h1^3*p21*p22^2*h2*k2 - 135*p12^2*h1^3*m2*p21^2*g + "
   "135*p12^2*h1^3*p21^2*h2*k2 + 270*p12*h1^3*m2*p21^2*p22*g - 270*p12*h1^3*p21^2*p22*h2*k2 - "
   "135*h1^3*m2*p21^2*p22^2*g + 135*h1^3*p21^2*p22^2*h2*k2)/(175*omega2*h1^3*h2^3*(omega1 + omega2))", {}},
  {"harmonic_re_v2_F", "(-m1*p12*tilt - m2*p22*tilt)/(2*(2*omega1 + omega2)*(2*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_conjA_v12",
   "(-18*omega1*p11*p12*m2*p21*p22 + 18*omega2*p11*p12*m2*p21*p22)/(25*omega1*h1*h2) + "
   "(-189*omega1^2*m1*p11^2*p12^2*h1*h2^3 - 189*omega1^2*p11^2*p12^2*h1^3*m2*h2 - "
   "378*omega1^2*p11^2*p12^2*h1^2*m2*h2^2 - 189*omega1^2*p11^2*p12^2*h1*m2*h2^3 + "
   "378*omega1^2*p11^2*p12*h1^3*m2*p22*h2 + 378*omega1^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "189*omega1^2*p11^2*h1^3*m2*p22^2*h2 - 126*omega1^2*p11^2*h1^2*m2*p22^2*h2^2 + "
   "378*omega1^2*p11*p12^2*h1^3*m2*p21*h2 + 378*omega1^2*p11*p12^2*h1^2*m2*p21*h2^2 - "
   "756*omega1^2*p11*p12*h1^3*m2*p21*p22*h2 + 378*omega1^2*p11*h1^3*m2*p21*p22^2*h2 - "
   "189*omega1^2*p12^2*h1^3*m2*p21^2*h2 - 126*omega1^2*p12^2*h1^2*m2*p21^2*h2^2 + "
   "378*omega1^2*p12*h1^3*m2*p21^2*p22*h2 - 189*omega1^2*h1^3*m2*p21^2*p22^2*h2 + "
   "126*omega1*omega2*m1*p11^2*p12^2*h1*h2^3 + 126*omega1*omega2*p11^2*p12^2*h1^3*m2*h2 + "
   "252*omega1*omega2*p11^2*p12^2*h1^2*m2*h2^2 + 126*omega1*omega2*p11^2*p12^2*h1*m2*h2^3 - "
   "252*omega1*omega2*p11^2*p12*h1^3*m2*p22*h2 - 252*omega1*omega2*p11^2*p12*h1^2*m2*p22*h2^2 + "
   "126*omega1*omega2*p11^2*h1^3*m2*p22^2*h2 - 252*omega1*omega2*p11*p12^2*h1^3*m2*p21*h2 - "
   "252*omega1*omega2*p11*p12^2*h1^2*m2*p21*h2^2 + 504*omega1*omega2*p11*p12*h1^3*m2*p21*p22*h2 - "
   "252*omega1*omega2*p11*h1^3*m2*p21*p22^2*h2 + 126*omega1*omega2*p12^2*h1^3*m2*p21^2*h2 - "
   "252*omega1*omega2*p12*h1^3*m2*p21^2*p22*h2 + 126*omega1*omega2*h1^3*m2*p21^2*p22^2*h2 - "
   "63*omega2^2*m1*p11^2*p12^2*h1*h2^3 - 63*omega2^2*p11^2*p12^2*h1^3*m2*h2 - "
   "126*omega2^2*p11^2*p12^2*h1^2*m2*h2^2 - 63*omega2^2*p11^2*p12^2*h1*m2*h2^3 + "
   "126*omega2^2*p11^2*p12*h1^3*m2*p22*h2 + 126*omega2^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "63*omega2^2*p11^2*h1^3*m2*p22^2*h2 + 126*omega2^2*p11*p12^2*h1^3*m2*p21*h2 + "
   "126*omega2^2*p11*p12^2*h1^2*m2*p21*h2^2 - 252*omega2^2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "126*omega2^2*p11*h1^3*m2*p21*p22^2*h2 - 63*omega2^2*p12^2*h1^3*m2*p21^2*h2 + "
   "126*omega2^2*p12*h1^3*m2*p21^2*p22*h2 - 63*omega2^2*h1^3*m2*p21^2*p22^2*h2 - 135*m1*p11^2*p12^2*h2^3*g - "
   "135*p11^2*p12^2*h1^3*m2*g + 135*p11^2*p12^2*h1^3*h2*k2 + 135*p11^2*p12^2*h1*h2^3*k1 - "
   "135*p11^2*p12^2*m2*h2^3*g + 270*p11^2*p12*h1^3*m2*p22*g - 270*p11^2*p12*h1^3*p22*h2*k2 - "
   "135*p11^2*h1^3*m2*p22^2*g + 135*p11^2*h1^3*p22^2*h2*k2 + 270*p11*p12^2*h1^3*m2*p21*g - "
   "270*p11*p12^2*h1^3*p21*h2*k2 - 540*p11*p12*h1^3*m2*p21*p22*g + 540*p11*p12*h1^3*p21*p22*h2*k2 + "
   "270*p11*h1^3*m2*p21*p22^2*g - 270*p11*h1^3*p21*p22^2*h2*k2 - 135*p12^2*h1^3*m2*p21^2*g + "
   "135*p12^2*h1^3*p21^2*h2*k2 + 270*p12*h1^3*m2*p21^2*p22*g - 270*p12*h1^3*p21^2*p22*h2*k2 - "
   "135*h1^3*m2*p21^2*p22^2*g + 135*h1^3*p21^2*p22^2*h2*k2)/(175*omega1*h1^3*h2^3*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v2_F",
   "(-3*m1*p12^2*h2*lift - 3*p12^2*h1*m2*lift - 3*p12^2*m2*h2*lift + 6*p12*h1*m2*p22*lift - "
   "3*h1*m2*p22^2*lift)/(20*omega1*h1*h2*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v2_conjA_v2",
   "(-504*omega1^2*m1*p11*p12^3*h1*h2^3 - 504*omega1^2*p11*p12^3*h1^3*m2*h2 - "
   "1008*omega1^2*p11*p12^3*h1^2*m2*h2^2 - 504*omega1^2*p11*p12^3*h1*m2*h2^3 + "
   "1512*omega1^2*p11*p12^2*h1^3*m2*p22*h2 + 1512*omega1^2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "1512*omega1^2*p11*p12*h1^3*m2*p22^2*h2 - 504*omega1^2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "504*omega1^2*p11*h1^3*m2*p22^3*h2 + 504*omega1^2*p12^3*h1^3*m2*p21*h2 + 504*omega1^2*p12^3*h1^2*m2*p21*h2^2 "
   "- 1512*omega1^2*p12^2*h1^3*m2*p21*p22*h2 - 504*omega1^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "1512*omega1^2*p12*h1^3*m2*p21*p22^2*h2 - 504*omega1^2*h1^3*m2*p21*p22^3*h2 - "
   "504*omega2^2*m1*p11*p12^3*h1*h2^3 - 504*omega2^2*p11*p12^3*h1^3*m2*h2 - 1008*omega2^2*p11*p12^3*h1^2*m2*h2^2 "
   "- 504*omega2^2*p11*p12^3*h1*m2*h2^3 + 1512*omega2^2*p11*p12^2*h1^3*m2*p22*h2 + "
   "1512*omega2^2*p11*p12^2*h1^2*m2*p22*h2^2 - 1512*omega2^2*p11*p12*h1^3*m2*p22^2*h2 - "
   "504*omega2^2*p11*p12*h1^2*m2*p22^2*h2^2 + 504*omega2^2*p11*h1^3*m2*p22^3*h2 + "
   "504*omega2^2*p12^3*h1^3*m2*p21*h2 + 504*omega2^2*p12^3*h1^2*m2*p21*h2^2 - "
   "1512*omega2^2*p12^2*h1^3*m2*p21*p22*h2 - 504*omega2^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "1512*omega2^2*p12*h1^3*m2*p21*p22^2*h2 - 504*omega2^2*h1^3*m2*p21*p22^3*h2 - 1080*m1*p11*p12^3*h2^3*g - "
   "1080*p11*p12^3*h1^3*m2*g + 1080*p11*p12^3*h1^3*h2*k2 + 1080*p11*p12^3*h1*h2^3*k1 - 1080*p11*p12^3*m2*h2^3*g "
   "+ 3240*p11*p12^2*h1^3*m2*p22*g - 3240*p11*p12^2*h1^3*p22*h2*k2 - 3240*p11*p12*h1^3*m2*p22^2*g + "
   "3240*p11*p12*h1^3*p22^2*h2*k2 + 1080*p11*h1^3*m2*p22^3*g - 1080*p11*h1^3*p22^3*h2*k2 + "
   "1080*p12^3*h1^3*m2*p21*g - 1080*p12^3*h1^3*p21*h2*k2 - 3240*p12^2*h1^3*m2*p21*p22*g + "
   "3240*p12^2*h1^3*p21*p22*h2*k2 + 3240*p12*h1^3*m2*p21*p22^2*g - 3240*p12*h1^3*p21*p22^2*h2*k2 - "
   "1080*h1^3*m2*p21*p22^3*g + 1080*h1^3*p21*p22^3*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v12_conjA_v1",
   "(-504*omega1^2*m1*p11^3*p12*h1*h2^3 - 504*omega1^2*p11^3*p12*h1^3*m2*h2 - "
   "1008*omega1^2*p11^3*p12*h1^2*m2*h2^2 - 504*omega1^2*p11^3*p12*h1*m2*h2^3 + 504*omega1^2*p11^3*h1^3*m2*p22*h2 "
   "+ 504*omega1^2*p11^3*h1^2*m2*p22*h2^2 + 1512*omega1^2*p11^2*p12*h1^3*m2*p21*h2 + "
   "1512*omega1^2*p11^2*p12*h1^2*m2*p21*h2^2 - 1512*omega1^2*p11^2*h1^3*m2*p21*p22*h2 - "
   "504*omega1^2*p11^2*h1^2*m2*p21*p22*h2^2 - 1512*omega1^2*p11*p12*h1^3*m2*p21^2*h2 - "
   "504*omega1^2*p11*p12*h1^2*m2*p21^2*h2^2 + 1512*omega1^2*p11*h1^3*m2*p21^2*p22*h2 + "
   "504*omega1^2*p12*h1^3*m2*p21^3*h2 - 504*omega1^2*h1^3*m2*p21^3*p22*h2 - 540*m1*p11^3*p12*h2^3*g - "
   "540*p11^3*p12*h1^3*m2*g + 540*p11^3*p12*h1^3*h2*k2 + 540*p11^3*p12*h1*h2^3*k1 - 540*p11^3*p12*m2*h2^3*g + "
   "540*p11^3*h1^3*m2*p22*g - 540*p11^3*h1^3*p22*h2*k2 + 1620*p11^2*p12*h1^3*m2*p21*g - "
   "1620*p11^2*p12*h1^3*p21*h2*k2 - 1620*p11^2*h1^3*m2*p21*p22*g + 1620*p11^2*h1^3*p21*p22*h2*k2 - "
   "1620*p11*p12*h1^3*m2*p21^2*g + 1620*p11*p12*h1^3*p21^2*h2*k2 + 1620*p11*h1^3*m2*p21^2*p22*g - "
   "1620*p11*h1^3*p21^2*p22*h2*k2 + 540*p12*h1^3*m2*p21^3*g - 540*p12*h1^3*p21^3*h2*k2 - 540*h1^3*m2*p21^3*p22*g "
   "+ 540*h1^3*p21^3*p22*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v22_conjA_v1",
   "(-252*omega1^2*m1*p11*p12^3*h1*h2^3 - 252*omega1^2*p11*p12^3*h1^3*m2*h2 - "
   "504*omega1^2*p11*p12^3*h1^2*m2*h2^2 - 252*omega1^2*p11*p12^3*h1*m2*h2^3 + "
   "756*omega1^2*p11*p12^2*h1^3*m2*p22*h2 + 756*omega1^2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "756*omega1^2*p11*p12*h1^3*m2*p22^2*h2 - 252*omega1^2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "252*omega1^2*p11*h1^3*m2*p22^3*h2 + 252*omega1^2*p12^3*h1^3*m2*p21*h2 + 252*omega1^2*p12^3*h1^2*m2*p21*h2^2 "
   "- 756*omega1^2*p12^2*h1^3*m2*p21*p22*h2 - 252*omega1^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "756*omega1^2*p12*h1^3*m2*p21*p22^2*h2 - 252*omega1^2*h1^3*m2*p21*p22^3*h2 + "
   "504*omega1*omega2*m1*p11*p12^3*h1*h2^3 + 504*omega1*omega2*p11*p12^3*h1^3*m2*h2 + "
   "1008*omega1*omega2*p11*p12^3*h1^2*m2*h2^2 + 504*omega1*omega2*p11*p12^3*h1*m2*h2^3 - "
   "1512*omega1*omega2*p11*p12^2*h1^3*m2*p22*h2 - 1512*omega1*omega2*p11*p12^2*h1^2*m2*p22*h2^2 + "
   "1512*omega1*omega2*p11*p12*h1^3*m2*p22^2*h2 + 504*omega1*omega2*p11*p12*h1^2*m2*p22^2*h2^2 - "
   "504*omega1*omega2*p11*h1^3*m2*p22^3*h2 - 504*omega1*omega2*p12^3*h1^3*m2*p21*h2 - "
   "504*omega1*omega2*p12^3*h1^2*m2*p21*h2^2 + 1512*omega1*omega2*p12^2*h1^3*m2*p21*p22*h2 + "
   "504*omega1*omega2*p12^2*h1^2*m2*p21*p22*h2^2 - 1512*omega1*omega2*p12*h1^3*m2*p21*p22^2*h2 + "
   "504*omega1*omega2*h1^3*m2*p21*p22^3*h2 - 756*omega2^2*m1*p11*p12^3*h1*h2^3 - "
   "756*omega2^2*p11*p12^3*h1^3*m2*h2 - 1512*omega2^2*p11*p12^3*h1^2*m2*h2^2 - 756*omega2^2*p11*p12^3*h1*m2*h2^3 "
   "+ 2268*omega2^2*p11*p12^2*h1^3*m2*p22*h2 + 2268*omega2^2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "2268*omega2^2*p11*p12*h1^3*m2*p22^2*h2 - 756*omega2^2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "756*omega2^2*p11*h1^3*m2*p22^3*h2 + 756*omega2^2*p12^3*h1^3*m2*p21*h2 + 756*omega2^2*p12^3*h1^2*m2*p21*h2^2 "
   "- 2268*omega2^2*p12^2*h1^3*m2*p21*p22*h2 - 756*omega2^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "2268*omega2^2*p12*h1^3*m2*p21*p22^2*h2 - 756*omega2^2*h1^3*m2*p21*p22^3*h2 - 540*m1*p11*p12^3*h2^3*g - "
   "540*p11*p12^3*h1^3*m2*g + 540*p11*p12^3*h1^3*h2*k2 + 540*p11*p12^3*h1*h2^3*k1 - 540*p11*p12^3*m2*h2^3*g + "
   "1620*p11*p12^2*h1^3*m2*p22*g - 1620*p11*p12^2*h1^3*p22*h2*k2 - 1620*p11*p12*h1^3*m2*p22^2*g + "
   "1620*p11*p12*h1^3*p22^2*h2*k2 + 540*p11*h1^3*m2*p22^3*g - 540*p11*h1^3*p22^3*h2*k2 + 540*p12^3*h1^3*m2*p21*g "
   "- 540*p12^3*h1^3*p21*h2*k2 - 1620*p12^2*h1^3*m2*p21*p22*g + 1620*p12^2*h1^3*p21*p22*h2*k2 + "
   "1620*p12*h1^3*m2*p21*p22^2*g - 1620*p12*h1^3*p21*p22^2*h2*k2 - 540*h1^3*m2*p21*p22^3*g + "
   "540*h1^3*p21*p22^3*h2*k2)/(175*h1^3*h2^3*(omega1 - omega2)*(omega1 - 3*omega2))", {}},
  {"harmonic_re_v2_A_v12_A_v2",
   "(-18*omega1*p11*p12*m2*p21*p22 - 18*omega2*p11*p12*m2*p21*p22)/(25*omega1*h1*h2) + "
   "(-189*omega1^2*m1*p11^2*p12^2*h1*h2^3 - 189*omega1^2*p11^2*p12^2*h1^3*m2*h2 - "
   "378*omega1^2*p11^2*p12^2*h1^2*m2*h2^2 - 189*omega1^2*p11^2*p12^2*h1*m2*h2^3 + "
   "378*omega1^2*p11^2*p12*h1^3*m2*p22*h2 + 378*omega1^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "189*omega1^2*p11^2*h1^3*m2*p22^2*h2 - 126*omega1^2*p11^2*h1^2*m2*p22^2*h2^2 + "
   "378*omega1^2*p11*p12^2*h1^3*m2*p21*h2 + 378*omega1^2*p11*p12^2*h1^2*m2*p21*h2^2 - "
   "756*omega1^2*p11*p12*h1^3*m2*p21*p22*h2 + 378*omega1^2*p11*h1^3*m2*p21*p22^2*h2 - "
   "189*omega1^2*p12^2*h1^3*m2*p21^2*h2 - 126*omega1^2*p12^2*h1^2*m2*p21^2*h2^2 + "
   "378*omega1^2*p12*h1^3*m2*p21^2*p22*h2 - 189*omega1^2*h1^3*m2*p21^2*p22^2*h2 - "
   "126*omega1*omega2*m1*p11^2*p12^2*h1*h2^3 - 126*omega1*omega2*p11^2*p12^2*h1^3*m2*h2 - "
   "252*omega1*omega2*p11^2*p12^2*h1^2*m2*h2^2 - 126*omega1*omega2*p11^2*p12^2*h1*m2*h2^3 + "
   "252*omega1*omega2*p11^2*p12*h1^3*m2*p22*h2 + 252*omega1*omega2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "126*omega1*omega2*p11^2*h1^3*m2*p22^2*h2 + 252*omega1*omega2*p11*p12^2*h1^3*m2*p21*h2 + "
   "252*omega1*omega2*p11*p12^2*h1^2*m2*p21*h2^2 - 504*omega1*omega2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "252*omega1*omega2*p11*h1^3*m2*p21*p22^2*h2 - 126*omega1*omega2*p12^2*h1^3*m2*p21^2*h2 + "
   "252*omega1*omega2*p12*h1^3*m2*p21^2*p22*h2 - 126*omega1*omega2*h1^3*m2*p21^2*p22^2*h2 - "
   "63*omega2^2*m1*p11^2*p12^2*h1*h2^3 - 63*omega2^2*p11^2*p12^2*h1^3*m2*h2 - "
   "126*omega2^2*p11^2*p12^2*h1^2*m2*h2^2 - 63*omega2^2*p11^2*p12^2*h1*m2*h2^3 + "
   "126*omega2^2*p11^2*p12*h1^3*m2*p22*h2 + 126*omega2^2*p11^2*p12*h1^2*m2*p22*h2^2 - "
   "63*omega2^2*p11^2*h1^3*m2*p22^2*h2 + 126*omega2^2*p11*p12^2*h1^3*m2*p21*h2 + "
   "126*omega2^2*p11*p12^2*h1^2*m2*p21*h2^2 - 252*omega2^2*p11*p12*h1^3*m2*p21*p22*h2 + "
   "126*omega2^2*p11*h1^3*m2*p21*p22^2*h2 - 63*omega2^2*p12^2*h1^3*m2*p21^2*h2 + "
   "126*omega2^2*p12*h1^3*m2*p21^2*p22*h2 - 63*omega2^2*h1^3*m2*p21^2*p22^2*h2 - 135*m1*p11^2*p12^2*h2^3*g - "
   "135*p11^2*p12^2*h1^3*m2*g + 135*p11^2*p12^2*h1^3*h2*k2 + 135*p11^2*p12^2*h1*h2^3*k1 - "
   "135*p11^2*p12^2*m2*h2^3*g + 270*p11^2*p12*h1^3*m2*p22*g - 270*p11^2*p12*h1^3*p22*h2*k2 - "
   "135*p11^2*h1^3*m2*p22^2*g + 135*p11^2*h1^3*p22^2*h2*k2 + 270*p11*p12^2*h1^3*m2*p21*g - "
   "270*p11*p12^2*h1^3*p21*h2*k2 - 540*p11*p12*h1^3*m2*p21*p22*g + 540*p11*p12*h1^3*p21*p22*h2*k2 + "
   "270*p11*h1^3*m2*p21*p22^2*g - 270*p11*h1^3*p21*p22^2*h2*k2 - 135*p12^2*h1^3*m2*p21^2*g + "
   "135*p12^2*h1^3*p21^2*h2*k2 + 270*p12*h1^3*m2*p21^2*p22*g - 270*p12*h1^3*p21^2*p22*h2*k2 - "
   "135*h1^3*m2*p21^2*p22^2*g + 135*h1^3*p21^2*p22^2*h2*k2)/(175*omega1*h1^3*h2^3*(omega1 + omega2))", {}},
  {"harmonic_re_v2_A_v23",
   "(-126*omega2^2*m1*p12^4*h1*h2^3 - 126*omega2^2*p12^4*h1^3*m2*h2 - 252*omega2^2*p12^4*h1^2*m2*h2^2 - "
   "126*omega2^2*p12^4*h1*m2*h2^3 + 504*omega2^2*p12^3*h1^3*m2*p22*h2 + 504*omega2^2*p12^3*h1^2*m2*p22*h2^2 - "
   "756*omega2^2*p12^2*h1^3*m2*p22^2*h2 - 252*omega2^2*p12^2*h1^2*m2*p22^2*h2^2 + "
   "504*omega2^2*p12*h1^3*m2*p22^3*h2 - 126*omega2^2*h1^3*m2*p22^4*h2 - 45*m1*p12^4*h2^3*g - 45*p12^4*h1^3*m2*g "
   "+ 45*p12^4*h1^3*h2*k2 + 45*p12^4*h1*h2^3*k1 - 45*p12^4*m2*h2^3*g + 180*p12^3*h1^3*m2*p22*g - "
   "180*p12^3*h1^3*p22*h2*k2 - 270*p12^2*h1^3*m2*p22^2*g + 270*p12^2*h1^3*p22^2*h2*k2 + 180*p12*h1^3*m2*p22^3*g "
   "- 180*p12*h1^3*p22^3*h2*k2 - 45*h1^3*m2*p22^4*g + 45*h1^3*p22^4*h2*k2)/(350*omega2^2*h1^3*h2^3)", {}},
  {"harmonic_re_v2_A_v13",
   "(-504*omega1^2*m1*p11^3*p12*h1*h2^3 - 504*omega1^2*p11^3*p12*h1^3*m2*h2 - "
   "1008*omega1^2*p11^3*p12*h1^2*m2*h2^2 - 504*omega1^2*p11^3*p12*h1*m2*h2^3 + 504*omega1^2*p11^3*h1^3*m2*p22*h2 "
   "+ 504*omega1^2*p11^3*h1^2*m2*p22*h2^2 + 1512*omega1^2*p11^2*p12*h1^3*m2*p21*h2 + "
   "1512*omega1^2*p11^2*p12*h1^2*m2*p21*h2^2 - 1512*omega1^2*p11^2*h1^3*m2*p21*p22*h2 - "
   "504*omega1^2*p11^2*h1^2*m2*p21*p22*h2^2 - 1512*omega1^2*p11*p12*h1^3*m2*p21^2*h2 - "
   "504*omega1^2*p11*p12*h1^2*m2*p21^2*h2^2 + 1512*omega1^2*p11*h1^3*m2*p21^2*p22*h2 + "
   "504*omega1^2*p12*h1^3*m2*p21^3*h2 - 504*omega1^2*h1^3*m2*p21^3*p22*h2 - 180*m1*p11^3*p12*h2^3*g - "
   "180*p11^3*p12*h1^3*m2*g + 180*p11^3*p12*h1^3*h2*k2 + 180*p11^3*p12*h1*h2^3*k1 - 180*p11^3*p12*m2*h2^3*g + "
   "180*p11^3*h1^3*m2*p22*g - 180*p11^3*h1^3*p22*h2*k2 + 540*p11^2*p12*h1^3*m2*p21*g - "
   "540*p11^2*p12*h1^3*p21*h2*k2 - 540*p11^2*h1^3*m2*p21*p22*g + 540*p11^2*h1^3*p21*p22*h2*k2 - "
   "540*p11*p12*h1^3*m2*p21^2*g + 540*p11*p12*h1^3*p21^2*h2*k2 + 540*p11*h1^3*m2*p21^2*p22*g - "
   "540*p11*h1^3*p21^2*p22*h2*k2 + 180*p12*h1^3*m2*p21^3*g - 180*p12*h1^3*p21^3*h2*k2 - 180*h1^3*m2*p21^3*p22*g "
   "+ 180*h1^3*p21^3*p22*h2*k2)/(175*h1^3*h2^3*(3*omega1 + omega2)*(3*omega1 - omega2))", {}},
  {"harmonic_re_v2_A_v1_A_v22",
   "(-252*omega1^2*m1*p11*p12^3*h1*h2^3 - 252*omega1^2*p11*p12^3*h1^3*m2*h2 - "
   "504*omega1^2*p11*p12^3*h1^2*m2*h2^2 - 252*omega1^2*p11*p12^3*h1*m2*h2^3 + "
   "756*omega1^2*p11*p12^2*h1^3*m2*p22*h2 + 756*omega1^2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "756*omega1^2*p11*p12*h1^3*m2*p22^2*h2 - 252*omega1^2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "252*omega1^2*p11*h1^3*m2*p22^3*h2 + 252*omega1^2*p12^3*h1^3*m2*p21*h2 + 252*omega1^2*p12^3*h1^2*m2*p21*h2^2 "
   "- 756*omega1^2*p12^2*h1^3*m2*p21*p22*h2 - 252*omega1^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "756*omega1^2*p12*h1^3*m2*p21*p22^2*h2 - 252*omega1^2*h1^3*m2*p21*p22^3*h2 - "
   "504*omega1*omega2*m1*p11*p12^3*h1*h2^3 - 504*omega1*omega2*p11*p12^3*h1^3*m2*h2 - "
   "1008*omega1*omega2*p11*p12^3*h1^2*m2*h2^2 - 504*omega1*omega2*p11*p12^3*h1*m2*h2^3 + "
   "1512*omega1*omega2*p11*p12^2*h1^3*m2*p22*h2 + 1512*omega1*omega2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "1512*omega1*omega2*p11*p12*h1^3*m2*p22^2*h2 - 504*omega1*omega2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "504*omega1*omega2*p11*h1^3*m2*p22^3*h2 + 504*omega1*omega2*p12^3*h1^3*m2*p21*h2 + "
   "504*omega1*omega2*p12^3*h1^2*m2*p21*h2^2 - 1512*omega1*omega2*p12^2*h1^3*m2*p21*p22*h2 - "
   "504*omega1*omega2*p12^2*h1^2*m2*p21*p22*h2^2 + 1512*omega1*omega2*p12*h1^3*m2*p21*p22^2*h2 - "
   "504*omega1*omega2*h1^3*m2*p21*p22^3*h2 - 756*omega2^2*m1*p11*p12^3*h1*h2^3 - "
   "756*omega2^2*p11*p12^3*h1^3*m2*h2 - 1512*omega2^2*p11*p12^3*h1^2*m2*h2^2 - 756*omega2^2*p11*p12^3*h1*m2*h2^3 "
   "+ 2268*omega2^2*p11*p12^2*h1^3*m2*p22*h2 + 2268*omega2^2*p11*p12^2*h1^2*m2*p22*h2^2 - "
   "2268*omega2^2*p11*p12*h1^3*m2*p22^2*h2 - 756*omega2^2*p11*p12*h1^2*m2*p22^2*h2^2 + "
   "756*omega2^2*p11*h1^3*m2*p22^3*h2 + 756*omega2^2*p12^3*h1^3*m2*p21*h2 + 756*omega2^2*p12^3*h1^2*m2*p21*h2^2 "
   "- 2268*omega2^2*p12^2*h1^3*m2*p21*p22*h2 - 756*omega2^2*p12^2*h1^2*m2*p21*p22*h2^2 + "
   "2268*omega2^2*p12*h1^3*m2*p21*p22^2*h2 - 756*omega2^2*h1^3*m2*p21*p22^3*h2 - 540*m1*p11*p12^3*h2^3*g - "
   "540*p11*p12^3*h1^3*m2*g + 540*p11*p12^3*h1^3*h2*k2 + 540*p11*p12^3*h1*h2^3*k1 - 540*p11*p12^3*m2*h2^3*g + "
   "1620*p11*p12^2*h1^3*m2*p22*g - 1620*p11*p12^2*h1^3*p22*h2*k2 - 1620*p11*p12*h1^3*m2*p22^2*g + "
   "1620*p11*p12*h1^3*p22^2*h2*k2 + 540*p11*h1^3*m2*p22^3*g - 540*p11*h1^3*p22^3*h2*k2 + 540*p12^3*h1^3*m2*p21*g "
   "- 540*p12^3*h1^3*p21*h2*k2 - 1620*p12^2*h1^3*m2*p21*p22*g + 1620*p12^2*h1^3*p21*p22*h2*k2 + "
   "1620*p12*h1^3*m2*p21*p22^2*g - 1620*p12*h1^3*p21*p22^2*h2*k2 - 540*h1^3*m2*p21*p22^3*g + "
   "540*h1^3*p21*p22^3*h2*k2)/(175*h1^3*h2^3*(omega1 + omega2)*(omega1 + 3*omega2))", {}},
  {"conservative_v1_conjA_v2_F",
   "(-3*m1*p11*p12*h2*lift - 3*p11*p12*h1*m2*lift - 3*p11*p12*m2*h2*lift + 3*p11*h1*m2*p22*lift + "
   "3*p12*h1*m2*p21*lift - 3*h1*m2*p21*p22*lift)/(10*omega1*h1*h2)", {}},
  {"harmonic_re_v1_F", "(-m1*p11*tilt - m2*p21*tilt)/(2*omega2*(2*omega1 + omega2))", {}},
  {"harmonic_re_v1_conjA_v1_F",
   "(3*m1*p11^2*h2*lift + 3*p11^2*h1*m2*lift + 3*p11^2*m2*h2*lift - 6*p11*h1*m2*p21*lift + "
   "3*h1*m2*p21^2*lift)/(5*h1*h2*(omega1 + omega2)*(omega1 - omega2))", {}},
  {"harmonic_re_v2_F", "(-m1*p12*tilt - m2*p22*tilt)/(2*omega1*(omega1 + 2*omega2))", {}},
  {"harmonic_re_v2_conjA_v2_F",
   "(-3*m1*p12^2*h2*lift - 3*p12^2*h1*m2*lift - 3*p12^2*m2*h2*lift + 6*p12*h1*m2*p22*lift - "
   "3*h1*m2*p22^2*lift)/(5*h1*h2*(omega1 + omega2)*(omega1 - omega2))", {}},
};

// Case principal_parametric_1.
constexpr int case_0_relations[] = {-2, 0, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {0, 1}, {1, 2}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    21, 22, 23, 24, 25};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 4},
  {BlockKind::modulation, "modulation of v2", 1, 0, 3},
  {BlockKind::harmonic, "harmonic Omega of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic omega2-Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic Omega of v2", 1, 1, 1},
  {BlockKind::harmonic, "harmonic omega2-Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, 3},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega2+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, 1},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 1, 4, 5, 6, 7, 8, 9, 10, 11, 8, 12, 13, 3, 14, 15, 16, 17, 18,
    8, 19, 20, 21, 18, 22, 23, 8, 24, 25};
constexpr int case_0_phases[] = {0, 0, 1, 0, 1, -1, -1, 2, 0, 0, 1, 0, 0, 1, 1, 0, 3, 0, 1, 0, 1, 1, 2, 0, 0, 0,
    1, 0, 1, -1, 1, 0, 0, -1, 2, 0, 0, 1, 1, 0, 3, 0, 1, 0, 1, 1, 2, 0};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, principal_parametric_1::blocks,
    case_0_block_lumps, case_0_phases, 3);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, principal_parametric_1::blocks,
    case_0_blocks, case_0_observed_frequency, case_0_mode_at_rest};

// Case additive_combination.
constexpr int case_1_relations[] = {-1, -1, 1};
constexpr Ratio case_1_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false, false};
constexpr int case_1_lump_numbers[] = {0, 1, 2, 26, 4, 5, 27, 7, 28, 10, 11, 9, 15, 13, 12, 14, 29, 17, 21, 30,
    19, 20, 25, 23, 22, 24};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
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
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 3, 12, 13, 8, 14, 15, 16, 17,
    18, 19, 20, 21, 19, 22, 23, 3, 24, 25};
constexpr int case_1_phases[] = {0, 0, 1, -2, 1, 0, 0, 1, 0, -1, 2, 0, 0, 1, 1, 0, 3, 0, 1, 0, 1, 3, 0, 0, 0, 0,
    1, -2, 1, 0, -1, 2, 0, 1, 0, 0, 0, 1, 1, 0, 3, 0, 1, 0, 1, 3, 0, 0};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, additive_combination::blocks,
    case_1_block_lumps, case_1_phases, 3);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, additive_combination::blocks,
    case_1_blocks, case_1_observed_frequency, case_1_mode_at_rest};

// Case free.
constexpr Ratio case_2_observed_frequency[] = {{1, 1}, {0, 1}, {0, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_2_mode_at_rest[] = {false, false};
constexpr int case_2_lump_numbers[] = {0, 1, 2, 4, 5, 7, 9, 10, 11, 13, 15, 12, 14, 17, 21, 23, 19, 20, 25, 22,
    24};
constexpr auto case_2_lumps = chosen_lumps(lump_table, case_2_lump_numbers);
constexpr BlockTable case_2_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 3},
  {BlockKind::modulation, "modulation of v2", 1, 0, 3},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega2 of v1", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 2, 1},
  {BlockKind::harmonic, "harmonic -2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic -omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic omega1 of v2", 1, 2, 2},
  {BlockKind::harmonic, "harmonic omega1+2*omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 2*omega1+omega2 of v2", 1, 2, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v2", 1, 2, 1},
};
constexpr int case_2_block_lumps[] = {0, 1, 2, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20};
constexpr int case_2_phases[] = {-2, 1, 0, -1, 2, 0, 0, 1, 0, 0, 3, 0, 1, 2, 0, 2, 1, 0, 3, 0, 0, -2, 1, 0, -1, 2,
    0, 0, 3, 0, 1, 0, 0, 1, 2, 0, 2, 1, 0, 3, 0, 0};
constexpr auto case_2_blocks = regressor_blocks(case_2_block_table, free::blocks, case_2_block_lumps,
    case_2_phases, 3);
constexpr GeneratedCase case_2 = {&lump_functions, case_2_lump_numbers, free::blocks, case_2_blocks,
    case_2_observed_frequency, case_2_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("principal_parametric_1", true, case_0_relations, case_0_lumps, case_0),
  compiled_case("additive_combination", true, case_1_relations, case_1_lumps, case_1),
  compiled_case("free", false, {}, case_2_lumps, case_2),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass_frame",
  .source = "Geometry: S. O'F. Fahey, dissertation, Virginia Tech, 2000, chapter 2; energies derived here",
  .fingerprint = "647a5f7b26bed208",
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

}  // namespace secular::generated::two_mass_frame
