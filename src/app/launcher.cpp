#include "app/launcher.hpp"

#include "app/shapes.hpp"

namespace app {
namespace {

constexpr double grab_margin = 8;  ///< world px around the lead
constexpr float grab_least = 22;   ///< units, the least radius of the target

}  // namespace

std::optional<carom::Vec2> Launcher::click(carom::Vec2 at, bool on_lead) {
  if (!aim.active()) {
    missed = !on_lead;
    refused = false;
    if (on_lead) aim.begin(at);
    return std::nullopt;
  }
  aim.move(at);
  refused = aim.too_weak();  // a double click loses no turn
  return refused ? std::nullopt : std::optional(aim.drag());
}

bool on_lead(const carom::Ball& lead, Point at, const Viewport& viewport, const View& view) {
  const float reach = std::max(viewport.px(lead.radius + grab_margin), view.px(grab_least));
  return length(at - viewport.to_window(lead.position)) <= reach;
}

void draw_invitation(DrawList& list, const Viewport& viewport, const carom::Ball& lead,
                     bool hovered, Color color) {
  stroke_circle(list, viewport.to_window(lead.position),
                viewport.px(lead.radius * (hovered ? 2.0 : 1.7)), viewport.px(hovered ? 2.4 : 1.4),
                color);
}

}  // namespace app
