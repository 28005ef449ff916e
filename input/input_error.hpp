#pragma once

#include <stdexcept>
#include <string>

namespace secular {

/// Bad input from outside: a file, an option, a value. Ends the program with status 2 and one message that says
/// where it is, what is wrong and what would be right.
class InputError : public std::runtime_error {
 public:
  /// file: path or option the input came from; place: "line 12", "line 3, column 7", "[[channel]] 2, key unit", or
  /// empty; wrong: what is wrong; right: what would be right (may be empty when `wrong` says it all).
  InputError(std::string file, std::string place, std::string wrong, std::string right = {});

  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }
  const std::string& wrong() const { return wrong_; }
  const std::string& right() const { return right_; }

 private:
  std::string file_, place_, wrong_, right_;
};

}  // namespace secular
