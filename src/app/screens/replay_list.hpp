#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/paged_list.hpp"

namespace app {

/// The replays saved, a line each, on as many pages as they need.
class ReplayList final : public Screen {
 public:
  ReplayList(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;

 private:
  /// A line of the page.
  struct Entry {
    std::string name;
    std::optional<replay::Replay> replay;  ///< none: it cannot be shown
    ReplayFault fault{};
  };

  /// Beside the replays, an item of the list each.
  enum Button : ButtonId { paste = PagedList::first_own, title };

  void show_page(std::size_t page);
  Navigation choose(ButtonId button);
  Navigation take_pasted_replay();
  std::string describe(const Entry& entry) const;
  std::string fault(const Entry& entry) const;
  void draw_entry(Canvas& canvas, ButtonId index) const;

  Words words_;
  Session& session_;
  std::vector<std::string> names_;
  std::vector<Entry> entries_;  ///< of the page
  PagedList list_;
  std::size_t per_page_ = 1;
  std::size_t first_ = 0;  ///< in names_, what the page begins with
  std::string message_;
  View view_;
  Rect head_;
  Rect rows_;
  Rect foot_;
  Rect message_box_;  ///< the foot beside what turns the pages
};

/// "Billiards"; against a computer the players: "Player 1 – Computer 4".
std::string table_name(const Words& words, const replay::Replay& table);

/// A game in a line: "Billiards · 12 turns · 300 : 200".
std::string line_of(const Words& words, const Campaign& campaign, const replay::Replay& replay);

}  // namespace app
