// hash(), save() and restore(): three visitors of the list in state_fields.h.
#include "engine/step/state_fields.h"

#include <algorithm>
#include <bit>

#include "engine/volume/hash.h"

namespace cusp::engine {

namespace {

constexpr std::uint32_t kMark = 0x53505543;  // "CUPS": the first four bytes of a key state

/// Bytes that a field takes.
template <class T>
constexpr int kBytes = std::same_as<T, bool> ? 1 : static_cast<int>(sizeof(T));

/// A field as an unsigned number, bit for bit. T: integer, enum, bool, float or double.
template <class T>
std::uint64_t bits_of(T value) noexcept {
  if constexpr (std::same_as<T, double>) {
    return std::bit_cast<std::uint64_t>(value);
  } else if constexpr (std::same_as<T, float>) {
    return std::bit_cast<std::uint32_t>(value);
  } else if constexpr (std::is_enum_v<T>) {
    return bits_of(static_cast<std::underlying_type_t<T>>(value));
  } else if constexpr (std::same_as<T, bool>) {
    return value ? 1 : 0;
  } else {
    return static_cast<std::make_unsigned_t<T>>(value);
  }
}

template <class T>
T from_bits(std::uint64_t bits) noexcept {
  if constexpr (std::same_as<T, double>) {
    return std::bit_cast<double>(bits);
  } else if constexpr (std::same_as<T, float>) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  } else if constexpr (std::same_as<T, bool>) {
    return bits != 0;
  } else {
    return static_cast<T>(bits);
  }
}

/// Hashes each field as one word; -0 and +0 are the same.
class Hasher {
 public:
  template <class T>
  void operator()(const char*, const T& value) noexcept {
    if constexpr (std::same_as<T, Vec3>) {
      for (int i = 0; i < 3; ++i) hash_.add_double(value[i]);
    } else if constexpr (std::floating_point<T>) {
      hash_.add_double(value);
    } else {
      hash_.add(bits_of(value));
    }
  }
  std::size_t size(const char*, std::size_t now, std::size_t) noexcept {
    hash_.add(now);
    return now;
  }
  void cuts(const char*, const Volume& volume) noexcept { hash_.add(volume.hash()); }
  void sweeps(const char*, const Sweeps& sweeps, const Volume& volume) noexcept {
    hash_.add(sweeps.hash());
    hash_.add(volume.sweeps_hash());
  }

  void add(std::uint64_t word) noexcept { hash_.add(word); }
  std::uint64_t value() const noexcept { return hash_.value(); }

 private:
  Hash64 hash_;
};

/// Little-endian, no padding; a list's length takes 4 bytes, the cut field's 8.
class Writer {
 public:
  template <class T>
  void operator()(const char*, const T& value) {
    if constexpr (std::same_as<T, Vec3>) {
      for (int i = 0; i < 3; ++i) put(bits_of(value[i]), 8);
    } else {
      put(bits_of(value), kBytes<T>);
    }
  }
  std::size_t size(const char*, std::size_t now, std::size_t) {
    put(now, 4);
    return now;
  }
  void cuts(const char*, const Volume& volume) { put(volume.save_cuts()); }
  void sweeps(const char*, const Sweeps& sweeps, const Volume& volume) {
    put(sweeps.save());
    put(volume.save_sweeps());
  }

  void put(const std::vector<std::byte>& bytes) {
    put(bytes.size(), 8);
    out_.insert(out_.end(), bytes.begin(), bytes.end());
  }

  void put(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
  std::vector<std::byte> take() { return std::move(out_); }

 private:
  std::vector<std::byte> out_;
};

/// Reads what Writer wrote. Once it has failed it gives zeros and empty lists.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(const char*, T& value) {
    if constexpr (std::same_as<T, Vec3>) {
      for (int i = 0; i < 3; ++i) value[i] = from_bits<double>(get(8));
    } else {
      value = from_bits<T>(get(kBytes<T>));
    }
  }
  std::size_t size(const char*, std::size_t, std::size_t least_bytes) {
    const std::size_t count = get(4);
    if (count > left() / least_bytes) refuse();
    return good_ ? count : 0;
  }
  void cuts(const char*, Volume& volume) {
    block([&](std::span<const std::byte> bytes) { return volume.load_cuts(bytes); });
  }
  void sweeps(const char*, Sweeps& sweeps, Volume& volume) {
    block([&](std::span<const std::byte> bytes) { return sweeps.load(bytes); });
    block([&](std::span<const std::byte> bytes) { return volume.load_sweeps(bytes, sweeps.size()); });
  }
  void refuse() { good_ = false; }

