#include "scenarios/library/tar.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace cusp::scenarios {
namespace {

constexpr std::size_t kBlock = 512;  // bytes; headers and data fill whole blocks
constexpr std::size_t kEndBlocks = 2;  // of zeros

/// A field of the header: place and length in bytes (POSIX.1-1988, table 10-1).
struct Field {
  std::size_t at, length;
};
constexpr Field kName{0, kMostTarName}, kMode{100, 8}, kUser{108, 8}, kGroup{116, 8}, kSize{124, 12}, kTime{136, 12}, kSum{148, 8},
    kType{156, 1}, kLink{157, 100}, kMagic{257, 8}, kPrefix{345, 155};
constexpr std::string_view kUstar("ustar\00000", 8);  // magic and version
constexpr char kRegular = '0';

void put(std::string& header, Field field, std::string_view text) { header.replace(field.at, text.size(), text); }

void put_octal(std::string& header, Field field, std::uint64_t value) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%0*llo", static_cast<int>(field.length) - 1, static_cast<unsigned long long>(value));
  put(header, field, digits);
}

std::string_view of(std::string_view header, Field field) { return header.substr(field.at, field.length); }

/// The text up to the first zero; nullopt if other bytes than zeros follow it.
std::optional<std::string> text_of(std::string_view field) {
  const std::size_t end = std::min(field.find('\0'), field.size());
  if (field.find_first_not_of('\0', end) != std::string_view::npos) return std::nullopt;
  return std::string(field.substr(0, end));
}

/// Octal digits, then zeros or blanks.
std::optional<std::uint64_t> octal_of(std::string_view field) {
  std::uint64_t value = 0;
  std::size_t digits = 0;
  for (; digits < field.size() && field[digits] >= '0' && field[digits] <= '7'; ++digits)
    value = value * 8 + static_cast<std::uint64_t>(field[digits] - '0');  // at most 12 digits: 36 bits
  if (digits == 0 || field.find_first_not_of(std::string_view("\0 ", 2), digits) != std::string_view::npos) return std::nullopt;
  return value;
}

/// Sum of the header's bytes with its own field as blanks.
std::uint64_t sum_of(std::string_view header) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < kBlock; ++i)
    sum += i >= kSum.at && i < kSum.at + kSum.length ? std::uint64_t{' '} : static_cast<unsigned char>(header[i]);
  return sum;
}

bool is_zero(std::string_view block) { return block.find_first_not_of('\0') == std::string_view::npos; }

bool leads_away(std::string_view name) {
  return name.empty() || name.front() == '.' || name.find_first_of("/\\:") != std::string_view::npos ||
         std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

/// Name and size of a regular file.
struct Head {
  std::string name;
  std::uint64_t size = 0;
};

Result<Head, FormatFailure> head_of(std::string_view header) {
  if (of(header, kMagic) != kUstar) return fail(FormatError::foreign_file, {});
  if (octal_of(of(header, kSum)) != sum_of(header)) return fail(FormatError::damaged, {});
  const auto name = text_of(of(header, kName));
  const auto size = octal_of(of(header, kSize));
  if (!name || !size) return fail(FormatError::damaged, {});
  if (leads_away(*name) || !is_zero(of(header, kPrefix))) return fail(FormatError::bad_file_name, *name);
  if (of(header, kType).front() != kRegular || !is_zero(of(header, kLink))) return fail(FormatError::unnamed_file, *name);
  return Head{*name, *size};
}

}  // namespace

std::string tar_name(std::string_view name) {
  if (name.size() <= kMostTarName) return std::string(name);
  constexpr std::size_t kMostSuffix = 16;  // a longer one is a name with a full stop in it
  const std::size_t dot = name.rfind('.');
  const std::string_view suffix = dot != std::string_view::npos && name.size() - dot <= kMostSuffix ? name.substr(dot) : std::string_view();
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  std::size_t kept = kMostTarName - suffix.size();
  while (kept > 0 && continues(name[kept])) --kept;
  return std::string(name.substr(0, kept)).append(suffix);
}

std::string write_tar(const std::vector<TarEntry>& entries) {
  std::string out;
  for (const TarEntry& entry : entries) {
    std::string header(kBlock, '\0');
    put(header, kName, entry.name);
    put_octal(header, kMode, 0644);
    put_octal(header, kUser, 0);
    put_octal(header, kGroup, 0);
    put_octal(header, kSize, entry.data.size());
    put_octal(header, kTime, 0);
    put(header, kType, std::string_view(&kRegular, 1));
    put(header, kMagic, kUstar);
    put_octal(header, {kSum.at, kSum.length - 1}, sum_of(header));  // six digits, a zero, a blank
    put(header, {kSum.at + kSum.length - 1, 1}, " ");
    out += header;
    out += entry.data;
    out.resize((out.size() + kBlock - 1) / kBlock * kBlock, '\0');
  }
  out.append(kEndBlocks * kBlock, '\0');
  return out;
}

Result<std::vector<TarEntry>, FormatFailure> read_tar(std::string_view bytes, std::size_t most) {
  std::vector<TarEntry> out;
  while (bytes.size() >= kBlock && !is_zero(bytes.substr(0, kBlock))) {
    auto head = head_of(bytes.substr(0, kBlock));
    if (!head) {
      // The first header shows whether this is an archive at all.
      if (!out.empty() && head.error().code == FormatError::foreign_file) return fail(FormatError::damaged, {});
      return std::unexpected(head.error());
    }
    bytes.remove_prefix(kBlock);
    if (out.size() == most) return fail(FormatError::unnamed_file, head->name);
    if (std::ranges::find(out, head->name, &TarEntry::name) != out.end()) return fail(FormatError::duplicate_value, head->name);
    if (head->size > bytes.size()) return fail(FormatError::truncated, head->name);
    out.push_back({std::move(head->name), bytes.substr(0, head->size)});
    const std::size_t blocks = (head->size + kBlock - 1) / kBlock * kBlock;
    if (blocks > bytes.size()) return fail(FormatError::truncated, out.back().name);
    bytes.remove_prefix(blocks);
  }
  if (out.empty()) return fail(FormatError::foreign_file, {});
  if (bytes.size() < kEndBlocks * kBlock) return fail(FormatError::truncated, {});
  if (!is_zero(bytes)) return fail(FormatError::damaged, {});
  return out;
}

}  // namespace cusp::scenarios
