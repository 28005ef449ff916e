#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <vector>

namespace secular {

/// Writes plain HDF5 files for tests.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& path, H5F_libver_t version = H5F_LIBVER_EARLIEST) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, version, version == H5F_LIBVER_EARLIEST ? H5F_LIBVER_LATEST : version);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
  }
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;
  ~Hdf5Writer() { H5Fclose(file_); }

  struct Form {
    hid_t type = H5T_IEEE_F64LE;
    std::vector<hsize_t> chunk{};  ///< empty: not in chunks
    bool deflate = false, shuffle = false, check_sum = false, compact = false, unwritten = false;
    bool bounded = false, early = false;  // the shape is the limit; space for all chunks at once
  };

  void add(const std::string& path, const std::vector<hsize_t>& shape, const std::vector<double>& values) {
    add(path, shape, values, Form{});
  }

  /// Makes the groups that the path names.
  void add(const std::string& path, const std::vector<hsize_t>& shape, const std::vector<double>& values,
           const Form& form) {
    const hid_t links = H5Pcreate(H5P_LINK_CREATE), creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    if (!form.chunk.empty()) H5Pset_chunk(creation, static_cast<int>(form.chunk.size()), form.chunk.data());
    if (form.shuffle) H5Pset_shuffle(creation);
    if (form.deflate) H5Pset_deflate(creation, 6);
    if (form.check_sum) H5Pset_fletcher32(creation);
    if (form.early) H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
    if (form.compact) H5Pset_layout(creation, H5D_COMPACT);
    // Only data sets that may grow can have chunks that are larger than they are.
    const bool grows = !form.chunk.empty() && !form.bounded;
    const std::vector<hsize_t> limits(shape.size(), H5S_UNLIMITED);
    const hid_t space = shape.empty() ? H5Screate(H5S_SCALAR)
                                      : H5Screate_simple(static_cast<int>(shape.size()), shape.data(),
                                                         grows ? limits.data() : nullptr);
    const hid_t set = H5Dcreate2(file_, path.c_str(), form.type, space, links, creation, H5P_DEFAULT);
    if (!form.unwritten) H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
    H5Pclose(links);
    H5Pclose(creation);
  }

  /// A data set in chunks of which but a part is written.
  void add_part(const std::string& path, const std::vector<hsize_t>& shape, Form form,
                const std::vector<hsize_t>& begin, const std::vector<hsize_t>& count,
                const std::vector<double>& values) {
    form.unwritten = form.bounded = true;
    add(path, shape, {}, form);
    write_part(path, begin, count, values);
  }
  void write_part(const std::string& path, const std::vector<hsize_t>& begin, const std::vector<hsize_t>& count,
                  const std::vector<double>& values) {
    const hid_t set = H5Dopen2(file_, path.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    const hid_t memory = H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
  }

  /// A number, or a text of its own length or of any length, beside a data set.
  void add_number(const std::string& set, const std::string& name, double value, std::vector<hsize_t> shape = {}) {
    add_attribute(set, name, H5T_IEEE_F64BE, H5T_NATIVE_DOUBLE, shape, std::vector<double>(8, value).data());
  }
  void add_unit(const std::string& set, const std::string& name, const std::string& text, bool any_length) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, any_length ? H5T_VARIABLE : text.size());
    const char* const pointer = text.c_str();
    add_attribute(set, name, type, type, {}, any_length ? static_cast<const void*>(&pointer) : pointer);
    H5Tclose(type);
  }

  /// How a group keeps its members.
  struct Group {
    bool creation_order = false, compressed = false;
  };

  void add_group(const std::string& path, const Group& form) {
    const hid_t creation = H5Pcreate(H5P_GROUP_CREATE);
    if (form.creation_order) H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    if (form.compressed) H5Pset_deflate(creation, 6);
    H5Gclose(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT));
    H5Pclose(creation);
  }

  /// A further name of an object.
  void add_link(const std::string& object, const std::string& name) {
    H5Lcreate_hard(file_, object.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }

  void add_soft_link(const std::string& object, const std::string& name) {
    H5Lcreate_soft(object.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }

  void remove(const std::string& name) { H5Ldelete(file_, name.c_str(), H5P_DEFAULT); }

  void add_text(const std::string& name, const std::string& text) {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, text.size());
    const hid_t set = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  }

 private:
  void add_attribute(const std::string& set, const std::string& name, hid_t type, hid_t memory,
                     const std::vector<hsize_t>& shape, const void* value) {
    const hid_t object = H5Dopen2(file_, set.c_str(), H5P_DEFAULT);
    const hid_t space = shape.empty() ? H5Screate(H5S_SCALAR)
                                      : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, memory, value);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Dclose(object);
  }

  hid_t file_;
};

}  // namespace secular
