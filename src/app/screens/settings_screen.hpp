#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/screens/settings_rows.hpp"
#include "app/text/text.hpp"

namespace app {

/// All settings, on some pages; every change holds and is saved at once, a name when its line is
/// left. A click on a line goes to its next value, a click on the arrow before the value to the one
/// before; Tab, up and down choose a line, left and right change it.
class SettingsScreen final : public Screen {
 public:
  SettingsScreen(const Words& words, Session& session, std::size_t page = 0);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;

  Letters letters() const override { return named() ? Letters::text : Letters::commands; }

 private:
  /// A part that is clicked or has the focus, in that order: pages, rows, "Help", "Close".
  using Control = std::size_t;
  static constexpr std::size_t pages = settings_pages;
  static constexpr std::size_t most_lines = most_settings_rows;

  std::span<const SettingsRow> rows() const { return settings_page(page_).rows; }
  Control help() const { return pages + rows().size(); }
  Control close() const { return help() + 1; }
  std::size_t controls() const { return close() + 1; }
  const SettingsRow* row_of(Control control) const;
  const SettingsRow* named() const;
  Rect box_of(Control control) const;
  Rect value_box(Control control) const;
  std::optional<Control> find(Point at) const;

  Navigation key(Key key);
  Navigation press(Control control, Point at);
  void focus(std::optional<Control> control);
  void show(std::size_t page);
  void change(const SettingsRow& row, int by);
  void ask_name(const SettingsRow& row);
  void set(Settings settings);
  void type(std::string_view text);

  std::string value_of(const SettingsRow& row) const;
  std::string tip(Control control) const;
  std::string hint() const;
  void list_box(DrawList& list, Control control, std::string text) const;

  void draw_page_button(Canvas& canvas, std::size_t page) const;
  void draw_line(Canvas& canvas, Control control) const;
  void draw_name(Canvas& canvas, const Rect& box, const SettingsRow& row, bool focused) const;
  void draw_button(Canvas& canvas, Control control, Text text) const;

  Words words_;
  Session& session_;
  std::size_t page_;
  std::optional<Control> hovered_;
  std::optional<Control> pressed_;
  std::optional<Control> focused_;
  std::string typed_;  ///< the name whose line has the focus

  Rect title_;
  Rect help_;
  Rect close_;
  std::array<Rect, pages> page_boxes_;
  std::array<Rect, most_lines> line_boxes_;
  Rect hint_;
  float arrow_ = 0;       ///< px, how wide the arrow at each end of a value is
  bool stacked_ = false;  ///< a line's value stands below its label
};

}  // namespace app
