#include "storage/cache/key_state_cache.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "storage/cache/cache_files.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLive = ".live";
constexpr const char* kRebuilt = ".rebuilt";
constexpr std::uint64_t kFormat = 0x3130534B50535543;  // "CUSPKS01"
constexpr std::size_t kSeal = sizeof(Hash256);
constexpr std::size_t kHeader = 8 + 16 + 8 + 8;  // format, session, tick, bytes of the packed state

struct CacheFile {
  fs::path path;
  SessionId session;
  std::uint64_t tick = 0;
  std::uint64_t bytes = 0;
  fs::file_time_type at{};
  bool live = false;
  bool whole = false;  // false: a temporary file of a killed writer
};

/// "SESSION-TICK.ending"; leading zeros make names sort like ticks.
std::string name_of(SessionId session, std::uint64_t tick, const char* ending) {
  std::string digits = std::to_string(tick);
  digits.insert(0, digits.size() < 12 ? 12 - digits.size() : 0, '0');
  return session.text() + "-" + digits + ending;
}

std::optional<CacheFile> file_of(const fs::directory_entry& entry) {
  constexpr std::size_t kId = 36;
  const std::string name = entry.path().filename().string();
  std::error_code bad;
  if (name.size() < kId + 2 || name[kId] != '-' || !entry.is_regular_file(bad) || bad) return std::nullopt;
  const auto session = SessionId::parse(name.substr(0, kId));
  if (!session) return std::nullopt;
  CacheFile file{entry.path(), *session};
  const char* end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kId + 1, end, file.tick);
  const std::string_view ending(read.ptr, static_cast<std::size_t>(end - read.ptr));
  file.live = ending == kLive;
  file.whole = read.ec == std::errc{} && (file.live || ending == kRebuilt);
  file.bytes = entry.file_size(bad);
  if (bad) return std::nullopt;
  file.at = entry.last_write_time(bad);
  return file;
}

/// Empty if the folder cannot be read.
std::vector<CacheFile> files_in(const fs::path& folder) {
  std::vector<CacheFile> out;
  std::error_code bad;
  for (fs::directory_iterator at(folder, bad), end; !bad && at != end; at.increment(bad)) {
    if (auto file = file_of(*at)) out.push_back(std::move(*file));
  }
  return out;
}

void remove_file(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

void put_u64(std::vector<std::byte>& out, std::uint64_t value) {
  for (int i = 0; i < 8; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
}
std::uint64_t u64_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) value |= std::to_integer<std::uint64_t>(bytes[at + i]) << (8 * i);
  return value;
}

}  // namespace

fs::path KeyStateCache::folder() const { return c_.db.file().string() + ".states"; }

/// The station's secret key enters the hash: only this station can compute it. No chain covers the measured process.
Hash256 KeyStateCache::seal(const std::vector<std::byte>& body) const {
  const Hash256 secret = blake2b_256(std::as_bytes(std::span{c_.key->secret_key}));
  return Blake2b().add_text("cusp key state").add_hash(secret).add_bytes(body).finish();
}

Stored<void> KeyStateCache::write(SessionId session, const KeyState& state, const char* ending) {
  if (!c_.key) return fail(StorageError::read_only, folder().string());
  std::vector<std::byte> body;
  put_u64(body, kFormat);
  for (const std::uint8_t byte : session.uuid.bytes) body.push_back(std::byte{byte});
  put_u64(body, state.tick);
  const auto packed = pack(state.state, Packing::quick);
  put_u64(body, packed.size());
  body.insert(body.end(), packed.begin(), packed.end());
  body.insert(body.end(), state.process.begin(), state.process.end());
  const Hash256 sealed = seal(body);
  for (const std::uint8_t byte : sealed) body.push_back(std::byte{byte});
  std::error_code bad;
  fs::create_directory(folder(), bad);
  const fs::path file = folder() / name_of(session, state.tick, ending);
  auto written = write_cache_file(file, body);
  if (written) trim(file);
  return written;
}

