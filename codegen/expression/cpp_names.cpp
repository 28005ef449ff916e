// Names of the generated code that come from a model file: see cpp_expression.hpp.
#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>
#include <string_view>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_letter(char c) {
  return is_upper(c) || (c >= 'a' && c <= 'z');
}

bool is_keyword(const std::string& name) {
  static const std::set<std::string> keywords = {
      "alignas",     "alignof",  "and",       "and_eq",    "asm",       "auto",         "bitand",
      "bitor",       "bool",     "break",     "case",      "catch",     "char",         "char16_t",
      "char32_t",    "char8_t",  "class",     "co_await",  "co_return", "co_yield",     "compl",
      "concept",     "const",    "consteval", "constexpr", "constinit", "const_cast",   "continue",
      "decltype",    "default",  "delete",    "do",        "double",    "dynamic_cast", "else",
      "enum",        "explicit", "export",    "extern",    "false",     "float",        "for",
      "friend",      "goto",     "if",        "inline",    "int",       "long",         "mutable",
      "namespace",   "new",      "noexcept",  "not",       "not_eq",    "nullptr",      "operator",
      "or",          "or_eq",    "private",   "protected", "public",    "register",     "reinterpret_cast",
      "requires",    "return",   "short",     "signed",    "sizeof",    "static",       "static_assert",
      "static_cast", "struct",   "switch",    "template",  "this",      "thread_local", "throw",
      "true",        "try",      "typedef",   "typeid",    "typename",  "union",        "unsigned",
      "using",       "virtual",  "void",      "volatile",  "wchar_t",   "while",        "xor",
      "xor_eq",      "std",      "secular",   "main",      "errno",     "assert",       "linux",
      "unix",        "stdin",    "stdout",    "stderr"};
  return keywords.count(name) != 0;
}

// NAN, M_PI, EOF: capitals only, too many for a symbol of physics.
bool looks_like_a_macro(const std::string& name) {
  const auto letters = std::count_if(name.begin(), name.end(), is_letter);
  const auto capitals = std::count_if(name.begin(), name.end(), is_upper);
  return letters == capitals && (letters > 2 || (letters > 1 && name.find('_') != std::string::npos));
}

// Names that belong to C++ (__x, _X) or that a "s_..._s" of another symbol could equal.
bool is_odd(const std::string& name) {
  return name.front() == '_' || name.find("__") != std::string::npos || name.rfind("s_", 0) == 0;
}

// omega0_2 is the square of omega0 and factor_0_1 a factor.
bool is_numbered(const std::string& name) {
  const std::size_t last = name.find_last_of('_');
  return last != std::string::npos && last + 1 < name.size() &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(last) + 1, name.end(), is_digit);
}

void require_identifier(const std::string& name) {
  const bool valid = !name.empty() && !is_digit(name.front()) && std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter(c) || is_digit(c) || c == '_';
  });
  if (!valid) throw std::logic_error("'" + name + "' reached the code generator without being an identifier");
}

// Those that generated code calls (estimator/model/scalar_functions.hpp).
bool is_scalar_function(const std::string& name) {
  static const std::set<std::string> functions = {"sin_of",  "cos_of",  "tan_of", "exp_of",  "sinh_of",
                                                  "cosh_of", "tanh_of", "log_of", "atan_of", "power_of"};
  return functions.contains(name);
}

std::string mangled(const std::string& name, bool clashes) {
  require_identifier(name);
  return clashes || is_scalar_function(name) || is_keyword(name) || is_odd(name) || looks_like_a_macro(name)
             ? "s_" + name + "_s"
             : name;
}

