#include <cstdint>

#include "carom/arithmetic.hpp"
#include "carom/fnv1a.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

void add_vector(Fnv1a& hash, Vec2 vector) {
  hash.add(vector.x);
  hash.add(vector.y);
}

}  // namespace

std::uint64_t World::state_hash() const {
  const ExactArithmetic exact;  // a subnormal number is not zero
  Fnv1a hash;
  hash.add(static_cast<std::uint8_t>(lead_out_));
  hash.add(static_cast<std::uint64_t>(balls_left()));
  for (std::size_t i = 0; i < size(); ++i) {
    if (!in_play(i)) continue;
    const Ball& b = ball(i);
    hash.add(b.id);
    hash.add(static_cast<std::uint8_t>(b.role));
    add_vector(hash, b.position);
    add_vector(hash, b.velocity);
    add_vector(hash, b.acceleration);
    hash.add(b.radius);
    hash.add(b.solidity);
  }
  return hash.hash();
}

}  // namespace carom
