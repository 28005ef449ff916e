#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

struct GeneratedFile {
  std::string name;  ///< relative to the output folder
  std::string text;
};

/// The C++ of a model: NAME.hpp with its equations of motion and lumps, NAME.CASE.hpp with the rows of each case,
/// NAME.cpp with the table that the estimator reads (estimator/model/compiled_model.hpp), which includes the
/// others. Same model, same bytes. Throws InputError for what cannot be computed from data: excitation clocks
/// without an amplitude, cases without a steady frame.
std::vector<GeneratedFile> emit_cpp(const CanonicalModel& model);

struct GeneratedUnit {
  GeneratedFile file;
  bool often_called = false;  ///< worth a compiler's optimisation
};

/// The same functions as units that may be compiled at once: NAME_functions.cpp; NAME_lumps.cpp (where there are
/// lumps), which are much of a model's text and the least of its work; NAME.cpp with the tables, the only one to
/// include headers that take compilers long, and what calls the other two.
std::vector<GeneratedUnit> emit_cpp_units(const CanonicalModel& model);

/// Throws an InputError for equations of motion that no measured signal can drive: cos(Omega*t) without an
/// amplitude.
void refuse_unsupported_motion(const CanonicalModel& model);

/// Throws the InputError with which emit_cpp refuses a case: a term that goes to quadrature, no rotating frame in
/// which the case is steady, an excitation clock without an amplitude.
void refuse_unsupported(const CanonicalModel& model, const CanonicalCase& resonance);

/// Of the files that list all models, which no model may be called.
inline constexpr const char* registry_name = "registry";

/// registry.hpp and registry.cpp: all models by name.
std::vector<GeneratedFile> emit_registry(const std::vector<std::string>& model_names);

/// Writes files into a folder (made if needed), each whole or not at all; unchanged files are left alone.
void write_generated(const std::vector<GeneratedFile>& files, const std::string& folder);

}  // namespace secular
