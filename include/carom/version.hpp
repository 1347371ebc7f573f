#pragma once

#include "carom/public.hpp"

// The one place of the version: the build files, the programs and the packages read it here.
#define CAROM_VERSION_MAJOR 0
#define CAROM_VERSION_MINOR 1
#define CAROM_VERSION_PATCH 0
#define CAROM_VERSION "0.1.0"

namespace CAROM_PUBLIC carom {

/// CAROM_VERSION of the library that was linked. It fits headers whose first two numbers are the
/// same.
const char* library_version();

/// A new number whenever a step gives other bits than before: no replay of the old number can be
/// played any more. tests/replays holds replays that tell when this is due.
inline constexpr int physics_version = 1;
/// The same for the rules of both games (phases, points, when a turn ends).
inline constexpr int rules_version = 1;

/// The vector instructions that steps are computed with on this machine: "AVX2", "SSE2", or
/// "portable" for what the compiler makes of the others'. The bits are the same with all.
const char* vector_instructions();

}  // namespace carom
