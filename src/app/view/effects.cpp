#include "app/view/effects.hpp"

#include <array>
#include <numbers>

#include "app/graphics/label.hpp"
#include "app/graphics/markers.hpp"
#include "app/graphics/noise.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/clear_place.hpp"

namespace app {
namespace {

constexpr nanoseconds sink_time = milliseconds{260};
constexpr nanoseconds burst_time = milliseconds{900};
constexpr nanoseconds shake_time = milliseconds{350};
constexpr nanoseconds float_time = milliseconds{1500};
constexpr nanoseconds announcement_time = milliseconds{1600};
constexpr nanoseconds fade_time = milliseconds{250};

/// The part of its time that has passed, in [0, 1].
float progress(nanoseconds age, nanoseconds total) {
  return std::clamp(static_cast<float>(age.count()) / static_cast<float>(total.count()), 0.0f,
                    1.0f);
}

/// Opacity of something that fades in and out again.
float fade(nanoseconds age, nanoseconds total) {
  return std::min(progress(age, fade_time), progress(total - age, fade_time));
}

}  // namespace

void Effects::sink(carom::Vec2 from, carom::Vec2 hole, double radius, BallKind kind) {
  sinking_.push_back({from, hole, radius, kind, {}});
}

void Effects::burst(carom::Vec2 at, double radius, BallKind kind, std::uint32_t id) {
  bursting_.push_back({at, radius, kind, id, {}});
}

void Effects::float_up(carom::Vec2 from, std::string text, int player) {
  floating_.push_back({from, std::move(text), player, {}});
}

void Effects::announce(std::string headline, std::string detail, std::optional<int> player) {
  announcement_ = {std::move(headline), std::move(detail), player, {}};
}

void Effects::advance(nanoseconds elapsed) {
  for (Sinking& ball : sinking_) ball.age += elapsed;
  for (Bursting& ball : bursting_) ball.age += elapsed;
  for (Floating& text : floating_) text.age += elapsed;
  std::erase_if(sinking_, [](const Sinking& ball) { return ball.age >= sink_time; });
  std::erase_if(bursting_, [](const Bursting& ball) { return ball.age >= burst_time; });
  std::erase_if(floating_, [](const Floating& text) { return text.age >= float_time; });
  if (announcement_) {
    announcement_->age += elapsed;
    if (announcement_->age >= announcement_time) announcement_.reset();
  }
}

void Effects::draw_under_balls(DrawList& list, const Viewport& viewport) const {
  for (const Sinking& ball : sinking_) {
    const float t = progress(ball.age, sink_time);
    const carom::Vec2 at = ball.from + static_cast<double>(t) * (ball.hole - ball.from);
    BallLook look = look_of(ball.kind, *list.palette);
    look.base = mix(look.base, palette::pocket, t);
    look.shade = mix(look.shade, palette::pocket, t);
    draw_ball(list, viewport.to_window(at), viewport.px(ball.radius) * (1 - 0.4f * t), look,
              1 - t * t);
  }
}

void Effects::shake(DrawList& list, std::size_t first, const Rect& area) const {
  float strongest = 0;
  float age = 0;
  for (const Bursting& ball : bursting_) {
    const float rest = 1 - progress(ball.age, shake_time);
    if (rest <= strongest) continue;
    strongest = rest;
    age = std::chrono::duration<float>(ball.age).count();
  }
  if (strongest == 0) return;
  const float share = 0.008f * strongest * strongest;
  const float reach = share * std::min(area.w, area.h);
  const Point off{reach * std::sin(age * 140), reach * std::cos(age * 110)};
  // A little larger, so that no edge of the picture comes in.
  const float scale = 1 + 2 * share;
  const Point middle = area.center();
  for (std::size_t i = first; i < list.vertices.size(); ++i) {
    Point& at = list.vertices[i].position;
    at = middle + (at - middle) * scale + off;
  }
}

void Effects::draw_burst(Canvas& canvas, const Viewport& viewport, const Bursting& ball) {
  DrawList& list = canvas.list;
  const BallLook look = look_of(ball.kind, *list.palette);
  const float t = progress(ball.age, burst_time);
  const Point c = viewport.to_window(ball.at);
  const float r = viewport.px(ball.radius);
  // A flash and a ring that opens, over in a third of the time.
  const float early = std::max(1 - t * 3, 0.0f);
  if (early > 0) {
    const float out = canvas.calm ? r * 1.4f : r * (1 + 1.6f * (1 - early * early));
    glow(list, c, out * 1.3f, out * 1.3f, faded(palette::sun, 0.9f * early));
    stroke_circle(list, c, out, r * 0.22f * early + 1, faded(palette::glint, early));
  }
  if (canvas.calm) return;
  constexpr std::uint32_t shards = 18;
  const float opacity = std::min(1.0f, (1 - t) * 2.5f);
  for (std::uint32_t i = 0; i < shards; ++i) {
    const auto any = [&](std::uint32_t what) { return noise(ball.id * 8 + what, i); };
    const float turn = 2 * std::numbers::pi_v<float> * (static_cast<float>(i) + any(0)) / shards;
    // In radii of the ball: outwards, and down with the time squared.
    const float way = r * t * (1.5f + 4.5f * any(1));
    const Point at = c + Point{std::cos(turn), std::sin(turn)} * (r * 0.4f + way) +
                     Point{0, r * t * (6.5f * t - 1.5f)};
    const float size = r * (0.16f + 0.26f * any(2)) * (1 - 0.4f * t);
    const float spin = turn + t * 14 * (any(3) - 0.5f);
    std::array<Point, 3> shard;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float angle = spin + 2.1f * static_cast<float>(corner);
      shard[corner] = at + Point{std::cos(angle), std::sin(angle)} *
                               (size * (0.7f + 0.5f * any(4 + static_cast<std::uint32_t>(corner))));
    }
    stroke(list, shard, 1.5f, faded(palette::ink, 0.6f * opacity));
    fill(list, shard, faded(mix(look.base, look.shade, any(7) * 0.7f), opacity));
  }
}

