#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Writing HDF5 files, and reading our own: what the archive and checkpoints need of the C API, with its
/// handles closed and its failures thrown as base::WorldError that names the file, the object and the
/// system's reason. Element types: float, double, std::int32_t, std::int64_t, std::uint8_t; stored
/// little-endian.
namespace rift::results::hdf5 {

/// An HDF5 handle that closes itself.
class Handle {
 public:
  using Closer = int (*)(std::int64_t);  // hid_t -> herr_t; hdf5.h stays out of this header
  Handle(std::int64_t id, Closer closer) : id_(id), closer_(closer) {}
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle();
  [[nodiscard]] std::int64_t id() const { return id_; }

 private:
  std::int64_t id_;
  Closer closer_;
};

/// What the disk has answered about an open file: the first error, as errno; 0 where there was none.
struct Disk {
  int error = 0;
};

/// Where an object is, for messages, and what the disk said of its file.
struct Place {
  std::filesystem::path file;
  std::string object;
  const Disk* disk;
};

/// Types of elements.
enum class Number : std::uint8_t { float32, float64, int32, int64, uint8 };

template <typename T>
inline constexpr Number number_type = Number::uint8;
template <>
inline constexpr Number number_type<float> = Number::float32;
template <>
inline constexpr Number number_type<double> = Number::float64;
template <>
inline constexpr Number number_type<std::int32_t> = Number::int32;
template <>
inline constexpr Number number_type<std::int64_t> = Number::int64;

/// Numbers of one type, as they lie in memory.
struct Numbers {
  template <typename T>
  Numbers(std::span<const T> values)
      : type(number_type<T>), data(values.data()), count(values.size()), bytes(values.size_bytes()) {
    static_assert(number_type<T> != Number::uint8 || std::is_same_v<T, std::uint8_t>);
  }
  template <typename T>
  Numbers(const std::vector<T>& values) : Numbers(std::span<const T>(values)) {}

  Number type;
  const void* data;
  std::size_t count, bytes;
};

/// A dataset of rows that grows: chunks of `chunk_rows` rows, shuffled and deflated.
class Growing {
 public:
  /// @param values  whole rows
  void append(const Numbers& values);
  [[nodiscard]] std::size_t rows() const { return rows_; }

 private:
  friend class Group;
  Growing(Handle dataset, Place place, std::size_t columns)
      : dataset_(std::move(dataset)), place_(std::move(place)), columns_(columns) {}
  Handle dataset_;
  Place place_;
  std::size_t columns_;
  std::size_t rows_ = 0;
};

/// A group of an open file; must not outlive it.
class Group {
 public:
  [[nodiscard]] Group group(const std::string& name);

  /// A dataset of the values' own size: [n], or [n / columns, columns] where columns > 0. Larger ones are
  /// compressed.
  void write(const std::string& name, const Numbers& values, std::size_t columns = 0);

  /// A scalar dataset: one fixed-length UTF-8 text.
  void write_text(const std::string& name, std::string_view text);

  /// A dataset of no rows yet, [0] or, where columns > 0, [0, columns].
  [[nodiscard]] Growing growing(const std::string& name, Number type, std::size_t chunk_rows,
                                std::size_t columns = 0);

  /// A scalar attribute, or an array of [n].
  void attribute(const std::string& name, std::int64_t value);
  void attribute(const std::string& name, const Numbers& values);
  /// A fixed-length ASCII attribute, not null-terminated, as VTKHDF asks of `Type`.
  void ascii_attribute(const std::string& name, std::string_view text);

 private:
  friend class File;
  Group(Handle handle, Place place) : handle_(std::move(handle)), place_(std::move(place)) {}
  [[nodiscard]] Place at(const std::string& name) const;
  void write_attribute(const std::string& name, std::int64_t type, const Handle& space, const void* data);
  Handle handle_;
  Place place_;
};

/// A new HDF5 file; one of the name is replaced. Datasets and groups must be gone before close().
class File {
 public:
  explicit File(const std::filesystem::path& path);
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  /// Without a close() before it, gives the file up: what it holds is of no use.
  ~File();
  [[nodiscard]] Group root();
  /// Writes what the library still holds and says whether that worked.
  void close();

 private:
  std::filesystem::path path_;
  std::unique_ptr<Disk> disk_;  // stays where it is when the library has closed the file
  std::int64_t id_ = -1;
};

/// A dataset that a file holds.
struct Stored {
  enum class Kind : std::uint8_t { integer, real, text, other } kind = Kind::other;
  std::vector<std::uint64_t> shape;  // rows first; empty where it is a scalar
  std::uint64_t rows() const { return shape.empty() ? 1 : shape.front(); }
  std::uint64_t columns() const { return shape.size() < 2 ? 1 : shape[1]; }
};

/// A file open for reading. Sizes that the file is too small for are not believed: base::WorldError.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);
  /// All numbers of a dataset, as they lie.
  [[nodiscard]] std::vector<double> doubles(const std::string& name) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& name) const;
  /// What write_text() wrote.
  [[nodiscard]] std::string text(const std::string& name) const;
  /// Every dataset, by its path without the leading slash.
  [[nodiscard]] std::map<std::string, Stored> contents() const;
  /// Reads all of a dataset, a few MB at a time. @return the XXH3-64 of its numbers or text
  [[nodiscard]] std::uint64_t digest(const std::string& name) const;
  /// The numbers of an attribute, or its text; empty where there is none of that kind.
  [[nodiscard]] std::vector<std::int64_t> attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name) const;

 private:
  [[nodiscard]] Handle dataset(const std::string& name) const;
  template <class T>
  [[nodiscard]] std::vector<T> numbers(const std::string& name) const;
  [[nodiscard]] Place at(const std::string& object) const { return {path_, object, disk_.get()}; }
  std::filesystem::path path_;
  std::unique_ptr<Disk> disk_;
  Handle file_;
};

}  // namespace rift::results::hdf5
