#include "search/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"

namespace search {

namespace {

using carom::Vec2;

constexpr int tries = 200;         // to find a free place
constexpr double thinnest = 0.17;  // cosine of the greatest cut, 80°
constexpr double slowest = 150;    // px/s
constexpr int longest_flight = 4 * carom::steps_per_second;

bool waits(const games::billiards::Game& game) {
  using games::billiards::Phase;
  return game.phase() == Phase::aim || game.phase() == Phase::place;
}
bool waits(const games::angry_balls::Game& game) {
  return game.phase() == games::angry_balls::Phase::aim;
}

}  // namespace

const carom::World& world_of(const Game& game) {
  return std::visit([](const auto& one) -> const carom::World& { return one.world(); }, game);
}

carom::Status check_waiting(const Game& game) {
  if (std::visit([](const auto& one) { return waits(one); }, game)) return carom::Done{};
  return carom::Error{.problem = "is not a game in which somebody is to shoot",
                      .expected = "a player who is to shoot, throw or place the cue ball"};
}

Candidates::Candidates(const Game& game, games::Random random)
    : game_(game), world_(world_of(game)), random_(random) {
  const carom::ExactArithmetic exact;
  const auto* table = std::get_if<games::billiards::Game>(&game);
  const carom::Role wanted = carom::Role::enemy;
  for (std::size_t i = 1; i < world_.size(); ++i)
    if (table != nullptr || world_.balls().role[i] == wanted) targets_.push_back(i);
  if (table == nullptr) {
    find_flights();
    return;
  }
  in_hand_ = table->phase() == games::billiards::Phase::place;
  if (in_hand_) {
    first_place_ = free_place();
    possible_ = first_place_.has_value();
  }
  pots_ = pots_from(in_hand_ ? std::nullopt : std::optional(world_.ball(0).position));
}

Shot Candidates::next() {
  const carom::ExactArithmetic exact;
  ++made_;
  return std::holds_alternative<games::billiards::Game>(game_) ? next_on_table() : next_in_level();
}

Shot Candidates::near(const Shot& shot, int tenths, int speed) {
  const auto within = [this](int most) {
    return static_cast<int>(below(static_cast<std::size_t>(2 * most + 1))) - most;
  };
  const int turn = within(tenths);
  const int strengthen = within(speed);
  Aim aim = turned(shot.aim, turn);
  aim.speed = std::clamp(aim.speed + strengthen, least_speed, greatest_speed);
  return {.place = shot.place, .aim = aim};
}

Shot Candidates::next_on_table() {
  if (made_ == 1) {
    const Vec2 from = in_hand_ ? *first_place_ : world_.ball(0).position;
    const Vec2 to = world_.ball(nearest_target(from)).position;
    return {.place = first_place_, .aim = nearest_aim(1000 * carom::unit(to - from))};
  }
  if (made_ % 2 == 0 && !pots_.empty()) {
    const Pot& pot = pots_[below(pots_.size())];
    if (in_hand_) return place_for(pot);
    return {.aim = nearest_aim(any_speed() * carom::unit(pot.ghost - world_.ball(0).position))};
  }
  Shot shot;
  if (in_hand_) shot.place = free_place().value_or(*first_place_);
  const Vec2 from = in_hand_ ? *shot.place : world_.ball(0).position;
  shot.aim = made_ % 8 == 7 ? any_aim() : strike(from);
  return shot;
}

// A target's any part, at any speed; a cushion may be first.
Aim Candidates::strike(Vec2 from) {
  const carom::Ball target = world_.ball(targets_[below(targets_.size())]);
  const Vec2 way = carom::unit(target.position - from);
  const double aside = random_.uniform(-1, 1) * (target.radius + world_.ball(0).radius);
  const Vec2 to = target.position + aside * Vec2{-way.y, way.x};
  return nearest_aim(any_speed() * carom::unit(to - from));
}

Aim Candidates::any_aim() {
  return {.tenths = static_cast<int>(below(3600)) - 1799, .speed = static_cast<int>(any_speed())};
}

// Fast shots meet more: their square is even.
double Candidates::any_speed() {
  const double least = slowest / games::max_launch_speed;
  return games::max_launch_speed * std::sqrt(random_.uniform(least * least, 1));
}

std::vector<Candidates::Pot> Candidates::pots_from(std::optional<Vec2> from) const {
  std::vector<Pot> pots;
  const double lead = world_.ball(0).radius;
  for (const std::size_t i : targets_)
    for (const carom::Hole& hole : world_.scene().holes) {
      const carom::Ball red = world_.ball(i);
      const Vec2 way = carom::unit(hole.position - red.position);
      const Vec2 ghost = red.position - (red.radius + lead) * way;
      if (from && dot(carom::unit(ghost - *from), way) < thinnest) continue;
      if (!clear(red.position, hole.position, i)) continue;
      if (from && !clear(*from, ghost, i)) continue;
      pots.push_back({.ghost = ghost, .way = way});
    }
  return pots;
}

// No ball but the lead and ball `but` stands between.
bool Candidates::clear(Vec2 from, Vec2 to, std::size_t but) const {
  const Vec2 way = carom::unit(to - from);
  const double far = carom::length(to - from);
  return std::ranges::none_of(targets_, [&](std::size_t i) {
    if (i == but) return false;
    const Vec2 at = world_.ball(i).position - from;
    const double along = dot(at, way);
    const double wide = world_.ball(i).radius + world_.ball(0).radius;
    return along > 0 && along < far && std::abs(cross(way, at)) < wide;
  });
}

// Behind the ghost ball, not far off the line.
Shot Candidates::place_for(const Pot& pot) {
  for (int i = 0; i < tries; ++i) {
    const Vec2 line =
        carom::unit(pot.way + random_.uniform(-0.5, 0.5) * Vec2{-pot.way.y, pot.way.x});
    const double far = random_.uniform(1, 10) * world_.ball(0).radius;
    const Vec2 place = games::on_grid(pot.ghost - far * line);
    if (!is_free(place)) continue;
    return {.place = place, .aim = nearest_aim(any_speed() * carom::unit(pot.ghost - place))};
  }
  return {.place = first_place_, .aim = strike(*first_place_)};
}

bool Candidates::is_free(Vec2 place) const {
  return std::get<games::billiards::Game>(game_).obstruction(place) ==
         games::billiards::Obstruction::none;
}

std::optional<Vec2> Candidates::free_place() {
  const carom::Scene& table = world_.scene();
  for (int i = 0; i < tries; ++i) {
    const double x = random_.uniform(0, table.width);
    const double y = random_.uniform(0, table.height);
    const Vec2 place = games::on_grid({x, y});
    if (is_free(place)) return place;
  }
  // Wherever a fine net finds one.
  constexpr int lines = 200;
  for (int row = 0; row <= lines; ++row)
    for (int column = 0; column <= lines; ++column) {
      const Vec2 place = games::on_grid({table.width * column / lines, table.height * row / lines});
      if (is_free(place)) return place;
    }
  return std::nullopt;
}

std::size_t Candidates::nearest_target(Vec2 from) const {
  return *std::ranges::min_element(targets_, {}, [&](std::size_t i) {
    return carom::length_squared(world_.ball(i).position - from);
  });
}

// At a part of an enemy, by the arc that is there after a number of steps, which friction and
// gravity leave linear in the first velocity. What is in the way does not count.
Shot Candidates::next_in_level() {
  if (made_ > 1 && made_ % 8 == 7) return {.aim = any_aim()};
  const Vec2 from = world_.ball(0).position;
  const carom::Ball target =
      world_.ball(made_ == 1 ? nearest_target(from) : targets_[below(targets_.size())]);
  const double reach = made_ == 1 ? 0 : target.radius + world_.ball(0).radius;
  const double across = random_.uniform(-1, 1) * reach;
  const double up = random_.uniform(-1, 1) * reach;
  const Vec2 to = target.position + Vec2{across, up} - from;
  const auto velocity = [&](const Flight& flight) {
    return (to + Vec2{0, flight.fall}) / flight.way;
  };
  const auto quickest = std::find_if(flights_.begin(), flights_.end(), [&](const Flight& flight) {
    return carom::length(velocity(flight)) <= games::max_launch_speed;
  });
  if (quickest == flights_.end()) return {.aim = any_aim()};
  // Quick ones are more often good: the longer, the rarer.
  const double part = made_ == 1 ? 0 : random_.uniform(0, 1);
  const auto longer = static_cast<double>(flights_.end() - quickest);
  const Flight& flight = quickest[static_cast<std::ptrdiff_t>(part * part * longer)];
  const Vec2 launch = velocity(flight);
  return {.aim = launch == Vec2{} ? any_aim() : nearest_aim(launch)};
}

void Candidates::find_flights() {
  const carom::Scene& scene = world_.scene();
  double kept = 1;  // of the first velocity
  double falling = 0;
  Flight flight;
  flights_.reserve(longest_flight);
  for (int step = 0; step < longest_flight; ++step) {
    kept *= scene.friction;
    falling = (falling + scene.gravity * carom::time_step) * scene.friction;
    flight.way += kept * carom::time_step;
    flight.fall += falling * carom::time_step;
    flights_.push_back(flight);
  }
}

}  // namespace search
