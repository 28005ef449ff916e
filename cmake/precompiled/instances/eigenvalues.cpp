#include "cmake/precompiled/dense.hpp"

#define SECULAR_INSTANCE template
#include "cmake/precompiled/instances/eigenvalues.inc"
