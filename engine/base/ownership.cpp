#include "engine/base/ownership.hpp"

#include "engine/base/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

/// Makes the folder. @return what was made, innermost first
std::vector<fs::path> make_with_parents(const fs::path& folder) {
  std::vector<fs::path> made;
  std::error_code error;
  for (fs::path p = folder; !p.empty() && !fs::exists(p, error); p = p.parent_path()) made.push_back(p);
  fs::create_directories(folder, error);
  if (error) throw WorldError("create the folder", folder, error.message());
  if (!fs::is_directory(folder)) throw WorldError("create the folder", folder, "a file of that name exists");
  return made;
}

void remove_made(const std::vector<fs::path>& made) {
  std::error_code not_empty;  // then it stays
  for (const fs::path& folder : made) fs::remove(folder, not_empty);
}

void try_to_write_into(const fs::path& folder) {
  const fs::path probe = temporary_name(folder / probe_name);
  std::error_code ignored;
  try {
    AppendFile file(probe);
    file.append("rift");
    file.close();
  } catch (const WorldError& failure) {
    fs::remove(probe, ignored);
    throw WorldError("write into", folder, failure.what());
  }
  std::error_code failure;
  fs::remove(probe, failure);
  if (failure) throw WorldError("remove a file from", folder, failure.message());
}

}  // namespace

LockResult try_lock(int descriptor, bool exclusive) {
  // Who only looks whether there is a lock takes it for an instant: a few more tries tell that from an owner.
  constexpr int tries = 10;
  for (int k = 1;; ++k) {
    if (::flock(descriptor, (exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0) return LockResult::taken;
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return LockResult::no_locks;
    if (k >= tries) return LockResult::held_by_another;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

FolderLock::FolderLock(const fs::path& folder, Kind kind) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) throw WorldError("open the folder", folder, reason_of(errno));
  const LockResult result = try_lock(descriptor_, kind == Kind::alone);
  kept_ = result == LockResult::taken;
  if (result != LockResult::held_by_another) return;
  ::close(std::exchange(descriptor_, -1));
  throw WorldError("write into", folder, "another process is writing it");
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OwnedFolder::OwnedFolder(fs::path folder, const std::function<void(const fs::path&)>& check)
    : folder_(std::move(folder)), made_(make_with_parents(folder_)), lock_(folder_) {
  try {
    remove_leftovers(folder_);
    if (check) check(folder_);
    try_to_write_into(folder_);
  } catch (...) {
    remove_made(made_);
    throw;
  }
}

OwnedFolder::~OwnedFolder() { remove_made(made_); }

bool is_owned(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

HeldFile::HeldFile(fs::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw WorldError("open", path_, reason_of(errno));
}

HeldFile::~HeldFile() { ::close(descriptor_); }

bool HeldFile::is_still_there() const {
  struct stat held = {}, named = {};
  if (::fstat(descriptor_, &held) != 0 || ::stat(path_.c_str(), &named) != 0) return false;
  return held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

std::uintmax_t HeldFile::size() const {
  struct stat held = {};
  if (::fstat(descriptor_, &held) != 0) throw WorldError("read", path_, reason_of(errno));
  return static_cast<std::uintmax_t>(held.st_size);
}

}  // namespace rift::base
