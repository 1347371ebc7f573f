#pragma once

#include <fstream>
#include <iterator>
#include <string>

/// The bytes of a file of this repository, by its path in it; empty if there is none.
inline std::string project_file(const std::string& path) {
  std::ifstream file(SOURCE_DIR "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// One of the replays that must verify for ever, by its name.
inline std::string replay_file(const std::string& name) {
  return project_file("tests/replays/" + name);
}