void Effects::draw_over_balls(Canvas& canvas, const Viewport& viewport, const Rect& table,
                              const carom::World& world) const {
  for (const Bursting& ball : bursting_) draw_burst(canvas, viewport, ball);
  std::vector<Rect> taken;
  for (const Floating& text : floating_) {
    const float t = progress(text.age, float_time);
    const float rise = canvas.px(48) * (canvas.calm ? 0.6f : 1 - (1 - t) * (1 - t));
    const Color accent = canvas.list.palette->accents[static_cast<std::size_t>(text.player)];
    const TextStyle style{Face::bold, 20, accent, Align::center};
    Rect box =
        pill_box(canvas, viewport.to_window(text.from) - Point{0, rise}, table, style, text.text);
    // Points made at one place stand above each other.
    for (const Rect& other : taken)
      if (box.overlaps(other)) box.y = std::max(other.y - box.h, table.y);
    taken.push_back(box);
    pill(canvas, box, style, text.text, fade(text.age, float_time));
  }
  if (announcement_) draw_announcement(canvas, table, things_in(world, viewport));
}

void Effects::draw_announcement(Canvas& canvas, const Rect& table,
                                std::span<const Rect> things) const {
  const float opacity = fade(announcement_->age, announcement_time);
  const std::optional<int> player = announcement_->player;
  const bool two_lines = !announcement_->detail.empty();
  // Above the middle: the cue ball and what it aims at stay in sight.
  const float height = canvas.px(two_lines ? 88 : 64);
  const Point middle{table.center().x, table.y + table.h * 0.12f + height / 2};
  const Align align = player ? Align::left : Align::center;
  const TextStyle headline{Face::black, 32, faded(palette::cream, opacity), align};
  const float alone =
      label_width(canvas, headline, announcement_->headline) + canvas.px(player ? 100 : 48);
  Rect box = centered(
      middle,
      std::min({two_lines ? canvas.px(440) : alone, canvas.view.width - canvas.px(32), table.w}),
      height);
  box = clear_place(box, table, things);
  const Color accent =
      player ? canvas.list.palette->accents[static_cast<std::size_t>(*player)] : palette::brass;
  fill_rounded(canvas.list, box.moved({0, canvas.px(4)}), canvas.px(16),
               faded(palette::shadow, opacity), canvas.px(16));
  fill_rounded(canvas.list, box, canvas.px(16), faded({14, 20, 25, 235}, opacity));
  stroke_rounded(canvas.list, box, canvas.px(16), canvas.px(2), faded(accent, opacity));
  box = box.inset(canvas.px(20), canvas.px(10));
  if (player) {
    draw_marker(canvas.list, *player, {box.x + canvas.px(20), box.center().y}, canvas.px(20),
                opacity);
    box.cut_left(canvas.px(56));
  }
  const Rect line = two_lines ? box.cut_top(canvas.px(40)) : box;
  label_or_elide(canvas, line, headline, announcement_->headline);
  if (two_lines)
    label_or_elide(canvas, box, {Face::regular, 18, faded(palette::muted, opacity), align},
                   announcement_->detail);
}

}  // namespace app
