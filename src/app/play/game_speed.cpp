#include "app/play/game_speed.hpp"

#include <algorithm>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

bool GameSpeed::event(const Input& input, bool free, bool watches) {
  if (std::holds_alternative<PointerReleased>(input) ||
      std::holds_alternative<PointerCancelled>(input))
    let_go();
  if (const auto* released = std::get_if<CommandReleased>(&input)) {
    if (released->command == Command::fast) fast_ = false;
    return false;
  }
  if (paused_) {
    // The press that ends the pause does nothing else: a click is not a shot.
    const bool ends = is_press_of_key(input) || std::holds_alternative<PointerPressed>(input);
    if (ends) paused_ = false;
    return ends || std::holds_alternative<TextTyped>(input) ||
           std::holds_alternative<WheelTurned>(input);
  }
  if (!free) return false;
  if (std::holds_alternative<PointerPressed>(input) && watches) pressed_ = nanoseconds{0};
  if (is_command(input, Command::pause)) {
    paused_ = true;
    fast_ = false;
    let_go();
    return true;
  }
  if (!is_command(input, Command::fast)) return false;
  fast_ = true;
  return true;
}

void GameSpeed::decisive() {
  if (was_slow_) return;
  was_slow_ = true;
  slow_left_ = slow_time;
}

Speed GameSpeed::pass(nanoseconds elapsed) {
  const bool slow = slow_left_ > nanoseconds{0};
  slow_left_ = std::max(slow_left_ - elapsed, nanoseconds{0});
  if (pressed_) *pressed_ += elapsed;
  // Not wanted by a player in a hurry.
  if (fast_ || (pressed_ && *pressed_ > touch_time)) return fast_forward;
  if (slow || !easing_) return slow ? slow_motion : real_speed;
  eased_ = std::min(eased_ + elapsed, ease_time);
  const auto more = (eased_quarters - real_speed.quarters) * eased_ / ease_time;
  return {real_speed.quarters + static_cast<int>(more)};
}

void GameSpeed::draw_veil(Canvas& canvas, const Rect& area, const Words& words) const {
  if (!paused_) return;
  DrawList& list = canvas.list;
  fill_rounded(list, area, 0, palette::scrim);
  const float height = canvas.px(112);
  Rect box = centered(area.center(), std::min(canvas.px(440), area.w - canvas.px(16)),
                      std::min(height, area.h));
  const float radius = canvas.px(16);
  fill_rounded(list, box, radius, Color{14, 20, 25, 235});
  stroke_rounded(list, box, radius, canvas.px(2), palette::brass);
  box = box.inset(canvas.px(20), canvas.px(14));
  Rect line = box.cut_top(box.h * 0.58f);
  // Two bars, as on every player.
  Rect sign = line.cut_left(canvas.px(48));
  sign = centered(sign.center(), canvas.px(24), canvas.px(32));
  fill_rounded(list, sign.cut_left(canvas.px(8)), canvas.px(2), palette::brass_lit);
  fill_rounded(list, sign.cut_right(canvas.px(8)), canvas.px(2), palette::brass_lit);
  line.cut_right(canvas.px(48));
  label(canvas, line, {Face::black, 34, palette::cream, Align::center}, words(Text::paused));
  label(canvas, box, {Face::regular, 18, palette::muted, Align::center}, words(Text::hint_paused));
}

}  // namespace app
