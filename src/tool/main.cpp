#include <CLI/CLI.hpp>
#include <cstdio>

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
  CLI::App carom{"A deterministic 2D ball-physics engine on the command line.", "carom"};
  cli::show_failures(carom);
  carom.require_subcommand(0, 1);
  carom.footer(
      "Examples:\n"
      "  carom simulate scenes/break.json\n"
      "  carom check levels/*.json\n"
      "  carom simulate --help");
  bool licences = false;
  carom.add_flag("--licences", licences, "Print the licences of this program and of its parts");
  int status = tool::done;
  tool::add_simulate(carom, status);
  tool::add_check(carom, status);
  tool::add_replay(carom, status);
  tool::add_shots(carom, status);
  tool::add_soak(carom, status);
  tool::add_level_link(carom, status);
  tool::add_quadtree(carom, status);
  try {
    carom.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return carom.exit(error) == 0 ? tool::done : tool::wrong_usage;
  }
  if (licences) {
    std::fwrite(licences::text.data(), 1, licences::text.size(), stdout);
    return std::fflush(stdout) == 0 && !std::ferror(stdout) ? tool::done : tool::wrong_input;
  }
  if (carom.get_subcommands().empty()) {
    std::fputs(carom.help().c_str(), stderr);
    return tool::wrong_usage;
  }
  return status;
}
