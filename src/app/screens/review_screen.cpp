#include "app/screens/review_screen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/markers.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/screens/load_screen.hpp"
#include "app/view/landscape.hpp"

namespace app {
namespace {

// Units.
constexpr float margin = 12;
constexpr float gap = 6;
constexpr float row_height = 40;
constexpr float tall_row = 50;  ///< with two lines
constexpr float most_width = 1120;
constexpr float button_width = 104;
constexpr float sign_width = 34;

std::string signed_number(const Words& words, double value) {
  const auto whole = std::lround(value);
  return (whole < 0 ? "−" : whole > 0 ? "+" : "") + words.number(std::abs(whole));
}

}  // namespace

ReviewScreen::ReviewScreen(const Words& words, Session& session, GameReview review)
    : words_(words), session_(session), review_(std::move(review)), list_(words) {}

void ReviewScreen::resize(const View& view) {
  const std::size_t first = page_ * per_page_;
  view_ = view;
  Rect rest = view.area().inset(view.px(margin), view.px(margin / 2));
  rest = centered(rest.center(), std::min(rest.w, view.px(most_width)), rest.h);
  title_ = rest.cut_top(view.button(44) + 2 * view.px(2)).inset(0, view.px(2));
  progress_ = rest.cut_top(view.px(26));
  rest.cut_top(view.px(gap));
  const float space = view.px(gap);
  const float costly_height =
      static_cast<float>(most_costly) * (view.button(tall_row) + space) - space;
  const bool beside = view.width > view.height;
  Rect left = rest;
  if (beside) {
    left = rest.cut_left((rest.w - view.px(16)) / 2);
    rest.cut_left(view.px(16));
    costliest_ = left.cut_bottom(costly_height);
    heading_ = left.cut_bottom(view.px(28));
    curve_ = left;
  } else {
    curve_ = rest.cut_top(std::min(view.px(150), rest.h * 0.2f));
    heading_ = rest.cut_top(view.px(28));
    costliest_ = rest.cut_top(costly_height);
    rest.cut_top(view.px(12));
  }
  foot_ = rest.cut_bottom(view.button(40) + view.px(8));
  rows_ = rest;
  const float pitch = view.button(row_height) + space;
  per_page_ = static_cast<std::size_t>(std::max((rows_.h + space) / pitch, 1.0f));
  show_page(first / per_page_);
}

void ReviewScreen::show_page(std::size_t page) {
  std::vector<Buttons::Button> own;
  own.push_back({back});
  const std::size_t shown = std::min(most_costly, review_.all());
  for (std::size_t i = 0; i < shown; ++i) own.push_back({costly + i});
  list_.show(page, review_.all(), per_page_, std::move(own));
  page_ = list_.first() / per_page_;
  Buttons& buttons = list_.buttons;
  const float space = view_.px(gap);
  Rect rows = rows_;
  for (ButtonId i = 0; i < list_.count(); ++i) {
    buttons.place(view_, i, rows.cut_top(view_.button(row_height)));
    rows.cut_top(space);
  }
  rows = costliest_;
  for (std::size_t i = 0; i < shown; ++i) {
    buttons.place(view_, costly + i, rows.cut_top(view_.button(tall_row)));
    rows.cut_top(space);
  }
  Rect head = title_;
  buttons.place(view_, back, head.cut_right(view_.px(button_width)));
  // In half of a window there is no room beside what turns the pages.
  View narrow = view_;
  narrow.width = 0;
  list_.place_pager(narrow, foot_);
  relabel();
}

void ReviewScreen::relabel() {
  Buttons& buttons = list_.buttons;
  buttons.relabel(back, words_(Text::help_back));
  buttons.explain(back, words_(Text::tip_close_help));
  for (ButtonId i = 0; i < list_.count(); ++i) {
    buttons.relabel(i, line_of(list_.first() + i));
    buttons.explain(i, words_(Text::tip_review_shot));
  }
  const auto costliest = review_.costliest(most_costly);
  for (std::size_t i = 0; i < std::min(most_costly, review_.all()); ++i) {
    const bool known = i < costliest.size();
    buttons.relabel(costly + i, known ? line_of(costliest[i]) : "…");
    buttons.explain(costly + i, words_(Text::tip_review_shot));
  }
}

std::string ReviewScreen::line_of(std::size_t shot) const {
  const std::string name = words_(Text::review_shot, {words_.number(static_cast<int>(shot) + 1)});
  if (shot >= review_.shots().size()) return name;
  const search::TurnReview& review = review_.shots()[shot].review;
  return name + " · " +
         words_(Text::review_decision, {words_.number(std::lround(review.decision()))}) + " · " +
         words_(Text::review_luck, {signed_number(words_, review.luck())});
}

std::string ReviewScreen::better_than(std::size_t shot) const {
  const search::TurnReview& review = review_.shots()[shot].review;
  return words_(Text::review_better,
                {words_.tenths(review.best.aim.tenths / 10.0), words_.number(review.best.aim.speed),
                 words_.number(std::lround(review.best_value.mean)),
                 words_.number(std::lround(review.played_value.mean))});
}

std::string ReviewScreen::progress() const {
  const double error = error_of(session_.settings.get().hand);
  const std::string hand = error == 0  ? words_(Text::hand_exact)
                           : error < 1 ? words_.tenths(error)
                                       : words_.number(static_cast<std::int64_t>(error));
  return words_(Text::review_progress, {words_.number(static_cast<int>(review_.shots().size())),
                                        words_.number(static_cast<int>(review_.all()))}) +
         (error == 0 ? std::string() : " · " + words_(Text::review_hand, {hand}));
}

Navigation ReviewScreen::show(std::size_t shot) const {
  Watch watch{.replay = review_.player().replay(), .turn = shot};
  if (shot < review_.shots().size() && review_.shots()[shot].review.decision() >= 1)
    watch.better = review_.shots()[shot].review.best;
  return watch;
}

Navigation ReviewScreen::event(const Input& input) {
  if (is_key(input, Key::escape)) return Back{};
  const auto chosen = list_.buttons.event(input, session_.sounds);
  if (!chosen) return Stay{};
  if (*chosen == back) return Back{};
  if (const auto page = list_.page_of(*chosen)) {
    show_page(*page);
    return Stay{};
  }
  if (*chosen < PagedList::previous) return show(list_.first() + *chosen);
  const auto costliest = review_.costliest(most_costly);
  const std::size_t index = *chosen - costly;
  return index < costliest.size() ? show(costliest[index]) : Stay{};
}

Navigation ReviewScreen::iterate(nanoseconds elapsed) {
  const std::size_t before = review_.shots().size();
  review_.advance(elapsed, steps_at_once(review_.player()), session_.rollouts);
  if (review_.shots().size() != before) relabel();
  return Stay{};
}

/// The first player's lead after each shot: as it was, and as it was to be expected of the shots.
void ReviewScreen::draw_curve(Canvas& canvas) const {
  DrawList& list = canvas.list;
  fill_rounded(list, curve_, canvas.px(8), faded(palette::ink, 0.5f));
  Rect inside = curve_.inset(canvas.px(10), canvas.px(6));
  label(canvas, inside.cut_top(canvas.px(22)), {Face::bold, 16, palette::brass_lit},
        words_(Text::review_lead));
  std::vector<double> made{0};
  std::vector<double> expected{0};
  double most = 1;
  for (const GameReview::Shot& shot : review_.shots()) {
    const double sign = shot.player == 0 ? 1 : -1;
    made.push_back(made.back() + sign * static_cast<double>(shot.review.made));
    expected.push_back(expected.back() + sign * shot.review.played_value.mean);
    most = std::max({most, std::abs(made.back()), std::abs(expected.back())});
  }
  const float middle = inside.center().y;
  line(list, {inside.x, middle}, {inside.right(), middle}, 1, faded(palette::cream, 0.4f));
  const auto at = [&](const std::vector<double>& curve, std::size_t i) {
    return Point{inside.x + inside.w * static_cast<float>(i) /
                                static_cast<float>(std::max<std::size_t>(review_.all(), 1)),
                 middle - static_cast<float>(curve[i] / most) * inside.h * 0.46f};
  };
  for (std::size_t i = 1; i < made.size(); ++i) {
    line(list, at(made, i - 1), at(made, i), canvas.px(1.5f), faded(palette::cream, 0.55f));
    line(list, at(expected, i - 1), at(expected, i), canvas.px(2.5f), palette::brass_lit);
  }
  for (const int player : {0, 1})
    draw_marker(list, player,
                {inside.right() - canvas.px(8),
                 player == 0 ? inside.y + canvas.px(8) : inside.bottom() - canvas.px(8)},
                canvas.px(7));
}

void ReviewScreen::draw_row(Canvas& canvas, ButtonId button, std::size_t shot, bool better) const {
  const Buttons::Look look = list_.buttons.draw_face(canvas, button);
  const std::string& text = list_.buttons.label_of(button);
  Rect inside = look.box.inset(canvas.px(8), canvas.px(2));
  const bool known = shot < review_.shots().size();
  const Point sign = inside.cut_left(canvas.px(sign_width)).center();
  if (known) draw_marker(canvas.list, review_.shots()[shot].player, sign, canvas.px(9));
  if (better && known)
    label(canvas, inside.cut_bottom(inside.h * 0.46f), {Face::regular, 16, palette::brass_lit},
          better_than(shot));
  label(canvas, inside, {Face::bold, 16, look.ink}, text);
  list_.buttons.list_box(canvas.list, button,
                         better && known ? text + " " + better_than(shot) : text);
}

void ReviewScreen::draw(Canvas& canvas) const {
  draw_night(canvas.list, canvas.view.area(), canvas.view.height);
  canvas.list.stand_still();
  Rect title = title_;
  title.cut_right(canvas.px(button_width + gap));
  label(canvas, title, {Face::black, 32, palette::cream}, words_(Text::review));
  label(canvas, progress_, {Face::regular, 17, palette::cream}, progress());
  draw_curve(canvas);
  label(canvas, heading_, {Face::bold, 17, palette::brass_lit}, words_(Text::review_costliest));
  for (ButtonId i = 0; i < list_.count(); ++i) draw_row(canvas, i, list_.first() + i, false);
  const auto costliest = review_.costliest(most_costly);
  for (std::size_t i = 0; i < std::min(most_costly, review_.all()); ++i)
    draw_row(canvas, costly + i, i < costliest.size() ? costliest[i] : review_.all(), true);
  list_.draw_pager(canvas);
  list_.buttons.draw_one(canvas, back, 17);
}

std::string ReviewScreen::describe() const {
  return words_(Text::product) + " · " + words_(Text::review) + " · " + progress();
}

}  // namespace app
