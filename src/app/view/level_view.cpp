#include "app/view/level_view.hpp"

#include <array>
#include <numbers>

#include "app/graphics/noise.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/graphics/stamps.hpp"
#include "app/view/faces.hpp"
#include "app/view/landscape.hpp"
#include "app/view/trails.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

constexpr double ground_depth = 0.08;  ///< of the level's height
constexpr float tau = 2 * std::numbers::pi_v<float>;

/// The speed (px/s) of a hit that breaks a ball when it is new.
double breaking_speed(double solidity, const carom::Scene& level) {
  return level.damage_per_speed > 0 ? solidity / level.damage_per_speed : carom::infinite_solidity;
}

/// A wall with its rounded top, of dressed stone.
void draw_wall(DrawList& list, const Viewport& viewport, const carom::Obstacle& wall) {
  const Point cap = viewport.to_window({wall.x, wall.height});
  const float r = viewport.px(wall.radius);
  const float foot = viewport.to_window({0, 0}).y;
  const Rect body{cap.x - r, cap.y - r, 2 * r, foot - cap.y + r};
  // Its shadow on the ground, away from the sun.
  glow(list, {cap.x - r * 0.6f, foot + r * 0.15f}, r * 2.4f, r * 0.35f, {0, 0, 0, 120});

  Outline outline{{body.right(), foot}, {body.x, foot}};
  for (int i = 0; i <= 24; ++i) {
    const float turn = std::numbers::pi_v<float> * (1 + static_cast<float>(i) / 24);
    outline.push_back(cap + Point{std::cos(turn), std::sin(turn)} * r);
  }
  fill(list, outline,
       Paint::horizontal(body, mix(palette::stone_shade, palette::stone, 0.35f), palette::stone));
  // Courses of blocks, every other one with a joint in its middle.
  const float course = std::max(r * 0.95f, 4.0f);
  const Color joint = faded(palette::stone_dark, 0.6f);
  const float width = std::max(r * 0.09f, 1.0f);
  const int courses = std::min(static_cast<int>((foot - cap.y) / course) + 1, 200);
  for (int i = 0; i < courses; ++i) {
    const float y = cap.y + course * static_cast<float>(i);
    const float next = std::min(y + course, foot);
    const Rect block{body.x + 1, y, body.w - 2, next - y};
    if (block.h > 2)
      fill_rounded(list, block, 0,
                   faded(i % 2 == 0 ? palette::stone_dark : palette::glint,
                         0.1f * noise(8, static_cast<std::uint32_t>(i))));
    line(list, {body.x, y}, {body.right(), y}, width, joint);
    const float x = i % 2 == 0 ? cap.x - r * 0.25f : cap.x + r * 0.3f;
    if (next - y > 2) line(list, {x, y}, {x, next}, width, joint);
  }
  // The dome catches the light.
  glow(list, cap + Point{r * 0.3f, -r * 0.5f}, r * 0.55f, r * 0.4f, faded(palette::sun, 0.55f));
  stroke(list, outline, std::max(r * 0.12f, 1.0f), palette::stone_dark);
}

/// A forked post that holds the projectile up; the physics knows nothing of it.
void draw_launch_post(DrawList& list, const Viewport& viewport, const carom::Ball& projectile) {
  const Point c = viewport.to_window(projectile.position);
  const float r = viewport.px(projectile.radius);
  const float foot = viewport.to_window({0, 0}).y;
  const Point fork = c + Point{0, r * 1.9f};
  if (foot - fork.y < r) return;
  const Color edge = palette::walnut_dark;
  const float width = r * 0.62f;
  const auto beam = [&](Point from, Point to, float wide) {
    fill(list, capsule(from, to, wide + std::max(r * 0.16f, 1.5f)), edge);
    fill(list, capsule(from, to, wide),
         Paint(from - Point{wide / 2, 0}, palette::walnut_lit, from + Point{wide / 2, 0},
               palette::walnut));
  };
  for (const float side : {-1.0f, 1.0f})
    beam(fork, c + Point{side * r * 1.15f, r * 0.45f}, width * 0.75f);
  beam(fork, {c.x, foot}, width);
  for (int i = 0; i < 3; ++i) {  // a cord where the fork begins
    const float y = fork.y + r * (0.15f + 0.24f * static_cast<float>(i));
    line(list, {c.x - width * 0.62f, y}, {c.x + width * 0.62f, y}, r * 0.12f, palette::brass);
  }
}

