#pragma once

#include "app/play/launcher.hpp"
#include "app/storage/aim_settings.hpp"
#include "app/text/text.hpp"

namespace app {

/// A game's own words for taking its lead, for a click beside it, and for the second click.
struct AimHints {
  Text take;
  Text missed;
  Text send;
};
/// Hint at the next thing to do.
Text aim_hint(const Launcher& launcher, AimWay way, bool touch, const AimHints& hints);
/// Hint for a player who does nothing.
Text nudge(AimWay way);

}  // namespace app
