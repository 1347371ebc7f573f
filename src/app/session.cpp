#include "app/session.hpp"

#include "replay/replay_file.hpp"

namespace app {

Language language_of(const Session& session) {
  if (session.asked_language) return *session.asked_language;
  switch (session.settings.get().language) {
    case LanguageChoice::english:
      return Language::english;
    case LanguageChoice::french:
      return Language::french;
    case LanguageChoice::system:
      break;
  }
  return session.system_language;
}

games::billiards::Options options_of(const Session& session) {
  const Settings& settings = session.settings.get();
  return {.first_player = first_player(settings.breaks, session.last_game),
          .keep_turn = settings.keep_turn};
}

std::optional<ReplayFault> take_pasted(Session& session) {
  auto read = replay::read_replay(session.clipboard.text());
  if (!read) return fault_of(read.errors());
  session.to_watch = std::move(read).value();
  return std::nullopt;
}

}  // namespace app
