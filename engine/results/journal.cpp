#include "engine/results/journal.hpp"

#include "engine/base/world_error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

namespace rift::results {
namespace {

constexpr std::string_view magic = "RIFTJRNL";
constexpr std::uint32_t version = 2;       // 1: the release rates had other meanings, see from_version_1
constexpr std::size_t preamble_size = 16;  // magic, version, zero

/// Precedes each payload. `check` guards the head alone: a size that lies is told from a record cut short.
struct Head {
  std::uint32_t kind;
  std::uint32_t check;
  std::uint64_t size;
};
static_assert(sizeof(Head) == 16);

std::uint32_t head_check(std::uint32_t kind, std::uint64_t size) {
  const std::array<std::uint64_t, 2> both{kind, size};
  return static_cast<std::uint32_t>(XXH3_64bits(both.data(), sizeof(both)));
}

template <typename T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

std::array<char, preamble_size> preamble() {
  std::array<char, preamble_size> bytes{};
  std::memcpy(bytes.data(), magic.data(), magic.size());
  std::memcpy(bytes.data() + magic.size(), &version, sizeof(version));
  return bytes;
}

/// The version in the first bytes of a file; nothing where they are not those of a journal, or too few.
std::optional<std::uint32_t> version_of(std::string_view bytes) {
  if (bytes.size() < preamble_size || !bytes.starts_with(magic)) return std::nullopt;
  std::array<std::uint32_t, 2> version_and_zero{};
  std::memcpy(version_and_zero.data(), bytes.data() + magic.size(), sizeof(version_and_zero));
  if (version_and_zero[1] != 0) return std::nullopt;
  return version_and_zero[0];
}

bool is_readable(std::uint32_t its) { return its == 1 || its == version; }

/// Why a file of whose first bytes these are is not read.
std::string reason_of_foreign(std::string_view bytes) {
  if (const auto its = version_of(bytes))
    return fmt::format("a journal of version {}, and this build reads versions 1 and {}", *its, version);
  return "not a journal";
}

void write_preamble(const std::filesystem::path& path) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.write(preamble().data(), preamble_size);
  file.close();
  if (!file) throw base::WorldError("write", path, base::reason_of(errno));
}

}  // namespace

JournalWriter::JournalWriter(const std::filesystem::path& path) : file_(path) {
  file_.append(bytes_of(preamble()));
  file_.flush();
}

JournalWriter::JournalWriter(const std::filesystem::path& path, std::uint64_t kept) : file_(path, kept) {
  write_preamble(path);
}

void JournalWriter::write(const Record& record) {
  // One append a record: a flush, which an append may cause, then never ends inside one.
  const auto payload = encode(record);
  const Head head{kind_of(record), head_check(kind_of(record), payload.size()), payload.size()};
  const std::uint64_t checksum = XXH3_64bits(payload.data(), payload.size());
  std::string bytes;
  bytes.reserve(sizeof(head) + payload.size() + sizeof(checksum));
  bytes.append(bytes_of(head)).append(payload).append(bytes_of(checksum));
  file_.append(bytes);
}

JournalReader::JournalReader(const std::filesystem::path& path, std::uint64_t from) : path_(path) {
  // Opening a folder succeeds and fails only at the first read, with a poorer message.
  std::error_code error;
  size_ = std::filesystem::file_size(path, error);
  if (error) throw base::WorldError("open", path, error.message());
  stream_.open(path, std::ios::binary);
  if (!stream_) throw base::WorldError("open", path, base::reason_of(errno));

  std::array<char, preamble_size> bytes{};
  stream_.read(bytes.data(), std::min<std::streamsize>(preamble_size, static_cast<std::streamsize>(size_)));
  if (stream_.bad()) throw base::WorldError("read", path, base::reason_of(errno));
  const std::string_view head(bytes.data(), std::min<std::size_t>(preamble_size, size_));
  version_ = version_of(head).value_or(0);
  if (head.size() < preamble_size && std::string_view(preamble().data(), preamble_size).starts_with(head)) {
    stop(JournalState::truncated, "cut short in its first 16 bytes");
  } else if (!is_readable(version_)) {
    stop(JournalState::foreign, reason_of_foreign(head));
  } else {
    good_bytes_ = std::max<std::uint64_t>(from, preamble_size);
    stream_.seekg(static_cast<std::streamoff>(good_bytes_));
  }
}

