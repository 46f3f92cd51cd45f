#include "ui/render/vertex_look.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {
namespace {

constexpr int kTaps = 6;  // of the kernel, along an axis; its half width of 3 voxels hides the steps of a groove of 2
// What a fine vertex may lie outside its brick, and a coarse one, with half a kernel.
constexpr int kFineMargin = 5, kCoarseMargin = 8;

Vec3f vec(LinearLight c) { return {c.r, c.g, c.b}; }
float smooth(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
IVec3 floor_of(Vec3f p) {
  return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z))};
}

float lattice(IVec3 v) {
  std::uint32_t h = static_cast<std::uint32_t>(v.x) * 0x8da6b343u ^ static_cast<std::uint32_t>(v.y) * 0xd8163841u ^
                    static_cast<std::uint32_t>(v.z) * 0xcb1ab31fu;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 13;
  return static_cast<float>(h & 0xffffu) / 32767.5f - 1.0f;
}

std::array<Vec3f, kTissueCodes> linear_tissues() {
  std::array<Vec3f, kTissueCodes> out{};
  const auto colours = tissue_colours();
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = {colours[i].r * colours[i].r, colours[i].g * colours[i].g, colours[i].b * colours[i].b};
  return out;
}

/// What a bur's blades leave on a wall.
Vec3f roughness(Vec3f at_mm) {
  constexpr float kShift = 37.0f;
  const auto grain = [](Vec3f p) { return 0.05f * noise(p, 0.42f) + 0.04f * noise(p, 0.21f); };
  return {grain(at_mm), grain(at_mm + kShift), grain(at_mm - kShift)};
}

}  // namespace

float noise(Vec3f at_mm, float wavelength_mm) noexcept {
  const Vec3f p = at_mm / wavelength_mm;
  const IVec3 low = floor_of(p);
  Vec3f f = p - Vec3f(low);
  f = f * f * (3.0f - 2.0f * f);
  const auto row = [&](int y, int z) {
    const float a = lattice(low + IVec3(0, y, z)), b = lattice(low + IVec3(1, y, z));
    return a + f.x * (b - a);
  };
  const float near = row(0, 0) + f.y * (row(1, 0) - row(0, 0)), far = row(0, 1) + f.y * (row(1, 1) - row(0, 1));
  return near + f.z * (far - near);
}

Vec3f enamel_colour(float depth_mm) noexcept {
  // Two fluxes through a scattering layer over a matt ground, seen at a mean slant.
  constexpr float kSlant = 1.0f / 0.84f;
  const float path = depth_mm * kSlant;
  const Vec3f scatter = vec(kEnamelScatter) * path, back = scatter / (1.0f + scatter);
  const Vec3f kept = glm::exp(-vec(kEnamelAbsorb) * path), through = kept / (1.0f + scatter);
  const Vec3f under = vec(kUnderEnamel);
  return back * kept + through * through * under / (1.0f - back * under);
}

void stain(VertexLook& look, float groove) noexcept {
  look.colour *= glm::mix(Vec3f(1.0f), vec(kFissureStain), 0.40f * groove * look.enamel * (1.0f - look.cut));
}

Vec3f ridge_colour(Vec3f enamel, float thin) noexcept { return glm::mix(enamel, vec(kThinEnamel), 0.34f * thin); }

Vec3f body_colour(Tissue tissue, Vec3f at_mm) noexcept {
  static const std::array<Vec3f, kTissueCodes> table = linear_tissues();
  if (tissue == Tissue::gingiva) {
    const float deep = 0.5f + 0.35f * noise(at_mm, 2.3f) + 0.25f * noise(at_mm, 0.55f);
    return glm::mix(vec(kGumPale), vec(kGumDeep), std::clamp(deep, 0.0f, 1.0f));
  }
  return table[index_of(tissue) % kTissueCodes];
}

