#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "app/audio/sound.hpp"
#include "app/input/key_bindings.hpp"
#include "app/storage/aim_settings.hpp"
#include "app/storage/alone_best.hpp"
#include "app/storage/campaign.hpp"
#include "app/storage/clipboard.hpp"
#include "app/storage/host_environment.hpp"
#include "app/storage/kept_games.hpp"
#include "app/storage/saved_replays.hpp"
#include "app/storage/settings.hpp"
#include "app/text/text.hpp"
#include "carom/rollouts.hpp"
#include "replay/recorder.hpp"

namespace app {

using BilliardsRecorder = replay::Recorder<games::billiards::Game>;
using LevelRecorder = replay::Recorder<games::angry_balls::Game>;

/// Shared by all screens for as long as the program runs.
struct Session {
  /// Store and clipboard must outlive this.
  Session(Store& store, Clipboard& shared, std::vector<Level> levels, HostEnvironment where = {})
      : campaign{std::move(levels), BestScores(store), 0},
        alone(store),
        kept(store),
        saved(store),
        settings(store),
        clipboard(shared),
        host(std::move(where)) {}

  /// Nothing moves for show only: no trails, no slow motion, no shaking.
  bool calm() const {
    const ReducedMotion wanted = settings.get().reduced_motion;
    return wanted == ReducedMotion::on ||
           (wanted == ReducedMotion::system && system_reduced_motion);
  }

  /// The lesson is shown wherever a ball waits to be shot.
  bool teaches() const { return teach && settings.get().hints; }

  /// Another number for every game that has luck.
  std::uint64_t fresh_seed();

  Campaign campaign;
  AloneBest alone;
  KeptGames kept;
  SavedReplays saved;
  KeptSettings settings;
  Clipboard& clipboard;
  Language system_language = Language::en;
  /// Asked for at this start: stronger than the settings, until the player changes them.
  std::optional<Language> asked_language;
  std::optional<FinishedGame> last_game;  ///< of billiards, since the start
  Sounds sounds;                          ///< noted and not yet played
  bool system_reduced_motion = false;     ///< what the desktop or browser asks for
  HostEnvironment host;
  Keyboard keyboard;
  int needless_clicks = 0;   ///< for a next throw, where nothing could change any more
  bool teach = false;        ///< how to shoot is not known yet
  carom::Rollouts rollouts;  ///< plays what computers think of
  std::uint64_t seeds = 0;   ///< given out, where the host has no random numbers
};

/// The language to speak now.
Language language_of(const Session& session);
/// Makes `words` speak it, once its texts are there.
void speak(const Session& session, Words& words);
/// The clipboard's content. Neither a replay nor a fault: it comes later, with Key::paste.
struct Pasted {
  std::optional<replay::Replay> replay{};
  std::optional<ReplayFault> fault{};
};

/// Reads the clipboard: a replay's text, or a link to one.
Pasted read_pasted(const Session& session);
/// The fault in words.
Text pasted_fault(ReplayFault fault);

/// The text that is copied for a replay: its own, or a link to it.
std::string shared_text(const Session& session, const replay::Replay& replay);

}  // namespace app
