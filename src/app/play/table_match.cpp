#include "app/play/table_match.hpp"

#include <algorithm>

namespace app {
namespace {

using games::billiards::Game;
using games::billiards::Options;

/// For one who plays alone there is no other player to have a turn.
Options options_of(const Session& session, bool alone) {
  const Settings& settings = session.settings.get();
  Options options{.touch_red = settings.touch_red, .rack = settings.rack, .alone = alone};
  if (alone) return options;
  options.first_player = first_player(settings.breaks, session.last_game);
  options.keep_turn = settings.keep_turn;
  return options;
}

bool has_computer(const replay::Occasion& occasion) {
  return std::ranges::any_of(occasion.computer, [](int level) { return level > 0; });
}

BilliardsRecorder begun(Session& session, const Options& options, replay::Occasion occasion) {
  occasion.seed = has_computer(occasion) ? session.fresh_seed() : 0;
  return {Game(options), occasion};
}

}  // namespace

BilliardsRecorder new_table(Session& session, bool practice) {
  if (practice) return BilliardsRecorder(Game({.alone = true}));
  const Settings& settings = session.settings.get();
  const bool alone = settings.seats == Seats::alone;
  replay::Occasion occasion;
  if (settings.seats == Seats::computer) occasion.computer[1] = settings.opponent;
  if (!alone) occasion.best_of = games_of(settings.match);
  return begun(session, options_of(session, alone), occasion);
}

BilliardsRecorder same_table(Session& session, const BilliardsRecorder& played) {
  Options options = options_of(session, played.game().options().alone);
  // A match has an order of its own.
  if (played.occasion().best_of > 1) options.first_player = played.game().options().first_player;
  return begun(session, options, played.occasion());
}

BilliardsRecorder next_table(Session& session, const BilliardsRecorder& played,
                             std::optional<int> winner) {
  replay::Occasion occasion = played.occasion();
  Options options = options_of(session, played.game().options().alone);
  const bool decided = match_winner(occasion, winner).has_value();
  occasion.won = decided ? std::array{0, 0} : games_won(occasion, winner);
  // Who breaks has the harder turn: in a match it alternates.
  if (occasion.best_of > 1) options.first_player = 1 - played.game().options().first_player;
  return begun(session, options, occasion);
}

std::array<int, 2> games_won(const replay::Occasion& occasion, std::optional<int> winner) {
  std::array<int, 2> won = occasion.won;
  if (winner) ++won[static_cast<std::size_t>(*winner)];
  return won;
}

std::optional<int> match_winner(const replay::Occasion& occasion, std::optional<int> winner) {
  if (!winner) return std::nullopt;
  const int won = games_won(occasion, winner)[static_cast<std::size_t>(*winner)];
  return won > occasion.best_of / 2 ? winner : std::nullopt;
}

}  // namespace app
