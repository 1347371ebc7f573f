#include "app/graphics/palette.hpp"

#include <cstddef>

namespace app {

const Palette& Palette::of(Colours colours) {
  static constexpr std::array<Palette, 4> all{{
      // Petrol felt, red balls.
      {.ball = rgb(0xd0222c),
       .ball_shade = rgb(0x4d0710),
       .felt = rgb(0x0d5057),
       .felt_lit = rgb(0x1f7b7c),
       .felt_dark = rgb(0x083338),
       .cushion = rgb(0x14666a),
       .cushion_lit = rgb(0x2f9391),
       .allowed = rgb(0xa8e6a1),
       .refused = rgb(0xff7a66),
       .accents = {rgb(0xf4b63f), rgb(0x74c7f2)},
       .strength = {rgb(0x9be08f), rgb(0xf7d354), rgb(0xff7a3d)}},
      // Navy felt, orange balls.
      {.ball = rgb(0xe8890c),
       .ball_shade = rgb(0x5c2f00),
       .felt = rgb(0x123a66),
       .felt_lit = rgb(0x225f96),
       .felt_dark = rgb(0x0a2340),
       .cushion = rgb(0x1a4d80),
       .cushion_lit = rgb(0x3a7ab5),
       .allowed = rgb(0x9ad0ff),
       .refused = rgb(0xffb13d),
       .accents = {rgb(0xf4b63f), rgb(0x74c7f2)},
       .strength = {rgb(0x8fc7ff), rgb(0xf5ecd8), rgb(0xffa524)}},
      // Charcoal felt, red balls, cyan beside red.
      {.ball = rgb(0xe02f3c),
       .ball_shade = rgb(0x54060f),
       .felt = rgb(0x22404a),
       .felt_lit = rgb(0x35606b),
       .felt_dark = rgb(0x14272e),
       .cushion = rgb(0x2c515c),
       .cushion_lit = rgb(0x4a808c),
       .allowed = rgb(0x7fe6d6),
       .refused = rgb(0xff6b74),
       .accents = {rgb(0xff8f8a), rgb(0x5fdccb)},
       .strength = {rgb(0x7fe6d6), rgb(0xf5ecd8), rgb(0xff6b74)}},
      // Nearly black felt, amber balls: told apart by brightness alone.
      {.ball = rgb(0xd08a1e),
       .ball_shade = rgb(0x6b4208),
       .felt = rgb(0x0b0f12),
       .felt_lit = rgb(0x161d22),
       .felt_dark = rgb(0x05080a),
       .cushion = rgb(0x3a464d),
       .cushion_lit = rgb(0x8fa0a8),
       .allowed = rgb(0xe6fff0),
       .refused = rgb(0xff7a5c),
       .accents = {rgb(0xe29c10), rgb(0xe8f6ff)},
       .strength = {rgb(0x9ab4c4), rgb(0xffd23f), rgb(0xffffff)}},
  }};
  return all[static_cast<std::size_t>(colours)];
}

}  // namespace app
