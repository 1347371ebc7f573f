#include "files/files.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/types.h>
#include <unistd.h>
#include <utility>

namespace files {

namespace {

// NAME.part-PID is what the process PID writes of NAME.
constexpr std::string_view aside_mark = ".part-";

carom::Error trouble(std::string problem) { return {.problem = std::move(problem)}; }

/// Whether a file of this name was written aside by a process that lives no more.
bool is_abandoned(const std::string& name, std::string_view ending) {
  const std::size_t mark = name.rfind(aside_mark);
  if (mark == std::string::npos || !name.substr(0, mark).ends_with(ending)) return false;
  const char* const end = name.data() + name.size();
  ::pid_t process = 0;
  const auto read = std::from_chars(name.data() + mark + aside_mark.size(), end, process);
  if (read.ec != std::errc() || read.ptr != end || process <= 0) return false;
  // Signal 0 only asks.
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

carom::Result<std::string> read(const std::filesystem::path& path) {
  std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
  if (!file)
    return carom::Error{.problem = {carom::MessageCode::cannot_be_opened, {std::strerror(errno)}}};
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  std::size_t count = 0;
  while (bytes.size() <= max_file_size &&
         (count = std::fread(buffer.data(), 1, buffer.size(), file)) > 0)
    bytes.append(buffer.data(), count);
  const bool failed = std::ferror(file);
  const int reason = errno;
  if (file != stdin) std::fclose(file);
  if (failed) return trouble(std::string("cannot be read: ") + std::strerror(reason));
  if (bytes.size() > max_file_size) return trouble("is larger than 2 GiB");
  return bytes;
}

Writer::Writer(std::filesystem::path path) : path_(std::move(path)) {
  if (path_ == "-") {
    file_ = stdout;
    return;
  }
  std::error_code ignored;
  // The file that a link points to is replaced, not the link.
  if (std::filesystem::is_symlink(path_, ignored)) {
    const auto target = std::filesystem::canonical(path_, ignored);
    if (!target.empty()) path_ = target;
  }
  const auto kind = std::filesystem::status(path_, ignored).type();
  if (kind == std::filesystem::file_type::regular ||
      kind == std::filesystem::file_type::not_found) {
    aside_ = path_;
    aside_ += aside_mark;
    aside_ += std::to_string(::getpid());
  }
  const auto& target = aside_.empty() ? path_ : aside_;
  const int descriptor = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    aside_.clear();
    fail("cannot be opened for writing");
    return;
  }
  file_ = ::fdopen(descriptor, "wb");
}

Writer::~Writer() {
  if (file_ && file_ != stdout) std::fclose(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void Writer::write(std::string_view bytes) {
  if (!error_.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("cannot be written");
}

carom::Status Writer::commit() {
  flush();
  if (error_.empty() && !aside_.empty()) {
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
  if (error_.empty() && !aside_.empty() && ::fsync(::fileno(file_)) != 0) fail("cannot be written");
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
