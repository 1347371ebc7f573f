#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "carom/scene.hpp"

/// Small worlds made of a fuzzer's input.
namespace small_world {

/// The input's bytes one after the other; zeros behind the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}
  bool over() const { return next_ == end_; }
  unsigned byte() { return over() ? 0 : *next_++; }
  double signed_byte() { return static_cast<std::int8_t>(byte()); }
  double word() { return byte() * 256 + byte(); }  // 0 to 65 535
  double signed_word() { return word() - 32768; }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

inline constexpr std::size_t most_balls =
    20;  // and most of them slow: millions of worlds are to be tried

inline double radius_of(unsigned byte) { return std::exp2(byte / 25.5); }  // 1 to 1024

// The same test as check()'s, which takes too long for each ball of millions of worlds.
inline bool stands_free(const carom::Scene& s, const carom::Ball& b) {
  const double x = b.position.x;
  const double y = b.position.y;
  const auto solid = [](carom::Edge edge) { return edge == carom::Edge::solid; };
  if ((solid(s.edges.left) && x - b.radius < 0) ||
      (solid(s.edges.right) && x + b.radius > s.width) ||
      (solid(s.edges.bottom) && y - b.radius < 0) ||
      (solid(s.edges.top) && y + b.radius > s.height))
    return false;
  return std::ranges::none_of(s.obstacles, [&](const carom::Obstacle& obstacle) {
    const double reach = obstacle.radius + b.radius;
    return y < obstacle.height
               ? std::abs(x - obstacle.x) < reach
               : carom::length(b.position - carom::Vec2{obstacle.x, obstacle.height}) < reach;
  });
}

inline carom::Ball ball(Bytes& bytes, const carom::Scene& s) {
  carom::Ball b;
  const unsigned kind = bytes.byte();
  carom::Ball last;
  last.position = {s.width / 2, s.height / 2};
  if (!s.balls.empty()) last = s.balls.back();
  switch (kind / 8 % 4) {
    case 0:
      b.radius = 10;
      break;
    case 1:
      b.radius = last.radius;
      break;
    case 2:  // the last diameter of a level of the tree, and the first of the next
      b.radius = last.radius / 2;
      break;
    default:
      b.radius = radius_of(bytes.byte());
  }
  b.radius = std::clamp(b.radius, 1.0, 1024.0);
  const double sum = last.radius + b.radius;
  // In order: an element of this list is evaluated before the next.
  switch (kind % 8) {
    case 0:
      b.position = carom::Vec2{bytes.word() / 65535 * s.width, bytes.word() / 65535 * s.height};
      break;
    case 1:  // upon each other
      b.position = last.position;
      break;
    case 2:  // overlapping by little, just in contact, touching, just not touching
      b.position = last.position + sum * carom::Vec2{1 + bytes.signed_byte() / 4096, 0};
      break;
    case 3:  // about there
      b.position = last.position + sum / 64 * carom::Vec2{bytes.signed_byte(), bytes.signed_byte()};
      break;
    case 4:  // on the sides of the tree's squares, if 10 px is the largest radius
      b.position = 26.0 * carom::Vec2{bytes.signed_byte(), bytes.signed_byte()};
      break;
    case 5:  // hardly there
      b.position = last.position + 0x1p-40 * carom::Vec2{bytes.signed_byte(), bytes.signed_byte()};
      break;
    case 6:  // outside
      b.position = carom::Vec2{bytes.signed_word(), bytes.signed_word()};
      break;
    default:  // far outside
      b.position = 30000 * carom::Vec2{bytes.signed_word(), bytes.signed_word()};
  }
  if (kind / 32 % 2 != 0) {
    const unsigned scale = bytes.byte();
    const double unit = scale == 255 ? 100 : scale / 64.0;
    b.velocity = unit * carom::Vec2{bytes.signed_byte(), bytes.signed_byte()};
  }
  if (kind / 64 % 2 != 0) b.solidity = 8.0 * bytes.byte();
  if (s.balls.empty() && kind / 128 != 0) b.role = carom::Role::cue;
  return b;
}

// A small sound world, whatever the bytes, that is hard on a broad phase.
inline carom::Scene scene(Bytes& bytes) {
  carom::Scene s;
  const unsigned edges = bytes.byte();
  const auto edge = [&](unsigned bit) {
    return (edges & bit) != 0 ? carom::Edge::open : carom::Edge::solid;
  };
  s.edges = {edge(1), edge(2), edge(4), edge(8)};
  if ((edges & 16) != 0) s.friction = 1;
  if ((edges & 32) != 0) s.gravity = 20.0 * bytes.byte();
  if ((edges & 64) != 0) s.damage_threshold = 4.0 * bytes.byte();
  s.width = 20 + 10.0 * bytes.byte();
  s.height = 20 + 10.0 * bytes.byte();
  const unsigned fixtures = bytes.byte();
  for (unsigned n = fixtures % 4; n > 0; --n) {
    const double x = bytes.byte() / 255.0 * s.width;
    const double y = bytes.byte() / 255.0 * s.height;
    s.holes.push_back({{x, y}, 1.0 + bytes.byte()});
  }
  for (unsigned n = fixtures / 4 % 4; n > 0; --n) {
    const double x = bytes.byte() / 255.0 * s.width;
    const double height = (bytes.byte() + 1) / 256.0 * s.height;
    s.obstacles.push_back({x, height, 1.0 + bytes.byte() / 4.0});
  }
  while (!bytes.over() && s.balls.size() < most_balls)
    if (const carom::Ball b = ball(bytes, s); stands_free(s, b)) s.balls.push_back(b);
  return s;
}

}  // namespace small_world
