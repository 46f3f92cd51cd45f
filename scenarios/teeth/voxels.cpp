#include "scenarios/teeth/voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/two_threads.h"

namespace cusp::scenarios {
namespace {

constexpr int kBlock = 4;             // voxels on a side of the blocks that are skipped or sampled whole
constexpr int kPad = 4;               // empty voxels on every side (voxel_volume.h)
constexpr double kTapVoxels = 4.5;    // how far from the surface samples are read: band 2.75 and two taps, less a bit
constexpr std::size_t kCrumbVoxels = 8;

/// Samples of the outside field on the grid, with a cubic reading between them.
struct Field {
  IVec3 size;
  std::vector<float> f;
  std::size_t index(int x, int y, int z) const noexcept {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(size.x) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(z));
  }
  /// Value and gradient (per voxel) at a place in voxel coordinates, tricubic (Catmull-Rom).
  double at(Vec3 p, Vec3& slope) const noexcept {
    const Vec3 base = glm::floor(p);
    const IVec3 i = glm::clamp(IVec3(base), IVec3(1), size - 3);
    double w[3][4], s[3][4];
    for (int a = 0; a < 3; ++a) {
      const double t = p[a] - i[a], t2 = t * t, t3 = t2 * t;
      w[a][0] = 0.5 * (2 * t2 - t3 - t);
      w[a][1] = 0.5 * (3 * t3 - 5 * t2 + 2);
      w[a][2] = 0.5 * (4 * t2 - 3 * t3 + t);
      w[a][3] = 0.5 * (t3 - t2);
      s[a][0] = 0.5 * (4 * t - 3 * t2 - 1);
      s[a][1] = 0.5 * (9 * t2 - 10 * t);
      s[a][2] = 0.5 * (8 * t - 9 * t2 + 1);
      s[a][3] = 0.5 * (3 * t2 - 2 * t);
    }
    double v = 0, gx = 0, gy = 0, gz = 0;
    for (int c = 0; c < 4; ++c) {
      double pv = 0, px = 0, py = 0;
      for (int b = 0; b < 4; ++b) {
        const float* row = &f[index(i.x - 1, i.y - 1 + b, i.z - 1 + c)];
        const double r0 = double(row[0]), r1 = double(row[1]), r2 = double(row[2]), r3 = double(row[3]);
        const double rv = w[0][0] * r0 + w[0][1] * r1 + w[0][2] * r2 + w[0][3] * r3;
        const double rx = s[0][0] * r0 + s[0][1] * r1 + s[0][2] * r2 + s[0][3] * r3;
        pv += w[1][b] * rv;
        px += w[1][b] * rx;
        py += s[1][b] * rv;
      }
      v += w[2][c] * pv;
      gx += w[2][c] * px;
      gy += w[2][c] * py;
      gz += s[2][c] * pv;
    }
    slope = {gx, gy, gz};
    return v;
  }
};

/// Distance from a grid point to the field's zero, in voxels with the field's sign, and the nearest place found there.
/// First the field over its own slope; then Newton steps that bring the place onto the surface and the line to it at
/// right angles to the surface. Where they never meet the surface (above a fissure the field is steeper than distance),
/// the answer is "beyond the band", and settle() takes it back to what the neighbours allow.
double true_distance(const Field& field, IVec3 at, double value, Vec3& nearest) noexcept {
  const Vec3 from(at);
  Vec3 slope;
  field.at(from, slope);
  double s2 = std::max(glm::dot(slope, slope), 1e-12);
  Vec3 p = from - glm::clamp(value / s2, -4.0 / std::sqrt(s2), 4.0 / std::sqrt(s2)) * slope;
  double best = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double v = field.at(p, slope);
    s2 = std::max(glm::dot(slope, slope), 1e-12);
    const Vec3 onto = -(v / s2) * slope;
    const Vec3 away = from - p;
    const Vec3 along = away - (glm::dot(away, slope) / s2) * slope;
    if (std::fabs(v) < 0.02 * std::sqrt(s2)) {
      const Vec3 q = p + onto;
      const double d = glm::length(from - q);
      if (d < best) {
        best = d;
        nearest = q;
      }
      if (glm::dot(along, along) < 1e-6) break;
    }
    Vec3 move = onto + along;
    const double length = glm::length(move), most = 0.7;
    if (length > most && round > 0) move *= most / length;
    p += move;
  }
  if (best > 1e8) best = 2.0 * kBandVoxels;
  return value < 0.0 ? -best : best;
}

