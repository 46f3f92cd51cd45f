// Key states: the whole state as bytes, little-endian, and back.
#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/step/state.h"

namespace cusp::engine {

namespace {

constexpr std::uint32_t kMark = 0x53505543;  // "CUPS"
/// Two places, a radius, a number and an axis.
constexpr std::size_t kSegmentBytes = 3 * 24 + 8 + 4;

class Writer {
 public:
  void u(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
  void d(double value) { u(std::bit_cast<std::uint64_t>(value), 8); }
  void v(Vec3 value) {
    for (int i = 0; i < 3; ++i) d(value[i]);
  }
  void raw(std::span<const std::byte> bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  std::vector<std::byte> take() { return std::move(out_); }

 private:
  std::vector<std::byte> out_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t u(int n) {
    if (bytes_.size() - at_ < static_cast<std::size_t>(n)) {
      good_ = false;
      return 0;
    }
    std::uint64_t value = 0;
    for (int i = 0; i < n; ++i) value |= static_cast<std::uint64_t>(bytes_[at_++]) << (8 * i);
    return value;
  }
  double d() { return std::bit_cast<double>(u(8)); }
  Vec3 v() {
    const double x = d(), y = d(), z = d();
    return {x, y, z};
  }
  std::span<const std::byte> raw(std::size_t n) {
    if (bytes_.size() - at_ < n) {
      good_ = false;
      return {};
    }
    at_ += n;
    return bytes_.subspan(at_ - n, n);
  }
  bool good() const { return good_; }
  bool done() const { return good_ && at_ == bytes_.size(); }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

void write_output(Writer& w, const StepOutput& o) {
  w.v(o.device_mm);
  w.v(o.proxy_mm);
  w.v(o.axis);
  w.v(o.force_raw_n);
  w.v(o.force_n);
  w.d(o.stiffness_n_per_mm);
  w.d(o.advance_mm);
  w.u(static_cast<std::uint64_t>(o.tissue), 1);
  w.u(o.bur, 2);
  w.u(o.tick, 8);
  w.u(o.elapsed_us, 8);
  const bool flags[8] = {o.contact, o.cutting, o.shank, o.faulted, o.infeasible, o.overflow, o.deferred, false};
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= flags[i] ? 1u << i : 0u;
  w.u(bits, 1);
  w.u(o.guard_acts, 2);
}

void read_output(Reader& r, StepOutput& o) {
  o.device_mm = r.v();
  o.proxy_mm = r.v();
  o.axis = r.v();
  o.force_raw_n = r.v();
  o.force_n = r.v();
  o.stiffness_n_per_mm = r.d();
  o.advance_mm = r.d();
  o.tissue = static_cast<Tissue>(r.u(1));
  o.bur = static_cast<std::uint16_t>(r.u(2));
  o.tick = r.u(8);
  o.elapsed_us = r.u(8);
  const auto bits = static_cast<unsigned>(r.u(1));
  o.contact = bits & 1u;
  o.cutting = bits & 2u;
  o.shank = bits & 4u;
  o.faulted = bits & 8u;
  o.infeasible = bits & 16u;
  o.overflow = bits & 32u;
  o.deferred = bits & 64u;
  o.guard_acts = static_cast<std::uint16_t>(r.u(2));
}

void write_guard(Writer& w, const GuardState& g) {
  w.u(static_cast<std::uint64_t>(g.fault), 1);
  w.d(g.ramp_ms);
  w.v(g.given_n);
  w.u(g.acted, 2);
  w.d(g.stale_ms);
  w.v(g.velocity_mm_s);
  const PassivityState& p = g.passivity;
  w.u(p.primed ? 1 : 0, 1);
  for (const double value : {p.stiffness_n_per_mm, p.scale, p.room_mj, p.bank_mj}) w.d(value);
  w.v(p.device_mm);
  w.v(p.spring_mm);
  for (const Vec3& v : p.held_n) w.v(v);
}

void read_guard(Reader& r, GuardState& g) {
  g.fault = static_cast<Fault>(r.u(1));
  g.ramp_ms = r.d();
  g.given_n = r.v();
  g.acted = static_cast<std::uint16_t>(r.u(2));
  g.stale_ms = r.d();
  g.velocity_mm_s = r.v();
  PassivityState& p = g.passivity;
  p.primed = r.u(1) != 0;
  for (double* value : {&p.stiffness_n_per_mm, &p.scale, &p.room_mj, &p.bank_mj}) *value = r.d();
  p.device_mm = r.v();
  p.spring_mm = r.v();
  for (Vec3& v : p.held_n) v = r.v();
}

void write_phenomena(Writer& w, const PhenomenaState& p, const StepOutput& o) {
  w.d(p.spindle.rpm);
  w.u(p.spindle.stalled ? 1 : 0, 1);
  w.u(p.vibration.phase, 4);
  w.d(p.heat.rise_k);
  w.u(p.heat.over ? 1 : 0, 1);
  w.u(std::bit_cast<std::uint32_t>(o.spindle_rpm), 4);
  w.u(std::bit_cast<std::uint32_t>(o.heat_k), 4);
  w.u(o.phenomena, 1);
}

/// False where a speed or a temperature is none.
bool read_phenomena(Reader& r, PhenomenaState& p, StepOutput& o) {
  p.spindle.rpm = r.d();
  p.spindle.stalled = r.u(1) != 0;
  p.vibration.phase = static_cast<std::uint32_t>(r.u(4));
  p.heat.rise_k = r.d();
  p.heat.over = r.u(1) != 0;
  o.spindle_rpm = std::bit_cast<float>(static_cast<std::uint32_t>(r.u(4)));
  o.heat_k = std::bit_cast<float>(static_cast<std::uint32_t>(r.u(4)));
  o.phenomena = static_cast<std::uint8_t>(r.u(1));
  return p.spindle.rpm >= 0.0 && p.spindle.rpm <= p.settings.free_rpm && p.heat.rise_k >= 0.0 && p.heat.rise_k <= 1000.0;
}

}  // namespace

std::vector<std::byte> StepState::save() const {
  const Inner& s = *inner_;
  Writer w;
  w.u(kMark, 4);
  w.u(static_cast<std::uint64_t>(kEngineVersion), 4);
  w.u(s.scene->specimen->hash(), 8);
  w.u(static_cast<std::uint64_t>(s.scene->method), 1);
  write_output(w, s.last);
  write_guard(w, s.guard);
  w.v(s.proxy);
  w.v(s.device);
  w.v(s.cut_pose);
  w.v(s.velocity);
  w.u(s.started ? 1 : 0, 1);
  w.u(s.cut_valid ? 1 : 0, 1);
  w.u(s.cut_pending ? 1 : 0, 1);
  w.v(s.cut_from);
  w.v(s.cut_axis);
  w.v(s.astray);
  w.u(s.strays, 1);
  for (const Vec3& v : {s.owed_piece.from, s.owed_piece.to, s.owed_piece.axis}) w.v(v);
  w.u(s.owed_piece.bur, 2);
  w.u(s.owed_piece.start_carved, 1);
  w.u(static_cast<std::uint64_t>(s.owed_piece.next + 1), 4);
  for (const double owed : s.owed) w.d(owed);
  w.v(s.foot);
  w.u(s.memory.open() ? 1 : 0, 1);
  w.u(s.memory.size(), 4);
  for (std::size_t i = 0; i < s.memory.size(); ++i) {
    w.v(s.memory.segment(i).a);
    w.v(s.memory.segment(i).b);
    w.d(s.memory.segment(i).by.radius_mm);
    w.u(static_cast<std::uint64_t>(s.memory.segment(i).by.head + 1), 4);
    w.v(s.memory.segment(i).by.axis);
  }
  w.u(s.leaving.half(), 2);
  w.u(s.leaving.entries().size(), 2);
  for (const LeavingPiece::Entry& entry : s.leaving.entries()) {
    w.u(static_cast<std::uint32_t>(entry.brick), 4);
    for (const std::uint64_t voxels : entry.voxels.slice) w.u(voxels, 8);
  }
  if (s.phenomena) write_phenomena(w, *s.phenomena, s.last);
  const std::vector<std::byte> cuts = s.volume.save_cuts();
  w.u(cuts.size(), 8);
  w.raw(cuts);
  if (s.surface) {
    const CutSurface& cut = s.surface->cut_surface();
    w.u(cut.sharpens() ? 1 : 0, 1);
    std::vector<std::int32_t> bricks(s.volume.cut_bricks().begin(), s.volume.cut_bricks().end());
    std::sort(bricks.begin(), bricks.end());
    for (const std::int32_t brick : bricks) w.u(cut.sharp(s.volume, brick), 2);
  }
  return w.take();
}

std::optional<StepState> StepState::restore(std::shared_ptr<const Scene> scene, std::span<const std::byte> bytes) {
  Reader r(bytes);
  if (r.u(4) != kMark || r.u(4) != static_cast<std::uint64_t>(kEngineVersion) || r.u(8) != scene->specimen->hash() ||
      r.u(1) != static_cast<std::uint64_t>(scene->method))
    return std::nullopt;
  const std::size_t burs = scene->burs.size();
  StepState out(std::move(scene));
  Inner& s = *out.inner_;
  read_output(r, s.last);
  read_guard(r, s.guard);
  s.proxy = r.v();
  s.device = r.v();
  s.cut_pose = r.v();
  s.velocity = r.v();
  s.started = r.u(1) != 0;
  s.cut_valid = r.u(1) != 0;
  s.cut_pending = r.u(1) != 0;
  s.cut_from = r.v();
  s.cut_axis = r.v();
  s.astray = r.v();
  s.strays = r.u(1) != 0;
  for (Vec3* v : {&s.owed_piece.from, &s.owed_piece.to, &s.owed_piece.axis}) *v = r.v();
  s.owed_piece.bur = static_cast<std::uint16_t>(r.u(2));
  s.owed_piece.start_carved = r.u(1) != 0;
  s.owed_piece.next = static_cast<std::int32_t>(r.u(4)) - 1;
  if (s.owed_piece.bur >= burs) return std::nullopt;
  for (double& owed : s.owed) owed = r.d();
  s.foot = r.v();
  const bool open = r.u(1) != 0;
  const std::size_t count = r.u(4);
  if (!r.good() || count > r.left() / kSegmentBytes || s.last.bur >= burs || index_of(s.last.tissue) >= kTissueCodes ||
      s.guard.fault > Fault::stale)
    return std::nullopt;
  std::vector<CutMemory::Segment> segments(count);
  for (CutMemory::Segment& segment : segments) {
    segment.a = r.v();
    segment.b = r.v();
    segment.by.radius_mm = r.d();
    segment.by.head = static_cast<std::int32_t>(r.u(4)) - 1;
    segment.by.axis = r.v();
    if (segment.by.head >= static_cast<std::int32_t>(burs)) return std::nullopt;
  }
  s.memory.load(segments, open);
  const auto half = static_cast<std::uint16_t>(r.u(2));
  std::vector<LeavingPiece::Entry> leaving(r.u(2));
  for (LeavingPiece::Entry& entry : leaving) {
    entry.brick = static_cast<std::int32_t>(r.u(4));
    for (std::uint64_t& voxels : entry.voxels.slice) voxels = r.u(8);
  }
  const IVec3 bricks = s.scene->specimen->brick_count();
  if (!r.good() || !s.leaving.load(half, leaving, bricks.x * bricks.y * bricks.z)) return std::nullopt;
  if (s.phenomena && !read_phenomena(r, *s.phenomena, s.last)) return std::nullopt;
  const std::size_t size = r.u(8);
  const auto cuts = r.raw(size);
  if (!r.good() || !s.volume.load_cuts(cuts)) return std::nullopt;
  if (s.surface) {
    // Loaded bricks come in index order, as they were written.
    const bool on = r.u(1) != 0;
    s.surface->load_sharp(s.volume, on, [&r](std::int32_t) { return static_cast<CutSurface::Parts>(r.u(2)); });
  }
  if (!r.done()) return std::nullopt;
  s.method->reload(s);
  return out;
}

}  // namespace cusp::engine
