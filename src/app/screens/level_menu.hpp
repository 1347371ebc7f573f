#pragma once

#include "app/storage/campaign.hpp"
#include "app/text/text.hpp"
#include "app/widgets/screen.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The levels to choose from (§2.3.2): a card each, on as many pages as they need. A level that
/// cannot be played is grey and tells why.
class LevelMenu final : public Screen {
 public:
  LevelMenu(const Words& words, Campaign& campaign);

  void resize(const View& view) override;
  Transition event(const Input& input) override;
  Transition iterate(nanoseconds) override { return Transition::stay; }
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override { return false; }

 private:
  void show_page(std::size_t page);
  std::size_t pages() const { return (campaign_.levels.size() + per_page_ - 1) / per_page_; }
  std::size_t first() const { return page_ * per_page_; }
  std::size_t cards() const { return std::min(per_page_, campaign_.levels.size() - first()); }
  Transition choose(std::size_t button);
  void draw_card(Canvas& canvas, std::size_t button) const;
  static void draw_picture(Canvas& canvas, const Rect& area, const carom::Scene& level);
  std::string about(std::size_t index) const;
  std::string notice() const;

  Words words_;
  Campaign& campaign_;
  /// The page's cards; then, if there are several pages, back and forward; then
  /// practice on and off; then the title.
  Buttons buttons_{{}};
  std::size_t per_page_ = 1;
  std::size_t columns_ = 1;
  std::size_t page_ = 0;
  std::optional<std::size_t> told_;  ///< the broken level that was clicked last
  View view_;
  Rect heading_;  ///< empty where it stands in head_
  Rect head_;
  Rect grid_;
  Rect foot_;
  Rect page_label_;
  Rect card_;  ///< only its size
};

}  // namespace app