std::optional<Record> JournalReader::stop(JournalState state, std::string reason) {
  stopped_ = true;
  state_ = state;
  reason_ = std::move(reason);
  return std::nullopt;
}

std::optional<Record> JournalReader::next() {
  if (stopped_) return std::nullopt;
  if (good_bytes_ > size_) return stop(JournalState::truncated, "shorter than when it was last read");
  const std::uint64_t left = size_ - good_bytes_;
  if (left == 0) return stop(JournalState::whole, "");
  if (left < sizeof(Head))
    return stop(JournalState::truncated, fmt::format("the record at byte {} is cut short", good_bytes_));

  Head head{};
  stream_.read(reinterpret_cast<char*>(&head), sizeof(head));
  if (!stream_) throw base::WorldError("read", path_, base::reason_of(errno));
  if (head.check != head_check(head.kind, head.size))
    return stop(JournalState::damaged,
                fmt::format("the head of the record at byte {} is damaged", good_bytes_));
  constexpr std::uint64_t around = sizeof(Head) + sizeof(std::uint64_t);
  if (left < around || head.size > left - around)
    return stop(JournalState::truncated, fmt::format("the record at byte {} is cut short", good_bytes_));

  std::string payload(head.size, '\0');
  std::uint64_t checksum = 0;
  stream_.read(payload.data(), static_cast<std::streamsize>(payload.size()));
  stream_.read(reinterpret_cast<char*>(&checksum), sizeof(checksum));
  if (!stream_) throw base::WorldError("read", path_, base::reason_of(errno));
  if (checksum != XXH3_64bits(payload.data(), payload.size()))
    return stop(JournalState::damaged, fmt::format("the record at byte {} is damaged", good_bytes_));
  auto record = decode(head.kind, payload);
  if (!record)
    return stop(JournalState::damaged,
                fmt::format("the record at byte {} (kind {}) makes no sense", good_bytes_, head.kind));
  if (version_ == 1) from_version_1(*record);
  good_bytes_ += around + head.size;
  return record;
}

namespace {

/// The record that begins at a byte, if one that is whole does.
std::optional<std::pair<Record, std::size_t>> record_at(std::string_view bytes, std::size_t at) {
  constexpr std::size_t around = sizeof(Head) + sizeof(std::uint64_t);
  Head head{};
  if (bytes.size() - at < around) return std::nullopt;
  std::memcpy(&head, bytes.data() + at, sizeof(head));
  if (head.check != head_check(head.kind, head.size) || head.size > bytes.size() - at - around)
    return std::nullopt;
  const std::string_view payload = bytes.substr(at + sizeof(head), head.size);
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, payload.data() + payload.size(), sizeof(checksum));
  if (checksum != XXH3_64bits(payload.data(), payload.size())) return std::nullopt;
  auto record = decode(head.kind, payload);
  if (!record) return std::nullopt;
  return std::pair{std::move(*record), around + head.size};
}

}  // namespace

std::uint64_t salvage_journal(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::string bytes = base::read_whole_file(from);
  const bool old = version_of(bytes) == 1;
  JournalWriter writer(to);
  std::uint64_t lost = 0;
  for (std::size_t at = std::min(preamble_size, bytes.size()); at < bytes.size();) {
    if (auto found = record_at(bytes, at)) {
      if (old) from_version_1(found->first);
      writer.write(found->first);
      at += found->second;
    } else {
      ++lost, ++at;
    }
  }
  writer.close();
  return lost;
}

}  // namespace rift::results
