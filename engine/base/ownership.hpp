#pragma once

#include "engine/base/world_error.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

/// Who writes into a folder, and whether a file is still the one that was opened.
namespace rift::base {

/// Takes the lock of an open file or folder (flock) without waiting; `exclusive` shares it with nobody.
enum class LockResult { taken, held_by_another, no_locks };  // no_locks: the file system has none
LockResult try_lock(int descriptor, bool exclusive);

/// The right to write into a folder, held while the object lives and gone with the process however it ends.
class FolderLock {
 public:
  enum class Kind {
    alone,     // nobody else writes
    together,  // others that take it so may write as well, under names of their own: parts of a study
  };
  /// Throws WorldError where another process holds it or the folder cannot be opened. On a file system
  /// without locks it goes on: see is_kept().
  explicit FolderLock(const std::filesystem::path& folder, Kind kind = Kind::alone);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// False where the file system has no locks, so that nothing keeps another process out.
  [[nodiscard]] bool is_kept() const { return kept_; }

 private:
  int descriptor_ = -1;
  bool kept_ = false;
};

/// What a folder is tried with; a process that is killed in the middle leaves it, under a temporary name.
inline constexpr const char* probe_name = ".rift_probe";

/// A folder made with its parents if need be, tried whether it can be written to, freed of what killed
/// processes have left (`.part`), and owned by this process while the object lives. Folders that it made and
/// that are still empty at the end are removed again.
class OwnedFolder {
 public:
  /// Throws WorldError where it cannot be made, written to or locked.
  /// @param check  asked once the folder is owned and before anything is written into it; may throw
  explicit OwnedFolder(std::filesystem::path folder,
                       const std::function<void(const std::filesystem::path&)>& check = {});
  OwnedFolder(const OwnedFolder&) = delete;
  OwnedFolder& operator=(const OwnedFolder&) = delete;
  ~OwnedFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  [[nodiscard]] bool has_locks() const { return lock_.is_kept(); }
  /// The folder stays, even empty.
  void keep() { made_.clear(); }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  // innermost first
  FolderLock lock_;
};

/// Whether another process owns the folder. False where there is no such folder, or no locks.
[[nodiscard]] bool is_owned(const std::filesystem::path& folder);

/// Keeps hold of a file, so that another one under its name is told from it even where the file system
/// gives the former's number again.
class HeldFile {
 public:
  /// Throws WorldError where it cannot be opened.
  explicit HeldFile(std::filesystem::path path);
  HeldFile(const HeldFile&) = delete;
  HeldFile& operator=(const HeldFile&) = delete;
  ~HeldFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether its name still leads to this very file.
  [[nodiscard]] bool is_still_there() const;
  [[nodiscard]] std::uintmax_t size() const;  // [bytes]

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace rift::base
