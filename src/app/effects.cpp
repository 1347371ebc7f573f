#include "app/effects.hpp"

#include "app/label.hpp"
#include "app/markers.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {
namespace {

using std::chrono::milliseconds;

constexpr nanoseconds sink_time = milliseconds{260};
constexpr nanoseconds float_time = milliseconds{1500};
constexpr nanoseconds announcement_time = milliseconds{1600};
constexpr nanoseconds fade_time = milliseconds{250};

/// How much of its time has passed, in [0, 1].
float progress(nanoseconds age, nanoseconds total) {
  return std::clamp(static_cast<float>(age.count()) / static_cast<float>(total.count()), 0.0f,
                    1.0f);
}

/// Opacity of something that fades in and out again.
float fade(nanoseconds age, nanoseconds total) {
  return std::min(progress(age, fade_time), progress(total - age, fade_time));
}

}  // namespace

void Effects::sink(carom::Vec2 from, carom::Vec2 hole, double radius, const BallLook& look) {
  sinking_.push_back({from, hole, radius, look, {}});
}

void Effects::float_up(carom::Vec2 from, std::string text, int player) {
  floating_.push_back({from, std::move(text), player, {}});
}

void Effects::announce(std::string headline, std::string detail, int player) {
  announcement_ = {std::move(headline), std::move(detail), player, {}};
}

void Effects::advance(nanoseconds elapsed) {
  for (Sinking& ball : sinking_) ball.age += elapsed;
  for (Floating& text : floating_) text.age += elapsed;
  std::erase_if(sinking_, [](const Sinking& ball) { return ball.age >= sink_time; });
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
    const BallLook look{mix(ball.look.base, palette::pocket, t),
                        mix(ball.look.shade, palette::pocket, t)};
    draw_ball(list, viewport.to_window(at), viewport.px(ball.radius) * (1 - 0.4f * t), look,
              1 - t * t);
  }
}

void Effects::draw_over_balls(Canvas& canvas, const Viewport& viewport, const Rect& table) const {
  for (const Floating& text : floating_) {
    const float t = progress(text.age, float_time);
    const float rise = canvas.px(48) * (1 - (1 - t) * (1 - t));
    const TextStyle style{Face::bold, 20, palette::accents[static_cast<std::size_t>(text.player)],
                          Align::center};
    pill(canvas, viewport.to_window(text.from) - Point{0, rise}, table, style, text.text,
         fade(text.age, float_time));
  }
  if (announcement_) {
    const float opacity = fade(announcement_->age, announcement_time);
    const bool two_lines = !announcement_->detail.empty();
    // Above the middle: the cue ball and what it aims at stay in sight.
    const float height = canvas.px(two_lines ? 88 : 64);
    const Point middle{table.center().x, table.y + table.h * 0.12f + height / 2};
    Rect box =
        centered(middle, std::min(canvas.px(440), canvas.view.width - canvas.px(32)), height);
    const Color accent = palette::accents[static_cast<std::size_t>(announcement_->player)];
    fill_rounded(canvas.list, box.moved({0, canvas.px(4)}), canvas.px(16),
                 faded(palette::shadow, opacity), canvas.px(16));
    fill_rounded(canvas.list, box, canvas.px(16), faded({14, 20, 25, 235}, opacity));
    stroke_rounded(canvas.list, box, canvas.px(16), canvas.px(2), faded(accent, opacity));
    box = box.inset(canvas.px(20), canvas.px(10));
    draw_marker(canvas.list, announcement_->player, {box.x + canvas.px(20), box.center().y},
                canvas.px(20), opacity);
    box.cut_left(canvas.px(56));
    const Rect headline = two_lines ? box.cut_top(canvas.px(40)) : box;
    label(canvas, headline, {Face::black, 32, faded(palette::cream, opacity)},
          announcement_->headline);
    if (two_lines)
      label(canvas, box, {Face::regular, 18, faded(palette::muted, opacity)},
            announcement_->detail);
  }
}

}  // namespace app
