#include "files/files.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace files {

namespace {

carom::Error trouble(std::string problem) { return {.problem = std::move(problem)}; }

}  // namespace

carom::Result<std::string> read(const std::filesystem::path& path) {
  std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
  if (!file) return trouble(std::string("cannot be opened: ") + std::strerror(errno));
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
  if (bytes.size() > max_file_size) return trouble("is larger than 4 GiB");
  return bytes;
}

Writer::Writer(std::filesystem::path path) : path_(std::move(path)) {
  if (path_ == "-") {
    file_ = stdout;
    return;
  }
  std::error_code ignored;
  // What a link points to is replaced, not the link.
  if (std::filesystem::is_symlink(path_, ignored)) {
    const auto target = std::filesystem::canonical(path_, ignored);
    if (!target.empty()) path_ = target;
  }
  const auto kind = std::filesystem::status(path_, ignored).type();
  if (kind == std::filesystem::file_type::regular ||
      kind == std::filesystem::file_type::not_found) {
    aside_ = path_;
    aside_ += ".part-" + std::to_string(::getpid());
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
  if (error_.empty() && std::fflush(file_) != 0) fail("cannot be written");
  if (error_.empty() && !aside_.empty()) {
    if (::fsync(::fileno(file_)) != 0)
      fail("cannot be written");
    else if (std::rename(aside_.c_str(), path_.c_str()) != 0)
      fail("cannot be put in its place");
    else
      aside_.clear();
  }
  if (!error_.empty()) return trouble(error_);
  return carom::Done{};
}

void Writer::fail(const char* what) { error_ = std::string(what) + ": " + std::strerror(errno); }

carom::Status write(const std::filesystem::path& path, std::string_view bytes) {
  Writer writer(path);
  writer.write(bytes);
  return writer.commit();
}

}  // namespace files
