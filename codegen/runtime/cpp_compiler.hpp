#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace secular {

/// A C++ compiler of this machine.
struct CppCompiler {
  std::vector<std::string> command;  ///< program and the arguments that $CXX gives it
  std::string identity;              ///< where it is and what it says of its version: part of the cache's key
};

/// $CXX (its words are a program and arguments), then c++, g++, clang++ in $PATH: the first that answers --version.
std::optional<CppCompiler> find_cpp_compiler();

/// Options of every compilation. Nothing that changes what floating-point operations mean: results are those of
/// code that is compiled in.
const std::vector<std::string>& cpp_compiler_options();

/// Compiles one source file into a shared object. Returns the compiler's first complaint, or nothing on success.
std::optional<std::string> compile_shared_object(const CppCompiler& compiler, const std::filesystem::path& source,
                                                 const std::vector<std::filesystem::path>& include_folders,
                                                 const std::filesystem::path& target);

}  // namespace secular
