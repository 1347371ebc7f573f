#include "app/session.hpp"

#include "replay/replay_file.hpp"

namespace app {

std::optional<ReplayFault> take_pasted(Session& session) {
  auto read = replay::read_replay(session.clipboard.text());
  if (!read) return fault_of(read.errors());
  session.to_watch = std::move(read).value();
  return std::nullopt;
}

}  // namespace app
