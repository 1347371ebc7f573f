#include "app/view/table_view.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "app/graphics/noise.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "app/view/trails.hpp"

namespace app {
namespace {

// World px.
constexpr double table_margin = 46;  ///< from the play area to the outer edge of the wood
constexpr double cushion_width = 15;
constexpr double wood_radius = 26;
constexpr double pocket_rim = 3.5;
constexpr double jaw = 7;  ///< how much longer a cushion is at the wood than at its nose

Rect around(const Viewport& viewport, const carom::Scene& table, double by) {
  return viewport.to_window({-by, -by}, {table.width + by, table.height + by});
}

class TablePainter {
 public:
  TablePainter(DrawList& list, const Viewport& viewport, const carom::Scene& scene)
      : list_(list), viewport_(viewport), scene_(scene) {
    // A lamp hangs above the middle.
    const Rect play = around(0);
    lamp_ = {play.center(), std::max(play.w * 0.68f, 1.0f), std::max(play.h * 0.86f, 1.0f),
             list_.palette->felt_lit, mix(list_.palette->felt, list_.palette->felt_dark, 0.35f)};
  }

  void paint(const Rect& window) {
    room(window);
    wood();
    sights();
    // The gaps that the cushions leave at the pockets.
    fill_between(list_, rounded(around(cushion_width), px(7)), list_.palette->felt_dark,
                 rounded(around(-1), px(7)), list_.palette->felt_dark);
    for (const carom::Hole& hole : scene_.holes) pocket_leather(hole);
    bed();
    cushions();
    for (const carom::Hole& hole : scene_.holes) pocket(hole);
  }

 private:
  Point at(double x, double y) const { return viewport_.to_window({x, y}); }
  float px(double length) const { return viewport_.px(length); }
  /// The play area, larger by `by` world px on each side.
  Rect around(double by) const { return app::around(viewport_, scene_, by); }

  /// The floor, where the lamp still reaches it, and the table's shadow.
  void room(const Rect& window) {
    const Rect outer = around(table_margin);
    Lamp lamp{outer.center(), std::max({outer.w * 0.8f, window.h * 0.6f, 1.0f}),
              std::max({outer.h * 0.95f, window.h * 0.6f, 1.0f}),
              mix(palette::panel_lit, list_.palette->felt_dark, 0.4f), palette::slate_bottom};
    // Nothing is painted where the table stands, but for its round corners.
    Rect rest = window;
    Rect hidden = outer.inset(px(wood_radius) * 0.4f);
    hidden.w = std::max(hidden.w, 0.0f);
    hidden.h = std::max(hidden.h, 0.0f);
    fill_lamplit(list_, rest.cut_top(hidden.y - rest.y), lamp);
    fill_lamplit(list_, rest.cut_bottom(rest.bottom() - hidden.bottom()), lamp);
    fill_lamplit(list_, rest.cut_left(hidden.x - rest.x), lamp);
    fill_lamplit(list_, rest.cut_right(rest.right() - hidden.right()), lamp);
    const float soft = px(26);
    const float radius = px(wood_radius);
    fill_between(list_, rounded(outer.inset(px(2)), radius), palette::shadow,
                 rounded(outer.moved({soft * 0.3f, soft * 0.5f}).inset(-soft * 0.7f), radius),
                 {0, 0, 0, 0});
  }

