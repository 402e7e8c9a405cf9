#include "engine/results/archive_check.hpp"
#include "engine/results/series.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/memory_file.hpp"

#include <hdf5.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace rift;

/// What a dataset of the archive is to be: its type, its shape and its first values.
struct Plan {
  std::uint8_t type = 0;  // of `types`
  std::vector<hsize_t> shape;
  std::vector<std::int64_t> values;
  bool chunked = false;
};

hid_t type_of(std::uint8_t type) {
  const std::array<hid_t, 6> types{H5T_STD_I64LE, H5T_IEEE_F32LE, H5T_IEEE_F64LE,
                                   H5T_STD_U8LE,  H5T_STD_I32LE,  H5T_STD_U64LE};
  return types[type % types.size()];
}

using Plans = std::map<std::string, Plan>;

/// A sound archive of 4 elements, 3 beams, 2 moments, 2 samples and an event.
Plans sound() {
  Plans plan;
  const auto put = [&](const std::string& name, std::uint8_t type, std::vector<hsize_t> shape,
                       std::vector<std::int64_t> values = {}) {
    plan[name] = {type, std::move(shape), std::move(values)};
  };
  put("VTKHDF/NumberOfPoints", 0, {1}, {4});
  put("VTKHDF/Points", 1, {4, 3});
  const auto cells = [&](const std::string& kind, std::int64_t count, std::int64_t size,
                         const std::vector<std::int64_t>& ids) {
    std::vector<std::int64_t> offsets;
    for (std::int64_t k = 0; k <= count; ++k) offsets.push_back(k * size);
    put("VTKHDF/" + kind + "/NumberOfCells", 0, {1}, {count});
    put("VTKHDF/" + kind + "/NumberOfConnectivityIds", 0, {1}, {static_cast<std::int64_t>(ids.size())});
    put("VTKHDF/" + kind + "/Connectivity", 0, {ids.size()}, ids);
    put("VTKHDF/" + kind + "/Offsets", 0, {offsets.size()}, offsets);
  };
  cells("Vertices", 4, 1, {0, 1, 2, 3});
  cells("Lines", 3, 2, {0, 1, 1, 2, 2, 3});
  cells("Polygons", 0, 0, {});
  cells("Strips", 0, 0, {});
  put("VTKHDF/PointData/radius", 1, {4});
  put("VTKHDF/PointData/displacement", 1, {8, 3});
  put("VTKHDF/CellData/damage_factor", 1, {14});
  put("VTKHDF/Steps/Values", 2, {2});
  put("VTKHDF/Steps/PointDataOffsets/radius", 0, {2});
  put("VTKHDF/Steps/PointDataOffsets/displacement", 0, {2}, {0, 4});
  put("VTKHDF/Steps/CellDataOffsets/damage_factor", 0, {2}, {0, 7});
  for (const char* column : {"step", "time_s", "phase", "lane"}) put(std::string("series/") + column, 0, {2});
  for (const auto& column : results::sample_columns) put(std::string("series/") + column.name, 2, {2});
  for (const auto& column : results::rate_columns) {
    put(std::string("series/") + column.name, 2, {2});
    put(std::string("crack/lane0/") + column.name, 2, {1});
  }
  put("crack/lane0/tip_m", 2, {1});
  for (const char* column : {"beam", "lane"}) put(std::string("events/") + column, 4, {1}, {1});
  for (const auto& column : results::event_columns) put(std::string("events/") + column.name, 2, {1});
  return plan;
}

/// Each change takes a dataset and lies about it.
std::set<std::string> tell_lies(Plans& plan, fuzz::Bytes& input) {
  std::set<std::string> lied;
  for (int lies = 0; lies < 8 && !input.empty(); ++lies) {
    auto chosen = plan.begin();
    std::advance(chosen, input.number<std::uint8_t>() % plan.size());
    lied.insert(chosen->first);
    Plan& p = chosen->second;
    switch (input.number<std::uint8_t>() % 6) {
      case 0:
        p.type = input.number<std::uint8_t>();
        break;
      case 1:  // another length, up to 2^40 rows that were never written
        p.shape.assign(1, hsize_t{1} << (input.number<std::uint8_t>() % 41));
        p.chunked = true;
        break;
      case 2:
        p.shape.assign(input.number<std::uint8_t>() % 4, input.number<std::uint8_t>() % 32);
        break;
      case 3:
        for (std::int64_t& v : p.values) v = input.number<std::int64_t>();
        break;
      case 4:
        if (!p.shape.empty()) p.shape[0] += input.number<std::uint8_t>() % 3 - 1;
        break;
      default:
        plan.erase(chosen);
    }
  }
  return lied;
}

