#pragma once

#include "app/screen.hpp"
#include "app/text.hpp"
#include "app/widgets.hpp"

namespace app {

class TitleScreen final : public Screen {
 public:
  explicit TitleScreen(const Words& words);

  void resize(const View& view) override;
  Transition event(const Input& input) override;
  void iterate(nanoseconds) override {}
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override { return false; }

 private:
  void draw_background(Canvas& canvas) const;
  void draw_art(Canvas& canvas) const;

  Words words_;
  Buttons buttons_;
  Rect art_;
  Rect wordmark_;
  Rect tagline_;
};

}  // namespace app
