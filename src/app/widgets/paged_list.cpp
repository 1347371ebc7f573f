#include "app/widgets/paged_list.hpp"

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"

namespace app {
namespace {

// Units.
constexpr float button_width = 104;
constexpr float pager_width = 380;

}  // namespace

void PagedList::show(std::size_t page, std::size_t items, std::size_t per_page,
                     std::vector<Buttons::Button> own) {
  items_ = items;
  per_page_ = per_page;
  page_ = std::min(page, pages() - 1);
  std::vector<Buttons::Button> all;
  for (ButtonId item = 0; item < count(); ++item) all.push_back({item});
  if (pages() > 1) {
    all.push_back({previous, words_(Text::previous_page), words_(Text::tip_page)});
    all.push_back({next, words_(Text::next_page), words_(Text::tip_page)});
  }
  std::ranges::move(own, std::back_inserter(all));
  const Buttons before = std::exchange(buttons, Buttons(std::move(all)));
  buttons.keep_focus(before);
}

Rect PagedList::place_pager(const View& view, Rect foot) {
  if (pages() == 1) return foot;
  Rect pager = view.narrow() ? foot.cut_bottom(view.button(40) + 2 * view.px(2))
                             : foot.cut_right(std::min(view.px(pager_width), foot.w));
  pager = pager.inset(0, view.px(2));
  const float width = view.px(button_width);
  buttons.place(view, previous, pager.cut_left(width));
  buttons.place(view, next, pager.cut_right(width));
  label_ = pager;
  return foot;
}

std::optional<std::size_t> PagedList::page_of(ButtonId button) const {
  if (button != previous && button != next) return std::nullopt;
  return (page_ + (button == next ? 1 : pages() - 1)) % pages();
}

void PagedList::draw(Canvas& canvas) const {
  for (const Buttons::Button& button : buttons.all())
    if (button.id >= first_own) buttons.draw_one(canvas, button.id, 18);
  draw_pager(canvas);
}

void PagedList::draw_pager(Canvas& canvas) const {
  if (pages() == 1) return;
  for (const Button turn : {previous, next}) buttons.draw_one(canvas, turn, 18);
  label(canvas, label_, {Face::bold, 16, palette::cream, Align::center},
        words_(Text::page, {words_.number(static_cast<int>(page_) + 1),
                            words_.number(static_cast<int>(pages()))}));
}

}  // namespace app
