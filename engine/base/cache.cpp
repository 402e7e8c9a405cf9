#include "engine/base/cache.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

// File: magic, key length, key, count, numbers, XXH3-64 of all that precedes it.
constexpr std::string_view magic = "riftcac1";

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string encode(const std::string& key, std::span<const double> numbers) {
  std::string bytes(magic);
  append(bytes, static_cast<std::uint64_t>(key.size()));
  bytes += key;
  append(bytes, static_cast<std::uint64_t>(numbers.size()));
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
  append(bytes, static_cast<std::uint64_t>(XXH3_64bits(bytes.data(), bytes.size())));
  return bytes;
}

/// The numbers of a file that is, to the last byte, what encode() wrote for this key.
std::optional<std::vector<double>> decode(const std::string& bytes, const std::string& key) {
  const std::size_t before = magic.size() + sizeof(std::uint64_t) + key.size() + sizeof(std::uint64_t);
  if (bytes.size() < before + sizeof(std::uint64_t)) return std::nullopt;
  const std::size_t payload = bytes.size() - before - sizeof(std::uint64_t);
  if (payload % sizeof(double) != 0) return std::nullopt;
  std::vector<double> numbers(payload / sizeof(double));
  std::copy_n(bytes.data() + before, payload, reinterpret_cast<char*>(numbers.data()));
  if (encode(key, numbers) != bytes) return std::nullopt;
  return numbers;
}

}  // namespace

Cache user_cache() {
  const auto environment = [](const char* name) {
    return std::getenv(name) ? fs::path(std::getenv(name)) : fs::path();
  };
  if (const fs::path base = environment("XDG_CACHE_HOME"); base.is_absolute()) return {base / "rift", {}};
  if (const fs::path home = environment("HOME"); home.is_absolute()) return {home / ".cache" / "rift", {}};
  return {};
}

fs::path cache_file(const Cache& cache, const std::string& kind, const std::string& key) {
  const XXH128_hash_t hash = XXH3_128bits(key.data(), key.size());
  return cache.folder / fmt::format("{}-{:016x}{:016x}.bin", kind, hash.high64, hash.low64);
}

std::optional<std::vector<double>> recall(Cache& cache, const std::string& kind, const std::string& key) {
  if (cache.folder.empty()) return std::nullopt;
  const fs::path file = cache_file(cache, kind, key);
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  auto numbers = decode(bytes, key);
  if (!numbers)
    cache.notes.push_back(fmt::format("{} is damaged: its contents are computed again", file.string()));
  return numbers;
}

void remember(Cache& cache, const std::string& kind, const std::string& key,
              std::span<const double> numbers) {
  if (cache.folder.empty()) return;
  const fs::path file = cache_file(cache, kind, key);
  std::error_code error;
  fs::create_directories(cache.folder, error);
  remove_leftovers(cache.folder);
  try {
    write_whole_file(file, encode(key, numbers));
  } catch (const WorldError&) {
    cache.notes.push_back(
        fmt::format("{}: could not be written, so the next run computes this again", file.string()));
  }
}

}  // namespace rift::base
