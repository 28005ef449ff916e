#include "measure/formats/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/file_bytes.hpp"
#include "measure/formats/hdf5_data.hpp"
#include "measure/formats/hdf5_object.hpp"
#include "measure/formats/mapped_file.hpp"
#include "measure/formats/matrix_lines.hpp"

namespace secular {
namespace {

constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);
constexpr const char* records_fault =
    "is a table of records (compound type), which is not read: in Python, pandas.read_hdf or h5py, then to_csv";
constexpr std::size_t largest_user_block = 1 << 16;
constexpr int deepest_group = 16;
constexpr std::uint64_t smallest_object = 16;   // bytes
constexpr std::size_t most_other_names = 4096;  // of variables by symbolic links: a guard

// The signature stands at the begin or behind a user block of 512, 1024, ... bytes.
std::optional<std::size_t> signature_place(const std::filesystem::path& path) {
  for (std::size_t at = 0; at <= largest_user_block; at = at == 0 ? 512 : 2 * at)
    if (some_bytes(path, hdf5_signature.size(), at) == hdf5_signature) return at;
  return std::nullopt;
}

struct Superblock {
  std::uint64_t base = 0, end = 0, root = 0;
};

Superblock read_superblock(std::string_view bytes, std::uint64_t at) {
  Hdf5Cursor cursor(bytes.substr(at), at);
  cursor.skip(8);
  const std::uint64_t version = cursor.number(1);
  if (version > 3) cursor.fail(fmt::format("version {} of HDF5's superblock is not known", version));
  if (version < 2) cursor.skip(4);
  if (cursor.number(1) != 8 || cursor.number(1) != 8) cursor.fail("addresses are not of eight bytes");
  cursor.skip(version < 2 ? 9 : 1);
  if (version == 1) cursor.skip(4);
  Superblock block;
  block.base = cursor.number(8);
  cursor.skip(8);
  block.end = cursor.number(8);
  if (version < 2) cursor.skip(16);
  block.root = cursor.number(8);
  if (block.base != at && block.base != 0) cursor.fail("addresses count from an impossible place");
  if (block.end > bytes.size())
    throw Hdf5Damage{fmt::format("the file has {} bytes, {} were written", bytes.size(), block.end), bytes.size()};
  return block;
}

std::string type_name(const Hdf5Type& type) {
  if (type.kind == Hdf5Class::floating_point) return type.size == 8 ? "double" : "single";
  return fmt::format("{}int{}", type.is_signed ? "" : "u", 8 * type.size);
}

/// What further names of the same numbers may cost where nobody asks for them by name: they could make any amount
/// out of a small file.
class Repeats {
 public:
  bool take(std::uint64_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }

 private:
  std::uint64_t left_ = std::uint64_t{1} << 26;
};

/// Goes through all objects of a file and collects the numeric ones.
class Walk {
 public:
  Walk(const Hdf5Bytes& file, const std::vector<std::string>& wanted, std::size_t limit, bool matlab)
      : file_(file),
        wanted_(wanted),
        limit_(limit),
        matlab_(matlab),
        objects_left_(file.size() / smallest_object),
        bytes_left_(file.size()) {}

  void visit(const std::string& path, std::uint64_t address, int depth) {
    if (objects_left_ == 0) throw Hdf5Damage{"groups contain each other", address};
    --objects_left_;
    // A group may be a member of itself: all of it is known already.
    if (depth > deepest_group || std::find(open_.begin(), open_.end(), address) != open_.end()) return;
    const Hdf5Object object = read_hdf5_object(file_, address);
    open_.push_back(address);
    if (object.shape)
      visit_data_set(path, object, depth);
    else
      visit_group(path, object, depth);
    open_.pop_back();
  }

  std::vector<MatVariable> variables;
  std::vector<MatVariable> unread_groups;
  std::vector<std::pair<std::string, std::string>> symbolic_links;  ///< name of each and what it leads to

 private:
  static std::string class_of(const Hdf5Object& object) {
    const auto found = object.attributes.find("MATLAB_class");
    return found == object.attributes.end() ? "" : found->second;
  }

