#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "app/hud/practice_strip.hpp"
#include "app/hud/user_bar.hpp"
#include "app/play/aim_hints.hpp"
#include "app/play/clock.hpp"
#include "app/play/computer_turn.hpp"
#include "app/play/foresight.hpp"
#include "app/play/game_speed.hpp"
#include "app/play/hint.hpp"
#include "app/play/launcher.hpp"
#include "app/play/played.hpp"
#include "app/play/preview.hpp"
#include "app/play/runout.hpp"
#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/view/effects.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/world_view.hpp"
#include "app/widgets/dialog.hpp"

namespace app {

/// States of the player; they follow the game's phase. Aiming is a Launcher, a computer's turn a
/// ComputerTurn.
struct Watching {};
struct Over {
  Dialog dialog;
  /// The world plays on for a moment, for show, before the window opens. None: it opens at once.
  std::optional<carom::World> epilogue{};
  nanoseconds wait{};
};

/// A game that is played: what the games share. Input goes down a chain in which the first that
/// answers wins: speed, aim, practice, what the player does, focus, bar, commands. Questions and
/// the window of the end are opened over this screen (Ask).
///
/// `Game` is games::billiards::Game or games::angry_balls::Game. `Waiting` is what the player does
/// between launches that is the game's own: putting the cue ball down, or taking the next throw.
template <class Game, class Waiting>
class PlayScreen : public Screen {
 public:
  void resize(const View& view) final;
  Navigation event(const Input& input) final;
  Navigation iterate(nanoseconds elapsed) final;
  void draw(Canvas& canvas) const final;
  std::string describe() const final;
  std::optional<AimPrompt> aim_prompt() const final;
  bool animating() const final;
  std::optional<Ask> opens() final;
  Navigation answered(ButtonId button) final;

  const Game& game() const { return played_.game(); }
  const Viewport& viewport() const { return world_view_.viewport(); }
  /// The aim that is being edited; null when nothing is aimed.
  const Aim* aimed() const { return aim_in(state_); }

 protected:
  using Recorder = typename Played<Game>::Recorder;
  using Event = std::remove_cvref_t<decltype(std::declval<Game>().events().front())>;
  using Handled = std::optional<Navigation>;
  enum class Doing : std::uint8_t { aim, watch, wait, over };
  /// The end window's buttons.
  enum EndButton : ButtonId { go_on, again, watch, leave, take_back, repeat, review };

  enum Reply : ButtonId { yes, no };
  /// The pause menu's buttons.
  enum class PauseButton : ButtonId { resume, restart, resign, settings, help, leave };

  /// `place`: where the game is saved already.
  PlayScreen(const Words& words, Session& session, Recorder recorder, KeptGames::Place place,
             WorldView world_view);
  /// The constructor's last step, when all of the game is there.
  void begin();

  // The game's own part.
  virtual Doing doing() const = 0;
  /// Time makes steps of the game.
  virtual bool moving() const = 0;
  /// The picture goes on from the phase before: nothing was put anywhere by hand.
  virtual bool continues() const { return false; }
  virtual carom::Vec2 first_drag() const = 0;
  virtual Over ending() = 0;
  virtual bool start_again() = 0;
  /// Of the player who is on, if that is a computer; and its decision is played.
  virtual std::optional<ComputerTurn> computer_turn() const { return std::nullopt; }
  virtual void play(const search::Decision&) {}
  /// The player may give the game up; and does.
  virtual bool can_resign() const { return false; }
  virtual void resign() {}
  virtual void announce_start() = 0;
  /// An event of the rules, of a step or command.
  virtual void note(const Event& event) = 0;
  virtual void after_step() {}
  /// A launch begins, or the game is elsewhere: the last launch is not shown any more.
  virtual void begin_launch() {}
  /// Where the game is left to.
  virtual Navigation leave_to() const = 0;
  virtual Navigation next_game() { return leave_to(); }

  virtual UserBar& bar() = 0;
  virtual const UserBar& bar() const = 0;
  virtual void resize_bar(const Rect& area) = 0;
  virtual void draw_bar(Canvas& canvas) const = 0;
  /// The bar is drawn over what leaves the world.
  virtual bool bar_is_last() const { return false; }
  virtual void draw_ground(Canvas&) const {}
  /// Where the pointer is after a change of size.
  virtual void find_pointer() = 0;

