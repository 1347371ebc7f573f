#pragma once

#include <optional>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"
#include "replay/player.hpp"

namespace app {

/// Plays the saved game, unseen and as fast as it goes, up to where it was left, and proves it on
/// the way. One that does not go as recorded is refused.
class LoadScreen final : public Screen {
 public:
  LoadScreen(const Words& words, Session& session, KeptGames::Kept kept);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  Navigation iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override { return words_(Text::loading); }
  bool animating() const override { return true; }

 private:
  Navigation finish();
  Navigation refuse(ReplayFault fault);

  Words words_;
  Session& session_;
  KeptGames::Kept kept_;
  std::optional<replay::Player> player_;  ///< none: the saved game cannot even begin
  Buttons buttons_;
  Rect panel_;
};

/// Steps that a screen may look ahead in one go without keeping the player waiting.
std::uint64_t steps_at_once(const replay::Player& player);

}  // namespace app
