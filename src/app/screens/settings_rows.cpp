#include "app/screens/settings_rows.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace app {
namespace {

using Kind = SettingsRow::Kind;

constexpr int volume_step = 10;

/// The choice after or before, round and round.
template <class Choice>
void turn(Choice& choice, int count, int by) {
  choice = static_cast<Choice>((static_cast<int>(choice) + count + by) % count);
}

/// The system's choice is before the first language.
std::optional<Language> language_beside(std::optional<Language> language, int by) {
  constexpr int choices = 1 + static_cast<int>(language_codes.size());
  const int choice = ((language ? 1 + static_cast<int>(*language) : 0) + choices + by) % choices;
  return choice == 0 ? std::nullopt : std::optional(static_cast<Language>(choice - 1));
}

template <class Choice>
std::string one_of(const Words& words, Choice choice, std::initializer_list<Text> texts) {
  return words(texts.begin()[static_cast<std::size_t>(choice)]);
}

/// A row that is on or off.
template <bool Settings::*Member>
constexpr SettingsRow yes_or_no(Text label, Text about) {
  return {Kind::choice, label, about,
          [](const Words& words, const Settings& now) {
            return words(now.*Member ? Text::yes : Text::no);
          },
          [](Settings& now, int) { now.*Member = !(now.*Member); }};
}

template <int Player>
constexpr SettingsRow name() {
  return {
      Kind::name,       Text::set_name,
      Text::about_name, [](const Words& words, const Settings&) { return words.player(Player); },
      nullptr,          Player};
}

std::string hand_in(const Words& words, Steadiness hand) {
  if (hand == Steadiness::exact) return words(Text::hand_exact);
  const double error = error_of(hand);
  return words(Text::hand_px,
               {error < 1 ? words.tenths(error) : words.number(static_cast<std::int64_t>(error))});
}

constexpr std::array general{
    SettingsRow{Kind::choice, Text::set_language, Text::about_language,
                [](const Words& words, const Settings& now) {
                  return now.language ? std::string(name_of(*now.language))
                                      : words(Text::as_system);
                },
                [](Settings& now, int by) { now.language = language_beside(now.language, by); }},
    SettingsRow{Kind::amount, Text::set_volume, Text::about_volume,
                [](const Words& words, const Settings& now) {
                  return words(Text::per_cent, {words.number(now.volume)});
                },
                [](Settings& now, int by) {
                  now.volume = std::clamp(now.volume + by * volume_step, 0, most_volume);
                }},
    yes_or_no<&Settings::mute>(Text::set_mute, Text::about_mute),
    yes_or_no<&Settings::hints>(Text::set_hints, Text::about_hints),
};

constexpr std::array picture{
    SettingsRow{Kind::choice, Text::set_colours, Text::about_colours,
                [](const Words& words, const Settings& now) {
                  return one_of(words, now.colours,
                                {Text::colours_standard, Text::colours_red_green,
                                 Text::colours_blue_yellow, Text::colours_high_contrast});
                },
                [](Settings& now, int by) { turn(now.colours, 4, by); }},
    SettingsRow{Kind::choice, Text::set_motion, Text::about_motion,
                [](const Words& words, const Settings& now) {
                  return one_of(words, now.reduced_motion, {Text::as_system, Text::yes, Text::no});
                },
                [](Settings& now, int by) { turn(now.reduced_motion, 3, by); }},
    yes_or_no<&Settings::screen_shake>(Text::set_shake, Text::about_shake),
};

constexpr std::array aiming{
    SettingsRow{Kind::choice, Text::set_way, Text::about_way,
                [](const Words& words, const Settings& now) {
                  return one_of(
                      words, now.aiming.way,
                      {Text::way_clicks, Text::way_pull, Text::way_turn, Text::way_apart});
                },
                [](Settings& now, int by) { turn(now.aiming.way, 4, by); }},
    SettingsRow{Kind::choice, Text::set_preview, Text::about_preview,
                [](const Words& words, const Settings& now) {
                  return one_of(words, now.aiming.preview,
                                {Text::preview_off, Text::preview_contact, Text::preview_short,
                                 Text::preview_full});
                },
                [](Settings& now, int by) { turn(now.aiming.preview, 4, by); }},
    SettingsRow{Kind::choice, Text::set_go_on, Text::about_go_on,
                [](const Words& words, const Settings& now) {
                  return words(now.go_on ? Text::go_on_itself : Text::go_on_click);
                },
                [](Settings& now, int) { now.go_on = !now.go_on; }},
    yes_or_no<&Settings::quick_rolling>(Text::set_quick_rolling, Text::about_quick_rolling),
};

constexpr std::array players{
    name<0>(),
    name<1>(),
    SettingsRow{Kind::choice, Text::set_breaks, Text::about_breaks,
                [](const Words& words, const Settings& now) {
                  if (now.breaks == Breaks::player_1 || now.breaks == Breaks::player_2)
                    return words.player(now.breaks == Breaks::player_1 ? 0 : 1);
                  return words(now.breaks == Breaks::alternate ? Text::breaks_alternate
                                                               : Text::breaks_loser);
                },
                [](Settings& now, int by) { turn(now.breaks, 4, by); }},
    SettingsRow{Kind::choice, Text::set_hand, Text::about_hand,
                [](const Words& words, const Settings& now) { return hand_in(words, now.hand); },
                [](Settings& now, int by) { turn(now.hand, 7, by); }},
};

constexpr std::array<SettingsPage, settings_pages> pages{{
    {Text::tab_general, general},
    {Text::tab_picture, picture},
    {Text::tab_aiming, aiming},
    {Text::tab_players, players},
}};
static_assert(std::all_of(pages.begin(), pages.end(), [](const SettingsPage& page) {
  return page.rows.size() <= most_settings_rows;
}));

}  // namespace

const SettingsPage& settings_page(std::size_t page) { return pages[page]; }

}  // namespace app
