// Campaigns larger than memory: a record is held once, what is not asked for is not read, and inspecting a large
// file looks at its beginning only.

#include <fmt/format.h>

#include <fstream>

#include "measure/data/inspection.hpp"
#include "measure/data/record_data.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/uff_file.hpp"
#include "tests/campaign/append_numbers.hpp"
#include "tests/campaign/hdf5_writer.hpp"
#include "tests/campaign/largest_allocation.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/uff_write.hpp"

namespace secular {
namespace {

constexpr std::size_t rows = 60000, columns = 3;
constexpr InspectionLimit small_limit{1 << 16, 3000, 1000};

double value(std::size_t i, std::size_t c) {
  return static_cast<double>((i * (c + 7)) % 997) - 498;
}

std::vector<double> signal(std::size_t c) {
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < rows; ++i) values[i] = c == 0 ? 0.01 * static_cast<double>(i) : value(i, c);
  return values;
}

class Streaming : public TemporaryFolder {
 protected:
  std::filesystem::path csv(const std::string& name) const {
    std::string text = "t,a,b\n";
    for (std::size_t i = 0; i < rows; ++i)
      text += fmt::format("{},{},{}\n", 0.01 * static_cast<double>(i), value(i, 1), value(i, 2));
    return write(name, text);
  }

  std::filesystem::path universal(UffEncoding encoding) const {
    std::vector<UffFunction> functions;
    for (std::size_t c = 1; c < columns; ++c) {
      UffFunction function;
      function.id_lines[0] = c == 1 ? "a" : "b";
      function.rate = 100;
      function.abscissa = {17, 0, 0, 0, "Time", "s"};
      function.numerator = {12, 0, 0, 0, "Acceleration", "m/s^2"};
      function.real = signal(c);
      functions.push_back(function);
    }
    return write(fmt::format("{}.uff", static_cast<int>(encoding)), uff_text(functions, encoding));
  }

  std::filesystem::path wav() const {
    std::string bytes = "RIFF";
    append_unsigned(bytes, 36 + 4 * rows, 4, ByteOrder::little);
    bytes += "WAVEfmt ";
    for (const auto& [number, size] : std::vector<std::pair<std::uint64_t, std::size_t>>{
             {16, 4}, {1, 2}, {2, 2}, {100, 4}, {400, 4}, {4, 2}, {16, 2}})
      append_unsigned(bytes, number, size, ByteOrder::little);
    bytes += "data";
    append_unsigned(bytes, 4 * rows, 4, ByteOrder::little);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t c = 1; c < columns; ++c)
        append_unsigned(bytes, static_cast<std::uint16_t>(static_cast<int>(value(i, c))), 2, ByteOrder::little);
    return write("a.wav", bytes);
  }

  std::filesystem::path mat(bool compressed) const {
    const std::filesystem::path path = folder_ / (compressed ? "z.mat" : "a.mat");
    MatWriter writer(path);
    for (std::size_t c = 0; c < columns; ++c)
      writer.add(MatWriter::column(c == 0 ? "t" : c == 1 ? "a" : "b", signal(c)), compressed);
    return path;
  }

  std::filesystem::path hdf5(bool chunked) const {
    const std::filesystem::path path = folder_ / (chunked ? "c.h5" : "a.h5");
    Hdf5Writer writer(path);
    Hdf5Writer::Form form;
    if (chunked) form.chunk = {1000};
    form.deflate = chunked;
    for (std::size_t c = 0; c < columns; ++c)
      writer.add(c == 0 ? "t" : c == 1 ? "a" : "b", {rows}, signal(c), form);
    return path;
  }

  std::vector<std::filesystem::path> every_format() const {
    return {csv("a.csv"),
            universal(UffEncoding::ascii),
            universal(UffEncoding::little_endian),
            wav(),
            mat(false),
            mat(true),
            hdf5(false),
            hdf5(true)};
  }
};

