#pragma once

#include "engine/results/hdf5.hpp"

/// How HDF5 reaches the disk: for hdf5.cpp and hdf5_input.cpp alone.
namespace rift::results::hdf5 {

/// Access to files through a driver that never lets the library meet a failed write. HDF5 keeps parts of a
/// file in memory and writes them whenever it likes, when it closes a dataset among others; after an error
/// there it holds on to half-closed objects and dies of them when the process exits. The driver notes the
/// first error in `disk`, keeps what could not be written in memory, and says that all is well; whoever
/// writes looks at `disk` after each call and gives up.
/// The driver takes no locks, which fail where the file system has none: a file that is written has a name
/// that only this process uses, and what is read is never changed in place.
/// @param disk  must outlive every file opened with it
Handle access_through(Disk& disk);

}  // namespace rift::results::hdf5
