#include "app/store.hpp"

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

carom::Status MemoryStore::set_aside(const std::string& name) {
  auto node = texts_.extract(name);
  if (node.empty()) return carom::Done{};
  node.key() += ".broken";
  texts_.insert(std::move(node));
  return carom::Done{};
}

}  // namespace app
