#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

/// Every word the player reads.
namespace app {

enum class Language : std::uint8_t { english, french };

/// From a POSIX locale's name such as "fr_CA.UTF-8"; English unless it is French.
Language language_of_locale(std::string_view locale);

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
  count,
};

/// The texts of one language.
class Words {
 public:
  explicit Words(Language language) : language_(language) {}

  /// The text, with {0}, {1}, … replaced by the values given.
  std::string operator()(Text text, std::initializer_list<std::string_view> values = {}) const;
  /// Thousands set apart as the language does.
  std::string number(int value) const;
  /// With one digit behind the point or comma.
  std::string tenths(double value) const;
  /// A shipped level's name in the language; others are left as they are.
  std::string level_name(std::string_view name) const;
  /// "Player 1" for 0.
  std::string player(int player) const;

 private:
  Language language_;
};

}  // namespace app
