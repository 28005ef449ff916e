#pragma once

#include <filesystem>
#include <string>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// The source file that makes a shared object of an emitted model: it includes the model's code and exports one C
/// function,  const void* secular_compiled_model(unsigned long long abi),  which returns the model's CompiledModel,
/// or nothing when the caller's compiled_model_abi() is another one.
std::string shared_model_source(const std::string& model_name);

/// Loads such an object. The model stays until the program ends: names and tables in it are pointed to from
/// everywhere. nullptr with `reason` set when the object cannot be loaded or speaks another ABI.
const CompiledModel* load_shared_model(const std::filesystem::path& file, std::string& reason);

}  // namespace secular
