#include "app/storage/kept_games.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "replay/replay_file.hpp"

namespace app {
namespace {

using replay::Kind;

constexpr std::string_view table_stem = "continue-billiards";
constexpr std::string_view level_stem = "continue-level";
constexpr std::string_view ending = ".json";
constexpr std::size_t digits = 4;

bool is_table(std::string_view name) { return name.starts_with(table_stem); }

/// 12 for "continue-level-0012.json"; 0 for "continue-level.json", as the first version named it,
/// and for what was put there by hand.
std::uint64_t number_of(std::string_view name) {
  name.remove_prefix((is_table(name) ? table_stem : level_stem).size());
  name.remove_suffix(ending.size());
  if (!name.starts_with('-')) return 0;
  name.remove_prefix(1);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = error == std::errc() && end == name.data() + name.size();
  return whole && number < 1'000'000'000 ? number : 0;
}

std::string numbered(Kind kind, std::uint64_t number) {
  std::string text = std::to_string(number);
  text.insert(0, digits - std::min(digits, text.size()), '0');
  return std::string(kind == Kind::billiards ? table_stem : level_stem)
      .append("-")
      .append(text)
      .append(ending);
}

}  // namespace

std::vector<std::string> KeptGames::names() const {
  std::vector<std::string> names;
  for (std::string& name : store_.list(""))
    if (is_table(name) || name.starts_with(level_stem)) names.push_back(std::move(name));
  std::ranges::stable_sort(names, std::greater(), number_of);
  return names;
}

carom::Result<KeptGames::Kept> KeptGames::load(const std::string& name) const {
  auto stored = store_.load(name);
  if (!stored) return stored.errors();
  if (!stored.value()) return carom::Error{.pointer = name, .problem = carom::MessageCode::is_gone};
  auto read = replay::read_json(*stored.value());
  if (!read) return read.errors();
  // The name of one game with the other in it.
  if ((read.value().kind() == Kind::billiards) != is_table(name))
    return carom::Error{.pointer = name, .problem = carom::MessageCode::is_of_other_game};
  return Kept{{name, std::move(*stored.value())}, std::move(read).value()};
}

std::optional<KeptGames::Kept> KeptGames::latest() {
  for (const std::string& name : names()) {
    auto kept = load(name);
    if (kept) return std::move(kept).value();
    refuse(name, fault_of(kept.errors()));
  }
  return std::nullopt;
}

/// Is true if the stored text was read or written here: no other window has gone on with it.
bool KeptGames::unchanged(const Place& place) const {
  if (place.name.empty()) return false;
  const auto stored = store_.load(place.name);
  return stored.ok() && stored.value() == place.text;
}

bool KeptGames::save_anew(Place& place, Kind kind, const std::string& text) {
  std::uint64_t number = 0;
  for (const std::string& name : names()) number = std::max(number, number_of(name));
  for (int tries = 0; tries < 100; ++tries) {
    const std::string name = numbered(kind, ++number);
    const auto saved = store_.save_new(name, text);
    if (!saved) return false;
    if (!saved.value()) continue;  // taken, by another window or by something that is not a file
    place.name = name;
    return true;
  }
  return false;
}

bool KeptGames::keep(Place& place, const replay::Replay& game) {
  if (!replay::check(game).empty()) return false;
  std::string text = replay::write_json(game);
  if (text.size() > replay::max_bytes) return false;
  const auto lock = store_.lock();
  if (!lock) return false;
  const Place before = place;
  const bool mine = unchanged(before);
  if (mine && before.own) {
    if (!store_.save(before.name, text)) return false;
  } else {
    if (!save_anew(place, game.kind(), text)) return false;
    // The new file goes on from it. One that stays is offered once more: no harm.
    if (mine) static_cast<void>(store_.remove(before.name));
  }
  place.text = std::move(text);
  place.own = true;
  return true;
}

void KeptGames::forget(Place& place) {
  const auto lock = store_.lock();
  if (lock && unchanged(place)) static_cast<void>(store_.remove(place.name));
  place = {};
}

void KeptGames::refuse(const std::string& name, ReplayFault fault) {
  const Kind kind = is_table(name) ? Kind::billiards : Kind::angry_balls;
  // Only what was read and found wrong is moved.
  const auto stored = store_.load(name);
  if (stored.ok() && !stored.value()) return;
  const bool set_aside = stored.ok() && store_.set_aside(name).ok();
  if (set_aside || unreadable_.insert(name).second)
    refused_.push_back({name, kind, stored ? fault : ReplayFault::unreadable, set_aside});
}

std::optional<KeptGames::Refused> KeptGames::take_refused() {
  if (refused_.empty()) return std::nullopt;
  Refused first = std::move(refused_.front());
  refused_.erase(refused_.begin());
  return first;
}

}  // namespace app
