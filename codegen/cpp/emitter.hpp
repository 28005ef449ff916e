#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/cpp/code_text.hpp"
#include "codegen/expression/cpp_expression.hpp"

/// The parts that emit_cpp puts together, each appending functions to one text.
namespace secular {

class Emitter {
 public:
  explicit Emitter(const CanonicalModel& canonical) : model(canonical) {}

  /// Local variables for parameters, values at rest (and pi) of these names.
  void unpack(const std::vector<std::string>& names);
  /// Local variables for shared powers.
  void definitions(const std::vector<std::string>& lines);
  /// "[0] omega0, [1] mu1".
  std::string parameter_list() const;

  const CanonicalModel& model;
  CodeText code;
};

/// coefficients, mass_matrix, accelerations, acceleration_by_state, acceleration_by_parameters.
void emit_motion(Emitter& emitter);
/// Struct Lumps: each lump once, whatever cases have it.
void emit_lumps(Emitter& emitter);
/// Struct LumpGradients: their derivatives by the parameters.
void emit_lump_gradients(Emitter& emitter);
/// Struct Model: sizes, Frequencies, Signals, which all rows are functions of.
void emit_row_signals(Emitter& emitter);
/// Where a block stands: in the first case that has an equal one.
struct BlockPlace {
  std::size_t resonance = 0;  ///< index of the case
  std::string name;           ///< of the struct there
};
BlockPlace block_place(const CanonicalModel& model, std::size_t resonance, std::size_t block);
/// Blocks that stand in a case, a struct each.
void emit_blocks(Emitter& emitter, std::size_t resonance);
/// "modulation_functions<Model, modulation_of_v>()" of all blocks of a case, in their order.
std::vector<std::string> block_function_list(const CanonicalModel& model, std::size_t resonance);
/// The tables of estimator/model/compiled_model.hpp: those of cases and symbols, then the model's, which holds
/// them.
void emit_tables(Emitter& emitter);
void emit_model_table(Emitter& emitter);

}  // namespace secular
