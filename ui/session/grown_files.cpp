#include "ui/session/grown_files.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <string>

#include "storage/cache/cache_files.h"
#include "storage/records/trace_codec.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

// A file: hash of what follows, key, packed bytes.
constexpr std::size_t kHash = sizeof(Hash256), kHeader = 2 * kHash;
constexpr std::size_t kMostFileBytes = std::size_t{256} << 20;
constexpr const char* kEnding = ".grown";
constexpr std::chrono::hours kStale{24};  // a temporary file of a process that was killed

bool is_hash(std::span<const std::byte> bytes, const Hash256& hash) { return std::memcmp(bytes.data(), hash.data(), kHash) == 0; }

void append(std::vector<std::byte>& out, const Hash256& hash) {
  const auto* bytes = reinterpret_cast<const std::byte*>(hash.data());
  out.insert(out.end(), bytes, bytes + kHash);
}

void remove_file(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

struct Kept {
  fs::path file;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

/// The files of a cache folder; those that killed processes left half written are removed.
std::vector<Kept> kept_in(const fs::path& folder) {
  std::vector<Kept> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;
    const Kept one{it->path(), it->last_write_time(gone), it->file_size(gone)};
    if (gone) continue;
    if (one.file.extension() == kEnding) {
      out.push_back(one);
    } else if (one.file.filename().string().find(kEnding) != std::string::npos && fs::file_time_type::clock::now() - one.used > kStale) {
      remove_file(one.file);
    }
  }
  return out;
}

}  // namespace

fs::path GrownFiles::file_of(const Hash256& key) const { return folder_ / (storage::hex(key).substr(0, 32) + kEnding); }

std::optional<std::vector<std::byte>> GrownFiles::read(const Hash256& key) const {
  const fs::path file = file_of(key);
  const auto bytes = storage::read_cache_file(file, kMostFileBytes);
  if (!bytes) return std::nullopt;
  const std::span all(*bytes);
  if (all.size() < kHeader || !is_hash(all, storage::blake2b_256(all.subspan(kHash))) || !is_hash(all.subspan(kHash), key)) {
    remove_file(file);
    return std::nullopt;
  }
  auto out = storage::unpack(all.subspan(kHeader));
  if (!out) {
    remove_file(file);
    return std::nullopt;
  }
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return std::move(*out);
}

void GrownFiles::keep(const Hash256& key, std::span<const std::byte> bytes) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return;
  const fs::space_info space = fs::space(folder_, error);
  if (error || space.available < kLeaveFree + bytes.size()) return;
  std::vector<std::byte> body;
  append(body, key);
  const std::vector<std::byte> packed = storage::pack(bytes);
  body.insert(body.end(), packed.begin(), packed.end());
  std::vector<std::byte> file;
  append(file, storage::blake2b_256(body));
  file.insert(file.end(), body.begin(), body.end());
  if (file.size() > std::min<std::uint64_t>(kMostFileBytes, most_bytes_)) return;
  const fs::path name = file_of(key);
  if (!storage::write_cache_file(name, file)) return;
  trim(name);
}

void GrownFiles::trim(const fs::path& fresh) const {
  std::vector<Kept> kept = kept_in(folder_);
  std::uint64_t bytes = 0;
  for (const Kept& one : kept) bytes += one.bytes;
  std::ranges::sort(kept, {}, &Kept::used);
  for (const Kept& one : kept) {
    if (bytes <= most_bytes_) return;
    if (one.file == fresh) continue;
    remove_file(one.file);
    bytes -= one.bytes;
  }
}

}  // namespace cusp::ui
