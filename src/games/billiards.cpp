#include "games/billiards.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"

namespace games::billiards {

namespace {

carom::Error refusal(std::string what, carom::MessageCode problem, carom::MessageCode expected) {
  return {.pointer = std::move(what), .problem = problem, .expected = expected};
}

/// The cue ball met another ball: all others are reds.
bool touches_red(std::span<const carom::Event> happened) {
  return std::ranges::any_of(happened, [](const carom::Event& event) {
    return event.kind == carom::EventKind::pair && (event.ball == 0 || event.other == 0);
  });
}

}  // namespace

carom::Scene rack(Rack kind) {
  const carom::ExactArithmetic exact;
  carom::Scene scene;
  scene.name = "Billiards";
  const double inset = carom::default_radius;
  for (const double y : {inset, scene.height - inset})
    for (const double x : {inset, scene.width / 2, scene.width - inset})
      scene.holes.push_back({.position = {x, y}});

  scene.balls.push_back(
      {.role = carom::Role::cue, .position = cue_start, .radius = carom::default_cue_radius});
  const double spacing = 1.01 * 2 * carom::default_radius;
  const double row_distance = spacing * (std::sqrt(3.0) / 2);
  for (int row = 0; row < rows_of(kind); ++row)
    for (int n = 0; n <= row; ++n)
      scene.balls.push_back(
          {.role = carom::Role::red,
           .position = apex_start + carom::Vec2{row * row_distance, (n - row / 2.0) * spacing}});
  return scene;
}

carom::Errors check_table(const carom::Scene& scene) {
  if (!scene.balls.empty() && scene.balls[0].role == carom::Role::cue) return {};
  return {{.pointer = "/balls",
           .problem = carom::MessageCode::has_no_cue_ball,
           .expected = carom::MessageCode::first_ball_cue}};
}

carom::Result<Game> Game::create(carom::Scene table, Options options) {
  carom::Errors errors = check_table(table);
  auto world = carom::World::create(std::move(table));
  if (!world) return world.errors();
  if (!errors.empty()) return errors;
  return Game(std::make_shared<const carom::World>(std::move(world).value()), options);
}

// The rack is sound: the test that plays it would not start otherwise.
Game::Game(Options options) : Game(create(rack(options.rack), options).value()) {}

Game::Game(std::shared_ptr<const carom::World> start, Options options)
    : start_(std::move(start)),
      world_(*start_),
      options_(options),
      phase_(reds_left() == 0 ? Phase::over : Phase::aim),
      player_(options.first_player == 1 ? 1 : 0) {
  options_.first_player = player_;
}

carom::Status Game::apply(const Command& command) {
  if (const auto* shot = std::get_if<Shoot>(&command)) return shoot(shot->drag);
  if (const auto* placement = std::get_if<Place>(&command)) return place(placement->position);
  *this = Game(start_, options_);
  return carom::Done{};
}

carom::Status Game::shoot(carom::Vec2 drag) {
  if (phase_ != Phase::aim)
    return refusal("shoot", carom::MessageCode::is_out_of_turn,
                   carom::MessageCode::cue_ball_waiting);
  if (carom::Status launched = games::launch(world_, drag); !launched) return launched;
  events_.clear();
  physics_.clear();
  phase_ = Phase::roll;
  turn_steps_ = 0;
  touched_red_ = false;
  ++tally().shots;
  return carom::Done{};
}

Obstruction Game::obstruction(carom::Vec2 position) const {
  const carom::ExactArithmetic exact;
  const double r = world_.ball(0).radius;
  const carom::Scene& table = world_.scene();
  // Written so that NaN does not pass.
  if (!(position.x >= r && position.x <= table.width - r && position.y >= r &&
        position.y <= table.height - r))
    return Obstruction::cushion;
  const auto overlaps = [&](carom::Vec2 centre, double radius) {
    return carom::length_squared(centre - position) < (radius + r) * (radius + r);
  };
  // As the engine tests obstacles (docs/physics.md#one-step, stage 5).
  for (const carom::Obstacle& obstacle : table.obstacles)
    if (position.y < obstacle.height
            ? std::abs(position.x - obstacle.x) < obstacle.radius + r
            : carom::length(position - carom::Vec2{obstacle.x, obstacle.height}) <
                  obstacle.radius + r)
      return Obstruction::cushion;
  for (const carom::Hole& hole : table.holes)
    if (overlaps(hole.position, hole.radius)) return Obstruction::hole;
  for (std::size_t i = 1; i < world_.size(); ++i)
    if (overlaps(world_.ball(i).position, world_.ball(i).radius)) return Obstruction::ball;
  return Obstruction::none;
}

carom::Status Game::place(carom::Vec2 position) {
  if (phase_ != Phase::place)
    return refusal("place", carom::MessageCode::is_out_of_turn,
                   carom::MessageCode::cue_ball_in_hand);
  if (obstruction(position) != Obstruction::none)
    return refusal("position", carom::MessageCode::is_not_free, carom::MessageCode::free_place);
  if (carom::Status placed = world_.place_lead(position); !placed) return placed;
  events_.clear();
  physics_.clear();
  phase_ = Phase::aim;
  return carom::Done{};
}

int Game::reds_left() const { return static_cast<int>(world_.size()) - 1; }

std::optional<int> Game::winner() const {
  if (phase_ != Phase::over || scores_[0] == scores_[1]) return std::nullopt;
  return scores_[0] > scores_[1] ? 0 : 1;
}

void Game::step() { run(1); }

std::uint64_t Game::run(std::uint64_t most) {
  events_.clear();
  physics_.clear();
  if (phase_ != Phase::roll || most == 0) return 0;
  // As before every step up to the one in which the first ball falls.
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 0; i < world_.size(); ++i) ids.push_back(world_.ball(i).id);
  // A slow shot takes one step before it is asked whether all rests.
  const bool rests = world_.at_rest();
  const std::uint64_t left = rests ? 1 : max_turn_steps - turn_steps_;
  std::uint64_t seen = 0;
  const carom::RunEnd end = world_.run(
      {.rest = !rests,
       .events = carom::EventKind::pocketed | carom::EventKind::left | carom::EventKind::destroyed},
      std::min(most, left), [&](std::uint64_t step, std::span<const carom::Event> happened) {
        seen = step;
        physics_.assign(happened.begin(), happened.end());
        touched_red_ = touched_red_ || touches_red(happened);
      });
  if (seen != world_.steps()) physics_.clear();
  turn_steps_ += end.steps;
  score_pocketed(ids);
  end_turn();
  return end.steps;
}

