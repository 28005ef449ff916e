#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/verdict/naming.hpp"

namespace secular {

/// One effect at one place, with what all explanations that hold it are worth.
struct CauseReport {
  std::string effect, subject;
  double probability = 0;
  double coefficient = 0, sd = 0;
  std::string coefficient_name;
  std::string unit;  ///< "1" for none, empty where the equations do not fix it (SymbolUnits)
  /// A gap, an exponent, ...
  struct Shape {
    std::string name;
    double value = 0, sd = 0;
    std::string unit;  ///< as above
  };
  std::vector<Shape> shapes;
  std::optional<double> closed;
};

/// A force outside of the catalogue that explains the gap.
struct OpenLaw {
  std::string mode;
  std::string law;       ///< the name of its row in the catalogue
  std::string in_words;  ///< Effect::in_words
  double exponent = 0, sd = 0;
  double probability = 0;
};

/// What a report says of the rivals; all of them hold indices into `candidates`.
struct CauseReporter {
  const std::vector<Candidate>& candidates;
  const std::vector<std::string>& unknown_names;            ///< of the discrepancy
  std::function<std::string(std::size_t)> unit;             ///< of an unknown
  std::function<Eigen::MatrixXd(const Refit&)> covariance;  ///< of the free unknowns of a fit
  std::function<double(const Explanation&)> closed_share;   ///< of the gap, on held-out conditions

  /// Causes by falling probability; the first few single ones of `rivals` say what share of the gap they close.
  std::vector<CauseReport> causes(const std::vector<Rival>& rivals) const;

  /// `rival`: a single open law.
  OpenLaw open_law(const Rival& rival) const;
};

/// The first single effect of `rivals` that is not in `set`, as a control; null: there is none.
const Rival* best_wrong_cause(const std::vector<Rival>& rivals, const std::vector<std::string>& set);

}  // namespace secular
