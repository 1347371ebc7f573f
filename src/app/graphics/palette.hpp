#pragma once

#include <array>
#include <cstdint>

#include "app/graphics/color.hpp"

namespace app {

/// Which colours tell apart what must be told apart; the others for players who see some alike.
enum class Colours : std::uint8_t {
  standard,
  red_green,      ///< where red and green look alike
  blue_yellow,    ///< where blue and yellow look alike
  high_contrast,  ///< by brightness alone
};

/// The colours that carry meaning. No meaning is told by them alone: players have signs, enemies
/// horns, what is refused a dashed outline.
struct Palette {
  Color ball;  ///< what is to be hit: reds, enemies
  Color ball_shade;
  Color felt;
  Color felt_lit;
  Color felt_dark;
  Color cushion;
  Color cushion_lit;
  Color allowed;
  Color refused;
  std::array<Color, 2> accents;   ///< one a player
  std::array<Color, 3> strength;  ///< of a launch, from calm to furious

  static const Palette& of(Colours colours);
};

/// All others: walnut, brass, on dark slate; a level at dusk.
namespace palette {

inline constexpr Color slate_top = rgb(0x1c262e);
inline constexpr Color slate_bottom = rgb(0x0e1418);
inline constexpr Color panel = rgb(0x26323b);
inline constexpr Color panel_edge = rgb(0x3d4d58);
inline constexpr Color panel_lit = rgb(0x344450);
inline constexpr Color scrim{6, 10, 13, 150};
inline constexpr Color shadow{0, 0, 0, 140};

inline constexpr Color cream = rgb(0xf5ecd8);
inline constexpr Color muted = rgb(0xb4c0c4);
inline constexpr Color ink = rgb(0x14191d);  ///< text on an accent

inline constexpr Color walnut_lit = rgb(0x8a5732);
inline constexpr Color walnut = rgb(0x5f381d);
inline constexpr Color walnut_dark = rgb(0x2b170b);

inline constexpr Color brass_lit = rgb(0xf7e3a4);
inline constexpr Color brass = rgb(0xc99f4a);
inline constexpr Color brass_dark = rgb(0x6a4c1b);
inline constexpr Color pocket_rim = rgb(0x1d1512);
inline constexpr Color pocket = rgb(0x020303);

inline constexpr Color ivory = rgb(0xfbf5e4);
inline constexpr Color ivory_shade = rgb(0x8f8468);
inline constexpr Color wood = rgb(0xd9a766);
inline constexpr Color wood_shade = rgb(0x5d3a1b);
inline constexpr Color wood_ring = rgb(0x6b431f);
inline constexpr Color stone = rgb(0xaeb4b6);
inline constexpr Color stone_shade = rgb(0x3b4449);
inline constexpr Color stone_dark = rgb(0x2a3136);
inline constexpr Color iron = rgb(0x2c2427);
inline constexpr Color glint = rgb(0xffffff);

inline constexpr Color sky_top = rgb(0x123a4e);
inline constexpr Color sky_middle = rgb(0x4f8d97);
inline constexpr Color sky_low = rgb(0xf2d7a2);
inline constexpr Color sun = rgb(0xfff1c9);
inline constexpr Color sun_low = rgb(0xf3bd74);
inline constexpr Color hills[3] = {rgb(0x7ba39b), rgb(0x4d807c), rgb(0x2d5f5e)};  ///< far to near
inline constexpr Color grass = rgb(0x5f9a4c);
inline constexpr Color grass_dark = rgb(0x2f5f33);
inline constexpr Color soil = rgb(0x5a4030);
inline constexpr Color soil_dark = rgb(0x241914);

}  // namespace palette

}  // namespace app
