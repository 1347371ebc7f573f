#include "app/title_screen.hpp"

#include <array>

#include "app/balls.hpp"
#include "app/faces.hpp"
#include "app/label.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {
namespace {

enum Choice : std::size_t { play_billiards, play_angry_balls, quit };

constexpr float rail = 40;  ///< units, the wood along the bottom
constexpr int rows = 8;     ///< of the rack
constexpr float row_distance = 1.7320508f;

}  // namespace

TitleScreen::TitleScreen(const Words& words)
    : words_(words),
      buttons_({words(Text::billiards), words(Text::angry_balls), words(Text::quit)},
               play_billiards) {}

void TitleScreen::resize(const View& view) {
  Rect rest = view.area();
  rest.cut_bottom(view.px(rail));
  rest = rest.inset(view.px(32), view.px(24));
  const bool tall = view.height > view.width;
  Rect words = tall ? rest.cut_bottom(std::min(view.px(448), rest.h * 0.64f))
                    : rest.cut_left(std::max(std::min(rest.w * 0.45f, view.px(480)),
                                             std::min(rest.w * 0.58f, view.px(288))));
  art_ = rest;
  if (!tall) words = centered(words.center(), words.w, std::min(words.h, view.px(456)));

  // Heights give way together in a very low window.
  const float unit = std::min(view.scale, words.h / 448);
  wordmark_ = words.cut_top(unit * 200);
  words.cut_top(unit * 4);
  tagline_ = words.cut_top(unit * 32);
  words.cut_top(unit * 20);
  const float width = std::min(words.w, view.px(304));
  const float left = tall ? words.center().x - width / 2 : words.x;
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_.place(i, {left, words.y + unit * 66 * static_cast<float>(i), width, unit * 54});
}

Transition TitleScreen::event(const Input& input) {
  if (is_key(input, Key::escape)) return Transition::quit;
  const auto chosen = buttons_.event(input);
  if (chosen == play_billiards) return Transition::billiards;
  if (chosen == play_angry_balls) return Transition::levels;
  if (chosen == quit) return Transition::quit;
  return Transition::stay;
}

void TitleScreen::draw(Canvas& canvas) const {
  draw_background(canvas);
  draw_art(canvas);

  std::string product = words_(Text::product);
  for (char& letter : product)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  const std::size_t space = product.find(' ');
  const Align align = canvas.view.height > canvas.view.width ? Align::center : Align::left;
  const std::array lines{product.substr(0, space), product.substr(space + 1)};
  // As large as both lines fit, standing on the tagline.
  float size = wordmark_.h * 0.61f / canvas.view.scale;
  for (const std::string& word : lines)
    size *= std::min(1.0f, wordmark_.w / label_width(canvas, {Face::black, size, {}}, word));
  const float line_height = canvas.px(size * 0.82f);
  const Point drop{0, canvas.px(4)};
  Rect rest = wordmark_;
  const Rect below = rest.cut_bottom(line_height);
  for (const auto& [box, word] :
       {std::pair{rest.cut_bottom(line_height), lines[0]}, std::pair{below, lines[1]}}) {
    const TextStyle style{Face::black, std::floor(size), palette::cream, align};
    TextStyle dark = style;
    dark.color = faded(palette::ink, 0.55f);
    label(canvas, box.moved(drop), dark, word);
    canvas.list.boxes.pop_back();  // a shadow is no text
    label(canvas, box, style, word);
  }
  label(canvas, tagline_, {Face::regular, 20, palette::brass_lit, align}, words_(Text::tagline));
  buttons_.draw(canvas, 22);
}

void TitleScreen::draw_background(Canvas& canvas) const {
  DrawList& list = canvas.list;
  const Rect all = canvas.view.area();
  fill_rounded(list, all, 0, Paint::vertical(all, palette::felt_dark, palette::felt));
  const Point lamp = art_.center();
  glow(list, lamp, all.w * 0.75f, all.h * 0.9f, faded(palette::felt_lit, 0.85f));

  Rect wood = all;
  wood = wood.cut_bottom(canvas.px(rail));
  const Rect shade{wood.x, wood.y - canvas.px(12), wood.w, canvas.px(12)};
  fill_rounded(list, shade, 0, Paint::vertical(shade, {0, 0, 0, 0}, {0, 0, 0, 120}));
  fill_rounded(list, wood, 0, Paint::vertical(wood, palette::walnut_lit, palette::walnut_dark));
  line(list, {wood.x, wood.y}, {wood.right(), wood.y}, canvas.px(3), palette::brass);
  for (int i = 1; i < 8; ++i) {
    const Point c{wood.w * static_cast<float>(i) / 8, wood.center().y};
    const float r = canvas.px(7);
    const std::array sight{Point{c.x, c.y - r}, Point{c.x + r, c.y}, Point{c.x, c.y + r},
                           Point{c.x - r, c.y}};
    fill(list, sight,
         Paint({c.x - r, c.y - r}, palette::brass_lit, {c.x + r, c.y + r}, palette::brass_dark));
  }
}

void TitleScreen::draw_art(Canvas& canvas) const {
  DrawList& list = canvas.list;
  // In radii of a red ball: 17 high; 13.4 to the right of the apex, and 9.4 of cue ball and speed
  // to its left.
  const float r = std::min(art_.w / 22.8f, art_.h / 17.0f);
  const Point apex = art_.center() + Point{-r * 2.0f, 0};
  const auto red = [&](int row, int n) {
    return apex + Point{static_cast<float>(row) * row_distance * r * 1.02f,
                        (static_cast<float>(2 * n - row)) * r * 1.02f};
  };
  for (int row = 0; row < rows; ++row)
    for (int n = 0; n <= row; ++n) draw_ball_shadow(list, red(row, n), r);
  for (int row = 0; row < rows; ++row)
    for (int n = 0; n <= row; ++n) draw_ball(list, red(row, n), r, red_ball);

  const Point cue = apex + Point{-r * 4.0f, r * 2.9f};
  const float cue_radius = r * 3.1f;
  for (int i = -2; i <= 2; ++i) {  // how fast it comes
    const auto off = static_cast<float>(i);
    const Point tail =
        cue + Point{-cue_radius * (1.75f - 0.12f * off * off), off * cue_radius * 0.36f};
    const Point head = cue + Point{-cue_radius * 0.6f, off * cue_radius * 0.36f};
    fill(list, capsule(tail, head, cue_radius * 0.09f),
         Paint(tail, faded(palette::cream, 0), head, faded(palette::cream, 0.5f)));
  }
  draw_ball_shadow(list, cue, cue_radius);
  draw_ball(list, cue, cue_radius, ivory_ball);
  draw_angry_face(list, cue, cue_radius);
}

std::string TitleScreen::describe() const {
  return words_(Text::product) + " · " + words_(Text::title_screen);
}

}  // namespace app
