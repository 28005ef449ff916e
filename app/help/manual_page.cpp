#include "app/help/manual_page.hpp"

#include <fmt/format.h>

namespace secular::app {
namespace {

// Text that roff is to print as it is: its own marks are a backslash, a dash that may become another one, and a
// point or an apostrophe that begins a line.
std::string literal(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

std::string entry(const DescribedOption& option) {
  std::string heading;
  for (const std::string& name : option.names)
    heading += (heading.empty() ? "\\fB" : ", \\fB") + literal(name) + "\\fR";
  if (!option.value.empty()) heading += " \\fI" + literal(option.value) + "\\fR";
  return ".TP\n" + heading + "\n" + literal(option.purpose) + (option.required ? ". Required.\n" : ".\n");
}

// Lines below a command's options keep their breaks: most are tables and examples.
std::string kept_lines(const std::string& text) {
  return text.empty() ? "" : ".PP\n.nf\n" + literal(text) + "\n.fi\n";
}

std::string section(const DescribedCommand& command, const std::string& above) {
  const std::string name = above + " " + command.name;
  std::string text = ".SS " + literal(name) + "\n" + literal(command.purpose) + ".\n";
  for (const bool positional : {true, false})
    for (const DescribedOption& option : command.options)
      if (option.positional == positional) text += entry(option);
  text += kept_lines(command.footer);
  for (const DescribedCommand& below : command.commands) text += section(below, name);
  return text;
}

}  // namespace

std::string manual_page(const DescribedCommand& program, const std::string& version) {
  std::string text = fmt::format(".TH {} 1 \"\" \"{}\"\n", literal(program.name), version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", literal(program.name), literal(program.purpose));
  text += fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n", literal(program.name));
  text += ".SH OPTIONS\n";
  for (const DescribedOption& option : program.options) text += entry(option);
  text += ".SH COMMANDS\n";
  for (const DescribedCommand& command : program.commands) text += section(command, program.name);
  text +=
      ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nThe work ran and its own check failed, or it came to no result.\n"
      ".TP\n2\nBad input, nothing in it to work on, or a command line that cannot be read.\n.TP\n3\nA fault of the "
      "program.\n";
  return text;
}

}  // namespace secular::app
