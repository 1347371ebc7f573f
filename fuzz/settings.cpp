#include "app/storage/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

#include "require.hpp"

// Accepted settings are saved and read back as they were; others are set aside with all their
// bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string file = app::settings_file;
  app::MemoryStore store;
  fuzz::require(store.save(file, bytes).ok(), "memory takes everything");
  app::KeptSettings kept(store);
  const bool refused = kept.trouble() == app::KeptSettings::Trouble::set_aside;
  fuzz::require(refused != store.load(file).value().has_value(), "what is refused is moved away");
  if (refused) {
    fuzz::require(store.load(file + ".broken").value() == bytes, "not a byte of it is lost");
    fuzz::require(kept.get() == app::Settings{}, "nothing is taken of it");
  }
  const app::Settings before = kept.get();
  kept.set(before);
  fuzz::require(kept.get() == before, "what was read is fit");
  fuzz::require(app::KeptSettings(store).get() == before, "it is read back");
  app::Settings named;
  named.names = {bytes, bytes.substr(size / 2)};
  kept.set(named);
  fuzz::require(app::KeptSettings(store).get() == kept.get(), "any text becomes a name");
  return 0;
}
