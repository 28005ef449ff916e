#include "measure/modal/residue_conversion.hpp"

#include <stdexcept>

namespace secular {

using Complex = std::complex<double>;

ResponseForm response_form(Quantity quantity) {
  switch (quantity) {
    case Quantity::acceleration:
      return ResponseForm::accelerance;
    case Quantity::velocity:
      return ResponseForm::mobility;
    case Quantity::displacement:
    case Quantity::angle:
    case Quantity::strain:
      return ResponseForm::receptance;
    default:
      throw std::invalid_argument("response_form: a " + to_string(quantity) + " is no motion");
  }
}

Complex convert_residue(Complex residue, Complex pole, ResponseForm from, ResponseForm to) {
  for (int i = static_cast<int>(from); i < static_cast<int>(to); ++i) residue *= pole;
  for (int i = static_cast<int>(to); i < static_cast<int>(from); ++i) residue /= pole;
  return residue;
}

}  // namespace secular
