#include "engine/results/hdf5_driver.hpp"

#include "engine/results/hdf5_calls.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace rift::results::hdf5 {
namespace {

constexpr haddr_t largest_file = (haddr_t{1} << 63) - 1;

/// A file that the library has open. The library fills the part that it knows.
struct DriverFile : H5FD_t {
  Disk* disk = nullptr;
  int descriptor = -1;
  haddr_t allocated = 0, end = 0;                     // bytes
  std::vector<std::pair<haddr_t, std::string>> lost;  // what could not be written, in its order, and where
};

DriverFile& of(H5FD_t* file) { return *static_cast<DriverFile*>(file); }
const DriverFile& of(const H5FD_t* file) { return *static_cast<const DriverFile*>(file); }

void note_error(const DriverFile& file, int error) {
  if (file.disk->error == 0) file.disk->error = error;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t access, haddr_t) {
  Disk* disk = *static_cast<Disk* const*>(H5Pget_driver_info(access));
  int how = O_CLOEXEC | ((flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY);
  if ((flags & H5F_ACC_CREAT) != 0) how |= O_CREAT;
  if ((flags & H5F_ACC_TRUNC) != 0) how |= O_TRUNC;
  const int descriptor = ::open(name, how, 0666);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    disk->error = errno;
    if (descriptor >= 0) ::close(descriptor);
    return nullptr;
  }
  auto* file = new DriverFile{};
  file->disk = disk, file->descriptor = descriptor, file->end = static_cast<haddr_t>(status.st_size);
  return file;
}

herr_t close_file(H5FD_t* opened) {
  DriverFile& file = of(opened);
  if (::close(file.descriptor) != 0) note_error(file, errno);
  delete &file;
  return 0;
}

herr_t ask_features(const H5FD_t*, unsigned long* features) {  // those of the library's own driver
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t allocated_bytes(const H5FD_t* file, H5FD_mem_t) { return of(file).allocated; }

herr_t set_allocated_bytes(H5FD_t* file, H5FD_mem_t, haddr_t bytes) {
  of(file).allocated = bytes;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return of(file).end; }

/// Lays what could not be written over what was read.
void lay_over(const DriverFile& file, haddr_t at, std::size_t size, char* bytes) {
  for (const auto& [from, text] : file.lost) {
    const haddr_t begin = std::max(at, from), end = std::min(at + size, from + text.size());
    if (begin < end) std::memcpy(bytes + (begin - at), text.data() + (begin - from), end - begin);
  }
}

herr_t read_bytes(H5FD_t* opened, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* buffer) {
  const DriverFile& file = of(opened);
  auto* bytes = static_cast<char*>(buffer);
  std::size_t done = 0;
  if (at > largest_file - size) return -1;  // a damaged file points there
  while (done < size) {
    const ssize_t count = ::pread(file.descriptor, bytes + done, size - done, static_cast<off_t>(at + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      note_error(file, errno);
      return -1;
    }
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  std::memset(bytes + done, 0, size - done);  // behind the end of the file
  lay_over(file, at, size, bytes);
  return 0;
}

herr_t write_bytes(H5FD_t* opened, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* buffer) {
  DriverFile& file = of(opened);
  const auto* bytes = static_cast<const char*>(buffer);
  std::size_t done = 0;
  while (done < size && file.disk->error == 0) {
    const ssize_t count = ::pwrite(file.descriptor, bytes + done, size - done, static_cast<off_t>(at + done));
    if (count >= 0)
      done += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      note_error(file, errno);
  }
  if (done < size) file.lost.emplace_back(at + done, std::string(bytes + done, size - done));
  file.end = std::max(file.end, at + size);
  return 0;
}

herr_t cut_to_allocated(H5FD_t* opened, hid_t, hbool_t) {
  DriverFile& file = of(opened);
  if (file.end == file.allocated || file.disk->error != 0) return 0;
  if (::ftruncate(file.descriptor, static_cast<off_t>(file.allocated)) != 0) note_error(file, errno);
  file.end = file.allocated;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION  // HDF5 1.14
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(H5_VFD_RESERVED + 1);
#endif
  driver.name = "rift";
  driver.maxaddr = largest_file;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Disk*);
  driver.open = open_file, driver.close = close_file;
  driver.query = ask_features;
  driver.get_eoa = allocated_bytes, driver.set_eoa = set_allocated_bytes, driver.get_eof = end_of_file;
  driver.read = read_bytes, driver.write = write_bytes, driver.truncate = cut_to_allocated;
  constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

hid_t registered_driver() {
  // What cannot be closed, a file that cannot be read for example, is not closed once more at the process's
  // exit.
  (void)H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static const H5FD_class_t driver = driver_class();
  return H5FDregister(&driver);
}

}  // namespace

Handle access_through(Disk& disk) {
  static const hid_t driver = registered_driver();
  const Place nowhere{"HDF5", "", &disk};
  auto access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare", nowhere);
  Disk* const info = &disk;
  require(H5Pset_driver(access.id(), driver, &info), "prepare", nowhere);
  return access;
}

}  // namespace rift::results::hdf5
