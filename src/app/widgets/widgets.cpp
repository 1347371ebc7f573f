#include "app/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr float least_size = 16;  ///< units, of a label that has a brief form

}  // namespace

const Buttons::Button* Buttons::find(ButtonId id) const {
  const auto found = std::ranges::find(buttons_, id, &Button::id);
  return found == buttons_.end() ? nullptr : &*found;
}

std::optional<ButtonId> Buttons::pointed(Point at) const {
  for (const Button& button : buttons_)
    if (button.box.contains(at)) return button.id;
  return std::nullopt;
}

/// The nearest one that a finger there can mean.
std::optional<ButtonId> Buttons::touched(Point at) const {
  std::optional<ButtonId> nearest;
  float least = finger_;
  for (const Button& button : buttons_) {
    const Rect& box = button.box;
    const Rect target = centered(box.center(), std::max(box.w, finger_), std::max(box.h, finger_));
    const Point inside{std::clamp(at.x, box.x, box.right()), std::clamp(at.y, box.y, box.bottom())};
    const float away = length(at - inside);
    if (!target.contains(at) || away >= least) continue;
    nearest = button.id;
    least = away;
  }
  return nearest;
}

void Buttons::move_focus(std::ptrdiff_t by) {
  const auto n = static_cast<std::ptrdiff_t>(buttons_.size());
  if (!focused_) {
    focused_ = primary_.value_or(by > 0 ? buttons_.front().id : buttons_.back().id);
    return;
  }
  const std::ptrdiff_t next = (static_cast<std::ptrdiff_t>(index_of(*focused_)) + by) % n;
  focused_ = buttons_[static_cast<std::size_t>((next + n) % n)].id;
}

void Buttons::move_focus_to_row(bool below) {
  const Button* nearest = nullptr;
  if (columns_ > 1 && focused_) {
    const Rect& from = box(*focused_);
    // The nearest row first; in it, what is nearest aside.
    const auto away = [&](const Button& button) {
      const Rect& to = button.box;
      return std::pair{below ? to.y - from.bottom() : from.y - to.bottom(),
                       std::abs(to.center().x - from.center().x)};
    };
    for (const Button& button : buttons_)
      if (away(button).first >= 0 && (!nearest || away(button) < away(*nearest))) nearest = &button;
  }
  if (nearest) {
    focused_ = nearest->id;
  } else {
    const auto by = static_cast<std::ptrdiff_t>(columns_);
    move_focus(below ? by : -by);
  }
}

std::optional<ButtonId> Buttons::event(const Input& input, Sounds& sounds) {
  const auto click = [&] { sounds.note({SoundKind::click}); };
  if (const auto* moved = std::get_if<PointerMoved>(&input)) {
    hovered_ = touch_ ? touched(moved->at) : pointed(moved->at);
  } else if (const auto* press = std::get_if<PointerPressed>(&input)) {
    focused_.reset();
    touch_ = press->touch;
    hovered_ = touch_ ? touched(press->at) : pointed(press->at);
    pressed_ = press->button == PointerButton::left ? hovered_ : std::nullopt;
    if (pressed_) click();
  } else if (const auto* release = std::get_if<PointerReleased>(&input)) {
    if (release->button != PointerButton::left) return std::nullopt;
    const auto pressed = std::exchange(pressed_, std::nullopt);
    const auto over = touch_ ? touched(release->at) : pointed(release->at);
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
      case Key::space: {
        const auto chosen = focused_ || key->key == Key::space ? focused_ : primary_;
        if (chosen) click();
        return chosen;
      }
      default:
        break;
    }
  }
  return std::nullopt;
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
    if (group->focused_) focused = all + group->index_of(*group->focused_);
    all += group->size();
  }
  std::size_t next = forward ? 0 : all - 1;
  if (focused) next = (*focused + (forward ? 1 : all - 1)) % all;
  for (Buttons* group : groups) {
    if (!group) continue;
    group->focused_.reset();
    if (next < group->size()) group->focused_ = group->buttons_[next].id;
    next -= group->size();  // before the group's beginning: a number beyond every end
  }
  return true;
}

std::string Buttons::tip() const {
  const auto shown = hovered_ ? hovered_ : focused_;
  return shown ? find(*shown)->tip : std::string();
}

void Buttons::draw(Canvas& canvas, float text_size) const {
  for (const Button& button : buttons_) draw_one(canvas, button.id, text_size);
}

Buttons::Look Buttons::draw_face(Canvas& canvas, ButtonId id) const {
  const bool primary = primary_ == id;
  Color face = primary ? palette::brass : palette::panel_lit;
  if (hovered(id)) face = mix(face, palette::cream, 0.18f);
  if (pressed(id)) face = mix(face, palette::ink, 0.3f);
  const Button& button = *find(id);
  if (!button.tip.empty() && (hovered(id) || focused(id)))
    canvas.list.tip = Tip{button.box, button.tip};
  Rect box = button.box;
  const float radius = canvas.px(8);

  if (focused(id))
    stroke_rounded(canvas.list, box.inset(-canvas.px(3)), radius + canvas.px(3), canvas.px(2),
                   palette::cream);
  fill_rounded(canvas.list, box.moved({0, canvas.px(2)}), radius, faded(palette::ink, 0.6f),
               canvas.px(3));
  if (pressed(id)) box = box.moved({0, canvas.px(1)});
  fill_rounded(canvas.list, box, radius,
               Paint::vertical(box, mix(face, palette::cream, 0.10f), face));
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, faded(palette::cream, 0.22f));
  return {box, primary ? palette::ink : palette::cream};
}

void Buttons::draw_one(Canvas& canvas, ButtonId id, float text_size) const {
  const Look look = draw_face(canvas, id);
  const Button& button = *find(id);
  const Rect inside = look.box.inset(canvas.px(10), 0);
  const TextStyle style{Face::bold, text_size, look.ink, Align::center};
  const bool brief =
      !button.brief.empty() &&
      label_width(canvas, {Face::bold, least_size, look.ink}, button.label) > inside.w;
  label(canvas, inside, style, brief ? button.brief : button.label);
  list_box(canvas.list, id, button.label);
}

void Buttons::list_box(DrawList& list, ButtonId id, std::string text) const {
  list.boxes.push_back({.kind = Box::Kind::button,
                        .area = box(id),
                        .text = std::move(text),
                        .focused = focused(id),
                        .primary = primary_ == id,
                        .tip = find(id)->tip});
}

}  // namespace app