Stored<void> KeyStateCache::keep_live(SessionId session, const KeyState& state) {
  if (auto written = write(session, state, kLive); !written) return written;
  std::vector<CacheFile> own = files_in(folder());
  // One process writes a running session: a temporary file of it is left over from a killed one.
  std::erase_if(own, [&](const CacheFile& f) { return f.session != session || (f.whole && !f.live); });
  std::ranges::sort(own, [](const CacheFile& a, const CacheFile& b) {
    return a.whole != b.whole ? a.whole : a.tick > b.tick;
  });
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (i >= 2 || !own[i].whole) remove_file(own[i].path);
  }
  return {};
}

Stored<void> KeyStateCache::keep_rebuilt(SessionId session, const KeyState& state) {
  std::error_code bad;
  const auto space = fs::space(c_.db.file().parent_path().empty() ? fs::path(".") : c_.db.file().parent_path(), bad);
  if (!bad && space.available < kLeaveFree) return fail(StorageError::disk_full, folder().string(), "reserve");
  return write(session, state, kRebuilt);
}

void KeyStateCache::release(SessionId session) {
  for (const CacheFile& file : files_in(folder())) {
    if (file.session != session || !file.live) continue;
    std::error_code ignored;
    fs::rename(file.path, folder() / name_of(session, file.tick, kRebuilt), ignored);
  }
}

void KeyStateCache::make_room() {
  for (const CacheFile& file : files_in(folder())) {
    if (!file.live) remove_file(file.path);
  }
}

void KeyStateCache::trim(const fs::path& fresh) const {
  std::vector<CacheFile> all = files_in(folder());
  std::uint64_t bytes = 0;
  for (const CacheFile& file : all) bytes += file.bytes;
  if (bytes <= most_bytes_) return;
  std::ranges::sort(all, [](const CacheFile& a, const CacheFile& b) {
    if (a.live != b.live) return b.live;
    return a.at != b.at ? a.at < b.at : a.path < b.path;
  });
  for (const CacheFile& file : all) {
    if (bytes <= most_bytes_) return;
    if (file.path == fresh) continue;
    remove_file(file.path);
    bytes -= file.bytes;
  }
}

std::vector<std::uint64_t> KeyStateCache::ticks(SessionId session) const {
  std::vector<std::uint64_t> out;
  for (const CacheFile& file : files_in(folder())) {
    if (file.session == session && file.whole) out.push_back(file.tick);
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

std::optional<KeyState> KeyStateCache::unsealed(std::vector<std::byte> body, SessionId session,
                                                std::uint64_t tick) const {
  if (body.size() < kHeader + kSeal) return std::nullopt;
  const auto same = [](std::byte a, std::uint8_t b) { return std::to_integer<std::uint8_t>(a) == b; };
  const std::vector<std::byte> sealed(body.end() - kSeal, body.end());
  body.resize(body.size() - kSeal);
  if (!std::ranges::equal(sealed, seal(body), same)) return std::nullopt;
  if (u64_at(body, 0) != kFormat || u64_at(body, 24) != tick) return std::nullopt;
  if (!std::ranges::equal(std::span{body}.subspan(8, 16), session.uuid.bytes, same)) return std::nullopt;
  const std::uint64_t packed = u64_at(body, 32);
  if (packed > body.size() - kHeader) return std::nullopt;
  auto state = unpack(std::span{body}.subspan(kHeader, packed));
  if (!state) return std::nullopt;
  return KeyState{tick, std::move(*state), {body.begin() + static_cast<std::ptrdiff_t>(kHeader + packed), body.end()}};
}

std::optional<KeyState> KeyStateCache::read(SessionId session, std::uint64_t tick) {
  if (!c_.key) return std::nullopt;  // opened read-only: without the key no seal can be checked
  for (const char* ending : {kLive, kRebuilt}) {
    const fs::path file = folder() / name_of(session, tick, ending);
    auto body = read_cache_file(file, kMostUnpackedBytes);
    if (!body) continue;
    if (auto state = unsealed(std::move(*body), session, tick)) return state;
    remove_file(file);
  }
  return std::nullopt;
}

void KeyStateCache::drop(SessionId session, std::uint64_t tick) {
  for (const char* ending : {kLive, kRebuilt}) remove_file(folder() / name_of(session, tick, ending));
}

}  // namespace cusp::storage