LookWindow::LookWindow(const Specimen& specimen, int brick, int level) : specimen_(specimen) {
  const int margin = level == kCoarsePatch ? kCoarseMargin : kFineMargin;
  size_ = kBrickEdge + 2 * margin;
  corner_ = specimen.brick_at(brick) * kBrickEdge - margin;
  const auto voxels = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  solid_.assign(voxels, 0.0f);
  tissue_.assign(voxels, Tissue::empty);
  const IVec3 low(corner_.x >> 3, corner_.y >> 3, corner_.z >> 3), last = corner_ + (size_ - 1);
  IVec3 b;
  for (b.z = low.z; b.z <= last.z >> 3; ++b.z)
    for (b.y = low.y; b.y <= last.y >> 3; ++b.y)
      for (b.x = low.x; b.x <= last.x >> 3; ++b.x) read_brick(b);
}

void LookWindow::read_brick(IVec3 brick) {
  const int index = specimen_.brick_index(brick);
  if (index < 0) return;
  const Tissue only = specimen_.only_tissue(index);
  const bool uniform = specimen_.uniform(index);
  if (uniform && only == Tissue::empty) return;
  if (only == Tissue::empty || (only_ != Tissue::empty && only != only_)) mixed_ = true;
  if (only != Tissue::empty) only_ = only;
  const std::uint16_t* s = specimen_.s_of(index);
  const IVec3 origin = brick * kBrickEdge;
  const IVec3 from = glm::max(origin, corner_), to = glm::min(origin + kBrickEdge, corner_ + size_);
  IVec3 v;
  for (v.z = from.z; v.z < to.z; ++v.z)
    for (v.y = from.y; v.y < to.y; ++v.y) {
      const int offset = brick_offset(0, v.y & 7, v.z & 7);
      const IVec3 local = IVec3(0, v.y, v.z) - corner_;
      const auto row = static_cast<std::ptrdiff_t>(local.x) + size_ * (local.y + size_ * static_cast<std::ptrdiff_t>(local.z));
      for (v.x = from.x; v.x < to.x; ++v.x) {
        const int o = offset + (v.x & 7);
        const auto at = static_cast<std::size_t>(row + v.x);
        solid_[at] = uniform ? 1.0f : static_cast<float>(s[o]) * (1.0f / 65535.0f);
        tissue_[at] = only != Tissue::empty ? (uniform || s[o] > 0 ? only : Tissue::empty) : specimen_.tissue_in(index, o);
      }
    }
}

/// Weights of a bell about a place and their slopes, per axis. Exact for a plane: the weights' sum is 1 and the slopes'
/// moment 1, wherever the place lies between the voxels; else a smooth surface shows rings.
struct LookWindow::Kernel {
  explicit Kernel(Vec3f voxel) : first(floor_of(voxel) - (kTaps / 2 - 1)) {
    for (int axis = 0; axis < 3; ++axis) {
      float sum = 0.0f, moment = 0.0f;
      for (int i = 0; i < kTaps; ++i) {
        const float x = static_cast<float>(first[axis] + i) - voxel[axis];
        const float t = std::max(1.0f - x * x / 9.0f, 0.0f);
        weight[axis][i] = t * t;
        sum += t * t;
        moment += t * t * x;
      }
      off[axis] = moment / sum;
      float steep = 0.0f;
      for (int i = 0; i < kTaps; ++i) {
        const float x = static_cast<float>(first[axis] + i) - voxel[axis];
        weight[axis][i] /= sum;
        slope[axis][i] = weight[axis][i] * (x - off[axis]);
        steep += slope[axis][i] * x;
      }
      for (int i = 0; i < kTaps; ++i) slope[axis][i] /= steep;
    }
  }
  IVec3 first;
  Vec3f off;  // of the weights' middle from the place
  float weight[3][kTaps], slope[3][kTaps];
};

