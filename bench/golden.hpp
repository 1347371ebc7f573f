#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace bench {

/// The state hashes that our engine must reach: speed never comes from wrong answers. A text file,
/// a workload's name and its hash a line.
class Golden {
 public:
  /// `update`: hashes that the file does not have are added to it; those it has stay.
  Golden(std::filesystem::path file, bool update);

  /// Returns the fault of a workload's hash, if there is one.
  std::optional<std::string> objection(const std::string& workload, std::uint64_t hash);

  /// Writes what was added. False: could not.
  bool save() const;

 private:
  std::filesystem::path file_;
  bool update_;
  std::map<std::string, std::string> hashes_;
};

}  // namespace bench
