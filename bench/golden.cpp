#include "golden.hpp"

#include <fstream>

#include "carom/trace.hpp"

namespace bench {

Golden::Golden(std::filesystem::path file, bool update) : file_(std::move(file)), update_(update) {
  std::ifstream in(file_);
  std::string workload;
  std::string hash;
  while (in >> workload >> hash) hashes_[workload] = hash;
}

std::optional<std::string> Golden::objection(const std::string& workload, std::uint64_t hash) {
  const std::string text = carom::hash_text(hash);
  const auto found = hashes_.find(workload);
  if (found == hashes_.end()) {
    if (!update_)
      return "hash " + text + ", but " + file_.string() + " has none: --update-golden adds it";
    hashes_[workload] = text;
  } else if (found->second != text) {
    return "hash " + text + ", but " + file_.string() + " says " + found->second;
  }
  return std::nullopt;
}

bool Golden::save() const {
  if (!update_) return true;
  std::ofstream out(file_);
  for (const auto& [workload, hash] : hashes_) out << workload << ' ' << hash << '\n';
  out.close();
  return out.good();
}

}  // namespace bench
