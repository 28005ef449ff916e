#pragma once

// What most tests of numerical sources include, parsed once.

#include <gtest/gtest.h>

#include "cmake/precompiled/dense.hpp"
