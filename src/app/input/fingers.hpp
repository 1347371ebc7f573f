#pragma once

#include <optional>
#include <vector>

#include "app/input/input.hpp"

namespace app {

/// The first finger is the pointer, and is nowhere once it is lifted. A second one takes back what
/// the first has begun; then nothing counts until all are lifted.
class Fingers {
 public:
  /// Returns the pointer's input that it means.
  std::vector<Input> event(const Finger& finger);
  bool none() const { return down_.empty(); }

 private:
  std::vector<std::int64_t> down_;
  std::optional<std::int64_t> pointer_;
};

}  // namespace app