/// Beyond an open side balls are gone: a veil. A solid side is a wall of stone.
void draw_side(DrawList& list, const Rect& beyond, Point from, Point to, bool open) {
  if (beyond.w <= 0 || beyond.h <= 0) return;
  if (open) {
    // Darker away from the level.
    const bool left = beyond.center().x < from.x;
    const Color near = faded(palette::slate_bottom, 0.3f);
    const Color far = faded(palette::slate_bottom, 0.8f);
    fill_rounded(list, beyond, 0, Paint::horizontal(beyond, left ? far : near, left ? near : far));
    dashed_line(list, from, to, 1.5f, 6, faded(palette::cream, 0.35f));
  } else {
    fill_rounded(list, beyond, 0, mix(palette::stone_shade, palette::stone, 0.2f));
    const float course = std::max((beyond.w + beyond.h) / 40, 6.0f);
    const Color joint = faded(palette::stone_dark, 0.6f);
    const auto count = [course](float room) { return static_cast<int>(std::ceil(room / course)); };
    for (int row = 0; row < count(beyond.h); ++row) {
      const float y = beyond.y + course * static_cast<float>(row);
      line(list, {beyond.x, y}, {beyond.right(), y}, 1.5f, joint);
      for (int brick = 1 + row % 2; brick < count(beyond.w); brick += 2) {
        const float x = beyond.x + course * static_cast<float>(brick);
        line(list, {x, y}, {x, std::min(y + course, beyond.bottom())}, 1.5f, joint);
      }
    }
    line(list, from, to, 3, palette::stone_dark);
  }
}

/// The wear of a ball: cracks that run inwards from its rim, more and longer ones.
void draw_cracks(DrawList& list, Point c, float r, float wear, std::uint32_t id) {
  constexpr int most = 8;
  const float total = wear * most;
  for (int i = 0; static_cast<float>(i) < total; ++i) {
    const auto row = id * 16 + static_cast<std::uint32_t>(i);
    const float grown = std::min(total - static_cast<float>(i), 1.0f);
    // Spread by the golden angle, so that any number of them is spread well.
    float turn = tau * (0.618034f * static_cast<float>(i) + noise(id, 99));
    Point at = c + Point{std::cos(turn), std::sin(turn)} * (r * 0.98f);
    const float stride = r * 0.3f * (0.35f + 0.65f * grown);
    for (std::uint32_t bend = 0; bend < 3; ++bend) {
      const float swerve = (noise(row, bend) - 0.5f) * 1.9f;
      const Point next = at - Point{std::cos(turn + swerve), std::sin(turn + swerve)} * stride;
      const float width = std::max(r * (0.13f - 0.03f * static_cast<float>(bend)), 1.2f);
      line(list, at + Point{0, width * 0.7f}, next + Point{0, width * 0.7f}, width * 0.6f,
           faded(palette::glint, 0.45f));
      line(list, at, next, width, palette::ink);
      at = next;
    }
  }
}

/// Rings of a trunk, or the flecks of a stone.
void draw_texture(DrawList& list, Point c, float r, bool wood, std::uint32_t id) {
  if (wood) {
    const Point heart = c + Point{r * 0.08f, r * 0.06f};
    for (const float ring : {0.82f, 0.6f, 0.38f, 0.16f})
      stroke_circle(list, heart + (c - heart) * ring, r * ring, std::max(r * 0.07f, 1.0f),
                    faded(palette::wood_ring, 0.6f));
    return;
  }
  for (std::uint32_t i = 0; i < 9; ++i) {
    const float turn = tau * noise(id + 40, i);
    const float out = 0.8f * std::sqrt(noise(id + 41, i));
    const Point at = c + Point{std::cos(turn), std::sin(turn)} * (r * out);
    const float size = r * (0.06f + 0.09f * noise(id + 42, i));
    fill(list, ellipse(at, size * 1.3f, size), faded(palette::stone_dark, 0.4f));
  }
  stroke_circle(list, c, r * 0.95f, std::max(r * 0.1f, 1.0f), faded(palette::stone_dark, 0.55f));
}

