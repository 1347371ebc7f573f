// The loops of Kernels for vectors of CAROM_LANES doubles. Included once by each file that makes a
// set, after all other headers, with the set's instructions switched on: so it has no header guard
// and includes nothing.

namespace carom {
namespace {

constexpr std::size_t lanes = CAROM_LANES;
constexpr std::size_t float_lanes = 2 * lanes;

using Doubles = double __attribute__((vector_size(8 * CAROM_LANES)));
using Floats = float __attribute__((vector_size(8 * CAROM_LANES)));
using Ints = std::int32_t __attribute__((vector_size(8 * CAROM_LANES)));

template <class V, class Number>
inline __attribute__((always_inline)) void read(V& v, const Number* from) {
  std::memcpy(&v, from, sizeof v);
}

template <class V, class Number>
inline __attribute__((always_inline)) void write(const V& v, Number* to) {
  std::memcpy(to, &v, sizeof v);
}

// The lanes that are true, as bits.
inline __attribute__((always_inline)) std::uint64_t lane_bits(const Ints& truth) {
#if defined(CAROM_MOVEMASK)
  return static_cast<std::uint64_t>(static_cast<unsigned>(CAROM_MOVEMASK(truth)));
#else
  std::uint64_t bits = 0;
  for (std::size_t lane = 0; lane < float_lanes; ++lane)
    bits |= static_cast<std::uint64_t>(truth[lane] & 1) << lane;
  return bits;
#endif
}

std::uint64_t may_meet(const Kernels::Discs& discs, const Kernels::Disc& one) {
  std::uint64_t found = 0;
  for (std::size_t j = 0; j < discs.count; j += float_lanes) {
    Floats dx, dy, far;
    read(dx, discs.x + j);
    read(dy, discs.y + j);
    read(far, discs.radius + j);
    dx -= one.x;
    dy -= one.y;
    far += one.radius;
    Floats du{};
    Floats dv{};
    if (discs.vx != nullptr) {
      read(du, discs.vx + j);
      read(dv, discs.vy + j);
    }
    du -= one.vx;
    dv -= one.vy;
    const Floats b = dx * du + dy * dv;
    const Floats a = du * du + dv * dv;
    const Floats c = dx * dx + dy * dy - far * far;
    // The discriminant's rounding is less than 12 units of the last place of b².
    const Ints may = ((b < 0) & (b * b * (1 + 0x1p-19F) >= a * c)) | (c <= 0);
    found |= lane_bits(may) << j;
  }
  return found;
}

std::uint64_t within(const Kernels::Discs& discs, const Kernels::Disc& one, float factor,
                     float slack) {
  std::uint64_t found = 0;
  for (std::size_t j = 0; j < discs.count; j += float_lanes) {
    Floats dx, dy, radius;
    read(dx, discs.x + j);
    read(dy, discs.y + j);
    read(radius, discs.radius + j);
    dx -= one.x;
    dy -= one.y;
    const Floats reach = (radius + one.radius) * factor + slack;
    const Ints near = dx * dx + dy * dy <= reach * reach;
    found |= lane_bits(near) << j;
  }
  return found;
}

void to_floats(const double* from, float* to, std::size_t count) {
  std::size_t i = 0;
#if defined(CAROM_TO_FLOATS)
  for (; i + lanes <= count; i += lanes) CAROM_TO_FLOATS(from + i, to + i);
#endif
  for (; i < count; ++i) to[i] = static_cast<float>(from[i]);
}

double least(const double* times, std::size_t count) {
  Doubles first;
  read(first, times);
  for (std::size_t i = lanes; i < count; i += lanes) {
    Doubles next;
    read(next, times + i);
    first = next < first ? next : first;
  }
  double one = first[0];
  for (std::size_t lane = 1; lane < lanes; ++lane) one = first[lane] < one ? first[lane] : one;
  return one;
}

std::uint64_t not_after(const double* times, std::size_t count, double now) {
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < count; ++i) found |= std::uint64_t{times[i] <= now} << i;
  return found;
}

// A vector that holds two quantities, along x and along y, of lanes / 2 balls.
constexpr std::size_t balls_each = lanes / 2;

inline __attribute__((always_inline)) Doubles gather(const double* x, const double* y,
                                                     const std::uint8_t* balls) {
#if CAROM_LANES == 4
  return Doubles{x[balls[0]], y[balls[0]], x[balls[1]], y[balls[1]]};
#else
  return Doubles{x[balls[0]], y[balls[0]]};
#endif
}

inline __attribute__((always_inline)) void scatter(const Doubles& both, double* x, double* y,
                                                   const std::uint8_t* balls) {
  for (std::size_t b = 0; b < balls_each; ++b) {
    x[balls[b]] = both[2 * b];
    y[balls[b]] = both[2 * b + 1];
  }
}

// Some vectors at a time, so that one need not wait for the other.
constexpr std::size_t most_vectors = 4;

template <std::size_t vectors, bool falls>
inline __attribute__((always_inline)) void advance_some(const Kernels::Motion& m,
                                                        const std::uint8_t* balls) {
  Doubles place[vectors], velocity[vectors], fall[vectors];
  for (std::size_t k = 0; k < vectors; ++k) {
    place[k] = gather(m.x, m.y, balls + k * balls_each);
    velocity[k] = gather(m.vx, m.vy, balls + k * balls_each);
    fall[k] = Doubles{};
    if (falls) fall[k] = gather(m.ax, m.ay, balls + k * balls_each) * m.part;
  }
  const double h = m.part;
  const double f = m.friction;
  if (falls) {
    for (int step = 0; step < m.steps; ++step)
      for (int part = 1; part <= m.parts; ++part) {
        const double friction = part == m.parts ? f : 1.0;
        for (std::size_t k = 0; k < vectors; ++k) {
          place[k] += velocity[k] * h;
          velocity[k] = velocity[k] * friction + fall[k];
        }
      }
  } else if (m.parts == 1) {
    for (int step = 0; step < m.steps; ++step)
      for (std::size_t k = 0; k < vectors; ++k) {
        place[k] += velocity[k] * h;
        velocity[k] = velocity[k] * f;
      }
  } else {
    for (int step = 0; step < m.steps; ++step)
      for (std::size_t k = 0; k < vectors; ++k) {
        const Doubles way = velocity[k] * h;
        for (int part = 0; part < m.parts; ++part) place[k] += way;
        velocity[k] = velocity[k] * f;
      }
  }
  for (std::size_t k = 0; k < vectors; ++k) {
    scatter(place[k], m.x, m.y, balls + k * balls_each);
    scatter(velocity[k], m.vx, m.vy, balls + k * balls_each);
  }
}

template <bool falls>
inline __attribute__((always_inline)) void advance_all(const Kernels::Motion& m) {
  std::uint8_t balls[64 + balls_each];
  std::size_t count = 0;
  for (std::uint64_t rest = m.balls; rest != 0; rest &= rest - 1)
    balls[count++] = static_cast<std::uint8_t>(__builtin_ctzll(rest));
  if (count == 0) return;
  // One is taken twice, to the same effect, where there is a place too many in the last vector.
  for (std::size_t k = 1; k < balls_each; ++k) balls[count + k - 1] = balls[count - 1];
  std::size_t left = (count + balls_each - 1) / balls_each;
  const std::uint8_t* next = balls;
  for (; left >= most_vectors; left -= most_vectors, next += most_vectors * balls_each)
    advance_some<most_vectors, falls>(m, next);
  if (left == 3) advance_some<3, falls>(m, next);
  if (left == 2) advance_some<2, falls>(m, next);
  if (left == 1) advance_some<1, falls>(m, next);
}

void advance(const Kernels::Motion& m) {
  if (m.ax != nullptr)
    advance_all<true>(m);
  else
    advance_all<false>(m);
}

}  // namespace
}  // namespace carom
