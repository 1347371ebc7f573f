// The windows that PlayScreen opens: questions, the pause menu, the end.

#include <utility>

#include "app/screens/next_offer.hpp"
#include "app/screens/place_ball.hpp"
#include "app/screens/play_screen.hpp"

namespace app {

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::pause() {
  game_speed_.let_go();
  window_ = Window::pause;
  const auto button = [&](PauseButton id, Text label, Text tip) {
    return Dialog::Button{static_cast<ButtonId>(id), words_(label), words_(tip)};
  };
  std::vector buttons{button(PauseButton::resume, Text::resume, Text::tip_resume),
                      button(PauseButton::restart, Text::restart, Text::tip_restart),
                      button(PauseButton::settings, Text::settings, Text::tip_settings),
                      button(PauseButton::help, Text::help, Text::tip_help),
                      button(PauseButton::leave, Text::leave, Text::tip_close)};
  if (can_resign())
    buttons.insert(buttons.begin() + 2,
                   button(PauseButton::resign, Text::resign, Text::tip_resign));
  return Ask{.dialog = Dialog(words_(Text::paused), {}, std::move(buttons)),
             .line = state_line(words_(Text::paused_state, {now()})),
             .shortcuts = {{Key::escape, static_cast<ButtonId>(PauseButton::resume)},
                           {app::Command::pause, static_cast<ButtonId>(PauseButton::resume)}}};
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::paused(ButtonId button) {
  switch (static_cast<PauseButton>(button)) {
    case PauseButton::resume:
      return Stay{};
    case PauseButton::restart:
      return request(UserBar::Command::restart);
    case PauseButton::resign:
      window_ = Window::resign;
      return Ask{.dialog = Dialog(words_(Text::ask_resign), {},
                                  {{yes, words_(Text::resign), words_(Text::tip_resign)},
                                   {no, words_(Text::keep_playing), words_(Text::tip_close_help)}}),
                 .line = described(words_(Text::ask_resign))};
    case PauseButton::settings:
      return ShowSettings{};
    case PauseButton::help:
      return ShowHelp{};
    case PauseButton::leave:
      break;
  }
  return obey(UserBar::Command::close);
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::request(UserBar::Command command) {
  game_speed_.let_go();  // what is pressed is let go unheard under another screen
  auto question = question_before(command);
  if (!question) return obey(command);
  window_ = Window::question;
  asked_ = command;
  std::string line = described(question->title());
  return Ask{.dialog = std::move(*question), .line = std::move(line)};
}

template <class Game, class Waiting>
std::optional<Ask> PlayScreen<Game, Waiting>::opens() {
  const auto* over = std::get_if<Over>(&state_);
  if (!over) {
    auto own = own_window();
    if (own) window_ = Window::own;
    return own;
  }
  if (over->wait > nanoseconds{0}) return std::nullopt;
  game_speed_.let_go();
  Ask ask{.dialog = over->dialog, .line = describe(), .cover = Cover::running};
  if (played_.practice())
    ask.shortcuts = {{Key::backspace, take_back}, {app::Command::again, repeat}};
  return ask;
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::answered(ButtonId button) {
  if (std::holds_alternative<Over>(state_)) return finish(button);
  if (window_ == Window::pause) return paused(button);
  if (window_ == Window::own) {
    own_answer(button);
    return Stay{};
  }
  if (window_ == Window::resign) {
    if (button == yes) resign();
    return Stay{};
  }
  if (button == yes) return obey(asked_);
  return Stay{};
}

template <class Game, class Waiting>
std::optional<Dialog> PlayScreen<Game, Waiting>::question_before(UserBar::Command command) const {
  // Leaving keeps the game; practice keeps none.
  if (command != UserBar::Command::restart || game().world().steps() == 0 || played_.practice())
    return std::nullopt;
  return Dialog(words_(Text::ask_restart), {{words_(Text::game_is_lost), {}, {}}},
                {{yes, words_(Text::new_game), words_(Text::tip_give_up)},
                 {no, words_(Text::keep_playing), words_(Text::tip_close_help)}});
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::obey(UserBar::Command command) {
  switch (command) {
    case UserBar::Command::pause:
      return pause();
    case UserBar::Command::close:
      // A level has moved on while it was offered to throw again.
      if (std::holds_alternative<Waiting>(state_)) keep();
      return leave_to();
    case UserBar::Command::restart:
      break;
  }
  if (start_again()) {
    game_speed_.new_game();
    hints_ = 0;
    show_anew();
    announce_start();
  }
  return Stay{};
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::finish(ButtonId button) {
  switch (static_cast<EndButton>(button)) {
    case go_on:
      return next_game();
    case again:
      return obey(UserBar::Command::restart);
    case leave:
      return obey(UserBar::Command::close);
    case watch:
      return Watch{played_.recorder().replay()};
    case review:
      return ShowReview{played_.recorder().replay()};
    case take_back:
      practise(TakeBack{});
      break;
    case repeat:
      practise(Repeat{});
      break;
  }
  return Stay{};
}

template class PlayScreen<games::billiards::Game, PlaceBall>;
template class PlayScreen<games::angry_balls::Game, NextOffer>;

}  // namespace app
