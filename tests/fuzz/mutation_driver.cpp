// Drives a fuzz target without libFuzzer, so that any compiler and every test run have it: its inputs are files of
// the corpus and damaged ones, the same in every run.
//   NAME_mutated ROUNDS [-dict=FILE] [FILE_OR_FOLDER]...        without files: random bytes
// Where one ends it, a file that it names says which; with -ROUND as the number of rounds, that input is printed.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "tests/campaign/damage.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace secular::fuzz {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Lines of a dictionary of libFuzzer: a string in quotes with \" and \\.
std::vector<std::string> words_of(const fs::path& dictionary) {
  std::vector<std::string> words;
  std::ifstream stream(dictionary);
  for (std::string line; std::getline(stream, line);) {
    if (line.size() < 2 || line.front() != '"') continue;
    std::string word;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] == '\\') ++i;
      word += line[i];
    }
    words.push_back(word);
  }
  return words;
}

struct Driver {
  std::vector<std::string> corpus, words;
  std::mt19937_64 random{20};
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random() % n); }

  std::string input() {
    std::string text;
    if (corpus.empty()) {
      text.resize(below(64) + 1);
      for (char& c : text) c = static_cast<char>(below(256));
      return text;
    }
    text = damaged(corpus[below(corpus.size())], random);
    if (!words.empty() && below(2) == 0) {
      const std::string& word = words[below(words.size())];
      text.replace(below(text.size() + 1), below(2) * word.size(), word);
    }
    if (below(8) == 0) {  // its end from another file
      const std::string& other = corpus[below(corpus.size())];
      text.resize(below(text.size() + 1));
      text += other.substr(below(other.size() + 1));
    }
    return text;
  }
};

void run(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

// The number of the round at work, in memory that a file keeps whatever ends the process.
class RoundFile {
 public:
  RoundFile() {
    const int descriptor = ::open(path_.c_str(), O_RDWR | O_CREAT, 0600);
    void* const memory = descriptor >= 0 && ::ftruncate(descriptor, size) == 0
                             ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0)
                             : MAP_FAILED;
    if (memory != MAP_FAILED) text_ = static_cast<char*>(memory);
    if (descriptor >= 0) ::close(descriptor);
  }
  ~RoundFile() { fs::remove(path_); }
  RoundFile(const RoundFile&) = delete;
  RoundFile& operator=(const RoundFile&) = delete;

  const fs::path& path() const { return path_; }
  void set(long round) const {
    if (text_) std::snprintf(text_, size, "%ld\n", round);
  }

 private:
  static constexpr std::size_t size = 24;
  fs::path path_ = fs::temp_directory_path() / ("secular_fuzz_round." + std::to_string(::getpid()));
  char* text_ = nullptr;
};

int drive(int count, char** arguments) {
  if (count < 2) return 2;
  Driver driver;
  for (int i = 2; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument.starts_with("-dict=")) {
      driver.words = words_of(argument.substr(6));
    } else if (fs::is_directory(argument)) {
      std::vector<fs::path> files;
      for (const fs::directory_entry& entry : fs::directory_iterator(argument))
        if (entry.is_regular_file()) files.push_back(entry.path());
      std::sort(files.begin(), files.end());
      for (const fs::path& file : files) driver.corpus.push_back(bytes_of(file));
    } else {
      driver.corpus.push_back(bytes_of(argument));
    }
    if (!argument.starts_with("-dict=") && driver.corpus.empty()) return 2;
  }
  const long rounds = std::strtol(arguments[1], nullptr, 10);
  if (rounds < 0) {
    std::string text;
    for (long round = 0; round < -rounds; ++round) text = driver.input();
    std::fwrite(text.data(), 1, text.size(), stdout);
    return 0;
  }
  const RoundFile at_work;
  std::printf("the round at work is in %s\n", at_work.path().c_str());
  std::fflush(stdout);
  for (const std::string& text : driver.corpus) run(text);
  for (long round = 1; round <= rounds; ++round) {
    at_work.set(round);
    run(driver.input());
  }
  return 0;
}

}  // namespace
}  // namespace secular::fuzz

int main(int count, char** arguments) {
  return secular::fuzz::drive(count, arguments);
}
