#pragma once

// What most numerical sources include, parsed once; and Eigen's decompositions, which cost a compiler many seconds
// each wherever they stand, compiled once in instances/. No source relies on this file: each includes what it uses.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#define SECULAR_INSTANCE extern template
#include "cmake/precompiled/instances/eigenvalues.inc"
#include "cmake/precompiled/instances/factorizations.inc"
#include "cmake/precompiled/instances/householder.inc"
#include "cmake/precompiled/instances/products.inc"
#include "cmake/precompiled/instances/singular_values.inc"
#include "cmake/precompiled/instances/triangular.inc"
#undef SECULAR_INSTANCE
