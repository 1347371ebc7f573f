#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom shots` to the command line; its exit status comes back in `status`.
void add_shots(CLI::App& carom, int& status);

}  // namespace tool
