#include "engine/results/hdf5.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/hdf5_calls.hpp"
#include "engine/results/hdf5_driver.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
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
                         place.disk->error != 0 ? base::reason_of(place.disk->error)
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

/// Little-endian, as the machines are that rift runs on (records.cpp): numbers lie in memory as in the file.
hid_t type_of(Number type) {
  switch (type) {
    case Number::float32:
      return H5T_IEEE_F32LE;
    case Number::float64:
      return H5T_IEEE_F64LE;
    case Number::int32:
      return H5T_STD_I32LE;
    case Number::int64:
      return H5T_STD_I64LE;
    default:
      return H5T_STD_U8LE;
  }
}

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

void Growing::append(const Numbers& values) {
  const std::size_t count = values.count / std::max<std::size_t>(columns_, 1);
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
  require(H5Dwrite(dataset_.id(), type_of(values.type), memory_space.id(), file_space.id(), H5P_DEFAULT,
                   values.data),
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

void Group::write(const std::string& name, const Numbers& values, std::size_t columns) {
  const auto place = at(name);
  const auto size = shape(values.count / std::max<std::size_t>(columns, 1), columns);
  const auto space = dataspace(size, nullptr, place);
  auto chunk = size;
  chunk[0] = std::clamp<hsize_t>(chunk[0], 1, hsize_t{1} << 16);
  const auto creation = values.bytes >= compress_from_bytes
                            ? compressed(chunk, place)
                            : own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "describe", place);
  const auto dataset = own(H5Dcreate2(handle_.id(), name.c_str(), type_of(values.type), space.id(),
                                      H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                           H5Dclose, "create", place);
  if (values.count == 0) return;
  require(H5Dwrite(dataset.id(), type_of(values.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data), "write",
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

Growing Group::growing(const std::string& name, Number type, std::size_t chunk_rows, std::size_t columns) {
  const auto place = at(name);
  auto largest = shape(0, columns);
  largest[0] = H5S_UNLIMITED;
  const auto space = dataspace(shape(0, columns), largest.data(), place);
  const auto creation = compressed(shape(std::max<std::size_t>(chunk_rows, 1), columns), place);
  return {own(H5Dcreate2(handle_.id(), name.c_str(), type_of(type), space.id(), H5P_DEFAULT, creation.id(),
                         H5P_DEFAULT),
              H5Dclose, "create", place),
          place, columns};
}

void Group::write_attribute(const std::string& name, std::int64_t type, const Handle& space,
                            const void* data) {
  const auto place = at(name);
  const auto attribute =
      own(H5Acreate2(handle_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          "create", place);
  require(H5Awrite(attribute.id(), type, data), "write", place);
}

void Group::attribute(const std::string& name, std::int64_t value) {
  const auto space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe", at(name));
  write_attribute(name, type_of(Number::int64), space, &value);
}

void Group::attribute(const std::string& name, const Numbers& values) {
  write_attribute(name, type_of(values.type), dataspace(shape(values.count, 0), nullptr, at(name)),
                  values.data);
}

void Group::ascii_attribute(const std::string& name, std::string_view text) {
  const auto bytes = at_least_one_byte(text);
  const auto type = text_type(bytes.size(), H5T_CSET_ASCII, at(name));
  const auto space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe", at(name));
  write_attribute(name, type.id(), space, bytes.data());
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

}  // namespace rift::results::hdf5