/// Largest change of s to a neighbour 1, sqrt 2 or sqrt 3 voxels away (index: squared), with 1 % for rounding.
constexpr int step_of(double voxels) { return static_cast<int>(1.01 * voxels * 65535.0 / (2.0 * kBandVoxels)); }
constexpr int kMostStep[4] = {0, step_of(1.0), step_of(1.41421356), step_of(1.73205081)};

class Maker {
 public:
  Maker(const Body& body, double voxel_mm) : body_(body), h_(voxel_mm) {
    // Whole voxels from the origin, so that the mirrored tooth lies on the same grid.
    const double edge = kBandVoxels + kPad + 0.5;
    const IVec3 low(glm::floor(body.low() / h_ - edge)), high(glm::ceil(body.high() / h_ + edge));
    Grid grid;
    grid.size = high - low + 1;
    grid.voxel_mm = h_;
    grid.origin_mm = h_ * Vec3(low);
    out_ = VoxelVolume(grid);
    field_.size = grid.size;
    field_.f.assign(grid.voxels(), 0.0f);
    blocks_ = (grid.size + (kBlock - 1)) / kBlock;
    kind_.assign(static_cast<std::size_t>(blocks_.x * blocks_.y * blocks_.z), Kind::outside);
  }

  int layers() const noexcept { return blocks_.z; }

  /// Pass 1, one layer of blocks: the outside field near the surface.
  void sample(int layer) {
    const double radius = (0.5 * kBlock * std::sqrt(3.0) + kTapVoxels) * h_, far = kSlopeMost * radius + kFissureMm;
    for_blocks(layer, [&](IVec3 low, IVec3 high, Kind& kind) {
      const double centre = body_.outside(place(0.5 * Vec3(low + high - 1)));
      kind = centre > far ? Kind::outside : centre < -far ? Kind::inside : Kind::near;
      for (int z = low.z; z < high.z; ++z) {
        for (int y = low.y; y < high.y; ++y) {
          for (int x = low.x; x < high.x; ++x) {
            field_.f[field_.index(x, y, z)] =
                static_cast<float>((kind == Kind::near ? body_.outside(place({x, y, z})) : centre) / h_);
          }
        }
      }
    });
  }

  /// Pass 2: distance and tissue.
  void fill(int layer) {
    const double radius = 0.5 * kBlock * std::sqrt(3.0) * h_, far = kSlopeMost * radius + 0.25;
    for_blocks(layer, [&](IVec3 low, IVec3 high, Kind& kind) {
      if (kind == Kind::outside) return;
      Tissue whole = Tissue::empty;
      if (kind == Kind::inside) whole = body_.whole(place(0.5 * Vec3(low + high - 1)), far);
      for (int z = low.z; z < high.z; ++z) {
        for (int y = low.y; y < high.y; ++y) {
          for (int x = low.x; x < high.x; ++x) voxel({x, y, z}, kind, whole);
        }
      }
    });
  }

