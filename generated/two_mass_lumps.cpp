// Model two_mass_lumps: generated code, never edited by hand.
// Holds tables. Made by: secular generate two_mass_lumps.
#include "two_mass_lumps.additive_combination.hpp"
#include "two_mass_lumps.lump-gradients.hpp"
#include "two_mass_lumps.hpp"

#include <limits>

#include "estimator/model/generated_table.hpp"

namespace secular::generated::two_mass_lumps {

namespace {

constexpr std::string_view coordinates[] = {"v1", "v2"};
constexpr std::string_view excitations[] = {"F"};
constexpr std::string_view excitation_frequencies[] = {"Omega"};
constexpr Ratio dimension_0[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 1}};
constexpr Ratio dimension_1[] = {{-2, 1}, {0, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_2[] = {{0, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_3[] = {{-2, 1}, {0, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_4[] = {{0, 1}, {0, 1}, {-2, 1}, {-2, 1}};
constexpr Ratio dimension_5[] = {{1, 1}, {-1, 1}, {-1, 1}, {-2, 1}};
constexpr Ratio dimension_6[] = {{1, 1}, {-1, 1}, {-1, 1}, {-1, 1}};
constexpr Ratio dimension_7[] = {{0, 1}, {-2, 1}, {0, 1}, {1, 1}};
constexpr Ratio dimension_8[] = {{0, 1}, {-2, 1}, {0, 1}, {-2, 1}};
constexpr Ratio dimension_9[] = {{-1, 1}, {1, 1}, {-1, 1}, {-1, 1}};
constexpr CompiledSymbol symbols[] = {
  {"omega1", dimension_0},
  {"omega2", dimension_0},
  {"mu11", dimension_0},
  {"mu13", dimension_1},
  {"lambda", dimension_2},
  {"alpha1", dimension_3},
  {"kappa", dimension_4},
  {"p", dimension_5},
  {"q1", dimension_6},
  {"mu22", dimension_0},
  {"mu23", dimension_7},
  {"alpha2", dimension_8},
  {"q2", dimension_9},
};
constexpr double nominal[] = {77.85, 209.35, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

constexpr CompiledLump lump_table[] = {
  {"mu11", "mu11", dimension_0},
  {"lambda", "lambda", dimension_2},
  {"kappa", "kappa", dimension_4},
  {"mu13", "mu13", dimension_1},
  {"alpha1", "alpha1", dimension_3},
  {"q1", "q1", dimension_6},
  {"p", "p", dimension_5},
  {"mu22", "mu22", dimension_0},
  {"mu23", "mu23", dimension_7},
  {"alpha2", "alpha2", dimension_8},
  {"q2", "q2", dimension_9},
};

// Case additive_combination.
constexpr int case_0_relations[] = {-1, -1, 1};
constexpr Ratio case_0_observed_frequency[] = {{0, 1}, {-1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 1}};
constexpr bool case_0_mode_at_rest[] = {false, false};
constexpr int case_0_lump_numbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
constexpr auto case_0_lumps = chosen_lumps(lump_table, case_0_lump_numbers);
constexpr BlockTable case_0_block_table[] = {
  {BlockKind::modulation, "modulation of v1", 0, 0, 7},
  {BlockKind::modulation, "modulation of v2", 1, 0, 5},
  {BlockKind::harmonic, "harmonic omega2+Omega of v1", 0, 1, 3},
  {BlockKind::harmonic, "harmonic omega1+2*Omega of v1", 0, 1, 1},
  {BlockKind::harmonic, "harmonic 3*omega1 of v1", 0, 1, 2},
  {BlockKind::harmonic, "harmonic 3*omega2 of v2", 1, 1, 2},
  {BlockKind::harmonic, "harmonic omega1+Omega of v2", 1, 1, 2},
};
constexpr int case_0_block_lumps[] = {0, 1, 2, 3, 4, 5, 6, 6, 7, 8, 9, 10, 2, 5, 6, 2, 3, 4, 8, 9, 6, 10};
constexpr int case_0_phases[] = {0, 1, 1, 1, 0, 2, 3, 0, 0, 0, 3, 0, 1, 0, 1};
constexpr auto case_0_blocks = regressor_blocks(case_0_block_table, additive_combination::blocks,
    case_0_block_lumps, case_0_phases, 3);
constexpr GeneratedCase case_0 = {&lump_functions, case_0_lump_numbers, additive_combination::blocks,
    case_0_blocks, case_0_observed_frequency, case_0_mode_at_rest};

constexpr CompiledCase cases[] = {
  compiled_case("additive_combination", true, case_0_relations, case_0_lumps, case_0),
};

}  // namespace

extern const CompiledModel model;
const CompiledModel model = {
  .name = "two_mass_lumps",
  .source = "S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)",
  .fingerprint = "4500730079e6e7c2",
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

}  // namespace secular::generated::two_mass_lumps
