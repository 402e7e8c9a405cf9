#pragma once

#include "engine/scene/issue.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/steering.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rift::scene {

/// Where a parameter was set.
struct Origin {
  std::string file;   // the preset, or "--set"
  int line = 0;       // 0 for --set
  std::string value;  // as shown in messages
};

/// The file that a parameter's rows came from, and their lines.
struct RowsOrigin {
  std::string file;
  std::vector<int> line;
};

/// The list of values that [study] has for an axis, as TOML values.
struct GridAxis {
  std::string name;
  std::vector<std::string> values;
};

/// One scenario of a study.
struct StudyRow {
  Scene scene;
  /// The axes that the study names, in the order of the file, and this scenario's values as text: "0.5 c_r",
  /// "linear"; "-" where the axis does not apply. The same names in every row.
  std::vector<std::pair<std::string, std::string>> axes;
  /// The combinations of the grid that are this scenario, each with a value for each of Preset::grid; several
  /// where some of them do not apply to it, none where it is one of [[study.rows]].
  std::vector<std::vector<std::string>> combinations = {};
};

/// A preset read into a scene, with every mistake that was found. The scenes count only where `issues` is
/// empty: a parameter with an issue keeps its default.
struct Preset {
  Scene scene;  // with a study or lanes what they start from; it is then checked in them, not by itself
  std::map<std::string, Origin> origins;  // by full key; what is not here is a default
  std::vector<Issue> issues;              // in the order of the file, those of --set last
  std::string name;                       // of the preset in messages
  std::vector<Scene> lanes;               // of [[lanes]], in the order of the file; a lattice and step shared
  /// Of [study], the first list varying slowest, then of [[study.rows]]; no two scenes are equal.
  std::vector<StudyRow> study;
  std::vector<Change> steering;            // of [[steering]], by lane and step
  std::map<std::string, RowsOrigin> rows;  // by full key, of those whose rows came from a file
  /// A line each: keys that --set has replaced, a thickness that it changes, plates of fewer than two layers
  /// of elements, rows that seem to be missing.
  std::vector<std::string> notes;
  std::vector<GridAxis> grid = {};  // the lists of [study], in the order of the file
};

/// Reads a preset file, applies overrides ("crack.velocity=0.3 c_r", full keys only) and checks all of it.
/// An override replaces what the file says of its key and of the keys that it excludes (thickness for
/// layers), with a note; the last one wins. Never throws for bad input, a missing file included.
Preset read_preset(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same with other lists in the place of [study], their values as they are typed ("0.3 c_r"); none:
/// without a grid. [[study.rows]] stay.
Preset read_preset(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                   const std::vector<GridAxis>& grid);

/// The same for a text; `name` stands for the file in messages. An empty text is a preset: all defaults.
Preset read_preset_text(std::string_view text, const std::string& name,
                        const std::vector<std::string>& overrides = {});

/// An issue about `key` that points at where it was set, or at the preset with the default value.
/// For checks which come later and need more than the scene (the lattice, the critical step).
Issue issue_at(const Preset& preset, const std::string& key, std::string text);

/// An issue about one of the rows of `key`, from 0: points at its line where the rows came from a file.
Issue issue_at_row(const Preset& preset, const std::string& key, std::size_t row, std::string text);

/// The effective preset as TOML: every key with a line of doc, absent ones as comments. Reading it gives the
/// scene back to the last bit.
std::string preset_text(const Scene& scene);

/// The same with its lanes as [[lanes]], and its study as [study] and [[study.rows]] as they were given.
std::string preset_text(const Preset& preset);

/// The text of a file, or why there is none ("no such file", "is a directory", "cannot be read: ...").
struct PresetFile {
  std::string text;
  std::string problem;
};

/// Reads a file, a pipe or a device, once and from its begin; at most one byte more than `largest`, so that a
/// device without end does no harm and the reader sees that it is too large.
PresetFile read_preset_file(const std::filesystem::path& path, std::size_t largest);

/// The reference page docs/parameters.md, made from the parameter table; a test keeps the file equal to it.
std::string parameters_markdown();

}  // namespace rift::scene
