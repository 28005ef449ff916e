// Damaged universal and WAV files: whatever the bytes, the outcome is success or an InputError.

#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/uff_file.hpp"
#include "tests/campaign/append_numbers.hpp"
#include "tests/campaign/mutation.hpp"
#include "tests/campaign/uff_write.hpp"

namespace secular {
namespace {

class DamagedFile : public Mutation {
 protected:
  void use(const std::string& name) const {
    inspect_file(folder_ / name);
    for (const DataVariable& variable : read_data_file(folder_ / name).variables)
      ASSERT_EQ(variable.values.size(), variable.fault.empty() ? variable.shape.at(0) : 0u) << variable.name;
  }
  void damage(const std::string& name, const std::string& valid) {
    run(name, valid, 4000, [&] { use(name); });
  }
  void refuse_every_shorter(const std::string& name, const std::string& valid, std::size_t longest) {
    for (std::size_t length = 0; length < longest; ++length) {
      write(name, valid.substr(0, length));
      EXPECT_THROW(use(name), InputError) << length << " of " << valid.size();
    }
  }
};

std::string universal(UffEncoding encoding) {
  std::vector<UffFunction> made;
  for (const bool even : {true, false})
    for (const UffOrdinate type :
         {UffOrdinate::real_single, UffOrdinate::real_double, UffOrdinate::complex_double}) {
      UffFunction function;
      function.id_lines[0] = "channel " + std::to_string(made.size());
      function.ordinate = type;
      function.even = even;
      function.rate = 100;
      function.abscissa = {17, 0, 0, 0, "Time", "s"};
      function.numerator = {12, 0, 0, 0, "Acceleration", "g"};
      for (int i = 0; i < 5; ++i) {
        if (!even) function.uneven_abscissa.push_back(0.01 * i);
        function.real.push_back(0.5 * i);
        if (is_complex(type)) function.imaginary.push_back(i);
      }
      made.push_back(function);
    }
  return uff_text(made, encoding);
}

TEST_F(DamagedFile, UniversalAscii) {
  const std::string valid = universal(UffEncoding::ascii);
  damage("a.uff", valid);
  EXPECT_GT(accepted_, 50);
  // Whole data sets are a whole file: only the last of them is cut.
  const std::size_t last = valid.rfind("    58\n");
  for (std::size_t length = last; length + 1 < valid.size(); ++length) {
    write("a.uff", valid.substr(0, length));
    EXPECT_THROW(use("a.uff"), InputError) << length;
  }
}

TEST_F(DamagedFile, UniversalBinary) {
  for (const UffEncoding encoding : {UffEncoding::little_endian, UffEncoding::big_endian}) {
    const std::string valid = universal(encoding);
    damage("a.uff", valid);
    const std::size_t last = valid.rfind("    58b");
    for (std::size_t length = last; length + 1 < valid.size(); ++length) {
      write("a.uff", valid.substr(0, length));
      EXPECT_THROW(use("a.uff"), InputError) << length;
    }
  }
}

TEST_F(DamagedFile, Wav) {
  std::string samples, format;
  for (int i = 0; i < 20; ++i) append_unsigned(samples, static_cast<std::uint64_t>(i * 100), 2, ByteOrder::little);
  for (const auto& [value, size] :
       std::vector<std::pair<std::uint64_t, std::size_t>>{{1, 2}, {2, 2}, {1000, 4}, {4000, 4}, {4, 2}, {16, 2}})
    append_unsigned(format, value, size, ByteOrder::little);
  std::string valid = "RIFF";
  append_unsigned(valid, 36 + samples.size(), 4, ByteOrder::little);
  valid += "WAVEfmt ";
  append_unsigned(valid, 16, 4, ByteOrder::little);
  valid += format + "data";
  append_unsigned(valid, samples.size(), 4, ByteOrder::little);
  valid += samples;
  damage("a.wav", valid);
  EXPECT_GT(accepted_, 50);
  refuse_every_shorter("a.wav", valid, valid.size());
}

}  // namespace
}  // namespace secular
