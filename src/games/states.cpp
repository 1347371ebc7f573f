#include <cmath>
#include <optional>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/state_bytes.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"

// Both games as bytes: the start, the world, and what the rules know.
namespace games {

namespace bytes = carom::bytes;

namespace {

// No game is that long, nor has such a score.
constexpr std::uint64_t most_turns = 1'000'000'000;
constexpr std::int64_t most_points = std::int64_t{1} << 53;

struct Parts {
  carom::Scene start;
  carom::World world;
  bytes::Reader rules;
};

void write(bytes::Writer& out, const carom::Scene& start, const carom::World& world) {
  out.text(carom::write_scene(start));
  out.text(world.save_state());
}

carom::Result<Parts> read(char kind, std::string_view state) {
  const auto payload = bytes::unseal(kind, state);
  if (!payload) return payload.errors();
  bytes::Reader in(payload.value());
  auto start = carom::read_scene(in.text());
  if (!start) return start.errors();
  auto world = carom::World::load_state(in.text());
  if (!world) return world.errors();
  carom::Scene fixed = start.value();
  fixed.balls.clear();
  if (!(fixed == world.value().scene())) return bytes::damaged("its world is none of its start");
  return Parts{std::move(start).value(), std::move(world).value(), in};
}

void write_whole(bytes::Writer& out, std::int64_t number) {
  out.number(static_cast<std::uint64_t>(number));
}

/// The rules' numbers, with their limits.
class Rules {
 public:
  explicit Rules(bytes::Reader reader) : reader_(reader) {}

  template <class Whole>
  void read(Whole& whole, std::uint64_t most) {
    const auto number = reader_.number<std::uint64_t>();
    sound_ &= number <= most;
    whole = static_cast<Whole>(sound_ ? number : 0);
  }
  bool sound() const { return sound_ && reader_.whole(); }

 private:
  bytes::Reader reader_;
  bool sound_ = true;
};

carom::Error no_game() { return bytes::damaged("its rules' numbers are no game's"); }

}  // namespace

namespace angry_balls {

std::string Game::save_state() const {
  bytes::Writer out;
  write(out, level_, world_);
  write_whole(out, static_cast<int>(phase_));
  write_whole(out, throws_left_);
  write_whole(out, score_);
  write_whole(out, turn_balls_);
  out.number(turn_steps_);
  return bytes::seal('a', out.take());
}

carom::Result<Game> Game::load_state(std::string_view state) {
  auto parts = read('a', state);
  if (!parts) return parts.errors();
  auto& [level, world, reader] = parts.value();
  if (carom::Errors errors = check_level(level); !errors.empty()) return errors;
  Game game(level, world);
  Rules rules(reader);
  rules.read(game.phase_, static_cast<std::uint64_t>(Phase::lost));
  rules.read(game.throws_left_, static_cast<std::uint64_t>(level.throws));
  rules.read(game.score_, most_points);
  rules.read(game.turn_balls_, level.balls.size());
  rules.read(game.turn_steps_, std::uint64_t{1} << 53);
  const bool aims = game.phase_ == Phase::aim;
  if (!rules.sound() || !world.has_lead() || world.ball(0).role != carom::Role::projectile ||
      (aims && (!world.in_play(0) || game.throws_left_ == 0)) ||
      (game.enemies_left() == 0) != (game.phase_ == Phase::won) ||
      (game.phase_ == Phase::lost && game.throws_left_ > 0))
    return no_game();
  return game;
}

}  // namespace angry_balls

namespace billiards {

std::string Game::save_state() const {
  carom::Scene start = start_->scene();
  for (std::size_t i = 0; i < start_->size(); ++i) start.balls.push_back(start_->ball(i));
  bytes::Writer out;
  write(out, start, world_);
  write_whole(out, options_.first_player);
  write_whole(out, options_.keep_turn);
  write_whole(out, options_.alone);
  write_whole(out, static_cast<int>(phase_));
  write_whole(out, player_);
  for (std::size_t player = 0; player < 2; ++player) {
    write_whole(out, scores_[player]);
    write_whole(out, tallies_[player].balls);
    write_whole(out, tallies_[player].best_turn);
    write_whole(out, tallies_[player].shots);
    write_whole(out, tallies_[player].fouls);
  }
  write_whole(out, turn_balls_);
  write_whole(out, turn_points_);
  out.number(turn_steps_);
  return bytes::seal('b', out.take());
}

carom::Result<Game> Game::load_state(std::string_view state) {
  auto parts = read('b', state);
  if (!parts) return parts.errors();
  auto& [start, world, reader] = parts.value();
  const std::size_t balls = start.balls.size();
  auto created = create(std::move(start));
  if (!created) return created;
  Game& game = created.value();
  game.world_ = world;
  Rules rules(reader);
  rules.read(game.options_.first_player, 1);
  rules.read(game.options_.keep_turn, 1);
  rules.read(game.options_.alone, 1);
  rules.read(game.phase_, static_cast<std::uint64_t>(Phase::over));
  rules.read(game.player_, 1);
  for (std::size_t player = 0; player < 2; ++player) {
    rules.read(game.scores_[player], most_points);
    rules.read(game.tallies_[player].balls, balls);
    rules.read(game.tallies_[player].best_turn, most_points);
    rules.read(game.tallies_[player].shots, most_turns);
    rules.read(game.tallies_[player].fouls, most_turns);
  }
  rules.read(game.turn_balls_, balls);
  rules.read(game.turn_points_, most_points);
  rules.read(game.turn_steps_, max_turn_steps);
  const bool cue_out = world.has_lead() && !world.in_play(0);
  if (!rules.sound() || !world.has_lead() || world.ball(0).role != carom::Role::cue ||
      (game.phase_ == Phase::place && !cue_out) ||
      ((game.phase_ == Phase::aim || game.phase_ == Phase::roll) && cue_out) ||
      (game.reds_left() == 0) != (game.phase_ == Phase::over))
    return no_game();
  return created;
}

}  // namespace billiards

}  // namespace games
