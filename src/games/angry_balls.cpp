#include "games/angry_balls.hpp"

#include <algorithm>
#include <utility>

#include "carom/scene_file.hpp"
#include "games/launch.hpp"

namespace games::angry_balls {

carom::Errors check_level(const carom::Scene& scene) {
  carom::Errors errors;
  if (scene.balls.empty() || scene.balls[0].role != carom::Role::projectile)
    errors.push_back({.pointer = "/balls",
                      .problem = carom::MessageCode::has_no_projectile,
                      .expected = carom::MessageCode::first_ball_projectile});
  if (std::ranges::count(scene.balls, carom::Role::enemy, &carom::Ball::role) == 0)
    errors.push_back({.pointer = "/balls",
                      .problem = carom::MessageCode::has_no_enemy,
                      .expected = carom::MessageCode::some_enemy});
  return errors;
}

carom::Result<carom::Scene> read_level(std::string_view json) {
  auto scene = carom::read_scene(json);
  if (!scene) return scene;
  carom::Errors errors = check_level(scene.value());
  if (!errors.empty()) return carom::locate(json, std::move(errors));
  return scene;
}

carom::Result<Game> Game::create(carom::Scene level) {
  auto world = carom::World::create(level);
  if (!world) return world.errors();
  carom::Errors errors = check_level(level);
  if (!errors.empty()) return errors;
  return Game(std::move(level), std::move(world).value());
}

Game::Game(carom::Scene level, carom::World world)
    : level_(std::move(level)), world_(std::move(world)), throws_left_(level_.throws) {}

carom::Status Game::apply(const Command& command) {
  if (const auto* shot = std::get_if<Throw>(&command)) return launch(shot->drag);
  if (std::holds_alternative<Next>(command)) return next();
  *this = Game(level_, carom::World::create(level_).value());
  return carom::Done{};
}

carom::Status Game::launch(carom::Vec2 drag) {
  if (phase_ != Phase::aim)
    return carom::Error{.pointer = "throw",
                        .problem = carom::MessageCode::is_out_of_turn,
                        .expected = carom::MessageCode::projectile_ready};
  if (carom::Status launched = games::launch(world_, drag); !launched) return launched;
  events_.clear();
  physics_.clear();
  phase_ = Phase::fly;
  --throws_left_;
  turn_balls_ = 0;
  turn_steps_ = 0;
  return carom::Done{};
}

carom::Status Game::next() {
  if (phase_ != Phase::offer)
    return carom::Error{.pointer = "next",
                        .problem = carom::MessageCode::is_out_of_turn,
                        .expected = carom::MessageCode::throw_at_rest};
  if (throws_left_ > 0)
    if (carom::Status placed = world_.place_lead(launch_place()); !placed) return placed;
  events_.clear();
  physics_.clear();
  phase_ = throws_left_ > 0 ? Phase::aim : Phase::lost;
  if (phase_ == Phase::lost) events_.push_back({.kind = EventKind::lost});
  return carom::Done{};
}

int Game::enemies_left() const {
  int count = 0;
  for (std::size_t i = 0; i < world_.size(); ++i)
    if (world_.ball(i).role == carom::Role::enemy) ++count;
  return count;
}

void Game::step() { run(1); }

std::uint64_t Game::run(std::uint64_t most) {
  events_.clear();
  physics_.clear();
  if ((phase_ != Phase::fly && phase_ != Phase::offer) || most == 0) return 0;
  // A slow throw takes one step before it is asked whether all rests.
  const bool waits_for_rest = phase_ == Phase::fly && !world_.at_rest();
  const std::uint64_t left = phase_ == Phase::offer ? most
                             : waits_for_rest       ? offer_steps - turn_steps_
                                                    : 1;
  std::uint64_t seen = 0;
  const carom::RunEnd end = world_.run(
      {.rest = waits_for_rest,
       .events = carom::EventKind::destroyed | carom::EventKind::left | carom::EventKind::pocketed},
      std::min(most, left), [&](std::uint64_t step, std::span<const carom::Event> happened) {
        seen = step;
        physics_.assign(happened.begin(), happened.end());
      });
  if (seen != world_.steps()) physics_.clear();
  turn_steps_ += end.steps;
  score_lost_balls();
  if (enemies_left() == 0) {
    phase_ = Phase::won;
    events_.push_back({.kind = EventKind::won});
  } else if (phase_ == Phase::fly && (world_.at_rest() || turn_steps_ >= offer_steps)) {
    phase_ = Phase::offer;
    events_.push_back({.kind = EventKind::offered});
  }
  return end.steps;
}

// Every ball but the projectile counts, in the order in which they go (§2.3.1).
void Game::score_lost_balls() {
  for (const carom::Event& event : physics_) {
    const bool gone = event.kind == carom::EventKind::destroyed ||
                      event.kind == carom::EventKind::left ||
                      event.kind == carom::EventKind::pocketed;
    if (!gone || event.ball == 0) continue;
    const std::int64_t points = points_for(++turn_balls_);
    score_ += points;
    events_.push_back({.kind = EventKind::scored,
                       .ball = event.ball,
                       .points = points,
                       .position = event.position});
  }
}

}  // namespace games::angry_balls
