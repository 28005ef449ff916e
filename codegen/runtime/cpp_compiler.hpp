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

/// A source file of a shared object.
struct CompilationUnit {
  std::filesystem::path source;
  bool seldom_called = false;  ///< code whose compilation costs more than it will ever run
};

/// Options of a compilation. Nothing that changes what floating-point operations mean: results are those of code
/// that is compiled in.
std::vector<std::string> cpp_compiler_options(bool seldom_called);

/// Compiles source files, at once, and links them into a shared object; objects are written beside it. Returns the
/// compiler's first complaint, or nothing on success.
std::optional<std::string> compile_shared_object(const CppCompiler& compiler,
                                                 const std::vector<CompilationUnit>& units,
                                                 const std::vector<std::filesystem::path>& include_folders,
                                                 const std::filesystem::path& target);

}  // namespace secular
