#pragma once

#include <memory>
#include <vector>

#include "app/screens/screen.hpp"

namespace app {

/// All screens that are open, the uppermost last. The uppermost gets the input; those below are
/// drawn and get time as far as those above let them (Cover).
class ScreenStack {
 public:
  /// `sounds` must outlive this.
  explicit ScreenStack(Sounds& sounds) : sounds_(sounds) {}

  /// Closes all screens and opens this one.
  void show(std::unique_ptr<Screen> screen);
  /// Opens a screen over the others.
  void cover(std::unique_ptr<Screen> screen);

  /// The screen under all others.
  Screen& bottom() { return *screens_.front(); }
  bool empty() const { return screens_.empty(); }
  Screen& top() { return *screens_.back(); }
  const Screen& top() const { return *screens_.back(); }

  /// Screens that are covered whole follow when they come to light.
  void resize(const View& view);
  void draw(Canvas& canvas) const;
  bool animating() const;

  // These do what is the stack's own: Stay, Back, Ask and Answer. They return the request that is
  // left, one for another screen; Stay if none is.
  Navigation event(const Input& input);
  Navigation iterate(nanoseconds elapsed);
  Navigation apply(Navigation request);

 private:
  void push(std::unique_ptr<Screen> screen);
  void pop();
  void open_windows();
  /// Index of the lowest screen that is drawn, or that gets time.
  std::size_t lowest(bool running) const;

  Sounds& sounds_;
  View view_;
  std::vector<std::unique_ptr<Screen>> screens_;
};

}  // namespace app
