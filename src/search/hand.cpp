#include "search/hand.hpp"

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"

namespace search {

namespace {

double uniform(games::Random& random) { return random.uniform(0, 1); }

// True with probability e^(−x) for x in [0, 1], after von Neumann: falling uniform numbers below x,
// of which there is an even number.
bool survives(double x, games::Random& random) {
  bool even = true;
  for (double last = x;; even = !even) {
    const double next = uniform(random);
    if (next >= last) return even;
    last = next;
  }
}

// e^(−1/2) each; the whole part of the number has this distribution before it is rejected.
int survived_halves(games::Random& random) {
  int count = 0;
  while (survives(0.5, random)) ++count;
  return count;
}

bool survives_halves(int count, games::Random& random) {
  for (; count > 0; --count)
    if (!survives(0.5, random)) return false;
  return true;
}

// With probability e^(−x(2k+x)/2), as k+1 trials of a share each.
bool survives_fraction(int k, double x, games::Random& random) {
  const double share = x * (2 * k + x) / (2 * k + 2);
  for (int i = 0; i <= k; ++i)
    if (!survives(share, random)) return false;
  return true;
}

}  // namespace

double normal(games::Random& random) {
  const carom::ExactArithmetic exact;
  for (;;) {
    const int k = survived_halves(random);
    if (!survives_halves(k * (k - 1), random)) continue;
    const double x = uniform(random);
    if (!survives_fraction(k, x, random)) continue;
    return random.one_in(2) ? k + x : -(k + x);
  }
}

carom::Vec2 launched(carom::Vec2 meant, const Hand& hand, games::Random& random) {
  if (hand.exact()) return meant;
  const carom::ExactArithmetic exact;
  for (;;) {
    // The two directions are alike, so the axes do as well as the drag's own.
    const double x = normal(random);
    const double y = normal(random);
    const carom::Vec2 made = games::on_grid(meant + hand.error * carom::Vec2{x, y});
    if (made != carom::Vec2{}) return made;
  }
}

}  // namespace search