TEST_F(Streaming, TheFirstValuesOfEveryFormat) {
  for (const std::filesystem::path& path : every_format()) {
    const DataFile whole = read_data_file(path), part = read_data_file(path, {}, MissingNumbers::refuse, 250);
    EXPECT_FALSE(whole.partial) << path;
    EXPECT_TRUE(part.partial) << path;
    ASSERT_EQ(part.variables.size(), columns) << path;
    for (std::size_t c = 0; c < columns; ++c) {
      const std::vector<double>&all = whole.variables[c].values, &few = part.variables[c].values;
      ASSERT_EQ(all.size(), rows) << path;
      ASSERT_GE(few.size(), 250u) << path;
      ASSERT_LE(few.size(), 260u) << path;  // up to the end of a line
      EXPECT_TRUE(std::equal(few.begin(), few.end(), all.begin())) << path;
    }
  }
}

TEST_F(Streaming, InspectingALargeFileAllocatesLittle) {
  for (const std::filesystem::path& path : every_format()) {
    const bool compressed = path.filename() == "z.mat";  // a variable is inflated to check it
    inspect_file(path, small_limit);
    take_largest_allocation();
    const FileInspection file = inspect_file(path, small_limit);
    EXPECT_LT(take_largest_allocation(), compressed ? 2 * 8 * rows : rows) << path;
    EXPECT_TRUE(file.partial) << path;
    EXPECT_FALSE(file.estimated) << path;
    for (const VariableInspection& variable : file.variables) {
      ASSERT_TRUE(variable.quality) << path;
      EXPECT_LE(variable.quality->samples, 1010u) << path;
      std::size_t count = 1;
      for (const std::size_t length : variable.shape) count *= length;
      EXPECT_EQ(count, rows) << path << " " << variable.name;
    }
  }
}

TEST_F(Streaming, TheLengthOfACsvThatIsNotReadIsSaidToBeAnEstimate) {
  std::string text = "x,a\n";
  for (std::size_t i = 0; i < rows; ++i) text += fmt::format("{},{}\n", value(i, 1), value(i, 2));
  const FileInspection file = inspect_file(write("a.csv", text), small_limit);
  EXPECT_TRUE(file.partial);
  EXPECT_TRUE(file.estimated);
  EXPECT_NEAR(static_cast<double>(file.variables[0].shape[0]), rows, 0.02 * rows);
}

TEST_F(Streaming, AnEndThatDoesNotFitTheBeginningIsAFault) {
  csv("a.csv");
  write("a.csv", read("a.csv") + "1.5,0,0\n");
  const FileInspection file = inspect_file(folder_ / "a.csv", small_limit);
  ASSERT_EQ(file.faults.size(), 1u);
  EXPECT_TRUE(contains(file.faults[0].text, "the last stamp, 1.5 s"));
  EXPECT_TRUE(file.estimated);
}

TEST_F(Streaming, ARecordIsHeldOnce) {
  csv("1.csv");
  std::filesystem::copy(folder_ / "1.csv", folder_ / "2.csv");
  write("campaign.toml", R"(schema = 1
name = "long"
sample_rate_hz = 100.0
channel = [{ name = "a", role = "response", quantity = "acceleration", unit = "m/s^2" },
           { name = "b", role = "response", quantity = "acceleration", unit = "m/s^2" }]
record = [{ file = "1.csv", kind = "free_decay" }, { file = "2.csv", kind = "free_decay" }]
)");
  const Campaign campaign = read_campaign(folder_);
  take_largest_allocation();
  take_allocated_peak();
  for (const RecordEntry& entry : campaign.records) EXPECT_EQ(read_record(campaign, entry).samples(), rows);
  // One column at a time, never the text, and no more than the columns and the steps of the clock (twice) together.
  EXPECT_LE(take_largest_allocation(), 8 * rows + 64);
  EXPECT_LE(take_allocated_peak(), (columns + 2) * 8 * rows + (1 << 16));
  const std::vector<RecordInspection> part = inspect_records(campaign, small_limit);
  ASSERT_EQ(part.size(), 2u);
  for (const RecordInspection& record : part) {
    EXPECT_EQ(record.samples, rows);
    EXPECT_EQ(record.judged, 1000u);
    EXPECT_FALSE(record.estimated);
    EXPECT_TRUE(record.faults.empty());
  }
  for (const RecordInspection& record : inspect_records(campaign)) EXPECT_EQ(record.judged, rows);
}

}  // namespace
}  // namespace secular
