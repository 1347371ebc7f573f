#pragma once

#include <cstddef>
#include <string>

#include "app/play/game_review.hpp"
#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/widgets/paged_list.hpp"

namespace app {

/// A game of billiards that was played, shot by shot: what each choice gave away, what was luck,
/// the costliest shots, and how the lead was to be expected. It fills in while it is looked at; a
/// shot chosen is shown in the replay.
class ReviewScreen final : public Screen {
 public:
  ReviewScreen(const Words& words, Session& session, GameReview review);

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  Navigation iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override { return !review_.done(); }

 private:
  static constexpr std::size_t most_costly = 3;
  enum Button : ButtonId { back = PagedList::first_own, costly };  ///< costly + i: the i-th of them

  void show_page(std::size_t page);
  void relabel();
  Navigation show(std::size_t shot) const;
  void draw_curve(Canvas& canvas) const;
  /// A shot's row; `better`: with the better one on a second line.
  void draw_row(Canvas& canvas, ButtonId button, std::size_t shot, bool better) const;
  std::string line_of(std::size_t shot) const;
  std::string better_than(std::size_t shot) const;
  std::string progress() const;

  Words words_;
  Session& session_;
  GameReview review_;
  PagedList list_;
  std::size_t page_ = 0;
  std::size_t per_page_ = 1;
  View view_;
  Rect title_;
  Rect progress_;
  Rect curve_;
  Rect heading_;  ///< of the costliest
  Rect costliest_;
  Rect rows_;
  Rect foot_;
};

}  // namespace app
