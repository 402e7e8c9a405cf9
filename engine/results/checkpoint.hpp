#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// `checkpoint.h5`: what a run needs to go on to the same bits (docs/results-format.md).
namespace rift::results {

using NamedNumbers = std::map<std::string, std::vector<double>>;

/// A moment of a run.
struct Checkpoint {
  std::string notes;  // JSON: where the march was
  NamedNumbers state;
  std::uint64_t journal_bytes = 0;  // of the journal that belong to it
};

inline constexpr const char* checkpoint_name = "checkpoint.h5";
inline constexpr const char* former_checkpoint_name = "checkpoint_former.h5";

/// Writes it under a temporary name, with a checksum at its end; the one before becomes the former one.
/// Throws WorldError; the one before is then still there.
void write_checkpoint(const std::filesystem::path& run_folder, const Checkpoint& checkpoint);

/// The latest one that is whole. @param[in] journal_bytes  of the journal that are whole: a checkpoint that
/// needs more is of no use.  @param[out] damaged  why a later one was not taken, for people; may be empty
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& run_folder,
                                          std::uint64_t journal_bytes, std::string& damaged);

/// Why a checkpoint's file is not one that was written whole; empty where it is.
std::string checkpoint_damage(const std::filesystem::path& path);

/// Bytes of the journal that a checkpoint needs; the file has no damage (checkpoint_damage()). Throws
/// WorldError where it holds no such number all the same.
std::uint64_t checkpoint_journal_bytes(const std::filesystem::path& path);

/// The run has ended: there is nothing to go on from.
void remove_checkpoints(const std::filesystem::path& run_folder);

}  // namespace rift::results
