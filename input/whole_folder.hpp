#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "input/folder_lock.hpp"

namespace secular {

/// A folder that is built beside its target and becomes it, or leaves nothing: neither itself nor parents made for
/// it, also where the program is interrupted (Interruption). What a killed program has left of the same target is
/// removed by the next one.
class WholeFolder {
 public:
  /// Who keeps other programs out of the target's parent while left-overs are looked for.
  enum class ParentLock { here, with_caller };

  /// Throws InputError where the place cannot be written to, or another program is writing the same folder.
  explicit WholeFolder(const std::filesystem::path& target, ParentLock parent = ParentLock::here);
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;
  ~WholeFolder();

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& target() const { return target_; }

  /// Writes a file from pieces: `next` gives them in order, an empty one ends the file. From any thread.
  void write(const std::filesystem::path& file, const std::function<std::string()>& next) const;

  /// Takes the place of a folder that is empty or missing; with `replace` also of another one, which is removed
  /// then: of all of it at once, and the old one stays where that fails.
  void finish(bool replace = false);

  /// Of a folder that is not finished: removes what has been built so far.
  void abandon() const;

 private:
  void put_in_place(bool replace) const;

  std::filesystem::path target_, path_, made_;  // made_: the topmost parent that did not exist before
  FolderLock being_built_;
  bool finished_ = false;
};

}  // namespace secular
