#include "app/text/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "app/base/embedded.hpp"
#include "carom/display_text.hpp"

namespace app {
namespace {

/// The texts of a language.
struct Table {
  std::string file;                     ///< what was loaded; what is built in is elsewhere
  std::vector<std::string_view> texts;  ///< by Text, the names of levels behind them
  std::string_view plural_forms;        ///< which form the counts from 0 to 199 take, as digits
};

constexpr auto count_of_texts = static_cast<std::size_t>(Text::count);

/// No texts if the file is of another version.
Table parse(std::string_view file) {
  std::vector<std::string_view> parts;
  while (!file.empty()) {
    const std::size_t end = file.find('\0');
    if (end == std::string_view::npos) return {};
    parts.push_back(file.substr(0, end));
    file.remove_prefix(end + 1);
  }
  if (parts.size() < 2 + count_of_texts || parts[0] != texts_version) return {};
  return {.file = {}, .texts = {parts.begin() + 2, parts.end()}, .plural_forms = parts[1]};
}

using Tables = std::array<Table, language_codes.size()>;

/// By Language. Those that are built in are there from the start.
Tables& tables() {
  static Tables all = [] {
    Tables made;
    for (const Embedded& file : embedded_texts)
      for (std::size_t i = 0; i < made.size(); ++i)
        if (file.name == std::string(language_codes[i]) + ".texts")
          made[i] = parse({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
    return made;
  }();
  return all;
}

const Table& table_of(Language language) { return tables()[static_cast<std::size_t>(language)]; }

/// The language's table if it has the text, otherwise the English one.
const Table& table_with(Language language, std::size_t text) {
  const Table& table = table_of(language);
  return text < table.texts.size() && !table.texts[text].empty() ? table : table_of(Language::en);
}

std::string_view text_in(Language language, Text text) {
  const auto index = static_cast<std::size_t>(text);
  return table_with(language, index).texts[index];
}

/// A text used instead for another device than the mouse.
struct ByHand {
  InputDevice hand;
  Text text;
  Text instead;
};
constexpr std::array by_hand{
    ByHand{InputDevice::finger, Text::hint_turn, Text::touch_turn},
    ByHand{InputDevice::finger, Text::nudge_turn, Text::touch_turn},
    ByHand{InputDevice::finger, Text::hint_replay, Text::touch_replay},
    ByHand{InputDevice::finger, Text::hint_watch, Text::touch_watch},
    ByHand{InputDevice::finger, Text::hint_flying, Text::touch_flying},
    ByHand{InputDevice::finger, Text::hint_repeat, Text::touch_repeat},
    ByHand{InputDevice::pad, Text::hint_repeat, Text::touch_repeat},
    ByHand{InputDevice::pad, Text::hint_take_cue_ball, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_not_cue_ball, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_take_projectile, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_not_projectile, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_pull, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_turn, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_apart, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_apart_aimed, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::nudge_apart, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_pull, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_click, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_turn, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_shoot, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_throw, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_too_weak, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_keys, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_place, Text::pad_place},
    ByHand{InputDevice::pad, Text::nudge_place, Text::pad_place},
    ByHand{InputDevice::pad, Text::hint_settings, Text::pad_settings},
    ByHand{InputDevice::pad, Text::hint_replay, Text::pad_replay},
    ByHand{InputDevice::pad, Text::ready_to_throw, Text::pad_ready},
    ByHand{InputDevice::pad, Text::lesson_1, Text::pad_lesson_1},
    ByHand{InputDevice::pad, Text::lesson_2, Text::pad_lesson_2},
    ByHand{InputDevice::pad, Text::lesson_3, Text::pad_lesson_3},
};

/// The texts of a sign in brackets, by InputDevice.
struct Sign {
  char sign;
  std::array<Text, 3> texts;
};
constexpr std::array signs{
    Sign{'C', {Text::start_press_mouse, Text::start_press_finger, Text::start_press_pad}},
    Sign{'c', {Text::press_mouse, Text::press_finger, Text::press_pad}},
    Sign{'O', {Text::start_press_on_mouse, Text::start_press_on_finger, Text::start_press_on_pad}},
    Sign{'o', {Text::press_on_mouse, Text::press_on_finger, Text::press_on_pad}},
    Sign{'k', {Text::presses_mouse, Text::presses_finger, Text::presses_pad}},
    Sign{'B', {Text::take_back_mouse, Text::take_back_finger, Text::take_back_pad}},
};

/// The pattern with its values, and signs for the hand in use.
std::string filled(std::string_view pattern, std::initializer_list<std::string_view> values,
                   Language language, InputDevice hand) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      const auto n = static_cast<std::size_t>(pattern[i + 1] - '0');
      if (n < values.size()) out += values.begin()[n];
      i += 2;
    } else if (pattern[i] == '[') {
      const char sign = pattern[i + 1];
      if (sign == '|' && hand != InputDevice::mouse) break;
      for (const Sign& known : signs)
        if (known.sign == sign)
          out += text_in(language, known.texts[static_cast<std::size_t>(hand)]);
      i += 2;
    } else {
      out += pattern[i];
    }
  }
  return out;
}

}  // namespace

