#include "engine/results/hdf5.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/hdf5_calls.hpp"
#include "engine/results/hdf5_driver.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace rift::results::hdf5 {
namespace {

// Of shuffled floats higher levels gain little and cost several times more.
constexpr unsigned deflate_level = 1;
constexpr std::size_t compress_from_bytes = 4096;

}  // namespace

void fail(const std::string& attempt, const Place& place) {
  H5Eclear2(H5E_DEFAULT);  // the library's reasons are for those who know its insides
  const bool whole_file = place.object.empty();
  throw base::WorldError(attempt + (whole_file ? "" : " " + place.object + " of"), place.file,
                         place.disk->error != 0 ? std::generic_category().message(place.disk->error)
                         : whole_file           ? "it is damaged, or no HDF5 file"
                                                : "it is missing or damaged");
}

void require(herr_t result, const std::string& attempt, const Place& place) {
  if (result < 0 || place.disk->error != 0) fail(attempt, place);
}

Handle own(hid_t id, Handle::Closer closer, const std::string& attempt, const Place& place) {
  Handle handle(id, closer);
  if (id < 0 || place.disk->error != 0) fail(attempt, place);
  return handle;
}

namespace {

template <typename T>
struct Types;
template <>
struct Types<float> {
  static hid_t file() { return H5T_IEEE_F32LE; }
  static hid_t memory() { return H5T_NATIVE_FLOAT; }
};
template <>
struct Types<double> {
  static hid_t file() { return H5T_IEEE_F64LE; }
  static hid_t memory() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Types<std::int32_t> {
  static hid_t file() { return H5T_STD_I32LE; }
  static hid_t memory() { return H5T_NATIVE_INT32; }
};
template <>
struct Types<std::int64_t> {
  static hid_t file() { return H5T_STD_I64LE; }
  static hid_t memory() { return H5T_NATIVE_INT64; }
};
template <>
struct Types<std::uint8_t> {
  static hid_t file() { return H5T_STD_U8LE; }
  static hid_t memory() { return H5T_NATIVE_UINT8; }
};

Handle text_type(std::size_t size, H5T_cset_t characters, const Place& place) {
  auto type = own(H5Tcopy(H5T_C_S1), H5Tclose, "describe", place);
  require(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)), "describe", place);
  require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "describe", place);
  require(H5Tset_cset(type.id(), characters), "describe", place);
  return type;
}

/// A one-byte null stands for the empty text: a type of no bytes does not exist.
std::string at_least_one_byte(std::string_view text) {
  return text.empty() ? std::string(1, '\0') : std::string(text);
}

Handle compressed(const std::vector<hsize_t>& chunk, const Place& place) {
  auto creation = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "describe", place);
  require(H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), "describe", place);
  require(H5Pset_shuffle(creation.id()), "describe", place);
  require(H5Pset_deflate(creation.id(), deflate_level), "describe", place);
  return creation;
}

std::vector<hsize_t> shape(std::size_t rows, std::size_t columns) {
  return columns == 0 ? std::vector<hsize_t>{rows} : std::vector<hsize_t>{rows, columns};
}

Handle dataspace(const std::vector<hsize_t>& size, const hsize_t* largest, const Place& place) {
  return own(H5Screate_simple(static_cast<int>(size.size()), size.data(), largest), H5Sclose, "describe",
             place);
}

}  // namespace

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(closer_, other.closer_);
  return *this;
}

Handle::~Handle() {
  if (id_ >= 0) closer_(id_);
}

template <typename T>
void Growing<T>::append(std::span<const T> values) {
  const std::size_t count = values.size() / std::max<std::size_t>(columns_, 1);
  if (count == 0) return;
  const auto total = shape(rows_ + count, columns_);
  require(H5Dset_extent(dataset_.id(), total.data()), "extend", place_);
  const auto file_space = own(H5Dget_space(dataset_.id()), H5Sclose, "extend", place_);
  const std::vector<hsize_t> start =
      columns_ == 0 ? std::vector<hsize_t>{rows_} : std::vector<hsize_t>{rows_, 0};
  const auto size = shape(count, columns_);
  require(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
          "extend", place_);
  const auto memory_space = dataspace(size, nullptr, place_);
  require(H5Dwrite(dataset_.id(), Types<T>::memory(), memory_space.id(), file_space.id(), H5P_DEFAULT,
                   values.data()),
          "write", place_);
  rows_ += count;
}

Place Group::at(const std::string& name) const {
  return {place_.file, place_.object + "/" + name, place_.disk};
}

