#include "app/play/practice.hpp"

namespace app {

void change(Aim& aim, Change how) {
  switch (how) {
    case Change::faster:
      return aim.strengthen(1);
    case Change::slower:
      return aim.strengthen(-1);
    case Change::left:
      return aim.turn(0.1);
    case Change::right:
      return aim.turn(-0.1);
  }
}

}  // namespace app
