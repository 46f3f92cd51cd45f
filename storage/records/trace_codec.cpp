#include "storage/records/trace_codec.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <memory>

#include "storage/base/sodium.h"

namespace cusp::storage {
namespace {

constexpr std::size_t kTraceSeal = 16;  // bytes of BLAKE2b in front
constexpr std::byte kTraceFormat{1};    // after the seal
constexpr int kFields = 12;
constexpr int kQuickLevel = 1;
constexpr int kLevel = 9;                // compresses 1 s of inputs in under a millisecond
constexpr std::size_t kMostVarint = 10;  // bytes of 64 bits in groups of 7

using InputColumns = std::array<std::int64_t, kFields>;

InputColumns columns_of(const StepInput& in) noexcept {
  return {in.x, in.y, in.z, in.qx, in.qy, in.qz, in.qw, in.buttons, in.pedal, in.bur, in.fragment, in.elapsed_us};
}

/// False when a value does not fit its field.
bool input_of(const InputColumns& c, StepInput& out) noexcept {
  const auto put = [](std::int64_t value, auto& field) {
    field = static_cast<std::remove_reference_t<decltype(field)>>(value);
    return static_cast<std::int64_t>(field) == value;
  };
  return put(c[0], out.x) && put(c[1], out.y) && put(c[2], out.z) && put(c[3], out.qx) && put(c[4], out.qy) &&
         put(c[5], out.qz) && put(c[6], out.qw) && put(c[7], out.buttons) && put(c[8], out.pedal) &&
         put(c[9], out.bur) && put(c[10], out.fragment) && put(c[11], out.elapsed_us);
}

/// Positions are predicted on a straight line, because the device moves smoothly; all other fields as unchanged.
constexpr bool predicts_line(int field) noexcept { return field < 3; }

void put_varint(std::vector<std::byte>& out, std::uint64_t value) {
  while (value >= 0x80) {
    out.push_back(static_cast<std::byte>(value | 0x80));
    value >>= 7;
  }
  out.push_back(static_cast<std::byte>(value));
}

struct Cursor {
  std::span<const std::byte> bytes;
  bool good = true;
  std::uint64_t varint() noexcept {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < kMostVarint; ++i) {
      if (bytes.empty()) break;
      const auto byte = std::to_integer<std::uint64_t>(bytes.front());
      bytes = bytes.subspan(1);
      value |= (byte & 0x7f) << (7 * i);
      if (byte < 0x80) return value;
    }
    good = false;
    return 0;
  }
};

constexpr std::uint64_t zigzag(std::int64_t value) noexcept {
  return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}
constexpr std::int64_t unzigzag(std::uint64_t value) noexcept {
  return static_cast<std::int64_t>(value >> 1 ^ (~(value & 1) + 1));
}

std::array<std::byte, kTraceSeal> seal_of(std::span<const std::byte> bytes) {
  ready_sodium();
  std::array<std::byte, kTraceSeal> seal{};
  crypto_generichash(reinterpret_cast<unsigned char*>(seal.data()), seal.size(),
                     reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), nullptr, 0);
  return seal;
}

std::unexpected<StorageFailure> bad(const char* detail) { return fail(StorageError::bad_trace, "trace", detail); }

}  // namespace

std::vector<std::byte> pack(std::span<const std::byte> bytes, Packing packing) {
  std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context{ZSTD_createCCtx(), ZSTD_freeCCtx};
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, packing == Packing::quick ? kQuickLevel : kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  const std::size_t size = ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size());
  assert(!ZSTD_isError(size));  // `out` has the bound's size and the parameters are valid
  out.resize(size);
  return out;
}

Stored<std::vector<std::byte>> unpack(std::span<const std::byte> bytes) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR || size > kMostUnpackedBytes) {
    return bad("frame");
  }
  if (ZSTD_findFrameCompressedSize(bytes.data(), bytes.size()) != bytes.size()) return bad("length");
  std::vector<std::byte> out(size);
  // One a thread: a context takes 160 kB, and making it takes longer than unpacking a small row.
  thread_local const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context{ZSTD_createDCtx(), ZSTD_freeDCtx};
  if (!context) return bad("content");
  const std::size_t got = ZSTD_decompressDCtx(context.get(), out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) || got != size) return bad("content");
  return out;
}

std::vector<std::byte> encode_trace(std::span<const StepInput> inputs) {
  assert(inputs.size() <= kMostInputsPerChunk);
  std::vector<std::byte> plain;
  plain.reserve(inputs.size() * kFields + kMostVarint);
  put_varint(plain, inputs.size());
  for (int field = 0; field < kFields; ++field) {
    std::int64_t last = 0, slope = 0;
    for (const StepInput& input : inputs) {
      const std::int64_t value = columns_of(input)[static_cast<std::size_t>(field)];
      put_varint(plain, zigzag(value - last - slope));
      if (predicts_line(field)) slope = value - last;
      last = value;
    }
  }
  const std::vector<std::byte> packed = pack(plain);
  std::vector<std::byte> out(kTraceSeal + 1 + packed.size(), kTraceFormat);
  std::ranges::copy(packed, out.begin() + kTraceSeal + 1);
  const auto seal = seal_of(std::span{out}.subspan(kTraceSeal));
  std::ranges::copy(seal, out.begin());
  return out;
}

Stored<std::vector<StepInput>> decode_trace(std::span<const std::byte> bytes) {
  if (bytes.size() <= kTraceSeal) return bad("length");
  const auto body = bytes.subspan(kTraceSeal);
  if (!std::ranges::equal(seal_of(body), bytes.first(kTraceSeal))) return bad("seal");
  if (body.front() != kTraceFormat) return bad("format");
  const auto plain = unpack(body.subspan(1));
  if (!plain) return std::unexpected(plain.error());
  Cursor cursor{*plain};
  const std::uint64_t count = cursor.varint();
  if (!cursor.good || count > kMostInputsPerChunk || count * kFields > cursor.bytes.size()) return bad("count");
  std::vector<InputColumns> rows(count);
  for (int field = 0; field < kFields; ++field) {
    std::int64_t last = 0, slope = 0;
    for (InputColumns& row : rows) {
      // Unsigned: a forged difference cannot overflow.
      const auto value =
          static_cast<std::int64_t>(static_cast<std::uint64_t>(last) + static_cast<std::uint64_t>(slope) +
                                    static_cast<std::uint64_t>(unzigzag(cursor.varint())));
      if (!cursor.good || value > INT64_C(0xFFFFFFFF) || value < INT32_MIN) return bad("value");
      if (predicts_line(field)) slope = value - last;
      last = value;
      row[static_cast<std::size_t>(field)] = value;
    }
  }
  if (!cursor.bytes.empty()) return bad("length");
  std::vector<StepInput> inputs(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!input_of(rows[i], inputs[i])) return bad("value");
  }
  return inputs;
}

}  // namespace cusp::storage
