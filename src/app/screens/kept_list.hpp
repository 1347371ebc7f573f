#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/dialog.hpp"
#include "app/widgets/paged_list.hpp"

namespace app {

/// The games in progress, that played last first: each can be continued, or deleted.
class KeptList final : public Screen {
 public:
  KeptList(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  Navigation answered(ButtonId button) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;

 private:
  /// A line of the page.
  struct Entry {
    std::string name;
    std::optional<KeptGames::Kept> kept;  ///< none: it cannot be read
    ReplayFault fault{};
  };

  /// Beside the games, of which each is two items of the list: continue, delete.
  enum Button : ButtonId { title = PagedList::first_own };
  enum Reply : ButtonId { yes, no };

  void show_page(std::size_t page);
  Navigation choose(ButtonId button);
  Navigation ask(const Entry& entry);
  std::string described(const std::string& what) const;
  std::string describe(const Entry& entry) const;
  void draw_entry(Canvas& canvas, ButtonId button) const;

  Words words_;
  Session& session_;
  std::vector<std::string> names_;
  std::vector<Entry> entries_;  ///< of the page
  PagedList list_;
  std::string doomed_;  ///< the game that a question asks to delete
  std::size_t per_page_ = 1;
  std::size_t page_ = 0;
  View view_;
  Rect head_;
  Rect rows_;
  Rect foot_;
};

}  // namespace app
