#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "carom/version.hpp"
#include "cli/help_format.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "files/output.hpp"
#include "licences/licences.hpp"
#include "platform/data_folder.hpp"
#include "platform/level_files.hpp"
#include "platform/null_platform.hpp"
#include "platform/png.hpp"
#include "platform/sdl_platform.hpp"
#include "replay/replay_file.hpp"

namespace {

// Exit statuses.
constexpr int done = 0;
constexpr int bad_input = 2;
constexpr int cannot_write = 3;
constexpr int no_display = 4;

constexpr std::uint64_t least_side = 64;
constexpr std::uint64_t greatest_side = 8192;

constexpr const char* examples = R"(Examples:
  angry-balls                       play in a window (F11: full screen)
  angry-balls --size 1920x1080 --lang fr
  angry-balls my-level.json my-levels/
  angry-balls --replay tests/replays/level-09-won.json
  angry-balls --script demos/billiards.jsonl --screenshot end.png
  echo '{"at": 1, "click": [100, 420]}' | angry-balls --script -

A script is JSON Lines, one action a line in the order of time ("at", in seconds), points in
window pixels:
  {"at": 0.5, "click": [400, 300]}            also "button": "right"
  {"at": 1, "move": [10, 20]}
  {"at": 1, "press": [10, 20]}                and "release": the button is held in between
  {"at": 1, "wheel": -2}                      notches
  {"at": 1.5, "key": "Escape"}                also "Shift+Left", "Ctrl+Up"
  {"at": 1.5, "hold": "Space"}                and "let_go"
  {"at": 1.5, "type": "47.3"}
  {"at": 1.5, "touch": [400, 300]}            and "touch_move", "touch_end"; "finger": 1
  {"at": 1.5, "pad": "A"}                     a gamepad's button; also "pad_hold", "pad_let_go"
  {"at": 1.5, "stick": ["left_x", 0.5]}       and there it stays
  {"at": 2, "screenshot": "shot.png"}
  {"at": 3, "print": true}                    says what is on screen
It plays without a display, as fast as it can, the same every time, with no scores, games and levels
of yours but those named; then one line tells what is on screen.

Best scores, the game in progress and replays are kept in $XDG_DATA_HOME/angry-balls, levels of your
own are found in $XDG_DATA_HOME/angry-balls/levels (XDG_DATA_HOME is ~/.local/share unless set).
Settings are kept in $XDG_CONFIG_HOME/angry-balls (XDG_CONFIG_HOME is ~/.config unless set).

Exit status: 0 done, 2 bad command line, script or replay, 3 a file cannot be written, 4 no display.)";

struct Options {
  std::string script;
  std::string screenshot;
  std::pair<int, int> size{1280, 720};
  std::string language;
  std::string replay;
  std::string data;
  std::vector<std::filesystem::path> levels;
};

/// The language the environment asks for (POSIX: the first of these that is set and not empty).
std::string environment_locale() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* value = std::getenv(name); value && *value) return value;
  return {};
}

