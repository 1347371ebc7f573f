#pragma once

#include <string>
#include <vector>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The choice of a game of billiards, over the title: players, the computer's level, rack, house
/// rules and match. It is saved, and the title's "Billiards" starts the same again.
class NewGame final : public Screen {
 public:
  NewGame(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  Cover cover() const override { return Cover::waiting; }

 private:
  enum Button : ButtonId { players, opponent, match, rack, keep_turn, touch_red, start, back };
  /// Those that there are for these players, in their order.
  std::vector<Button> rows() const;
  std::string label_of(Button button) const;
  void change(Button button);

  Words words_;
  Session& session_;
  View view_;
  Buttons buttons_;
  Rect panel_;
  Rect title_;
};

}  // namespace app
