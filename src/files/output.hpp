#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/stat.h>

#include "carom/result.hpp"

namespace files {

/// A file that the user named for output. It is written in place, so devices, pipes, links and
/// existing files stay what they are, with their owner and permissions. "-" is standard output;
/// /dev/stdout, /dev/fd/3 and links to them are those descriptors as they are, with their place in
/// the file, so that what was appended to stays.
///
/// Nothing changes before the first write(): only then an existing file loses its old content. A
/// new file that was not committed, for an error, a signal or whatever reason, is removed.
class Output {
 public:
  /// Opens it. Refuses a file that is also one of `inputs`, by whatever name ("-" is standard
  /// input); opened() tells.
  explicit Output(const std::string& path, std::span<const std::string> inputs = {});
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  carom::Status opened() const;
  /// Is true if the output goes where standard output goes.
  bool is_standard_output() const { return standard_output_; }
  /// An existing file that is neither device nor pipe nor descriptor; its size in bytes.
  std::optional<std::uintmax_t> replaced_size() const;

  /// After an error the rest does nothing; commit() tells.
  void write(std::string_view bytes);
  /// Nothing more will be written: a long work of which this is all there is may end.
  bool failed() const { return !error_.empty(); }
  carom::Status commit();

 private:
  void open(const std::string& path);
  void refuse_inputs(std::span<const std::string> inputs);
  void begin();
  void fail(const char* what);

  std::string created_;  ///< the new file's path; empty when there is none, or it is committed
  std::FILE* file_ = nullptr;
  struct ::stat status_ {};
  bool standard_output_ = false;
  bool opened_by_path_ = false;  ///< other than a descriptor that was open already
  bool begun_ = false;
  bool guarded_ = false;  ///< removed by a signal
  std::string error_;
};

/// Where `path` names one of this process's own descriptors, that descriptor: "-" (1), /dev/stdout,
/// /dev/fd/N, /proc/self/fd/N, and symbolic links to these.
std::optional<int> own_descriptor(const std::filesystem::path& path);

/// Makes sure that descriptors 0 to 2 are open, so that no file that is opened later is taken for
/// standard output or standard error. One that was closed fails when it is used. To be called
/// first.
void reserve_standard_descriptors();

/// Writes out the rest of standard output and returns its error, if any. To be asked at
/// the end of a program, whose output is otherwise lost in silence.
carom::Status finish_standard_output();

}  // namespace files
