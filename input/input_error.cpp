#include "input/input_error.hpp"

#include <utility>

namespace secular {
namespace {

std::string message(const std::string& file, const std::string& place, const std::string& wrong,
                    const std::string& right) {
  std::string text = file;
  if (!place.empty()) text += (text.empty() ? "" : ", ") + place;
  if (!text.empty()) text += ": ";
  text += wrong;
  if (!right.empty()) text += "; " + right;
  return text;
}

}  // namespace

InputError::InputError(std::string file, std::string place, std::string wrong, std::string right)
    : std::runtime_error(message(file, place, wrong, right)),
      file_(std::move(file)),
      place_(std::move(place)),
      wrong_(std::move(wrong)),
      right_(std::move(right)) {}

}  // namespace secular