/// Strong enemies wear iron: a hoop with rivets, a second one for the strongest.
void draw_armour(DrawList& list, Point c, float r, int hoops) {
  if (hoops == 0) return;
  stroke_circle(list, c, r * 0.92f, r * 0.16f, palette::iron);
  constexpr int rivets = 10;
  for (int i = 0; i < rivets; ++i) {
    const float turn = tau * (static_cast<float>(i) + 0.5f) / rivets;
    fill_disc(list, c + Point{std::cos(turn), std::sin(turn)} * (r * 0.92f), r * 0.05f,
              palette::brass_lit);
  }
  if (hoops > 1) stroke_circle(list, c, r * 0.76f, r * 0.07f, palette::iron);
}

/// Marks that tell a ball from others of its radius, without its cracks.
struct LevelBallLook {
  BallKind kind;
  bool enemy;
  bool lead;
  int hoops;             ///< of iron
  std::uint32_t flecks;  ///< which of three textures of stone

  static LevelBallLook of(const carom::Ball& ball, double full_solidity,
                          const carom::Scene& level) {
    const bool enemy = ball.role == carom::Role::enemy;
    const double breaking = breaking_speed(full_solidity, level);
    const BallKind kind = kind_of(ball, full_solidity, level);
    return {kind, enemy, carom::is_lead(ball.role),
            !enemy ? 0 : (breaking >= 500) + (breaking >= 1000),
            kind == BallKind::stone ? ball.id % 3 : 0};
  }
  std::uint32_t number() const {
    return static_cast<std::uint32_t>(kind) | static_cast<std::uint32_t>(hoops) << 8 | flecks << 16;
  }
};

void draw_body(DrawList& list, Point c, float r, const LevelBallLook& look) {
  if (look.enemy) draw_horns(list, c, r);
  // A dark rim parts balls from hills and sky.
  fill_disc(list, c, r + std::max(r * 0.07f, 1.0f), faded(palette::ink, 0.7f));
  draw_ball(list, c, r, look.kind);
  if (look.enemy)
    draw_armour(list, c, r, look.hoops);
  else if (!look.lead)
    draw_texture(list, c, r, look.kind == BallKind::wooden, look.flecks);
}

void draw_face(DrawList& list, Point c, float r, const LevelBallLook& look) {
  if (look.enemy) draw_villain_face(list, c, r);
  if (look.lead) draw_angry_face(list, c, r);
}

void draw_level_ball(DrawList& list, Point c, float r, const carom::Ball& ball,
                     double full_solidity, const carom::Scene& level) {
  using Of = Stamps::Key::Of;
  const auto look = LevelBallLook::of(ball, full_solidity, level);
  const float reach = 1.45f * r + 2;
  if (full_solidity == carom::infinite_solidity || ball.solidity >= full_solidity) {
    stamp(list, {Of::sound_ball, r, look.number()}, c, reach,
          [&look](DrawList& on, Point at, float radius) {
            draw_body(on, at, radius, look);
            draw_face(on, at, radius, look);
          });
    return;
  }
  // Cracks run between the ball and its face.
  stamp(list, {Of::worn_ball, r, look.number()}, c, reach,
        [&look](DrawList& on, Point at, float radius) { draw_body(on, at, radius, look); });
  draw_cracks(list, c, r,
              static_cast<float>(std::clamp(1 - ball.solidity / full_solidity, 0.0, 1.0)), ball.id);
  if (look.enemy || look.lead)
    stamp(list, {Of::face, r, look.number()}, c, r,
          [&look](DrawList& on, Point at, float radius) { draw_face(on, at, radius, look); });
}

/// An arrow at the top edge, over it, smaller the further up the ball is.
void draw_high_ball(DrawList& list, const Rect& area, Point c, float r, BallKind kind) {
  const float above = area.y - c.y;
  const float size =
      std::clamp(1 - above / (3 * area.h), 0.6f, 1.0f) * std::max({r, area.h * 0.03f, 10.0f});
  const Point tip{std::max(std::min(c.x, area.right() - size), area.x + size),
                  area.y + size * 0.5f};
  const std::array arrow{tip, tip + Point{size * 0.9f, size * 1.2f},
                         tip + Point{-size * 0.9f, size * 1.2f}};
  stroke(list, arrow, size * 0.3f, palette::ink);
  fill(list, arrow, palette::brass_lit);
  const Point below = tip + Point{0, size * 2.3f};
  fill_disc(list, below, size * 0.8f, faded(palette::ink, 0.7f));
  draw_ball(list, below, size * 0.7f, look_of(kind, *list.palette));
}

}  // namespace

