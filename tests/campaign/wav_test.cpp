#include "measure/formats/wav_file.hpp"
#include "tests/campaign/append_numbers.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/variable_names.hpp"

namespace secular {
namespace {

using Numbers = std::vector<double>;

constexpr std::uint64_t pcm = 1, floating_point = 3, extensible = 0xFFFE;

void append(std::string& bytes, std::uint64_t value, std::size_t size) {
  append_unsigned(bytes, value, size, ByteOrder::little);
}

struct WavForm {
  std::uint64_t coding = pcm, channels = 1, rate = 1000, bits = 16;
};

std::string wav(const WavForm& form, const std::string& samples) {
  std::string format;
  append(format, form.coding, 2);
  append(format, form.channels, 2);
  append(format, form.rate, 4);
  append(format, form.rate * form.channels * form.bits / 8, 4);
  append(format, form.channels * form.bits / 8, 2);
  append(format, form.bits, 2);
  if (form.coding == extensible) {
    append(format, 22, 2);
    append(format, form.bits, 2);
    append(format, 0, 4);
    append(format, pcm, 2);
    format += std::string(14, '\0');
  }
  std::string bytes = "RIFF";
  append(bytes, 4 + 8 + 5 + 1 + 8 + format.size() + 8 + samples.size(), 4);
  bytes += "WAVE";
  bytes += std::string("LIST\5\0\0\0abcde\0", 14);  // odd chunks are filled up
  bytes += "fmt ";
  append(bytes, format.size(), 4);
  bytes += format + "data";
  append(bytes, samples.size(), 4);
  return bytes + samples;
}

class Wav : public TemporaryFolder {
 protected:
  DataFile read(const WavForm& form, const std::string& samples) const {
    return read_data_file(write("a.wav", wav(form, samples)));
  }
};

TEST_F(Wav, IntegersAreFractionsOfFullScale) {
  EXPECT_EQ(read({pcm, 1, 1000, 16}, std::string("\0\x40\0\x80", 4)).vector("channel 1").values,
            (Numbers{0.5, -1}));
  EXPECT_EQ(read({pcm, 1, 1000, 24}, std::string("\0\0\x40\0\0\x80", 6)).vector("channel 1").values,
            (Numbers{0.5, -1}));
  EXPECT_EQ(read({pcm, 1, 1000, 32}, std::string("\0\0\0\x40\0\0\0\x80", 8)).vector("channel 1").values,
            (Numbers{0.5, -1}));
  EXPECT_EQ(read({pcm, 1, 1000, 8}, std::string("\xC0\0", 2)).vector("channel 1").values, (Numbers{0.5, -1}));
  EXPECT_EQ(read({extensible, 1, 1000, 16}, std::string("\0\x40", 2)).vector("channel 1").values, Numbers{0.5});
}

TEST_F(Wav, FloatingPointAndSeveralChannels) {
  std::string samples;
  for (const double value : {0.5, -2.0, 0.25, 4.0}) append_float(samples, value, 4, ByteOrder::little);
  const DataFile data = read({floating_point, 2, 44100, 32}, samples);
  EXPECT_EQ(data.format, "WAV");
  EXPECT_EQ(data.vector("channel 1").values, (Numbers{0.5, 0.25}));
  EXPECT_EQ(data.vector("channel 2").values, (Numbers{-2, 4}));
  EXPECT_EQ(data.vector("t").values, (Numbers{0, 1.0 / 44100}));
  EXPECT_EQ(data_variable_names(folder_ / "a.wav"), (std::vector<std::string>{"t", "channel 1", "channel 2"}));
}

TEST_F(Wav, IsImportedWithTheUnitsTheOptionsGive) {
  ImportOptions options;
  options.files = {write("a.wav", wav({pcm, 1, 8000, 16}, std::string("\0\x40\0\x80\0\x20", 6)))};
  options.kind = "free_decay";
  for (const char* channel : {"tip=channel 1:response", "tip=channel 1:response:voltage:V"}) {
    options.channels = {channel};
    EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "give --channel NAME:ROLE:QUANTITY:UNIT:FACTOR"));
  }
  options.channels = {"tip=channel 1:response:voltage:mV:4000"};
  const ImportedFiles imported = import_files(options);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 8000);
  EXPECT_EQ(imported.campaign.channels[0].unit, "V");
  EXPECT_EQ(imported.samples[0].channels[0], (Numbers{2, -4, 1}));
}

// A recorder that writes into a pipe cannot go back to fill in sizes.
TEST_F(Wav, AStreamGoesToTheEndOfTheFile) {
  for (const std::string& size : {std::string(4, '\0'), std::string(4, '\xFF')})
    for (const std::size_t cut : {0U, 1U}) {
      std::string bytes = wav({pcm, 1, 1000, 16}, std::string("\0\x40\0\x80\0\x20", 6));
      bytes.replace(4, 4, size);
      bytes.replace(bytes.size() - 10, 4, size);
      bytes += std::string(cut, '\1');  // the begin of a sample
      EXPECT_EQ(read_data_file(write("a.wav", bytes)).vector("channel 1").values, (Numbers{0.5, -1, 0.25}));
    }
  // A size that the file as a whole states is meant.
  std::string bytes = wav({pcm, 1, 1000, 16}, std::string("\0\x40", 2));
  bytes.replace(bytes.size() - 6, 4, std::string(4, '\xFF'));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(write("a.wav", bytes)); }), "bytes are announced"));
}

TEST_F(Wav, ComplaintsNameThePlace) {
  const auto complaint = [&](const std::string& bytes) {
    return refusal([&] { read_data_file(write("a.wav", bytes)); });
  };
  const std::string valid = wav({}, std::string("\0\x40\0\x80", 4));
  EXPECT_TRUE(contains(complaint(""), "not the begin of a WAV file"));
  EXPECT_TRUE(contains(complaint(valid.substr(0, valid.size() - 1)), "4 bytes are announced, 3 follow"));
  EXPECT_TRUE(contains(complaint(valid.substr(0, 30)), "has no data"));
  EXPECT_TRUE(contains(complaint(wav({}, "abc")), "end inside of a sample"));
  EXPECT_TRUE(contains(complaint(wav({2, 1, 1000, 4}, "ab")), "coding 2 with 4 bits is not read"));
  EXPECT_TRUE(contains(complaint(wav({pcm, 0, 1000, 16}, "ab")), "no channels"));
  EXPECT_TRUE(contains(complaint(wav({pcm, 1, 0, 16}, "ab")), "sample rate is zero"));
}

}  // namespace
}  // namespace secular