Group Group::group(const std::string& name) {
  const auto place = at(name);
  return {own(H5Gcreate2(handle_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
              "create", place),
          place};
}

template <typename T>
void Group::write(const std::string& name, std::span<const T> values, std::size_t columns) {
  const auto place = at(name);
  const auto size = shape(values.size() / std::max<std::size_t>(columns, 1), columns);
  const auto space = dataspace(size, nullptr, place);
  auto chunk = size;
  chunk[0] = std::clamp<hsize_t>(chunk[0], 1, hsize_t{1} << 16);
  const auto creation = values.size_bytes() >= compress_from_bytes
                            ? compressed(chunk, place)
                            : own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "describe", place);
  const auto dataset = own(H5Dcreate2(handle_.id(), name.c_str(), Types<T>::file(), space.id(), H5P_DEFAULT,
                                      creation.id(), H5P_DEFAULT),
                           H5Dclose, "create", place);
  if (values.empty()) return;
  require(H5Dwrite(dataset.id(), Types<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write",
          place);
}

void Group::write_text(const std::string& name, std::string_view text) {
  const auto place = at(name);
  const auto bytes = at_least_one_byte(text);
  const auto type = text_type(bytes.size(), H5T_CSET_UTF8, place);
  const auto space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe", place);
  const auto dataset = own(
      H5Dcreate2(handle_.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "create", place);
  require(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), "write", place);
}

template <typename T>
Growing<T> Group::growing(const std::string& name, std::size_t chunk_rows, std::size_t columns) {
  const auto place = at(name);
  auto largest = shape(0, columns);
  largest[0] = H5S_UNLIMITED;
  const auto space = dataspace(shape(0, columns), largest.data(), place);
  const auto creation = compressed(shape(std::max<std::size_t>(chunk_rows, 1), columns), place);
  return {own(H5Dcreate2(handle_.id(), name.c_str(), Types<T>::file(), space.id(), H5P_DEFAULT, creation.id(),
                         H5P_DEFAULT),
              H5Dclose, "create", place),
          place, columns};
}

template <typename T>
void Group::attribute(const std::string& name, T value) {
  const auto place = at(name);
  const auto space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe", place);
  const auto attribute =
      own(H5Acreate2(handle_.id(), name.c_str(), Types<T>::file(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
          H5Aclose, "create", place);
  require(H5Awrite(attribute.id(), Types<T>::memory(), &value), "write", place);
}

template <typename T>
void Group::attribute(const std::string& name, std::span<const T> values) {
  const auto place = at(name);
  const auto space = dataspace(shape(values.size(), 0), nullptr, place);
  const auto attribute =
      own(H5Acreate2(handle_.id(), name.c_str(), Types<T>::file(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
          H5Aclose, "create", place);
  require(H5Awrite(attribute.id(), Types<T>::memory(), values.data()), "write", place);
}

void Group::ascii_attribute(const std::string& name, std::string_view text) {
  const auto place = at(name);
  const auto bytes = at_least_one_byte(text);
  const auto type = text_type(bytes.size(), H5T_CSET_ASCII, place);
  const auto space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe", place);
  const auto attribute =
      own(H5Acreate2(handle_.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          "create", place);
  require(H5Awrite(attribute.id(), type.id(), bytes.data()), "write", place);
}

File::File(const std::filesystem::path& path) : path_(path), disk_(std::make_unique<Disk>()) {
  const auto access = access_through(*disk_);
  const Place place{path_, "", disk_.get()};
  id_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
  if (id_ < 0) fail("create", place);
}

File::~File() {
  if (id_ < 0) return;
  if (disk_->error == 0) disk_->error = ECANCELED;  // nothing more is written
  H5Fclose(id_);
  H5Eclear2(H5E_DEFAULT);
}

Group File::root() {
  const Place place{path_, "", disk_.get()};
  return {own(H5Gopen2(id_, "/", H5P_DEFAULT), H5Gclose, "open", place), place};
}

void File::close() {
  const Place place{path_, "", disk_.get()};
  require(H5Fflush(id_, H5F_SCOPE_GLOBAL), "write", place);
  require(H5Fclose(std::exchange(id_, -1)), "write", place);
}

template class Growing<float>;
template class Growing<double>;
template class Growing<std::int32_t>;
template class Growing<std::int64_t>;
template class Growing<std::uint8_t>;
template void Group::write(const std::string&, std::span<const float>, std::size_t);
template void Group::write(const std::string&, std::span<const double>, std::size_t);
template void Group::write(const std::string&, std::span<const std::int32_t>, std::size_t);
template void Group::write(const std::string&, std::span<const std::int64_t>, std::size_t);
template void Group::write(const std::string&, std::span<const std::uint8_t>, std::size_t);
template Growing<float> Group::growing(const std::string&, std::size_t, std::size_t);
template Growing<double> Group::growing(const std::string&, std::size_t, std::size_t);
template Growing<std::int32_t> Group::growing(const std::string&, std::size_t, std::size_t);
template Growing<std::int64_t> Group::growing(const std::string&, std::size_t, std::size_t);
template Growing<std::uint8_t> Group::growing(const std::string&, std::size_t, std::size_t);
template void Group::attribute(const std::string&, std::int32_t);
template void Group::attribute(const std::string&, std::int64_t);
template void Group::attribute(const std::string&, double);
template void Group::attribute(const std::string&, std::span<const std::int32_t>);
template void Group::attribute(const std::string&, std::span<const std::int64_t>);

}  // namespace rift::results::hdf5
