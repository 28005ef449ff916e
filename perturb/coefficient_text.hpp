#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

namespace secular {

// Text of coefficients by the symbols' names: GiNaC's own order changes from run to run.

/// "omega0^2*k". Nothing for what is no product of numbers and powers of symbols.
std::optional<std::string> monomial_text(const GiNaC::ex& monomial);

/// The terms of a sum that is multiplied out, sorted. Nothing if one is no monomial.
std::optional<std::vector<std::string>> sum_terms(const GiNaC::ex& sum);

/// "k + omega0^2" of terms, as model text; "0" without any.
std::string joined_terms(const std::vector<std::string>& terms);

/// As model text, over one denominator. Of rational functions of symbols alone.
std::string rational_text(const GiNaC::ex& value);

}  // namespace secular
