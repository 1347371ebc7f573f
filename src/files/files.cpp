#include "files/files.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <random>
#include <string>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#include <utility>

namespace files {

namespace {

// NAME.part-PID-RANDOM is what the process PID writes of NAME.
const std::string aside_mark = ".part-";

carom::Error trouble(std::string problem) { return {.problem = std::move(problem)}; }

/// Is true if a file of this name was written aside by a process that lives no more.
bool is_abandoned(const std::string& name, std::string_view ending) {
  const std::size_t mark = name.rfind(aside_mark);
  if (mark == std::string::npos || !name.substr(0, mark).ends_with(ending)) return false;
  const char* const end = name.data() + name.size();
  ::pid_t process = 0;
  const auto read = std::from_chars(name.data() + mark + aside_mark.size(), end, process);
  if (read.ec != std::errc() || process <= 0) return false;
  // Older versions wrote no more than this.
  const std::string_view random(read.ptr, static_cast<std::size_t>(end - read.ptr));
  if (!random.empty() &&
      (random.size() != 9 || random.front() != '-' ||
       random.find_first_not_of("0123456789abcdef", 1) != std::string_view::npos))
    return false;
  // Signal 0 only asks.
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

carom::Result<std::string> read_until(const std::filesystem::path& path, std::size_t most,
                                      bool stop_at_zero) {
  std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
  if (!file)
    return carom::Error{.problem = {carom::MessageCode::cannot_be_opened, {std::strerror(errno)}}};
  struct ::stat status {};
  const bool known_size = ::fstat(::fileno(file), &status) == 0 && S_ISREG(status.st_mode);
  bool too_large = known_size && static_cast<std::uintmax_t>(status.st_size) > most;
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  std::size_t count = 0;
  while (!too_large && (count = std::fread(buffer.data(), 1, buffer.size(), file)) > 0) {
    bytes.append(buffer.data(), count);
    too_large = bytes.size() > most;
    if (stop_at_zero && std::memchr(buffer.data(), 0, count)) break;
  }
  const bool failed = std::ferror(file);
  const int reason = errno;
  if (file != stdin) std::fclose(file);
  if (failed) return trouble(std::string("cannot be read: ") + std::strerror(reason));
  if (too_large) return trouble("is larger than " + std::to_string(most >> 20) + " MiB");
  return bytes;
}

}  // namespace

carom::Result<std::string> read(const std::filesystem::path& path, std::size_t most) {
  return read_until(path, most, false);
}

carom::Result<std::string> read_text(const std::filesystem::path& path, std::size_t most) {
  return read_until(path, most, true);
}

Writer::Writer(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code ignored;
  // The file that a link points to is replaced, not the link.
  if (std::filesystem::is_symlink(path_, ignored)) {
    const auto target = std::filesystem::canonical(path_, ignored);
    if (!target.empty()) path_ = target;
  }
  struct ::stat old {};
  const bool replaces = ::stat(path_.c_str(), &old) == 0;
  if (replaces && !S_ISREG(old.st_mode)) {
    error_ = "is no file";
    return;
  }
  // A name that nobody can have planted something under.
  std::random_device random;
  int descriptor = -1;
  do {
    std::array<char, 9> digits;
    std::snprintf(digits.data(), digits.size(), "%08x", random());
    aside_ = path_;
    aside_ += aside_mark + std::to_string(::getpid()) + "-" + digits.data();
    descriptor = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) {
    aside_.clear();
    fail("cannot be opened for writing");
    return;
  }
  // A failure here does not make the file less the user's.
  if (replaces && ::fchown(descriptor, old.st_uid, old.st_gid) == 0) errno = 0;
  if (replaces) ::fchmod(descriptor, old.st_mode & 07777);
  file_ = ::fdopen(descriptor, "wb");
}

Writer::~Writer() {
  if (file_) std::fclose(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void Writer::write(std::string_view bytes) {
  if (!error_.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("cannot be written");
}

carom::Status Writer::commit() {
  flush();
  if (error_.empty()) {
    if (std::rename(aside_.c_str(), path_.c_str()) != 0)
      fail("cannot be put in its place");
    else
      aside_.clear();
  }
  if (!error_.empty()) return trouble(error_);
  return carom::Done{};
}

// A link, other than a new name, fails where the name is taken. The destructor removes the old one.
carom::Result<bool> Writer::commit_new() {
  flush();
  if (error_.empty() && ::link(aside_.c_str(), path_.c_str()) != 0) {
    if (errno == EEXIST) return false;
    fail("cannot be put in its place");
  }
  if (!error_.empty()) return trouble(error_);
  return true;
}

void Writer::flush() {
  if (error_.empty() && std::fflush(file_) != 0) fail("cannot be written");
  if (error_.empty() && ::fsync(::fileno(file_)) != 0) fail("cannot be written");
}

void Writer::fail(const char* what) { error_ = std::string(what) + ": " + std::strerror(errno); }

carom::Status write(const std::filesystem::path& path, std::string_view bytes) {
  Writer writer(path);
  writer.write(bytes);
  return writer.commit();
}

carom::Result<bool> write_new(const std::filesystem::path& path, std::string_view bytes) {
  Writer writer(path);
  writer.write(bytes);
  return writer.commit_new();
}

void remove_abandoned(const std::filesystem::path& folder, std::string_view ending) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (is_abandoned(entry->path().filename(), ending) && entry->is_regular_file(ignored))
      std::filesystem::remove(entry->path(), ignored);
  }
}

}  // namespace files
