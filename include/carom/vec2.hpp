#pragma once

#include <cfloat>
#include <cmath>

#include "carom/public.hpp"

// Every file of the engine includes this one: the same scene must give the same bits everywhere.
// arithmetic.hpp finds out at run time what compilers do not tell by a macro.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "carom must not be compiled with -ffast-math or a part of it"
#endif
#if FLT_EVAL_METHOD != 0
#error "carom needs arithmetic in plain binary64, without excess precision"
#endif

namespace CAROM_PUBLIC carom {

/// A vector of the plane, y pointing up (§1.1.1). Unit: px, px/s or px/s², as its use says.
struct Vec2 {
  double x = 0;
  double y = 0;

  constexpr Vec2& operator+=(Vec2 b) {
    x += b.x;
    y += b.y;
    return *this;
  }
  constexpr Vec2& operator-=(Vec2 b) {
    x -= b.x;
    y -= b.y;
    return *this;
  }

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  friend constexpr bool operator==(Vec2 a, Vec2 b) = default;
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double length_squared(Vec2 a) { return dot(a, a); }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// The unit vector along `a`; (1, 0) when `a` is zero (docs/physics.md#two-balls).
inline Vec2 unit(Vec2 a) {
  const double norm = length(a);
  return norm > 0 ? a / norm : Vec2{1, 0};
}

}  // namespace carom
