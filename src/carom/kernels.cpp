#include "carom/internal/kernels.hpp"

#include <cstdint>
#include <cstring>

#include "carom/version.hpp"

#ifdef __SSE2__
#include <emmintrin.h>
#define CAROM_MOVEMASK(truth) _mm_movemask_ps(__builtin_bit_cast(__m128, truth))
#define CAROM_TO_FLOATS(from, to) \
  _mm_storel_pd(reinterpret_cast<double*>(to), _mm_castps_pd(_mm_cvtpd_ps(_mm_loadu_pd(from))))
#endif

#define CAROM_LANES 2
#include "carom/internal/kernel_loops.hpp"

namespace carom {

const Kernels& plain_kernels() {
#ifdef __SSE2__
  static constexpr Kernels plain{"SSE2", may_meet, within, to_floats, least, not_after, advance};
#else
  static constexpr Kernels plain{"portable", may_meet,  within, to_floats,
                                 least,      not_after, advance};
#endif
  return plain;
}

const Kernels& kernels() {
  static const Kernels* const widest =
      avx2_kernels() != nullptr ? avx2_kernels() : &plain_kernels();
  return *widest;
}

const char* vector_instructions() { return kernels().name; }

const char* library_version() { return CAROM_VERSION; }

}  // namespace carom
