#include "codegen/runtime/cpp_compiler.hpp"

#include <cstdlib>
#include <functional>
#include <future>
#include <sstream>
#include <utility>

#include "input/child_process.hpp"
#include "input/stop_request.hpp"

namespace secular {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::string first_complaint(const std::string& output) {
  std::istringstream lines(output);
  std::string first;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error") != std::string::npos) return line;
    if (first.empty()) first = line;
  }
  return first.empty() ? "it ended without a message" : first;
}

// Standard input is empty, messages are not translated.
ProcessEnd run_in_english(const std::vector<std::string>& command) {
  return run_process({.arguments = command, .hidden = {"LC_ALL="}, .settings = {"LC_ALL=C"}});
}

}  // namespace

std::optional<CppCompiler> find_cpp_compiler() {
  std::vector<std::vector<std::string>> candidates;
  if (const char* const chosen = std::getenv("CXX"); chosen != nullptr) candidates.push_back(words(chosen));
  for (const char* const name : {"c++", "g++", "clang++"}) candidates.push_back({name});
  for (std::vector<std::string>& command : candidates) {
    if (command.empty()) continue;
    const auto program = find_program(command.front());
    if (!program) continue;
    command.front() = program->string();
    std::vector<std::string> question = command;
    question.emplace_back("--version");
    const ProcessEnd answer = run_in_english(question);
    if (answer.status != 0 || answer.output.empty()) continue;
    std::string identity = answer.output;
    for (const std::string& word : command) identity += word + "\n";
    return CppCompiler{command, identity};
  }
  return std::nullopt;
}

std::vector<std::string> cpp_compiler_options(bool seldom_called) {
  // Contraction into fused operations is off: it is the one thing that compilers do on their own account.
  return {"-std=c++20",
          seldom_called ? "-O0" : "-O1",
          "-fPIC",
          "-fvisibility=hidden",
          "-ffp-contract=off",
          "-fno-math-errno",
          "-w",
          "-pipe"};
}

std::optional<std::string> compile_shared_object(const CppCompiler& compiler,
                                                 const std::vector<CompilationUnit>& units,
                                                 const std::vector<std::filesystem::path>& include_folders,
                                                 const std::filesystem::path& target) {
  const auto run = [](const std::vector<std::string>& command) -> std::optional<std::string> {
    const ProcessEnd result = run_in_english(command);
    if (result.status != 0) return first_complaint(result.output);
    return std::nullopt;
  };
  const auto compile = [&](const CompilationUnit& unit, const std::filesystem::path& object) {
    std::vector<std::string> command = compiler.command;
    for (std::string& option : cpp_compiler_options(unit.seldom_called)) command.push_back(std::move(option));
    for (const std::filesystem::path& folder : include_folders) {
      command.emplace_back("-I");
      command.push_back(folder.string());
    }
    for (const std::string& word : {std::string("-c"), std::string("-o"), object.string(), unit.source.string()})
      command.push_back(word);
    return run(command);
  };
  std::vector<std::string> link = compiler.command;
  for (const std::string& word : {std::string("-shared"), std::string("-o"), target.string()}) link.push_back(word);
  const std::atomic<bool>* const stop = StopScope::current();
  std::vector<std::future<std::optional<std::string>>> complaints;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::filesystem::path object = target.parent_path() / ("unit" + std::to_string(i) + ".o");
    link.push_back(object.string());
    complaints.push_back(std::async(std::launch::async, [&compile, &unit = units[i], object, stop] {
      const StopScope scope(stop);
      return compile(unit, object);
    }));
  }
  std::optional<std::string> first;
  for (auto& complaint : complaints)
    if (auto text = complaint.get(); text && !first) first = std::move(text);
  return first ? first : run(link);
}

}  // namespace secular
