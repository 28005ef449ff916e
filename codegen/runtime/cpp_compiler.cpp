#include "codegen/runtime/cpp_compiler.hpp"

#include <cstdlib>
#include <sstream>

#include "codegen/runtime/process.hpp"

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
    const ProcessResult answer = run_process(question);
    if (answer.status != 0 || answer.output.empty()) continue;
    std::string identity = answer.output;
    for (const std::string& word : command) identity += word + "\n";
    return CppCompiler{command, identity};
  }
  return std::nullopt;
}

const std::vector<std::string>& cpp_compiler_options() {
  // Contraction into fused operations is off: it is the one thing that compilers do on their own account.
  static const std::vector<std::string> options = {
      "-std=c++20",      "-O1", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off",
      "-fno-math-errno", "-w",  "-pipe"};
  return options;
}

std::optional<std::string> compile_shared_object(const CppCompiler& compiler, const std::filesystem::path& source,
                                                 const std::vector<std::filesystem::path>& include_folders,
                                                 const std::filesystem::path& target) {
  std::vector<std::string> command = compiler.command;
  const std::vector<std::string>& options = cpp_compiler_options();
  command.insert(command.end(), options.begin(), options.end());
  for (const std::filesystem::path& folder : include_folders) {
    command.emplace_back("-I");
    command.push_back(folder.string());
  }
  command.emplace_back("-o");
  command.push_back(target.string());
  command.push_back(source.string());
  const ProcessResult result = run_process(command);
  if (result.status != 0) return first_complaint(result.output);
  return std::nullopt;
}

}  // namespace secular
