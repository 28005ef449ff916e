#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jobs/shared/parameter_file.hpp"
#include "report/figure.hpp"

namespace secular::python {

/// What a job found, as the texts of its files and the figures of its report.
struct JobOutcome {
  std::string json;
  std::function<std::string(const std::string& command)> report = {};  ///< none: the command has no report
  std::vector<report::NamedFigure> figures = {};
  std::function<std::vector<report::NamedFigure>()> draw =
      {};                                         ///< of figures that are made when they are asked for
  std::map<std::string, std::string> texts = {};  ///< of other files, by name
  std::vector<std::string> notices = {};
};

/// (name, text of JSON); a text of None is that of the file, or of the shipped numbers, of that name.
using ParameterArgument = std::pair<std::string, std::optional<std::string>>;
GivenParameters given_parameters(const ParameterArgument& argument);

}  // namespace secular::python
