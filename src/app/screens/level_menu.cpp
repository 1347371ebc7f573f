#include "app/screens/level_menu.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/landscape.hpp"
#include "app/view/level_view.hpp"
#include "app/widgets/level_fault.hpp"

namespace app {
namespace {

// Units.
constexpr float margin = 16;
constexpr float gap = 12;
constexpr float least_width = 140;
constexpr float least_height = 112;
constexpr float most_width = 300;
constexpr float slim_width = 176;   ///< of a card: less has no room for a name beside the number
constexpr float words_height = 58;  ///< of a card, below the picture
constexpr float picture_ratio = 0.56f;  ///< a picture's height by its width
constexpr float button_width = 104;
constexpr float practice_width = 148;
constexpr float phone_width = 560;

constexpr std::size_t most_drawn = 300;  ///< balls, walls and holes of a card's picture, each

}  // namespace

LevelMenu::LevelMenu(const Words& words, Session& session)
    : words_(words), campaign_(session.campaign), sounds_(session.sounds), list_(words) {}

void LevelMenu::resize(const View& view) {
  view_ = view;
  Rect rest = view.area().inset(view.px(margin), view.px(4));
  // Where both do not fit beside each other, the heading stands over its buttons.
  const bool alone = view.width < view.px(phone_width);
  heading_ = alone ? rest.cut_top(view.px(44)) : Rect();
  head_ = rest.cut_top(view.button(44) + 2 * view.px(4));
  rest.cut_top(view.px(4));
  foot_ = rest.cut_bottom(view.button(40) + view.px(view.narrow() ? 44 : 8));
  rest.cut_bottom(view.px(8));
  grid_ = rest;

  const float space = view.px(gap);
  const auto most = [space](float room, float least) {
    return static_cast<std::size_t>(std::max((room + space) / (least + space), 1.0f));
  };
  const auto card = [&](std::size_t columns, std::size_t rows) {
    const auto share = [space](float room, std::size_t n) {
      return (room + space) / static_cast<float>(n) - space;
    };
    const float width = std::min(share(grid_.w, columns), view.px(most_width));
    // A level is about twice as wide as high; more height would only be sky.
    return Rect{0, 0, width,
                std::min(share(grid_.h, rows), width * picture_ratio + view.px(words_height))};
  };
  // The columns that give the largest pictures with all levels on a page; else as many cards as
  // there is room for.
  const std::size_t most_rows = most(grid_.h, view.px(least_height));
  columns_ = most(grid_.w, view.px(least_width));
  rows_ = most_rows;
  float best = 0;
  for (std::size_t columns = columns_; columns > 0; --columns) {
    const std::size_t needed = (campaign_.levels.size() + columns - 1) / columns;
    if (needed > most_rows) break;
    const Rect size = card(columns, needed);
    const float picture = std::min(size.w, (size.h - view.px(words_height)) / picture_ratio);
    // Full rows are worth somewhat smaller pictures.
    const float worth = picture * static_cast<float>(campaign_.levels.size()) /
                        static_cast<float>(columns * needed);
    if (worth <= best) continue;
    best = worth;
    columns_ = columns;
    rows_ = needed;
  }
  card_ = card(columns_, rows_);
  // All that fits, and no larger: the grid stands in the middle.
  const auto extent = [space](float size, std::size_t n) {
    return (size + space) * static_cast<float>(n) - space;
  };
  grid_ = centered(grid_.center(), extent(card_.w, columns_), extent(card_.h, rows_));
  show_page(campaign_.current / (columns_ * rows_));
}

void LevelMenu::show_page(std::size_t page) {
  list_.show(page, campaign_.levels.size(), columns_ * rows_,
             {{practice, words_(campaign_.practice ? Text::practice_on : Text::practice_off),
               words_(Text::tip_practice_levels)},
              {title, words_(Text::title_button), words_(Text::tip_title)}});
  Buttons& buttons = list_.buttons;
  buttons.set_columns(columns_);
  const float space = view_.px(gap);
  for (std::size_t i = 0; i < list_.count(); ++i) {
    buttons.explain(i, about(list_.first() + i));
    const std::size_t row = i / columns_;
    // A last row that is not full stands in the middle.
    const auto missing =
        static_cast<float>(columns_ - std::min(columns_, list_.count() - row * columns_));
    buttons.place(
        view_, i,
        {std::round(grid_.x + (static_cast<float>(i % columns_) + missing / 2) * (card_.w + space)),
         std::round(grid_.y + static_cast<float>(row) * (card_.h + space)), card_.w, card_.h});
  }
  Rect head = head_.inset(0, view_.px(4));
  buttons.place(view_, title, head.cut_right(view_.px(button_width)));
  head.cut_right(space);
  buttons.place(view_, practice, head.cut_right(view_.px(practice_width)));
  foot_ = list_.place_pager(view_, foot_);
}

Navigation LevelMenu::event(const Input& input) {
  if (is_key(input, Key::escape)) return ShowTitle{};
  const auto chosen = list_.buttons.event(input, sounds_);
  return chosen ? choose(*chosen) : Stay{};
}

Navigation LevelMenu::choose(ButtonId button) {
  told_.reset();
  if (button == title) return ShowTitle{};
  if (button == practice) {
    campaign_.practice = !campaign_.practice;
    campaign_.current = list_.first();
    resize(view_);
    return Stay{};
  }
  if (const auto page = list_.page_of(button)) {
    campaign_.current = *page * columns_ * rows_;
    resize(view_);
    return Stay{};
  }
  const std::size_t level = list_.first() + button;
  if (!campaign_.levels[level].scene) {
    told_ = level;
    return Stay{};
  }
  return PlayLevel{level, campaign_.practice};
}

/// A card's tip: the goal, or the whole of a broken level's error.
std::string LevelMenu::about(std::size_t index) const {
  const Level& level = campaign_.levels[index];
  if (!level.scene) return words_(Text::hint_broken_level, {problem_of(words_, level)});
  const carom::Scene& scene = level.scene.value();
  return words_(Text::tip_level, {words_.number(static_cast<int>(std::ranges::count(
                                      scene.balls, carom::Role::enemy, &carom::Ball::role))),
                                  words_.number(scene.throws)});
}

/// The line below: about a card, a trouble, or the next thing to do.
std::string LevelMenu::notice() const {
  std::optional<std::size_t> level = told_;
  for (std::size_t i = 0; i < list_.count(); ++i)
    if (list_.buttons.hovered(i) || list_.buttons.focused(i)) level = list_.first() + i;
  if (level) return about(*level);
  if (campaign_.practice) return words_(Text::hint_practice_levels);
  switch (campaign_.best.trouble()) {
    case BestScores::Trouble::set_aside:
      return words_(Text::scores_set_aside);
    case BestScores::Trouble::not_kept:
      return words_(Text::scores_not_kept);
    case BestScores::Trouble::none:
      break;
  }
  return words_(Text::hint_choose_level);
}

void LevelMenu::draw(Canvas& canvas) const {
  const Rect all = canvas.view.area();
  draw_night(canvas.list, all, foot_.y - canvas.px(4));
  canvas.list.stand_still();
  Rect strip = all;
  strip = strip.cut_bottom(all.bottom() - foot_.y + canvas.px(4));
  fill_rounded(canvas.list, strip, 0,
               Paint::vertical(strip, palette::slate_top, palette::slate_bottom));

  Rect head = head_;
  head.cut_right(canvas.px(practice_width + button_width + 2 * gap));
  label(canvas, heading_.w > 0 ? heading_ : head, {Face::black, 32, palette::cream},
        words_(Text::choose_level));
  for (std::size_t i = 0; i < list_.count(); ++i) draw_card(canvas, i);
  list_.draw(canvas);
  const TextStyle style{Face::regular, 18, palette::cream, Align::center};
  const std::string words = notice();
  const bool one_line = foot_.h < canvas.px(46) || label_width(canvas, style, words) <= foot_.w;
  if (one_line)
    label(canvas, foot_, style, elided(canvas, style, words, foot_.w));
  else
    paragraph(canvas, foot_, style, words);
}

void LevelMenu::draw_card(Canvas& canvas, ButtonId button) const {
  const Buttons& buttons = list_.buttons;
  const std::size_t index = list_.first() + button;
  const Level& level = campaign_.levels[index];
  const bool playable = level.scene.ok();
  DrawList& list = canvas.list;
  const std::size_t texts = list.boxes.size();
  const float radius = canvas.px(10);
  Rect box = buttons.box(button);
  fill_rounded(list, box.moved({0, canvas.px(3)}), radius, palette::shadow, canvas.px(6));
  if (buttons.pressed(button)) box = box.moved({0, canvas.px(1)});
  Color face = playable ? palette::panel : mix(palette::panel, palette::slate_bottom, 0.6f);
  if (buttons.hovered(button)) face = mix(face, palette::cream, 0.14f);
  fill_rounded(list, box, radius, face);

  Rect rest = box.inset(canvas.px(8));
  Rect words = rest.cut_bottom(canvas.px(44));
  rest.cut_bottom(canvas.px(4));
  const Color dim = rgb(0x8b979c);
  if (playable) {
    draw_picture(canvas, rest, level.scene.value());
  } else {
    fill_rounded(list, rest, canvas.px(4), palette::slate_bottom);
    paragraph(canvas, rest.inset(canvas.px(6), canvas.px(2)), {Face::regular, 16, dim},
              problem_of(words_, level));
  }
  const std::string number = words_.number(static_cast<int>(index) + 1);
  const TextStyle number_style{Face::black, 30, playable ? palette::brass_lit : dim, Align::center};
  const float number_width = std::max(label_width(canvas, number_style, number) + 1, canvas.px(26));
  // On a slim card the name needs the whole width: the number stands in the sky.
  const bool slim = playable && box.w < canvas.px(slim_width);
  label(canvas,
        slim ? rest.cut_left(number_width).cut_top(canvas.px(32)) : words.cut_left(number_width),
        number_style, number);
  if (!slim) words.cut_left(canvas.px(8));
  const std::string name = level.origin == Origin::shipped ? words_.level_name(level.name)
                                                           : words_.foreign_name(level.name);
  const TextStyle name_style{Face::bold, 16, playable ? palette::cream : dim};
  const auto best = campaign_.best.of(level.identity);
  const Rect line = playable ? words.cut_top(words.h / 2) : words;
  const std::string shown = elided(canvas, name_style, name, line.w);
  label(canvas, line, name_style, shown);
  if (playable)
    label(canvas, words, {Face::regular, 16, best ? palette::brass_lit : palette::muted},
          best ? words_(Text::best, {words_.number(*best)}) : words_(Text::not_won_yet));

  const bool focused = buttons.focused(button);
  stroke_rounded(list, box.inset(0.5f), radius, focused ? canvas.px(3) : 1,
                 focused ? palette::cream
                 : best  ? palette::brass
                         : palette::panel_edge);
  std::string all;
  for (std::size_t i = texts; i < list.boxes.size(); ++i) {
    const std::string& text = list.boxes[i].text;
    all += (all.empty() ? "" : "\n") + (text == shown ? name : text);
  }
  buttons.list_box(list, button, std::move(all));
}

/// The level, small. A level of very many things shows the first of them.
void LevelMenu::draw_picture(Canvas& canvas, const Rect& area, const carom::Scene& level) {
  const Viewport viewport = level_viewport(area, level);
  carom::Scene few;
  few.width = level.width;
  few.height = level.height;
  few.edges = level.edges;
  few.gravity = level.gravity;
  few.damage_per_speed = level.damage_per_speed;
  const auto end_of_first = [](const auto& list) {
    return list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), most_drawn));
  };
  few.holes.assign(level.holes.begin(), end_of_first(level.holes));
  few.obstacles.assign(level.obstacles.begin(), end_of_first(level.obstacles));
  few.balls.assign(level.balls.begin(), end_of_first(level.balls));
  const std::size_t first = canvas.list.vertices.size();
  draw_level(canvas.list, area, viewport, few);
  if (const auto world = carom::World::create(few))
    draw_level_balls(canvas.list, area, viewport, world.value(), few, {}, 1);
  clip(canvas.list, first, area);
}

std::string LevelMenu::describe() const {
  return words_(Text::menu_state,
                {words_(Text::product), words_(Text::level_menu),
                 words_.count(Text::level_count, static_cast<int>(campaign_.levels.size()))});
}

}  // namespace app
