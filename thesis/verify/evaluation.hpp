#pragma once

#include <cln/exception.h>
#include <ginac/ginac.h>

#include <stdexcept>

#include "input/input_error.hpp"
#include "perturb/expression.hpp"

namespace secular::verify {

/// What `work` makes of a user's formula. What algebra refuses there (a pole, a number out of range, a function
/// that is not rational) is the formula's fault: InputError at its first line. A wrong call stays a logic error.
template <typename Work>
auto evaluated(const FormulaSource& source, const Work& work) {
  const auto refuse = [&](const char* why) {
    fail_at(source, {source.first_line, 1}, std::string("cannot be evaluated: ") + why,
            "a formula that has a value for every value of its symbols but single ones");
  };
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const std::domain_error& error) {  // GiNaC::pole_error among them
    refuse(error.what());
  } catch (const std::runtime_error& error) {  // of CLN and GiNaC: overflow, range
    refuse(error.what());
  }
  return decltype(work())();
}

}  // namespace secular::verify
