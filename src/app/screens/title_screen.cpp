#include "app/screens/title_screen.hpp"

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/screens/dialog_screen.hpp"
#include "app/screens/load_screen.hpp"
#include "app/screens/title_art.hpp"
#include "carom/display_text.hpp"

namespace app {

using replay::Kind;

namespace {

// Units.
constexpr float rail = 40;               ///< how high the wood is
constexpr float kept_games_width = 142;  ///< and the gap before it
/// Of words: in the middle below the poster, left beside it.
Align align_in(const View& view) { return view.height > view.width ? Align::center : Align::left; }

}  // namespace

TitleScreen::TitleScreen(const Words& words, Session& session)
    : words_(words), session_(session), latest_(session.kept.latest()) {
  if (latest_) choices_.push_back(Choice::continue_latest);
  if (latest_ && session.kept.names().size() > 1) choices_.push_back(Choice::kept_games);
  for (const Choice choice : {Choice::billiards, Choice::new_game, Choice::practice_table,
                              Choice::angry_balls, Choice::replays, Choice::settings,
                              session.host.can_quit ? Choice::quit : Choice::open_file})
    choices_.push_back(choice);
  std::vector<Buttons::Button> buttons;
  for (const Choice choice : choices_) buttons.push_back({id_of(choice)});
  buttons_ = Buttons(std::move(buttons), id_of(choices_.front()));
  // Who plays on after scoring only playing it tells.
  if (latest_ && latest_->game.options.keep_turn)
    if (auto player = replay::Player::create(latest_->game)) ahead_ = std::move(player).value();
}

std::string TitleScreen::label_of(Choice choice) const {
  switch (choice) {
    case Choice::continue_latest:
      return offer();
    case Choice::kept_games:
      return words_(Text::kept_games);
    case Choice::billiards:
      return words_(Text::billiards);
    case Choice::new_game:
      return words_(Text::new_game_more);
    case Choice::practice_table:
      return words_(Text::practice);
    case Choice::angry_balls:
      return words_(Text::angry_balls);
    case Choice::replays:
      return words_(Text::replays);
    case Choice::settings:
      return words_(Text::settings);
    case Choice::open_file:
      return words_(Text::open_file);
    case Choice::quit:
      break;
  }
  return words_(Text::quit);
}

Text TitleScreen::tip_of(Choice choice) {
  switch (choice) {
    case Choice::continue_latest:
      return Text::tip_continue;
    case Choice::kept_games:
      return Text::tip_kept_games;
    case Choice::billiards:
      return Text::tip_billiards;
    case Choice::new_game:
      return Text::tip_new_game;
    case Choice::practice_table:
      return Text::tip_practice_table;
    case Choice::angry_balls:
      return Text::tip_angry_balls;
    case Choice::replays:
      return Text::tip_replays;
    case Choice::settings:
      return Text::tip_settings;
    case Choice::open_file:
      return Text::tip_open;
    case Choice::quit:
      break;
  }
  return Text::tip_quit;
}

/// Label of the saved game's button.
std::string TitleScreen::offer() const {
  const replay::Replay& game = latest_->game;
  if (game.kind() == Kind::billiards) {
    // Each turn has one shot; the last may just have been made.
    const auto shots = std::ranges::count_if(game.moves, [](const replay::Move& move) {
      return std::holds_alternative<games::billiards::Shoot>(move.command) && move.steps > 0;
    });
    if (const int level = std::max(game.occasion.computer[0], game.occasion.computer[1]); level > 0)
      return words_(Text::continue_computer, {words_.number(level)});
    if (game.options.keep_turn && !to_play_) return words_(Text::continue_table);
    const auto player =
        to_play_.value_or(game.options.alone ? 0 : (game.options.first_player + shots) % 2);
    return words_(Text::continue_billiards, {words_.number(player + 1)});
  }
  const Level level = session_.campaign.known(*game.level);
  if (const auto index = session_.campaign.find(level.identity))
    return words_(Text::continue_level, {words_.number(static_cast<int>(*index) + 1)});
  return words_(Text::continue_named_level, {words_.foreign_name(level.name)});
}

void TitleScreen::resize(const View& view) {
  view_ = view;
  Rect rest = view.area();
  const bool tall = view.height > view.width;
  rail_ = rest;
  if (!tall) rail_ = rest.cut_bottom(view.px(rail));
  rest = rest.inset(view.px(32), view.px(24));
  Rect words = tall ? rest.cut_bottom(std::min(view.px(448), rest.h * 0.64f))
                    : rest.cut_left(std::max(std::min(rest.w * 0.45f, view.px(480)),
                                             std::min(rest.w * 0.58f, view.px(288))));
  if (tall) {
    rest.cut_bottom(view.px(8));
    rail_ = {0, rest.cut_bottom(view.px(rail)).y, view.width, view.px(rail)};
  }
  art_ = rest;
  art_.h = rail_.y - art_.y;
  if (!tall) words = centered(words.center(), words.w, std::min(words.h, view.px(456)));

  // Heights give way together in a very low window, and to games that are offered again.
  const std::size_t offered = latest_ ? 1 : 0;
  const float pitch = offered == 0 ? 66.0f : 57.0f;
  const float height = pitch - (offered == 0 ? 12.0f : 9.0f);
  const float unit = std::min(view.scale, words.h / 448);
  const float high = std::max(unit * height, view.touch ? view.button(0) : 0);
  const float step = std::max(unit * pitch, high + view.px(4));
  wordmark_ = words.cut_top(std::max(unit * 398 - step * static_cast<float>(3 + offered), 0.0f));
  words.cut_top(unit * 4);
  tagline_ = words.cut_top(unit * 32);
  words.cut_top(unit * 20);
  const bool several = std::ranges::find(choices_, Choice::kept_games) != choices_.end();
  const float width = std::min(words.w, view.px(tall || several ? 360 : 304));
  const float left = tall ? words.center().x - width / 2 : words.x;
  Rect row;
  const auto next_row = [&] {
    row = {left, words.y, width, high};
    words.cut_top(step);
  };
  const float gap = view.px(8);
  for (const Choice choice : choices_) {
    const ButtonId id = id_of(choice);
    buttons_.relabel(id, label_of(choice));
    buttons_.explain(id, words_(tip_of(choice)));
    if (several && choice == Choice::continue_latest)
      buttons_.abbreviate(id, words_(Text::continue_game));
    const bool alone = choice == Choice::continue_latest && !several;
    const bool second = choice == Choice::kept_games || choice == Choice::practice_table ||
                        choice == Choice::replays || choice == Choice::open_file ||
                        choice == Choice::quit;
    if (choice == Choice::new_game) {
      row.cut_left(gap);
      buttons_.place(view, id, row.cut_left(std::max((row.w - gap) * 0.25f, view.button(44))));
    } else if (second) {
      row.cut_left(gap);
      buttons_.place(view, id, row);
    } else {
      next_row();
      const float first = choice == Choice::continue_latest ? row.w - view.px(kept_games_width)
                          : choice == Choice::billiards     ? row.w * 0.40f
                                                            : row.w * 0.56f;
      buttons_.place(view, id, alone ? row : row.cut_left(first));
    }
  }
}

Navigation TitleScreen::iterate(nanoseconds) {
  if (!ahead_ || ahead_->look_ahead(steps_at_once(*ahead_))) return Stay{};
  if (!ahead_->divergence()) {
    ahead_->seek(ahead_->turns().size());
    to_play_ = std::get<games::billiards::Game>(ahead_->game()).player();
    resize(view_);
  }
  ahead_.reset();
  return Stay{};
}

Navigation TitleScreen::event(const Input& input) {
  if (is_key(input, Key::escape) && buttons_.has_focus()) {
    buttons_.blur();
    return Stay{};
  }
  if (is_key(input, Key::escape)) {
    if (session_.host.can_quit) return Quit{};
    return Stay{};
  }
  if (is_key(input, Key::settings)) return ShowSettings{};
  if (is_key(input, Key::paste)) {
    Pasted pasted = read_pasted(session_);
    if (pasted.replay) return Watch{std::move(*pasted.replay)};
    if (pasted.fault)
      return message(words_, words_(Text::paste_failed),
                     {{words_(pasted_fault(*pasted.fault)), {}, {}}});
    return Stay{};
  }
  const auto chosen = buttons_.event(input, session_.sounds);
  return chosen ? choose(static_cast<Choice>(*chosen)) : Stay{};
}

Navigation TitleScreen::choose(Choice choice) {
  switch (choice) {
    case Choice::continue_latest:
      return Load{*latest_};
    case Choice::kept_games:
      return ShowSavedGames{};
    case Choice::billiards:
      return PlayBilliards{};
    case Choice::new_game:
      return ShowNewGame{};
    case Choice::practice_table:
      return PlayBilliards{.practice = true};
    case Choice::angry_balls:
      return ShowLevels{};
    case Choice::replays:
      return ShowReplays{};
    case Choice::settings:
      return ShowSettings{};
    case Choice::open_file:
      session_.host.choose_file();
      return Stay{};
    case Choice::quit:
      break;
  }
  return Quit{};
}

/// Settings that could not be read, or a saved game that cannot be continued, and what became of
/// the file.
std::optional<Ask> TitleScreen::opens() {
  if (const auto trouble = session_.settings.take_trouble();
      trouble != KeptSettings::Trouble::none) {
    std::vector<Dialog::Line> lines{{words_(Text::settings_unreadable), {}, {}}};
    if (trouble == KeptSettings::Trouble::set_aside) {
      lines.push_back({words_(Text::settings_set_aside), {}, {}});
      lines.push_back({words_(Text::kept_file, {settings_file}), {}, {}});
    } else {
      lines.push_back({words_(Text::settings_blocked), {}, {}});
    }
    return message(words_, words_(Text::settings_broken), std::move(lines));
  }
  const auto refused = session_.kept.take_refused();
  if (!refused) return std::nullopt;
  std::vector<Dialog::Line> lines{{words_(text_of(refused->fault)), {}, {}}};
  if (refused->set_aside) {
    lines.push_back({words_(Text::kept_set_aside), {}, {}});
    lines.push_back({words_(Text::kept_file, {carom::display_text(refused->name)}), {}, {}});
  } else {
    lines.push_back({words_(Text::kept_blocked), {}, {}});
  }
  return message(words_,
                 words_(refused->kind == Kind::billiards ? Text::kept_refused_billiards
                                                         : Text::kept_refused_level),
                 std::move(lines));
}

void TitleScreen::draw(Canvas& canvas) const {
  draw_title_ground(canvas, art_, rail_);
  draw_poster(canvas, art_);
  canvas.list.stand_still();

  draw_wordmark(canvas, wordmark_, words_(Text::product), align_in(canvas.view));
  const std::string tip = buttons_.tip();
  label(canvas, tagline_,
        {Face::regular, tip.empty() ? 20.0f : 18.0f, palette::brass_lit, align_in(canvas.view)},
        tip.empty() ? words_(Text::tagline) : tip);
  for (const Choice choice : choices_) {
    const bool large = choice == Choice::billiards || choice == Choice::angry_balls;
    buttons_.draw_one(canvas, id_of(choice), large ? 22 : 18);
  }
  canvas.list.tip.reset();  // it stands below the name
}

std::string TitleScreen::describe() const {
  return words_(Text::product) + " · " + words_(Text::title_screen);
}

}  // namespace app
