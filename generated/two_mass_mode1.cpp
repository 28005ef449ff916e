// Model two_mass_mode1: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (5.1)-(5.5)
// Equation of motion: 0 = omega0^2*v + delta3*v*D(v)^2 + 2*delta2*v*D2(v) - eta2*v*F*cos(Omega*t) + alpha2*v^2
// + delta3*v^2*D2(v) + alpha3*v^3 + 2*mu1*D(v) + mu2*D(v)*abs(D(v)) + delta2*D(v)^2 + mu3*D(v)^3 + D2(v) -
// eta1*F*cos(Omega*t)
// Case principal_parametric: Omega = 2*omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case primary: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass_mode1
#include "generated/two_mass_mode1.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass_mode1 {

namespace {

constexpr std::string_view coordinates[] = {"v"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_4[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_7[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr Ratio dimension_8[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu1", dimension_1},
  {"mu2", dimension_2},
  {"mu3", dimension_3},
  {"alpha2", dimension_4},
  {"alpha3", dimension_5},
  {"delta2", dimension_6},
  {"delta3", dimension_7},
  {"eta1", dimension_8},
  {"eta2", dimension_9},
};
constexpr double nominal[] = {77.85, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr int case_0_relations[] = {-2, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {1, 2}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr Ratio case_0_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_0_lump_1[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_0_lump_2[] = {{-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_0_lump_3[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_4[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_5[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_6[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_0_lump_7[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_0_lump_8[] = {{0, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_0_lump_9[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_0_lumps[] = {
  {"mu1", "mu1", case_0_lump_0},
  {"mu2", "mu2", case_0_lump_1},
  {"mu3", "mu3", case_0_lump_2},
  {"alpha_e", "(6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3 - 10*alpha2^2)/(24*omega0^2)", case_0_lump_3},
  {"eta_e", "(-6*omega0^2*delta2*eta1 + 3*omega0^2*eta2 + 2*alpha2*eta1)/(12*omega0^2)", case_0_lump_4},
  {"alpha_0", "-omega0^2*delta2 + alpha2", case_0_lump_5},
  {"eta1", "eta1", case_0_lump_6},
  {"alpha_q", "-3*omega0^2*delta2 + alpha2", case_0_lump_7},
  {"harmonic_re_v_A_v_F", "(14*omega0^2*delta2*eta1 - 3*omega0^2*eta2 - 2*alpha2*eta1)/(48*omega0^4)", case_0_lump_8},
  {"harmonic_re_v_A_v3", "(42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 + 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)", case_0_lump_9},
};
constexpr int case_0_block_0_lumps[] = {0, 1, 2, 3, 4};
constexpr int case_0_block_1_lumps[] = {5};
constexpr int case_0_block_1_phase[] = {0, 0};
constexpr int case_0_block_2_lumps[] = {6, 7};
constexpr int case_0_block_2_phase[] = {0, 1};
constexpr int case_0_block_3_lumps[] = {1, 2, 8, 9};
constexpr int case_0_block_3_phase[] = {1, 1};
constexpr int case_0_block_4_lumps[] = {1};
constexpr int case_0_block_4_phase[] = {5, 0};
constexpr int case_0_block_5_lumps[] = {1};
constexpr int case_0_block_5_phase[] = {7, 0};
constexpr int case_0_block_6_lumps[] = {1};
constexpr int case_0_block_6_phase[] = {9, 0};
constexpr RegressorBlock case_0_blocks[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, {}, case_0_block_0_lumps, column_function<principal_parametric::columns_0, 1, 1, 5>, column_slope_function<principal_parametric::column_slopes_0, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, case_0_block_1_phase, case_0_block_1_lumps, column_function<principal_parametric::columns_1, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_1, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic Omega of v", 0, 1, case_0_block_2_phase, case_0_block_2_lumps, column_function<principal_parametric::columns_2, 1, 1, 2>, column_slope_function<principal_parametric::column_slopes_2, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic omega0+Omega of v", 0, 2, case_0_block_3_phase, case_0_block_3_lumps, column_function<principal_parametric::columns_3, 1, 1, 4>, column_slope_function<principal_parametric::column_slopes_3, 1, 1, 4>},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, case_0_block_4_phase, case_0_block_4_lumps, column_function<principal_parametric::columns_4, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_4, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, case_0_block_5_phase, case_0_block_5_lumps, column_function<principal_parametric::columns_5, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_5, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, case_0_block_6_phase, case_0_block_6_lumps, column_function<principal_parametric::columns_6, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_6, 1, 1, 1>},
};

constexpr Ratio case_1_observed_frequency[] = {{1, 1}, {0, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr Ratio case_1_lump_0[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_1_lump_1[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_1_lump_2[] = {{-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_1_lump_3[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_4[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_5[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_1_lump_6[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_1_lumps[] = {
  {"mu1", "mu1", case_1_lump_0},
  {"mu2", "mu2", case_1_lump_1},
  {"mu3", "mu3", case_1_lump_2},
  {"alpha_e", "(6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3 - 10*alpha2^2)/(24*omega0^2)", case_1_lump_3},
  {"alpha_0", "-omega0^2*delta2 + alpha2", case_1_lump_4},
  {"alpha_q", "-3*omega0^2*delta2 + alpha2", case_1_lump_5},
  {"harmonic_re_v_A_v3", "(42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 + 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)", case_1_lump_6},
};
constexpr int case_1_block_0_lumps[] = {0, 1, 2, 3};
constexpr int case_1_block_1_lumps[] = {4};
constexpr int case_1_block_1_phase[] = {0, 0};
constexpr int case_1_block_2_lumps[] = {5};
constexpr int case_1_block_2_phase[] = {2, 0};
constexpr int case_1_block_3_lumps[] = {1, 2, 6};
constexpr int case_1_block_3_phase[] = {3, 0};
constexpr int case_1_block_4_lumps[] = {1};
constexpr int case_1_block_4_phase[] = {5, 0};
constexpr int case_1_block_5_lumps[] = {1};
constexpr int case_1_block_5_phase[] = {7, 0};
constexpr int case_1_block_6_lumps[] = {1};
constexpr int case_1_block_6_phase[] = {9, 0};
constexpr RegressorBlock case_1_blocks[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, {}, case_1_block_0_lumps, column_function<free::columns_0, 1, 1, 4>, column_slope_function<free::column_slopes_0, 1, 1, 4>},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, case_1_block_1_phase, case_1_block_1_lumps, column_function<principal_parametric::columns_1, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_1, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 2*omega0 of v", 0, 1, case_1_block_2_phase, case_1_block_2_lumps, column_function<free::columns_2, 1, 1, 1>, column_slope_function<free::column_slopes_2, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 3*omega0 of v", 0, 2, case_1_block_3_phase, case_1_block_3_lumps, column_function<free::columns_3, 1, 1, 3>, column_slope_function<free::column_slopes_3, 1, 1, 3>},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, case_1_block_4_phase, case_1_block_4_lumps, column_function<principal_parametric::columns_4, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_4, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, case_1_block_5_phase, case_1_block_5_lumps, column_function<principal_parametric::columns_5, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_5, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, case_1_block_6_phase, case_1_block_6_lumps, column_function<principal_parametric::columns_6, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_6, 1, 1, 1>},
};

constexpr int case_2_relations[] = {-1, 1};
constexpr Ratio case_2_observed_frequency[] = {{0, 1}, {1, 1}};
constexpr bool case_2_mode_at_rest[] = {false};
constexpr Ratio case_2_lump_0[] = {{-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio case_2_lump_1[] = {{0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio case_2_lump_2[] = {{0, 1}, {-2, 1}, {-1, 1}};
constexpr Ratio case_2_lump_3[] = {{-1, 1}, {0, 1}, {0, 1}};
constexpr Ratio case_2_lump_4[] = {{-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio case_2_lump_5[] = {{-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_6[] = {{1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_7[] = {{0, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio case_2_lump_8[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_9[] = {{-1, 1}, {0, 1}, {-2, 1}};
constexpr Ratio case_2_lump_10[] = {{-1, 1}, {-1, 1}, {0, 1}};
constexpr Ratio case_2_lump_11[] = {{-2, 1}, {0, 1}, {0, 1}};
constexpr CompiledLump case_2_lumps[] = {
  {"conservative_v_A_v2_F", "(-3*omega0^2*delta2*eta2 + 5*alpha2*eta2)/(12*omega0^3)", case_2_lump_0},
  {"mu1", "mu1", case_2_lump_1},
  {"conservative_v_A_v_F2", "-eta2^2/(12*omega0^3)", case_2_lump_2},
  {"mu2", "mu2", case_2_lump_3},
  {"mu3", "mu3", case_2_lump_4},
  {"alpha_e", "(6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3 - 10*alpha2^2)/(24*omega0^2)", case_2_lump_5},
  {"eta1", "eta1", case_2_lump_6},
  {"eta2", "eta2", case_2_lump_7},
  {"alpha_0", "-omega0^2*delta2 + alpha2", case_2_lump_8},
  {"alpha_q", "-3*omega0^2*delta2 + alpha2", case_2_lump_9},
  {"harmonic_re_v_A_v2_F", "(17*omega0^2*delta2*eta2 - 3*alpha2*eta2)/(48*omega0^4)", case_2_lump_10},
  {"harmonic_re_v_A_v3", "(42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 + 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)", case_2_lump_11},
};
constexpr int case_2_block_0_lumps[] = {0, 1, 2, 3, 4, 5, 6};
constexpr int case_2_block_1_lumps[] = {7, 8};
constexpr int case_2_block_1_phase[] = {0, 0};
constexpr int case_2_block_2_lumps[] = {7, 9};
constexpr int case_2_block_2_phase[] = {1, 1};
constexpr int case_2_block_3_lumps[] = {2, 3, 4, 10, 11};
constexpr int case_2_block_3_phase[] = {1, 2};
constexpr int case_2_block_4_lumps[] = {3};
constexpr int case_2_block_4_phase[] = {5, 0};
constexpr int case_2_block_5_lumps[] = {3};
constexpr int case_2_block_5_phase[] = {7, 0};
constexpr int case_2_block_6_lumps[] = {3};
constexpr int case_2_block_6_phase[] = {9, 0};
constexpr RegressorBlock case_2_blocks[] = {
  {BlockKind::modulation, "modulation of v", 0, 0, {}, case_2_block_0_lumps, column_function<primary::columns_0, 1, 1, 7>, column_slope_function<primary::column_slopes_0, 1, 1, 7>},
  {BlockKind::harmonic, "harmonic 0 of v", 0, 1, case_2_block_1_phase, case_2_block_1_lumps, column_function<primary::columns_1, 1, 1, 2>, column_slope_function<primary::column_slopes_1, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic omega0+Omega of v", 0, 1, case_2_block_2_phase, case_2_block_2_lumps, column_function<primary::columns_2, 1, 1, 2>, column_slope_function<primary::column_slopes_2, 1, 1, 2>},
  {BlockKind::harmonic, "harmonic omega0+2*Omega of v", 0, 2, case_2_block_3_phase, case_2_block_3_lumps, column_function<primary::columns_3, 1, 1, 5>, column_slope_function<primary::column_slopes_3, 1, 1, 5>},
  {BlockKind::harmonic, "harmonic 5*omega0 of v", 0, 2, case_2_block_4_phase, case_2_block_4_lumps, column_function<principal_parametric::columns_4, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_4, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 7*omega0 of v", 0, 2, case_2_block_5_phase, case_2_block_5_lumps, column_function<principal_parametric::columns_5, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_5, 1, 1, 1>},
  {BlockKind::harmonic, "harmonic 9*omega0 of v", 0, 2, case_2_block_6_phase, case_2_block_6_lumps, column_function<principal_parametric::columns_6, 1, 1, 1>, column_slope_function<principal_parametric::column_slopes_6, 1, 1, 1>},
};

constexpr CompiledCase cases[] = {
  {
    .name = "principal_parametric",
    .excited = true,
    .relations = case_0_relations,
    .observed_frequency = case_0_observed_frequency,
    .mode_at_rest = case_0_mode_at_rest,
    .lumps = case_0_lumps,
    .blocks = case_0_blocks,
    .evaluate_lumps = principal_parametric::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = principal_parametric::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<principal_parametric::modulation<double>>,
    .modulation_jacobian = jacobian_function<principal_parametric::modulation_jacobian<double>>,
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
  {
    .name = "primary",
    .excited = true,
    .relations = case_2_relations,
    .observed_frequency = case_2_observed_frequency,
    .mode_at_rest = case_2_mode_at_rest,
    .lumps = case_2_lumps,
    .blocks = case_2_blocks,
    .evaluate_lumps = primary::evaluate_lumps<double>,
    .evaluate_lumps_jacobian = primary::evaluate_lumps_jacobian<double>,
    .modulation = modulation_function<primary::modulation<double>>,
    .modulation_jacobian = jacobian_function<primary::modulation_jacobian<double>>,
  },
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass_mode1",
  .source = "S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (5.1)-(5.5)",
  .fingerprint = "a3346d9e677791b0",
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

}  // namespace secular::generated::two_mass_mode1