LookWindow::Sums LookWindow::sums_at(Vec3f voxel) const noexcept {
  Sums out;
  Kernel kernel(voxel);
  kernel.first = glm::clamp(kernel.first - corner_, IVec3(0), IVec3(size_ - kTaps));
  for (int z = 0; z < kTaps; ++z)
    for (int y = 0; y < kTaps; ++y) {
      const int row = kernel.first.x + size_ * (kernel.first.y + y + size_ * (kernel.first.z + z));
      const float* s = &solid_[static_cast<std::size_t>(row)];
      float sum = 0.0f, along = 0.0f;
      for (int x = 0; x < kTaps; ++x) {
        sum += s[x] * kernel.weight[0][x];
        along += s[x] * kernel.slope[0][x];
      }
      const float wy = kernel.weight[1][y], wz = kernel.weight[2][z];
      out.solid += sum * wy * wz;
      out.gradient += Vec3f(along * wy * wz, sum * kernel.slope[1][y] * wz, sum * wy * kernel.slope[2][z]);
      if (!mixed_) continue;
      const Tissue* t = &tissue_[static_cast<std::size_t>(row)];
      for (int x = 0; x < kTaps; ++x) out.tissue[index_of(t[x]) % kTissueCodes] += kernel.weight[0][x] * wy * wz;
    }
  out.solid -= glm::dot(out.gradient, kernel.off);
  if (!mixed_) out.tissue[index_of(only_) % kTissueCodes] = 1.0f;
  return out;
}

VertexLook LookWindow::look(const PatchVertex& vertex, const Around& around) const {
  const Grid& grid = specimen_.grid();
  Vec3f voxel = Vec3f((Vec3(vertex.position_mm) - grid.origin_mm) / grid.voxel_mm);
  VertexLook out{.position_mm = vertex.position_mm, .normal = vertex.normal, .cut = vertex.cut ? 1.0f : 0.0f};
  Sums sums = sums_at(voxel);
  const bool smooth_field = specimen_.reading() == Reading::banded && glm::length(sums.gradient) > 0.02f;
  const float behind = sums.solid - 0.5f;  // above 0 in a groove, and where a bur went under the surface
  if (smooth_field && vertex.cut) {
    // At the margin the specimen's own surface begins, wherever the voxels end.
    out.cut = smooth(0.0f, 0.22f, behind);
    out.normal = glm::normalize(glm::mix(-glm::normalize(sums.gradient), vertex.normal, out.cut) + roughness(vertex.position_mm) * out.cut);
  } else if (smooth_field) {
    float filled = 0.0f;
    for (int pass = 0; pass < 4 && sums.solid - 0.5f > 0.03f && filled < kMostFillVoxels; ++pass) {
      const float steep = std::max(glm::length(sums.gradient), 0.02f);
      const float step = std::min((sums.solid - 0.5f) / steep, kMostFillVoxels - filled);
      filled += step;
      voxel -= sums.gradient * (step / steep);
      sums = sums_at(voxel);
    }
    out.position_mm = Vec3f(grid.origin_mm + Vec3(voxel) * grid.voxel_mm);
    if (const float steep = glm::length(sums.gradient); steep > 0.02f) out.normal = -sums.gradient / steep;
  }
  // Shares to the third power: a junction stays a line, and yet runs between the voxels.
  float all = 0.0f, enamel = 0.0f;
  Vec3f rest(0.0f);
  for (std::size_t i = 1; i < kTissueCodes; ++i) {
    const float w = sums.tissue[i] * sums.tissue[i] * sums.tissue[i];
    if (w <= 0.0f) continue;
    all += w;
    if (is_enamel(static_cast<Tissue>(i))) enamel += w;
    else rest += w * body_colour(static_cast<Tissue>(i), vertex.position_mm);
  }
  if (all <= 0.0f) {
    out.colour = body_colour(vertex.tissue, vertex.position_mm);
    return out;
  }
  out.enamel = enamel / all;
  out.colour = rest / all;
  if (enamel <= 0.0f) return out;
  float depth = around.depth_mm;
  depth *= 1.0f + 0.16f * noise(vertex.position_mm, 1.7f) + 0.09f * noise(vertex.position_mm, 0.5f);
  Vec3f body = enamel_colour(depth * (1.0f - 0.2f * out.cut));
  out.thin = smooth(0.03f, 0.17f, around.ridge) * smooth(0.25f, 0.9f, depth) * out.enamel * (1.0f - out.cut);
  body = ridge_colour(body, out.thin);
  body = glm::mix(body, vec(kCutEnamel), 0.55f * out.cut);
  out.colour += out.enamel * body;
  return out;
}

}  // namespace cusp::ui
