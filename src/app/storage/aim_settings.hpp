#pragma once

#include <cstdint>

namespace app {

/// Length of the preview while a player aims (preview.hpp).
enum class PreviewLength : std::uint8_t {
  off,      ///< only where the launch goes
  contact,  ///< up to the first ball that is hit
  brief,    ///< and the first stretch of both balls after it; in a level the flight's first second
  full,     ///< the whole turn, in practice; elsewhere the first stretches, in a level, too
};

/// Ways to aim by the pointer. The keyboard aims in each way, and a click on the lead that does
/// not move starts the report's two clicks in each way.
enum class AimWay : std::uint8_t {
  clicks,  ///< one click on the lead, one where to send it (§1.4.1)
  pull,    ///< press on the lead, pull back as with a sling, let go
  turn,    ///< the pointer turns; wheel, bar or Space held set the strength; a click launches
  apart,  ///< a tap points, a drag turns, a bar sets the strength, a button launches; a pull on the
          ///< lead does all at once
};

/// A player's choices about aiming.
struct AimSettings {
  PreviewLength preview = PreviewLength::brief;
  AimWay way = AimWay::apart;
  friend bool operator==(const AimSettings&, const AimSettings&) = default;
};

}  // namespace app
