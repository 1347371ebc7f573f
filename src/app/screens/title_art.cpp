#include "app/screens/title_art.hpp"

#include <array>
#include <utility>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "app/view/faces.hpp"
#include "app/view/landscape.hpp"

namespace app {
namespace {

constexpr float least_wordmark = 20;  ///< units, of the em; smaller it is left out
constexpr int rows = 8;               ///< of the rack
constexpr float row_distance = 1.7320508f;
constexpr Color dusk = rgb(0xd8743c);

/// Where the poster's parts stand.
struct Poster {
  float r;  ///< px, of a red ball
  Point apex;
  Point cue;
  Point sun;

  explicit Poster(const Rect& art) {
    // In radii: the pile is 16 wide, 14.2 high, on its apex are horns; 5 more for the ball that
    // comes.
    r = std::min(art.w / 21, art.h / 16.2f);
    apex = {art.center().x + r * 2.5f, art.bottom() - r * (1 + (rows - 1) * row_distance)};
    cue = apex + Point{-r * 6.6f, r * 0.9f};
    sun = cue + Point{r * 1.6f, r * 3.4f};
  }
};

}  // namespace

/// The product's name in two lines; a very low window has no room for it.
void draw_wordmark(Canvas& canvas, const Rect& area, std::string product, Align align) {
  for (char& letter : product)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  const std::size_t space = product.find(' ');
  const std::array lines{product.substr(0, space), product.substr(space + 1)};
  // As large as both lines fit, standing on the tagline.
  float size = area.h * 0.61f / canvas.view.scale;
  for (const std::string& word : lines)
    size *= std::min(1.0f, area.w / label_width(canvas, {Face::black, size, {}}, word));
  if (size < least_wordmark) return;
  const float line_height = canvas.px(size * 0.82f);
  const Point drop{0, canvas.px(4)};
  Rect rest = area;
  const Rect below = rest.cut_bottom(line_height);
  for (const auto& [box, word] :
       {std::pair{rest.cut_bottom(line_height), lines[0]}, std::pair{below, lines[1]}}) {
    const TextStyle style{Face::black, std::floor(size), palette::cream, align};
    TextStyle dark = style;
    dark.color = faded(palette::ink, 0.55f);
    label(canvas, box.moved(drop), dark, word);
    canvas.list.boxes.pop_back();  // a shadow is not a text
    const std::size_t first = canvas.list.vertices.size();
    label(canvas, box, style, word);
    const Paint lit =
        Paint::vertical(box, palette::ivory, mix(palette::ivory, palette::brass, 0.3f));
    for (std::size_t i = first; i < canvas.list.vertices.size(); ++i)
      canvas.list.vertices[i].color = lit.at(canvas.list.vertices[i].position);
  }
}

/// Dusk over the table's rail; on a tall window the felt lies below it.
void draw_title_ground(Canvas& canvas, const Rect& art, const Rect& rail) {
  DrawList& list = canvas.list;
  const Palette& colours = *list.palette;
  const Rect all = canvas.view.area();
  const Rect sky{0, 0, all.w, rail.y};
  const Poster poster(art);
  fill_lamplit(list, sky,
               {poster.sun, std::max(poster.r * 24, 1.0f), std::max(poster.r * 20, 1.0f),
                mix(colours.felt_lit, palette::sky_low, 0.6f), colours.felt_dark});
  const std::size_t first = list.vertices.size();
  fill_disc(list, poster.sun, poster.r * 6.2f,
            Paint(poster.sun - Point{0, poster.r * 6}, palette::brass_lit,
                  poster.sun + Point{0, poster.r * 6}, dusk));
  for (int range = 0; range < 3; ++range) {
    const float near = static_cast<float>(range) / 2;
    const Color color = mix(mix(colours.felt_lit, palette::sun, 0.2f), colours.felt_dark, near);
    const Rect hills{0, rail.y - poster.r * 5, all.w, poster.r * 5};
    fill_under(list, ridge(sky, rail.y, poster.r * 14, range), rail.y,
               Paint::vertical(hills, color, mix(color, colours.felt_lit, 0.5f)));
  }
  clip(list, first, sky);

  if (rail.bottom() < all.h) {
    const Rect felt{0, rail.bottom(), all.w, all.h - rail.bottom()};
    fill_lamplit(list, felt,
                 {{felt.center().x, felt.y},
                  all.w,
                  std::max(felt.h, 1.0f),
                  colours.felt,
                  colours.felt_dark});
    const Rect shade{0, felt.y, all.w, canvas.px(12)};
    fill_rounded(list, shade, 0, Paint::vertical(shade, {0, 0, 0, 120}, {0, 0, 0, 0}));
  }
  fill_rounded(list, rail, 0, Paint::vertical(rail, palette::walnut_lit, palette::walnut_dark));
  line(list, {rail.x, rail.y}, {rail.right(), rail.y}, canvas.px(3), palette::brass);
  for (int i = 1; i < 8; ++i) {
    const Point c{rail.w * static_cast<float>(i) / 8, rail.center().y};
    const float r = canvas.px(7);
    const std::array sight{Point{c.x, c.y - r}, Point{c.x + r, c.y}, Point{c.x, c.y + r},
                           Point{c.x - r, c.y}};
    fill(list, sight,
         Paint({c.x - r, c.y - r}, palette::brass_lit, {c.x + r, c.y + r}, palette::brass_dark));
  }
}

/// The rack of one game piled up like a tower of the other, and who flies at it.
void draw_poster(Canvas& canvas, const Rect& art) {
  DrawList& list = canvas.list;
  const Poster poster(art);
  const float r = poster.r;
  glow(list, {poster.apex.x, art.bottom() + canvas.px(2)}, r * 10, canvas.px(10), {0, 0, 0, 170});
  for (int row = rows - 1; row >= 0; --row) {
    for (int n = 0; n <= row; ++n) {
      const Point c = poster.apex + Point{static_cast<float>(2 * n - row) * r,
                                          static_cast<float>(row) * row_distance * r};
      const bool villain = row < 2;
      if (villain) draw_horns(list, c, r);
      fill_disc(list, c, r * 1.04f, faded(palette::ink, 0.6f));
      draw_ball(list, c, r, BallKind::red);
      if (villain) draw_villain_face(list, c, r);
    }
  }

  const Point c = poster.cue;
  const float radius = r * 3.1f;
  const Point way = unit({1, 0.16f});
  for (int i = -2; i <= 2; ++i) {  // how fast it comes
    const auto off = static_cast<float>(i);
    const Point beside = c + turned(way) * (off * radius * 0.38f);
    const Point tail = beside - way * (radius * (2.3f - 0.28f * off * off));
    const Point head = beside - way * (radius * 0.6f);
    fill(list, capsule(tail, head, radius * 0.09f),
         Paint(tail, faded(palette::cream, 0), head, faded(palette::cream, 0.6f)));
  }
  fill_disc(list, c, radius * 1.03f, faded(palette::ink, 0.55f));
  draw_ball(list, c, radius, BallKind::ivory);
  draw_angry_face(list, c, radius);
}

}  // namespace app