  /// A frame of wood: rings of vertices whose colours are grain and light at once.
  void wood() {
    const Rect outer = around(table_margin);
    const float width = px(table_margin - cushion_width);
    constexpr std::int32_t rings = 12;
    constexpr std::int32_t side_points = 26;
    constexpr std::int32_t corner_points = 5;
    constexpr std::int32_t n = 4 * (side_points + corner_points);
    const float radius = px(wood_radius);
    // Clockwise, the top side first, each followed by the corner at its end.
    struct Place {
      std::size_t from, to;  ///< corners
      float along;           ///< from the one to the other
      Point outwards;
    };
    std::array<Place, n> places;
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t side = i / (side_points + corner_points);
      const std::int32_t k = i % (side_points + corner_points);
      const float bend = static_cast<float>(std::max(k - side_points, 0)) / corner_points;
      const float angle = std::numbers::pi_v<float> / 2 * (static_cast<float>(side) - 1 + bend);
      const auto to = static_cast<std::size_t>(side);
      places[static_cast<std::size_t>(i)] = {
          (to + 3) % 4,
          to,
          static_cast<float>(std::min(k, side_points)) / side_points,
          {std::cos(angle), std::sin(angle)}};
    }
    const Point light{-0.5f, -0.85f};
    for (std::int32_t ring = 0; ring <= rings; ++ring) {
      const float depth = static_cast<float>(ring) / rings;
      const Rect edge = outer.inset(width * depth);
      const float r = std::max(radius - width * depth, 0.0f);
      const std::array centers{Point{edge.right() - r, edge.y + r},
                               Point{edge.right() - r, edge.bottom() - r},
                               Point{edge.x + r, edge.bottom() - r}, Point{edge.x + r, edge.y + r}};
      // Round across: the outer half faces outwards, the inner half the bed.
      const float slope = 1 - 2 * depth;
      const auto row = static_cast<std::uint32_t>(ring);
      const float streak = noise(20, row) - 0.5f;
      for (std::int32_t i = 0; i < n; ++i) {
        const Place& place = places[static_cast<std::size_t>(i)];
        const Point from = centers[place.from];
        const Point p = from + (centers[place.to] - from) * place.along + place.outwards * r;
        const float facing = dot(place.outwards, light) * slope * slope * slope;
        const float figure = noise(21 + row, static_cast<std::uint32_t>(i)) - 0.5f;
        const float value = 0.42f + 0.32f * facing + 0.55f * lamp_.strength(p) * (0.4f + depth) +
                            0.22f * streak + 0.17f * figure;
        const std::int32_t at = list_.add(p, mix(palette::walnut_dark, palette::walnut_lit, value));
        if (ring == 0) continue;
        const std::int32_t next = i + 1 < n ? at + 1 : at + 1 - n;
        list_.quad(at - n, next - n, next, at);
      }
    }
    joints(outer, width);
    stroke_rounded(list_, outer, radius, px(2), palette::walnut_dark);
    stroke_rounded(list_, outer.inset(px(2.2)), px(wood_radius - 2.2), px(1.2),
                   Paint::vertical(outer, faded(palette::brass_lit, 0.5f), {0, 0, 0, 60}));
    // A brass inlay borders the bed.
    stroke_rounded(list_, around(cushion_width + 1), px(8), px(3), palette::walnut_dark);
    stroke_rounded(list_, around(cushion_width + 2.5), px(8), px(1.4),
                   Paint::vertical(outer, palette::brass_lit, palette::brass));
  }

  /// Where two rails meet.
  void joints(const Rect& outer, float width) {
    const Rect inner = outer.inset(width);
    const float cut = px(wood_radius) * 0.3f;  // off the round corner
    for (const float x : {-1.0f, 1.0f}) {
      for (const float y : {-1.0f, 1.0f}) {
        const Point m = outer.center();
        const Point from = m + Point{x * inner.w / 2, y * inner.h / 2};
        line(list_, from, from + Point{x, y} * (width - cut), px(1),
             faded(palette::walnut_dark, 0.7f));
      }
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
    fill_lamplit(list_, around(0), lamp_);
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
    // It overhangs the bed, and its shadow falls down and to the right, like the balls'.
    const Point inwards = unit(a - foot);
    const bool lit = inwards.x + inwards.y < 0;
    const Point depth = inwards * px(lit ? 4 : 10);
    fill(list_, std::array{a, b, b + depth, a + depth},
         Paint(a, {0, 0, 0, 100}, a + depth, {0, 0, 0, 0}));
    const Color high = list_.palette->cushion;
    fill(list_, strip,
         Paint(foot, lit ? high : mix(high, list_.palette->felt_dark, 0.75f), a,
               lit ? list_.palette->cushion_lit : high));
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
  Lamp lamp_;
};

}  // namespace

Viewport table_viewport(const Rect& area, const carom::Scene& table) {
  constexpr double worth_it = 1.08;  // times larger
  const carom::Vec2 from{-table_margin, -table_margin};
  const carom::Vec2 to{table.width + table_margin, table.height + table_margin};
  const Viewport lying(area, from, to);
  const Viewport upright(area, from, to, true);
  return upright.scale() > worth_it * lying.scale() ? upright : lying;
}

Rect table_box(const Viewport& viewport, const carom::Scene& table) {
  return around(viewport, table, table_margin);
}

void draw_table(DrawList& list, const Rect& window, const Viewport& viewport,
                const carom::Scene& scene) {
  TablePainter(list, viewport, scene).paint(window);
}

void draw_table_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const Interpolator& motion, double fraction) {
  draw_trails(list, viewport, world, motion, fraction, [&](const carom::Ball& ball) {
    return ball.id == 0 ? palette::ivory : mix(list.palette->ball, palette::cream, 0.25f);
  });
}

void draw_balls(DrawList& list, const Viewport& viewport, const carom::World& world,
                const Interpolator& motion, double fraction) {
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
