#include "app/play/session.hpp"

#include "app/storage/links.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace app {

Language language_of(const Session& session) {
  if (session.asked_language) return *session.asked_language;
  if (const auto chosen = session.settings.get().language) return *chosen;
  return session.system_language;
}

void speak(const Session& session, Words& words) {
  const Language language = language_of(session);
  if (has_texts(language) || !session.host.fetch_texts)
    words.speak(language);
  else
    session.host.fetch_texts(language);
}

games::billiards::Options options_of(const Session& session, bool practice) {
  if (practice) return {.alone = true};
  const Settings& settings = session.settings.get();
  games::billiards::Options options{.touch_red = settings.touch_red, .rack = settings.rack};
  if (settings.seats == Seats::alone) {
    options.alone = true;
  } else {
    options.first_player = first_player(settings.breaks, session.last_game);
    options.keep_turn = settings.keep_turn;
  }
  return options;
}

Pasted read_pasted(const Session& session) {
  const auto text = session.clipboard.text();
  if (!text) return {};
  auto read = replay::read_replay(behind(links::replay, *text).value_or(*text));
  if (!read) return {.fault = fault_of(read.errors())};
  return {.replay = std::move(read).value()};
}

Text pasted_fault(ReplayFault fault) {
  return fault == ReplayFault::other_version ? Text::paste_other_version : Text::paste_damaged;
}

std::string shared_text(const Session& session, const replay::Replay& replay) {
  const std::string text = replay::write_text(replay);
  const std::string& prefix = session.host.link_prefix;
  return prefix.empty() ? text : prefix + std::string(links::replay) + text;
}

}  // namespace app
