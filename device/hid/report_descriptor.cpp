#include "device/hid/report_descriptor.h"

#include <algorithm>

namespace cusp::device::hid {

namespace {

constexpr std::size_t kMostNested = 32;      // collections, and pushes
constexpr std::size_t kMostFields = 1024;
constexpr std::uint32_t kMostBits = 4096 * 8;  // of a report
constexpr std::uint32_t kMostUsages = 1024;    // named one by one for one main item

// Item tags with their type, as the first byte without its two size bits.
enum Item : std::uint8_t {
  kInput = 0x80,
  kCollection = 0xA0,
  kEndCollection = 0xC0,
  kUsagePage = 0x04,
  kLogicalLeast = 0x14,
  kLogicalMost = 0x24,
  kReportSize = 0x74,
  kReportNumber = 0x84,
  kReportCount = 0x94,
  kPush = 0xA4,
  kPop = 0xB4,
  kUsage = 0x08,
  kUsageLeast = 0x18,
  kUsageMost = 0x28,
  kLong = 0xFE,
};
constexpr std::uint32_t kConstant = 1, kVariable = 2, kRelative = 4;  // of an input item

struct Globals {
  std::uint16_t page = 0;
  std::int32_t least = 0, most = 0;
  std::uint32_t most_unsigned = 0;  // the same bytes, for makers who forget that they are signed
  std::uint32_t bits = 0, count = 0;
  std::uint8_t report = 0;
};

struct Locals {
  std::vector<std::uint32_t> usages;  // page in the upper half where the item names one
  std::optional<std::uint32_t> least, most;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  Result<ReportDescriptor, DescriptorFailure> read() {
    while (at_ < bytes_.size()) {
      const std::size_t begun = at_;
      const std::uint8_t head = bytes_[at_++];
      if (head == kLong) {
        if (bytes_.size() - at_ < 2 || bytes_.size() - at_ - 2 < bytes_[at_]) return bad(DescriptorError::cut_off, begun);
        at_ += 2u + bytes_[at_];
        continue;
      }
      const std::size_t size = (head & 3) == 3 ? 4 : head & 3;
      if (bytes_.size() - at_ < size) return bad(DescriptorError::cut_off, begun);
      std::uint32_t data = 0;
      for (std::size_t i = 0; i < size; ++i) data |= static_cast<std::uint32_t>(bytes_[at_ + i]) << (8 * i);
      at_ += size;
      if (const auto error = item(head & 0xFC, data, size)) return bad(*error, begun);
    }
    if (depth_ != 0) return bad(DescriptorError::nesting, bytes_.size());
    for (std::size_t i = 0; i < bits_.size(); ++i) out_.bytes[i] = static_cast<std::uint16_t>((bits_[i] + 7) / 8);
    return std::move(out_);
  }

 private:
  static std::unexpected<DescriptorFailure> bad(DescriptorError code, std::size_t at) {
    return std::unexpected(DescriptorFailure{code, at});
  }
  static std::int32_t signed_of(std::uint32_t data, std::size_t size) noexcept {
    if (size == 1) return static_cast<std::int8_t>(data);
    if (size == 2) return static_cast<std::int16_t>(data);
    return static_cast<std::int32_t>(data);
  }

  std::optional<DescriptorError> item(std::uint8_t tag, std::uint32_t data, std::size_t size) {
    switch (tag) {
      case kUsagePage: globals_.page = static_cast<std::uint16_t>(data); break;
      case kLogicalLeast: globals_.least = signed_of(data, size); break;
      case kLogicalMost:
        globals_.most = signed_of(data, size);
        globals_.most_unsigned = data;
        break;
      case kReportSize: globals_.bits = data; break;
      case kReportCount: globals_.count = data; break;
      case kReportNumber:
        if (data == 0 || data > 255) return DescriptorError::report_number;
        globals_.report = static_cast<std::uint8_t>(data);
        out_.numbered = true;
        break;
      case kPush:
        if (pushed_.size() >= kMostNested) return DescriptorError::nesting;
        pushed_.push_back(globals_);
        break;
      case kPop:
        if (pushed_.empty()) return DescriptorError::nesting;
        globals_ = pushed_.back();
        pushed_.pop_back();
        break;
      case kUsage:
        if (locals_.usages.size() >= kMostUsages) return DescriptorError::size;
        locals_.usages.push_back(size == 4 ? data : static_cast<std::uint32_t>(globals_.page) << 16 | data);
        break;
      case kUsageLeast: locals_.least = size == 4 ? data : static_cast<std::uint32_t>(globals_.page) << 16 | data; break;
      case kUsageMost: locals_.most = size == 4 ? data : static_cast<std::uint32_t>(globals_.page) << 16 | data; break;
      case kCollection:
        if (depth_ >= kMostNested) return DescriptorError::nesting;
        if (depth_++ == 0 && !named_ && !locals_.usages.empty()) {
          named_ = true;
          out_.page = static_cast<std::uint16_t>(locals_.usages.front() >> 16);
          out_.usage = static_cast<std::uint16_t>(locals_.usages.front());
        }
        locals_ = {};
        break;
      case kEndCollection:
        if (depth_ == 0) return DescriptorError::nesting;
        --depth_;
        locals_ = {};
        break;
      case kInput: {
        const auto error = input(data);
        locals_ = {};
        return error;
      }
      default:
        if ((tag & 0x0C) == 0) locals_ = {};  // outputs and features end a main item's names too
        break;
    }
    return std::nullopt;
  }

