#include "measure/formats/matrix_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace secular {
namespace {

/// More than any rack of converters has; a larger matrix is no list of channels, and would make one of absurd
/// length.
constexpr std::size_t most_lines = 1024;

}  // namespace

std::string MatrixLines::name(const std::string& matrix, std::size_t line) const {
  return columns ? fmt::format("{}(:,{})", matrix, line + 1) : fmt::format("{}({},:)", matrix, line + 1);
}

bool is_matrix_line(const std::string& name) {
  return name.find("(:,") != std::string::npos || name.ends_with(",:)");
}

std::optional<MatrixLines> matrix_lines(const std::vector<std::size_t>& shape) {
  if (shape.size() != 2 || shape[0] < 2 || shape[1] < 2) return std::nullopt;
  const bool columns = shape[1] <= shape[0];
  const MatrixLines lines{columns ? shape[1] : shape[0], columns ? shape[0] : shape[1], columns};
  if (lines.count > most_lines) return std::nullopt;
  return lines;
}

std::string array_fault(const std::vector<std::size_t>& shape) {
  const auto longer = std::count_if(shape.begin(), shape.end(), [](std::size_t n) { return n > 1; });
  if (longer < 2) return {};
  if (shape.size() > 2) return fmt::format("is an array of {} dimensions", shape.size());
  return fmt::format("is a matrix of more than {} rows and columns", most_lines);
}

std::string matrix_fault(const std::string& name, const std::vector<std::string>& variables) {
  std::vector<std::string> lines;
  for (const std::string& variable : variables)
    if (variable.starts_with(name + "(:,") || (variable.starts_with(name + "(") && variable.ends_with(",:)")))
      lines.push_back(variable);
  if (lines.empty()) return {};
  return fmt::format("is a matrix, whose {} are {} to {}", lines.front().ends_with(",:)") ? "rows" : "columns",
                     lines.front(), lines.back());
}

}  // namespace secular
