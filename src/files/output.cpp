#include "files/output.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace files {

namespace {

namespace fs = std::filesystem;

carom::Error trouble(std::string problem) { return {.problem = std::move(problem)}; }

// The new file that a signal which ends the program removes. Written before `unfinished_set`, read
// after it, and only then: a handler may come at any time.
std::array<char, 4096> unfinished_path;
struct ::stat unfinished_status;
std::atomic<bool> unfinished_set = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};

bool same_file(const struct ::stat& a, const struct ::stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Async-signal-safe.
void remove_if_still(const char* path, const struct ::stat& status) {
  struct ::stat now {};
  if (::lstat(path, &now) == 0 && same_file(now, status)) ::unlink(path);
}

void remove_and_end(int signal) {
  if (unfinished_set) remove_if_still(unfinished_path.data(), unfinished_status);
  // The default action was put back when the handler began (SA_RESETHAND).
  ::raise(signal);
}

// One output at a time is guarded; the programs have no more.
bool guard(const std::string& path, const struct ::stat& status) {
  if (unfinished_set || path.size() >= unfinished_path.size()) return false;
  std::copy(path.begin(), path.end(), unfinished_path.begin());
  unfinished_path[path.size()] = '\0';
  unfinished_status = status;
  unfinished_set = true;
  for (const int signal : ending_signals) {
    struct ::sigaction old {};
    // A signal that is ignored (nohup) stays ignored.
    if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_DFL) continue;
    struct ::sigaction action {};
    action.sa_handler = remove_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
  return true;
}

void end_guard() {
  unfinished_set = false;
  for (const int signal : ending_signals) {
    struct ::sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == remove_and_end)
      std::signal(signal, SIG_DFL);
  }
}

// The number that a path of a folder of descriptors ends in.
std::optional<int> number(const std::string& name) {
  int value = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data(), end, value);
  if (name.empty() || read.ec != std::errc() || read.ptr != end || value < 0) return std::nullopt;
  return value;
}

int duplicate(int descriptor) {
#ifdef __EMSCRIPTEN__
  // Emscripten opens the path anew, and a stream of Node's has none. The program uses it no more.
  return descriptor;
#else
  return ::fcntl(descriptor, F_DUPFD_CLOEXEC, 3);
#endif
}

bool find_status(int descriptor, struct ::stat& status) {
  const bool found = ::fstat(descriptor, &status) == 0;
#ifdef __EMSCRIPTEN__
  if (descriptor <= STDERR_FILENO) return true;  // nothing is known of Node's own streams
#endif
  return found;
}

}  // namespace

std::optional<int> own_descriptor(const fs::path& path) {
  if (path == "-") return STDOUT_FILENO;
  constexpr int most_links = 40;  // as Linux
  fs::path at = path;
  for (int links = 0; links < most_links; ++links) {
    std::error_code error;
    const fs::path folder = fs::canonical(at.has_parent_path() ? at.parent_path() : ".", error);
    if (error) return std::nullopt;
    for (const char* const own : {"/proc/self/fd", "/proc/thread-self/fd"})
      if (folder == fs::canonical(own, error) && !error) return number(at.filename());
    const fs::path target = fs::read_symlink(folder / at.filename(), error);
    if (error) return std::nullopt;
    at = target.is_absolute() ? target : folder / target;
  }
  return std::nullopt;
}

Output::Output(const std::string& path, std::span<const std::string> inputs) {
  open(path);
  if (error_.empty()) refuse_inputs(inputs);
}

void Output::open(const std::string& path) {
  int descriptor = -1;
  if (const auto own = own_descriptor(path)) {
    standard_output_ = *own == STDOUT_FILENO;
    const int flags = ::fcntl(*own, F_GETFL);
    if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY)
      errno = EBADF;
    else
      descriptor = duplicate(*own);
  } else {
    opened_by_path_ = true;
    constexpr int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY;
    descriptor = ::open(path.c_str(), flags | O_CREAT | O_EXCL, 0666);
    if (descriptor >= 0) {
      created_ = path;
      begun_ = true;  // there is nothing to truncate
    } else if (errno == EEXIST) {
      // O_CREAT for a link to what is not there yet.
      descriptor = ::open(path.c_str(), flags | O_CREAT, 0666);
    }
  }
  if (descriptor < 0) return fail("cannot be opened for writing");
  if (!find_status(descriptor, status_) || !(file_ = ::fdopen(descriptor, "wb"))) {
    fail("cannot be opened for writing");
    ::close(descriptor);
    return;
  }
  if (!created_.empty()) guarded_ = guard(created_, status_);
  struct ::stat out {};
  standard_output_ =
      standard_output_ || ((S_ISREG(status_.st_mode) || S_ISFIFO(status_.st_mode)) &&
                           ::fstat(STDOUT_FILENO, &out) == 0 && same_file(out, status_));
}

void Output::refuse_inputs(std::span<const std::string> inputs) {
  if (!S_ISREG(status_.st_mode)) return;
  for (const std::string& input : inputs) {
    struct ::stat status {};
    const int found =
        input == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(input.c_str(), &status);
    if (found == 0 && same_file(status, status_)) {
      error_ = "is read from as well: it would be lost";
      return;
    }
  }
}

Output::~Output() {
  if (file_) std::fclose(file_);
  if (created_.empty()) return;
  remove_if_still(created_.c_str(), status_);
  if (guarded_) end_guard();
}

carom::Status Output::opened() const {
  if (!error_.empty()) return trouble(error_);
  return carom::Done{};
}

std::optional<std::uintmax_t> Output::replaced_size() const {
  if (!opened_by_path_ || !created_.empty() || !error_.empty() || !S_ISREG(status_.st_mode))
    return std::nullopt;
  return static_cast<std::uintmax_t>(status_.st_size);
}

void Output::begin() {
  if (std::exchange(begun_, true) || !opened_by_path_ || !S_ISREG(status_.st_mode)) return;
  if (::ftruncate(::fileno(file_), 0) != 0) fail("cannot be written");
}

void Output::write(std::string_view bytes) {
  if (!error_.empty()) return;
  begin();
  if (error_.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    fail("cannot be written");
}

carom::Status Output::commit() {
  if (error_.empty()) begin();
  if (error_.empty() && std::fflush(file_) != 0) fail("cannot be written");
  if (file_ && std::fclose(std::exchange(file_, nullptr)) != 0 && error_.empty())
    fail("cannot be written");
  if (!error_.empty()) return trouble(error_);
  created_.clear();
  if (std::exchange(guarded_, false)) end_guard();
  return carom::Done{};
}

void Output::fail(const char* what) { error_ = std::string(what) + ": " + std::strerror(errno); }

// Opened the wrong way round, so that using one that was closed fails.
void reserve_standard_descriptors() {
#ifndef __EMSCRIPTEN__
  for (int descriptor = 0; descriptor <= 2; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 &&
        ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor)
      std::_Exit(1);
#endif
}

carom::Status finish_standard_output() {
  errno = 0;
  std::cout.flush();
  const bool failed_before = std::ferror(stdout) != 0 || !std::cout;
  if (std::fflush(stdout) == 0 && !failed_before) return carom::Done{};
  return trouble(std::string("cannot be written") +
                 (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()));
}

}  // namespace files
