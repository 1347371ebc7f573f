#pragma once

#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// A list of items, a button each, on as many pages as they need, together with the screen's other
/// buttons. The items of a page are numbered from 0.
class PagedList {
 public:
  enum Button : ButtonId {
    previous = ButtonId{1} << 20,  ///< there if there are several pages
    next,
    first_own,  ///< the screen's own begin here
  };

  explicit PagedList(const Words& words) : words_(words) {}

  /// Shows a page of the list; `page` beyond the end is the last one. `own`: the screen's buttons,
  /// which have the focus last. The focus stays on its button.
  void show(std::size_t page, std::size_t items, std::size_t per_page,
            std::vector<Buttons::Button> own);
  /// Puts what turns the pages into the foot, if it is needed, and returns the rest.
  Rect place_pager(const View& view, Rect foot);

  std::size_t pages() const {
    return std::max<std::size_t>((items_ + per_page_ - 1) / per_page_, 1);
  }
  /// The item that is the page's first.
  std::size_t first() const { return page_ * per_page_; }
  /// Number of items on the page.
  std::size_t count() const { return std::min(per_page_, items_ - first()); }

  /// The page that a button goes to, round and round; none if it is another button.
  std::optional<std::size_t> page_of(ButtonId button) const;

  /// All buttons but the items, and which page it is.
  void draw(Canvas& canvas) const;
  /// Of these only what turns the pages.
  void draw_pager(Canvas& canvas) const;

  Buttons buttons;

 private:
  Words words_;
  std::size_t items_ = 0;
  std::size_t per_page_ = 1;
  std::size_t page_ = 0;
  Rect label_;
};

}  // namespace app
