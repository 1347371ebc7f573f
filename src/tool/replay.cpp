#include "tool/replay.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "carom/display_text.hpp"
#include "carom/trace.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "files/output.hpp"
#include "json/limits.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"
#include "tool/counted.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

using Json = nlohmann::json;

struct ReplayOptions {
  std::string file;
  bool verify = false;
  bool text = false;
  bool json = false;
  std::optional<std::string> trace;
  std::optional<std::string> against;
};

std::string score_text(const replay::Replay& replay, const std::array<std::int64_t, 2>& score) {
  std::string text = std::to_string(score[0]);
  if (replay.kind() == replay::Kind::billiards) text += " : " + std::to_string(score[1]);
  return text;
}

void print_turns(const replay::Player& player, std::FILE* out) {
  const replay::Replay& replay = player.replay();
  const bool billiards = replay.kind() == replay::Kind::billiards;
  if (billiards)
    std::fputs("turn  player  steps  points  score\n", out);
  else
    // In quotes: a name may contain anything.
    std::fprintf(out, "\"%s\"\nturn  steps  points  score\n",
                 carom::display_text(replay.level->name).c_str());
  for (std::size_t i = 0; i < player.reached_turns(); ++i) {
    const replay::Turn& turn = player.turns()[i];
    std::fprintf(out, "%4zu", i + 1);
    if (billiards) std::fprintf(out, "  %6d", turn.player + 1);
    std::fprintf(out, "  %5llu  %6lld  %s\n", static_cast<unsigned long long>(turn.steps),
                 static_cast<long long>(turn.points), score_text(replay, turn.score).c_str());
  }
}

// The steps of a trace one by one, whatever white space is between and within them.
class TraceReader {
 public:
  explicit TraceReader(std::string_view trace) : rest_(trace) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  // The next step, up to the bracket that closes it, or what stands there instead of one; empty at
  // the end.
  std::string_view next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    std::size_t end = 0;
    std::size_t depth = 0;
    bool in_text = false;
    for (; end < rest_.size(); ++end) {
      const char c = rest_[end];
      if (in_text) {
        if (c == '\\') ++end;
        if (c == '"') in_text = false;
      } else if (c == '"') {
        in_text = true;
      } else if (c == '{' || c == '[') {
        ++depth;
      } else if (c == '}' || c == ']') {
        if (depth <= 1) break;
        --depth;
      } else if (c == '\n' && depth == 0) {
        break;
      }
    }
    const std::string_view step = rest_.substr(0, std::min(end + 1, rest_.size()));
    rest_.remove_prefix(step.size());
    return step;
  }

 private:
  std::string_view rest_;
};

// The difference between two steps of traces, number by number: "ball 12: expected …, got …". Empty
// when they say the same.
std::string difference(std::string_view expected_line, std::string_view got_line) {
  constexpr json::Limits limits{.depth = 8, .values = std::numeric_limits<std::size_t>::max()};
  const Json expected = json::parse<Json>(expected_line, limits);
  const Json got = Json::parse(got_line, nullptr, false);
  if (expected == got) return {};
  if (!expected.is_object() || !expected.contains("balls") || !expected["balls"].is_array())
    return "expected a line of a trace";
  const auto with_id = [](const Json& step, const Json& id) {
    for (const Json& ball : step["balls"])
      if (ball.is_object() && ball.value("id", Json()) == id)
        return carom::display_text(ball.dump(-1, ' ', false, Json::error_handler_t::replace));
    return std::string("no such ball");
  };
  for (const Json* const step : {&expected, &got})
    for (const Json& ball : (*step)["balls"]) {
      const Json id = ball.is_object() ? ball.value("id", Json()) : Json();
      const std::string theirs = with_id(expected, id);
      const std::string ours = with_id(got, id);
      if (theirs != ours)
        return std::string("ball ")
                   .append(
                       carom::display_text(id.dump(-1, ' ', false, Json::error_handler_t::replace)))
                   .append(": expected ")
                   .append(theirs) +
               ", got " + ours;
    }
  return "all balls agree, the order, the events or the hash do not";
}

// Calls f with every line of the game's trace, without the newline, until it returns false.
template <class F>
void for_each_trace_line(replay::Player player, F f) {
  std::span<const carom::Event> events;
  std::string line;
  for (bool more = true; more;) {
    line.clear();
    carom::append_trace_line(line, replay::world(player.game()), events);
    line.pop_back();
    if (!f(player.steps(), std::string_view(line))) return;
    // The last commands of a replay may have no step after them.
    const std::uint64_t before = player.steps();
    do more = player.step();
    while (more && player.steps() == before);
    events = std::visit([](const auto& game) { return game.physics_events(); }, player.game());
  }
}

int write_trace(const replay::Player& player, files::Output& trace, const std::string& path) {
  for_each_trace_line(player, [&](std::uint64_t, std::string_view line) {
    trace.write(line);
    trace.write("\n");
    return !trace.failed();
  });
  const carom::Status written = trace.commit();
  return written ? done : report_output(written.errors(), path);
}

// The turn, counted from 1, that a step belongs to.
std::size_t turn_of(const replay::Player& player, std::uint64_t step) {
  std::size_t turn = 1;
  while (turn < player.turns().size() && player.turns()[turn].first_step < step) ++turn;
  return turn;
}

