#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

/// Files that are either whole or say that they are not. Every failure throws WorldError with the path.
namespace rift::base {

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

/// A name beside `path` for what will become it, which no other process uses, on this node or another one:
/// "NAME.HOST-PROCESS-CHANCE.part". A name that would become too long loses letters of NAME.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& path);

/// The name of the file that a temporary one was to become: "NAME", of "NAME.part" as well; any other name is
/// returned as it is.
[[nodiscard]] std::string target_name(const std::string& name);

/// Whether no living process writes this temporary file. Those of other nodes count as written for a day
/// after their last change, since nobody here knows whether their process lives; those that name no process
/// do not.
[[nodiscard]] bool is_leftover(const std::filesystem::path& part);

/// Removes the temporary files in a folder whose processes are gone; files that cannot be removed stay.
void remove_leftovers(const std::filesystem::path& folder);

/// Throws WorldError where a file of this name could not be made: its folder is missing or cannot be written
/// into, or a folder has its name. Asked before the work that the file is to hold.
void check_target(const std::filesystem::path& path);

/// A file that appears under its name only when it is complete: written under `temporary()` in the same
/// folder, renamed by commit(), removed where commit() is never reached.
class PendingFile {
 public:
  /// Makes the temporary file, empty. Throws WorldError where it cannot be made.
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

/// A text written piece by piece, which appears under its name only when it is complete.
class PendingText {
 public:
  explicit PendingText(const std::filesystem::path& path);
  void append(std::string_view piece) { text_.append(piece); }
  void commit();

 private:
  PendingFile file_;
  AppendFile text_;
};

/// Replaces `path` by `text` in one step: a reader sees the old file or the new one, never half of one.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// The content of a small file.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path);

/// Makes the folder and those above it, where they are not there yet.
void make_folder(const std::filesystem::path& folder);
/// Replaces a former file of the name `to`.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);
/// Does nothing where there is no such file.
void remove_file(const std::filesystem::path& path);

/// What an exception says, for people: those of the standard library's file system name their path and the
/// system's reason, not the function that was called.
[[nodiscard]] std::string plain_text(const std::exception& error);

}  // namespace rift::base
