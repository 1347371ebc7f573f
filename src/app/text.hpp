#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

/// Every word the player reads.
namespace app {

enum class Language : std::uint8_t { english, french };

/// From a POSIX locale's name such as "fr_CA.UTF-8"; English unless it is French.
Language language_of_locale(std::string_view locale);

/// The language of a start.
struct StartLanguage {
  // Implicit: most starts just have one.
  StartLanguage(Language of, bool by_player = false) : language(of), asked(by_player) {}  // NOLINT

  Language language;
  bool asked;  ///< by the player, at this start; otherwise it is the system's
};

enum class Text : std::uint8_t {
  product,
  tagline,
  title_screen,
  billiards,
  angry_balls,
  quit,
  player,
  to_play,
  waiting,
  balls_left,
  this_turn,
  restart,
  close,
  retry,
  hint_take_cue_ball,
  hint_not_cue_ball,
  hint_shoot,
  hint_too_weak,
  hint_watch,
  hint_place,
  hint_obstructed,
  on_ball,
  on_hole,
  on_cushion,
  speed,
  speed_capped,
  points,
  turn_of,
  turn_scored,
  turn_nothing,
  cue_ball_in_hand,
  wins,
  draw,
  play_again,
  back_to_title,
  ask_restart,
  ask_leave,
  game_is_lost,
  new_game,
  leave,
  keep_playing,
  aiming,
  watching,
  placing,
  state,
  choose_level,
  level_menu,
  best,
  not_won_yet,
  page,
  previous_page,
  next_page,
  title_button,
  hint_choose_level,
  hint_broken_level,
  scores_set_aside,
  scores_not_kept,
  menu,
  score,
  throws,
  enemies,
  goal,
  level_and_name,
  hint_take_projectile,
  hint_not_projectile,
  hint_throw,
  hint_flying,
  hint_next,
  hint_finish,
  next_throw,
  finish,
  won,
  lost,
  new_best,
  throws_used,
  enemies_remain,
  next_level,
  ask_leave_level,
  level_is_lost,
  ready_to_throw,
  watching_throw,
  next_offered,
  finish_offered,
  level_state,
  menu_state,
  continue_billiards,
  continue_table,
  continue_level,
  continue_named_level,
  practice,
  replays,
  ask_new_game,
  continue_game,
  kept_billiards,
  other_level,
  kept_refused_billiards,
  kept_refused_level,
  kept_set_aside,
  kept_file,
  kept_blocked,
  fault_damaged,
  fault_other_version,
  fault_diverged,
  fault_finished,
  ok,
  not_kept,
  loading,
  turns_loaded,
  cancel,
  watch_replay,
  replay_title,
  replay_state,
  replay_playing,
  replay_paused,
  play,
  pause,
  one_step,
  previous_turn,
  following_turn,
  slower,
  faster,
  times,
  save_replay,
  copy,
  turn_of_turns,
  turn_of_player,
  verifying,
  verified,
  diverged,
  hint_replay,
  replay_saved,
  replay_not_saved,
  replay_copied,
  replay_not_copied,
  score_pair,
  saved_replays,
  paste,
  no_replays,
  hint_replays,
  replay_line,
  replays_state,
  bad_replay,
  old_replay,
  paste_failed,
  paste_damaged,
  paste_other_version,
  take_back,
  repeat,
  slower_throw,
  faster_throw,
  turn_left,
  turn_right,
  hint_repeat,
  practised,
  practice_state,
  practice_on,
  practice_off,
  hint_practice_levels,
  practice_only,
  aimed,
  entered_angle,
  entered_speed,
  hint_pull,
  hint_let_go,
  hint_turn,
  hint_keys,
  hint_entry,
  points_made,
  balls,
  best_turn,
  shots,
  fouls,
  settings,
  settings_state,
  settings_broken,
  settings_unreadable,
  settings_set_aside,
  settings_blocked,
  settings_not_kept,
  hint_settings,
  tab_general,
  tab_picture,
  tab_aiming,
  tab_players,
  set_language,
  set_volume,
  set_mute,
  set_hints,
  set_colours,
  set_motion,
  set_shake,
  set_way,
  set_preview,
  set_name,
  set_breaks,
  set_keep_turn,
  about_language,
  about_volume,
  about_mute,
  about_hints,
  about_colours,
  about_motion,
  about_shake,
  about_way,
  about_preview,
  about_name,
  about_breaks,
  about_keep_turn,
  as_system,
  english,
  french,
  per_cent,
  yes,
  no,
  colours_standard,
  colours_red_green,
  colours_blue_yellow,
  colours_high_contrast,
  way_clicks,
  way_pull,
  way_turn,
  preview_off,
  preview_contact,
  preview_short,
  preview_full,
  breaks_alternate,
  breaks_loser,
  sound_on,
  sound_off,
  paused,
  hint_paused,
  paused_state,
  open_file,
  link_refused,
  link_damaged,
  file_refused,
  level_not_kept,
  count,
};

/// The texts of one language. Copies speak alike: what is changed in one holds in all of them, so
/// screens keep theirs, and a change of language needs no new screen.
class Words {
 public:
  explicit Words(Language language) : voice_(std::make_shared<Voice>(Voice{language, {}})) {}
  // No moving: there are always words.
  Words(const Words&) = default;
  Words& operator=(const Words&) = default;
  ~Words() = default;

  void speak(Language language) { voice_->language = language; }
  Language language() const { return voice_->language; }
  /// What player() gives; an empty name means "Player 1", "Player 2".
  void name_players(std::array<std::string, 2> names) { voice_->names = std::move(names); }

  /// The text, with {0}, {1}, … replaced by the values given.
  std::string operator()(Text text, std::initializer_list<std::string_view> values = {}) const;
  /// Thousands set apart as the language does.
  std::string number(int value) const;
  /// With one digit behind the point or comma.
  std::string tenths(double value) const;
  /// A shipped level's name in the language; others are left as they are.
  std::string level_name(std::string_view name) const;
  /// The name of player 0 or 1: "Player 1" for a player without one.
  std::string player(int player) const;

 private:
  struct Voice {
    Language language;
    std::array<std::string, 2> names;
  };
  std::shared_ptr<Voice> voice_;
};

}  // namespace app
