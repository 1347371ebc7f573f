#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "carom/result.hpp"
#include "carom/vec2.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/random.hpp"
#include "search/simulation.hpp"

namespace search {

using Game = std::variant<games::billiards::Game, games::angry_balls::Game>;

const carom::World& world_of(const Game& game);

/// Refuses a game whose player is not to shoot, throw or place.
carom::Status check_waiting(const Game& game);

/// Shots that are worth a simulation: half from geometry (direct pots, arcs that hit an enemy),
/// half at random directions and parts of what is to be hit. All are ones that the game takes.
class Candidates {
 public:
  /// `game` is one whose player is to shoot, throw or place, and outlives this.
  Candidates(const Game& game, games::Random random);

  /// There is a place for the cue ball, if it is in hand.
  bool possible() const { return possible_; }
  /// The next one. The first aims straight at the nearest ball to be hit.
  Shot next();
  /// One that differs from `shot` by at most so many tenths of a degree and px/s.
  Shot near(const Shot& shot, int tenths, int speed);

 private:
  struct Pot {
    carom::Vec2 ghost{};  ///< px, where the cue ball meets the red
    carom::Vec2 way{};    ///< the red's to the hole, a unit vector
  };

  /// The place of a throw's ball after some steps: it is `way` times its first velocity on, and
  /// fell so far.
  struct Flight {
    double way = 0;   ///< s
    double fall = 0;  ///< px
  };

  void find_flights();
  Shot next_on_table();
  Shot next_in_level();
  Aim any_aim();
  Aim strike(carom::Vec2 from);
  Shot place_for(const Pot& pot);
  std::vector<Pot> pots_from(std::optional<carom::Vec2> from) const;
  bool clear(carom::Vec2 from, carom::Vec2 to, std::size_t but) const;
  std::optional<carom::Vec2> free_place();
  bool is_free(carom::Vec2 place) const;
  std::size_t nearest_target(carom::Vec2 from) const;
  double any_speed();
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_.below(count)); }

  const Game& game_;
  const carom::World& world_;
  games::Random random_;
  bool in_hand_ = false;
  bool possible_ = true;
  std::vector<std::size_t> targets_;  ///< indices of reds or enemies
  std::vector<Pot> pots_;
  std::vector<Flight> flights_;  ///< by steps
  std::optional<carom::Vec2> first_place_;
  std::uint64_t made_ = 0;
};

}  // namespace search