// After a step: the turn passes, or the game is over.
void Game::end_turn() {
  const bool cue_fell = !world_.in_play(0);
  if (cue_fell) {
    ++tally().fouls;
    events_.push_back({.kind = EventKind::cue_pocketed, .player = player_});
  }
  if (reds_left() == 0) {
    phase_ = Phase::over;
    events_.push_back({.kind = EventKind::over, .player = player_});
  } else if (cue_fell) {
    // The other balls keep their speeds and wait for the next shot (§1.4.1).
    phase_ = Phase::place;
    pass_turn(other_player());
  } else if (world_.at_rest() || turn_steps_ >= max_turn_steps) {
    world_.stop();
    if (options_.touch_red && !touched_red_) {
      ++tally().fouls;
      events_.push_back({.kind = EventKind::missed, .player = player_});
      phase_ = Phase::place;
      pass_turn(other_player());
      return;
    }
    phase_ = Phase::aim;
    pass_turn(options_.keep_turn && turn_balls_ > 0 ? player_ : other_player());
  }
}

// Reds that fall in the same step count in index order (docs/physics.md#billiards), whatever holes
// they fall into.
void Game::score_pocketed(std::span<const std::uint32_t> ids_by_index) {
  for (const std::uint32_t id : ids_by_index) {
    const auto fell = [&](const carom::Event& event) {
      return event.kind == carom::EventKind::pocketed && event.ball == id;
    };
    if (id == 0 || std::ranges::none_of(physics_, fell)) continue;
    const std::int64_t points = points_for(++turn_balls_);
    turn_points_ += points;
    scores_[static_cast<std::size_t>(player_)] += points;
    ++tally().balls;
    tally().best_turn = std::max(tally().best_turn, turn_points_);
    events_.push_back({.kind = EventKind::scored, .player = player_, .ball = id, .points = points});
  }
}

void Game::pass_turn(int next) {
  player_ = next;
  turn_balls_ = 0;
  turn_points_ = 0;
  events_.push_back({.kind = EventKind::turn, .player = player_});
}

}  // namespace games::billiards
