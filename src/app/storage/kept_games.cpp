#include "app/storage/kept_games.hpp"

#include "replay/replay_file.hpp"

namespace app {

using replay::Kind;

KeptGames::KeptGames(Store& store) : store_(store) {
  load(Kind::billiards);
  load(Kind::angry_balls);
}

std::string KeptGames::file(Kind kind) {
  return kind == Kind::billiards ? "continue-billiards.json" : "continue-level.json";
}

void KeptGames::load(Kind kind) {
  const auto stored = store_.load(file(kind));
  if (!stored) return refuse(kind, ReplayFault::damaged);
  if (!stored.value()) return;
  auto read = replay::read_json(*stored.value());
  if (!read) return refuse(kind, fault_of(read.errors()));
  // The name of one game with the other in it.
  if (read.value().kind() != kind) return refuse(kind, ReplayFault::damaged);
  at(kind).game = std::move(read).value();
}

bool KeptGames::keep(const replay::Replay& game) {
  Slot& slot = at(game.kind());
  if (slot.blocked || !replay::check(game).empty()) return false;
  const std::string text = replay::write_json(game);
  if (text.size() > replay::max_bytes || !store_.save(file(game.kind()), text)) return false;
  slot.game = game;
  return true;
}

void KeptGames::forget(Kind kind) {
  Slot& slot = at(kind);
  slot.game.reset();
  // What cannot be removed is offered once more: no harm.
  if (!slot.blocked) static_cast<void>(store_.remove(file(kind)));
}

void KeptGames::refuse(Kind kind, ReplayFault fault) {
  Slot& slot = at(kind);
  slot.game.reset();
  slot.blocked = !store_.set_aside(file(kind)).ok();
  refused_.push_back({kind, fault, !slot.blocked});
}

std::optional<KeptGames::Refused> KeptGames::take_refused() {
  if (refused_.empty()) return std::nullopt;
  const Refused first = refused_.front();
  refused_.erase(refused_.begin());
  return first;
}

}  // namespace app
