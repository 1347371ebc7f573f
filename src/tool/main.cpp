#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "carom/version.hpp"
#include "cli/options.hpp"
#include "licences/licences.hpp"
#include "tool/check.hpp"
#include "tool/exit_status.hpp"
#include "tool/level_link.hpp"
#include "tool/quadtree.hpp"
#include "tool/replay.hpp"
#include "tool/shots.hpp"
#include "tool/simulate.hpp"
#include "tool/soak.hpp"

int main(int argc, char** argv) {
  CLI::App app{"A deterministic 2D ball-physics engine on the command line.", "carom"};
  cli::show_failures(app);
  app.require_subcommand(0, 1);
  app.set_version_flag(
      "--version", std::string("carom " CAROM_VERSION " (") + carom::vector_instructions() + ")",
      "Print the version and the vector instructions used here, and exit");
  app.footer(
      "Examples:\n"
      "  carom simulate scenes/break.json\n"
      "  carom check levels/*.json\n"
      "  carom simulate --help");
  bool licences = false;
  app.add_flag("--licences", licences, "Print the licences of this program and of its parts");
  int status = tool::done;
  tool::add_simulate(app, status);
  tool::add_check(app, status);
  tool::add_replay(app, status);
  tool::add_shots(app, status);
  tool::add_soak(app, status);
  tool::add_level_link(app, status);
  tool::add_quadtree(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? tool::done : tool::wrong_usage;
  }
  if (licences) {
    std::fwrite(licences::text.data(), 1, licences::text.size(), stdout);
    return std::fflush(stdout) == 0 && !std::ferror(stdout) ? tool::done : tool::wrong_input;
  }
  if (app.get_subcommands().empty()) {
    std::fputs(app.help().c_str(), stderr);
    return tool::wrong_usage;
  }
  return status;
}
