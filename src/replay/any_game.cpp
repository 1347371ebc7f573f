#include "replay/any_game.hpp"

#include <type_traits>
#include <utility>

namespace replay {

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

carom::Result<AnyGame> start(const Replay& replay) {
  if (!replay.level) return AnyGame(billiards::Game(replay.options));
  auto game = angry_balls::Game::create(*replay.level);
  if (!game) return game.errors();
  return AnyGame(std::move(game).value());
}

carom::Status apply_command(AnyGame& game, const Command& command) {
  return std::visit(
      [](auto& played, const auto& given) -> carom::Status {
        using Game = std::decay_t<decltype(played)>;
        using Given = std::decay_t<decltype(given)>;
        constexpr bool of_billiards =
            std::is_same_v<Given, billiards::Shoot> || std::is_same_v<Given, billiards::Place>;
        if constexpr (of_billiards == std::is_same_v<Game, billiards::Game>)
          return played.apply(given);
        else
          return carom::Error{.pointer = "command",
                              .problem = carom::MessageCode::is_of_other_game,
                              .expected = carom::MessageCode::command_of_game};
      },
      game, command);
}

void step(AnyGame& game) { run(game, 1); }

std::uint64_t run(AnyGame& game, std::uint64_t most) {
  return std::visit([most](auto& played) { return played.run(most); }, game);
}

const carom::World& world(const AnyGame& game) {
  return std::visit([](const auto& played) -> const carom::World& { return played.world(); }, game);
}

bool moves(const billiards::Game& game) { return game.phase() == billiards::Phase::roll; }

bool moves(const angry_balls::Game& game) {
  return game.phase() == angry_balls::Phase::fly || game.phase() == angry_balls::Phase::offer;
}

bool moves(const AnyGame& game) {
  return std::visit([](const auto& played) { return moves(played); }, game);
}

bool over(const billiards::Game& game) { return game.phase() == billiards::Phase::over; }

bool over(const angry_balls::Game& game) {
  return game.phase() == angry_balls::Phase::won || game.phase() == angry_balls::Phase::lost;
}

bool over(const AnyGame& game) {
  return std::visit([](const auto& played) { return over(played); }, game);
}

std::array<std::int64_t, 2> score(const billiards::Game& game) {
  return {game.score(0), game.score(1)};
}

std::array<std::int64_t, 2> score(const angry_balls::Game& game) { return {game.score(), 0}; }

std::array<std::int64_t, 2> score(const AnyGame& game) {
  return std::visit([](const auto& played) { return score(played); }, game);
}

}  // namespace replay