// What generated functions call their own.
const std::set<std::string> local_names = {"parameters",
                                           "gradient",
                                           "lump",
                                           "denominator",
                                           "data",
                                           "columns",
                                           "lumps",
                                           "jacobian",
                                           "amplitude",
                                           "forcing",
                                           "derivative",
                                           "excitation",
                                           "displacement",
                                           "force",
                                           "velocity",
                                           "acceleration",
                                           "mass",
                                           "Scalar",
                                           "Complex",
                                           "i",
                                           "rate",
                                           "derivatives",
                                           "evaluate_lumps",
                                           "integer_power",
                                           "abs",
                                           "accelerations",
                                           "solve_in_place",
                                           "excitation_frequency",
                                           "evaluate_lumps_jacobian",
                                           "modulation",
                                           "ExcitationSample",
                                           "BatchArrays",
                                           "root_of",
                                           "exchange_values",
                                           "natural_frequency",
                                           "factor",
                                           "factors",
                                           "Factors",
                                           "column",
                                           "row",
                                           "frequencies",
                                           "signals",
                                           "natural",
                                           "list",
                                           "coefficient",
                                           "coefficients",
                                           "by_coefficient",
                                           "by_conjugate",
                                           "slopes",
                                           "by",
                                           "Number",
                                           "NumberList",
                                           "Lumps",
                                           "Model",
                                           "Frequencies",
                                           "Signals",
                                           "modes",
                                           "excitations",
                                           "LumpGradients",
                                           "mode",
                                           "slope",
                                           "times_i",
                                           "conjugate",
                                           "load_complex",
                                           "store_complex",
                                           "parts_of",
                                           "absolute",
                                           "sign_of",
                                           "is_nonzero",
                                           "Parameter",
                                           "Sample",
                                           "inverse_or_zero",
                                           "fixed_power",
                                           "ComplexNumber",
                                           "mass_matrix",
                                           "modulus_of",
                                           "parameter",
                                           "add"};

// What generated files call their own.
const std::set<std::string> table_names = {"model",
                                           "cases",
                                           "symbols",
                                           "nominal",
                                           "coordinates",
                                           "excitations",
                                           "generated",
                                           "accelerations",
                                           "CompiledModel",
                                           "CompiledCase",
                                           "CompiledSymbol",
                                           "CompiledLump",
                                           "Ratio",
                                           "RegressorBlock",
                                           "BlockKind",
                                           "ModelFunction",
                                           "ExcitationSample",
                                           "ObservationBatch",
                                           "BatchArrays",
                                           "PlainBatch",
                                           "BlockShape",
                                           "BlockFunctions",
                                           "BlockTable",
                                           "GeneratedCase",
                                           "LumpFunctions",
                                           "LumpGradients",
                                           "NumberList",
                                           "Lumps",
                                           "Model",
                                           "coefficients",
                                           "follows_modes",
                                           "follows_excitation",
                                           "is_forced",
                                           "lump_values",
                                           "lump_jacobian",
                                           "modulation_functions",
                                           "harmonic_functions",
                                           "regressor_blocks",
                                           "chosen_lumps",
                                           "compiled_case",
                                           "call_lumps",
                                           "add_coefficient_slopes",
                                           "root_of",
                                           "exchange_values",
                                           "integer_power",
                                           "excitation_frequencies",
                                           "solve_in_place",
                                           "Scalar",
                                           "Complex",
                                           "compiled_models",
                                           "mass_matrix",
                                           "acceleration_by_state",
                                           "acceleration_by_parameters",
                                           "ComplexNumber",
                                           "DualNumber",
                                           "times_i",
                                           "conjugate",
                                           "norm_of",
                                           "modulus_of",
                                           "load_complex",
                                           "store_complex",
                                           "parts_of",
                                           "absolute",
                                           "sign_of",
                                           "is_nonzero",
                                           "Lanes",
                                           "LaneParameter",
                                           "LaneSample",
                                           "inverse_or_zero",
                                           "fixed_power",
                                           "find_compiled_model"};

}  // namespace

std::string safe_identifier(const std::string& symbol) {
  static constexpr std::string_view prefixes[] = {"A_",       "conj_", "norm_", "abs_", "unit_",
                                                  "inverse_", "by_",   "per_",  "over_"};
  const bool clashes = local_names.count(symbol) != 0 || is_numbered(symbol) ||
                       std::any_of(std::begin(prefixes), std::end(prefixes),
                                   [&](std::string_view p) { return symbol.starts_with(p); });
  return mangled(symbol, clashes);
}

std::string safe_namespace(const std::string& name) {
  return mangled(name, table_names.count(name) != 0 || name.starts_with("case_") || name.starts_with("lump_") ||
                           name.starts_with("dimension_"));
}

}  // namespace secular
