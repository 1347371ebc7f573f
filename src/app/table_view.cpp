#include "app/table_view.hpp"

#include <algorithm>
#include <array>

#include "app/balls.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"
#include "app/trails.hpp"

namespace app {
namespace {

// World px.
constexpr double cushion_width = 15;
constexpr double wood_radius = 26;
constexpr double pocket_rim = 3.5;
constexpr double jaw = 7;  ///< how much longer a cushion is at the wood than at its nose

class TablePainter {
 public:
  TablePainter(DrawList& list, const Viewport& viewport, const carom::Scene& scene)
      : list_(list), viewport_(viewport), scene_(scene) {}

  void paint() {
    wood();
    sights();
    fill_rounded(list_, around(cushion_width), px(7), list_.palette->felt_dark);
    for (const carom::Hole& hole : scene_.holes) pocket_leather(hole);
    bed();
    cushions();
    for (const carom::Hole& hole : scene_.holes) pocket(hole);
  }

 private:
  Point at(double x, double y) const { return viewport_.to_window({x, y}); }
  float px(double length) const { return viewport_.px(length); }
  /// The play area, larger by `by` world px on each side.
  Rect around(double by) const {
    const Point corner = at(-by, scene_.height + by);
    return {corner.x, corner.y, px(scene_.width + 2 * by), px(scene_.height + 2 * by)};
  }

  void wood() {
    const Rect outer = around(table_margin);
    fill_rounded(list_, outer.moved({0, px(8)}).inset(-px(4)), px(wood_radius), palette::shadow,
                 px(30));
    fill_rounded(list_, outer, px(wood_radius), palette::walnut);
    const float width = px(table_margin - cushion_width);
    for (int side = 0; side < 4; ++side) rail(outer, width, side);
    grain(outer, width);
    stroke_rounded(list_, outer, px(wood_radius), px(2), palette::walnut_dark);
    stroke_rounded(list_, outer.inset(px(2.2)), px(wood_radius - 2.2), px(1.2),
                   Paint::vertical(outer, faded(palette::brass_lit, 0.5f), {0, 0, 0, 60}));
    // A brass inlay borders the bed.
    stroke_rounded(list_, around(cushion_width + 1), px(8), px(3), palette::walnut_dark);
    stroke_rounded(list_, around(cushion_width + 2.5), px(8), px(1.4),
                   Paint::vertical(outer, palette::brass_lit, palette::brass));
  }

  /// One of the four rails, mitred: 0 right, 1 bottom, 2 left, 3 top.
  void rail(const Rect& outer, float width, int side) {
    const Outline edge = rounded(outer, px(wood_radius));
    const Rect inner = outer.inset(width);
    const std::array corners{Point{inner.right(), inner.y}, Point{inner.right(), inner.bottom()},
                             Point{inner.x, inner.bottom()}, Point{inner.x, inner.y}};
    const Point from = corners[static_cast<std::size_t>(side)];
    const Point to = corners[static_cast<std::size_t>((side + 1) % 4)];
    const Point outwards = turned(unit(to - from)) * -1;

    Outline outline{to, from};
    // Its part of the edge: what lies beyond both mitres, which run diagonally.
    const Point along = unit(to - from);
    Outline beyond;
    for (const Point& p : edge) {
      const float out = dot(p - from, outwards);
      if (out > 0 && dot(p - from, along) >= -out && dot(p - to, along) <= out) beyond.push_back(p);
    }
    if (beyond.empty()) return;  // a window of next to no size
    std::ranges::sort(beyond, {}, [&](Point p) { return dot(p, along); });
    outline.insert(outline.end(), beyond.begin(), beyond.end());
    const bool lit = side >= 2;  // left and top face the lamp's side
    fill(list_, outline,
         Paint(from + outwards * width, lit ? palette::walnut_lit : palette::walnut, from,
               lit ? palette::walnut : mix(palette::walnut, palette::walnut_dark, 0.45f)));
    line(list_, from, beyond.front(), px(1), faded(palette::walnut_dark, 0.6f));
  }

  /// Fine darker streaks along the rails.
  void grain(const Rect& outer, float rail) {
    const float inset = px(wood_radius);
    for (int i = 1; i < 6; ++i) {
      const float off = rail * static_cast<float>(i) / 6 + px(i % 2 == 0 ? 1.2 : -1);
      const Color streak = faded(palette::walnut_dark, i % 2 == 0 ? 0.13f : 0.2f);
      const float width = px(i % 3 == 0 ? 1.6 : 0.9);
      for (const float y : {outer.y + off, outer.bottom() - off})
        line(list_, {outer.x + inset, y}, {outer.right() - inset, y}, width, streak);
      for (const float x : {outer.x + off, outer.right() - off})
        line(list_, {x, outer.y + inset}, {x, outer.bottom() - inset}, width, streak);
    }
  }

  /// The brass diamonds that divide the rails into eighths and quarters.
  void sights() {
    const double middle = cushion_width + (table_margin - cushion_width) / 2 + 1;
    for (int i = 1; i < 8; ++i) {
      if (i == 4) continue;
      const double x = scene_.width * i / 8;
      sight(at(x, -middle));
      sight(at(x, scene_.height + middle));
    }
    for (int i = 1; i < 4; ++i) {
      const double y = scene_.height * i / 4;
      sight(at(-middle, y));
      sight(at(scene_.width + middle, y));
    }
  }

