#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perturb/expression.hpp"

namespace secular::verify {

/// What a source prints at one place, as data, with the verdict that is recorded for it. The file that holds it
/// (models/printed/) explains every kind.
struct PrintedStatement {
  int chapter = 0;
  std::string equation;  ///< "5.17"
  std::string part;      ///< which piece of it
  std::string kind;
  int mode = 0;  ///< from 0
  int order = 0;
  FormulaSource printed;
  std::optional<FormulaSource> corrected;
  std::optional<FormulaSource> equals;  ///< what left - right must be (zero without it)
  std::optional<FormulaSource> of;      ///< what a special case specialises
  std::string name, inside, mean_of;
  std::optional<FormulaSource> scale, term, times;
  std::vector<std::string> without;    ///< parameters that are zero here
  std::vector<std::string> solve_for;  ///< two unknowns of the fixed points
  std::map<std::string, FormulaSource> where;
  bool only_secular = false, at_peak = false;
  std::string verdict;  ///< confirmed, convention or misprint
  std::string reason, remark;
  std::uint32_t line = 0;
};

/// The symbols a chapter writes for one model and resonance case.
struct PrintedChapter {
  int number = 0;
  std::string model, resonance;
  std::vector<std::vector<std::string>> unknowns;  ///< [mode][order]
  std::vector<std::string> suffixes;               ///< per mode: A1, a1, beta1
  FormulaSource gamma;
  std::vector<std::pair<std::string, FormulaSource>> definitions;  ///< right ones, in alphabetical order
};

/// A table entry that follows from other entries: all numbers as printed.
struct PrintedArithmetic {
  std::string table, entry, printed;
  FormulaSource formula;
  std::map<std::string, std::string> from;
  std::string verdict;  ///< agrees or disagrees
  std::string reason;
};

/// Equations that have to follow from a Lagrangian.
struct PrintedSymmetry {
  std::string equations, model;
  std::vector<std::string> without;  ///< damping and excitation
  std::string verdict;
};

struct PrintedSource {
  std::string file, name, source;
  std::vector<PrintedChapter> chapters;
  std::vector<PrintedStatement> statements;
  std::vector<PrintedArithmetic> arithmetic;
  std::vector<PrintedSymmetry> symmetries;
};

/// Throws InputError with file and line.
PrintedSource read_printed_source(const std::filesystem::path& path);

}  // namespace secular::verify
