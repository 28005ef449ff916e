#include "codegen/runtime/runtime_model.hpp"

#include <fmt/format.h>

#include <system_error>

#include "codegen/runtime/content_hash.hpp"
#include "codegen/runtime/cpp_compiler.hpp"
#include "codegen/runtime/derived_code.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "codegen/runtime/model_cache.hpp"
#include "codegen/runtime/shared_model.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr const char* needed_headers[] = {"estimator/model/compiled_model.hpp",
                                          "estimator/model/model_function.hpp",
                                          "estimator/model/pair_number.hpp",
                                          "estimator/model/batch_arrays.hpp",
                                          "estimator/model/block_functions.hpp",
                                          "estimator/model/complex_number.hpp",
                                          "estimator/model/dense_solve.hpp",
                                          "estimator/model/dual_number.hpp",
                                          "estimator/model/excitation_sample.hpp",
                                          "estimator/model/generated_table.hpp",
                                          "estimator/model/integer_power.hpp",
                                          "estimator/model/lane_functions.hpp",
                                          "estimator/model/lanes.hpp",
                                          "estimator/model/lump_functions.hpp",
                                          "estimator/model/scalar_functions.hpp",
                                          "estimator/model/smooth_functions.hpp"};

struct Headers {
  fs::path folder;
  std::string text;
};

std::optional<Headers> find_headers(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    Headers headers{folder, ""};
    bool complete = true;
    for (const char* const name : needed_headers) {
      const auto text = read_file_bytes(folder / name);
      complete = complete && text;
      headers.text += text.value_or("");
    }
    if (complete) return headers;
  }
  return std::nullopt;
}

// One attempt to have the model compiled; `obstacle` says why there is none.
class Compilation {
 public:
  Compilation(const ModelRequest& request, const RuntimeModelOptions& options)
      : request_(request), options_(options), cache_(options.cache_folder) {}

  std::optional<RuntimeModel> run() {
    const auto compiler = find_cpp_compiler();
    if (!compiler) return failed("no C++ compiler was found ($CXX, c++, g++, clang++)");
    const auto headers = find_headers(options_.header_folders);
    if (!headers)
      return failed("the headers of generated code (estimator/model/compiled_model.hpp) were not found");
    const DerivedCode code = derived_code(request_, cache_);
    std::string source;
    for (const GeneratedUnit& unit : code.units) source += unit.file.name + "\n" + unit.file.text;
    source += shared_model_source(code.model_name);
    std::string options;
    for (const bool seldom_called : {false, true})
      for (const std::string& option : cpp_compiler_options(seldom_called)) options += option + " ";
    const std::string key = content_hash({"shared object", source, headers->text, compiler->identity, options,
                                          std::to_string(compiled_model_abi())});
    RuntimeModel result;
    result.notes = code.notes;
    result.origin = RuntimeModel::Origin::cached;
    std::string reason;
    if (cache_.read(key, suffix)) result.model = shared(load_shared_model(cache_.file(key, suffix), reason));
    if (result.model) return result;
    if (!build(code, *compiler, *headers, key)) return std::nullopt;
    result.origin = RuntimeModel::Origin::compiled;
    result.model = shared(load_shared_model(cache_.file(key, suffix), reason));
    if (!result.model) return failed("the compiled code cannot be loaded: " + reason);
    return result;
  }

  const std::string& obstacle() const { return obstacle_; }

 private:
  static constexpr const char* suffix = ".so";

  // The object stays loaded until the program ends.
  static std::shared_ptr<const CompiledModel> shared(const CompiledModel* model) {
    return {std::shared_ptr<void>(), model};
  }

  bool fail(std::string obstacle) {
    obstacle_ = std::move(obstacle);
    return false;
  }
  std::nullopt_t failed(std::string obstacle) {
    fail(std::move(obstacle));
    return std::nullopt;
  }

  bool build(const DerivedCode& code, const CppCompiler& compiler, const Headers& headers, const std::string& key) {
    const PrivateFolder work = cache_.work_folder();
    if (work.path().empty()) return fail("no folder for compiled code can be written");
    const fs::path entry = work.path() / "entry.cpp", object = work.path() / "model.so";
    const fs::path folder = work.path() / "generated";
    // The entry includes the tables.
    std::vector<CompilationUnit> units;
    std::error_code error;
    fs::create_directory(folder, error);
    bool written = write_file_bytes(entry, shared_model_source(code.model_name));
    for (const auto& [file, often_called] : code.units) {
      written = write_file_bytes(folder / file.name, file.text) && written;
      const bool tables = file.name == code.model_name + ".cpp";
      units.push_back({tables ? entry : folder / file.name, !often_called});
    }
    if (!written) return fail("the generated code cannot be written into the cache");
    if (const auto complaint = compile_shared_object(compiler, units, {work.path(), headers.folder}, object))
      return fail(compiler.command.front() + " failed: " + *complaint);
    const auto bytes = read_file_bytes(object);
    if (!bytes || !cache_.store(key, suffix, *bytes))
      return fail("the compiled code cannot be written into the cache");
    return true;
  }

  const ModelRequest& request_;
  const RuntimeModelOptions& options_;
  ModelCache cache_;
  std::string obstacle_;
};

}  // namespace

RuntimeModel load_runtime_model(const fs::path& file, const RuntimeModelOptions& options) {
  const auto text = read_file_bytes(file);
  if (!text) throw InputError(file.string(), "", "cannot be read", "name a model file");
  return load_runtime_model_text(*text, file.string(), options);
}

RuntimeModel load_runtime_model_text(const std::string& text, const std::string& name,
                                     const RuntimeModelOptions& options) {
  const ModelRequest request{name, text, options.cases, options.effects, options.catalogue};
  RuntimeModel result;
  if (!options.interpret) {
    Compilation compilation(request, options);
    if (std::optional<RuntimeModel> compiled = compilation.run()) return std::move(*compiled);
    result.notes.push_back(fmt::format("model {} is interpreted, which is slower: {}",
                                       fs::path(name).stem().string(), compilation.obstacle()));
  }
  result.origin = RuntimeModel::Origin::interpreted;
  result.model = interpreted_model(cached_model(request, ModelCache(options.cache_folder), result.notes));
  return result;
}

}  // namespace secular
