#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/public.hpp"
#include "carom/scene.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

/// A world's balls, to read (World::balls()): one array per quantity with one entry per ball, in
/// index order, with the meaning and unit of Ball's field of that name. A loop over one quantity of
/// all balls reads nothing else, and the compiler can take several balls at a time. Nothing can be
/// written through it.
struct BallsView {
  std::span<const double> x;       ///< px
  std::span<const double> y;       ///< px
  std::span<const double> vx;      ///< px/s
  std::span<const double> vy;      ///< px/s
  std::span<const double> ax;      ///< px/s²
  std::span<const double> ay;      ///< px/s²
  std::span<const double> radius;  ///< px
  std::span<const double> solidity;
  std::span<const std::uint32_t> id;
  std::span<const Role> role;

  std::size_t size() const { return x.size(); }
  /// The ball at an index < size().
  Ball operator[](std::size_t i) const {
    return {.id = id[i],
            .role = role[i],
            .position = position(i),
            .velocity = velocity(i),
            .acceleration = acceleration(i),
            .radius = radius[i],
            .solidity = solidity[i]};
  }
  Vec2 position(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 velocity(std::size_t i) const { return {vx[i], vy[i]}; }
  Vec2 acceleration(std::size_t i) const { return {ax[i], ay[i]}; }
};

/// The storage of a world's balls, which only the world writes.
struct Balls {
  std::vector<double> x;       ///< px
  std::vector<double> y;       ///< px
  std::vector<double> vx;      ///< px/s
  std::vector<double> vy;      ///< px/s
  std::vector<double> ax;      ///< px/s²
  std::vector<double> ay;      ///< px/s²
  std::vector<double> radius;  ///< px
  std::vector<double> solidity;
  std::vector<std::uint32_t> id;
  std::vector<Role> role;

  std::size_t size() const { return x.size(); }
  BallsView view() const { return {x, y, vx, vy, ax, ay, radius, solidity, id, role}; }
  /// The ball at an index < size().
  Ball operator[](std::size_t i) const { return view()[i]; }
  Vec2 position(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 velocity(std::size_t i) const { return {vx[i], vy[i]}; }
  Vec2 acceleration(std::size_t i) const { return {ax[i], ay[i]}; }

  void set_position(std::size_t i, Vec2 to) {
    x[i] = to.x;
    y[i] = to.y;
  }
  void set_velocity(std::size_t i, Vec2 to) {
    vx[i] = to.x;
    vy[i] = to.y;
  }
  void set_acceleration(std::size_t i, Vec2 to) {
    ax[i] = to.x;
    ay[i] = to.y;
  }

  void reserve(std::size_t count);
  void push_back(const Ball& ball);
  /// Puts the last ball in the place of ball i and drops the last place.
  void swap_out(std::size_t i);
};

}  // namespace carom
