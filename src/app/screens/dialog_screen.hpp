#pragma once

#include "app/screens/screen.hpp"

namespace app {

/// A question or message over the screen that opened it, which gets the answer.
class DialogScreen final : public Screen {
 public:
  /// `sounds` must outlive this.
  DialogScreen(Ask ask, Sounds& sounds) : ask_(std::move(ask)), sounds_(sounds) {}

  void resize(const View& view) override { ask_.dialog.resize(view); }
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override { ask_.dialog.draw(canvas); }
  std::string describe() const override { return ask_.line; }
  Cover cover() const override { return ask_.cover; }

 private:
  Ask ask_;
  Sounds& sounds_;
};

/// A message with the button "OK".
Ask message(const Words& words, const std::string& title, std::vector<Dialog::Line> lines);

}  // namespace app
