#include "measure/formats/mat_file.hpp"

#include <fmt/format.h>
#include <matio.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/mat_structure.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/stored_numbers.hpp"

namespace secular {
namespace {

struct Closer {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Closer>;
using Variable = std::unique_ptr<matvar_t, Closer>;

/// Bytes under a name that can be opened while this lasts; what was opened stays readable afterwards.
class FileInMemory {
 public:
  explicit FileInMemory(const std::vector<unsigned char>& bytes) {
    if (bytes.empty()) return;
    handle_ = memfd_create("secular", MFD_CLOEXEC);
    for (std::size_t written = 0; handle_ >= 0 && written < bytes.size();) {
      const ssize_t count = write(handle_, bytes.data() + written, bytes.size() - written);
      if (count <= 0) throw std::bad_alloc();
      written += static_cast<std::size_t>(count);
    }
  }
  ~FileInMemory() {
    if (handle_ >= 0) close(handle_);
  }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  bool exists() const { return handle_ >= 0; }
  std::string path() const { return fmt::format("/proc/self/fd/{}", handle_); }

 private:
  int handle_ = -1;
};

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
  const FileInMemory repaired(check_mat_structure(path));
  File file(Mat_Open(repaired.exists() ? repaired.path().c_str() : name.c_str(), MAT_ACC_RDONLY));
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
  if (type_name(variable->class_type) || variable->class_type == MAT_C_OPAQUE) visit(path, *variable);
}

// Headers first, all of them: reading numbers moves the place in the file.
void visit_all(mat_t* file, const std::filesystem::path& path, const Visitor& visit) {
  std::vector<Variable> variables;
  while (Variable variable{Mat_VarReadNextInfo(file)})
    if (variable->name || variable->class_type == MAT_C_OPAQUE) variables.push_back(std::move(variable));
  if (variables.empty())
    throw InputError(path.string(), "", "holds no readable variable", "it may be damaged or cut short");
  for (const Variable& variable : variables)
    if (const std::string name = variable->name ? variable->name : "object"; !name.empty())
      walk(name, variable.get(), 0, visit);
}

// Numbers of a variable whose header was read: `count` of them in stored order, from `start` on, `stride` apart.
struct Stretch {
  std::size_t start = 0, stride = 1, count = 0;
};

// Empty if they cannot be read.
template <class Element>
std::vector<double> converted(mat_t* file, matvar_t& variable, const Stretch& part) {
  std::vector<Element> stored(part.count);
  if (part.count == 0 || Mat_VarReadDataLinear(file, &variable, stored.data(), static_cast<int>(part.start),
                                               static_cast<int>(part.stride), static_cast<int>(part.count)) != 0)
    return {};
  if constexpr (std::is_same_v<Element, double>)
    return stored;
  else
    return {stored.begin(), stored.end()};
}

std::vector<double> numbers(mat_t* file, matvar_t& variable, const Stretch& part) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return converted<double>(file, variable, part);
    case MAT_C_SINGLE:
      return converted<float>(file, variable, part);
    case MAT_C_INT8:
      return converted<std::int8_t>(file, variable, part);
    case MAT_C_UINT8:
      return converted<std::uint8_t>(file, variable, part);
    case MAT_C_INT16:
      return converted<std::int16_t>(file, variable, part);
    case MAT_C_UINT16:
      return converted<std::uint16_t>(file, variable, part);
    case MAT_C_INT32:
      return converted<std::int32_t>(file, variable, part);
    case MAT_C_UINT32:
      return converted<std::uint32_t>(file, variable, part);
    case MAT_C_INT64:
      return converted<std::int64_t>(file, variable, part);
    case MAT_C_UINT64:
      return converted<std::uint64_t>(file, variable, part);
    default:
      return {};
  }
}

// Real parts and imaginary parts of all of a complex variable; empty if they cannot be read.
std::array<std::vector<double>, 2> complex_numbers(mat_t* file, matvar_t& variable) {
  const std::size_t count = element_count(variable);
  const auto read = [&](auto element) -> std::array<std::vector<double>, 2> {
    std::vector<decltype(element)> real(count), imaginary(count);
    mat_complex_split_t parts{real.data(), imaginary.data()};
    if (Mat_VarReadDataLinear(file, &variable, &parts, 0, 1, static_cast<int>(count)) != 0) return {};
    return {std::vector<double>(real.begin(), real.end()), std::vector<double>(imaginary.begin(), imaginary.end())};
  };
  if (variable.class_type == MAT_C_DOUBLE) return read(double{});
  if (variable.class_type == MAT_C_SINGLE) return read(float{});
  return {};
}

