#include "app/play/aim_hints.hpp"

namespace app {

Text aim_hint(const Launcher& launcher, AimWay way, bool touch, const AimHints& hints) {
  if (way == AimWay::turn && launcher.offers_shot(way, touch)) return Text::hint_touch_shoot;
  if (launcher.refused()) return Text::hint_too_weak;
  switch (launcher.stance()) {
    case Launcher::Stance::idle:
      if (launcher.missed()) return hints.missed;
      return way == AimWay::clicks  ? hints.take
             : way == AimWay::pull  ? Text::hint_pull
             : way == AimWay::apart ? Text::hint_apart
                                    : Text::hint_turn;
    case Launcher::Stance::clicked:
      return hints.send;
    case Launcher::Stance::pulling:
      return Text::hint_let_go;
    case Launcher::Stance::turning:
      return way == AimWay::apart ? Text::hint_apart_aimed : Text::hint_turn;
    case Launcher::Stance::by_keys:
      return way == AimWay::apart && touch ? Text::hint_apart_aimed : Text::hint_keys;
    case Launcher::Stance::entering:
      return Text::hint_entry;
  }
  return hints.take;
}

Text nudge(AimWay way) {
  switch (way) {
    case AimWay::clicks:
      return Text::nudge_click;
    case AimWay::pull:
      return Text::nudge_pull;
    case AimWay::apart:
      return Text::nudge_apart;
    case AimWay::turn:
      break;
  }
  return Text::nudge_turn;
}

}  // namespace app
