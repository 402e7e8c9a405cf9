// Loaded before the C library (LD_PRELOAD), makes one call of a kind fail, as a failing disk would.
//
//   RIFT_FAULT_UNDER  a folder: only regular files below it fail
//   RIFT_FAULT_KIND   write, close, fsync, rename, open, truncate, mkdir, unlink
//   RIFT_FAULT_CALL   which call of that kind, from 1; 0 or unset: none
//   RIFT_FAULT_ERROR  the errno it fails with
//   RIFT_FAULT_STAYS  set: all later calls of the kind fail too, as on a disk that stays full
//   RIFT_FAULT_COUNT  a file that says at the end how many calls of the kind there were
//   RIFT_FAULT_IN     the name of the program whose calls count (default: rift), of all that inherit this
//
// What a program writes through stdio does not pass here: the C library calls itself.
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const char* variable(const char* name, const char* otherwise) {
  const char* value = getenv(name);
  return value != nullptr ? value : otherwise;
}

std::atomic<int> calls = 0;

/// Whether the call that is under way is to fail; errno is set then.
bool fails(const char* kind) {
  static const char* const wanted = variable("RIFT_FAULT_KIND", "");
  static const int call = atoi(variable("RIFT_FAULT_CALL", "0"));
  static const bool stays = getenv("RIFT_FAULT_STAYS") != nullptr;
  static const int error = atoi(variable("RIFT_FAULT_ERROR", "28"));
  static const bool here = strcmp(program_invocation_short_name, variable("RIFT_FAULT_IN", "rift")) == 0;
  if (!here || strcmp(wanted, kind) != 0) return false;
  const int now = ++calls;
  if (call == 0 || now < call || (now > call && !stays)) return false;
  errno = error;
  return true;
}

bool is_below(const char* path) {
  static const char* const folder = variable("RIFT_FAULT_UNDER", "");
  return folder[0] != '\0' && strncmp(path, folder, strlen(folder)) == 0;
}

bool path_counts(const char* path) {
  if (path[0] == '/') return is_below(path);
  char whole[PATH_MAX];
  return getcwd(whole, sizeof whole) != nullptr && is_below(whole);
}

/// A regular file below the folder that is open for writing.
bool descriptor_counts(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return false;
  path[length] = '\0';
  return is_below(path);
}

bool is_for_writing(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

struct Count {
  ~Count() {
    const char* path = getenv("RIFT_FAULT_COUNT");
    if (path == nullptr || strcmp(program_invocation_short_name, variable("RIFT_FAULT_IN", "rift")) != 0)
      return;
    char text[32];
    const int length = snprintf(text, sizeof text, "%d", calls.load());
    const int file =
        static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0666));
    syscall(SYS_write, file, text, length);
    syscall(SYS_close, file);
  }
} count_at_the_end;

}  // namespace

#define REAL(name) static auto* const real_##name = real<decltype(name)>(#name)

extern "C" {

ssize_t write(int file, const void* bytes, size_t size) {
  REAL(write);
  return descriptor_counts(file) && fails("write") ? -1 : real_write(file, bytes, size);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
  REAL(writev);
  return descriptor_counts(file) && fails("write") ? -1 : real_writev(file, parts, count);
}
ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  REAL(pwrite);
  return descriptor_counts(file) && fails("write") ? -1 : real_pwrite(file, bytes, size, at);
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  REAL(pwrite64);
  return descriptor_counts(file) && fails("write") ? -1 : real_pwrite64(file, bytes, size, at);
}
int fsync(int file) {
  REAL(fsync);
  return descriptor_counts(file) && fails("fsync") ? -1 : real_fsync(file);
}
int fdatasync(int file) {
  REAL(fdatasync);
  return descriptor_counts(file) && fails("fsync") ? -1 : real_fdatasync(file);
}
int close(int file) {
  REAL(close);
  const bool failing = is_for_writing(file) && descriptor_counts(file) && fails("close");
  const int error = errno, result = real_close(file);  // the descriptor is gone all the same, as on NFS
  if (!failing) return result;
  errno = error;
  return -1;
}
int ftruncate(int file, off_t size) noexcept {
  REAL(ftruncate);
  return descriptor_counts(file) && fails("truncate") ? -1 : real_ftruncate(file, size);
}
int ftruncate64(int file, off64_t size) noexcept {
  REAL(ftruncate64);
  return descriptor_counts(file) && fails("truncate") ? -1 : real_ftruncate64(file, size);
}
int rename(const char* from, const char* to) noexcept {
  REAL(rename);
  return path_counts(to) && fails("rename") ? -1 : real_rename(from, to);
}
int mkdir(const char* path, mode_t mode) noexcept {
  REAL(mkdir);
  return path_counts(path) && fails("mkdir") ? -1 : real_mkdir(path, mode);
}
int unlink(const char* path) noexcept {
  REAL(unlink);
  return path_counts(path) && fails("unlink") ? -1 : real_unlink(path);
}
int remove(const char* path) noexcept {
  REAL(remove);
  return path_counts(path) && fails("unlink") ? -1 : real_remove(path);
}
int unlinkat(int folder, const char* path, int flags) noexcept {
  REAL(unlinkat);
  return path_counts(path) && fails("unlink") ? -1 : real_unlinkat(folder, path, flags);
}

#define OPEN(name)                                                                            \
  int name(const char* path, int flags, ...) {                                                \
    static auto* const real_open = real<int(const char*, int, ...)>(#name);                   \
    va_list rest;                                                                             \
    va_start(rest, flags);                                                                    \
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;                    \
    va_end(rest);                                                                             \
    const bool writing = (flags & O_ACCMODE) != O_RDONLY;                                     \
    return writing && path_counts(path) && fails("open") ? -1 : real_open(path, flags, mode); \
  }
OPEN(open)
OPEN(open64)

}  // extern "C"
