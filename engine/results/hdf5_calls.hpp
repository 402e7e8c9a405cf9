#pragma once

#include "engine/results/hdf5.hpp"

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <type_traits>

/// Calls of the C API whose failures are exceptions: for hdf5.cpp and hdf5_input.cpp alone.
namespace rift::results::hdf5 {

static_assert(std::is_same_v<hid_t, std::int64_t>, "HDF5 1.10 or later");
static_assert(std::is_same_v<herr_t, int>);

/// Throws base::WorldError with the system's reason where the disk has failed.
[[noreturn]] void fail(const std::string& attempt, const Place& place);
/// Both throw where the call has failed, and where the disk has failed during it.
void require(herr_t result, const std::string& attempt, const Place& place);
Handle own(hid_t id, Handle::Closer closer, const std::string& attempt, const Place& place);

}  // namespace rift::results::hdf5
