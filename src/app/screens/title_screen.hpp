#pragma once

#include <optional>
#include <vector>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/dialog.hpp"
#include "app/widgets/widgets.hpp"
#include "replay/player.hpp"

namespace app {

/// Where the games are chosen, and one that was left is offered again.
class TitleScreen final : public Screen {
 public:
  TitleScreen(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  Navigation iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override { return ahead_.has_value(); }
  bool is_first() const override { return true; }
  std::optional<Ask> opens() override;

 private:
  enum class Choice : std::uint8_t {
    continue_latest,
    kept_games,
    billiards,
    new_game,
    practice_table,
    angry_balls,
    replays,
    settings,
    open_file,
    quit,
  };
  static ButtonId id_of(Choice choice) { return static_cast<ButtonId>(choice); }
  static Text tip_of(Choice choice);
  Navigation choose(Choice choice);
  std::string offer() const;
  std::string label_of(Choice choice) const;

  Words words_;
  Session& session_;
  std::vector<Choice> choices_;  ///< of the buttons
  View view_;
  std::optional<KeptGames::Kept> latest_;  ///< the saved game that was played last
  std::optional<replay::Player> ahead_;    ///< plays the game kept, until who is to play is known
  std::optional<std::ptrdiff_t> to_play_;
  Buttons buttons_;
  Rect art_;   ///< what the poster shows, standing on the rail
  Rect rail_;  ///< of wood, as wide as the window
  Rect wordmark_;
  Rect tagline_;
};

}  // namespace app
