#include "codegen/runtime/model_cache.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <system_error>

#include "codegen/runtime/content_hash.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours oldest_entry(24 * 90), oldest_work_folder(24);

std::string trailer(const std::string& key, std::string_view content) {
  return "\nsecular cache entry " + key + " " + content_hash({content}) + "\n";
}

std::optional<fs::path> users_cache() {
  for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")}) {
    const char* const value = std::getenv(variable);
    if (value != nullptr && fs::path(value).is_absolute()) return fs::path(value) / below / "secular";
  }
  return std::nullopt;
}

// Code is loaded from here: only this user (or root) may have put it there.
bool is_trustworthy(const fs::path& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return false;
  return (status.st_uid == geteuid() || status.st_uid == 0) && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

}  // namespace

ModelCache::ModelCache(const std::optional<fs::path>& folder) {
  std::error_code error;
  if (const auto wanted = folder ? folder : users_cache()) {
    // Whole path first, so that only the last folder is made for this user alone.
    fs::create_directories(wanted->parent_path(), error);
    mkdir(wanted->c_str(), 0700);
    if (is_trustworthy(*wanted)) readable_ = *wanted;
    if (!readable_.empty() && access(readable_.c_str(), W_OK) == 0) writable_ = readable_;
  }
  if (!writable_.empty()) return;
  temporary_ = std::make_unique<PrivateFolder>(fs::temp_directory_path(error));
  writable_ = temporary_->path();
  if (readable_.empty()) readable_ = writable_;
}

fs::path ModelCache::file(const std::string& key, const std::string& suffix) const {
  const fs::path stored = writable_ / (key + suffix);
  std::error_code error;
  return fs::exists(stored, error) ? stored : readable_ / (key + suffix);
}

std::optional<std::string> ModelCache::read(const std::string& key, const std::string& suffix) const {
  if (readable_.empty()) return std::nullopt;  // nothing is taken from the current folder
  std::optional<std::string> bytes = read_file_bytes(file(key, suffix));
  const std::size_t length = trailer(key, "").size();
  if (!bytes || bytes->size() < length) return std::nullopt;
  const std::string_view content(bytes->data(), bytes->size() - length);
  if (bytes->substr(content.size()) != trailer(key, content)) return std::nullopt;
  bytes->resize(content.size());
  return bytes;
}

bool ModelCache::store(const std::string& key, const std::string& suffix, std::string_view content) const {
  const PrivateFolder work = work_folder();
  if (work.path().empty()) return false;
  const fs::path fresh = work.path() / "entry";
  if (!write_file_bytes(fresh, std::string(content) + trailer(key, content))) return false;
  std::error_code error;
  fs::rename(fresh, writable_ / (key + suffix), error);
  if (!error && !temporary_) remove_old_entries();
  return !error;
}

void ModelCache::remove_old_entries() const {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (const fs::directory_entry& entry : fs::directory_iterator(writable_, error)) {
    const auto written = entry.last_write_time(error);
    if (error) continue;
    const bool work = entry.path().filename().string().rfind("build-", 0) == 0;
    if (now - written > (work ? oldest_work_folder : oldest_entry)) fs::remove_all(entry.path(), error);
  }
}

}  // namespace secular
