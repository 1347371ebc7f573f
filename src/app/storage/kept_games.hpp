#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/storage/replay_fault.hpp"
#include "app/storage/store.hpp"
#include "replay/replay.hpp"

namespace app {

/// Games in progress, kept in a Store as replays after every command and turn, so that they can be
/// continued. Each has a name of its own, "continue-billiards-0001.json"; the highest number was
/// played last. A window writes only over what it has itself written last.
class KeptGames {
 public:
  /// Where a game is kept, and as what; at first nowhere.
  struct Place {
    std::string name{};
    std::string text{};
    bool own = false;  ///< written here, and not only read
  };
  struct Kept {
    Place place;
    replay::Replay game;
  };
  /// A stored game that cannot be continued.
  struct Refused {
    std::string name;
    replay::Kind kind{};
    ReplayFault fault{};
    bool set_aside = false;  ///< kept under another name; if not, it is where it was
  };

  /// The store must outlive this.
  explicit KeptGames(Store& store) : store_(store) {}

  /// The games kept, that played last first.
  std::vector<std::string> names() const;
  /// Read, but not yet played.
  carom::Result<Kept> load(const std::string& name) const;
  /// The first of names() that can be read. Those before it are refused.
  std::optional<Kept> latest();
  /// Keeps a game where it was kept before, or under a new name if it was continued: another window
  /// may have done the same. False when it could not be saved.
  bool keep(Place& place, const replay::Replay& game);
  /// The game is over.
  void forget(Place& place);
  /// The player no longer wants it. False when it cannot be removed.
  bool remove(const std::string& name) { return store_.remove(name).ok(); }
  /// Refuses a saved game that turned out to be none.
  void refuse(const std::string& name, ReplayFault fault);
  /// Returns a refused game that was not reported yet, one at a time.
  std::optional<Refused> take_refused();

 private:
  bool unchanged(const Place& place) const;
  bool save_anew(Place& place, replay::Kind kind, const std::string& text);

  Store& store_;
  std::vector<Refused> refused_;
  std::set<std::string> unreadable_;  ///< told once
};

}  // namespace app
