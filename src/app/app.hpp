#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/graphics/font.hpp"
#include "app/graphics/stamps.hpp"
#include "app/input/fingers.hpp"
#include "app/input/pad.hpp"
#include "app/play/session.hpp"
#include "app/screens/screen_stack.hpp"
#include "app/text/text.hpp"
#include "app/widgets/toast.hpp"

namespace app {

/// The whole game as a player sees it. The platform owns the loop: it hands in input and time, and
/// shows what comes out.
class App {
 public:
  /// The window's size in px. Store and clipboard must outlive this. `levels`: what the player has
  /// beside the shipped ones.
  App(StartLanguage start, int width, int height, Store& store, Clipboard& clipboard,
      std::vector<Level> levels = {}, HostEnvironment host = {});

  void event(const Input& input);
  void iterate(nanoseconds elapsed);
  /// Time that passed while nothing moved and the platform slept.
  void rest(nanoseconds elapsed) { quiet_ += elapsed; }
  /// If nothing was ever saved, pictures tell how to shoot until something is done.
  void teach_beginners();
  /// Sets the print on letters' keys; at first, as in the United States.
  void name_keys(std::function<std::string(Key)> label) {
    session_.keyboard.label = std::move(label);
  }
  /// Shows a replay over what is on screen, which lets go of what it holds.
  void watch(replay::Replay replay);
  /// Opens what a link carries behind the address, "#replay=TEXT" or "#level=TEXT"; tells the
  /// player if it is wrong. A link without either changes nothing.
  void open_link(std::string_view link);
  /// Opens a file: a replay is shown; a level is saved beside the others and played. Tells the
  /// player if it is neither. `name`: for messages and for keeping it.
  void open_file(const std::string& name, const std::string& bytes);
  /// The player's own levels, read again because a file has changed: the level in play begins anew
  /// if it is another now, or the player is told what is wrong with it.
  void take_levels(std::vector<Level> own);
  /// The texts that HostEnvironment::fetch_texts was asked for; of another version they are
  /// refused.
  void take_texts(Language language, std::string file);
  /// The picture now; good until the next call.
  const DrawList& draw();
  /// The picture's texture, as of the last draw().
  const Atlas& atlas() const { return atlas_; }

  /// Screen, turn, scores and balls left in one line: the window's title.
  std::string describe() const { return stack_.top().describe(); }
  /// The picture changes without input; otherwise the platform may sleep.
  bool animating() const;
  /// The uppermost one.
  const Screen& screen() const { return stack_.top(); }

  /// The sounds since the last call; none while muted.
  std::vector<SoundEvent> take_sounds();
  /// Per cent, 0 while muted.
  int volume() const {
    const Settings& settings = session_.settings.get();
    return settings.mute ? 0 : settings.volume;
  }
  KeptSettings& settings() { return session_.settings; }
  /// Goes back as Esc does: the back button of a phone or page. False where there is nothing to go
  /// back to.
  bool back();
  bool quit_requested() const { return quit_requested_; }

 private:
  void give(const Input& input);
  void give_to_screen(const Input& input);
  void note_hand(const Input& input);
  bool steers() const { return screen().aim_prompt().has_value(); }
  void go(Navigation request);
  void mute();
  void keep_keys();
  void play(Level level);
  void refuse(Text title, std::string line);

  Words words_;
  Store& store_;
  Session session_;
  View view_;
  Atlas atlas_;
  Font font_{atlas_};
  Stamps stamps_{atlas_};
  DrawList list_;
  Toast toast_;
  ScreenStack stack_;
  InputDevice laid_out_for_{};
  bool mouse_held_ = false;
  Fingers fingers_;
  Pad pad_;
  nanoseconds quiet_{};  ///< since the last input
  bool quit_requested_ = false;
  std::size_t given_levels_ = 0;  ///< first in the campaign: all but those opened meanwhile
};

}  // namespace app
