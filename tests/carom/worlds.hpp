#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene.hpp"
#include "carom/world.hpp"

/// Small worlds for tests.
namespace worlds {

/// A world of the scene; a test that hands in a wrong scene fails here, loudly.
inline carom::World make(carom::Scene scene) {
  auto world = carom::World::create(std::move(scene));
  if (!world) throw std::invalid_argument(carom::to_string(world.errors().front()));
  return std::move(world).value();
}

inline carom::Ball ball(carom::Vec2 position, carom::Vec2 velocity = {}, double radius = 10) {
  carom::Ball made;
  made.position = position;
  made.velocity = velocity;
  made.radius = radius;
  return made;
}

/// A table of 800 × 400 px without holes.
inline carom::Scene table(std::vector<carom::Ball> balls) {
  carom::Scene scene;
  scene.balls = std::move(balls);
  return scene;
}

/// A level: gravity, a floor, open sides, no ceiling.
inline carom::Scene level(std::vector<carom::Ball> balls) {
  carom::Scene scene = table(std::move(balls));
  scene.gravity = 500;
  scene.edges = {.left = carom::Edge::open,
                 .right = carom::Edge::open,
                 .bottom = carom::Edge::solid,
                 .top = carom::Edge::open};
  return scene;
}

inline double energy(const carom::World& world) {
  double sum = 0;
  for (std::size_t i = 0; i < world.size(); ++i)
    if (world.in_play(i)) sum += carom::length_squared(world.ball(i).velocity);
  return sum;
}

inline carom::Vec2 momentum(const carom::World& world) {
  carom::Vec2 sum;
  for (std::size_t i = 0; i < world.size(); ++i)
    if (world.in_play(i)) sum += world.ball(i).velocity;
  return sum;
}

inline bool all_finite(const carom::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball b = world.ball(i);
    for (const double number : {b.position.x, b.position.y, b.velocity.x, b.velocity.y,
                                b.acceleration.x, b.acceleration.y})
      if (!std::isfinite(number)) return false;
  }
  return true;
}

}  // namespace worlds
