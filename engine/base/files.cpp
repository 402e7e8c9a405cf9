#include "engine/base/files.hpp"

#include "engine/base/ownership.hpp"
#include "engine/base/process_name.hpp"
#include "engine/base/world_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <climits>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

namespace rift::base {
namespace {

constexpr std::size_t flush_from = std::size_t{4} << 20;

/// Puts the file, or the names a folder holds, on the disk itself.
void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw WorldError("open", path, reason_of(errno));
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  // Some file systems (and /dev) know no fsync; that is not a failed write.
  if (result != 0 && error != EINVAL && error != EROFS) throw WorldError("flush", path, reason_of(error));
}

constexpr std::string_view temporary_ending = ".part";

/// What a temporary name says.
struct TemporaryName {
  std::string target, host;
  pid_t process = 0;
};

/// Nothing for any other name.
std::optional<TemporaryName> read_temporary_name(std::string_view name) {
  if (!name.ends_with(temporary_ending)) return std::nullopt;
  name.remove_suffix(temporary_ending.size());
  const std::size_t chance = name.rfind('-');
  if (chance == name.npos || name.size() - chance != 9) return std::nullopt;
  name = name.substr(0, chance);
  const std::size_t process = name.rfind('-'), host = name.rfind('.');
  if (process == name.npos || host == name.npos || host > process) return std::nullopt;
  TemporaryName read{std::string(name.substr(0, host)),
                     std::string(name.substr(host + 1, process - host - 1)), 0};
  const char* end = name.data() + name.size();
  const auto [at, error] = std::from_chars(name.data() + process + 1, end, read.process);
  if (error != std::errc() || at != end || read.process <= 0) return std::nullopt;
  return read;
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw WorldError("create", path_, reason_of(errno));
  (void)::flock(descriptor_, LOCK_EX | LOCK_NB);  // some file systems know no locks; then nobody is warned
}

AppendFile::AppendFile(std::filesystem::path path, std::uint64_t kept) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw WorldError("open", path_, reason_of(errno));
  const auto fail = [&](const char* attempt, const std::string& why) {
    ::close(std::exchange(descriptor_, -1));
    throw WorldError(attempt, path_, why);
  };
  if (try_lock(descriptor_, true) == LockResult::held_by_another)
    fail("write", "another process is writing it");
  if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0) fail("cut", reason_of(errno));
  if (::lseek(descriptor_, 0, SEEK_END) != static_cast<off_t>(kept)) fail("continue", reason_of(errno));
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
  if (error != 0) throw WorldError("write", path_, reason_of(error));
}

void AppendFile::close() {
  flush();
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    throw WorldError("flush", path_, reason_of(errno));
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) throw WorldError("close", path_, reason_of(errno));
}

bool is_being_written(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  const std::string ending =
      fmt::format(".{}-{}-{:08x}{}", host_name(), ::getpid(), std::random_device{}(), temporary_ending);
  std::string name = path.filename().string();
  name.resize(std::min(name.size(), NAME_MAX - std::min<std::size_t>(ending.size(), NAME_MAX)));
  return path.parent_path() / (name + ending);
}

std::string target_name(const std::string& name) {
  if (const auto read = read_temporary_name(name)) return read->target;
  return name.ends_with(temporary_ending) ? name.substr(0, name.size() - temporary_ending.size()) : name;
}

bool is_leftover(const std::filesystem::path& part) {
  const auto name = read_temporary_name(part.filename().string());
  if (!name) return part.extension() == temporary_ending;
  if (name->host == host_name()) return has_ended(name->process);
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(part, error);
  return !error && std::filesystem::file_time_type::clock::now() - changed > std::chrono::hours(24);
}

void remove_leftovers(const std::filesystem::path& folder) {
  std::error_code end, stays;
  for (auto entry = std::filesystem::directory_iterator(folder, end);
       !end && entry != std::filesystem::directory_iterator(); entry.increment(end))
    if (read_temporary_name(entry->path().filename().string()) && is_leftover(entry->path()))
      std::filesystem::remove_all(entry->path(), stays);
}

void check_target(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!std::filesystem::exists(folder, ignored))
    throw WorldError("write", path, "there is no folder " + folder.string());
  if (!std::filesystem::is_directory(folder, ignored))
    throw WorldError("write", path, folder.string() + " is no folder");
  if (std::filesystem::is_directory(path, ignored))
    throw WorldError("write", path, "a folder of that name exists");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) throw WorldError("write", path, reason_of(errno));
}

PendingFile::PendingFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(temporary_name(path_)) {
  check_target(path_);
  const int descriptor = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) throw WorldError("create", path_, reason_of(errno));
  ::close(descriptor);
}

PendingFile::~PendingFile() {
  std::error_code nothing_to_remove;
  std::filesystem::remove(temporary_, nothing_to_remove);
}

void PendingFile::commit() {
  sync_to_disk(temporary_);
  rename_file(temporary_, path_);
  const auto folder = path_.parent_path();
  sync_to_disk(folder.empty() ? "." : folder);
}

PendingText::PendingText(const std::filesystem::path& path) : file_(path), text_(file_.temporary(), 0) {}

void PendingText::commit() {
  text_.close();
  file_.commit();
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  PendingText file(path);
  file.append(text);
  file.commit();
}

std::string read_whole_file(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw WorldError("open", path, reason_of(errno));
  std::string text;
  std::array<char, 65536> piece;
  ssize_t count = 0;
  int error = 0;
  while (error == 0 && (count = ::read(descriptor, piece.data(), piece.size())) != 0) {
    if (count > 0)
      text.append(piece.data(), static_cast<std::size_t>(count));
    else if (errno != EINTR)
      error = errno;
  }
  ::close(descriptor);
  if (error != 0) throw WorldError("read", path, reason_of(error));
  return text;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WorldError("create the folder", folder, error.message());
  if (!std::filesystem::is_directory(folder, error))
    throw WorldError("create the folder", folder, "a file of that name exists");
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) throw WorldError("rename", from, error.message());
}

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw WorldError("remove", path, error.message());
}

std::string plain_text(const std::exception& error) {
  if (const auto* failure = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return "cannot use " + failure->path1().string() + ": " + failure->code().message();
  return error.what();
}

}  // namespace rift::base
