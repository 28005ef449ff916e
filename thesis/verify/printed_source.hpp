#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "perturb/expression.hpp"

namespace secular::verify {

/// Where a table of the file stands, for messages.
struct PrintedPlace {
  std::string file;
  std::uint32_t line = 0;
  std::map<std::string, std::uint32_t> lines;  ///< by key

  /// Throws InputError at the line of `key`.
  [[noreturn]] void fail(const std::string& key, const std::string& wrong, const std::string& right) const;
};

/// What a source prints at one place, as data, with the verdict that is recorded for it. The file that holds it
/// (models/printed/) explains every kind.
struct PrintedStatement {
  PrintedPlace place;
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
  std::vector<std::string> solve_for;  ///< unknowns of the fixed points: two, three of saddle_node
  std::map<std::string, FormulaSource> where;
  bool only_secular = false, at_peak = false;
  std::string verdict;  ///< confirmed, convention or misprint
  std::string reason, remark;
};

/// The symbols a chapter writes for one model and resonance case.
struct PrintedChapter {
  PrintedPlace place;
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
  std::string claim;  ///< the formula `equals` the printed entry, or is `at least` or `at most` that
  FormulaSource formula;
  std::map<std::string, std::string> from;
  std::string verdict;  ///< agrees or disagrees
  std::string reason;
};

/// A printed matrix that follows from other printed matrices, by rows.
struct PrintedMatrix {
  std::string equation, part;
  std::vector<std::vector<std::string>> printed;
  FormulaSource formula;
  std::map<std::string, std::vector<std::vector<std::string>>> from;
  std::string verdict;  ///< agrees or disagrees
  std::string reason;
};

/// An equation between symbols that stand for any number or matrix: no model has a part in it.
struct PrintedIdentity {
  PrintedPlace place;
  std::string equation, part;
  FormulaSource printed;
  std::optional<FormulaSource> corrected;
  std::vector<std::pair<std::string, FormulaSource>> define;  ///< in this order
  std::map<std::string, std::pair<int, int>> sizes;           ///< rows and columns of what is a matrix
  std::vector<std::string> complex;                           ///< symbols that are complex
  std::string verdict;                                        ///< confirmed, convention or misprint
  std::string reason, remark;
};

/// Equations that have to follow from a Lagrangian.
struct PrintedSymmetry {
  PrintedPlace place;
  std::string equations, model;
  std::vector<std::string> without;  ///< damping and excitation
  std::string verdict;
};

struct PrintedSource {
  std::string file, name, source;
  std::vector<PrintedChapter> chapters;
  std::vector<PrintedStatement> statements;
  std::vector<PrintedIdentity> identities;
  std::vector<PrintedArithmetic> arithmetic;
  std::vector<PrintedMatrix> matrices;
  std::vector<PrintedSymmetry> symmetries;
};

/// Throws InputError with file and line. What hangs on the model is checked where it is used.
PrintedSource read_printed_source(const std::filesystem::path& path);
/// `name` stands for the file in messages.
PrintedSource read_printed_source_text(std::string_view text, std::string name);

}  // namespace secular::verify
