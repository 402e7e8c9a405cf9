#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// Files that are either whole or say that they are not. Every failure throws WorldError with the path.
namespace rift::results {

/// A new file that only grows. What is appended waits in memory until flush(), which writes all of it or
/// throws; what a failed flush could not write stays in memory for the next one, so that nothing is lost
/// silently.
class AppendFile {
 public:
  /// Throws where `path` exists: a file is never overwritten.
  explicit AppendFile(std::filesystem::path path);
  /// Goes on with a file that is there, behind its first `kept` bytes; the rest is dropped. Throws where
  /// another process is writing it.
  AppendFile(std::filesystem::path path, std::uint64_t kept);
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  /// Tries to write what is left, and cannot say whether it succeeded: call close().
  ~AppendFile();

  /// Flushes by itself from time to time, so that memory stays bounded.
  void append(std::string_view bytes);
  /// After it, readers see everything appended so far.
  void flush();
  /// Flushes to the disk itself; the file takes no more.
  void close();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::string waiting_;
  int descriptor_ = -1;
};

/// Whether another AppendFile, of any process, goes on with the file. False where there is no such file.
[[nodiscard]] bool is_being_written(const std::filesystem::path& path);

/// A file that appears under its name only when it is complete: written under `temporary()` in the same
/// folder, renamed by commit(), removed where commit() is never reached.
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path path);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  /// Flushes the temporary file to the disk and renames it, replacing a former file of the name.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
};

/// Replaces `path` by `text` in one step: a reader sees the old file or the new one, never half of one.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// The content of a small text file.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path);

}  // namespace rift::results
