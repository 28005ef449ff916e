#pragma once

#include <filesystem>
#include <string>

#include "tests/places.hpp"

namespace secular::testing_support {

/// What a run of the program came to; status -1 where a signal ended it.
struct Outcome {
  int status = -1;
  std::string output, errors;
};

/// How the program is run.
struct RunOptions {
  std::string environment;  ///< assignments before the command, "A=1 B=2"
  std::string program = testing_support::program();
};

/// With `folder` as working folder and nothing on standard input; what it prints stays in folder/stdout.txt and
/// folder/stderr.txt.
Outcome run_program(const std::filesystem::path& folder, const std::string& arguments,
                    const RunOptions& options = {});

/// The same with the cache of compiled models that tests share.
Outcome run_with_shared_cache(const std::filesystem::path& folder, const std::string& arguments);

/// The whole file; empty where there is none.
std::string text_of(const std::filesystem::path& file);

}  // namespace secular::testing_support
