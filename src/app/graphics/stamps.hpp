#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>

#include "app/graphics/atlas.hpp"
#include "app/graphics/draw_list.hpp"

namespace app {

/// Small pictures of what is drawn again and again, kept in the atlas: a quad instead of hundreds
/// of triangles. They have two texels a pixel, so that they stay sharp between pixels too.
class Stamps {
 public:
  struct Key {
    enum class Of : std::uint8_t { glow, ball, sound_ball, worn_ball, face };
    Of of;
    float radius;  ///< px
    /// Tells apart what looks different at one radius.
    std::uint32_t look = 0;

    friend auto operator<=>(const Key&, const Key&) = default;  // NOLINT(modernize-use-nullptr)
  };
  /// Draws around a centre, at a radius (px).
  using Draw = std::function<void(DrawList&, Point center, float radius)>;

  /// Must not outlive the atlas.
  explicit Stamps(Atlas& atlas) : atlas_(atlas) {}

  /// Draws at `center`, by its picture, what `draw` draws no further than `reach` (px) from there.
  /// `draw` must give the same for the same key as long as the atlas forgets nothing. False if
  /// there can be no picture: it is too large, or they are too many.
  bool draw(DrawList& list, const Key& key, Point center, float reach, const Draw& draw) {
    return stretch(list, key, center, reach, reach, reach, {255, 255, 255, 255}, draw);
  }
  /// The same, stretched: what lies at `reach` in the picture comes to lie `across` and `down` from
  /// the centre. Multiplies the picture by `color`.
  bool stretch(DrawList& list, const Key& key, Point center, float reach, float across, float down,
               Color color, const Draw& draw);

 private:
  struct Picture {
    Atlas::Part part;
    Rect area;  ///< px around the centre
  };

  std::optional<Picture> make(const Palette& palette, const Key& key, float reach,
                              const Draw& draw);

  Atlas& atlas_;
  std::uint64_t version_ = 0;  ///< of the atlas that they lie in
  std::map<Key, std::optional<Picture>> pictures_;
  int texels_ = 0;
};

/// Draws by a stamp where there can be one, and by `draw` itself otherwise.
void stamp(DrawList& list, const Stamps::Key& key, Point center, float reach,
           const Stamps::Draw& draw);

}  // namespace app
