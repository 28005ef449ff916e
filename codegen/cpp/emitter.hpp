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
  /// `in_units`: functions of one unit among several, not of a header.
  explicit Emitter(const CanonicalModel& canonical, bool in_units = false) : model(canonical), units(in_units) {}

  /// Local variables for parameters, values at rest (and pi) of these names.
  void unpack(const std::vector<std::string>& names, const std::string& attribute = "");
  /// Local variables for shared powers.
  void definitions(const CppWriter& writer) { definitions(writer.definitions()); }
  void definitions(const std::vector<std::string>& lines);
  /// "[0] omega0, [1] mu1".
  std::string parameter_list() const;

  const CanonicalModel& model;
  bool units = false;
  CodeText code;

 private:
  void rest_value(const CanonicalRestValue& value, const std::string& attribute);
};

/// mass_matrix, accelerations, acceleration_by_state, acceleration_by_parameters.
void emit_motion(Emitter& emitter);
/// Lumps with divisors, lump_N: each once, whatever cases have it.
void emit_shared_lumps(Emitter& emitter);
/// evaluate_lumps, evaluate_lumps_jacobian of one case, after the shared lumps.
void emit_lumps(Emitter& emitter, const CanonicalCase& resonance);
/// Where the functions of a block stand: those of the first case that has an equal one, which says the same of the
/// same lumps.
struct BlockPlace {
  std::string space;  ///< namespace of the case
  std::size_t block = 0;
};
BlockPlace block_place(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t block);
/// factors_N, columns_N, column_slopes_N of one block.
void emit_block(Emitter& emitter, const CanonicalCase& resonance, std::size_t block);
/// modulation, modulation_jacobian.
void emit_modulation(Emitter& emitter, const CanonicalCase& resonance);
/// The tables of estimator/model/compiled_model.hpp: those of cases and symbols, then the model's, which holds
/// them.
void emit_tables(Emitter& emitter);
void emit_model_table(Emitter& emitter);

}  // namespace secular
