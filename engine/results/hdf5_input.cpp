#include "engine/base/world_error.hpp"
#include "engine/results/hdf5_calls.hpp"
#include "engine/results/hdf5_driver.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

namespace rift::results::hdf5 {
namespace {

/// Deflate makes a thousandth of a dataset at best: a file cannot hold one that is larger than this many of
/// it.
constexpr std::uint64_t most_times_the_file = 1100;
constexpr hsize_t slab_numbers = 1 << 19;

std::uint64_t count_of(const Stored& stored) {
  std::uint64_t count = 1;
  for (const std::uint64_t n : stored.shape)
    if (__builtin_mul_overflow(count, n, &count)) return std::numeric_limits<std::uint64_t>::max();
  return count;
}

/// The file must be large enough for what is said to lie in it.
void require_room(std::uint64_t bytes, const Place& place) {
  std::error_code ignored;
  const auto file = std::filesystem::file_size(place.file, ignored);
  if (bytes / most_times_the_file > file)
    throw base::WorldError("believe the size of " + place.object + " of", place.file,
                           "the file is too small for it");
}

Stored stored_in(hid_t dataset, const Place& place) {
  Stored stored;
  const auto type = own(H5Dget_type(dataset), H5Tclose, "describe", place);
  const H5T_class_t kind = H5Tget_class(type.id());
  stored.kind = kind == H5T_INTEGER                                        ? Stored::Kind::integer
                : kind == H5T_FLOAT                                        ? Stored::Kind::real
                : kind == H5T_STRING && H5Tis_variable_str(type.id()) == 0 ? Stored::Kind::text
                                                                           : Stored::Kind::other;
  const auto space = own(H5Dget_space(dataset), H5Sclose, "describe", place);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  require(rank, "describe", place);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  if (rank > 0) require(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr), "describe", place);
  stored.shape.assign(shape.begin(), shape.end());
  return stored;
}

template <class T>
hid_t native() {
  return std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
}

/// Rows of a dataset from one to another, as numbers of type `type`.
void read_rows(hid_t dataset, hid_t type, const Stored& stored, hsize_t from, hsize_t rows, void* target,
               const Place& place) {
  std::vector<hsize_t> start(stored.shape.size(), 0), size(stored.shape.begin(), stored.shape.end());
  start[0] = from, size[0] = rows;
  const auto space = own(H5Dget_space(dataset), H5Sclose, "read", place);
  require(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
          "read", place);
  const auto memory =
      own(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, "read", place);
  require(H5Dread(dataset, type, memory.id(), space.id(), H5P_DEFAULT, target), "read", place);
}

template <class T>
std::uint64_t digest_of(hid_t dataset, const Stored& stored, const Place& place) {
  XXH3_state_t state;
  XXH3_64bits_reset(&state);
  const std::uint64_t rows = stored.rows(), count = count_of(stored),
                      per_row = rows == 0 ? 1 : std::max<std::uint64_t>(count / rows, 1);
  const std::uint64_t slab = std::max<std::uint64_t>(slab_numbers / per_row, 1);
  std::vector<T> numbers(std::min(slab, rows) * per_row);
  for (std::uint64_t row = 0; row < rows && count > 0; row += slab) {
    const std::uint64_t here = std::min(slab, rows - row);
    read_rows(dataset, native<T>(), stored, row, here, numbers.data(), place);
    XXH3_64bits_update(&state, numbers.data(), here * per_row * sizeof(T));
  }
  return XXH3_64bits_digest(&state);
}

struct Listing {
  std::map<std::string, Stored>& contents;
  const Place& file;
  std::string trouble;
};

herr_t list(hid_t root, const char* name, const H5O_info_t* info, void* data) {
  auto& listing = *static_cast<Listing*>(data);
  if (info->type != H5O_TYPE_DATASET) return 0;
  try {  // no exception may cross the library
    const Place place{listing.file.file, name, listing.file.disk};
    const auto dataset = own(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose, "open", place);
    listing.contents.emplace(name, stored_in(dataset.id(), place));
  } catch (const std::exception& error) {
    listing.trouble = error.what();
    return -1;
  }
  return 0;
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : path_(path),
      disk_(std::make_unique<Disk>()),
      file_(own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_through(*disk_).id()), H5Fclose, "open",
                at(""))) {}

Handle InputFile::dataset(const std::string& name) const {
  return own(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "open", at(name));
}

