#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rift::base {

/// Where costly, repeatable results are kept between runs, addressed by what they depend on.
/// A cache can fail without harm: then the result is computed again, and `notes` says why.
struct Cache {
  std::filesystem::path folder;    // empty: nothing is kept
  std::vector<std::string> notes;  // what was damaged or could not be written, for people
};

/// $XDG_CACHE_HOME/rift, else ~/.cache/rift, else none.
Cache user_cache();

/// The numbers stored under a kind ("packing") and a key (a text that names all they depend on). A file that
/// is damaged, of another format or of another key counts as absent, with a note.
std::optional<std::vector<double>> recall(Cache& cache, const std::string& kind, const std::string& key);

/// Stores under a temporary name and renames: two runs side by side, or a kill, never leave half a file.
void remember(Cache& cache, const std::string& kind, const std::string& key, std::span<const double> numbers);

/// The file of a kind and key.
std::filesystem::path cache_file(const Cache& cache, const std::string& kind, const std::string& key);

}  // namespace rift::base
