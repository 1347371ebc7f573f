#pragma once

// The parser asserts that strtod understands every number, which it does not in a locale whose
// decimal point takes two bytes (ps_AF). Numbers are read by from_chars here, so never mind.
#define JSON_ASSERT(condition) static_cast<void>(0)
#include <nlohmann/json.hpp>
