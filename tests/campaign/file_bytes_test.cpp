#include "measure/formats/file_bytes.hpp"

#include "measure/formats/mapped_file.hpp"
#include "tests/campaign/append_numbers.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

TEST(Text, WhatIsNoUtf8IsLatin1) {
  for (const char* const text : {"", "m/s^2", "m/s²", "µm", "€", "\xF0\x9F\x98\x80"})
    EXPECT_EQ(as_utf8(text), text);
  EXPECT_EQ(as_utf8("m/s\xB2"), "m/s²");
  EXPECT_EQ(as_utf8("\xB5m"), "µm");
  for (const std::string text :
       {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xFF", "\xE0\x9F\x80"})
    EXPECT_NE(as_utf8(text), text);
}

TEST(StoredNumbers, BothByteOrders) {
  const std::string bytes("\x01\x02\x03\xFF", 4);
  EXPECT_EQ(unsigned_at(bytes, 0, 3, ByteOrder::little), 0x030201u);
  EXPECT_EQ(unsigned_at(bytes, 0, 3, ByteOrder::big), 0x010203u);
  EXPECT_EQ(signed_at(bytes, 2, 2, ByteOrder::little), -253);
  EXPECT_EQ(signed_at(bytes, 3, 1, ByteOrder::big), -1);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
    for (const std::size_t size : {4u, 8u}) {
      std::string stored;
      append_float(stored, -0.15625, size, order);
      EXPECT_EQ(float_at(stored, 0, size, order), -0.15625);
    }
}

class FileBytes : public TemporaryFolder {};

TEST_F(FileBytes, AreAllOrAComplaint) {
  EXPECT_EQ(MappedFile(write("a", std::string("a\0b", 3))).bytes(), std::string("a\0b", 3));
  EXPECT_EQ(some_bytes(folder_ / "a", 2), std::string("a\0", 2));
  EXPECT_EQ(some_bytes(folder_ / "none", 2), "");
  EXPECT_TRUE(contains(refusal([&] { MappedFile file(folder_); }), "is a folder"));
  EXPECT_TRUE(contains(refusal([&] { MappedFile file(folder_ / "none"); }), "cannot be opened"));
}

}  // namespace
}  // namespace secular
