#pragma once

#include <cmath>
#include <cstdint>

#include "carom/scene.hpp"
#include "games/random.hpp"

/// Random scenes that are hard on a broad phase: crowds, heaps on one spot, radii from 1 to 1000,
/// balls far outside, everything at rest or very fast.
namespace random_worlds {

using Numbers = games::Random;

/// A sound scene with up to `most` balls.
inline carom::Scene scene(std::uint64_t seed, std::size_t most) {
  Numbers n(seed);
  carom::Scene s;
  const bool narrow = n.one_in(8);
  s.width = narrow ? 60 : n.uniform(200, 3000);
  s.height = n.uniform(100, 2000);
  s.friction = n.one_in(2) ? 1 : n.uniform(0.9, 1);
  if (n.one_in(2)) s.gravity = n.uniform(1, 2000);
  const auto edge = [&] { return n.one_in(3) ? carom::Edge::open : carom::Edge::solid; };
  s.edges = {edge(), edge(), edge(), edge()};
  s.damage_threshold = n.one_in(2) ? 0 : n.uniform(0, 500);
  for (std::uint64_t k = n.one_in(3) ? n.below(7) : 0; k > 0; --k)
    s.holes.push_back({{n.uniform(0, s.width), n.uniform(0, s.height)}, n.uniform(5, 60)});
  for (std::uint64_t k = n.one_in(3) ? n.below(4) : 0; k > 0; --k)
    s.obstacles.push_back({n.uniform(0, s.width), n.uniform(1, s.height), n.uniform(1, 40)});

  enum class Radii : std::uint8_t { equal, like_billiards, mixed, wild };
  const auto radii = static_cast<Radii>(n.below(4));
  const auto radius = [&]() -> double {
    switch (radii) {
      case Radii::equal:
        return 10;
      case Radii::like_billiards:
        return n.one_in(5) ? 8 : 10;
      case Radii::mixed:
        return n.uniform(3, 25);
      case Radii::wild:  // as many of each order of magnitude
        return std::pow(10, n.uniform(0, n.one_in(6) ? 3 : 1.7));
    }
    return 10;
  };
  const double top_speed = n.one_in(5) ? 0 : n.one_in(5) ? 20000 : n.uniform(10, 1500);
  const std::size_t count = 1 + n.below(most);
  const bool heaps = n.one_in(5);
  const bool crowd = n.one_in(3);
  const carom::Scene empty = s;
  carom::Vec2 heap{n.uniform(0, s.width), n.uniform(0, s.height)};
  for (std::size_t tries = 0; s.balls.size() < count && tries < 4 * count; ++tries) {
    carom::Ball b;
    b.radius = radius();
    const double spread = crowd ? 0.3 : 1;
    b.position = {n.uniform(0, spread * s.width), n.uniform(0, spread * s.height)};
    if (heaps) {
      if (n.one_in(10)) heap = b.position;
      b.position = heap;
    }
    if (n.one_in(25)) b.position = {n.uniform(-1e4, 1e4), n.uniform(-1e4, 1e4)};
    if (n.one_in(200)) b.position = {n.uniform(-1e9, 1e9), n.uniform(-1e9, 1e9)};
    if (n.one_in(4)) b.position = {std::round(b.position.x), std::round(b.position.y)};
    b.velocity = {n.uniform(-top_speed, top_speed), n.uniform(-top_speed, top_speed)};
    if (n.one_in(3)) b.solidity = n.uniform(0, 4000);
    if (s.balls.empty() && n.one_in(2)) b.role = carom::Role::cue;
    // What sticks out of a solid edge or into an obstacle would be refused.
    carom::Scene alone = empty;
    alone.balls = {b};
    if (carom::check(alone).empty()) s.balls.push_back(b);
  }
  while (!carom::check(s).empty()) s.balls.resize(s.balls.size() / 2);  // too much of a heap
  return s;
}

}  // namespace random_worlds
