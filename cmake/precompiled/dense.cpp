#include <Eigen/Dense>

#include "cmake/precompiled/dense_instances.hpp"

#define SECULAR_INSTANCE template
SECULAR_DENSE_INSTANCES