  void sight(Point c) {
    const float r = px(4.6);
    const auto diamond = [](Point m, float s) {
      return std::array{Point{m.x, m.y - s}, Point{m.x + s, m.y}, Point{m.x, m.y + s},
                        Point{m.x - s, m.y}};
    };
    fill(list_, diamond(c + Point{px(0.6), px(1)}, r * 1.15f), faded(palette::walnut_dark, 0.8f));
    fill(list_, diamond(c, r),
         Paint({c.x - r, c.y - r}, palette::brass_lit, {c.x + r, c.y + r}, palette::brass_dark));
  }

  void bed() {
    const Rect play = around(0);
    fill_rounded(list_, play, 0, list_.palette->felt);
    // A lamp hangs above the middle.
    glow(list_, play.center(), play.w * 0.5f, play.h * 0.5f, faded(list_.palette->felt_lit, 0.55f));
    glow(list_, play.center(), play.w * 0.3f, play.h * 0.42f,
         faded(list_.palette->felt_lit, 0.45f));
    // The line and the spot that the cue ball and the rack start from.
    const Color chalk{245, 236, 216, 44};
    line(list_, at(scene_.width / 4, 0), at(scene_.width / 4, scene_.height), px(1.2), chalk);
    fill_disc(list_, at(scene_.width / 4, scene_.height / 2), px(2.4), chalk);
  }

  /// One strip of cushion, its nose on the edge of play; `outwards` points to the wood.
  void cushion(carom::Vec2 nose_from, carom::Vec2 nose_to, carom::Vec2 outwards) {
    const carom::Vec2 way = carom::unit(nose_to - nose_from);
    const carom::Vec2 out = cushion_width * outwards;
    const auto corner = [&](carom::Vec2 nose, double sign) {
      return viewport_.to_window(nose + out + sign * jaw * way);
    };
    const Point a = viewport_.to_window(nose_from);
    const Point b = viewport_.to_window(nose_to);
    const std::array strip{a, b, corner(nose_to, 1), corner(nose_from, -1)};
    const Point foot = viewport_.to_window(nose_from + out);
    // Its shadow falls down and to the right, like the balls'.
    const Point inwards = unit(a - foot);
    if (inwards.x + inwards.y > 0) {
      const Point depth = inwards * px(9);
      fill(list_, std::array{a, b, b + depth, a + depth},
           Paint(a, {0, 0, 0, 90}, a + depth, {0, 0, 0, 0}));
    }
    const bool lit = inwards.x + inwards.y < 0;
    fill(list_, strip,
         Paint(foot, lit ? list_.palette->cushion : list_.palette->felt_dark, a,
               lit ? list_.palette->cushion_lit : list_.palette->cushion));
    line(list_, a, b, px(1.2), faded(list_.palette->cushion_lit, lit ? 1 : 0.75f));
  }

  void cushions() {
    const double gap = 25;  ///< from a corner or a middle hole's centre to the nose's end
    const double w = scene_.width;
    const double h = scene_.height;
    for (const double start : {gap, w / 2 + gap - 4}) {
      const double end = start + w / 2 - 2 * gap + 4;
      cushion({start, 0}, {end, 0}, {0, -1});
      cushion({start, h}, {end, h}, {0, 1});
    }
    cushion({0, gap}, {0, h - gap}, {-1, 0});
    cushion({w, gap}, {w, h - gap}, {1, 0});
  }

  /// The dark cup behind a pocket, that cuts into the cushion's strip.
  void pocket_leather(const carom::Hole& hole) {
    const Point c = viewport_.to_window(hole.position);
    fill_disc(list_, c, px(hole.radius + 9), palette::pocket_rim);
  }

  void pocket(const carom::Hole& hole) {
    const Point c = viewport_.to_window(hole.position);
    const float r = px(hole.radius);
    const float rim = px(pocket_rim);
    fill_disc(list_, c, r + rim + px(1), Color{0, 0, 0, 110}, px(4));
    fill_disc(
        list_, c, r + rim,
        Paint({c.x - r, c.y - r}, palette::brass_lit, {c.x + r, c.y + r}, palette::brass_dark));
    fill_disc(list_, c, r, Paint({c.x, c.y - r}, palette::pocket, {c.x, c.y + r}, rgb(0x231d1a)));
    // Depth: the far wall below stays faintly lit, the rest is black.
    fill_disc(list_, c - Point{0, r * 0.08f}, r * 0.86f, palette::pocket, r * 0.25f);
    stroke_circle(list_, c, r + rim * 0.9f, px(0.7), faded(palette::walnut_dark, 0.8f));
  }

  DrawList& list_;
  const Viewport& viewport_;
  const carom::Scene& scene_;
};

}  // namespace

void draw_table(DrawList& list, const Viewport& viewport, const carom::Scene& scene) {
  TablePainter(list, viewport, scene).paint();
}

void draw_table_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const Motion& motion, double fraction) {
  draw_trails(list, viewport, world, motion, fraction, [&](const carom::Ball& ball) {
    return ball.id == 0 ? palette::ivory : mix(list.palette->ball, palette::cream, 0.25f);
  });
}

void draw_balls(DrawList& list, const Viewport& viewport, const carom::World& world,
                const Motion& motion, double fraction) {
  const auto each_ball = [&](const auto& visit) {
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (world.in_play(i))
        visit(world.ball(i), viewport.to_window(motion.position(world, i, fraction)));
    }
  };
  each_ball([&](const carom::Ball& ball, Point center) {
    draw_ball_shadow(list, center, viewport.px(ball.radius));
  });
  each_ball([&](const carom::Ball& ball, Point center) {
    draw_ball(list, center, viewport.px(ball.radius),
              carom::is_lead(ball.role) ? BallKind::ivory : BallKind::red);
  });
}

}  // namespace app
