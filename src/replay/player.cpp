#include "replay/player.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "carom/trace.hpp"
#include "replay/written_forms.hpp"

namespace replay {

namespace {

// The snapshots may hold this many balls, holes and obstacles in all, some two hundred bytes each.
// When that is used up, every other one is dropped: seeking plays on from the nearest before.
constexpr std::size_t max_kept_things = 200'000;

std::size_t things(const carom::World& world) {
  return world.size() + world.scene().holes.size() + world.scene().obstacles.size();
}

// Known from the commands alone: all but a shot after a placement, and Next, begin a turn.
std::vector<Turn> turns_of(const std::vector<Move>& moves) {
  std::vector<Turn> turns;
  std::uint64_t step = 0;
  const Command* before = nullptr;
  for (const Move& move : moves) {
    const bool goes_on = std::holds_alternative<games::angry_balls::Next>(move.command) ||
                         (before && std::holds_alternative<games::billiards::Place>(*before) &&
                          std::holds_alternative<games::billiards::Shoot>(move.command));
    if (!goes_on || turns.empty())
      turns.push_back(
          {.first_move = static_cast<std::size_t>(&move - moves.data()), .first_step = step});
    turns.back().steps += move.steps;
    step += move.steps;
    before = &move.command;
  }
  return turns;
}

std::int64_t points(std::array<std::int64_t, 2> score) { return score[0] + score[1]; }

std::string score_text(std::array<std::int64_t, 2> score, Kind kind) {
  std::string text = "score " + std::to_string(score[0]);
  if (kind == Kind::billiards) text += " : " + std::to_string(score[1]);
  return text;
}

}  // namespace

std::string to_string(const Divergence& divergence, std::size_t turns) {
  std::string text = "diverged in turn " + std::to_string(divergence.turn + 1);
  if (turns > 0) text += " of " + std::to_string(turns);
  if (divergence.first_step == divergence.last_step)
    text += " at step " + std::to_string(divergence.last_step);
  else
    text += ", steps " + std::to_string(divergence.first_step) + " to " +
            std::to_string(divergence.last_step);
  return text + ": expected " + divergence.expected + ", got " + divergence.got;
}

carom::Result<Player> Player::create(Replay replay) {
  carom::Errors errors = check(replay);
  if (!errors.empty()) return errors;
  auto game = start(replay);
  if (!game) return game.errors();
  return Player(std::move(replay), std::move(game).value());
}

Player::Player(Replay replay, AnyGame game)
    : replay_(std::move(replay)),
      turns_(turns_of(replay_.moves)),
      shown_{.game = game},
      ahead_{.game = std::move(game)} {
  kept_.push_back(shown_);
  if (replay_.moves.empty()) compare();
}

bool Player::at_end(const Moment& moment) const {
  return moment.steps_due == 0 && moment.move == replay_.moves.size();
}

std::size_t Player::turn() const {
  const bool between = shown_.steps_due == 0 && !at_end(shown_);
  const std::size_t move = between ? shown_.move : std::max(shown_.move, std::size_t{1}) - 1;
  const auto next = std::ranges::upper_bound(turns_, move, {}, &Turn::first_move);
  return static_cast<std::size_t>(std::max(next - turns_.begin(), std::ptrdiff_t{1})) - 1;
}

bool Player::step() {
  bool changed = false;
  for (bool stepped = false; !stepped;) {
    if (shown_.time() == ahead_.time() && !advance_ahead(1) && shown_.time() == ahead_.time())
      return changed;
    stepped = shown_.steps_due > 0;
    advance(shown_, 1);
    changed = true;
  }
  return changed;
}

bool Player::seek(std::size_t turn) {
  return seek(turn, std::numeric_limits<std::uint64_t>::max()) == Sought::shown;
}

Sought Player::seek(std::size_t turn, std::uint64_t steps) {
  if (turn > turns_.size()) return Sought::nowhere;
  if (turn == turns_.size()) {
    if (look_ahead(steps)) return Sought::on_way;
    shown_ = ahead_;
    return Sought::shown;
  }
  while (reached_turns_ <= turn) {
    if (steps == 0) return Sought::on_way;
    const std::uint64_t before = ahead_.time();
    if (!advance_ahead(steps)) return Sought::nowhere;
    steps -= ahead_.time() - before;
  }
  const std::uint64_t time = turns_[turn].first_move + turns_[turn].first_step;
  if (!sought_ || sought_turn_ != turn) {
    sought_ = kept_[std::min(turn / kept_each_, kept_.size() - 1)];
    if (shown_.time() <= time && shown_.time() > sought_->time()) sought_ = shown_;
    sought_turn_ = turn;
  }
  while (sought_->time() < time) {
    if (steps == 0) return Sought::on_way;
    const std::uint64_t before = sought_->time();
    advance(*sought_, std::min(steps, time - before));
    steps -= sought_->time() - before;
  }
  shown_ = *std::exchange(sought_, std::nullopt);
  return Sought::shown;
}

bool Player::look_ahead(std::uint64_t steps) {
  const std::uint64_t start = ahead_.time();
  while (ahead_.time() - start < steps)
    if (!advance_ahead(steps - (ahead_.time() - start))) return false;
  return true;
}

// Gives the next command or takes up to `most` steps. False when there is nothing to do any more,
// or the game has just diverged.
bool Player::advance_ahead(std::uint64_t most) {
  Moment& moment = ahead_;
  if (divergence_ || at_end(moment)) return false;
  if (moment.steps_due == 0) {
    const Move& move = replay_.moves[moment.move];
    if (reached_turns_ < turns_.size() && turns_[reached_turns_].first_move == moment.move)
      begin_turn();
    if (const carom::Status applied = apply_command(moment.game, move.command); !applied) {
      diverge('"' + std::string(command_names[move.command.index()].name) + '"',
              "its refusal: " + carom::to_string(applied.errors().front()));
      return false;
    }
    ++moment.move;
    moment.steps_due = move.steps;
  } else {
    if (!moves(moment.game)) {
      diverge(std::to_string(moment.steps_due) + " more steps of this turn",
              "a game that stands still");
      return false;
    }
    const std::uint64_t taken = run(moment.game, std::min(most, moment.steps_due));
    moment.step += taken;
    moment.steps_due -= taken;
  }
  Turn& turn = turns_[reached_turns_ - 1];
  const std::int64_t before = reached_turns_ > 1 ? points(turns_[reached_turns_ - 2].score) : 0;
  turn.score = score(moment.game);
  turn.points = points(turn.score) - before;
  if (moment.steps_due == 0) compare();
  return !divergence_;
}

// Only what advance_ahead() has found possible.
void Player::advance(Moment& moment, std::uint64_t most) const {
  if (moment.steps_due == 0) {
    const Move& move = replay_.moves[moment.move];
    static_cast<void>(apply_command(moment.game, move.command));
    ++moment.move;
    moment.steps_due = move.steps;
  } else {
    const std::uint64_t taken = run(moment.game, std::min(most, moment.steps_due));
    moment.step += taken;
    moment.steps_due -= taken;
  }
}

void Player::begin_turn() {
  if (const auto* game = std::get_if<games::billiards::Game>(&ahead_.game))
    turns_[reached_turns_].player = game->player();
  if (reached_turns_ == kept_.size() * kept_each_) keep();
  ++reached_turns_;
}

void Player::keep() {
  kept_.push_back(ahead_);
  kept_things_ += things(world(ahead_.game));
  if (kept_things_ <= max_kept_things || kept_.size() < 3) return;
  std::vector<Moment> fewer;
  for (std::size_t n = 0; n < kept_.size(); n += 2) fewer.push_back(std::move(kept_[n]));
  kept_ = std::move(fewer);
  kept_each_ *= 2;
  kept_things_ = 0;
  for (const Moment& moment : kept_) kept_things_ += things(world(moment.game));
}

// Known at the end of a move: the hash, at the end of the game the score too.
void Player::compare() {
  const Moment& moment = ahead_;
  const std::uint64_t hash = world(moment.game).state_hash();
  if (moment.move > 0) {
    const std::size_t move = moment.move - 1;
    const bool is_short = replay_.short_hashes && moment.move < replay_.moves.size();
    const std::uint64_t mask = is_short ? short_hash_mask : ~std::uint64_t{0};
    const std::uint64_t expected = replay_.moves[move].hash & mask;
    const std::uint64_t got = hash & mask;
    if (expected != got) {
      const auto text = [&](std::uint64_t shown) {
        return "hash " + std::string(is_short ? "…" : "") +
               carom::hash_text(shown).substr(is_short ? 14 : 0);
      };
      return diverge(text(expected), text(got));
    }
  }
  const std::array<std::int64_t, 2> points_made = score(moment.game);
  if (at_end(moment) && points_made != replay_.score)
    return diverge(score_text(replay_.score, replay_.kind()),
                   score_text(points_made, replay_.kind()));
  right_step_ = moment.step;
  if (moment.move > 0) hashes_.push_back(hash);
}

Replay Player::with_full_hashes() const {
  Replay replay = replay_;
  for (std::size_t move = 0; move < hashes_.size(); ++move) replay.moves[move].hash = hashes_[move];
  replay.short_hashes = false;
  return replay;
}

void Player::diverge(std::string expected, std::string got) {
  divergence_ = {.turn = reached_turns_ > 0 ? reached_turns_ - 1 : 0,
                 .first_step = right_step_,
                 .last_step = ahead_.step,
                 .expected = std::move(expected),
                 .got = std::move(got)};
}

carom::Result<Player> verify(Replay replay) {
  auto player = Player::create(std::move(replay));
  if (player) player.value().look_ahead(max_moves + max_steps);
  return player;
}

carom::Result<Replay> with_full_hashes(Replay replay) {
  const auto player = verify(std::move(replay));
  if (!player) return player.errors();
  if (player.value().divergence())
    return carom::Error{
        .problem = {carom::MessageCode::has_diverged,
                    {to_string(*player.value().divergence(), player.value().turns().size())}}};
  return player.value().with_full_hashes();
}

}  // namespace replay
