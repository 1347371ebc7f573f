#pragma once

#include "carom/vec2.hpp"
#include "games/random.hpp"

namespace search {

/// A player's precision: the error of the drag, Gaussian along it and across it, alike.
struct Hand {
  /// px of drag in the world, the standard deviation of each; 1 px is 5 px/s. 0: exact, as a player
  /// is who types the numbers.
  double error = 0;

  bool exact() const { return error <= 0; }
  friend bool operator==(const Hand&, const Hand&) = default;
};

/// A number from the standard normal distribution, with the same bits everywhere: algorithm N of C.
/// F. F. Karney, "Sampling exactly from the normal distribution" (ACM TOMS 42, 2016), on numbers of
/// 53 bits. It needs no logarithm.
double normal(games::Random& random);

/// The drag that the hand makes of the one that is meant: on the grid, not zero.
carom::Vec2 launched(carom::Vec2 meant, const Hand& hand, games::Random& random);

}  // namespace search