  void visit_group(const std::string& path, const Hdf5Object& group, int depth) {
    const std::string type = class_of(group);
    if (!type.empty() && type != "struct") return;  // sparse matrices and objects
    std::string fault;
    const std::vector<Hdf5Link> members = hdf5_members(file_, group, fault);
    // Nothing is left out in silence: the group stands among the variables and says what to do.
    if (!fault.empty()) unread_groups.push_back({path, {}, "group", {}, fault});
    if (!type.empty() && visit_struct_array(path, members, depth)) return;
    for (const Hdf5Link& member : members) {
      if (matlab_ && path.empty() && member.name.starts_with('#')) continue;  // MATLAB's own: what cells refer to
      if (member.name.starts_with("_i_")) continue;                           // PyTables' own: the index of a table
      const std::string name = path.empty() ? member.name : path + "." + member.name;
      if (member.target.empty())
        visit(name, member.address, depth + 1);
      else
        symbolic_links.emplace_back(name, name_of_target(path, member.target));
    }
  }

  // "/run/a" and, from group "run", "a": both are "run.a".
  static std::string name_of_target(const std::string& group, std::string target) {
    const bool absolute = target.starts_with('/');
    target.erase(0, target.find_first_not_of("/."));
    std::replace(target.begin(), target.end(), '/', '.');
    return absolute || group.empty() ? target : group + "." + target;
  }

  // The fields of a struct array are data sets of references, one for each element.
  bool visit_struct_array(const std::string& path, const std::vector<Hdf5Link>& fields, int depth) {
    std::vector<std::vector<std::uint64_t>> elements;
    for (const Hdf5Link& field : fields) {
      if (!field.target.empty()) return false;
      const Hdf5Object object = read_hdf5_object(file_, field.address);
      if (!object.shape || !is_reference(object) || !class_of(object).empty()) return false;
      elements.push_back(references(object));
      if (elements.back().size() != elements.front().size())
        throw Hdf5Damage{"the fields of a struct array have different lengths", field.address};
    }
    if (elements.empty()) return false;
    for (std::size_t i = 0; i < elements.front().size(); ++i)
      for (std::size_t f = 0; f < fields.size(); ++f)
        visit(fmt::format("{}({}).{}", path, i + 1, fields[f].name), elements[f][i], depth + 1);
    return true;
  }

  static bool is_reference(const Hdf5Object& object) {
    return object.type && object.type->kind == Hdf5Class::reference && object.type->usual;
  }

  std::vector<std::uint64_t> references(const Hdf5Object& object) const {
    std::string fault;
    const auto longer = std::count_if(object.shape->begin(), object.shape->end(), [](auto n) { return n > 1; });
    if (longer > 1 && object.layout.storage == Hdf5Storage::chunked) return {};
    return hdf5_references(file_, object, fault);
  }

  void visit_data_set(const std::string& path, const Hdf5Object& object, int depth) {
    const std::string type = class_of(object);
    if (!object.type || type == "char") return;
    if (is_reference(object)) {
      if (type != "cell" || object.attributes.contains("MATLAB_empty")) return;
      const std::vector<std::uint64_t> elements = references(object);
      for (std::size_t i = 0; i < elements.size(); ++i)
        visit(fmt::format("{}{{{}}}", path, i + 1), elements[i], depth + 1);
      return;
    }
    const bool complex = object.type->kind == Hdf5Class::compound && !type.empty();
    const bool number = object.type->kind == Hdf5Class::integer || object.type->kind == Hdf5Class::floating_point;
    if (object.attributes.contains("MATLAB_object_decode"))
      return variables.push_back({path, {}, "object", {}, matlab_object_fault(path)});
    if (object.type->kind == Hdf5Class::compound && !complex)
      return variables.push_back({path, {}, "table of records", {}, records_fault});
    if ((!number && !complex) || (number && !object.type->usual)) return;
    MatVariable found;
    found.path = path;
    found.shape.assign(object.shape->begin(), object.shape->end());
    found.type = complex ? "complex " + type : type_name(*object.type);
    if (!type.empty()) std::reverse(found.shape.begin(), found.shape.end());  // MATLAB stores columns first
    if (found.shape.empty()) found.shape = {1};
    if (object.attributes.contains("MATLAB_empty")) {  // what is stored then is the shape
      found.shape = {0, 0};
      found.type = type;
    }
    found.fault = vector_fault(object, complex);
    if (const auto unit = object.attributes.find("units"); unit != object.attributes.end())
      found.unit = unit->second;
    const std::optional<MatrixLines> lines =
        found.fault.empty() ? matrix_lines(found.shape) : std::optional<MatrixLines>();
    if (found.fault.empty() && !lines) found.fault = array_fault(found.shape);
    add_lines(std::move(found), lines, object, !type.empty());
  }

