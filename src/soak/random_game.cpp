#include "soak/random_game.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "carom/world.hpp"
#include "replay/player.hpp"
#include "replay/recorder.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"
#include "soak/invariants.hpp"

namespace soak {

namespace {

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;
using carom::Vec2;

constexpr double widest_drag = 400;  // px: the full speed

Vec2 on_grid(Vec2 a) {
  return {std::floor(a.x / replay::text_grid) * replay::text_grid,
          std::floor(a.y / replay::text_grid) * replay::text_grid};
}

// As clicks give them; now and then any other number, or far more than the full speed.
Vec2 random_drag(games::Random& random) {
  const double most = random.one_in(50) ? 1e6 : widest_drag;
  const Vec2 drag{random.uniform(-most, most), random.uniform(-most, most)};
  return random.one_in(50) ? drag : on_grid(drag);
}

// The fault of the written forms of a replay, or empty.
std::string check_replay(const replay::Replay& played, std::size_t& text_size) {
  const auto from_json = replay::read_json(replay::write_json(played));
  if (!from_json)
    return "the replay's JSON is refused: " + carom::to_string(from_json.errors().front());
  if (from_json.value() != played) return "the replay's JSON reads as another one";
  const std::string text = replay::write_text(from_json.value());
  text_size = text.size();
  const auto from_text = replay::read_text(text);
  if (!from_text)
    return "the replay's text is refused: " + carom::to_string(from_text.errors().front());
  const auto full = replay::with_full_hashes(from_text.value());
  if (!full) return "the replay does not verify: " + carom::to_string(full.errors().front());
  if (full.value() != played) return "the replay's text reads as another one";
  return {};
}

// The world of a game once more, stepped beside it with another broad phase.
class Twin {
 public:
  explicit Twin(carom::BroadPhase broad_phase) : broad_phase_(broad_phase) {}

  /// After a command.
  void follow(const carom::World& world) {
    world_ = world;
    world_->set_broad_phase(broad_phase_);
  }

  void step() { world_->step(); }

  /// `stopped`: the rules may have stopped the game's world after the step.
  bool equals(const carom::World& world, bool stopped) {
    if (world_->state_hash() == world.state_hash()) return true;
    if (stopped) world_->stop();
    return world_->state_hash() == world.state_hash();
  }

 private:
  carom::BroadPhase broad_phase_;
  std::optional<carom::World> world_;
};

template <class Game>
PlayedGame play(Game game, games::Random& random) {
  PlayedGame played;
  replay::Recorder<Game> recorder(std::move(game));
  const carom::World& world = recorder.game().world();
  Invariants invariants;
  std::array twins{Twin(carom::BroadPhase::pairs), Twin(carom::BroadPhase::quadtree)};
  while (!replay::over(recorder.game()) && played.failure.empty() &&
         played.steps < replay::max_steps) {
    if (const auto command = random_command(recorder.game(), random)) {
      if (const carom::Status applied = recorder.apply(*command); !applied)
        played.failure = "a command is refused: " + carom::to_string(applied.errors().front());
      for (Twin& twin : twins) twin.follow(world);
      continue;
    }
    invariants.before_step(world);
    recorder.step();
    ++played.steps;
    std::optional<std::string> wrong = invariants.after_step(world);
    // A difference stays, so that it is enough to look now and then.
    const bool stands = !replay::moves(recorder.game());
    for (Twin& twin : twins) {
      twin.step();
      if (!wrong && (stands || played.steps % 64 == 0) && !twin.equals(world, stands))
        wrong = "another broad phase gives another state";
    }
    if (wrong) played.failure = "after step " + std::to_string(played.steps) + " " + *wrong;
  }
  played.replay = recorder.replay();
  if (played.failure.empty()) played.failure = check_replay(played.replay, played.text_size);
  if (const auto player = replay::Player::create(played.replay)) {
    played.turns = player.value().turns().size();
    for (const replay::Turn& turn : player.value().turns())
      played.longest_turn = std::max(played.longest_turn, turn.steps);
  }
  return played;
}

}  // namespace

std::optional<billiards::Command> random_command(const billiards::Game& game,
                                                 games::Random& random) {
  if (game.phase() == billiards::Phase::aim) return billiards::Shoot{random_drag(random)};
  if (game.phase() != billiards::Phase::place) return std::nullopt;
  const carom::Scene& table = game.world().scene();
  Vec2 position;
  do position = on_grid({random.uniform(0, table.width), random.uniform(0, table.height)});
  while (game.obstruction(position) != billiards::Obstruction::none);
  return billiards::Place{position};
}

std::optional<angry_balls::Command> random_command(const angry_balls::Game& game,
                                                   games::Random& random) {
  if (game.phase() == angry_balls::Phase::aim) return angry_balls::Throw{random_drag(random)};
  if (game.phase() == angry_balls::Phase::offer && random.one_in(20)) return angry_balls::Next{};
  return std::nullopt;
}

carom::Scene random_level(games::Random& random) {
  carom::Scene level;
  level.name = "Random";
  level.width = random.uniform(300, 1500);
  level.height = random.uniform(200, 800);
  for (carom::Edge carom::Edges::*side :
       {&carom::Edges::left, &carom::Edges::right, &carom::Edges::bottom, &carom::Edges::top})
    level.edges.*side = random.one_in(2) ? carom::Edge::open : carom::Edge::solid;
  level.friction = random.one_in(10) ? 1 : random.uniform(0.98, 1);
  level.gravity = random.one_in(10) ? 0 : random.uniform(0, 1200);
  level.damage_threshold = random.uniform(0, 800);
  level.throws = 1 + static_cast<int>(random.below(5));
  const auto anywhere = [&] {
    return Vec2{random.uniform(0, level.width), random.uniform(0, level.height)};
  };
  if (random.one_in(4))
    for (auto count = random.below(4); count > 0; --count)
      level.holes.push_back({.position = anywhere(), .radius = random.uniform(5, 40)});
  for (auto count = random.below(6); count > 0; --count)
    level.obstacles.push_back({.x = random.uniform(0, level.width),
                               .height = random.uniform(1, level.height / 2),
                               .radius = random.uniform(1, 25)});

  // The first ball that fits is the projectile, the second an enemy, so that it is a level.
  const std::uint64_t wanted = 2 + random.below(40);
  for (int tries = 0; level.balls.size() < wanted && tries < 10'000; ++tries) {
    level.balls.push_back(
        {.role = random.one_in(2) ? carom::Role::neutral : carom::Role::enemy,
         .position = anywhere(),
         .radius = random.uniform(3, 30),
         .solidity = random.one_in(4) ? carom::infinite_solidity : random.uniform(0, 20'000)});
    if (level.balls.size() == 1)
      level.balls[0] = {.role = carom::Role::projectile,
                        .position = level.balls[0].position,
                        .radius = level.balls[0].radius};
    if (level.balls.size() == 2) level.balls[1].role = carom::Role::enemy;
    if (!carom::check(level).empty()) level.balls.pop_back();
  }
  return level;
}

PlayedGame play_random_game(std::uint64_t seed, replay::Kind kind) {
  games::Random random(seed);
  if (kind == replay::Kind::billiards)
    return play(
        billiards::Game({.first_player = seed % 2 != 0 ? 1 : 0, .keep_turn = seed / 2 % 2 != 0}),
        random);
  auto game = angry_balls::Game::create(random_level(random));
  // A narrow level full of obstacles may have no room for two balls.
  while (!game) game = angry_balls::Game::create(random_level(random));
  return play(std::move(game).value(), random);
}

}  // namespace soak
