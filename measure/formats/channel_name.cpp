#include "measure/formats/channel_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "measure/formats/csv_dialect.hpp"

namespace secular {

std::string channel_name_fault(std::string_view name) {
  if (name.empty()) return "is empty; every channel has a name";
  if (name == "t") return "is 't', which names time; every channel has a name of its own";
  for (const CsvDialect& dialect : csv_dialects)
    if (!dialect.in_names && name.find(dialect.separator) != std::string_view::npos)
      return fmt::format("'{}' has a {}, which a CSV header cannot hold", name, dialect.name);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (name.find('"') != std::string_view::npos || std::any_of(name.begin(), name.end(), is_control))
    return fmt::format("'{}' has a quote or control character, which a CSV header cannot hold", name);
  if (name.front() == ' ' || name.back() == ' ')
    return fmt::format("'{}' begins or ends with a blank, which a CSV header cannot hold", name);
  double number = 0;
  if (std::from_chars(name.data(), name.data() + name.size(), number).ptr == name.data() + name.size())
    return fmt::format("'{}' is a number, which a CSV header cannot hold", name);
  return {};
}

}  // namespace secular