  /// Time passes while something is done between launches.
  virtual void pass_waiting(nanoseconds) {}
  /// A window of the game's own to open now, and the answer.
  virtual std::optional<Ask> own_window() { return std::nullopt; }
  virtual void own_answer(ButtonId) {}
  virtual Handled waiting_event(Waiting& waiting, const Input& input) = 0;
  virtual Buttons* waiting_buttons() { return nullptr; }
  virtual void place_waiting(Waiting&) {}
  virtual void draw_waiting(Canvas&, const Waiting&, bool over_effects) const = 0;
  virtual std::optional<AimPrompt> waiting_prompt() const { return std::nullopt; }
  virtual std::string waiting_hint() const = 0;
  virtual Color waiting_color(const Palette& palette) const = 0;

  virtual AimHints aim_hints() const = 0;
  virtual Text watch_hint() const = 0;
  virtual Color lead_color(const Palette& palette) const = 0;
  /// Where effects may be written, window px.
  virtual Rect effects_area(const Canvas& canvas) const = 0;
  /// The player's state in words; and the whole line with it.
  virtual std::string now() const = 0;
  virtual std::string state_line(const std::string& now) const = 0;

  // For the game's own part.
  void follow_phase();
  /// After a command was taken: shows what it did.
  void happened();
  void place_parts();
  bool on_button() const;
  /// A button of the bar or of the practice has the keyboard's focus.
  bool focus_elsewhere() const;
  void blur();
  void keep();
  std::string end_title() const { return std::get<Over>(state_).dialog.title(); }
  int hints() const { return hints_; }
  /// Again, then the replay or in practice back by a shot.
  std::vector<Dialog::Button> end_buttons(Text again_label = Text::play_again) const;
  bool thinking() const {
    const auto* computer = std::get_if<ComputerTurn>(&state_);
    return computer && computer->thinking();
  }

  Words words_;
  Session& session_;
  Played<Game> played_;
  std::variant<Launcher, ComputerTurn, Watching, Waiting, Over> state_ = Launcher{};
  Effects effects_;
  std::int64_t turn_points_ =
      0;  ///< of the turn that is shown; the game forgets them with the turn
  WorldView world_view_;
  View view_;
  GameLayout layout_;
  Point pointer_;
  bool touch_ = false;  ///< a finger was the pointer

 private:
  // The chain.
  Handled change_speed(const Input& input);
  Handled aim(const Input& input);
  Handled practise(const Input& input);
  Handled act(const Input& input);
  Handled move_focus(const Input& input);
  Handled press_bar(const Input& input);
  Handled press_hint(const Input& input);
  Handled command(const Input& input);

  Navigation pause();
  Navigation paused(ButtonId button);
  bool skip(const Input& input);
  Navigation request(UserBar::Command command);
  /// The question before a command, if there is one; its buttons are a Reply each.
  std::optional<Dialog> question_before(UserBar::Command command) const;
  Navigation obey(UserBar::Command command);
  Navigation finish(ButtonId button);
  void practise(const PracticeCommand& command);
  void show_anew();
  /// Shows more of a good shot.
  void ask_hint();
  bool offers_hint() const;
  void step();
  void compute(ComputerTurn& turn, nanoseconds elapsed);
  const carom::World& shown_world() const;
  Launcher::Stage stage() const;
  void draw_launcher(Canvas& canvas, const Launcher& launcher) const;
  void draw_computer(Canvas& canvas, const ComputerTurn& turn) const;
  std::string described(std::string what) const;
  std::string hint() const;
  Color hint_color(const Palette& palette) const;

  decltype(std::declval<Game>().phase()) phase_{};  ///< that state_ follows
  enum class Window : std::uint8_t { question, pause, resign, own };
  Window window_{};           ///< that was opened last
  UserBar::Command asked_{};  ///< the subject of a question
  Runout<Game> runout_;
  std::optional<Hint> hint_;  ///< of this launch
  Buttons hint_button_{std::vector<Buttons::Button>{{0}}};
  int hints_ = 0;  ///< asked for, in this game
  Clock clock_;
  GameSpeed game_speed_;
  Foresight<Game> foresight_;
  Interpolator interpolator_;
  mutable Previewer previewer_;  ///< remembers what draw() asked for
  PracticeStrip strip_;
};

}  // namespace app
