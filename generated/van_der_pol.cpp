// Model van_der_pol: generated code, never edited by hand.
// Holds tables. Made by: secular generate van_der_pol.
#include "van_der_pol.free.hpp"
#include "van_der_pol.free_third_order.hpp"
#include "van_der_pol.lump-gradients.hpp"
#include "van_der_pol.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::van_der_pol {

namespace {

constexpr std::string_view coordinates[] = {"x"};
constexpr Ratio dimension_0[] = {{0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {-1, 1}};
constexpr Ratio dimension_2[] = {{-4, 1}, {-1, 1}};
constexpr Ratio dimension_3[] = {{-6, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega0", dimension_0},
  {"mu", dimension_1},
};
constexpr double nominal[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu", "mu", dimension_1},
  {"conservative_x_A_x", "-mu^2/(8*omega0)", dimension_2},
  {"dissipative_x_A_x2_conjA_x", "(-2*omega0^2*mu - mu^3)/(4*omega0^2)", dimension_3},
  {"dissipative_x_A_x3_conjA_x2", "35*mu^3/(64*omega0^2)", dimension_3},
};

// Case free.
constexpr Ratio case_0_observed_frequency[] = {{1, 1}};
constexpr bool case_0_mode_at_rest[] = {false};
constexpr int case_0_lump_numbers[] = {0, 1};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 2},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 5*omega0 of x", 0, 2, 1},
};
constexpr int case_0_block_lumps[] = {0, 1, 0, 1, 1};
constexpr int case_0_phases[] = {3, 5};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, free::blocks, case_0_block_lumps,
    case_0_phases, 1);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, free::blocks, case_0_blocks,
    case_0_observed_frequency, case_0_mode_at_rest};

// Case free_third_order.
constexpr Ratio case_1_observed_frequency[] = {{1, 1}};
constexpr bool case_1_mode_at_rest[] = {false};
constexpr int case_1_lump_numbers[] = {0, 1, 2, 3};
constexpr auto case_1_lumps = chosen_lumps(lump_table, case_1_lump_numbers);
constexpr BlockTable case_1_block_table[] = {
  {BlockKind::modulation, "modulation of x", 0, 0, 4},
  {BlockKind::harmonic, "harmonic 3*omega0 of x", 0, 1, 3},
  {BlockKind::harmonic, "harmonic 5*omega0 of x", 0, 2, 2},
  {BlockKind::harmonic, "harmonic 7*omega0 of x", 0, 3, 1},
};
constexpr int case_1_block_lumps[] = {0, 1, 2, 3, 0, 1, 3, 1, 3, 3};
constexpr int case_1_phases[] = {3, 5, 7};
constexpr auto case_1_blocks = regressor_blocks(case_1_block_table, free_third_order::blocks, case_1_block_lumps,
    case_1_phases, 1);
constexpr GeneratedCase case_1 = {&lump_functions, case_1_lump_numbers, free_third_order::blocks, case_1_blocks,
    case_1_observed_frequency, case_1_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("free", true, {}, case_0_lumps, case_0),
  compiled_case("free_third_order", true, {}, case_1_lumps, case_1),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "van_der_pol",
  .source = "B. van der Pol, Philosophical Magazine 2, 978 (1926)",
  .fingerprint = "63ba806d60fd9151",
  .coordinates = coordinates,
  .excitations = {},
  .excitation_frequencies = {},
  .symbols = symbols,
  .nominal = nominal,
  .cases = cases,
  .mass_matrix = mass_matrix<double>,
  .acceleration = accelerations<double>,
  .acceleration_of_lanes = accelerations<Lanes>,
  .acceleration_by_state = acceleration_by_state<double>,
  .acceleration_by_parameters = acceleration_by_parameters<double>,
};

}  // namespace secular::generated::van_der_pol
