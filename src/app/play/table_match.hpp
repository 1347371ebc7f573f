#pragma once

#include <array>
#include <optional>

#include "app/play/session.hpp"

/// Games of billiards as the settings want them, one after the other.
namespace app {

/// A new game; `practice`: a table for one who practises.
BilliardsRecorder new_table(Session& session, bool practice);
/// The same once more, with the same players.
BilliardsRecorder same_table(Session& session, const BilliardsRecorder& played);
/// The game after one that is over: the next of its match, or the first of another with the same
/// players. `winner`: 0 or 1; none: a draw.
BilliardsRecorder next_table(Session& session, const BilliardsRecorder& played,
                             std::optional<int> winner);

/// Games of the match won by each player, the one that `winner` has won included.
std::array<int, 2> games_won(const replay::Occasion& occasion, std::optional<int> winner);
/// The player who has won the match by that game; a draw wins none.
std::optional<int> match_winner(const replay::Occasion& occasion, std::optional<int> winner);

}  // namespace app
