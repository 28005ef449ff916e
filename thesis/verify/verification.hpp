#pragma once

#include <functional>
#include <string>
#include <vector>

#include "perturb/model.hpp"
#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// One row of the verdict table.
struct Verdict {
  std::string equation, part, kind;
  std::string verdict;   ///< found: confirmed, convention, misprint, agrees, disagrees or unresolved
  std::string recorded;  ///< expected
  std::string reason, remark;
  std::string printed;                   ///< as the source has it
  std::string corrected;                 ///< right form of a misprint
  std::string term_printed, term_right;  ///< what the right form changes
  std::string evidence;                  ///< of a misprint or a convention: what decides it
  std::string proof;   ///< what was found beside the derivation, or at random values; empty where nothing was
  bool proved = true;  ///< the proof, where there is one, decides for the corrected form
  bool as_recorded() const { return verdict == recorded && proved; }
};

struct VerificationSettings {
  bool proofs = true;  ///< integrate the full equations for every misprint that a motion can show
  std::function<void(std::size_t done, std::size_t total)> progress;
};

/// Compares every statement of a printed source with the engine's derivation, judges it, and decides the misprints
/// that a motion can show a second time, by the full equations of motion. `find_model` turns a model's name into a
/// model. Throws InputError, also where the source has nothing to verify.
std::vector<Verdict> verify_source(const PrintedSource& source,
                                   const std::function<Model(const std::string&)>& find_model,
                                   const VerificationSettings& settings = {});

}  // namespace secular::verify
