#include "tests/scenarios/import/packed_dicom.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace cusp::test {
namespace {

std::string pack_bits(const std::string& bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t run = 1;
    while (run < 128 && i + run < bytes.size() && bytes[i + run] == bytes[i]) ++run;
    if (run > 1) {
      out += static_cast<char>(257 - run);
      out += bytes[i];
    } else {
      out += '\0';
      out += bytes[i];
    }
    i += run;
  }
  if (out.size() % 2 != 0) out += '\0';
  return out;
}

/// Most significant bit first; after a byte of ones comes one of zeros.
class BitWriter {
 public:
  void put(std::uint32_t bits, int count) {
    for (int i = count - 1; i >= 0; --i) {
      byte_ = byte_ << 1 | (bits >> i & 1u);
      if (++filled_ == 8) flush();
    }
  }
  std::string end() {
    while (filled_ != 0) put(1, 1);
    return out_;
  }

 private:
  void flush() {
    out_ += static_cast<char>(byte_);
    if (byte_ == 0xff) out_ += '\0';
    byte_ = 0;
    filled_ = 0;
  }
  std::string out_;
  std::uint32_t byte_ = 0;
  int filled_ = 0;
};

void big16(std::string& out, unsigned v) {
  out += static_cast<char>(v >> 8 & 0xff);
  out += static_cast<char>(v & 0xff);
}

}  // namespace

std::string rle_frame(const std::vector<std::int16_t>& values) {
  std::string upper, lower;
  for (const std::int16_t v : values) {
    upper += static_cast<char>(static_cast<std::uint16_t>(v) >> 8);
    lower += static_cast<char>(v & 0xff);
  }
  const std::string first = pack_bits(upper), second = pack_bits(lower);
  std::string out(64, '\0');
  const auto put32 = [&](std::size_t at, std::size_t v) {
    for (std::size_t i = 0; i < 4; ++i) out[at + i] = static_cast<char>(v >> 8 * i & 0xff);
  };
  put32(0, 2);
  put32(4, 64);
  put32(8, 64 + first.size());
  return out + first + second;
}

std::string jpeg_lossless_frame(const std::vector<std::int16_t>& values, int columns, int rows) {
  std::string out("\xff\xd8\xff\xc3", 4);  // SOI, SOF3
  big16(out, 11);
  out += '\x10';  // bits a pixel
  big16(out, static_cast<unsigned>(rows));
  big16(out, static_cast<unsigned>(columns));
  out += std::string("\x01\x01\x11\x00", 4);
  out += std::string("\xff\xc4", 2);  // DHT: the seventeen sizes of a difference, all with codes of five bits
  big16(out, 2 + 1 + 16 + 17);
  out += '\0';
  for (int length = 1; length <= 16; ++length) out += length == 5 ? '\x11' : '\0';
  for (int size = 0; size <= 16; ++size) out += static_cast<char>(size);
  out += std::string("\xff\xda\x00\x08\x01\x01\x00\x01\x00\x00", 10);  // SOS: predictor 1
  BitWriter bits;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto at = static_cast<std::size_t>(y * columns + x);
      const auto pixel = [&](std::size_t i) { return static_cast<std::int32_t>(static_cast<std::uint16_t>(values[i])); };
      const std::int32_t guess = x > 0 ? pixel(at - 1) : y > 0 ? pixel(at - static_cast<std::size_t>(columns)) : 1 << 15;
      // Modulo 2^16, between -32767 and 32768.
      std::int32_t d = (pixel(at) - guess) & 0xffff;
      if (d > 32768) d -= 65536;
      const int size = std::bit_width(static_cast<std::uint32_t>(std::abs(d)));
      bits.put(static_cast<std::uint32_t>(size), 5);
      if (size < 16) bits.put(static_cast<std::uint32_t>(d >= 0 ? d : d + (1 << size) - 1), size);
    }
  }
  out += bits.end() + std::string("\xff\xd9", 2);
  if (out.size() % 2 != 0) out += '\0';
  return out;
}

}  // namespace cusp::test
