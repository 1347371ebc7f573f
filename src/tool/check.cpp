#include "tool/check.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene_file.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "games/angry_balls.hpp"
#include "games/level_check.hpp"
#include "tool/busy.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

int check(const std::string& path) {
  std::optional<Busy> busy("reading " + shown_name(path));
  const auto bytes = files::read_text(path);
  if (!bytes) {
    busy.reset();
    return report(bytes.errors(), path);
  }
  const auto level = games::angry_balls::read_level(bytes.value());
  busy.reset();
  if (!level) return report(level.errors(), path);
  busy.emplace("trying " + shown_name(path));
  games::angry_balls::LevelReport tried =
      games::angry_balls::level_report(level.value(), games::angry_balls::level_check_budget,
                                       [&busy](double part) { busy->set_part(part); });
  busy.reset();
  for (carom::Error& warning : carom::locate(bytes.value(), std::move(tried.warnings))) {
    warning.problem = {carom::MessageCode::warning, {carom::to_string(warning.problem)}};
    std::fprintf(stderr, "%s\n", carom::to_string(warning, shown_name(path)).c_str());
  }
  std::printf("%s: ok\n", shown_name(path).c_str());
  return done;
}

}  // namespace

void add_check(CLI::App& carom, int& status) {
  const auto levels = std::make_shared<std::vector<std::string>>();
  CLI::App* command = carom.add_subcommand("check", "Say what is wrong with a level.");
  command->add_option("level", *levels, "Level files (JSON); - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("LEVEL...");
  command->footer(
      "Says \"ok\", or every error with line, column, pointer and what was expected. Warns of "
      "what\n"
      "a player would hold against a sound level: balls that do not stay where they were put or\n"
      "never come to rest, enemies that no throw can harm, lengths in metres. Large levels are "
      "not\n"
      "tried in full, and it says so.\n"
      "Exit status: 0 all levels are sound, warnings or not; 1 some are not, or cannot be read; 2\n"
      "wrong usage.\n\n"
      "Examples:\n"
      "  carom check levels/01-first-steps.json\n"
      "  carom check levels/*.json");
  command->callback([levels, &status] {
    for (const std::string& level : *levels)
      if (check(level) != done) status = wrong_input;
  });
}

}  // namespace tool
