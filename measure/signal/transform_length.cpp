#include "measure/signal/transform_length.hpp"

namespace secular {
namespace {

bool fast(Eigen::Index length) {
  for (const Eigen::Index factor : {2, 3, 5})
    while (length % factor == 0) length /= factor;
  return length == 1;
}

}  // namespace

Eigen::Index padded_transform_length(Eigen::Index samples) {
  Eigen::Index length = samples < 1 ? 1 : samples;
  while (!fast(length)) ++length;
  return length;
}

Eigen::Index cut_transform_length(Eigen::Index samples) {
  Eigen::Index length = samples / 2 * 2;
  while (length > 2 && !fast(length)) length -= 2;
  return length;
}

}  // namespace secular
