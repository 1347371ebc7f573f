#pragma once

#include <memory>

#include "app/screens/screen.hpp"

namespace app {

/// The screen that a request is for. None for a request of the stack's own, for Quit, and for a
/// replay that cannot be played.
std::unique_ptr<Screen> make_screen(const Words& words, Session& session, Navigation request);

/// The request's screen lies over the others; if not, it takes their place.
bool lies_over(const Navigation& request);

}  // namespace app
