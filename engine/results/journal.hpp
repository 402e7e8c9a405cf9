#pragma once

#include "engine/base/files.hpp"
#include "engine/results/records.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

/// `journal.rift`: append-only, one checksum per record; what survives a kill. Layout:
/// docs/results-format.md.
namespace rift::results {

/// Writes a new journal; throws WorldError where the file exists or the disk is full (see AppendFile).
class JournalWriter {
 public:
  explicit JournalWriter(const std::filesystem::path& path);
  /// Goes on with a journal behind its first `kept` bytes, whole records and no release rates among them; the
  /// rest is dropped. One of version 1 becomes one of this version.
  JournalWriter(const std::filesystem::path& path, std::uint64_t kept);

  /// Encodes at once, so that the record may be changed or dropped afterwards. Cost O(size).
  void write(const Record& record);
  /// Call after each batch: readers that follow see only what is flushed.
  void flush() { file_.flush(); }
  /// Flushes to the disk itself and says whether that worked; nothing can be written afterwards.
  void close() { file_.close(); }

 private:
  base::AppendFile file_;
};

/// How a journal comes to its end.
enum class JournalState : std::uint8_t {
  whole,      // after its last record
  truncated,  // inside a record: a writer was killed, or is still writing
  damaged,    // at a record whose checksum does not fit, or that no writer writes
  foreign,    // at once: not a journal, or of a version that this build does not know
};

/// Reads a journal record by record; only one is in memory at a time. Damage is a state, never an exception;
/// WorldError only where the file cannot be opened or read.
class JournalReader {
 public:
  /// @param from  0, or what good_bytes() said of the same, since grown, journal (`rift watch`).
  explicit JournalReader(const std::filesystem::path& path, std::uint64_t from = 0);

  /// The next whole record; nothing at the end, at the first damaged record and ever after.
  /// Allocates at most what the file still holds.
  [[nodiscard]] std::optional<Record> next();

  /// Bytes up to the end of the last whole record.
  [[nodiscard]] std::uint64_t good_bytes() const { return good_bytes_; }
  /// Final once next() has returned nothing.
  [[nodiscard]] JournalState state() const { return state_; }
  /// Why it stopped, for people; empty where the journal is whole.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  std::optional<Record> stop(JournalState state, std::string reason);

  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint32_t version_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t good_bytes_ = 0;
  JournalState state_ = JournalState::whole;
  bool stopped_ = false;
  std::string reason_;
};

/// Copies every whole record of a journal into a new one: those behind damage, too, which a reader does not
/// reach. Throws WorldError. Cost O(size) in time and memory.
/// @return bytes that belong to no whole record
std::uint64_t salvage_journal(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace rift::results