  /// Pass 3. Above a fissure a Newton path may end on the farther wall; a distance grows by no more than the way walked
  /// (1 % for rounding), so such a voxel is taken back to what its neighbours allow. Two sweeps: its neighbours are right.
  void settle() {
    const IVec3 low(kPad), high = field_.size - kPad;
    for (int z = low.z; z < high.z; ++z) {
      for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
          if (near(x, y, z)) settle(x, y, z);
          else x |= kBlock - 1;  // to the block's end
        }
      }
    }
    for (int z = high.z - 1; z >= low.z; --z) {
      for (int y = high.y - 1; y >= low.y; --y) {
        for (int x = high.x - 1; x >= low.x; --x) {
          if (near(x, y, z)) settle(x, y, z);
          else x &= ~(kBlock - 1);
        }
      }
    }
  }

  /// Pass 4. A canal that ends near the apex, or a coat one voxel thin, may cut off a few voxels: they join the tissue
  /// around them, so that each tissue is one component.
  void join_strays() {
    const std::size_t row = static_cast<std::size_t>(field_.size.x), slice = row * static_cast<std::size_t>(field_.size.y);
    const std::size_t around[6] = {1, std::size_t(0) - 1, row, std::size_t(0) - row, slice, std::size_t(0) - slice};
    const auto solid = [&](std::size_t i) { return out_.s[i] >= kHalf; };  // never at the rim: that is padding
    std::vector<std::uint8_t> seen(out_.s.size(), 0);
    std::array<std::vector<std::size_t>, kTissueCodes> largest;
    std::vector<std::vector<std::size_t>> strays;
    for (std::size_t i = 0; i < out_.s.size(); ++i) {
      if (seen[i] || !solid(i)) continue;
      const Tissue own = out_.tissue[i];
      std::vector<std::size_t> component{i};
      seen[i] = 1;
      for (std::size_t k = 0; k < component.size(); ++k) {
        for (const std::size_t step : around) {
          const std::size_t next = component[k] + step;
          if (seen[next] || !solid(next) || out_.tissue[next] != own) continue;
          seen[next] = 1;
          component.push_back(next);
        }
      }
      std::vector<std::size_t>& most = largest[index_of(own)];
      if (component.size() > most.size()) most.swap(component);
      if (!component.empty()) strays.push_back(std::move(component));
    }
    for (const std::vector<std::size_t>& component : strays) {
      std::array<int, kTissueCodes> votes{};
      const Tissue own = out_.tissue[component.front()];
      // Several lesions, or the ligaments of several teeth, are several components; only crumbs of one are strays.
      const bool several = own == Tissue::carious_enamel || own == Tissue::carious_dentine ||
                           own == kFirmCariousDentine || own == Tissue::ligament;
      if (several && component.size() > kCrumbVoxels) continue;
      for (const std::size_t i : component) {
        for (const std::size_t step : around) {
          if (solid(i + step) && out_.tissue[i + step] != own) ++votes[index_of(out_.tissue[i + step])];
        }
      }
      const auto most = std::max_element(votes.begin(), votes.end());
      if (*most == 0) continue;
      for (const std::size_t i : component) out_.tissue[i] = static_cast<Tissue>(most - votes.begin());
    }
  }

  VoxelVolume take() { return std::move(out_); }

 private:
  enum class Kind : std::uint8_t { outside, near, inside };

  Vec3 place(Vec3 voxel) const noexcept { return out_.grid.origin_mm + h_ * voxel; }

  template <class Work>
  void for_blocks(int layer, const Work& work) {
    for (int by = 0; by < blocks_.y; ++by) {
      for (int bx = 0; bx < blocks_.x; ++bx) {
        const IVec3 low = kBlock * IVec3(bx, by, layer), high = glm::min(low + kBlock, field_.size);
        work(low, high, kind_[static_cast<std::size_t>(bx + blocks_.x * (by + blocks_.y * layer))]);
      }
    }
  }

  void voxel(IVec3 v, Kind kind, Tissue whole) {
    if (!inner(v)) return;  // padding, whatever the body's box
    const std::size_t i = field_.index(v.x, v.y, v.z);
    const double value = double(field_.f[i]);
    double d = value;
    Vec3 nearest(v);
    if (kind == Kind::near && std::fabs(value) < kTapVoxels) d = true_distance(field_, v, value, nearest);
    const std::uint16_t s = solid_from_distance(d);
    if (s == 0) return;
    out_.s[i] = s;
    if (whole != Tissue::empty) {
      out_.tissue[i] = whole;
    } else if (d > 0.0) {
      out_.tissue[i] = body_.skin(place(nearest));  // outside: as the surface next to it
    } else {
      out_.tissue[i] = body_.inside(place(Vec3(v)), d * h_);
    }
  }

  void settle(int x, int y, int z) {
    const IVec3 size = field_.size;
    const std::size_t at = field_.index(x, y, z);
    const int own = out_.s[at];
    if (own == 0 || own == kSolid) {  // far from the surface, unless a face neighbour is not
      const std::size_t row = static_cast<std::size_t>(size.x), slice = row * static_cast<std::size_t>(size.y);
      const auto same = [&](std::size_t next) { return out_.s[next] == own; };
      if (same(at - 1) && same(at + 1) && same(at - row) && same(at + row) && same(at - slice) && same(at + slice)) return;
    }
    int best = own;
    std::size_t from = at;
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int squares = dx * dx + dy * dy + dz * dz;
          if (squares == 0) continue;
          const std::size_t next = field_.index(x + dx, y + dy, z + dz);
          int step = kMostStep[squares], other = out_.s[next];
          const double here = double(field_.f[at]), there = double(field_.f[next]);
          if (here * there < 0.0) {  // the surface lies between: near the zero of the field
            step = static_cast<int>(step * (here / (here - there)) * 1.1);
            other = kHalf;
          }
          if (here > 0.0 && other - step > best) best = other - step, from = next;
          if (here < 0.0 && other + step < best) best = other + step, from = next;
        }
      }
    }
    if (best == own) return;
    out_.s[at] = static_cast<std::uint16_t>(best);
    if (own == 0) out_.tissue[at] = out_.tissue[from];
  }

  bool near(int x, int y, int z) const noexcept {
    return kind_[static_cast<std::size_t>(x / kBlock + blocks_.x * (y / kBlock + blocks_.y * (z / kBlock)))] == Kind::near;
  }

  bool inner(IVec3 v) const noexcept {
    return v.x >= kPad && v.y >= kPad && v.z >= kPad && v.x < field_.size.x - kPad && v.y < field_.size.y - kPad &&
           v.z < field_.size.z - kPad;
  }

  const Body& body_;
  double h_;
  Field field_;
  IVec3 blocks_{0};
  std::vector<Kind> kind_;
  VoxelVolume out_;
};

}  // namespace

