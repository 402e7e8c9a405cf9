#pragma once

#include "engine/results/run_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::results {

/// What a file of a run is found to be.
enum class Found {
  intact,
  missing,  // and could not be made, or was not to be
  mended,   // made anew from the journal; what was there before is kept beside it as *_damaged*
  damaged,  // something of it is lost
  removed,  // left by a kill, of no use
};
const char* name_of(Found found);

struct Finding {
  std::string file;
  Found found = Found::intact;
  std::string text;  // for people
};

struct Verification {
  RunState run;
  bool running = false;  // another process is writing it: then it is looked at only
  std::vector<Finding> files;
};

/// Whether nothing of the run is lost: every file is sound, or was made anew of a whole journal.
bool is_whole(const Verification& verification);

/// Looks at every file of a run: checksums of journal and checkpoints; the archive in a process of its own,
/// dataset by dataset against what the journal gives; tables and summary against the journal. With `mend`,
/// what can be made anew is, what was there is kept under another name, and all whole records of a damaged
/// journal are saved. Throws WorldError where there is neither a journal nor an archive, or a file cannot be
/// written.
Verification verify_run(const std::filesystem::path& folder, bool mend);

}  // namespace rift::results
