#include "tool/level_link.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "carom/scene_file.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "games/angry_balls.hpp"
#include "replay/level_text.hpp"
#include "replay/replay.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

int convert(const std::string& file, bool back) {
  const auto bytes = files::read_text(file, back ? files::max_small_file : files::max_file_size);
  if (!bytes) return report(bytes.errors(), file);
  std::string_view text = bytes.value();
  while (back && !text.empty() && text.find_last_of(" \t\r\n") == text.size() - 1)
    text.remove_suffix(1);
  const auto level =
      back ? replay::read_level_text(text) : games::angry_balls::read_level(bytes.value());
  if (!level) return report(level.errors(), file);
  const std::string written = carom::write_scene(level.value());
  if (written.size() > replay::max_bytes)
    return report({{.problem = {carom::MessageCode::is_larger_than_bytes,
                                {std::to_string(replay::max_bytes)}}}},
                  file);
  if (back)
    std::fputs(written.c_str(), stdout);
  else
    std::printf("%s\n", replay::write_level_text(level.value()).c_str());
  return done;
}

}  // namespace

void add_level_link(CLI::App& carom, int& status) {
  struct Options {
    std::string file;
    bool json = false;
  };
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      carom.add_subcommand("level-link", "Print a level as the text that a link carries.");
  command->add_option("level", options->file, "Level file; - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("LEVEL");
  command->add_flag("--json", options->json,
                    "The other way: LEVEL is such a text; print the level");
  command->footer(
      "The page opens a level from its address followed by #level= and the text.\n\n"
      "Examples:\n"
      "  carom level-link levels/01-first-steps.json\n"
      "  carom level-link levels/01-first-steps.json | carom level-link --json -");
  command->callback([options, &status] { status = convert(options->file, options->json); });
}

}  // namespace tool
