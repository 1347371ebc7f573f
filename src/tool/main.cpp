#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <new>
#include <string>

#include "carom/version.hpp"
#include "cli/help_format.hpp"
#include "cli/options.hpp"
#include "files/output.hpp"
#include "licences/licences.hpp"
#include "tool/advise.hpp"
#include "tool/check.hpp"
#include "tool/exit_status.hpp"
#include "tool/generate.hpp"
#include "tool/level_link.hpp"
#include "tool/prove.hpp"
#include "tool/quadtree.hpp"
#include "tool/replay.hpp"
#include "tool/scene_input.hpp"
#include "tool/shots.hpp"
#include "tool/simulate.hpp"
#include "tool/soak.hpp"
#include "tool/strength.hpp"

int main(int argc, char** argv) {
  files::reserve_standard_descriptors();
  CLI::App program{"A deterministic 2D ball-physics engine on the command line.", "carom"};
  cli::show_failures(program);
  program.formatter(std::make_shared<cli::HelpFormat>());
  program.require_subcommand(0, 1);
  program.set_version_flag(
      "--version", std::string("carom " CAROM_VERSION " (") + carom::vector_instructions() + ")",
      "Print the version and the vector instructions used here, and exit");
  program.footer(
      "Examples:\n"
      "  carom simulate scenes/break.json\n"
      "  carom check levels/*.json\n"
      "  carom simulate --help");
  bool licences = false;
  program.add_flag("--licences", licences, "Print the licences of this program and of its parts");
  int status = tool::done;
  tool::add_simulate(program, status);
  tool::add_check(program, status);
  tool::add_prove(program, status);
  tool::add_generate(program, status);
  tool::add_replay(program, status);
  tool::add_shots(program, status);
  tool::add_advise(program, status);
  tool::add_strength(program, status);
  tool::add_soak(program, status);
  tool::add_level_link(program, status);
  tool::add_quadtree(program, status);
  try {
    program.parse(argc, argv);
    if (licences) {
      std::fwrite(licences::text.data(), 1, licences::text.size(), stdout);
    } else if (program.get_subcommands().empty()) {
      std::fputs(program.help().c_str(), stderr);
      status = tool::wrong_usage;
    }
  } catch (const CLI::ParseError& error) {
    status = program.exit(error) == 0 ? tool::done : tool::wrong_usage;
  } catch (const std::bad_alloc&) {
    std::fputs("carom: there is not enough memory for this\n", stderr);
    status = tool::wrong_input;
  }
  if (const carom::Status written = files::finish_standard_output();
      !written && status == tool::done)
    status = tool::report_output(written.errors(), "-");
  return status;
}
