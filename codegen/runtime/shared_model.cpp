#include "codegen/runtime/shared_model.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {

std::string shared_model_source(const std::string& model_name) {
  return fmt::format(R"(#include "generated/{}.cpp"

extern "C" __attribute__((visibility("default"))) const void* secular_compiled_model(unsigned long long abi) {{
  return abi == secular::compiled_model_abi() ? &secular::generated::{}::model : nullptr;
}}
)",
                     model_name, safe_namespace(model_name));
}

const CompiledModel* load_shared_model(const std::filesystem::path& file, std::string& reason) {
  void* const object = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) {
    const char* const message = dlerror();
    reason = message ? message : "cannot be loaded";
    return nullptr;
  }
  using Entry = const void* (*)(unsigned long long);
  void* const symbol = dlsym(object, "secular_compiled_model");
  const void* const model = symbol ? reinterpret_cast<Entry>(symbol)(compiled_model_abi()) : nullptr;
  if (model == nullptr) {
    reason =
        symbol ? "was compiled against another version of estimator/model/compiled_model.hpp" : "holds no model";
    dlclose(object);
    return nullptr;
  }
  return static_cast<const CompiledModel*>(model);
}

}  // namespace secular
