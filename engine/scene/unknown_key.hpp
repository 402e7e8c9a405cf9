#pragma once

#include <string>

/// Messages about names that the parameter table does not know, with the nearest one that it does.
namespace rift::scene {

/// Whether presets have a table of this name.
bool is_table(const std::string& name);

/// "unknown table [spcimen], did you mean [specimen]?"
std::string unknown_table(const std::string& name);

/// "unknown key 'damge_zone_ratio', did you mean 'damage_zone_ratio'?"
/// @param table  of the preset in which the key stands; empty where `name` is meant to be a full key
std::string unknown_key(const std::string& table, const std::string& name);

}  // namespace rift::scene
