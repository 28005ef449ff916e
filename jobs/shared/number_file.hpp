#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// A JSON object of symbol to number. Throws InputError naming the file, the place and the key.
std::map<std::string, double> read_numbers(const std::string& path);
/// The same of the text of such a file; `path`: what messages call it.
std::map<std::string, double> numbers_of(const std::string& text, const std::string& path);

/// A warning that names the numbers of a file that stand for nothing here, such as misspelled ones, and the names
/// there are; empty if each is `known`.
std::string unused_numbers(const std::string& path, const std::map<std::string, double>& numbers,
                           const std::set<std::string, std::less<>>& known);

/// The same where a model's symbols, excitations and their frequencies are known.
std::string unused_numbers(const std::string& path, const std::map<std::string, double>& numbers,
                           const CompiledModel& model);

}  // namespace secular
