#include "app/widgets/level_fault.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace app {
namespace {

// In the order in which they are tried.
constexpr std::array problems{
    Text::fault_missing, Text::fault_unknown_key,   Text::fault_twice,    Text::fault_empty,
    Text::fault_json,    Text::fault_nested,        Text::fault_utf8,     Text::fault_gone,
    Text::fault_object,  Text::fault_array,         Text::fault_newer,    Text::fault_second_lead,
    Text::fault_is,      Text::fault_no_projectile, Text::fault_no_enemy, Text::fault_too_many,
    Text::fault_speed,   Text::fault_sticks_out,    Text::fault_overlaps, Text::fault_unopened,
};
constexpr std::array expectations{
    Text::fault_want_greater_to, Text::fault_want_greater,  Text::fault_want_from_to,
    Text::fault_want_from_most,  Text::fault_want_least,    Text::fault_want_whole,
    Text::fault_want_one_of,     Text::fault_want_one_lead, Text::fault_want_most,
};

/// What stands for {0} and {1} of the pattern in `text`; nothing if the text is another.
std::optional<std::array<std::string_view, 2>> values_in(std::string_view text,
                                                         std::string_view pattern) {
  std::array<std::string_view, 2> values;
  for (std::string_view& value : values) {
    const std::size_t sign = pattern.find('{');
    if (!text.starts_with(pattern.substr(0, sign))) return std::nullopt;
    if (sign == std::string_view::npos) break;
    text.remove_prefix(sign);
    pattern.remove_prefix(sign + 3);
    const std::string_view next = pattern.substr(0, pattern.find('{'));
    const std::size_t end = next.empty() ? text.size() : text.find(next);
    if (end == std::string_view::npos) return std::nullopt;
    value = text.substr(0, end);
    text.remove_prefix(end);
  }
  return text == pattern ? std::optional(values) : std::nullopt;
}

/// The engine's sentence in the player's language; empty if none of the texts is that sentence.
template <std::size_t n>
std::string translated(const Words& words, std::string_view sentence,
                       const std::array<Text, n>& texts) {
  const Words english(Language::en);
  for (const Text text : texts)
    if (const auto values = values_in(sentence, english(text, {"{0}", "{1}"})))
      return words(text, {(*values)[0], (*values)[1]});
  return {};
}

}  // namespace

std::string problem_of(const Words& words, const Level& level) {
  if (level.scene || words.language() == Language::en) return level.problem;
  carom::Error error = level.scene.errors().front();
  const std::string problem = translated(words, error.problem, problems);
  const std::string expected = translated(words, error.expected, expectations);
  if (!problem.empty()) error.problem = problem;
  error.expected.clear();
  const std::string text = carom::to_string(error, level.file);
  // An expectation that has no translation is left out.
  return expected.empty() ? text : words(Text::fault_with_expected, {text, expected});
}

}  // namespace app
