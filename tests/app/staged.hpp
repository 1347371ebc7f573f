#pragma once

#include <memory>
#include <utility>

#include "app/screens/screen_stack.hpp"

/// A screen on a stack of its own, with the windows that it opens. Requests for other screens are
/// returned and not followed.
template <class S>
class Staged {
 public:
  template <class... Rest>
  Staged(const app::Words& words, app::Session& session, Rest&&... rest) : stack_(session.sounds) {
    auto made = std::make_unique<S>(words, session, std::forward<Rest>(rest)...);
    screen_ = made.get();
    stack_.resize(app::View::of(1280, 720));
    stack_.show(std::move(made));
  }

  void resize(const app::View& view) { stack_.resize(view); }
  app::Navigation event(const app::Input& input) { return stack_.event(input); }
  app::Navigation iterate(app::nanoseconds elapsed) { return stack_.iterate(elapsed); }
  void draw(app::Canvas& canvas) const { stack_.draw(canvas); }
  std::string describe() const { return stack_.top().describe(); }
  bool animating() const { return stack_.animating(); }

  const auto& game() const { return screen_->game(); }
  const auto& viewport() const { return screen_->viewport(); }
  const auto* aimed() const { return screen_->aimed(); }

 private:
  app::ScreenStack stack_;
  S* screen_;
};

template <class Request>
bool asks_for(const app::Navigation& request) {
  return std::holds_alternative<Request>(request);
}
