#pragma once

#include <optional>
#include <vector>

#include "app/play/session.hpp"
#include "app/text/text.hpp"
#include "app/widgets/dialog.hpp"
#include "app/widgets/screen.hpp"
#include "app/widgets/widgets.hpp"
#include "replay/player.hpp"

namespace app {

/// Where the games are chosen, and one that was left is offered again.
class TitleScreen final : public Screen {
 public:
  TitleScreen(const Words& words, Session& session);

  void resize(const View& view) override;
  Transition event(const Input& input) override;
  Transition iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override { return ahead_.has_value(); }

 private:
  enum class Choice : std::uint8_t {
    continue_billiards,
    continue_level,
    billiards,
    practice_table,
    angry_balls,
    replays,
    settings,
    open_file,
    quit,
  };
  /// About what the dialog is: a kept game, by a new one of its kind; or nothing but OK.
  struct Question {
    Dialog dialog;
    std::optional<Choice> about;
  };

  enum Answer : ButtonId { go_on, give_up, cancel };

  static ButtonId id_of(Choice choice) { return static_cast<ButtonId>(choice); }
  static Text tip_of(Choice choice);
  Transition choose(Choice choice);
  Transition answer(ButtonId button);
  Transition proceed(Choice choice);
  void tell_refused();
  void tell(const std::string& title, const std::string& line);
  std::string offer(replay::Kind kind) const;
  std::string kept_level() const;
  std::string label_of(Choice choice) const;

  Words words_;
  Session& session_;
  std::vector<Choice> choices_;  ///< of the buttons
  View view_;
  std::optional<Question> question_;
  bool level_opened_ = false;            ///< Session::level_opened, until it is answered
  std::optional<replay::Player> ahead_;  ///< plays the game kept, until who is to play is known
  std::optional<std::ptrdiff_t> to_play_;
  Buttons buttons_;
  Rect art_;   ///< what the poster shows, standing on the rail
  Rect rail_;  ///< of wood, as wide as the window
  Rect wordmark_;
  Rect tagline_;
};

}  // namespace app