// A complex variable as two real ones, NAME.re and NAME.im, or two for each line of a matrix: tables of lines have
// them.
void add_complex_parts(mat_t* file, matvar_t& variable, const std::string& name,
                       const std::function<bool(const std::string&)>& is_wanted, std::size_t limit,
                       std::vector<MatVariable>& variables) {
  const bool real_type = variable.class_type == MAT_C_DOUBLE || variable.class_type == MAT_C_SINGLE;
  const std::size_t count = element_count(variable);
  if (!real_type || count == 0 || count > std::numeric_limits<int>::max()) return;
  const std::vector<std::size_t> shape(variable.dims, variable.dims + variable.rank);
  const std::optional<MatrixLines> matrix = matrix_lines(shape);
  if (!matrix && !array_fault(shape).empty()) return;
  std::array<std::vector<double>, 2> whole;
  for (std::size_t i = 0; i < (matrix ? matrix->count : 1); ++i)
    for (const std::size_t part : {0u, 1u}) {
      MatVariable line;
      line.path = (matrix ? matrix->name(name, i) : name) + (part == 0 ? ".re" : ".im");
      line.shape = matrix ? std::vector<std::size_t>{matrix->length} : shape;
      line.type = part == 0 ? "real part" : "imaginary part";
      if (is_wanted(line.path) && limit > 0) {
        if (whole[0].empty()) whole = complex_numbers(file, variable);
        const std::size_t rows = shape[0], length = matrix ? matrix->length : count;
        for (std::size_t n = 0; n < std::min(length, limit) && !whole[part].empty(); ++n)
          line.values.push_back(whole[part][!matrix ? n : matrix->columns ? i * rows + n : i + n * rows]);
        if (line.values.empty()) line.fault = "has no complete data";
      }
      variables.push_back(std::move(line));
    }
}

// Why a variable holds no real numbers; empty if it does.
std::string number_fault(const matvar_t& variable) {
  if (variable.isComplex) return "is complex";
  const std::size_t count = element_count(variable);
  if (count == 0) return "is empty";
  return count > std::numeric_limits<int>::max() ? "is longer than this format can be" : "";
}

// The first numbers of a line of a matrix, which is stored column by column. Of a compressed one all is read at
// once, since each part would inflate what stands before it.
std::vector<std::vector<double>> read_lines(mat_t* file, matvar_t& variable, const MatrixLines& matrix,
                                            const std::vector<std::size_t>& places, std::size_t limit) {
  const std::size_t rows = variable.dims[0], count = std::min(matrix.length, limit);
  const std::size_t across = matrix.columns ? rows : 1, along = matrix.columns ? 1 : rows;
  const bool at_once = variable.compression != MAT_COMPRESSION_NONE;
  const std::vector<double> whole =
      at_once ? numbers(file, variable, {0, 1, element_count(variable)}) : std::vector<double>();
  std::vector<std::vector<double>> lines;
  for (const std::size_t place : places) {
    if (!at_once) {
      lines.push_back(numbers(file, variable, {place * across, along, count}));
      continue;
    }
    std::vector<double>& line = lines.emplace_back();
    for (std::size_t i = 0; i < count && !whole.empty(); ++i) line.push_back(whole[place * across + i * along]);
  }
  return lines;
}

// A variable, or one for each line of a matrix, with the numbers of those that are wanted.
void add_variable(mat_t* file, matvar_t& variable, const std::string& name, const std::vector<std::string>& wanted,
                  std::size_t limit, std::vector<MatVariable>& variables) {
  const auto is_wanted = [&](const std::string& path) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), path) != wanted.end();
  };
  if (variable.class_type == MAT_C_OPAQUE) {
    variables.push_back({name, {}, "object", {}, matlab_object_fault(name)});
    return;
  }
  MatVariable found;
  found.path = name;
  found.shape.assign(variable.dims, variable.dims + variable.rank);
  found.type = (variable.isComplex ? "complex " : "") + std::string(type_name(variable.class_type));
  found.fault = number_fault(variable);
  const std::optional<MatrixLines> matrix =
      found.fault.empty() ? matrix_lines(found.shape) : std::optional<MatrixLines>();
  if (found.fault.empty() && !matrix) found.fault = array_fault(found.shape);
  std::vector<std::size_t> places;
  const std::size_t before = variables.size();
  for (std::size_t i = 0; i < (matrix ? matrix->count : 1); ++i) {
    variables.push_back(found);
    if (matrix) {
      variables.back().path = matrix->name(name, i);
      variables.back().shape = {matrix->length};
    }
    if (found.fault.empty() && is_wanted(variables.back().path)) places.push_back(i);
  }
  if (variable.isComplex) add_complex_parts(file, variable, name, is_wanted, limit, variables);
  if (places.empty()) return;
  std::vector<std::vector<double>> lines;
  if (matrix)
    lines = read_lines(file, variable, *matrix, places, limit);
  else
    lines.push_back(numbers(file, variable, {0, 1, std::min(element_count(variable), limit)}));
  for (std::size_t i = 0; i < places.size(); ++i) {
    MatVariable& line = variables[before + places[i]];
    line.values = std::move(lines[i]);
    if (line.values.empty() && limit > 0) line.fault = "has no complete data";
  }
}

}  // namespace

std::string matlab_object_fault(const std::string& name) {
  return fmt::format(
      "is an object (timetable, table, datetime, ...), which MATLAB alone reads: there, S = "
      "table2struct(timetable2table("
      "{0}), 'ToScalar', true) for a timetable, S.Time = seconds(S.Time - S.Time(1)), save('file.mat', '-struct', "
      "'S')",
      name);
}

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
    add_variable(file.get(), variable, name, wanted, limit, variables);
  });
  return variables;
}

}  // namespace secular
