#pragma once

#include <cstddef>

/// Allocations of this program, from its start on.
std::size_t allocations();
