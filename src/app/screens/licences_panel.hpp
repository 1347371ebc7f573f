#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The licence texts in the help: a text of any length, page by page or line by line.
class LicencesPanel {
 public:
  /// `text` must outlive this.
  LicencesPanel(const Words& words, std::string_view text);

  /// Within `area`, window px.
  void resize(const View& view, const Rect& area);
  /// `input` with the keys as they are pressed. False: closed.
  bool event(const Input& input, Sounds& sounds);
  void draw(Canvas& canvas) const;

 private:
  enum Button : ButtonId { previous, next, back };

  std::size_t last_top() const { return lines_.size() > rows_ ? lines_.size() - rows_ : 0; }
  void scroll(std::ptrdiff_t lines);

  Words words_;
  std::string_view text_;
  Buttons buttons_;
  std::vector<std::string_view> lines_;  ///< as they fit
  std::size_t rows_ = 1;                 ///< lines shown at once
  std::size_t top_ = 0;                  ///< the first one shown
  Rect head_;
  Rect page_label_;
  Rect page_;
  float line_ = 0;  ///< height, px
};

}  // namespace app
