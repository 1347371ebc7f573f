#include "app/storage/settings.hpp"

#include <algorithm>
#include <utility>

#include "app/base/utf8.hpp"
#include "carom/display_text.hpp"
#include "json/limits.hpp"
#include "replay/replay.hpp"

namespace app {
namespace {

using Json = nlohmann::json;  // finds a key among many at once
using OrderedJson = nlohmann::ordered_json;

constexpr const char* version_key = "angry-balls-settings";
constexpr int version = 1;

constexpr std::string_view system_language = "system";
// The names of choices in a file, in the order of their enumerations.
constexpr std::array<std::string_view, 3> motions{"system", "on", "off"};
constexpr std::array<std::string_view, 4> palettes{"standard", "red-green", "blue-yellow",
                                                   "high-contrast"};
constexpr std::array<std::string_view, 4> ways{"two-clicks", "drag-back", "turn-then-power",
                                               "turn-and-slide"};
constexpr std::array<std::string_view, 4> previews{"off", "contact", "short", "full"};
constexpr std::array<std::string_view, 3> all_seats{"two", "computer", "alone"};
constexpr std::array<std::string_view, 3> matches{"1", "3", "5"};
constexpr std::array<std::string_view, 2> racks{"classic", "quick"};
constexpr std::array<std::string_view, 7> hands{"exact", "0.5", "1", "2", "4", "8", "15"};
constexpr std::array<std::string_view, 4> breakers{"player-1", "player-2", "alternate", "loser"};

// Both directions go by the same list of keys: `visit` is called with each key and its value.

struct Writer {
  OrderedJson& out;
  void operator()(const char* key, bool value) const { out[key] = value; }
  void operator()(const char* key, int value, int, int) const { out[key] = value; }
  void operator()(const char* key, const std::array<std::string, 2>& value) const {
    out[key] = value;
  }
  void operator()(const char* key, std::optional<Language> value) const {
    out[key] = value ? code_of(*value) : system_language;
  }
  void operator()(const char* key, const KeyBindings& value) const {
    out[key] = OrderedJson::object();
    for (const auto& [command, letter] : value.to_pairs()) out[key][command] = letter;
  }
  template <class Choice, std::size_t n>
  void operator()(const char* key, Choice value, const std::array<std::string_view, n>& of) const {
    out[key] = of[static_cast<std::size_t>(value)];
  }
};

struct Reader {
  const Json& in;
  std::size_t known = 1;  ///< keys found, the version's included
  bool sound = true;

  /// The value, if the key is given.
  const Json* find(const char* key) {
    const auto found = in.find(key);
    if (found == in.end()) return nullptr;
    ++known;
    return &*found;
  }
  template <class Choice, std::size_t n>
  void choose(const Json& given, Choice& value, const std::array<std::string_view, n>& of) {
    const auto* const name =
        given.is_string() ? std::ranges::find(of, given.get_ref<const std::string&>()) : of.end();
    if (name == of.end())
      sound = false;
    else
      value = static_cast<Choice>(name - of.begin());
  }
  void operator()(const char* key, bool& value) {
    const Json* const given = find(key);
    if (!given) return;
    if (given->is_boolean())
      value = given->get<bool>();
    else
      sound = false;
  }
  void operator()(const char* key, int& value, int least, int most) {
    const Json* const given = find(key);
    if (!given) return;
    const auto within = [&](std::uint64_t number) {
      return number >= static_cast<std::uint64_t>(least) &&
             number <= static_cast<std::uint64_t>(most);
    };
    if (given->is_number_unsigned() && within(given->get<std::uint64_t>()))
      value = given->get<int>();
    else
      sound = false;
  }
  void operator()(const char* key, std::array<std::string, 2>& value) {
    const Json* const given = find(key);
    if (!given) return;
    sound &= given->is_array() && given->size() == value.size();
    for (std::size_t i = 0; sound && i < value.size(); ++i) {
      sound = (*given)[i].is_string();
      // Older versions took more: that costs the player no other setting.
      if (sound) value[i] = name_of((*given)[i].get_ref<const std::string&>());
    }
  }
  void operator()(const char* key, std::optional<Language>& value) {
    const Json* const given = find(key);
    if (given && *given != system_language) choose(*given, value.emplace(), language_codes);
  }
  void operator()(const char* key, KeyBindings& value) {
    const Json* const given = find(key);
    if (!given) return;
    sound &= given->is_object();
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& item : given->items()) {
      sound &= item.value().is_string();
      if (!sound) return;
      pairs.emplace_back(item.key(), item.value().get<std::string>());
    }
    const auto read = KeyBindings::from_pairs(pairs);
    sound &= read.ok();
    if (read) value = read.value();
  }
  template <class Choice, std::size_t n>
  void operator()(const char* key, Choice& value, const std::array<std::string_view, n>& of) {
    if (const Json* const given = find(key)) choose(*given, value, of);
  }
};

/// `Any`: Settings or const Settings.
template <class Any, class Visit>
void visit_all(Any& settings, Visit& visit) {
  visit("language", settings.language);
  visit("volume", settings.volume, 0, most_volume);
  visit("mute", settings.mute);
  visit("reduced-motion", settings.reduced_motion, motions);
  visit("screen-shake", settings.screen_shake);
  visit("colours", settings.colours, palettes);
  visit("aiming", settings.aiming.way, ways);
  visit("preview", settings.aiming.preview, previews);
  visit("hints", settings.hints);
  visit("taught", settings.taught);
  visit("names", settings.names);
  visit("breaks", settings.breaks, breakers);
  visit("keep-turn", settings.keep_turn);
  visit("players", settings.seats, all_seats);
  visit("rack", settings.rack, racks);
  visit("touch-red", settings.touch_red);
  visit("opponent", settings.opponent, 1, replay::most_computer);
  visit("match", settings.match, matches);
  visit("hand", settings.hand, hands);
  visit("go-on", settings.go_on);
  visit("go-on-offered", settings.go_on_offered);
  visit("quick-rolling", settings.quick_rolling);
  visit("keys", settings.keys);
}

OrderedJson json_of(const Settings& settings) {
  OrderedJson out{{version_key, version}};
  Writer writer{out};
  visit_all(settings, writer);
  return out;
}

std::string text_of(const Settings& settings) { return json_of(settings).dump(2) + '\n'; }

/// All of it, or nothing if any of it is wrong. A key that is missing has its default: files grow
/// with the program.
std::optional<Settings> parse(const std::string& text) {
  if (text.size() > max_settings) return std::nullopt;
  const Json in = json::parse(text);
  if (!in.is_object() || !in.contains(version_key) || in[version_key] != version ||
      !in[version_key].is_number_unsigned())
    return std::nullopt;
  Settings settings;
  Reader reader{in};
  visit_all(settings, reader);
  if (!reader.sound || reader.known != in.size()) return std::nullopt;
  return settings;
}

/// Of `mine` what was changed since `before`, and of `theirs` all else.
void merge(const OrderedJson& before, const OrderedJson& mine, OrderedJson& theirs) {
  if (mine == before) return;
  if (mine.is_primitive() || theirs.size() != mine.size()) {
    theirs = mine;
    return;
  }
  auto old = before.begin();
  auto merged = theirs.begin();
  for (auto changed = mine.begin(); changed != mine.end(); ++changed, ++old, ++merged)
    merge(*old, *changed, *merged);
}

/// Changes made here count, and of the rest those of another window.
Settings merged(const Settings& before, const Settings& mine, const Settings& theirs) {
  OrderedJson both = json_of(theirs);
  merge(json_of(before), json_of(mine), both);
  // Two windows may have given a letter to two commands.
  return parse(both.dump()).value_or(mine);
}

}  // namespace

