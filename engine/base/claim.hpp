#pragma once

#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

/// Who works on what in a folder that several processes share, on any nodes and file systems: NFS and Lustre
/// without locks suffice. A claim is a small file that only one process can make, and that says by its time
/// of last change that its holder lives. It saves work and guards nothing: a process that was taken for dead
/// may still go on, so that what is computed must be the same whoever computes it.
namespace rift::base {

/// Who holds a claim.
struct ClaimHolder {
  std::string host, label;
  int process = 0;      // 0: it has only just begun
  double silent_s = 0;  // since its last sign of life
  bool lives = true;
};

class Claims;

/// The right to do what it is named after; released with the object.
class Claim {
 public:
  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;
  ~Claim();

 private:
  friend class Claims;
  Claim(Claims& of, std::string name) : claims_(&of), name_(std::move(name)) {}

  Claims* claims_;
  std::string name_;
};

/// The claims of this process in a folder. A thread of its own gives the signs of life.
class Claims {
 public:
  /// How long a holder on another node may give no sign of life. Nodes of NFS see a file's time up to a
  /// minute late.
  static constexpr double patience_s = 150;

  /// @param label  of this process, for people, such as a job's number; of letters without blanks
  /// Throws WorldError where the folder cannot be made or written to.
  explicit Claims(std::filesystem::path folder, std::string label = {}, double signs_every_s = 10);
  Claims(const Claims&) = delete;
  Claims& operator=(const Claims&) = delete;
  ~Claims();

  /// The claim of this name, also where its holder is dead; none where another holder lives. Throws
  /// WorldError where the folder cannot be written to.
  [[nodiscard]] std::optional<Claim> take(const std::string& name);

  /// What a folder's claims are held by, by name; none where there is no such folder.
  [[nodiscard]] static std::map<std::string, ClaimHolder> holders(const std::filesystem::path& folder);

 private:
  friend class Claim;

  [[nodiscard]] std::filesystem::path file_of(const std::string& name) const;
  [[nodiscard]] double now_s();
  [[nodiscard]] bool make(const std::string& name);
  [[nodiscard]] static bool take_away(const std::filesystem::path& file, const std::string& words);
  void release(const std::string& name);
  void give_signs_of_life(const std::stop_token& stop, double every_s);

  std::filesystem::path folder_, clock_;  // the clock is a file: its time is that of the folder's server
  std::string label_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<std::string, std::string> mine_;  // the words in each claim's file, by its name
  std::jthread signs_;                       // last: it ends first
};

}  // namespace rift::base
