#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/public.hpp"

namespace CAROM_PUBLIC carom {

// All that the library finds wrong, or says that it expected: X(code, English template). In a
// template {0} stands for the first argument, {1} for the second, … This is the one place where the
// English sentences are.
#define CAROM_MESSAGES(X)                                                                 \
  X(text, "{0}") /* of unknown origin: the operating system's words, for instance */      \
  /* Problems of the input. */                                                            \
  X(is, "is {0}")                                                                         \
  X(is_object, "is an object")                                                            \
  X(is_array, "is an array")                                                              \
  X(is_missing, "is missing")                                                             \
  X(is_unknown_key, "is an unknown key")                                                  \
  X(is_given_twice, "is given twice")                                                     \
  X(is_given, "is given")                                                                 \
  X(is_empty, "is empty")                                                                 \
  X(is_newer, "is {0}, newer than this program")                                          \
  X(is_nested_too_deeply, "is nested too deeply")                                         \
  X(is_too_large_a_number, "is too large")                                                \
  X(is_larger_than_bytes, "is larger than {0} bytes")                                     \
  X(is_bytes_long, "is {0} bytes long")                                                   \
  X(is_not_utf8, "is not in UTF-8")                                                       \
  X(is_not_json, "is not valid JSON")                                                     \
  X(is_not_json_found, "is not valid JSON: found {0}")                                    \
  X(is_not_json_utf8, "is not valid JSON: a text is not in UTF-8")                        \
  X(is_not_json_open_text, "is not valid JSON: a text does not end on its line")          \
  X(is_not_json_control, "is not valid JSON: a text contains {0}")                        \
  X(is_not_json_escape, "is not valid JSON: a text has a wrong escape sequence")          \
  X(has_elements, "has {0} elements")                                                     \
  X(has_more_elements, "has more than {0} elements")                                      \
  X(has_overlapping_pairs, "overlap in more than {0} pairs")                              \
  X(has_balls_in_holes, "lie on holes in more than {0} pairs")                            \
  X(moves_at, "moves at {0} px/s")                                                        \
  X(is_second_lead, "is {0}, but ball 0 is {1} already")                                  \
  X(sticks_out_left, "sticks out of the solid left edge")                                 \
  X(sticks_out_right, "sticks out of the solid right edge")                               \
  X(sticks_out_bottom, "sticks out of the solid bottom edge")                             \
  X(sticks_out_top, "sticks out of the solid top edge")                                   \
  X(overlaps_obstacle, "overlaps obstacle {0} (x {1}, height {2}, radius {3})")           \
  X(one_more_error, "and 1 more error")                                                   \
  X(more_errors, "and {0} more errors")                                                   \
  X(is_inexact, "cannot be simulated exactly by this build")                              \
  X(is_no_ball, "is no ball in play")                                                     \
  X(is_too_fast, "is not finite or too fast")                                             \
  X(is_too_far, "is not finite or too far away")                                          \
  X(has_no_lead, "has nothing to place")                                                  \
  X(has_no_projectile, "have no projectile")                                              \
  X(has_no_enemy, "have no enemy")                                                        \
  X(has_no_cue_ball, "have no cue ball")                                                  \
  X(is_out_of_turn, "is out of turn")                                                     \
  X(is_not_free, "is not free")                                                           \
  X(gives_no_velocity, "gives no velocity")                                               \
  X(is_of_other_game, "is one of the other game")                                         \
  X(is_of_other_version, "made by {0} {1}, this is {0} {2}")                              \
  X(is_third_score, "is a third score")                                                   \
  X(has_moves, "has {0} moves")                                                           \
  X(has_options_of_billiards, "has options of billiards")                                 \
  X(has_infinite_drag, "has a place or drag that is not finite")                          \
  X(makes_game_too_long, "makes the game longer than {0} steps")                          \
  X(is_not_the_replays, "is not the replay's")                                            \
  X(has_diverged, "{0}")                                                                  \
  X(is_damaged, "is damaged: {0}")                                                        \
  X(is_longer_than, "is longer than {0} characters")                                      \
  X(has_foreign_character, "is no text of {0}: its character {1} does not belong there")  \
  X(is_version_of, "is version {0} of the text of {1}")                                   \
  X(is_gone, "is not there any more")                                                     \
  X(cannot_be_opened, "cannot be opened: {0}")                                            \
  X(has_nothing_to_launch, "has nothing to launch")                                       \
  /* Objections of a player to a sound level. */                                          \
  X(warning, "warning: {0}")                                                              \
  X(crosses_level_at_once,                                                                \
    "is {0} px: a throw of full strength crosses it in {1} × 0.01 "                      \
    "s")                                                                                  \
  X(falls_too_slowly,                                                                     \
    "makes a ball that falls through the whole level no faster than {0} "                 \
    "px/s, which counts as standing still")                                               \
  X(lies_in_hole, "lies within hole {0}: a throw is over as soon as it begins")           \
  X(lies_on_hole, "lies within hole {0}, which pulls every throw")                        \
  X(lies_outside_level,                                                                   \
    "lies outside the level: the projectile is lost as soon as it is "                    \
    "thrown")                                                                             \
  X(lies_on_launch_place, "lies on the launch place")                                     \
  X(has_no_effect, "has no effect")                                                       \
  X(is_lost_by_itself, "is lost by itself before anything is thrown")                     \
  X(moves_by_itself, "moves {0} px by itself before anything is thrown")                  \
  X(never_rests_by_itself,                                                                \
    "does not come to rest by itself within 30 s: the next throw would "                  \
    "never be offered")                                                                   \
  X(never_rests_after_throw,                                                              \
    "does not come to rest within 60 s after a throw: the next one is not "               \
    "offered")                                                                            \
  X(is_out_of_reach,                                                                      \
    "could not be hurt, pocketed or driven out by any of {0} throws "                     \
    "tried")                                                                              \
  X(is_out_of_reach_so_far,                                                               \
    "could not be hurt, pocketed or driven out by any of the {0} throws "                 \
    "tried")                                                                              \
  X(more_warnings, "and {0} more of the kind")                                            \
  X(budget_is_used_up,                                                                    \
    "is too large to try everything: the budget of {0} million ball-steps "               \
    "is used up after {1} of {2} throws")                                                 \
  /* Expectations. {1}     or {2} of a number is its unit or another note in brackets. */ \
  X(number_above, "a number greater than {0}{1}")                                         \
  X(number_above_to, "a number greater than {0} and at most {1}{2}")                      \
  X(number_from_to, "a number from {0} to {1}{2}")                                        \
  X(number_from, "a number of at least {0}{1}")                                           \
  X(whole_number_from_to, "a whole number from {0} to {1}")                               \
  X(at_most, "at most {0}")                                                               \
  X(at_most_speed, "at most {0} (px/s)")                                                  \
  X(at_most_levels, "at most {0} arrays and objects within each other")                   \
  X(at_most_brackets, "at most {0} levels of brackets")                                   \
  X(at_most_pairs, "at most 20 per ball and 10000 more")                                  \
  X(one_of, "one of {0}")                                                                 \
  X(each_key_once, "every key at most once")                                              \
  X(text_of_200_bytes, "a text of at most 200 bytes")                                     \
  X(text_of_2000_bytes, "a text of at most 2000 bytes")                                   \
  X(format_version, "1, the version of the format")                                       \
  X(object_of_edges, "an object such as {{\"left\": \"open\"}")                           \
  X(object_such_as, "an object such as {0}")                                              \
  X(throws, "a whole number from 1 to 1000")                                              \
  X(array_of_holes, "an array of holes")                                                  \
  X(array_of_obstacles, "an array of obstacles")                                          \
  X(array_of_balls, "an array of balls")                                                  \
  X(edge, "\"solid\" or \"open\"")                                                        \
  X(role, "\"neutral\", \"cue\", \"red\", \"enemy\" or \"projectile\"")                   \
  X(one_lead_first, "at most one cue ball or projectile, and that as the first ball")     \
  X(x_at_least, "x of at least {0} (px)")                                                 \
  X(x_at_most, "x of at most {0} (px)")                                                   \
  X(y_at_least, "y of at least {0} (px)")                                                 \
  X(y_at_most, "y of at most {0} (px)")                                                   \
  X(place_outside_obstacles, "a place outside of every obstacle")                         \
  X(ball_in_play, "a ball in play")                                                       \
  X(world_with_lead, "a world with a cue ball or projectile")                             \
  X(coordinates_from_to, "coordinates from {0} to {1} (px)")                              \
  X(exact_arithmetic, "one with -ffp-contract=off and without a part of -ffast-math")     \
  X(first_ball_projectile, "the first ball to have the role \"projectile\"")              \
  X(first_ball_cue, "the first ball to have the role \"cue\"")                            \
  X(some_enemy, "at least one ball with the role \"enemy\"")                              \
  X(finite_drag, "a finite vector that is not zero")                                      \
  X(free_place, "a place clear of balls, holes and cushions")                             \
  X(cue_ball_waiting, "the cue ball at rest, waiting for its shot")                       \
  X(cue_ball_in_hand, "the cue ball in hand")                                             \
  X(projectile_ready, "the projectile at the launch place")                               \
  X(throw_at_rest, "a throw that has come to rest")                                       \
  X(command_of_game, "a command of the game that is played")                              \
  X(text_of, "the text of {0}")                                                           \
  X(text_of_whole, "the text of {0}, whole and unchanged")                                \
  X(text_characters, "letters, digits, - and _ only")                                     \
  X(version, "version {0}")                                                               \
  X(shorter_game, "a shorter game")                                                       \
  X(lead_as_first_ball, "a projectile or a cue ball as the first ball")                   \
  X(level_in_px, "a level some hundred px wide; lengths are px, not metres")              \
  X(gravity_in_px, "some hundred px/s²; at {0} px/s a ball begins to count as moving")    \
  X(launch_place_off_holes, "a launch place outside of all holes")                        \
  X(launch_place_in_level, "a launch place between 0 and the width")                      \
  X(place_off_projectile, "a place clear of the projectile")                              \
  X(no_solidity, "no solidity: a projectile's is infinite")                               \
  X(ball_that_stays, "a ball that stays until it is hit")                                 \
  X(ball_at_rest, "a ball at rest: on the floor, on a cap or right above another ball")   \
  X(balls_that_rest, "balls that come to rest")                                           \
  X(friction_below_1, "friction below 1, holes that are larger than the balls")           \
  X(enemy_within_reach, "an enemy within reach")                                          \
  X(fewer_balls, "fewer balls, or a look at what was not tried")                          \
  X(finite_numbers, "finite numbers (px)")

/// Which sentence a Message is. Translations go by it.
enum class MessageCode : std::uint8_t {
#define CAROM_CODE(code, english) code,
  CAROM_MESSAGES(CAROM_CODE)
#undef CAROM_CODE
};

/// A part of an error: what it says, as a code, and with which numbers and names.
struct Message {
  MessageCode code = MessageCode::text;
  /// In the order of the template's places. What stood in a file is cut and fit to be printed.
  std::vector<std::string> arguments{};

  Message() = default;
  Message(MessageCode what, std::vector<std::string> with = {})
      : code(what), arguments(std::move(with)) {}
  /// A sentence from elsewhere. An empty one says nothing.
  Message(std::string text) {
    if (!text.empty()) arguments.push_back(std::move(text));
  }
  Message(std::string_view text) : Message(std::string(text)) {}
  Message(const char* text) : Message(std::string(text)) {}

  bool empty() const { return code == MessageCode::text && arguments.empty(); }
  friend bool operator==(const Message&, const Message&) = default;
};

/// The code as it is written in CAROM_MESSAGES: "is_missing".
std::string_view name(MessageCode code);
/// The English template of a code.
std::string_view english(MessageCode code);
/// A template with the arguments in its places; "{{" stands for a brace.
std::string fill(std::string_view form, const std::vector<std::string>& arguments);
/// In English; "" for an empty one.
std::string to_string(const Message& message);

}  // namespace carom
