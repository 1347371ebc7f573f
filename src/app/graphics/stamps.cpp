#include "app/graphics/stamps.hpp"

#include <cmath>

#include "app/graphics/raster.hpp"

namespace app {
namespace {

constexpr float density = 2;       ///< texels a pixel
constexpr float widest = 64;       ///< px of reach; what is larger there are few of
constexpr int most = 1024 * 1024;  ///< texels in all: the atlas must not grow without end

/// Clear texels take the colour of their neighbours, as drawing between them mixes both.
void bleed(Image& image) {
  const Image before = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (before.at(x, y).a != 0) continue;
      Color nearest{};
      for (int row = std::max(y - 1, 0); row <= std::min(y + 1, image.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, image.width - 1); ++column)
          if (before.at(column, row).a >= nearest.a) nearest = before.at(column, row);
      image.at(x, y) = {nearest.r, nearest.g, nearest.b, 0};
    }
  }
}

/// The part that is not clear, and a clear rim around it.
Atlas::Part ink_of(const Image& image) {
  int left = image.width, top = image.height, right = 0, bottom = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y).a == 0) continue;
      left = std::min(left, x - 1);
      top = std::min(top, y - 1);
      right = std::max(right, x + 2);
      bottom = std::max(bottom, y + 2);
    }
  }
  left = std::max(left, 0);
  top = std::max(top, 0);
  return {left, top, std::min(right, image.width) - left, std::min(bottom, image.height) - top};
}

}  // namespace

bool Stamps::stretch(DrawList& list, const Key& key, Point center, float reach, float across,
                     float down, Color color, const Draw& draw) {
  if (!(reach <= widest)) return false;
  if (version_ != atlas_.version()) {
    pictures_.clear();
    texels_ = 0;
    version_ = atlas_.version();
  }
  const auto [found, is_new] = pictures_.try_emplace(key);
  if (is_new) found->second = make(*list.palette, key, reach, draw);
  if (!found->second) return false;
  const auto& [part, area] = *found->second;
  const Point scale{across / reach, down / reach};
  list.picture({center.x + area.x * scale.x, center.y + area.y * scale.y, area.w * scale.x,
                area.h * scale.y},
               atlas_.texture(part), color);
  return true;
}

std::optional<Stamps::Picture> Stamps::make(const Palette& palette, const Key& key, float reach,
                                            const Draw& draw) {
  const float half = (std::ceil(reach) + 1) * density;
  const int side = static_cast<int>(half * 2);
  if (texels_ + side * side > most) return std::nullopt;
  DrawList list;
  list.palette = &palette;
  draw(list, {half, half}, key.radius * density);
  Image image(side, side, {0, 0, 0, 0});
  rasterize(list, atlas_, image);
  bleed(image);
  const Atlas::Part ink = ink_of(image);
  if (ink.w <= 0) return std::nullopt;
  texels_ += ink.w * ink.h;
  const auto part =
      atlas_.add(ink.w, ink.h, [&](int x, int y) { return image.at(ink.x + x, ink.y + y); });
  if (!part) return std::nullopt;
  const auto px = [](float texels) { return texels / density; };
  return Picture{*part,
                 {px(static_cast<float>(ink.x) - half), px(static_cast<float>(ink.y) - half),
                  px(static_cast<float>(ink.w)), px(static_cast<float>(ink.h))}};
}

void stamp(DrawList& list, const Stamps::Key& key, Point center, float reach,
           const Stamps::Draw& draw) {
  if (!list.stamps || !list.stamps->draw(list, key, center, reach, draw))
    draw(list, center, key.radius);
}

}  // namespace app