// Step by step against the trace of the same game, played elsewhere.
int compare_with_trace(const replay::Player& player, std::string_view trace) {
  TraceReader theirs(trace);
  std::string problem;
  std::uint64_t at = 0;
  for_each_trace_line(player, [&](std::uint64_t step, std::string_view line) {
    const std::string_view expected = theirs.next();
    at = step;
    if (expected.empty())
      problem = "the trace ends here";
    else if (expected != line)
      problem = difference(expected, line);
    return problem.empty();
  });
  if (problem.empty() && !theirs.next().empty()) problem = "the trace goes on, the replay ends";
  if (problem.empty()) return done;
  std::fprintf(stderr, "diverged in turn %zu at step %llu, %s\n", turn_of(player, at),
               static_cast<unsigned long long>(at), problem.c_str());
  return wrong_input;
}

int convert(const replay::Replay& replay, const ReplayOptions& options) {
  // With its defaults and blanks a level may be longer than it was. A text holds less than JSON.
  const auto fits = [&](const std::string& json) {
    return json.size() <= replay::max_bytes
               ? done
               : report({{.problem = {carom::MessageCode::is_larger_than_bytes,
                                      {std::to_string(replay::max_bytes)}}}},
                        options.file);
  };
  if (options.text) {
    if (const int status = fits(replay::write_json(replay)); status != done) return status;
    std::printf("%s\n", replay::write_text(replay).c_str());
    return done;
  }
  const auto full = replay::with_full_hashes(replay);
  if (!full) return report(full.errors(), options.file);
  const std::string json = replay::write_json(full.value());
  if (const int status = fits(json); status != done) return status;
  std::fputs(json.c_str(), stdout);
  return done;
}

int play(const ReplayOptions& options) {
  const auto bytes = files::read_text(options.file, files::max_small_file);
  if (!bytes) return report(bytes.errors(), options.file);
  auto read = replay::read_replay(bytes.value());
  if (!read) return report(read.errors(), options.file);
  if (options.text || options.json) return convert(read.value(), options);

  const auto verified = replay::verify(std::move(read).value());
  if (!verified) return report(verified.errors(), options.file);
  const replay::Player& player = verified.value();
  // All input is read before anything is written.
  std::string against;
  std::vector<std::string> inputs{options.file};
  if (options.against) {
    auto trace = files::read_text(*options.against);
    if (!trace) return report(trace.errors(), *options.against);
    against = std::move(trace).value();
    inputs.push_back(*options.against);
  }
  std::optional<files::Output> trace;
  if (options.trace) {
    trace.emplace(*options.trace, inputs);
    if (const carom::Status opened = trace->opened(); !opened)
      return report_output(opened.errors(), *options.trace);
  }
  // A trace on standard output stays pure; the rest then goes to standard error.
  std::FILE* out = trace && trace->is_standard_output() ? stderr : stdout;
  if (!options.verify) print_turns(player, out);
  if (trace)
    if (const int status = write_trace(player, *trace, *options.trace); status != done)
      return status;
  if (options.against)
    if (const int status = compare_with_trace(player, against); status != done) return status;
  if (player.divergence()) {
    std::fprintf(stderr, "%s\n",
                 replay::to_string(*player.divergence(), player.turns().size()).c_str());
    return wrong_input;
  }
  if (options.verify)
    std::fprintf(out, "verified, %s, score %s\n", counted(player.turns().size(), "turn").c_str(),
                 score_text(player.replay(), player.replay().score).c_str());
  return done;
}

}  // namespace

void add_replay(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = carom.add_subcommand("replay", "Play a recorded game and prove it.");
  command
      ->add_option("replay", options->file,
                   "Replay file, JSON or the text for links; - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("REPLAY");
  CLI::Option* verify =
      command->add_flag("--verify", options->verify,
                        "Print only whether the game went as the replay says, or where not");
  command
      ->add_option("--trace", options->trace,
                   "Write every step's balls and events as JSON Lines; - is standard output")
      ->check(cli::file_name())
      ->option_text("FILE");
  command
      ->add_option("--against", options->against,
                   "Compare every step with a trace of the same game, written elsewhere, and name "
                   "step and ball of the first difference")
      ->check(cli::file_name())
      ->option_text("TRACE");
  CLI::Option* text = command->add_flag("--text", options->text,
                                        "Only print the replay as text for links, unplayed");
  CLI::Option* json = command->add_flag("--json", options->json, "Only print the replay as JSON");
  for (CLI::Option* convert : {text, json})
    for (const char* other : {"--verify", "--trace", "--against"})
      convert->excludes(command->get_option(other));
  text->excludes(json);
  // Without the list of what excludes what.
  for (CLI::Option* flag : {verify, text, json}) flag->option_text(" ");
  command->footer(
      "Prints every turn's steps, points and score. Steps count from the start of the game.\n"
      "Exit status: 0 the game went as the replay says; 1 it did not, or a file is wrong or cannot "
      "be\n"
      "read or written; 2 wrong usage.\n\n"
      "Examples:\n"
      "  carom replay tests/replays/billiards-whole.json\n"
      "  carom replay --verify tests/replays/billiards-whole.json\n"
      "  carom replay --text tests/replays/billiards-whole.json | carom replay --verify -");
  command->callback([options, &status] { status = play(*options); });
}

}  // namespace tool
