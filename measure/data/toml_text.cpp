#include "measure/data/toml_text.hpp"

#include "measure/formats/number_table.hpp"

namespace secular {

std::string toml_string(const std::string& text) {
  static const char* const hex = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += std::string("\\") + c;
    else if (code < 0x20 || code == 0x7f)
      result += std::string("\\u00") + hex[code / 16] + hex[code % 16];
    else
      result += c;
  }
  return result + "\"";
}

std::string toml_number(double value) {
  std::string text = number_text(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string toml_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + toml_string(name);
  return "[" + text + "]";
}

}  // namespace secular
