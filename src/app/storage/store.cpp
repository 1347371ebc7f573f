#include "app/storage/store.hpp"

namespace app {

carom::Result<std::optional<std::string>> MemoryStore::load(const std::string& name) {
  const auto found = texts_.find(name);
  if (found == texts_.end()) return std::optional<std::string>();
  return std::optional(found->second);
}

carom::Status MemoryStore::save(const std::string& name, const std::string& text) {
  texts_[name] = text;
  return carom::Done{};
}

carom::Result<bool> MemoryStore::save_new(const std::string& name, const std::string& text) {
  return texts_.try_emplace(name, text).second;
}

carom::Status MemoryStore::remove(const std::string& name) {
  texts_.erase(name);
  return carom::Done{};
}

carom::Status MemoryStore::set_aside(const std::string& name) {
  auto node = texts_.extract(name);
  if (node.empty()) return carom::Done{};
  node.key() += ".broken";
  texts_.insert(std::move(node));
  return carom::Done{};
}

std::vector<std::string> MemoryStore::list(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& [name, text] : texts_)
    if (name.starts_with(folder) && is_listed(name)) names.push_back(name);
  return names;
}

}  // namespace app
