#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom generate` to the command line; its exit status comes back in `status`.
void add_generate(CLI::App& carom, int& status);

}  // namespace tool
