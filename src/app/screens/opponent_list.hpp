#pragma once

#include <string>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The choice of the computer's level: ten, each with a word, a face, and the facts that make it
/// strong or weak.
class OpponentList final : public Screen {
 public:
  OpponentList(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;

 private:
  void draw_level(Canvas& canvas, int level) const;

  Words words_;
  Session& session_;
  Buttons buttons_;  ///< a level's number each; 0 goes back
  Rect title_;
  Rect note_;
};

/// "4 · Club"
std::string ranked(const Words& words, int level);
/// "hand 8 px, looks at 100 shots"
std::string facts_of(const Words& words, int level);

}  // namespace app
