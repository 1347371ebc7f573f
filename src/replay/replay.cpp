#include "replay/replay.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "replay/agreed.hpp"
#include "replay/written_forms.hpp"

namespace replay {

using enum carom::MessageCode;

carom::Errors check(const Replay& replay) {
  carom::Errors errors;
  const auto report = [&](std::string pointer, carom::Message problem, carom::Message expected) {
    errors.push_back({std::move(pointer), std::move(problem), std::move(expected)});
  };
  if (replay.level) {
    carom::Errors found = carom::check(*replay.level);
    if (found.empty()) found = games::angry_balls::check_level(*replay.level);
    for (carom::Error& error : found) {
      error.pointer.insert(0, "/level");
      errors.push_back(std::move(error));
    }
  }
  if (replay.level &&
      (replay.options != games::billiards::Options{} || replay.occasion != Occasion{}))
    report("/game", has_options_of_billiards, "none in \"angry-balls\"");
  if (replay.options.first_player != 0 && replay.options.first_player != 1)
    report("/first-player", {is, {std::to_string(replay.options.first_player + 1)}}, "1 or 2");
  for (const Agreed& item : agreed()) {
    Replay same = {.options = replay.options, .occasion = replay.occasion};
    if (!item.set(same, item.get(replay)))
      report("/" + std::string(item.key), {is, {std::to_string(item.get(replay))}},
             std::string(item.expected));
  }
  const Occasion& occasion = replay.occasion;
  for (std::size_t player = 0; player < 2; ++player)
    if (occasion.won[player] > occasion.best_of / 2)
      report(player == 0 ? "/won-1" : "/won-2", {is, {std::to_string(occasion.won[player])}},
             "fewer games than win the match");
  for (std::size_t player = 0; player < 2; ++player)
    if (replay.score[player] < 0 || replay.score[player] > max_score ||
        (replay.level && player == 1 && replay.score[player] != 0))
      report("/score/" + std::to_string(player), {is, {std::to_string(replay.score[player])}},
             "the points made, from 0 to " + std::to_string(max_score));

  if (replay.moves.size() > max_moves)
    report("/moves", {has_elements, {std::to_string(replay.moves.size())}},
           {at_most, {std::to_string(max_moves)}});
  std::uint64_t steps = 0;
  for (std::size_t i = 0; i < replay.moves.size() && errors.size() < carom::max_errors; ++i) {
    const Move& move = replay.moves[i];
    const std::string pointer = "/moves/" + std::to_string(i);
    const CommandName& name = command_names[move.command.index()];
    if (name.kind != replay.kind())
      report(pointer + "/command", {is, {'"' + std::string(name.name) + '"'}},
             expected_commands(replay.kind()));
    if (const carom::Vec2* const vector = vector_of(move.command))
      if (!std::isfinite(vector->x) || !std::isfinite(vector->y))
        report(pointer, has_infinite_drag, finite_numbers);
    const std::uint64_t most = name.moves ? max_move_steps : 0;
    if (move.steps > most) {
      report(pointer + "/steps", {is, {std::to_string(move.steps)}},
             {whole_number_from_to, {"0", std::to_string(most)}});
      continue;
    }
    const bool was_within = steps <= max_steps;
    steps += move.steps;
    if (was_within && steps > max_steps)
      report(pointer + "/steps", {makes_game_too_long, {std::to_string(max_steps)}}, shorter_game);
  }
  return errors;
}

}  // namespace replay
