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
#include "app/settings.hpp"
#include "app/sound.hpp"
#include "app/text.hpp"
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
        settings(store),
        clipboard(shared) {}

  /// Nothing moves for show only: no trails, no slow motion, no shaking.
  bool calm() const {
    const ReducedMotion wanted = settings.get().reduced_motion;
    return wanted == ReducedMotion::on ||
           (wanted == ReducedMotion::system && system_reduced_motion);
  }

  Campaign campaign;
  KeptGames kept;
  SavedReplays saved;
  KeptSettings settings;
  Clipboard& clipboard;
  Language system_language = Language::english;
  /// Asked for at this start: stronger than the settings, until the player changes them.
  std::optional<Language> asked_language;
  std::optional<FinishedGame> last_game;   ///< of billiards, since the start
  Sounds sounds;                           ///< noted and not yet played
  bool system_reduced_motion = false;      ///< what the desktop or browser asks for
  std::optional<replay::Replay> to_watch;  ///< what Transition::replay shows
  replay::Kind to_continue{};              ///< what Transition::load goes on with
  /// What Transition::resume goes on with.
  std::optional<std::variant<BilliardsRecorder, LevelRecorder>> loaded;
};

/// The language to speak now.
Language language_of(const Session& session);
/// What a new game of billiards is played by.
games::billiards::Options options_of(const Session& session);

/// Makes what the clipboard holds the replay to watch; or tells why it is none.
std::optional<ReplayFault> take_pasted(Session& session);

}  // namespace app
