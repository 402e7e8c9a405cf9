#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/series.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/memory_file.hpp"

#include <algorithm>
#include <string>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace {

using namespace rift;
using namespace rift::results;

/// The bytes as they are, or as payloads with heads and checksums that fit, so that what is inside is read.
std::string journal_of(fuzz::Bytes input) {
  const auto mode = input.number<std::uint8_t>();
  if (mode % 2 == 0) return std::string(input.left);
  std::string journal("RIFTJRNL\1\0\0\0\0\0\0\0", 16);
  const auto append = [&](const auto& value) {
    journal.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  while (!input.empty()) {
    const std::uint32_t kind = input.number<std::uint8_t>() % 9;
    const std::string_view payload = input.text(input.number<std::uint16_t>());
    const std::uint64_t both[] = {kind, payload.size()};
    append(kind);
    append(static_cast<std::uint32_t>(XXH3_64bits(both, sizeof both)));
    append(both[1]);
    journal.append(payload);
    append(XXH3_64bits(payload.data(), payload.size()));
  }
  return journal;
}

}  // namespace

// A journal: read, indexed, turned into a table. Only WorldError may leave.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::MemoryFile file;
  const auto& path = file.holding(journal_of(fuzz::bytes_of(data, size)));
  try {
    const JournalScan scan = scan_journal(path);
    (void)series_csv(scan.samples, scan.rates);
    if (!scan.geometry) return 0;
    for_each_moment(path, *scan.geometry, [](std::span<const Frame>) {});
    JournalIndex index(path);
    for (std::int32_t lane = 0; lane < std::min(index.lanes(), 4); ++lane)
      for (const FrameEntry& entry : index.frames(lane)) (void)index.frame(entry);
  } catch (const rift::base::WorldError&) {
  }
  return 0;
}