  /// The usage of the i-th value: the named ones in turn, the last again for the rest, else a run.
  std::uint32_t usage_of(std::uint32_t i) const noexcept {
    if (!locals_.usages.empty()) return locals_.usages[std::min<std::size_t>(i, locals_.usages.size() - 1)];
    if (!locals_.least) return 0;
    const std::uint32_t last = locals_.most.value_or(*locals_.least);
    return last <= *locals_.least ? *locals_.least : *locals_.least + std::min(i, last - *locals_.least);
  }

  std::optional<DescriptorError> input(std::uint32_t flags) {
    std::uint32_t& used = bits_[globals_.report];
    if (globals_.count == 0 || globals_.bits == 0) return std::nullopt;
    if (globals_.bits > kMostBits || globals_.count > kMostBits || globals_.bits * globals_.count > kMostBits - used)
      return DescriptorError::size;
    const std::uint32_t begin = used;
    used += globals_.bits * globals_.count;
    if ((flags & kConstant) != 0) return std::nullopt;  // padding
    if (globals_.bits > 32) return DescriptorError::size;
    InputField field;
    field.report = globals_.report;
    field.bits = static_cast<std::uint8_t>(globals_.bits);
    field.relative = (flags & kRelative) != 0;
    field.least = globals_.least;
    field.most = globals_.most;
    // 25 FF, "at most 255", is -1 to the letter: where the range would be upside down, it is meant unsigned.
    if (field.least >= 0 && field.most < field.least)
      field.most = static_cast<std::int32_t>(std::min<std::uint32_t>(globals_.most_unsigned, INT32_MAX));
    if ((flags & kVariable) == 0) {
      if (out_.inputs.size() >= kMostFields) return DescriptorError::size;
      field.list = true;
      field.bit = begin;
      field.count = static_cast<std::uint16_t>(globals_.count);
      const std::uint32_t first = usage_of(0);
      field.page = static_cast<std::uint16_t>(first >> 16);
      field.usage = static_cast<std::uint16_t>(first);
      out_.inputs.push_back(field);
      return std::nullopt;
    }
    if (globals_.count > kMostFields - out_.inputs.size()) return DescriptorError::size;
    for (std::uint32_t i = 0; i < globals_.count; ++i) {
      const std::uint32_t named = usage_of(i);
      field.bit = begin + i * globals_.bits;
      field.page = static_cast<std::uint16_t>(named >> 16);
      field.usage = static_cast<std::uint16_t>(named);
      out_.inputs.push_back(field);
    }
    return std::nullopt;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0, depth_ = 0;
  bool named_ = false;
  Globals globals_;
  Locals locals_;
  std::vector<Globals> pushed_;
  std::array<std::uint32_t, 256> bits_{};
  ReportDescriptor out_;
};

}  // namespace

Result<ReportDescriptor, DescriptorFailure> parse_report_descriptor(std::span<const std::uint8_t> bytes) {
  return Reader(bytes).read();
}

std::optional<std::int32_t> value_in(const InputField& field, std::span<const std::uint8_t> payload,
                                     std::uint16_t slot) noexcept {
  if (slot >= field.count || field.bits == 0 || field.bits > 32) return std::nullopt;
  const std::size_t begin = field.bit + static_cast<std::size_t>(slot) * field.bits;
  if (begin + field.bits > payload.size() * 8) return std::nullopt;
  std::uint64_t raw = 0;
  const std::size_t first = begin / 8, last = (begin + field.bits - 1) / 8;  // at most five bytes
  for (std::size_t i = first; i <= last; ++i) raw |= static_cast<std::uint64_t>(payload[i]) << (8 * (i - first));
  raw = raw >> (begin % 8) & ((std::uint64_t{1} << field.bits) - 1);
  std::int64_t value = static_cast<std::int64_t>(raw);
  if (field.least < 0 && (raw >> (field.bits - 1) & 1) != 0) value -= std::int64_t{1} << field.bits;
  if (value < field.least || value > field.most) return std::nullopt;
  return static_cast<std::int32_t>(value);
}

}  // namespace cusp::device::hid
