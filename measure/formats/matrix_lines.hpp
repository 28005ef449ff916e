#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace secular {

/// A matrix of numbers as channels side by side: its columns, or its rows where there are fewer of them.
struct MatrixLines {
  std::size_t count = 0, length = 0;
  bool columns = true;

  /// As MATLAB writes it: "data(:,2)" or "data(2,:)"; counted from 0 here.
  std::string name(const std::string& matrix, std::size_t line) const;
};

/// Whether a variable of this name is a line of a matrix.
bool is_matrix_line(const std::string& name);

/// None for what is no matrix (a vector, an array of more dimensions), and for a matrix that is rather a picture.
std::optional<MatrixLines> matrix_lines(const std::vector<std::size_t>& shape);

/// Why an array is no channel by itself; empty for a vector or a single number.
std::string array_fault(const std::vector<std::size_t>& shape);

/// What is to be said of a name that stands for a matrix among variables of these names: that its lines are the
/// channels. Empty if it does not.
std::string matrix_fault(const std::string& name, const std::vector<std::string>& variables);

}  // namespace secular
