#include "app/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

Buttons::Buttons(std::vector<std::string> labels, std::optional<std::size_t> primary)
    : primary_(primary) {
  for (std::string& label : labels) buttons_.push_back({std::move(label), {}, {}});
}

std::optional<std::size_t> Buttons::find(Point at) const {
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    if (buttons_[i].box.contains(at)) return i;
  return std::nullopt;
}

/// The nearest one that a finger there can mean.
std::optional<std::size_t> Buttons::touched(Point at) const {
  std::optional<std::size_t> nearest;
  float least = finger_;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const Rect& box = buttons_[i].box;
    const Rect target = centered(box.center(), std::max(box.w, finger_), std::max(box.h, finger_));
    const Point inside{std::clamp(at.x, box.x, box.right()), std::clamp(at.y, box.y, box.bottom())};
    const float away = length(at - inside);
    if (!target.contains(at) || away >= least) continue;
    nearest = i;
    least = away;
  }
  return nearest;
}

void Buttons::move_focus(std::ptrdiff_t by) {
  const auto n = static_cast<std::ptrdiff_t>(buttons_.size());
  if (focused_)
    focused_ =
        static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(*focused_) + by) % n + n) % n);
  else
    focused_ = primary_.value_or(by > 0 ? 0 : buttons_.size() - 1);
}

void Buttons::move_focus_to_row(bool below) {
  std::optional<std::size_t> nearest;
  if (columns_ > 1 && focused_) {
    const Rect& from = buttons_[*focused_].box;
    // The nearest row first; in it, what is nearest aside.
    const auto away = [&](std::size_t i) {
      const Rect& to = buttons_[i].box;
      return std::pair{below ? to.y - from.bottom() : from.y - to.bottom(),
                       std::abs(to.center().x - from.center().x)};
    };
    for (std::size_t i = 0; i < buttons_.size(); ++i)
      if (away(i).first >= 0 && (!nearest || away(i) < away(*nearest))) nearest = i;
  }
  if (nearest) {
    focused_ = nearest;
  } else {
    const auto by = static_cast<std::ptrdiff_t>(columns_);
    move_focus(below ? by : -by);
  }
}

std::optional<std::size_t> Buttons::event(const Input& input) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) {
    hovered_ = touch_ ? touched(moved->at) : find(moved->at);
  } else if (const auto* press = std::get_if<PointerPressed>(&input)) {
    focused_.reset();
    touch_ = press->touch;
    hovered_ = touch_ ? touched(press->at) : find(press->at);
    pressed_ = press->button == PointerButton::left ? hovered_ : std::nullopt;
  } else if (const auto* release = std::get_if<PointerReleased>(&input)) {
    if (release->button != PointerButton::left) return std::nullopt;
    const auto pressed = std::exchange(pressed_, std::nullopt);
    const auto over = touch_ ? touched(release->at) : find(release->at);
    touch_ = false;
    if (pressed && pressed == over) return pressed;
  } else if (std::holds_alternative<PointerLeft>(input) ||
             std::holds_alternative<PointerCancelled>(input)) {
    hovered_.reset();
    pressed_.reset();
    touch_ = false;
  } else if (const auto* key = std::get_if<KeyPressed>(&input)) {
    switch (key->key) {
      case Key::tab:
      case Key::right:
        move_focus(1);
        break;
      case Key::back_tab:
      case Key::left:
        move_focus(-1);
        break;
      case Key::down:
        move_focus_to_row(true);
        break;
      case Key::up:
        move_focus_to_row(false);
        break;
      case Key::enter:
        return focused_ ? focused_ : primary_;
      case Key::space:
        return focused_;
      default:
        break;
    }
  }
  return std::nullopt;
}

void Buttons::keep_focus(const Buttons& before, std::size_t tail) {
  if (!before.focused_) return;
  const std::size_t from_end = before.size() - *before.focused_;
  if (from_end <= tail && from_end <= size())
    focused_ = size() - from_end;
  else if (*before.focused_ + tail < size())
    focused_ = before.focused_;
}

bool Buttons::move_focus(std::initializer_list<Buttons*> groups, const Input& input) {
  const bool forward =
      is_key(input, Key::tab) || is_key(input, Key::right) || is_key(input, Key::down);
  const bool backward =
      is_key(input, Key::back_tab) || is_key(input, Key::left) || is_key(input, Key::up);
  if (!forward && !backward) return false;
  std::size_t all = 0;
  std::optional<std::size_t> focused;
  for (const Buttons* group : groups) {
    if (!group) continue;
    if (group->focused_) focused = all + *group->focused_;
    all += group->size();
  }
  std::size_t next = forward ? 0 : all - 1;
  if (focused) next = (*focused + (forward ? 1 : all - 1)) % all;
  for (Buttons* group : groups) {
    if (!group) continue;
    group->focused_ = next < group->size() ? std::optional(next) : std::nullopt;
    next -= group->size();  // before the group's beginning: a number beyond every end
  }
  return true;
}

std::string Buttons::tip() const {
  const auto shown = hovered_ ? hovered_ : focused_;
  return shown ? buttons_[*shown].tip : std::string();
}

void Buttons::draw(Canvas& canvas, float text_size) const {
  for (std::size_t i = 0; i < buttons_.size(); ++i) draw_one(canvas, i, text_size);
}

Buttons::Look Buttons::draw_face(Canvas& canvas, std::size_t index) const {
  const bool primary = primary_ == index;
  Color face = primary ? palette::brass : palette::panel_lit;
  if (hovered(index)) face = mix(face, palette::cream, 0.18f);
  if (pressed(index)) face = mix(face, palette::ink, 0.3f);
  const Button& button = buttons_[index];
  if (!button.tip.empty() && (hovered(index) || focused(index)))
    canvas.list.tip = Tip{button.box, button.tip};
  Rect box = button.box;
  const float radius = canvas.px(8);

  if (focused(index))
    stroke_rounded(canvas.list, box.inset(-canvas.px(3)), radius + canvas.px(3), canvas.px(2),
                   palette::cream);
  fill_rounded(canvas.list, box.moved({0, canvas.px(2)}), radius, faded(palette::ink, 0.6f),
               canvas.px(3));
  if (pressed(index)) box = box.moved({0, canvas.px(1)});
  fill_rounded(canvas.list, box, radius,
               Paint::vertical(box, mix(face, palette::cream, 0.10f), face));
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, faded(palette::cream, 0.22f));
  return {box, primary ? palette::ink : palette::cream};
}

void Buttons::draw_one(Canvas& canvas, std::size_t index, float text_size) const {
  const Look look = draw_face(canvas, index);
  const Button& button = buttons_[index];
  label(canvas, look.box.inset(canvas.px(10), 0), {Face::bold, text_size, look.ink, Align::center},
        button.label);
  list_box(canvas.list, index, button.label);
}

void Buttons::list_box(DrawList& list, std::size_t index, std::string text) const {
  list.boxes.push_back({.kind = Box::Kind::button,
                        .area = box(index),
                        .text = std::move(text),
                        .focused = focused(index),
                        .primary = primary_ == index,
                        .tip = buttons_[index].tip});
}

}  // namespace app
