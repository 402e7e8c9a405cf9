#include "engine/results/checkpoint.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/hdf5.hpp"
#include "engine/results/json_input.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>
#include <system_error>

namespace rift::results {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// The last 16 bytes of the file, behind what HDF5 looks at: "RIFTCHK1" and XXH3-64 of all before.
constexpr std::size_t seal_bytes = 16;
constexpr char seal_mark[] = "RIFTCHK1";

std::string seal_of(const std::string& bytes) {
  const std::uint64_t hash = XXH3_64bits(bytes.data(), bytes.size());
  std::string seal(seal_mark, 8);
  for (int k = 0; k < 8; ++k) seal += static_cast<char>(hash >> (8 * k) & 0xFF);
  return seal;
}

void append_seal(const fs::path& path) {
  const std::string bytes = base::read_whole_file(path);
  base::AppendFile file(path, bytes.size());
  file.append(seal_of(bytes));
  file.close();
}

Checkpoint read_file(const fs::path& path) {
  const hdf5::InputFile file(path);
  const Json index = read_json(file.text("index"), path);
  Checkpoint checkpoint;
  checkpoint.notes = base::json_text(index.at("notes"));
  checkpoint.journal_bytes = index.at("journal_bytes").get<std::uint64_t>();
  for (const auto& [name, count] : index.at("state").items())
    checkpoint.state[name] = count == 0 ? std::vector<double>{} : file.doubles(name);
  return checkpoint;
}

}  // namespace

std::string checkpoint_damage(const fs::path& path) {
  const std::string bytes = base::read_whole_file(path);
  if (bytes.size() <= seal_bytes) return "too short";
  const std::string seal = bytes.substr(bytes.size() - seal_bytes);
  if (seal.compare(0, 8, seal_mark, 8) != 0) return "it does not end as a checkpoint does";
  return seal == seal_of(bytes.substr(0, bytes.size() - seal_bytes)) ? "" : "its checksum does not fit";
}

void write_checkpoint(const fs::path& run_folder, const Checkpoint& checkpoint) {
  const fs::path path = run_folder / checkpoint_name;
  base::PendingFile pending(path);
  {
    hdf5::File file(pending.temporary());
    Json index{{"notes", read_json(checkpoint.notes, path)}, {"journal_bytes", checkpoint.journal_bytes}};
    index["state"] = Json::object();
    {
      hdf5::Group root = file.root();
      for (const auto& [name, numbers] : checkpoint.state) {
        index["state"][name] = numbers.size();
        if (!numbers.empty()) root.write(name, numbers);
      }
      root.write_text("index", base::json_text(index));
    }
    file.close();
  }
  append_seal(pending.temporary());
  if (fs::exists(path)) base::rename_file(path, run_folder / former_checkpoint_name);
  pending.commit();
}

std::optional<Checkpoint> read_checkpoint(const fs::path& run_folder, std::uint64_t journal_bytes,
                                          std::string& damaged) {
  for (const char* name : {checkpoint_name, former_checkpoint_name}) {
    const fs::path path = run_folder / name;
    if (!fs::exists(path)) continue;
    std::string why = checkpoint_damage(path);
    try {
      if (why.empty()) {
        Checkpoint checkpoint = read_file(path);
        if (checkpoint.journal_bytes <= journal_bytes) return checkpoint;
        why = fmt::format("it needs {} bytes of the journal, of which {} are whole", checkpoint.journal_bytes,
                          journal_bytes);
      }
    } catch (const std::exception& error) {
      why = error.what();
    }
    damaged += fmt::format("{}{}: {}", damaged.empty() ? "" : "; ", path.string(), why);
  }
  return std::nullopt;
}

std::uint64_t checkpoint_journal_bytes(const fs::path& path) {
  const hdf5::InputFile file(path);
  const Json index = json_or_discarded(file.text("index"));
  if (!index.is_object() || !index.contains("journal_bytes") || !index["journal_bytes"].is_number_unsigned())
    throw base::WorldError("read", path, "it names no place in the journal");
  return index["journal_bytes"].get<std::uint64_t>();
}

void remove_checkpoints(const fs::path& run_folder) {
  std::error_code none;
  for (const char* name : {checkpoint_name, former_checkpoint_name}) fs::remove(run_folder / name, none);
}

}  // namespace rift::results