  bool is_wanted(const std::string& name) const {
    return std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
  }

  // The variable, or one for each line of a matrix, with the numbers of those that are wanted.
  void add_lines(MatVariable whole, const std::optional<MatrixLines>& matrix, const Hdf5Object& object,
                 bool reversed) {
    const double scale = packing(object, "scale_factor", 1, whole.fault);
    const double offset = packing(object, "add_offset", 0, whole.fault);
    const auto [first, is_new] = first_names_.emplace(open_.back(), whole.path);
    const std::uint64_t bytes = sizeof(double) * hdf5_count(*object.shape);
    if (!is_new && wanted_.empty() && whole.fault.empty() && !repeats_left_.take(bytes))
      whole.fault = "is another name of " + first->second;
    Hdf5Lines lines = hdf5_only_line(*object.shape);
    if (matrix) {
      lines.along = matrix->columns != reversed ? 0 : 1;
      lines.across = 1 - lines.along;
      lines.places.clear();
    }
    std::vector<MatVariable*> read;
    const std::size_t before = variables.size(), count = matrix ? matrix->count : 1;
    for (std::size_t i = 0; i < count; ++i) {
      variables.push_back(whole);
      if (!matrix) continue;
      variables.back().path = matrix->name(whole.path, i);
      variables.back().shape = {matrix->length};
    }
    for (std::size_t i = 0; i < count && whole.fault.empty(); ++i) {
      MatVariable& variable = variables[before + i];
      if (!wanted_.empty() && !is_wanted(variable.path)) continue;
      read.push_back(&variable);
      if (matrix) lines.places.push_back(i);
    }
    if (read.empty()) return;
    if (is_new) spend(object);
    std::string fault;
    std::vector<std::vector<double>> numbers = hdf5_numbers(file_, object, lines, fault, limit_);
    const std::uint64_t announced = object.shape->empty() ? 1 : (*object.shape)[lines.along];
    for (std::size_t i = 0; i < read.size(); ++i) {
      MatVariable& variable = *read[i];
      variable.fault = fault;
      variable.values = std::move(numbers[i]);
      for (double& value : variable.values) value = scale * value + offset;
      if (fault.empty() && variable.values.size() < std::min<std::uint64_t>(announced, limit_)) {
        variable.type += fmt::format(", {} of {} written", variable.values.size(), announced);
        variable.shape = {variable.values.size()};
      }
    }
  }

  // Values are stored as (value - add_offset)/scale_factor, by the conventions of netCDF.
  static double packing(const Hdf5Object& object, const std::string& name, double without, std::string& fault) {
    if (!object.attributes.contains(name)) return without;
    const auto number = object.numbers.find(name);
    if (number != object.numbers.end()) return number->second;
    if (fault.empty()) fault = "has an attribute " + name + " that is not one number";
    return without;
  }

  // Every byte of the file is read once: references that repeat a data set would make much out of a small file.
  void spend(const Hdf5Object& object) {
    const Hdf5Storage storage = object.layout.storage;
    if (storage == Hdf5Storage::other) return;
    const std::uint64_t bytes =
        hdf5_count(*object.shape) * object.type->size / (storage == Hdf5Storage::chunked ? hdf5_deflate_limit : 1) +
        1;
    if (bytes > bytes_left_)
      throw Hdf5Damage{"data sets announce more numbers than the file can hold", object.layout.address};
    bytes_left_ -= bytes;
  }

