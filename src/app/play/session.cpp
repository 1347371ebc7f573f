#include "app/play/session.hpp"

#include "app/storage/links.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace app {

std::uint64_t Session::fresh_seed() {
  return (host.random ? host.random() : ++seeds) & replay::most_mark;
}

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
