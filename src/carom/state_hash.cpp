#include <bit>
#include <cstdint>

#include "carom/world.hpp"

namespace carom {

namespace {

/// FNV-1a, 64 bits, fed with little-endian numbers.
class Fnv1a {
 public:
  template <class Unsigned>
  void add(Unsigned number) {
    for (std::size_t byte = 0; byte < sizeof(Unsigned); ++byte) {
      hash_ ^= static_cast<std::uint64_t>(number >> (8 * byte)) & 0xff;
      hash_ *= 0x100000001b3;
    }
  }
  // Adding 0.0 turns -0.0, whose sign says nothing, into 0.0 and changes no other number.
  void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }
  void add(Vec2 vector) {
    add(vector.x);
    add(vector.y);
  }

  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace

std::uint64_t World::state_hash() const {
  Fnv1a hash;
  hash.add(static_cast<std::uint8_t>(lead_out_));
  hash.add(static_cast<std::uint64_t>(balls_left()));
  for (std::size_t i = 0; i < size(); ++i) {
    if (!in_play(i)) continue;
    const Ball& b = ball(i);
    hash.add(b.id);
    hash.add(static_cast<std::uint8_t>(b.role));
    hash.add(b.position);
    hash.add(b.velocity);
    hash.add(b.acceleration);
    hash.add(b.radius);
    hash.add(b.solidity);
  }
  return hash.hash();
}

}  // namespace carom
