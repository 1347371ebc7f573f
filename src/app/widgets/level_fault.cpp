#include "app/widgets/level_fault.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace app {
namespace {

using enum carom::MessageCode;

/// The text of a code. Codes without one are said in English, or left out where they only add what
/// was expected.
struct Row {
  carom::MessageCode code;
  Text text;
};

constexpr std::array rows{
    Row{is_missing, Text::fault_missing},
    Row{is_unknown_key, Text::fault_unknown_key},
    Row{is_given_twice, Text::fault_twice},
    Row{is_empty, Text::fault_empty},
    Row{is_not_json, Text::fault_json},
    Row{is_not_json_found, Text::fault_json},
    Row{is_not_json_utf8, Text::fault_json},
    Row{is_not_json_open_text, Text::fault_json},
    Row{is_not_json_control, Text::fault_json},
    Row{is_not_json_escape, Text::fault_json},
    Row{is_nested_too_deeply, Text::fault_nested},
    Row{is_not_utf8, Text::fault_utf8},
    Row{is_gone, Text::fault_gone},
    Row{is_object, Text::fault_object},
    Row{is_array, Text::fault_array},
    Row{is_newer, Text::fault_newer},
    Row{is_second_lead, Text::fault_second_lead},
    Row{is, Text::fault_is},
    Row{has_no_projectile, Text::fault_no_projectile},
    Row{has_no_enemy, Text::fault_no_enemy},
    Row{has_elements, Text::fault_too_many},
    Row{has_more_elements, Text::fault_too_many},
    Row{moves_at, Text::fault_speed},
    Row{sticks_out_left, Text::fault_sticks_out},
    Row{sticks_out_right, Text::fault_sticks_out},
    Row{sticks_out_bottom, Text::fault_sticks_out},
    Row{sticks_out_top, Text::fault_sticks_out},
    Row{overlaps_obstacle, Text::fault_overlaps},
    Row{is_bytes_long, Text::fault_too_long},
    Row{is_too_large_a_number, Text::fault_too_large},
    Row{is_larger_than_bytes, Text::fault_too_large},
    Row{has_overlapping_pairs, Text::fault_pairs},
    Row{has_balls_in_holes, Text::fault_on_holes},
    Row{cannot_be_opened, Text::fault_unopened},
    Row{number_above_to, Text::fault_want_greater_to},
    Row{number_above, Text::fault_want_greater},
    Row{number_from_to, Text::fault_want_from_to},
    Row{number_from, Text::fault_want_least},
    Row{whole_number_from_to, Text::fault_want_whole},
    Row{one_of, Text::fault_want_one_of},
    Row{one_lead_first, Text::fault_want_one_lead},
    Row{at_most, Text::fault_want_most},
};

/// In the player's language; empty if there is no text.
std::string translated(const Words& words, const carom::Message& message) {
  const auto* const row =
      std::ranges::find(rows, message.code, [](const Row& known) { return known.code; });
  if (row == rows.end()) return {};
  // A number's unit follows it; it is the last argument.
  const std::size_t last = message.code == number_above || message.code == number_from ? 0 : 1;
  std::array<std::string, 2> values;
  for (std::size_t i = 0; i < message.arguments.size(); ++i)
    values[std::min(i, last)] += message.arguments[i];
  return words(row->text, {values[0], values[1]});
}

}  // namespace

std::string problem_of(const Words& words, const Level& level) {
  if (level.scene || words.language() == Language::en) return level.problem;
  carom::Error error = level.scene.errors().front();
  const std::string expected = translated(words, std::exchange(error.expected, {}));
  if (std::string problem = translated(words, error.problem); !problem.empty())
    error.problem = std::move(problem);
  const std::string text = carom::to_string(error, level.file);
  return expected.empty() ? text : words(Text::fault_with_expected, {text, expected});
}

}  // namespace app
