#include "app/input/fingers.hpp"

#include <algorithm>

namespace app {

std::vector<Input> Fingers::event(const Finger& finger) {
  const bool pointer = pointer_ == finger.id;
  switch (finger.phase) {
    case Finger::Phase::down:
      // A finger whose lifting was never reported comes down again.
      if (std::ranges::find(down_, finger.id) == down_.end()) down_.push_back(finger.id);
      if (down_.size() == 1) {
        pointer_ = finger.id;
        return {PointerMoved{finger.at}, PointerPressed{finger.at, PointerButton::left, true}};
      }
      if (!pointer_) return {};
      pointer_.reset();
      return {PointerCancelled{}};
    case Finger::Phase::moved:
      if (!pointer) return {};
      return {PointerMoved{finger.at}};
    case Finger::Phase::up:
      break;
  }
  std::erase(down_, finger.id);
  if (!pointer) return {};
  pointer_.reset();
  return {PointerMoved{finger.at}, PointerReleased{finger.at}, PointerLeft{}};
}

}  // namespace app
