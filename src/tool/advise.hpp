#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom advise` to the command line; its exit status comes back in `status`.
void add_advise(CLI::App& carom, int& status);

}  // namespace tool
