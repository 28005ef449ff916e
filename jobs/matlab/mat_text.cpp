#include "jobs/matlab/mat_text.hpp"

#include <fmt/format.h>
#include <matio.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "input/input_error.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_identifier = 63;

struct VariableEnd {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, VariableEnd>;

Variable checked(matvar_t* made) {
  if (made == nullptr) throw std::runtime_error("a variable of a MAT file could not be made");
  return Variable(made);
}

struct Shape {
  std::size_t rows = 0, columns = 0;
};

Variable made(const char* name, matio_classes kind, matio_types type, Shape shape, const void* data,
              int options = 0) {
  std::size_t sizes[] = {shape.rows, shape.columns};
  // matio copies what it is given.
  return checked(Mat_VarCreate(name, kind, type, 2, sizes, const_cast<void*>(data), options));
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string identifier(const std::string& name) {
  std::string text = name.empty() || !is_letter(name.front()) ? "x" + name : name;
  for (char& c : text)
    if (!is_letter(c) && !(c >= '0' && c <= '9')) c = '_';
  return text.substr(0, longest_identifier);
}

// Identifiers of several names, each another one.
std::vector<std::string> identifiers(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) {
    std::string unique = identifier(name);
    for (int n = 1; std::find(all.begin(), all.end(), unique) != all.end(); ++n) {
      const std::string number = fmt::format("_{}", n);
      unique = identifier(name).substr(0, longest_identifier - number.size()) + number;
    }
    all.push_back(std::move(unique));
  }
  return all;
}

// UTF-8 that a JSON parser let pass.
std::vector<std::uint16_t> utf16(const std::string& text) {
  std::vector<std::uint16_t> units;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    std::uint32_t code = length == 1 ? first : first & (0xffU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k)
      code = (code << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
    i += length;
    if (code >= 0x10000) {
      units.push_back(static_cast<std::uint16_t>(0xd800 + ((code - 0x10000) >> 10U)));
      code = 0xdc00 + ((code - 0x10000) & 0x3ffU);
    }
    units.push_back(static_cast<std::uint16_t>(code));
  }
  return units;
}

bool is_number_or_null(const Json& value) {
  return value.is_number() || value.is_null();
}

template <class Test>
bool is_list_of(const Json& value, const Test& test) {
  return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), test);
}

bool is_numbers(const Json& value) {
  return is_list_of(value, is_number_or_null) &&
         std::any_of(value.begin(), value.end(), [](const Json& one) { return one.is_number(); });
}

// Rows of numbers, all of one length.
bool is_matrix(const Json& value) {
  return is_list_of(value, [&](const Json& row) { return is_numbers(row) && row.size() == value.front().size(); });
}

double number_of(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Variable variable_of(const Json& value, const char* name);

Variable numbers_of(const Json& rows, std::size_t columns, const char* name) {
  std::vector<double> values;  // by column
  for (std::size_t c = 0; c < columns; ++c)
    for (const Json& row : rows) values.push_back(number_of(row.is_array() ? row[c] : row));
  return made(name, MAT_C_DOUBLE, MAT_T_DOUBLE, {rows.size(), columns}, values.data());
}

Variable flags_of(const std::vector<bool>& flags, const char* name) {
  const std::vector<std::uint8_t> values(flags.begin(), flags.end());
  return made(name, MAT_C_UINT8, MAT_T_UINT8, {values.size(), 1}, values.data(), MAT_F_LOGICAL);
}

Variable cells_of(const Json& list, const char* name) {
  std::vector<Variable> cells;
  for (const Json& one : list) cells.push_back(variable_of(one, nullptr));
  std::vector<matvar_t*> handed;
  for (Variable& cell : cells) handed.push_back(cell.release());
  return made(name, MAT_C_CELL, MAT_T_CELL, {handed.size(), 1}, handed.data());
}

// One struct for each object, with the fields of all.
Variable structs_of(const std::vector<const Json*>& objects, const char* name) {
  std::vector<std::string> keys;
  for (const Json* object : objects)
    for (const auto& [key, value] : object->items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  const std::vector<std::string> fields = identifiers(keys);
  std::vector<const char*> texts;
  for (const std::string& field : fields) texts.push_back(field.c_str());
  std::size_t sizes[] = {objects.size(), 1};
  Variable whole = checked(Mat_VarCreateStruct(name, 2, sizes, texts.data(), static_cast<unsigned>(texts.size())));
  for (std::size_t f = 0; f < keys.size(); ++f)
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const auto at = objects[i]->find(keys[f]);
      Mat_VarSetStructFieldByIndex(whole.get(), f, i,
                                   variable_of(at == objects[i]->end() ? Json() : *at, texts[f]).release());
    }
  return whole;
}

Variable list_of(const Json& list, const char* name) {
  if (is_numbers(list)) return numbers_of(list, 1, name);
  if (is_matrix(list)) return numbers_of(list, list.front().size(), name);
  if (is_list_of(list, [](const Json& one) { return one.is_boolean(); })) {
    std::vector<bool> flags;
    for (const Json& one : list) flags.push_back(one.get<bool>());
    return flags_of(flags, name);
  }
  if (is_list_of(list, [](const Json& one) { return one.is_object(); })) {
    std::vector<const Json*> objects;
    for (const Json& one : list) objects.push_back(&one);
    return structs_of(objects, name);
  }
  return cells_of(list, name);
}

Variable variable_of(const Json& value, const char* name) {
  if (value.is_object()) return structs_of({&value}, name);
  if (value.is_array() && !value.empty()) return list_of(value, name);
  if (value.is_boolean()) return flags_of({value.get<bool>()}, name);
  if (value.is_number()) {
    const double number = value.get<double>();
    return made(name, MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 1}, &number);
  }
  if (value.is_string()) {
    const std::vector<std::uint16_t> units = utf16(value.get<std::string>());
    return made(name, MAT_C_CHAR, MAT_T_UTF16, {units.empty() ? 0U : 1U, units.size()}, units.data());
  }
  return made(name, MAT_C_DOUBLE, MAT_T_DOUBLE, {}, nullptr);
}

// A file for matio, which writes to nothing else.
class ScratchFile {
 public:
  ScratchFile() : path_((std::filesystem::temp_directory_path() / "secular-XXXXXX").string()) {
    const int handle = mkstemp(path_.data());
    if (handle < 0)
      throw InputError(path_, "", "cannot be made", "a folder for temporary files that can be written to (TMPDIR)");
    close(handle);
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const char* name() const { return path_.c_str(); }
  std::string bytes() const {
    std::ifstream stream(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  std::string path_;
};

}  // namespace

std::string mat_of_json(const std::string& json, const std::string& name, const std::string& file) {
  const Json content = Json::parse(json, nullptr, false);
  if (content.is_discarded())
    throw InputError(file, "", "is no JSON", "a file that a command of this program wrote");
  const ScratchFile scratch;
  mat_t* const mat = Mat_CreateVer(scratch.name(), mat_heading, MAT_FT_MAT5);
  if (mat == nullptr) throw InputError(scratch.name(), "", "cannot be written", "free space for temporary files");
  const Variable variable = variable_of(content, identifier(name).c_str());
  const int fault = Mat_VarWrite(mat, variable.get(), MAT_COMPRESSION_NONE);
  if (Mat_Close(mat) != 0 || fault != 0)
    throw InputError(scratch.name(), "", "cannot be written", "free space for temporary files");
  return scratch.bytes();
}

}  // namespace secular
