#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// Lets the fuzzer keep its input as a finding.
inline void require(bool held, const char* what) {
  if (held) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace fuzz
