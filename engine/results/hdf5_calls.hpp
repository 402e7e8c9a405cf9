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

/// Throws WorldError with the library's innermost reason; the file of `place` is given up.
[[noreturn]] void fail(const std::string& attempt, const Place& place);
void require(herr_t result, const std::string& attempt, const Place& place);
/// How files are opened: without the library's locks, which fail where the file system has none. A file that
/// is written has a name that only this process uses, and what is read is never changed in place.
Handle access_without_locks();
Handle own(hid_t id, Handle::Closer closer, const std::string& attempt, const Place& place);

}  // namespace rift::results::hdf5
