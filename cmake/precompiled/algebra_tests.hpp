#pragma once

// What most tests of symbolic sources include, parsed once.

#include <gtest/gtest.h>

#include "cmake/precompiled/algebra.hpp"