void write(hid_t file, const std::string& name, const Plan& p, hid_t links) {
  const auto rank = static_cast<int>(p.shape.size());
  const hid_t space = rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, p.shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  if (p.chunked && rank == 1 && p.shape[0] > 0) {
    const hsize_t chunk = std::min<hsize_t>(p.shape[0], 1024);
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_deflate(creation, 1);
  }
  hsize_t count = 1;
  for (const hsize_t n : p.shape) count *= n;
  const hid_t set = H5Dcreate2(file, name.c_str(), type_of(p.type), space, links, creation, H5P_DEFAULT);
  if (set >= 0 && count <= 4096) {
    std::vector<std::int64_t> values(p.values);
    values.resize(count);
    if (count > 0) H5Dwrite(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  if (set >= 0) H5Dclose(set);
  H5Pclose(creation);
  H5Sclose(space);
}

void attributes(hid_t file, fuzz::Bytes& input) {
  const auto lie = input.number<std::uint8_t>();
  const hsize_t two = 2 + lie % 3 / 2;
  const std::array<std::int64_t, 3> version{2, lie % 5 == 4, 0};
  const hid_t group = H5Gopen2(file, "VTKHDF", H5P_DEFAULT);
  if (group < 0) return;
  const hid_t space = H5Screate_simple(1, &two, nullptr), scalar = H5Screate(H5S_SCALAR);
  const hid_t number = H5Acreate2(group, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(number, H5T_NATIVE_INT64, version.data());
  H5Aclose(number);
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, lie == 7 ? 10000 : 8);
  const std::string words = "PolyData" + std::string(10000, '\0');
  const hid_t text = H5Acreate2(group, "Type", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(text, type, words.data());
  H5Aclose(text), H5Tclose(type), H5Sclose(space), H5Sclose(scalar), H5Gclose(group);
  const hid_t steps = H5Gopen2(file, "VTKHDF/Steps", H5P_DEFAULT);
  if (steps < 0) return;
  const std::int64_t moments = lie == 9 ? -1 : 2;
  const hid_t one = H5Screate(H5S_SCALAR);
  const hid_t count = H5Acreate2(steps, "NSteps", H5T_STD_I64LE, one, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(count, H5T_NATIVE_INT64, &moments);
  H5Aclose(count), H5Sclose(one), H5Gclose(steps);
}

using Image = std::vector<char>;

Image image_of(hid_t file) {
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) std::abort();
  Image image(static_cast<std::size_t>(size));
  H5Fget_file_image(file, image.data(), image.size());
  return image;
}

/// A file in memory, as an image has it or empty.
hid_t open_in_memory(const Image* image) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 1 << 16, 0);
  if (image) H5Pset_file_image(access, const_cast<char*>(image->data()), image->size());
  const hid_t file =
      image ? H5Fopen("lies", H5F_ACC_RDWR, access) : H5Fcreate("sound", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  H5Pclose(access);
  if (file < 0) std::abort();
  return file;
}

hid_t links() {
  static const hid_t creation = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(creation, 1);
  return creation;
}

Image sound_image(const Plans& plans) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t file = open_in_memory(nullptr);
  for (const auto& [name, plan] : plans) write(file, name, plan, links());
  const Image image = image_of(file);
  H5Fclose(file);
  return image;
}

}  // namespace

// A well-formed HDF5 file that lies about its sizes, types and indices: check_archive() must come to an end
// without an exception, and must not call sound what is not there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Plans whole = sound();
  static const Image start = sound_image(whole);
  static fuzz::MemoryFile memory;
  fuzz::Bytes input = fuzz::bytes_of(data, size);
  Plans plans = whole;
  const std::set<std::string> lied = tell_lies(plans, input);
  const hid_t file = open_in_memory(&start);
  for (const std::string& name : lied) {
    H5Ldelete(file, name.c_str(), H5P_DEFAULT);
    if (const auto plan = plans.find(name); plan != plans.end()) write(file, name, plan->second, links());
  }
  attributes(file, input);
  const Image image = image_of(file);
  H5Fclose(file);
  const results::ArchiveCheck check = results::check_archive(memory.holding({image.data(), image.size()}));
  if (plans.size() < whole.size() && check.problems.empty()) std::abort();
  return 0;
}
