#include "app/screens/screen_stack.hpp"

#include <utility>

#include "app/screens/dialog_screen.hpp"

namespace app {

void ScreenStack::show(std::unique_ptr<Screen> screen) {
  screens_.clear();
  cover(std::move(screen));
}

void ScreenStack::cover(std::unique_ptr<Screen> screen) {
  push(std::move(screen));
  open_windows();
}

void ScreenStack::push(std::unique_ptr<Screen> screen) {
  screens_.push_back(std::move(screen));
  top().resize(view_);
}

void ScreenStack::pop() {
  if (screens_.size() < 2) return;
  const bool hidden = top().cover() == Cover::whole;
  screens_.pop_back();
  if (hidden) resize(view_);
}

void ScreenStack::open_windows() {
  while (auto ask = top().opens()) push(std::make_unique<DialogScreen>(std::move(*ask), sounds_));
}

std::size_t ScreenStack::lowest(bool running) const {
  std::size_t index = screens_.size() - 1;
  while (index > 0) {
    const Cover cover = screens_[index]->cover();
    if (cover == Cover::whole || (running && cover == Cover::waiting)) break;
    --index;
  }
  return index;
}

void ScreenStack::resize(const View& view) {
  view_ = view;
  if (screens_.empty()) return;
  for (std::size_t i = lowest(false); i < screens_.size(); ++i) screens_[i]->resize(view);
}

void ScreenStack::draw(Canvas& canvas) const {
  for (std::size_t i = lowest(false); i < screens_.size(); ++i) screens_[i]->draw(canvas);
}

bool ScreenStack::animating() const {
  for (std::size_t i = lowest(true); i < screens_.size(); ++i)
    if (screens_[i]->animating()) return true;
  return false;
}

Navigation ScreenStack::event(const Input& input) {
  // A key that is let go may have been pressed before something came to lie over the screen.
  if (std::holds_alternative<KeyReleased>(input) || std::holds_alternative<CommandReleased>(input))
    for (std::size_t i = 0; i + 1 < screens_.size(); ++i) screens_[i]->event(input);
  return apply(top().event(input));
}

Navigation ScreenStack::iterate(nanoseconds elapsed) {
  for (std::size_t i = lowest(true); i + 1 < screens_.size(); ++i) screens_[i]->iterate(elapsed);
  return apply(top().iterate(elapsed));
}

Navigation ScreenStack::apply(Navigation request) {
  if (const auto* answer = std::get_if<Answer>(&request)) {
    const ButtonId button = answer->button;
    pop();
    return apply(top().answered(button));
  }
  if (auto* ask = std::get_if<Ask>(&request))
    push(std::make_unique<DialogScreen>(std::move(*ask), sounds_));
  else if (std::holds_alternative<Back>(request))
    pop();
  else if (!std::holds_alternative<Stay>(request))
    return request;
  open_windows();
  return Stay{};
}

}  // namespace app