BallKind kind_of(const carom::Ball& ball, double full_solidity, const carom::Scene& level) {
  if (carom::is_lead(ball.role)) return BallKind::ivory;
  if (ball.role == carom::Role::enemy) return BallKind::red;
  // A ball that no single throw can break is of stone.
  const bool wood = breaking_speed(full_solidity, level) <= games::max_launch_speed;
  return wood ? BallKind::wooden : BallKind::stone;
}

Viewport level_viewport(const Rect& area, const carom::Scene& level) {
  const double ground = level.height * ground_depth;
  double sky = 0;
  double deeper = 0;
  if (area.w > 0) {
    const double spare =
        static_cast<double>(area.h / area.w) * level.width - (level.height + ground);
    deeper = std::max(spare, 0.0) * 0.25;
    sky = std::max(spare, 0.0) - deeper;
  }
  return {area, {0, -ground - deeper}, {level.width, level.height + sky}};
}

void draw_level(DrawList& list, const Rect& area, const Viewport& viewport,
                const carom::Scene& level) {
  const Point bottom_left = viewport.to_window({0, 0});
  const Point top_right = viewport.to_window({level.width, level.height});
  draw_landscape(list, area, bottom_left.y, bottom_left.y - top_right.y);

  for (const carom::Hole& hole : level.holes) {
    const Point c = viewport.to_window(hole.position);
    glow(list, c, viewport.px(hole.radius) * 1.5f, viewport.px(hole.radius) * 1.5f,
         faded(palette::ink, 0.8f));
    fill_disc(list, c, viewport.px(hole.radius), palette::pocket);
    dashed_circle(list, c, viewport.px(hole.radius) * 0.8f, viewport.px(1.5), 9,
                  faded(list.palette->accents[1], 0.7f));
  }
  if (!level.balls.empty()) draw_launch_post(list, viewport, level.balls[0]);
  for (const carom::Obstacle& wall : level.obstacles) draw_wall(list, viewport, wall);

  const float left = bottom_left.x;
  const float right = top_right.x;
  const bool top_open = level.edges.top == carom::Edge::open;
  if (!top_open)
    draw_side(list, {left, area.y, right - left, top_right.y - area.y}, {left, top_right.y},
              top_right, false);
  draw_side(list, {area.x, area.y, left - area.x, area.h}, {left, area.y}, {left, area.bottom()},
            level.edges.left == carom::Edge::open);
  draw_side(list, {right, area.y, area.right() - right, area.h}, {right, area.y},
            {right, area.bottom()}, level.edges.right == carom::Edge::open);
}

void draw_level_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const carom::Scene& level, const Interpolator& motion, double fraction) {
  draw_trails(list, viewport, world, motion, fraction, [&](const carom::Ball& ball) {
    return mix(look_of(kind_of(ball, level.balls[ball.id].solidity, level), *list.palette).base,
               palette::cream, 0.4f);
  });
}

void draw_level_balls(DrawList& list, const Rect& area, const Viewport& viewport,
                      const carom::World& world, const carom::Scene& level,
                      const Interpolator& motion, double fraction) {
  const float ground = viewport.to_window({0, 0}).y;
  const auto each_ball = [&](const auto& visit) {
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (world.in_play(i))
        visit(world.ball(i), viewport.to_window(motion.position(world, i, fraction)));
    }
  };
  each_ball([&](const carom::Ball& ball, Point c) {  // fainter the higher the ball
    const float r = viewport.px(ball.radius);
    const float height = std::max(ground - c.y - r, 0.0f);
    const float nearness = std::max(1 - height / (r * 8), 0.0f);
    if (nearness > 0 && ground > area.y)
      glow(list, {c.x - height * 0.2f, ground + r * 0.12f}, r * (1.3f + 0.4f * (1 - nearness)),
           r * 0.3f, faded({0, 0, 0, 150}, nearness));
  });
  each_ball([&](const carom::Ball& ball, Point c) {
    const float r = viewport.px(ball.radius);
    const double full = level.balls[ball.id].solidity;
    if (c.y + r < area.y)
      draw_high_ball(list, area, c, r, kind_of(ball, full, level));
    else
      draw_level_ball(list, c, r, ball, full, level);
  });
}

bool any_above(const Rect& area, const Viewport& viewport, const carom::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    // Horns are half a radius high, and the ball may have been a little higher a step ago.
    if (world.in_play(i) &&
        viewport.to_window(ball.position).y - 3 * viewport.px(ball.radius) < area.y)
      return true;
  }
  return false;
}

}  // namespace app
