#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "carom/result.hpp"

/// Reading and writing whole files, for the programs at the edge. Errors leave naming the file to
/// them.
namespace files {

inline constexpr std::size_t max_file_size = std::size_t{2} << 30;    ///< bytes
inline constexpr std::size_t max_small_file = std::size_t{16} << 20;  ///< bytes

/// The bytes of a file; "-" is standard input. Refuses what cannot be read and what is larger than
/// `most` bytes, a file before it is read.
carom::Result<std::string> read(const std::filesystem::path& path,
                                std::size_t most = max_file_size);

/// The same of a text. Ends early at a zero byte, which no text has and every reader refuses, so
/// that nobody waits for the rest of /dev/zero.
carom::Result<std::string> read_text(const std::filesystem::path& path,
                                     std::size_t most = max_file_size);

/// A file of the game's own folder, written so that its name never stands for half of it: the bytes
/// go aside and take the name in commit(), after an fsync, with the permissions of the old file.
/// Without commit() nothing has changed. Refuses anything but a file. What the player names is
/// written by Output instead.
class Writer {
 public:
  explicit Writer(std::filesystem::path path);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// After an error the rest does nothing; commit() tells.
  void write(std::string_view bytes);
  carom::Status commit();
  /// The same, but never in the place of another file: false when the name is taken.
  carom::Result<bool> commit_new();

 private:
  void fail(const char* what);
  void flush();

  std::filesystem::path path_;
  std::filesystem::path aside_;  ///< empty when it could not be made, and once it has the name
  std::FILE* file_ = nullptr;
  std::string error_;
};

/// A whole file by way of Writer.
carom::Status write(const std::filesystem::path& path, std::string_view bytes);
/// The same by Writer::commit_new().
carom::Result<bool> write_new(const std::filesystem::path& path, std::string_view bytes);

/// Removes from `folder` what a Writer whose process was killed has left aside of files whose names
/// end in `ending`. What a living process writes stays; so does everything else.
void remove_abandoned(const std::filesystem::path& folder, std::string_view ending);

}  // namespace files