template <class T>
std::vector<T> InputFile::numbers(const std::string& name) const {
  const Place place = at(name);
  const Handle set = dataset(name);
  const Stored stored = stored_in(set.id(), place);
  if (stored.kind != Stored::Kind::integer && stored.kind != Stored::Kind::real)
    throw base::WorldError("read " + name + " of", path_, "it holds no numbers");
  const std::uint64_t count = count_of(stored);
  require_room(count, place);
  std::vector<T> numbers(count);
  if (!numbers.empty())
    require(H5Dread(set.id(), native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), "read", place);
  return numbers;
}

std::vector<double> InputFile::doubles(const std::string& name) const { return numbers<double>(name); }

std::vector<std::int64_t> InputFile::integers(const std::string& name) const {
  return numbers<std::int64_t>(name);
}

std::string InputFile::text(const std::string& name) const {
  const Place place = at(name);
  const Handle set = dataset(name);
  const Stored stored = stored_in(set.id(), place);
  if (stored.kind != Stored::Kind::text || !stored.shape.empty())
    throw base::WorldError("read " + name + " of", path_, "it is no text");
  const auto type = own(H5Dget_type(set.id()), H5Tclose, "describe", place);
  require_room(H5Tget_size(type.id()), place);
  std::string text(H5Tget_size(type.id()), '\0');
  require(H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read", place);
  text.resize(std::min(text.size(), text.find_last_not_of('\0') + 1));
  return text;
}

std::map<std::string, Stored> InputFile::contents() const {
  std::map<std::string, Stored> contents;
  const Place place = at("the contents");
  Listing listing{contents, place, {}};
  if (H5Ovisit2(file_.id(), H5_INDEX_NAME, H5_ITER_INC, list, &listing, H5O_INFO_BASIC) < 0) {
    if (listing.trouble.empty()) fail("list", place);
    throw base::WorldError("list the contents of", path_, listing.trouble);
  }
  return contents;
}

std::uint64_t InputFile::digest(const std::string& name) const {
  const Place place = at(name);
  const Handle set = dataset(name);
  const Stored stored = stored_in(set.id(), place);
  if (stored.kind == Stored::Kind::text && stored.shape.empty()) {
    const std::string words = text(name);
    return XXH3_64bits(words.data(), words.size());
  }
  if (stored.kind == Stored::Kind::other || stored.kind == Stored::Kind::text || stored.shape.empty())
    throw base::WorldError("read " + name + " of", path_, "rift writes no data of this type");
  require_room(count_of(stored), place);
  return stored.kind == Stored::Kind::integer ? digest_of<std::int64_t>(set.id(), stored, place)
                                              : digest_of<double>(set.id(), stored, place);
}

namespace {

/// An attribute of an object, its type and how many values it has; nothing where there is none.
struct Attribute {
  Handle attribute, type;
  hssize_t count;
};

std::optional<Attribute> attribute_of(hid_t file, const std::string& object, const std::string& name,
                                      const Place& place) {
  if (H5Aexists_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) return std::nullopt;
  Handle attribute = own(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "open", place);
  Handle type = own(H5Aget_type(attribute.id()), H5Tclose, "describe", place);
  const auto space = own(H5Aget_space(attribute.id()), H5Sclose, "describe", place);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  return Attribute{std::move(attribute), std::move(type), count};
}

}  // namespace

std::vector<std::int64_t> InputFile::attribute(const std::string& object, const std::string& name) const {
  const Place place = at(object + "@" + name);
  const auto found = attribute_of(file_.id(), object, name, place);
  constexpr hssize_t most = 64;
  if (!found || H5Tget_class(found->type.id()) != H5T_INTEGER || found->count < 0 || found->count > most)
    return {};
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(found->count));
  if (!numbers.empty())
    require(H5Aread(found->attribute.id(), H5T_NATIVE_INT64, numbers.data()), "read", place);
  return numbers;
}

std::string InputFile::text_attribute(const std::string& object, const std::string& name) const {
  const Place place = at(object + "@" + name);
  const auto found = attribute_of(file_.id(), object, name, place);
  constexpr std::size_t most = 4096;
  if (!found || found->count != 1 || H5Tget_class(found->type.id()) != H5T_STRING ||
      H5Tis_variable_str(found->type.id()) != 0 || H5Tget_size(found->type.id()) > most)
    return {};
  std::string text(H5Tget_size(found->type.id()), '\0');
  require(H5Aread(found->attribute.id(), found->type.id(), text.data()), "read", place);
  text.resize(std::min(text.size(), text.find_last_not_of('\0') + 1));
  return text;
}

}  // namespace rift::results::hdf5
