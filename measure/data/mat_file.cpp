#include "measure/data/mat_file.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/mat_structure.hpp"
#include "measure/data/stored_numbers.hpp"

namespace secular {
namespace {

struct Closer {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Closer>;
using Variable = std::unique_ptr<matvar_t, Closer>;

constexpr int deepest_struct = 16;

void keep_quiet(int, char*) {}

// Version 4 has no signature, but the head of its first matrix: kind of numbers (in decimal digits: byte order,
// zero, precision 0 to 5, full, text or sparse), rows, columns, whether it is complex, and the length of the name
// that follows, which ends with zero.
bool is_mat_v4(std::string_view bytes) {
  constexpr std::size_t head = 20, longest_name = 64;
  if (bytes.size() < head) return false;
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    const auto number = [&](std::size_t place) { return unsigned_at(bytes, 4 * place, 4, order); };
    const std::uint64_t kind = number(0), length = number(4);
    const bool numbers = kind / 1000 == (order == ByteOrder::big ? 1 : 0) && kind / 100 % 10 == 0 &&
                         kind / 10 % 10 <= 5 && kind % 10 <= 2;
    if (numbers && number(3) <= 1 && length >= 2 && length <= longest_name && head + length <= bytes.size() &&
        bytes[head + length - 1] == '\0' && bytes[head] != '\0')
      return true;
  }
  return false;
}

File open(const std::filesystem::path& path) {
  const std::string name = path.string();
  Mat_LogInitFunc("secular", keep_quiet);  // complaints become InputErrors
  {
    std::ifstream probe(path, std::ios::binary);
    std::array<char, 128> header{};
    if (!probe) throw InputError(name, "", "cannot be opened for reading", "check the path and its permissions");
    probe.read(header.data(), header.size());
    const std::string text(header.data(), static_cast<std::size_t>(probe.gcount()));
    if (text.rfind("MATLAB 7.3", 0) == 0)
      throw InputError(name, "byte 513", "the signature of HDF5 is missing in a MAT v7.3 file",
                       "the file is damaged or cut short: copy or save it again");
    if (is_mat_v4(text))
      throw InputError(name, "", "is a MAT v4 file, which is not read", "save it again with save -v7");
    if (text.size() < 128 || text.rfind("MATLAB 5.0", 0) != 0)
      throw InputError(name, "", "is not a MAT v5 file", "a MAT v5 file or a CSV was expected");
  }
  check_mat_structure(path);
  File file(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
  if (!file || Mat_GetVersion(file.get()) != MAT_FT_MAT5)
    throw InputError(name, "", "is not a readable MAT v5 file", "it may be damaged or cut short");
  return file;
}

const char* type_name(matio_classes type) {
  switch (type) {
    case MAT_C_DOUBLE:
      return "double";
    case MAT_C_SINGLE:
      return "single";
    case MAT_C_INT8:
      return "int8";
    case MAT_C_UINT8:
      return "uint8";
    case MAT_C_INT16:
      return "int16";
    case MAT_C_UINT16:
      return "uint16";
    case MAT_C_INT32:
      return "int32";
    case MAT_C_UINT32:
      return "uint32";
    case MAT_C_INT64:
      return "int64";
    case MAT_C_UINT64:
      return "uint64";
    default:
      return nullptr;
  }
}

std::size_t element_count(const matvar_t& variable) {
  std::size_t count = 1;
  for (int i = 0; i < variable.rank; ++i) {
    if (variable.dims[i] != 0 && count > (std::size_t{1} << 40) / variable.dims[i]) return 0;
    count *= variable.dims[i];
  }
  return variable.rank > 0 ? count : 0;
}

using Visitor = std::function<void(const std::string& path, matvar_t& variable)>;

// Calls `visit` for every numeric leaf.
void walk(const std::string& path, matvar_t* variable, int depth, const Visitor& visit) {
  if (!variable || depth > deepest_struct) return;
  const std::size_t count = element_count(*variable);
  if (variable->class_type == MAT_C_STRUCT) {
    const unsigned fields = Mat_VarGetNumberOfFields(variable);
    char* const* names = Mat_VarGetStructFieldnames(variable);
    if (!names || !variable->data) return;
    for (std::size_t i = 0; i < count; ++i)
      for (unsigned f = 0; f < fields; ++f)
        walk(count > 1 ? fmt::format("{}({}).{}", path, i + 1, names[f]) : fmt::format("{}.{}", path, names[f]),
             Mat_VarGetStructFieldByIndex(variable, f, i), depth + 1, visit);
    return;
  }
  if (variable->class_type == MAT_C_CELL) {
    if (!variable->data) return;
    for (std::size_t i = 0; i < count; ++i)
      walk(path + "{" + std::to_string(i + 1) + "}", Mat_VarGetCell(variable, static_cast<int>(i)), depth + 1,
           visit);
    return;
  }
  if (type_name(variable->class_type)) visit(path, *variable);
}

// Headers first, all of them: reading numbers moves the place in the file.
void visit_all(mat_t* file, const std::filesystem::path& path, const Visitor& visit) {
  std::vector<Variable> variables;
  while (Variable variable{Mat_VarReadNextInfo(file)})
    if (variable->name) variables.push_back(std::move(variable));
  if (variables.empty())
    throw InputError(path.string(), "", "holds no readable variable", "it may be damaged or cut short");
  for (const Variable& variable : variables) walk(variable->name, variable.get(), 0, visit);
}

// The first numbers of a variable whose header was read, in file order; empty if they cannot be read.
template <class Element>
std::vector<double> converted(mat_t* file, matvar_t& variable, std::size_t limit) {
  const std::size_t count = std::min(element_count(variable), limit);
  std::vector<Element> stored(count);
  if (count == 0 || Mat_VarReadDataLinear(file, &variable, stored.data(), 0, 1, static_cast<int>(count)) != 0)
    return {};
  if constexpr (std::is_same_v<Element, double>)
    return stored;
  else
    return {stored.begin(), stored.end()};
}

std::vector<double> numbers(mat_t* file, matvar_t& variable, std::size_t limit) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return converted<double>(file, variable, limit);
    case MAT_C_SINGLE:
      return converted<float>(file, variable, limit);
    case MAT_C_INT8:
      return converted<std::int8_t>(file, variable, limit);
    case MAT_C_UINT8:
      return converted<std::uint8_t>(file, variable, limit);
    case MAT_C_INT16:
      return converted<std::int16_t>(file, variable, limit);
    case MAT_C_UINT16:
      return converted<std::uint16_t>(file, variable, limit);
    case MAT_C_INT32:
      return converted<std::int32_t>(file, variable, limit);
    case MAT_C_UINT32:
      return converted<std::uint32_t>(file, variable, limit);
    case MAT_C_INT64:
      return converted<std::int64_t>(file, variable, limit);
    case MAT_C_UINT64:
      return converted<std::uint64_t>(file, variable, limit);
    default:
      return {};
  }
}

// Why a variable is no vector of real numbers; empty if it is one.
std::string vector_fault(const matvar_t& variable) {
  if (variable.isComplex) return "is complex";
  const auto longer =
      std::count_if(variable.dims, variable.dims + variable.rank, [](std::size_t n) { return n > 1; });
  if (longer > 1) return "is a matrix";
  const std::size_t count = element_count(variable);
  if (count == 0) return "is empty";
  return count > std::numeric_limits<int>::max() ? "is longer than this format can be" : "";
}

}  // namespace

bool looks_like_mat(const std::filesystem::path& path) {
  std::ifstream probe(path, std::ios::binary);
  std::array<char, 6> header{};
  probe.read(header.data(), header.size());
  return probe && std::string(header.data(), header.size()) == "MATLAB";
}

std::vector<MatVariable> read_mat(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                                  std::size_t limit) {
  const File file = open(path);
  std::vector<MatVariable> variables;
  visit_all(file.get(), path, [&](const std::string& name, matvar_t& variable) {
    MatVariable found;
    found.path = name;
    found.shape.assign(variable.dims, variable.dims + variable.rank);
    found.type = (variable.isComplex ? "complex " : "") + std::string(type_name(variable.class_type));
    found.fault = vector_fault(variable);
    const bool read = wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    if (read && found.fault.empty()) {
      found.values = numbers(file.get(), variable, limit);
      if (found.values.empty() && limit > 0) found.fault = "has no complete data";
    }
    variables.push_back(std::move(found));
  });
  return variables;
}

}  // namespace secular
