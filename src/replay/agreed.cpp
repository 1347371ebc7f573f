#include "replay/agreed.hpp"

#include <algorithm>
#include <array>

namespace replay {
namespace {

using games::billiards::Rack;
using games::billiards::reds_of;

constexpr std::uint64_t classic_reds = reds_of(Rack::classic);
constexpr std::uint64_t quick_reds = reds_of(Rack::quick);

bool set_truth(bool& value, std::uint64_t number) {
  if (number > 1) return false;
  value = number == 1;
  return true;
}

template <class Number>
bool set_number(Number& value, std::uint64_t number, std::uint64_t most) {
  if (number > most) return false;
  value = static_cast<Number>(number);
  return true;
}

constexpr std::string_view a_truth = "true or false";
constexpr std::string_view a_level = "the level of a computer player, 1 to 10, or 0 for a person";
constexpr std::string_view a_mark = "a whole number up to 9007199254740991";
constexpr std::string_view games_won = "games won before, fewer than win the match";

template <std::size_t player>
constexpr Agreed computer{
    player == 0 ? "computer-1" : "computer-2",
    false,
    0,
    a_level,
    [](const Replay& of) { return std::uint64_t(of.occasion.computer[player]); },
    [](Replay& of, std::uint64_t n) {
      return set_number(of.occasion.computer[player], n, most_computer);
    }};

template <std::size_t player>
constexpr Agreed won{player == 0 ? "won-1" : "won-2",
                     false,
                     0,
                     games_won,
                     [](const Replay& of) { return std::uint64_t(of.occasion.won[player]); },
                     [](Replay& of, std::uint64_t n) {
                       return set_number(of.occasion.won[player], n, most_games / 2);
                     }};

constexpr std::array all{
    Agreed{"reds", false, classic_reds, "36 or 15",
           [](const Replay& of) { return std::uint64_t(reds_of(of.options.rack)); },
           [](Replay& of, std::uint64_t n) {
             if (n != classic_reds && n != quick_reds) return false;
             of.options.rack = n == quick_reds ? Rack::quick : Rack::classic;
             return true;
           }},
    Agreed{"touch-red", true, 0, a_truth,
           [](const Replay& of) { return std::uint64_t(of.options.touch_red); },
           [](Replay& of, std::uint64_t n) { return set_truth(of.options.touch_red, n); }},
    Agreed{"alone", true, 0, a_truth,
           [](const Replay& of) { return std::uint64_t(of.options.alone); },
           [](Replay& of, std::uint64_t n) { return set_truth(of.options.alone, n); }},
    computer<0>,
    computer<1>,
    Agreed{"seed", false, 0, a_mark, [](const Replay& of) { return of.occasion.seed; },
           [](Replay& of, std::uint64_t n) { return set_number(of.occasion.seed, n, most_mark); }},
    Agreed{"best-of", false, 1, "1, 3 or 5",
           [](const Replay& of) { return std::uint64_t(of.occasion.best_of); },
           [](Replay& of, std::uint64_t n) {
             return n % 2 == 1 && set_number(of.occasion.best_of, n, most_games);
           }},
    won<0>,
    won<1>,
    Agreed{"duel", false, 0, a_mark, [](const Replay& of) { return of.occasion.duel; },
           [](Replay& of, std::uint64_t n) { return set_number(of.occasion.duel, n, most_mark); }},
};

}  // namespace

std::span<const Agreed> agreed() { return all; }

int form_version(const Replay& replay) {
  const bool usual =
      std::ranges::all_of(all, [&](const Agreed& item) { return item.get(replay) == item.usual; });
  return usual ? 1 : 2;
}

}  // namespace replay
