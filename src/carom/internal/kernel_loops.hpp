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

// `V`s of balls from i on, two at a time, so that one need not wait for the other.
template <class V, std::size_t vectors>
inline __attribute__((always_inline)) void advance_some(const Kernels::Motion& m, std::size_t i) {
  constexpr std::size_t each = sizeof(V) / sizeof(double);
  V x[vectors], y[vectors], vx[vectors], vy[vectors], fall[vectors];
  for (std::size_t k = 0; k < vectors; ++k) {
    read(x[k], m.x + i + k * each);
    read(y[k], m.y + i + k * each);
    read(vx[k], m.vx + i + k * each);
    read(vy[k], m.vy + i + k * each);
    if (m.ay != nullptr) {
      read(fall[k], m.ay + i + k * each);
      fall[k] = fall[k] * m.part;
    }
  }
  const double h = m.part;
  const double f = m.friction;
  if (m.ay != nullptr) {
    for (int step = 0; step < m.steps; ++step)
      for (int part = 1; part <= m.parts; ++part) {
        const double friction = part == m.parts ? f : 1.0;
        for (std::size_t k = 0; k < vectors; ++k) {
          x[k] += vx[k] * h;
          y[k] += vy[k] * h;
          vx[k] = vx[k] * friction;
          vy[k] = vy[k] * friction + fall[k];
        }
      }
  } else if (m.parts == 1) {
    for (int step = 0; step < m.steps; ++step)
      for (std::size_t k = 0; k < vectors; ++k) {
        x[k] += vx[k] * h;
        y[k] += vy[k] * h;
        vx[k] = vx[k] * f;
        vy[k] = vy[k] * f;
      }
  } else {
    for (int step = 0; step < m.steps; ++step)
      for (std::size_t k = 0; k < vectors; ++k) {
        const V along = vx[k] * h;
        const V up = vy[k] * h;
        for (int part = 0; part < m.parts; ++part) {
          x[k] += along;
          y[k] += up;
        }
        vx[k] = vx[k] * f;
        vy[k] = vy[k] * f;
      }
  }
  for (std::size_t k = 0; k < vectors; ++k) {
    write(x[k], m.x + i + k * each);
    write(y[k], m.y + i + k * each);
    write(vx[k], m.vx + i + k * each);
    write(vy[k], m.vy + i + k * each);
  }
}

void advance(const Kernels::Motion& m) {
  constexpr std::size_t block = 2 * lanes;
  constexpr std::uint64_t all = (std::uint64_t{1} << block) - 1;
  std::size_t i = 0;
  for (; i + block <= m.count; i += block)
    if ((m.moving >> i & all) != 0) advance_some<Doubles, 2>(m, i);
  if (i + lanes <= m.count) {
    if ((m.moving >> i & (all >> lanes)) != 0) advance_some<Doubles, 1>(m, i);
    i += lanes;
  }
  for (; i < m.count; ++i)
    if ((m.moving >> i & 1) != 0) advance_some<double, 1>(m, i);
}

}  // namespace
}  // namespace carom