  std::uint64_t get(int n) {
    if (!good_ || left() < static_cast<std::size_t>(n)) {
      refuse();
      return 0;
    }
    std::uint64_t value = 0;
    for (int i = 0; i < n; ++i) value |= static_cast<std::uint64_t>(bytes_[at_++]) << (8 * i);
    return value;
  }
  /// All bytes were read, and nothing was refused.
  bool done() const { return good_ && left() == 0; }

 private:
  template <class Load>
  void block(Load&& load) {
    const std::size_t size = get(8);
    if (size > left()) refuse();
    if (!good_) return;
    if (!load(bytes_.subspan(at_, size))) refuse();
    at_ += size;
  }
  std::size_t left() const { return bytes_.size() - at_; }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

/// True if a run names sweeps that follow each other, or none.
bool in_store(const Sweeps& sweeps, SweepRun run) noexcept {
  if (run.to == Sweeps::kNone) return run.from == Sweeps::kNone || run.from == 0;
  return run.from >= 0 && run.from <= run.to && run.to < sweeps.size() && !sweeps.gap(run.from) &&
         sweeps.about(run.from, 0, run.to - run.from).to == run.to;
}

/// True if no voxel names the gap between two ways.
bool name_sweeps(const Volume& volume, const Sweeps& sweeps) noexcept {
  for (const std::int32_t brick : volume.cut_bricks())
    if (const std::int32_t* ids = volume.sweeps_of(brick))
      if (std::any_of(ids, ids + kBrickVoxels, [&](std::int32_t id) { return id != Volume::kNoSweep && sweeps.gap(id); })) return false;
  return true;
}

/// True if a way has the vertices that whoever goes on with it reads, and room for its end.
bool has_vertices(const Polyline& way, int least, int most) noexcept { return way.count >= least && way.count <= most; }

/// Indices and enums of the state are the scene's; what the spindle and the heat keep is in their range.
bool in_range(const StepState::Inner& s) noexcept {
  const std::size_t burs = s.scene->burs.size();
  if (s.last.bur >= burs || index_of(s.last.tissue) >= kTissueCodes || s.guard.fault > Fault::stale) return false;
  if (s.pending_sweep.bur >= burs) return false;
  if (!has_vertices(s.cut_way, s.cut_pending ? 1 : 0, Polyline::kMost - 1)) return false;
  if (!has_vertices(s.pending_sweep.way, s.pending_sweep.waits ? 2 : 0, Polyline::kMost)) return false;
  if (!in_store(s.sweeps, {s.cut_first, s.cut_last}) || !in_store(s.sweeps, {s.pending_sweep.first, s.pending_sweep.last})) return false;
  if (!name_sweeps(s.volume, s.sweeps)) return false;
  for (std::size_t i = 0; i < s.memory.size(); ++i) {
    const std::int32_t head = s.memory.segment(i).by.head;
    if (head < 0 || head >= static_cast<std::int32_t>(burs)) return false;
  }
  if (!s.phenomena) return true;
  const double rpm = s.phenomena->spindle.rpm, rise_k = s.phenomena->heat.rise_k;
  return rpm >= 0.0 && rpm <= s.phenomena->settings.free_rpm && rise_k >= 0.0 && rise_k <= kMostRiseK;
}

}  // namespace

std::uint64_t StepState::hash() const noexcept {
  Hasher hasher;
  hasher.add(static_cast<std::uint64_t>(kEngineVersion));
  const Inner& inner = *inner_;
  visit(hasher, inner);
  return hasher.value();
}

std::vector<std::byte> StepState::save() const {
  const Inner& inner = *inner_;
  Writer writer;
  writer.put(kMark, 4);
  writer.put(static_cast<std::uint64_t>(kEngineVersion), 4);
  writer.put(inner.scene->specimen->hash(), 8);
  writer.put(bits_of(inner.scene->method), 1);
  visit(writer, inner);
  return writer.take();
}

std::optional<StepState> StepState::restore(std::shared_ptr<const Scene> scene, std::span<const std::byte> bytes) {
  Reader reader(bytes);
  if (reader.get(4) != kMark || reader.get(4) != static_cast<std::uint64_t>(kEngineVersion) ||
      reader.get(8) != scene->specimen->hash() || reader.get(1) != bits_of(scene->method))
    return std::nullopt;
  StepState out(std::move(scene));
  visit(reader, *out.inner_);
  if (!reader.done() || !in_range(*out.inner_)) return std::nullopt;
  out.inner_->method->reload(*out.inner_);
  return out;
}

}  // namespace cusp::engine
