#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/storage/store.hpp"
#include "games/billiards.hpp"

namespace app {

/// The fewest shots in which tables were cleared alone, a list for each kind of table, saved in a
/// Store.
class AloneBest {
 public:
  static constexpr std::size_t most = 5;  ///< of a list

  /// The store must outlive this.
  explicit AloneBest(Store& store) : store_(store) { load(); }

  /// The fewest first.
  const std::vector<int>& of(const games::billiards::Options& options);
  /// Takes over and saves. Returns the place in the list, from 1; 0 if it is not among the best.
  std::size_t record(const games::billiards::Options& options, int shots);

 private:
  using Lists = std::map<std::string, std::vector<int>>;
  bool load();

  Store& store_;
  Lists lists_;
};

}  // namespace app
