#include "app/storage/replay_fault.hpp"

namespace app {

ReplayFault fault_of(const carom::Errors& errors) {
  const bool foreign =
      !errors.empty() && errors.front().problem.code == carom::MessageCode::is_of_other_version;
  return foreign ? ReplayFault::other_version : ReplayFault::damaged;
}

Text text_of(ReplayFault fault) {
  switch (fault) {
    case ReplayFault::unreadable:
      return Text::fault_unreadable;
    case ReplayFault::other_version:
      return Text::fault_other_version;
    case ReplayFault::diverged:
      return Text::fault_diverged;
    case ReplayFault::finished:
      return Text::fault_finished;
    case ReplayFault::damaged:
      break;
  }
  return Text::fault_damaged;
}

}  // namespace app