/// "1280x720" → 1280, 720; refuses anything else.
std::pair<int, int> parse_size(const std::string& text) {
  const std::size_t x = std::min(text.find('x'), text.size());
  const auto width = cli::read_whole(std::string_view(text).substr(0, x));
  const auto height = cli::read_whole(std::string_view(text).substr(std::min(x + 1, text.size())));
  const auto sound = [](const std::optional<std::uint64_t>& side) {
    return side && *side >= least_side && *side <= greatest_side;
  };
  if (!sound(width) || !sound(height))
    cli::refuse("--size", text, "WIDTHxHEIGHT, each from 64 to 8192 (px), such as 1280x720");
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

int report(const carom::Errors& errors, std::string_view file, int status) {
  for (const carom::Error& error : errors)
    std::cerr << "angry-balls: " << carom::to_string(error, file) << '\n';
  return status;
}

int play_script(const Options& options, app::StartLanguage language,
                std::optional<replay::Replay> replay) {
  const std::string name = options.script == "-" ? "<stdin>" : options.script;
  const auto text = files::read_text(options.script, files::max_small_file);
  if (!text) return report(text.errors(), name, bad_input);
  const auto script = platform::parse_script(text.value());
  if (!script) return report(script.errors(), name, bad_input);

  app::MemoryStore forgetful;
  std::optional<platform::FolderStore> folder;
  if (!options.data.empty()) folder.emplace(options.data);
  app::Store& store = folder ? static_cast<app::Store&>(*folder) : forgetful;
  platform::NullPlatform game(language, options.size.first, options.size.second,
                              platform::read_levels(options.levels), store);
  if (folder) game.app().teach_beginners();
  if (replay) game.app().watch(std::move(*replay));
  // An output that cannot be written is reported before the play.
  std::optional<platform::PngFile> picture;
  if (!options.screenshot.empty()) {
    picture.emplace(options.screenshot);
    if (const auto status = picture->opened(); !status)
      return report(status.errors(), {}, cannot_write);
  }
  // Every line at once: who reads it may be waiting for it.
  const auto print = [](const std::string& line) { std::cout << line << std::endl; };
  if (const auto status = game.run(script.value(), print); !status)
    return report(status.errors(), {}, cannot_write);
  if (picture)
    if (const auto status = picture->write(game.picture()); !status)
      return report(status.errors(), {}, cannot_write);
  std::cout << game.app().describe() << '\n';
  return done;
}

int play_in_window(const Options& options, app::StartLanguage language,
                   std::optional<replay::Replay> replay) {
  app::MemoryStore forgetful;
  std::optional<platform::FolderStore> folder_store;
  std::vector<std::filesystem::path> levels = options.levels;
  const auto folder = options.data.empty() ? platform::data_folder()
                                           : std::optional(std::filesystem::path(options.data));
  if (folder) {
    // Whoever names a folder wants everything there.
    const auto config = options.data.empty() ? platform::config_folder() : std::nullopt;
    folder_store.emplace(*folder, config.value_or(*folder));
    std::error_code ignored;
    if (std::filesystem::exists(*folder / "levels", ignored))
      levels.insert(levels.begin(), *folder / "levels");
  }
  app::Store& store = folder_store ? static_cast<app::Store&>(*folder_store) : forgetful;
  const auto window = platform::open_window({.language = language,
                                             .width = options.size.first,
                                             .height = options.size.second,
                                             .store = store,
                                             .levels = platform::read_levels(levels),
                                             .host = {.licences = licences::text}});
  if (!window) {
    std::cerr << "angry-balls: no display: " << carom::to_string(window.errors().front().problem)
              << " (a script plays without one: --script FILE)\n";
    return no_display;
  }
  platform::GameWindow& game = *window.value();
  if (replay) game.app().watch(std::move(*replay));
  // A level that is being made is shown as its file is now.
  using std::chrono::steady_clock;
  constexpr std::chrono::milliseconds between_looks{500};
  platform::LevelWatch watch(levels);
  steady_clock::time_point looked = steady_clock::now();
  while (game.iterate()) {
    if (const auto now = steady_clock::now(); now - looked >= between_looks) {
      looked = now;
      if (watch.changed()) game.app().take_levels(platform::read_levels(levels));
    }
    game.wait();
  }
  return done;
}

/// The program but for what concerns its output as a whole.
int run(int argc, char** argv) {
  Options options;
  CLI::App program("Angry Balls: billiards for two, and levels to break to pieces.", "angry-balls");
  cli::show_failures(program);
  program.formatter(std::make_shared<cli::HelpFormat>());
  program
      .add_option("LEVELS", options.levels,
                  "Levels of your own: files, and folders of *.json and *.angry-level files; or "
                  "one replay to show: *.angry-replay")
      ->check(cli::file_name())
      ->type_name("");
  program.footer(examples);
  program.set_version_flag("--version", "angry-balls " CAROM_VERSION);
  bool licences = false;
  program.add_flag("--licences", licences, "Print the licences of this program and of its parts");
  auto* script =
      program
          .add_option("--script", options.script,
                      "Play the inputs in FILE (\"-\": standard input), without a display")
          ->check(cli::file_name())
          ->type_name("FILE");
  program
      .add_option("--screenshot", options.screenshot,
                  "Write the script's last picture to FILE (PNG)")
      ->check(cli::file_name())
      ->type_name("FILE")
      ->needs(script);
  program.add_option("--replay", options.replay, "Show the replay in FILE (\"-\": standard input)")
      ->check(cli::file_name())
      ->type_name("FILE");
  program
      .add_option(
          "--data", options.data,
          "Keep settings, scores, games and replays in FOLDER (a script: nowhere unless given)")
      ->check(cli::file_name())
      ->type_name("FOLDER");
  program
      .add_option_function<std::string>(
          "--size", [&](const std::string& text) { options.size = parse_size(text); },
          "Size of the window, px (default 1280x720)")
      ->type_name("WxH");
  const std::vector<std::string> languages(app::language_codes.begin(), app::language_codes.end());
  program
      .add_option("--lang", options.language,
                  "Language (default: the settings', the environment's)")
      ->check(CLI::IsMember(languages))
      ->type_name(CLI::detail::join(languages, "|"));
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? done : bad_input;
  }
  // The argument of a double click.
  if (options.levels.size() == 1 && options.levels[0].extension() == ".angry-replay") {
    options.replay = options.levels[0].string();
    options.levels.clear();
  }
  if (licences) return (std::cout << licences::text).flush() ? done : cannot_write;

  const bool asked = !options.language.empty();
  const app::StartLanguage language(
      app::language_of_locale(asked ? options.language : environment_locale()), asked);
  std::optional<replay::Replay> replay;
  if (!options.replay.empty()) {
    const auto bytes = files::read_text(options.replay, files::max_small_file);
    if (!bytes) return report(bytes.errors(), options.replay, bad_input);
    auto read = replay::read_replay(bytes.value());
    if (!read) return report(read.errors(), options.replay, bad_input);
    replay = std::move(read).value();
  }
  if (!options.script.empty()) return play_script(options, language, std::move(replay));
  return play_in_window(options, language, std::move(replay));
}

}  // namespace

int main(int argc, char** argv) {
  files::reserve_standard_descriptors();
  int status = done;
  try {
    status = run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "angry-balls: there is not enough memory for this\n";
    status = bad_input;
  }
  if (const auto written = files::finish_standard_output(); !written && status == done)
    return report(written.errors(), "<standard output>", cannot_write);
  return status;
}