Result<VoxelVolume, ToothFailure> voxels_of(const Body& body, double voxel_mm, ToothCancel cancel,
                                            const ToothProgress& progress, double from) {
  Maker maker(body, voxel_mm);
  const int layers = maker.layers();
  const auto report = [&](double low, double high) {
    return [&progress, low, high, layers](int i) {
      if (progress) progress(low + (high - low) * (i + 1) / layers);
    };
  };
  const double middle = from + 0.5 * (1.0 - from);
  in_two_threads(layers, [&](int layer) { maker.sample(layer); }, report(from, middle), cancel);
  in_two_threads(layers, [&](int layer) { maker.fill(layer); }, report(middle, 1.0), cancel);
  if (cancel != nullptr && cancel->load()) return fail(ToothError::cancelled, "tooth");
  maker.settle();
  maker.join_strays();
  return maker.take();
}

VoxelVolume united(const std::vector<VoxelVolume>& parts) {
  const double h = parts.front().grid.voxel_mm;
  const auto first_of = [h](const Grid& g) { return IVec3(glm::floor(g.origin_mm / h + 0.5)); };
  IVec3 low = first_of(parts.front().grid), high = low;
  for (const VoxelVolume& part : parts) {
    low = glm::min(low, first_of(part.grid));
    high = glm::max(high, first_of(part.grid) + part.grid.size);
  }
  Grid grid;
  grid.voxel_mm = h;
  grid.size = high - low;
  grid.origin_mm = h * Vec3(low);
  VoxelVolume out(grid);
  for (const VoxelVolume& part : parts) {
    out.names.insert(part.names.begin(), part.names.end());
    const IVec3 shift = first_of(part.grid) - low;
    std::size_t i = 0;
    for (int z = 0; z < part.grid.size.z; ++z) {
      for (int y = 0; y < part.grid.size.y; ++y) {
        std::size_t to = grid.index(IVec3(0, y, z) + shift);
        for (int x = 0; x < part.grid.size.x; ++x, ++i, ++to) {
          if (part.s[i] <= out.s[to]) continue;
          out.s[to] = part.s[i];
          out.tissue[to] = part.tissue[i];
        }
      }
    }
  }
  return out;
}

VoxelVolume embedded(VoxelVolume teeth, const VoxelVolume& around) {
  // The surroundings run through the teeth: there they reach further in than the tooth does, and must not win.
  VoxelVolume out = united({std::move(teeth), VoxelVolume(around.grid)});
  const double h = around.grid.voxel_mm;
  const IVec3 shift(glm::floor((around.grid.origin_mm - out.grid.origin_mm) / h + 0.5));
  std::size_t i = 0;
  for (int z = 0; z < around.grid.size.z; ++z) {
    for (int y = 0; y < around.grid.size.y; ++y) {
      std::size_t to = out.grid.index(IVec3(0, y, z) + shift);
      for (int x = 0; x < around.grid.size.x; ++x, ++i, ++to) {
        if (around.s[i] <= out.s[to]) continue;
        if (out.s[to] < kHalf) out.tissue[to] = around.tissue[i];
        out.s[to] = around.s[i];
      }
    }
  }
  return out;
}

VoxelVolume mirrored(const VoxelVolume& volume) {
  Grid grid = volume.grid;
  grid.origin_mm.x = -(grid.origin_mm.x + grid.voxel_mm * (grid.size.x - 1));
  VoxelVolume out(grid);
  out.names = volume.names;
  const std::size_t row = static_cast<std::size_t>(grid.size.x);
  for (std::size_t i = 0; i < grid.voxels(); i += row) {
    const auto at = static_cast<std::ptrdiff_t>(i), end = static_cast<std::ptrdiff_t>(i + row);
    std::reverse_copy(volume.s.begin() + at, volume.s.begin() + end, out.s.begin() + at);
    std::reverse_copy(volume.tissue.begin() + at, volume.tissue.begin() + end, out.tissue.begin() + at);
  }
  return out;
}

}  // namespace cusp::scenarios
