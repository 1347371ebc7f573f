#include <cstdint>
#include <cstring>

#include "carom/internal/kernels.hpp"

// Compiled for AVX2 on any x86-64, and called only where the processor has it. All other headers
// come first: no function of theirs may be compiled for it, since the linker keeps one of each.
#ifdef __x86_64__
#include <immintrin.h>

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#define CAROM_LANES 4
#define CAROM_MOVEMASK(truth) _mm256_movemask_ps(__builtin_bit_cast(__m256, truth))
#define CAROM_TO_FLOATS(from, to) _mm_storeu_ps(to, _mm256_cvtpd_ps(_mm256_loadu_pd(from)))
#include "carom/internal/kernel_loops.hpp"

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

namespace carom {

const Kernels* avx2_kernels() {
#ifdef __x86_64__
  static constexpr Kernels wide{"AVX2", may_meet, within, to_floats, least, not_after, advance};
  return __builtin_cpu_supports("avx2") ? &wide : nullptr;
#else
  return nullptr;
#endif
}

}  // namespace carom
