#pragma once

#include <string>

#include "app/base/time.hpp"
#include "app/graphics/canvas.hpp"

namespace app {

/// A short message over whatever is on screen.
class Toast {
 public:
  void show(std::string text);
  void advance(nanoseconds elapsed);
  bool active() const { return !text_.empty(); }
  void draw(Canvas& canvas) const;

 private:
  std::string text_;
  nanoseconds left_{};
};

}  // namespace app
