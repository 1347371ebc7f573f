#pragma once

#include <cstdint>
#include <vector>

#include "app/graphics/atlas.hpp"
#include "app/graphics/draw_list.hpp"
#include "platform/sdl_owned.hpp"

namespace platform {

/// Shows draw lists in a window, by SDL's renderer. What stands still from frame to frame is drawn
/// once and kept as a picture; where a frame remains on screen until it is painted over, only what
/// moved is restored.
class Painter {
 public:
  /// Throws std::runtime_error if there is no renderer for the window, which must outlive this.
  explicit Painter(SDL_Window* window);

  SDL_Renderer* renderer() const { return renderer_.get(); }
  void show(const app::DrawList& list, const app::Atlas& atlas);
  /// The window may have lost what it showed.
  void frame_lost() { touched_.clear(); }
  /// The graphics card has lost everything.
  void forget();

 private:
  void upload(const app::Atlas& atlas);
  bool has_still(const app::DrawList& list);
  bool keep_still(const app::DrawList& list);
  void restore();
  void note_touched(const app::DrawList& list);
  void draw(const app::DrawList& list, std::size_t first, std::size_t end);

  Owned<SDL_Renderer> renderer_;
  bool frame_remains_ = false;  ///< after it was presented

  Owned<SDL_Texture> atlas_;
  std::uint64_t uploaded_version_ = 0;
  std::size_t uploaded_parts_ = 0;

  Owned<SDL_Texture> still_;  ///< the picture of what these draw
  std::vector<app::Vertex> still_vertices_;
  std::vector<std::int32_t> still_indices_;

  // Tiles of the window, in rows: where the last frame was drawn over what stands still. Empty: all
  // of the window was drawn anew.
  std::vector<bool> touched_;
  int columns_ = 0;
};

}  // namespace platform
