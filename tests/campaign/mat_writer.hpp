#pragma once

#include <matio.h>

#include <filesystem>
#include <string>
#include <vector>

namespace secular {

/// Writes MAT v5 files for tests. Shapes are {rows, columns}.
class MatWriter {
 public:
  explicit MatWriter(const std::filesystem::path& path, mat_ft version = MAT_FT_MAT5)
      : file_(Mat_CreateVer(path.c_str(), "MATLAB 5.0 MAT-file", version)) {}
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;
  ~MatWriter() { Mat_Close(file_); }

  template <class Element>
  static matvar_t* array(const std::string& name, matio_classes type, matio_types storage, std::size_t rows,
                         std::size_t columns, std::vector<Element> values) {
    std::size_t shape[2] = {rows, columns};
    return Mat_VarCreate(name.c_str(), type, storage, 2, shape, values.data(), 0);
  }
  static matvar_t* column(const std::string& name, const std::vector<double>& values) {
    return array(name, MAT_C_DOUBLE, MAT_T_DOUBLE, values.size(), 1, values);
  }
  static matvar_t* row(const std::string& name, const std::vector<double>& values) {
    return array(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 1, values.size(), values);
  }
  static matvar_t* text(const std::string& name, const std::string& value) {
    return array(name, MAT_C_CHAR, MAT_T_UTF8, 1, value.size(), std::vector<char>(value.begin(), value.end()));
  }
  /// A square sparse matrix with ones on its diagonal; matio keeps the pointers until it is written.
  void add_sparse_identity(const std::string& name, mat_uint32_t size, bool compressed = false) {
    std::vector<mat_uint32_t> rows, columns = {0};
    for (mat_uint32_t i = 0; i < size; ++i) {
      rows.push_back(i);
      columns.push_back(i + 1);
    }
    std::vector<double> ones(size, 1);
    mat_sparse_t sparse{};
    sparse.nzmax = sparse.nir = sparse.ndata = size;
    sparse.njc = size + 1;
    sparse.ir = rows.data();
    sparse.jc = columns.data();
    sparse.data = ones.data();
    std::size_t shape[2] = {size, size};
    add(Mat_VarCreate(name.c_str(), MAT_C_SPARSE, MAT_T_DOUBLE, 2, shape, &sparse, MAT_F_DONT_COPY_DATA),
        compressed);
  }
  /// A 1 x count struct array; fields[i * names.size() + f]: field f of element i. Takes the fields over.
  static matvar_t* structure(const std::string& name, std::size_t count, std::vector<const char*> names,
                             const std::vector<matvar_t*>& fields) {
    std::size_t shape[2] = {1, count};
    matvar_t* const made =
        Mat_VarCreateStruct(name.c_str(), 2, shape, names.data(), static_cast<unsigned>(names.size()));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t f = 0; f < names.size(); ++f)
        Mat_VarSetStructFieldByName(made, names[f], i, fields[i * names.size() + f]);
    return made;
  }

  void add(matvar_t* variable, bool compressed = false) {
    Mat_VarWrite(file_, variable, compressed ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }

 private:
  mat_t* file_;
};

}  // namespace secular
