#include "engine/results/files.hpp"

#include "engine/results/world_error.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace rift::results {
namespace {

constexpr std::size_t flush_from = std::size_t{4} << 20;

std::string errno_text(int error) { return std::generic_category().message(error); }

/// Puts the file, or the names a folder holds, on the disk itself.
void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw WorldError("open", path, errno_text(errno));
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  // Some file systems (and /dev) know no fsync; that is not a failed write.
  if (result != 0 && error != EINVAL && error != EROFS) throw WorldError("flush", path, errno_text(error));
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw WorldError("create", path_, errno_text(errno));
  (void)::flock(descriptor_, LOCK_EX | LOCK_NB);  // some file systems know no locks; then nobody is warned
}

AppendFile::AppendFile(std::filesystem::path path, std::uint64_t kept) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw WorldError("open", path_, errno_text(errno));
  const auto fail = [&](const char* attempt, const std::string& why) {
    ::close(std::exchange(descriptor_, -1));
    throw WorldError(attempt, path_, why);
  };
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) fail("write", "another process is writing it");
  if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0) fail("cut", errno_text(errno));
  if (::lseek(descriptor_, 0, SEEK_END) != static_cast<off_t>(kept)) fail("go on with", errno_text(errno));
}

AppendFile::~AppendFile() {
  if (descriptor_ < 0) return;
  try {
    flush();
  } catch (const WorldError&) {
    // A destructor cannot report; the file then ends after its last whole flush.
  }
  ::close(descriptor_);
}

void AppendFile::append(std::string_view bytes) {
  waiting_.append(bytes);
  if (waiting_.size() >= flush_from) flush();
}

void AppendFile::flush() {
  std::size_t done = 0;
  int error = 0;
  while (done < waiting_.size() && error == 0) {
    const ssize_t count = ::write(descriptor_, waiting_.data() + done, waiting_.size() - done);
    if (count >= 0)
      done += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      error = errno;
  }
  waiting_.erase(0, done);  // after a failure the next flush goes on at the very byte where this one stopped
  if (error != 0) throw WorldError("write", path_, errno_text(error));
}

void AppendFile::close() {
  flush();
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    throw WorldError("flush", path_, errno_text(errno));
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) throw WorldError("close", path_, errno_text(errno));
}

bool is_being_written(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

PendingFile::PendingFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".part";
}

PendingFile::~PendingFile() {
  std::error_code nothing_to_remove;
  std::filesystem::remove(temporary_, nothing_to_remove);
}

void PendingFile::commit() {
  sync_to_disk(temporary_);
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw WorldError("rename", temporary_, error.message());
  const auto folder = path_.parent_path();
  sync_to_disk(folder.empty() ? "." : folder);
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  PendingFile pending(path);
  std::error_code nothing_to_remove;
  std::filesystem::remove(pending.temporary(), nothing_to_remove);  // left by a run that was killed
  AppendFile file(pending.temporary());
  file.append(text);
  file.close();
  pending.commit();
}

std::string read_whole_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw WorldError("open", path, errno_text(errno));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw WorldError("read", path, errno_text(errno));
  return text;
}

}  // namespace rift::results