  static std::string vector_fault(const Hdf5Object& object, bool complex) {
    if (complex) return "is complex";
    return object.attributes.contains("MATLAB_empty") || hdf5_count(*object.shape) == 0 ? "is empty" : "";
  }

  const Hdf5Bytes& file_;
  const std::vector<std::string>& wanted_;
  std::size_t limit_;
  bool matlab_;
  std::uint64_t objects_left_, bytes_left_;
  Repeats repeats_left_;
  std::vector<std::uint64_t> open_;                   // addresses of the object and of the groups it stands in
  std::map<std::uint64_t, std::string> first_names_;  // of data sets, by address
};

/// What a symbolic link leads to goes by its name, too: a variable, or the variables of a group.
void add_symbolic_links(const Hdf5Bytes& content, std::uint64_t root, const std::vector<std::string>& wanted,
                        std::size_t limit, bool matlab, Walk& walk) {
  Repeats repeats;
  std::vector<MatVariable> others;
  std::vector<std::string> targets, names;  // of those that are wanted
  for (const auto& [name, target] : walk.symbolic_links)
    for (const MatVariable& variable : walk.variables) {
      const std::string_view rest =
          std::string_view(variable.path).substr(std::min(target.size(), variable.path.size()));
      if (!variable.path.starts_with(target) ||
          (!rest.empty() && std::string_view(".({").find(rest[0]) == std::string_view::npos))
        continue;
      if (others.size() > most_other_names) return;
      others.push_back(variable);
      MatVariable& other = others.back();
      other.path = name + std::string(rest);
      if (std::find(wanted.begin(), wanted.end(), other.path) != wanted.end()) {
        targets.push_back(variable.path);
        names.push_back(other.path);
      } else if (wanted.empty() && other.fault.empty() && !repeats.take(sizeof(double) * other.values.size())) {
        other.values.clear();
        other.fault = "is another name of " + variable.path;
      }
    }
  if (!targets.empty()) {
    Walk again(content, targets, limit, matlab);
    again.visit("", root, 0);
    for (const MatVariable& variable : again.variables)
      for (std::size_t i = 0; i < targets.size(); ++i)
        if (variable.path == targets[i])
          for (MatVariable& other : others)
            if (other.path == names[i]) {
              other = variable;
              other.path = names[i];
            }
  }
  std::move(others.begin(), others.end(), std::back_inserter(walk.variables));
}

}  // namespace

std::vector<MatVariable> read_hdf5(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                                   std::size_t limit) {
  const MappedFile mapped(path);
  const std::string_view bytes = mapped.bytes();
  const std::string file = path.string();
  const std::optional<std::size_t> place = signature_place(path);
  if (!place)
    throw InputError(file, "", "is not an HDF5 file",
                     "the signature of HDF5 was expected at its begin or byte 513");
  try {
    const Superblock superblock = read_superblock(bytes, *place);
    const Hdf5Bytes content(bytes, superblock.base);
    Walk walk(content, wanted, limit, bytes.starts_with("MATLAB"));
    walk.visit("", superblock.root, 0);
    add_symbolic_links(content, superblock.root, wanted, limit, bytes.starts_with("MATLAB"), walk);
    if (walk.variables.empty() && !walk.unread_groups.empty())
      throw InputError(file, walk.unread_groups.front().path, walk.unread_groups.front().fault,
                       "save it for an earlier version of HDF5, or as MAT v7 or CSV");
    for (MatVariable& group : walk.unread_groups) walk.variables.push_back(std::move(group));
    return std::move(walk.variables);
  } catch (const Hdf5Damage& damage) {
    throw InputError(file, fmt::format("byte {}", damage.at + 1), damage.what,
                     "the file is damaged or cut short: copy or save it again");
  }
}

bool looks_like_hdf5(const std::filesystem::path& path) {
  return signature_place(path).has_value();
}

}  // namespace secular
