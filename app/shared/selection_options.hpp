#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "measure/observe/observation_set.hpp"

namespace secular::app {

/// Options of which a command has no use (docs/your_own_data.md says why).
struct SelectionParts {
  bool band = true, span = true;
};

/// --band, --from, --to and --records: the same in every command that reads records.
class SelectionOptions {
 public:
  /// Adds them to a command; `of`: the option that names the campaign, where that is one.
  void add_to(CLI::App& command, SelectionParts parts = {}, CLI::Option* of = nullptr);

  /// What they say, as far as that makes sense by itself. Throws InputError.
  Window window() const;

 private:
  std::optional<std::string> band_, records_;
  std::optional<double> from_s_, to_s_;
};

}  // namespace secular::app
