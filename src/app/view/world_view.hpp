#pragma once

#include <optional>

#include "app/graphics/canvas.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// A table or a level as a picture: how it fits, what stands still, what moves.
class WorldView {
 public:
  /// A table, or with `level` a level: as it was at the start.
  explicit WorldView(carom::Scene scene, bool level) : scene_(std::move(scene)), level_(level) {}

  /// Shows it within `area`, window px; `margin`: around a table.
  void fit(const Rect& area, float margin);
  /// The same, `factor` times as large, with a place of the world (px) in the middle of `area`.
  WorldView magnified(const Rect& area, carom::Vec2 center, double factor) const;
  const Viewport& viewport() const { return viewport_; }
  const Rect& area() const { return area_; }
  /// The area of a table with its wood; of a level its own.
  Rect box() const;

  /// A table's room fills the window.
  void draw_still(Canvas& canvas) const;
  /// The balls `fraction` of the way through the current step, and what quick ones leave behind.
  void draw_moving(Canvas& canvas, const carom::World& world, const Interpolator& motion,
                   double fraction) const;

 private:
  carom::Scene scene_;
  bool level_;
  Rect area_;
  Viewport viewport_;
};

}  // namespace app