Language language_of_locale(std::string_view locale) {
  std::string name(locale.substr(0, locale.find_first_of(".@")));
  std::ranges::replace(name, '-', '_');
  // "pt_BR" before "pt".
  for (const std::string& wanted : {name, name.substr(0, name.find('_'))})
    for (std::size_t i = 0; i < language_codes.size(); ++i)
      if (wanted == language_codes[i]) return static_cast<Language>(i);
  return Language::en;
}

bool load_texts(Language language, std::string file) {
  // A text's bytes stay where they are when the table gets them.
  Table table;
  table.file = std::move(file);
  Table parsed = parse(table.file);
  if (parsed.texts.size() != table_of(Language::en).texts.size()) return false;
  table.texts = std::move(parsed.texts);
  table.plural_forms = parsed.plural_forms;
  tables()[static_cast<std::size_t>(language)] = std::move(table);
  return true;
}

bool has_texts(Language language) { return !table_of(language).texts.empty(); }

std::string Words::operator()(Text text, std::initializer_list<std::string_view> values) const {
  for (const ByHand& other : by_hand)
    if (other.hand == hand() && other.text == text) {
      text = other.instead;
      break;
    }
  return filled(text_in(language(), text), values, language(), hand());
}

std::string Words::count(Text text, int n) const {
  const auto index = static_cast<std::size_t>(text);
  const Table& table = table_with(language(), index);
  std::string_view forms = table.texts[index];
  const int among = n < 200 ? n : 100 + n % 100;
  for (int form = table.plural_forms[static_cast<std::size_t>(among)] - '0'; form > 0; --form)
    forms.remove_prefix(forms.find('\x1f') + 1);
  return filled(forms.substr(0, forms.find('\x1f')), {number(n)}, language(), hand());
}

std::string Words::number(std::int64_t value) const {
  const std::string_view separator = text_in(language(), Text::thousands_mark);
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3 && digits[at - 4] != '-';) {
    at -= 3;
    digits.insert(at, separator);
  }
  return digits;
}

std::string Words::tenths(double value) const {
  const auto all = static_cast<int>(std::lround(value * 10));
  const int part = std::abs(all % 10);
  return (all < 0 ? "−" : "") + number(std::abs(all / 10)) +
         std::string(text_in(language(), Text::decimal_mark)) + std::to_string(part);
}

std::string Words::level_name(std::string_view name) const {
  if (name.empty()) return (*this)(Text::unnamed_level);
  const auto& english = table_of(Language::en).texts;
  for (std::size_t i = count_of_texts; i < english.size(); ++i)
    if (english[i] == name) return std::string(table_with(language(), i).texts[i]);
  return std::string(name);
}

std::string Words::foreign_name(std::string_view name) const {
  constexpr std::size_t most = 60;
  if (name.empty()) return (*this)(Text::unnamed_level);
  std::string shown = carom::display_text(name, most);
  const auto replace = [&](std::string_view sign, std::string_view by) {
    for (std::size_t at = shown.find(sign); at != std::string::npos; at = shown.find(sign, at))
      shown.replace(at, sign.size(), by);
  };
  // The dots that part the pieces of a title, their likes, and quotes.
  for (const std::string_view sign : {"·", "•", "‧", "∙", "⋅", "・", "･", "‣", "●", "᛫"})
    replace(sign, "-");
  for (const std::string_view quote : {"\"", "“", "”", "„", "‟", "«", "»", "‹", "›"})
    replace(quote, "'");
  return shown;
}

std::string Words::player(int player) const {
  if (const int level = computers_[static_cast<std::size_t>(player)]; level > 0)
    return (*this)(Text::computer, {number(level)});
  const std::string& name = voice_->names[static_cast<std::size_t>(player)];
  return name.empty() ? (*this)(Text::player, {number(player + 1)}) : carom::display_text(name);
}

std::string Words::computer_rank(int level) const {
  constexpr std::array ranks{Text::rank_casual, Text::rank_regular, Text::rank_keen,
                             Text::rank_club,   Text::rank_league,  Text::rank_expert,
                             Text::rank_pro,    Text::rank_master,  Text::rank_champion,
                             Text::rank_machine};
  return (*this)(ranks[static_cast<std::size_t>(level - 1)]);
}

}  // namespace app