std::string name_of(std::string_view typed, bool unfinished) {
  std::string name;
  std::size_t count = 0;
  while (!typed.empty() && count < longest_name) {
    const CodePoint first = first_code_point(typed);
    const std::string_view point = typed.substr(0, std::max<std::size_t>(first.size, 1));
    typed.remove_prefix(point.size());
    if (first.size == 0 || !carom::is_shown(first.code) || (name.empty() && point == " ")) continue;
    name += point;
    ++count;
  }
  while (!unfinished && name.ends_with(' ')) name.pop_back();
  return name;
}

int first_player(Breaks breaks, const std::optional<FinishedGame>& last) {
  switch (breaks) {
    case Breaks::player_1:
      break;
    case Breaks::player_2:
      return 1;
    case Breaks::loser:
      if (last && last->winner) return 1 - *last->winner;
      [[fallthrough]];
    case Breaks::alternate:
      if (last) return 1 - last->first_player;
      break;
  }
  return 0;
}

KeptSettings::KeptSettings(Store& store) : store_(store) {
  if (const auto stored = load()) settings_ = *stored;
}

KeptSettings::Trouble KeptSettings::take_trouble() {
  return std::exchange(told_, true) ? Trouble::none : trouble_;
}

/// Returns the stored settings. Sets a file aside that does not hold any.
std::optional<Settings> KeptSettings::load() {
  const auto stored = store_.load(settings_file);
  blocked_ = !stored.ok();
  if (stored.ok() && stored.value()) {
    if (auto settings = parse(*stored.value())) return settings;
    blocked_ = !store_.set_aside(settings_file).ok();
    trouble_ = Trouble::set_aside;
  }
  if (blocked_) trouble_ = Trouble::not_kept;
  return std::nullopt;
}

void KeptSettings::set(Settings settings) {
  for (std::string& name : settings.names) name = name_of(name);
  settings.volume = std::clamp(settings.volume, 0, most_volume);
  settings.opponent = std::clamp(settings.opponent, 1, replay::most_computer);
  const Settings before = std::exchange(settings_, std::move(settings));
  const auto lock = store_.lock();
  // Another window, or an editor, may have saved since: other contents are not overwritten.
  if (const auto stored = load()) settings_ = merged(before, settings_, *stored);
  if (blocked_) return;
  if (!lock || !store_.save(settings_file, text_of(settings_)))
    trouble_ = Trouble::not_kept;
  else if (trouble_ == Trouble::not_kept)
    trouble_ = Trouble::none;
}

}  // namespace app
