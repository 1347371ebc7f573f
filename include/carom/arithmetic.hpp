#pragma once

#include <cstdint>

#if defined(__SSE2__) && !defined(__EMSCRIPTEN__)
#include <xmmintrin.h>
#elif !defined(__aarch64__) && !defined(__EMSCRIPTEN__)
#include <cfenv>
#endif

#include "carom/public.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

/// While one of these lives, this thread computes as IEEE-754 says by default: rounded to nearest,
/// with subnormal numbers, without traps. Other libraries may have set something else (a part
/// linked with -Ofast does); afterwards that is set again. Every function of the library whose
/// result depends on it makes one; a program that computes with the library's numbers may, too.
/// Costs a read of the control register.
class ExactArithmetic {
 public:
  ExactArithmetic() : before_(control()) {
    if ((before_ & ~ignored) != standard) [[unlikely]]
      set_control(standard);
  }
  ~ExactArithmetic() {
    if ((before_ & ~ignored) != standard) [[unlikely]]
      set_control(before_);
  }
  ExactArithmetic(const ExactArithmetic&) = delete;
  ExactArithmetic& operator=(const ExactArithmetic&) = delete;

 private:
#if defined(__SSE2__) && !defined(__EMSCRIPTEN__)
  using Control = std::uint32_t;
  static constexpr Control ignored = 0x3f;     // flags of what has happened
  static constexpr Control standard = 0x1f80;  // all exceptions masked, nearest, no FTZ, no DAZ
  static Control control() { return _mm_getcsr(); }
  static void set_control(Control control) {
    // Nothing is computed before that should come after, or the other way round.
    asm volatile("" ::: "memory");
    _mm_setcsr(control);
    asm volatile("" ::: "memory");
  }
#elif defined(__aarch64__)
  using Control = std::uint64_t;
  static constexpr Control ignored = ~(Control{0x7} << 22 | Control{0x9f} << 8 | Control{0x7});
  static constexpr Control standard = 0;  // nearest, no flush to zero, no traps
  static Control control() {
    Control control;
    asm volatile("mrs %0, fpcr" : "=r"(control));
    return control;
  }
  static void set_control(Control control) {
    asm volatile("msr fpcr, %0" ::"r"(control) : "memory");
  }
#elif defined(__EMSCRIPTEN__)  // WebAssembly has nothing to set
  using Control = int;
  static constexpr Control ignored = 0;
  static constexpr Control standard = 0;
  static Control control() { return standard; }
  static void set_control(Control) {}
#else
  using Control = int;
  static constexpr Control ignored = 0;
  static constexpr Control standard = FE_TONEAREST;
  static Control control() { return std::fegetround(); }
  static void set_control(Control control) { std::fesetround(control); }
#endif

  const Control before_;
};

}  // namespace carom
