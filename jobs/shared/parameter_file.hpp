#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace secular {

/// Covariance of symbols of a model, [name][name].
struct NamedCovariance {
  std::vector<std::string> names;
  Eigen::MatrixXd matrix;
};

/// What a file tells of the symbols of a model.
struct GivenParameters {
  std::map<std::string, double> values;
  std::map<std::string, double> sd;  ///< of an estimate
  NamedCovariance covariance;        ///< of an estimate: of the values that it estimated
  std::set<std::string> doubtful;    ///< of an estimate: whose error bars it doubts
  /// Of an estimate: of symbols that the data did not identify, values that go with all that they did.
  std::map<std::string, double> representative;
  NamedCovariance representative_covariance;  ///< of all values together with these
  /// Cases whose steady motions do not depend on which values those are.
  std::set<std::string> identified_cases;
  std::map<std::string, std::string> units;  ///< of an estimate
  std::string coordinate_unit;               ///< the same, of the modes' displacements; empty: not said
  /// Of an estimate: by case and lump.
  std::map<std::string, std::map<std::string, std::string>> lump_units;
};

/// An estimate.json of `identify` or a plain JSON object of symbol to number; `path` is a file, or the name of a
/// shipped one ("predictions/table_5_4"). Throws InputError naming the file, the place and what was expected.
GivenParameters read_parameter_file(const std::string& path);
/// The same of the text of such a file; `path`: what messages call it.
GivenParameters parameters_of(const std::string& text, const std::string& path);

}  // namespace secular
