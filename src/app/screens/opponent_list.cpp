#include "app/screens/opponent_list.hpp"

#include <utility>
#include <vector>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/view/balls.hpp"
#include "app/view/faces.hpp"
#include "app/view/landscape.hpp"
#include "search/opponent.hpp"

namespace app {
namespace {

// Units.
constexpr float margin = 12;
constexpr float gap = 6;
constexpr float row_height = 46;
constexpr float most_width = 640;    ///< of a column
constexpr float beside_width = 400;  ///< of a row: less has its two texts above each other
constexpr float face_room = 280;     ///< of a row that has room for a face
constexpr float note_height = 44;
constexpr float face_width = 40;

constexpr ButtonId back = 0;
constexpr int levels = replay::most_computer;
static_assert(levels == static_cast<int>(search::levels.size()));
constexpr int first_with_horns = 7;  ///< the first exact hand

}  // namespace

OpponentList::OpponentList(const Words& words, Session& session)
    : words_(words), session_(session) {
  std::vector<Buttons::Button> buttons;
  for (int level = 1; level <= levels; ++level) buttons.push_back({static_cast<ButtonId>(level)});
  buttons.push_back({back});
  buttons_ = Buttons(std::move(buttons), static_cast<ButtonId>(session.settings.get().opponent));
}

void OpponentList::resize(const View& view) {
  Rect rest = view.area().inset(view.px(margin), view.px(margin / 2));
  const bool columns = view.width > view.height;
  rest = centered(rest.center(),
                  std::min(rest.w, view.px(columns ? 1.5f * most_width : most_width)), rest.h);
  Rect head = rest.cut_top(view.button(44) + 2 * view.px(4)).inset(0, view.px(4));
  buttons_.place(view, back, head.cut_right(view.px(104)));
  head.cut_right(view.px(gap));
  title_ = head;
  note_ = rest.cut_bottom(view.px(note_height));
  const std::size_t per_column = columns ? levels / 2 : levels;
  const float space = view.px(gap);
  const float room = (rest.h - space) / static_cast<float>(per_column);
  const float step = std::min(room, view.px(row_height) * 1.25f + space);
  const float high = std::max(step - space, view.button(0));
  rest = centered(rest.center(), rest.w, step * static_cast<float>(per_column));
  const float width = columns ? (rest.w - space) / 2 : rest.w;
  for (int level = 1; level <= levels; ++level) {
    const auto index = static_cast<std::size_t>(level - 1);
    const auto column = static_cast<float>(index / per_column);
    const auto row = static_cast<float>(index % per_column);
    const auto id = static_cast<ButtonId>(level);
    buttons_.place(view, id, {rest.x + column * (width + space), rest.y + row * step, width, high});
    buttons_.relabel(id, ranked(words_, level));
    buttons_.explain(id, words_(Text::about_opponent));
  }
  buttons_.relabel(back, words_(Text::help_back));
  buttons_.explain(back, words_(Text::tip_close_help));
}

Navigation OpponentList::event(const Input& input) {
  if (is_key(input, Key::escape)) return Back{};
  const auto chosen = buttons_.event(input, session_.sounds);
  if (!chosen) return Stay{};
  if (*chosen != back) {
    Settings settings = session_.settings.get();
    settings.opponent = static_cast<int>(*chosen);
    session_.settings.set(std::move(settings));
  }
  return Back{};
}

namespace {

/// Exact hands have horns.
void draw_face(DrawList& list, const Rect& box, float most, int level) {
  const Point center = box.center();
  const float radius = std::min(most, box.h * 0.38f);
  const bool horns = level >= first_with_horns;
  if (horns) draw_horns(list, center, radius);
  draw_ball(list, center, radius, look_of(horns ? BallKind::stone : BallKind::red, *list.palette));
  if (horns)
    draw_villain_face(list, center, radius);
  else
    draw_angry_face(list, center, radius);
}

}  // namespace

void OpponentList::draw_level(Canvas& canvas, int level) const {
  const auto id = static_cast<ButtonId>(level);
  const Buttons::Look look = buttons_.draw_face(canvas, id);
  Rect rest = look.box.inset(canvas.px(6), canvas.px(2));
  if (rest.w >= canvas.px(face_room))
    draw_face(canvas.list, rest.cut_left(canvas.px(face_width)), canvas.px(14), level);
  rest.cut_left(canvas.px(4));
  const std::string name = ranked(words_, level);
  const std::string facts = facts_of(words_, level);
  const bool beside = rest.w >= canvas.px(beside_width);
  label(canvas, beside ? rest.cut_left(rest.w * 0.4f) : rest.cut_top(rest.h * 0.52f),
        {Face::bold, 18, look.ink}, name);
  label(canvas, rest, {Face::regular, 16, look.ink, beside ? Align::right : Align::left}, facts);
  buttons_.list_box(canvas.list, id, name + " " + facts);
}

void OpponentList::draw(Canvas& canvas) const {
  draw_night(canvas.list, canvas.view.area(), canvas.view.height);
  canvas.list.stand_still();
  label(canvas, title_, {Face::black, 32, palette::cream}, words_(Text::choose_opponent));
  for (int level = 1; level <= levels; ++level) draw_level(canvas, level);
  buttons_.draw_one(canvas, back, 17);
  paragraph(canvas, note_, {Face::regular, 17, palette::cream, Align::center},
            words_(Text::about_levels));
}

std::string OpponentList::describe() const {
  return words_(Text::product) + " · " + words_(Text::choose_opponent) + " · " +
         ranked(words_, session_.settings.get().opponent);
}

std::string ranked(const Words& words, int level) {
  return words(Text::ranked, {words.number(level), words.computer_rank(level)});
}

std::string facts_of(const Words& words, int level) {
  const search::Level& facts = search::levels[static_cast<std::size_t>(level - 1)];
  const std::string shots = words.number(static_cast<std::int64_t>(facts.simulations));
  if (facts.hand.exact()) return words(Text::hand_facts_exact, {shots});
  return words(Text::hand_facts,
               {words.number(static_cast<std::int64_t>(facts.hand.error)), shots});
}

}  // namespace app
