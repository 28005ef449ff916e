#include "input/whole_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

#include "input/folder_lock.hpp"
#include "input/input_error.hpp"
#include "input/interruption.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr double longest_wait_s = 2;  // others hold the lock of the parent for a moment only

// How the names of what is built beside the target begin.
std::string unfinished(const fs::path& target) {
  return fmt::format(".{}.unfinished-", target.filename().string());
}

// What a process that was killed has left. Who builds holds the lock of the folder.
void remove_left_overs(const fs::path& target) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(target.parent_path(), error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().starts_with(unfinished(target))) found.push_back(entry->path());
  for (const fs::path& folder : found) {
    const FolderLock lock(folder);
    if (lock.state() == FolderLock::State::taken)
      throw InputError(target.string(), "", "another command is writing it",
                       "wait until that has ended, or name another folder");
    if (lock.state() == FolderLock::State::held) fs::remove_all(folder, error);
  }
}

}  // namespace

WholeFolder::WholeFolder(const fs::path& target, ParentLock parent_lock)
    : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  std::error_code error;
  if (fs::exists(target_, error)) target_ = fs::canonical(target_, error);  // what a link points to, not the link
  for (fs::path parent = target_.parent_path(); !parent.empty() && !fs::exists(parent, error);
       parent = parent.parent_path())
    made_ = parent;
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  fs::create_directories(target_.parent_path(), error);
  if (!error) {
    // Only one command at a time looks and begins.
    FolderLock beginning;
    if (parent_lock == ParentLock::here) beginning = FolderLock(target_.parent_path(), longest_wait_s);
    remove_left_overs(target_);
    for (int attempt = 0; !error && path_.empty(); ++attempt) {
      const fs::path name =
          target_.parent_path() / fmt::format("{}{}-{}", unfinished(target_), ::getpid(), attempt);
      if (fs::create_directory(name, error)) path_ = name;
    }
    being_built_ = FolderLock(path_);
  }
  if (error) {
    abandon();
    throw InputError(target.string(), "", "cannot be created: " + error.message(),
                     "name a folder in a place that you may write to");
  }
  interruption.add(this, [this] {
    abandon();
    std::error_code ignored;
    return !fs::exists(path_, ignored);
  });
}

WholeFolder::~WholeFolder() {
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  interruption.take_out(this);
  if (!finished_) abandon();
}

void WholeFolder::write(const fs::path& file, const std::function<std::string()>& next) const {
  std::error_code error;
  fs::create_directories((path_ / file).parent_path(), error);
  std::ofstream stream(path_ / file, std::ios::binary);
  for (std::string piece = next(); stream && !piece.empty(); piece = next()) stream << piece;
  stream.close();
  if (!stream)
    throw InputError((target_ / file).string(), "", "cannot be written",
                     "check the name, the permissions and the free space");
}

void WholeFolder::finish(bool replace) {
  {
    const std::lock_guard lock(Interruption::instance().guard());
    put_in_place(replace);
    finished_ = true;
  }
  std::error_code ignored;
  fs::remove_all(path_, ignored);  // what was replaced
}

void WholeFolder::put_in_place(bool replace) const {
  std::error_code error;
  fs::rename(path_, target_, error);  // takes the place of an empty folder
  if (!error) return;
  const auto fail = [&] {
    throw InputError(target_.string(), "", "cannot be put in place: " + error.message(), "name a new folder");
  };
  if (!replace || !fs::is_directory(target_)) fail();
  // Both names change at once. Where the file system cannot, the old folder steps aside and comes back if need be.
  if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) return;
  const fs::path aside =
      target_.parent_path() / fmt::format(".{}.replaced-{}", target_.filename().string(), ::getpid());
  fs::rename(target_, aside, error);
  if (error) fail();
  fs::rename(path_, target_, error);
  std::error_code ignored;
  fs::rename(aside, error ? target_ : path_, ignored);
  if (error) fail();
}

void WholeFolder::abandon() const {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (made_.empty()) return;
  for (fs::path parent = target_.parent_path(); fs::remove(parent, ignored) && parent != made_;)
    parent = parent.parent_path();
}

}  // namespace secular
