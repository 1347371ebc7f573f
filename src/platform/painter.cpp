#include "platform/painter.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

namespace platform {
namespace {

constexpr int tile = 16;  ///< px

/// True where a triangle shows a part of the atlas, not a colour alone.
bool textured(const app::DrawList& list, std::size_t index) {
  return list.vertices[static_cast<std::size_t>(list.indices[index])].texture != app::Point{};
}

void draw_with(SDL_Renderer* renderer, SDL_Texture* texture, const app::DrawList& list,
               std::size_t first, std::size_t end) {
  constexpr int stride = sizeof(app::Vertex);
  static_assert(sizeof(app::Color) == sizeof(SDL_Color));
  const app::Vertex& vertex = list.vertices.front();
  SDL_RenderGeometryRaw(renderer, texture, &vertex.position.x, stride,
                        reinterpret_cast<const SDL_Color*>(&vertex.color), stride,
                        &vertex.texture.x, stride, static_cast<int>(list.vertices.size()),
                        list.indices.data() + first, static_cast<int>(end - first),
                        sizeof(list.indices.front()));
}

}  // namespace

Painter::Painter(SDL_Window* window)
    : renderer_(SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC)) {
  if (!renderer_) renderer_ = owned(SDL_CreateRenderer(window, -1, 0));
#ifdef __EMSCRIPTEN__
  frame_remains_ = true;  // the page asks for it
#else
  SDL_RendererInfo info;
  frame_remains_ =
      SDL_GetRendererInfo(renderer_.get(), &info) == 0 && info.name == std::string_view("software");
#endif
  SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
  SDL_SetRenderDrawBlendMode(renderer_.get(), SDL_BLENDMODE_BLEND);  // of what has no texture
}

void Painter::forget() {
  atlas_.reset();
  still_.reset();
  touched_.clear();
}

void Painter::show(const app::DrawList& list, const app::Atlas& atlas) {
  upload(atlas);
  const bool still = has_still(list);
  if (still && !touched_.empty()) {
    restore();
  } else {
    SDL_RenderClear(renderer_.get());
    if (still) SDL_RenderCopy(renderer_.get(), still_.get(), nullptr, nullptr);
  }
  draw(list, still ? list.still_indices : 0, list.indices.size());
  if (still && frame_remains_)
    note_touched(list);
  else
    touched_.clear();
  SDL_RenderPresent(renderer_.get());
}

/// Brings over what was added to the atlas since the last time.
void Painter::upload(const app::Atlas& atlas) {
  if (!atlas_ || atlas.version() != uploaded_version_) {
    atlas_ = owned(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32,
                                     SDL_TEXTUREACCESS_STATIC, atlas.side(), atlas.side()));
    SDL_SetTextureBlendMode(atlas_.get(), SDL_BLENDMODE_BLEND);
    SDL_SetTextureScaleMode(atlas_.get(), SDL_ScaleModeLinear);
    SDL_UpdateTexture(atlas_.get(), nullptr, atlas.texels().data(), atlas.side() * 4);
    uploaded_version_ = atlas.version();
    // Of what stands still some may lie elsewhere in the new one.
    still_vertices_.clear();
  } else {
    for (const app::Atlas::Part& part : atlas.parts().subspan(uploaded_parts_)) {
      const SDL_Rect area{part.x, part.y, part.w, part.h};
      SDL_UpdateTexture(atlas_.get(), &area, &atlas.texel(part.x, part.y), atlas.side() * 4);
    }
  }
  uploaded_parts_ = atlas.parts().size();
}

/// Is true if there is a picture of the list's still part: once it was the same in two frames.
bool Painter::has_still(const app::DrawList& list) {
  const std::span vertices(list.vertices.data(), list.still_vertices);
  const std::span indices(list.indices.data(), list.still_indices);
  const auto same = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  if (same(vertices, still_vertices_) && same(indices, still_indices_))
    return !indices.empty() && (still_ || keep_still(list));
  still_vertices_.assign(vertices.begin(), vertices.end());
  still_indices_.assign(indices.begin(), indices.end());
  still_.reset();
  touched_.clear();
  return false;
}

bool Painter::keep_still(const app::DrawList& list) {
  int width = 1, height = 1;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  still_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_TARGET,
                                 width, height));
  if (!still_ || SDL_SetRenderTarget(renderer_.get(), still_.get()) != 0) {
    still_.reset();
    return false;
  }
  SDL_SetTextureBlendMode(still_.get(), SDL_BLENDMODE_NONE);
  SDL_RenderClear(renderer_.get());
  draw(list, 0, list.still_indices);
  SDL_SetRenderTarget(renderer_.get(), nullptr);
  return true;
}

/// Puts what stands still back where the last frame was drawn over it.
void Painter::restore() {
  int width = 1, height = 1;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  const int tiles = static_cast<int>(touched_.size());
  const auto touched = [&](int i) { return touched_[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < tiles; ++i) {
    if (!touched(i)) continue;
    const int first = i;
    const int end = (i / columns_ + 1) * columns_;
    while (i + 1 < end && touched(i + 1)) ++i;
    const int x = first % columns_ * tile;
    const int y = first / columns_ * tile;
    // The last ones reach beyond the window.
    const SDL_Rect area{x, y, std::min((i + 1 - first) * tile, width - x),
                        std::min(tile, height - y)};
    SDL_RenderCopy(renderer_.get(), still_.get(), &area, &area);
  }
}

void Painter::note_touched(const app::DrawList& list) {
  int width = 1, height = 1;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  columns_ = (width + tile - 1) / tile;
  const int rows = (height + tile - 1) / tile;
  touched_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), false);
  const auto tile_of = [](float at, int tiles) {
    return std::clamp(static_cast<int>(std::floor(at / tile)), 0, tiles - 1);
  };
  for (std::size_t i = list.still_indices; i + 2 < list.indices.size(); i += 3) {
    const auto corner = [&](std::size_t which) {
      return list.vertices[static_cast<std::size_t>(list.indices[i + which])].position;
    };
    const auto [left, right] = std::minmax({corner(0).x, corner(1).x, corner(2).x});
    const auto [top, bottom] = std::minmax({corner(0).y, corner(1).y, corner(2).y});
    const int last = tile_of(right, columns_);
    for (int row = tile_of(top, rows); row <= tile_of(bottom, rows); ++row) {
      const auto start = touched_.begin() + std::ptrdiff_t{row} * columns_;
      std::fill(start + tile_of(left, columns_), start + last + 1, true);
    }
  }
}

/// The triangles of the indices from `first` to before `end`. Most of the area needs no texture,
/// and is drawn quicker without where there is no graphics card.
void Painter::draw(const app::DrawList& list, std::size_t first, std::size_t end) {
  while (first < end) {
    const bool with_texture = textured(list, first);
    std::size_t last = first + 3;
    while (last < end && textured(list, last) == with_texture) last += 3;
    draw_with(renderer_.get(), with_texture ? atlas_.get() : nullptr, list, first, last);
    first = last;
  }
}

}  // namespace platform
