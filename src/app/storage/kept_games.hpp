#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/storage/replay_fault.hpp"
#include "app/storage/store.hpp"
#include "replay/replay.hpp"

namespace app {

/// The game of each kind that is in progress, kept in a Store after every turn as a replay, so that
/// it can be continued at the next start.
class KeptGames {
 public:
  /// What was stored and cannot be continued.
  struct Refused {
    replay::Kind kind{};
    ReplayFault fault{};
    bool set_aside = false;  ///< kept under another name; if not, nothing is saved over it
  };

  /// The store must outlive this.
  explicit KeptGames(Store& store);

  /// The game to continue. Read, but not yet played.
  const std::optional<replay::Replay>& of(replay::Kind kind) const { return at(kind).game; }
  /// False when it could not be saved.
  bool keep(const replay::Replay& game);
  /// The game is over, or was given up.
  void forget(replay::Kind kind);
  /// What is kept turned out to be none.
  void refuse(replay::Kind kind, ReplayFault fault);
  /// What has been refused and not been told yet, one at a time.
  std::optional<Refused> take_refused();

  static std::string file(replay::Kind kind);

 private:
  struct Slot {
    std::optional<replay::Replay> game;
    bool blocked = false;  ///< something unreadable is there that cannot be moved away
  };
  Slot& at(replay::Kind kind) { return slots_[static_cast<std::size_t>(kind)]; }
  const Slot& at(replay::Kind kind) const { return slots_[static_cast<std::size_t>(kind)]; }
  void load(replay::Kind kind);

  Store& store_;
  std::array<Slot, 2> slots_;
  std::vector<Refused> refused_;
};

}  // namespace app
