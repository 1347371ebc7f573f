#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom prove` and `carom verify` to the command line; the exit status of the one that ran
/// comes back in `status`.
void add_prove(CLI::App& carom, int& status);

}  // namespace tool
