#include "engine/base/claim.hpp"

#include "engine/base/files.hpp"
#include "engine/base/process_name.hpp"
#include "engine/base/world_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <random>
#include <sstream>
#include <system_error>
#include <utility>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".claim";

/// The small file's text; empty where it is gone.
std::string words_in(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  std::array<char, 512> text{};
  const ssize_t count = ::read(descriptor, text.data(), text.size());
  ::close(descriptor);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count))};
}

/// When the file was changed last [s]; none where it is gone.
std::optional<double> changed_s(const fs::path& file) {
  struct stat status = {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

void touch(const fs::path& file) { (void)::utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

/// By what its file says: "HOST PROCESS CHANCE LABEL".
ClaimHolder holder_of(const std::string& words, double silent_s) {
  ClaimHolder holder{.host = {}, .label = {}, .process = 0, .silent_s = silent_s, .lives = true};
  std::string chance;
  std::istringstream text(words);
  text >> holder.host >> holder.process >> chance >> holder.label;
  const bool is_here = holder.process > 0 && holder.host == host_name();
  const bool has_gone = is_here && has_ended(holder.process);
  holder.lives = !has_gone && silent_s < Claims::patience_s;  // its number may be another process's by now
  return holder;
}

}  // namespace

Claim::Claim(Claim&& other) noexcept
    : claims_(std::exchange(other.claims_, nullptr)), name_(std::move(other.name_)) {}

Claim::~Claim() {
  if (claims_ != nullptr) claims_->release(name_);
}

Claims::Claims(fs::path folder, std::string label, double signs_every_s)
    : folder_(std::move(folder)), label_(std::move(label)) {
  make_folder(folder_);
  remove_leftovers(folder_);
  clock_ = temporary_name(folder_ / "clock");
  AppendFile(clock_).close();
  signs_ = std::jthread(
      [this, signs_every_s](const std::stop_token& stop) { give_signs_of_life(stop, signs_every_s); });
}

Claims::~Claims() {
  signs_.request_stop();
  signs_.join();
  std::error_code others_are_there;
  fs::remove(clock_, others_are_there);
  fs::remove(folder_, others_are_there);
}

fs::path Claims::file_of(const std::string& name) const { return folder_ / (name + ending); }

/// By the clock of who keeps the folder, which need not be this node's.
double Claims::now_s() {
  touch(clock_);
  const std::optional<double> now = changed_s(clock_);
  if (!now) throw WorldError("read", clock_, "it is gone");
  return *now;
}

/// @return false where there is such a claim
bool Claims::make(const std::string& name) {
  const fs::path file = file_of(name);
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST) return false;
  if (descriptor < 0) throw WorldError("create", file, reason_of(errno));
  const std::string words =
      fmt::format("{} {} {:08x} {}\n", host_name(), ::getpid(), std::random_device{}(), label_);
  const bool written = ::write(descriptor, words.data(), words.size()) == static_cast<ssize_t>(words.size());
  const int error = errno;
  ::close(descriptor);
  if (!written) {
    ::unlink(file.c_str());
    throw WorldError("write", file, reason_of(error));
  }
  const std::scoped_lock lock(mutex_);
  mine_[name] = words;
  return true;
}

/// Removes the file of a dead holder, by a name that only one process can give it. Where another one has
/// taken the claim meanwhile, that one's file has been moved: it is put back.
/// @return whether the claim is free now
bool Claims::take_away(const fs::path& file, const std::string& words) {
  const fs::path moved = temporary_name(file);
  if (::rename(file.c_str(), moved.c_str()) != 0) return errno == ENOENT;
  const bool is_the_dead = words_in(moved) == words;
  if (!is_the_dead) (void)::link(moved.c_str(), file.c_str());
  ::unlink(moved.c_str());
  return is_the_dead;
}

std::optional<Claim> Claims::take(const std::string& name) {
  constexpr int tries = 2;  // the second one where a dead holder's claim was taken away
  for (int k = 0; k < tries; ++k) {
    if (make(name)) return Claim(*this, name);
    const std::string words = words_in(file_of(name));
    const std::optional<double> changed = changed_s(file_of(name));
    if (!changed) continue;  // released meanwhile
    if (holder_of(words, now_s() - *changed).lives || !take_away(file_of(name), words)) return std::nullopt;
  }
  return std::nullopt;
}

void Claims::release(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  const auto claim = mine_.find(name);
  // Who was taken for dead finds another holder's words.
  if (words_in(file_of(name)) == claim->second) ::unlink(file_of(name).c_str());
  mine_.erase(claim);
}

void Claims::give_signs_of_life(const std::stop_token& stop, double every_s) {
  std::unique_lock lock(mutex_);
  const std::chrono::duration<double> every(every_s);
  while (!changed_.wait_for(lock, stop, every, [] { return false; }) && !stop.stop_requested())
    for (const auto& [name, words] : mine_) touch(file_of(name));
}

std::map<std::string, ClaimHolder> Claims::holders(const fs::path& folder) {
  std::map<std::string, ClaimHolder> all;
  std::error_code none;  // no folder, no claims
  const double now_s =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() != ending) continue;
    const std::optional<double> changed = changed_s(entry.path());
    if (changed) all[entry.path().stem().string()] = holder_of(words_in(entry.path()), now_s - *changed);
  }
  return all;
}

}  // namespace rift::base
