#pragma once

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/paged_list.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The levels to choose from (§2.3.2): a card each, on as many pages as they need. A level that
/// cannot be played is grey and tells why.
class LevelMenu final : public Screen {
 public:
  LevelMenu(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  Navigation levels_changed() override { return ShowLevels{}; }

 private:
  /// Beside the levels, an item of the list each.
  enum Button : ButtonId { practice = PagedList::first_own, title };

  void show_page(std::size_t page);
  Navigation choose(ButtonId button);
  void draw_card(Canvas& canvas, ButtonId button) const;
  static void draw_picture(Canvas& canvas, const Rect& area, const carom::Scene& level);
  std::string about(std::size_t index) const;
  std::string notice() const;

  Words words_;
  Campaign& campaign_;
  Sounds& sounds_;
  PagedList list_;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::optional<std::size_t> told_;  ///< the broken level that was clicked last
  View view_;
  Rect heading_;  ///< empty where it stands in head_
  Rect head_;
  Rect grid_;
  Rect foot_;
  Rect card_;  ///< only its size
};

}  // namespace app
