#include "thesis/procedures/thesis_harmonics.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

// With V = 2 A the first-order responses (6.21), (6.22) have no further factor 1/2; the thesis prints one in every
// column of (6.43)-(6.48), which doubles every estimate of its Table 6.1.
double half(bool printed) {
  return printed ? 0.5 : 1.0;
}

// (5.38) from (5.12): V(Omega) = (alpha2 - 3 delta2 w0^2)/(6 w0^2) V^2 - eta1/(3 w0^2) F, in these two unknowns.
void columns_5_38(const EnsembleTones& t, bool printed, Complex* column) {
  const double w2 = t.mode_frequency[0] * t.mode_frequency[0];
  column[0] = t.mode[0] * t.mode[0] / (6 * w2);
  column[1] = (printed ? 1.0 : -1.0) * t.excitation / (3 * w2);
}

// Mode `own` with the other one: damping coupling and parametric excitation, at the other mode's frequency.
void coupling(const EnsembleTones& t, int own, bool printed, Complex* column) {
  const int other = 1 - own;
  const double w = t.mode_frequency[own], v = t.mode_frequency[other], excitation = t.excitation_frequency;
  column[0] = half(printed) * Complex(0, -v) * t.mode[other] / (w * w - v * v);
  column[1] =
      half(printed) * std::conj(t.mode[own]) * t.excitation / (2 * (2 * w * excitation - excitation * excitation));
}

// At w1 + w2: quadratic nonlinearity and external excitation.
void sum_tone(const EnsembleTones& t, int own, bool printed, Complex* column) {
  const int other = 1 - own;
  const double w = t.mode_frequency[own], v = t.mode_frequency[other], excitation = t.excitation_frequency;
  column[0] = half(printed) * t.mode[0] * t.mode[1] / (v * v + 2 * w * v);
  column[1] = half(printed) * t.excitation / (w * w - excitation * excitation);
}

// At Omega + w: parametric excitation alone.
void upper_tone(const EnsembleTones& t, int own, bool printed, Complex* column) {
  const double w = t.mode_frequency[own], excitation = t.excitation_frequency;
  column[0] = -half(printed) * t.mode[own] * t.excitation / (2 * (excitation * excitation + 2 * w * excitation));
}

constexpr std::string_view unknowns_5_38[] = {"alpha2 - 3 delta2 w0^2", "eta1"};
constexpr std::string_view unknowns_6_43[] = {"mu12", "eta12"};
constexpr std::string_view unknowns_6_44[] = {"alpha22 - w1 w2 delta22 - w1^2 delta22", "eta11"};
constexpr std::string_view unknowns_6_45[] = {"eta12"};
constexpr std::string_view unknowns_6_46[] = {"mu21", "eta22"};
constexpr std::string_view unknowns_6_47[] = {"alpha23 - w1 w2 delta23 - w2^2 delta23", "eta21"};
constexpr std::string_view unknowns_6_48[] = {"eta22"};

constexpr std::string_view sign_misprint =
    "both columns have a plus sign; by (5.12) the excitation's is negative, so that eta1 changes sign";
constexpr std::string_view factor_misprint =
    "a factor 1/2 too much in every column against (6.36), (6.37), so that every estimate comes out doubled";

constexpr ThesisHarmonic harmonics[] = {
    {"5.38", unknowns_5_38, 1, 0, {2, 0}, sign_misprint, columns_5_38},
    {"6.43",
     unknowns_6_43,
     2,
     0,
     {0, 1},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { coupling(t, 0, printed, c); }},
    {"6.44",
     unknowns_6_44,
     2,
     0,
     {1, 1},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { sum_tone(t, 0, printed, c); }},
    {"6.45",
     unknowns_6_45,
     2,
     0,
     {2, 1},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { upper_tone(t, 0, printed, c); }},
    {"6.46",
     unknowns_6_46,
     2,
     1,
     {1, 0},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { coupling(t, 1, printed, c); }},
    {"6.47",
     unknowns_6_47,
     2,
     1,
     {1, 1},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { sum_tone(t, 1, printed, c); }},
    {"6.48",
     unknowns_6_48,
     2,
     1,
     {1, 2},
     factor_misprint,
     [](const EnsembleTones& t, bool printed, Complex* c) { upper_tone(t, 1, printed, c); }},
};

}  // namespace

std::span<const ThesisHarmonic> thesis_harmonics() {
  return harmonics;
}

}  // namespace secular
