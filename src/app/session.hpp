#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/aim_settings.hpp"
#include "app/campaign.hpp"
#include "app/clipboard.hpp"
#include "app/kept_games.hpp"
#include "app/saved_replays.hpp"
#include "replay/recorder.hpp"

namespace app {

using BilliardsRecorder = replay::Recorder<games::billiards::Game>;
using LevelRecorder = replay::Recorder<games::angry_balls::Game>;

/// What the screens share and hand on to each other.
struct Session {
  /// Store and clipboard must outlive this.
  Session(Store& store, Clipboard& shared, std::vector<Level> levels)
      : campaign{std::move(levels), BestScores(store), 0},
        kept(store),
        saved(store),
        clipboard(shared) {}

  Campaign campaign;
  KeptGames kept;
  SavedReplays saved;
  Clipboard& clipboard;
  AimSettings aiming;
  std::optional<replay::Replay> to_watch;  ///< what Transition::replay shows
  replay::Kind to_continue{};              ///< what Transition::load goes on with
  /// What Transition::resume goes on with.
  std::optional<std::variant<BilliardsRecorder, LevelRecorder>> loaded;
};

/// Makes what the clipboard holds the replay to watch; or tells why it is none.
std::optional<ReplayFault> take_pasted(Session& session);

}  // namespace app
