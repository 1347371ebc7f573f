#pragma once

#include <span>
#include <variant>
#include <vector>

#include "app/play/session.hpp"
#include "app/screens/keys_panel.hpp"
#include "app/screens/licences_panel.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// All keys, and the use of mouse, fingers and gamepad, over any screen; on as many pages as the
/// window makes of it.
class Help final : public Screen {
 public:
  /// `session` must outlive this.
  Help(const Words& words, Session& session);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  Cover cover() const override { return Cover::waiting; }
  Letters letters() const override { return Letters::keys; }

 private:
  struct Line {
    std::size_t page = 0;
    Rect box;
    std::string key;   ///< of a title the only text
    std::string what;  ///< empty: a title
  };
  enum Button : ButtonId { previous, next, keys, close, licences };

  struct Section {
    Text title;
    Text lines;
  };

  void lay_out();
  void lay_out(std::span<const Section> in_order);
  void turn(std::size_t by);

  Words words_;
  Session& session_;
  Keyboard& keyboard_;
  View view_;
  Buttons buttons_;
  Buttons pager_;  ///< there if there are several pages
  std::variant<std::monostate, KeysPanel, LicencesPanel> panel_;  ///< in its place
  std::vector<Line> lines_;
  std::size_t page_ = 0;
  std::size_t pages_ = 1;
  Rect frame_;
  Rect head_;
  Rect page_label_;
};

}  // namespace app
