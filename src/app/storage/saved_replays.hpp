#pragma once

#include <string>
#include <vector>

#include "app/storage/store.hpp"
#include "carom/result.hpp"
#include "replay/replay.hpp"

namespace app {

/// The replays that the player has saved, or put among them by hand.
class SavedReplays {
 public:
  /// The store must outlive this.
  explicit SavedReplays(Store& store) : store_(store) {}

  /// Names such as "replay-0001", in order of their files.
  std::vector<std::string> names() const;
  carom::Result<replay::Replay> load(const std::string& name) const;
  /// Saves under a name of its own, which it gives; never over another. Fills short hashes in
  /// first, which plays the game.
  carom::Result<std::string> save(const replay::Replay& replay);

 private:
  Store& store_;
};

}  // namespace app
