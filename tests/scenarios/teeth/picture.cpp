#include "tests/scenarios/teeth/picture.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scenarios/teeth/own_tissues.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr int kFine = 2;  // samples a pixel side
constexpr Vec3 kGround{24, 24, 24};

Vec3 colour_of(Tissue tissue) {
  switch (tissue) {
    case Tissue::enamel: return {235, 238, 247};
    case Tissue::dentine: return {220, 183, 108};
    case Tissue::cementum: return {130, 95, 55};
    case Tissue::pulp: return {192, 55, 52};
    case Tissue::carious_enamel: return {168, 138, 100};
    case Tissue::carious_dentine: return {106, 61, 30};
    case Tissue::bone: return {233, 223, 201};
    case Tissue::gingiva: return {217, 140, 140};
    case Tissue::ligament: return {150, 110, 150};
    case Tissue::plastic: return {213, 218, 223};
    default: break;
  }
  if (tissue == kFirmCariousDentine) return {150, 98, 52};
  if (tissue == kNeighbourEnamel) return {214, 222, 236};
  if (tissue == kNeighbourDentine) return {206, 180, 130};
  return kGround;
}

struct Reader {
  const VoxelVolume& v;
  double at(Vec3 mm) const {
    const Vec3 q = (mm - v.grid.origin_mm) / v.grid.voxel_mm, b = glm::floor(q), f = q - b;
    const IVec3 i(b);
    if (i.x < 0 || i.y < 0 || i.z < 0 || i.x + 1 >= v.grid.size.x || i.y + 1 >= v.grid.size.y || i.z + 1 >= v.grid.size.z)
      return 0.0;
    double sum = 0.0;
    for (int c = 0; c < 8; ++c) {
      const IVec3 o(c & 1, c >> 1 & 1, c >> 2);
      const double w = (o.x ? f.x : 1 - f.x) * (o.y ? f.y : 1 - f.y) * (o.z ? f.z : 1 - f.z);
      sum += w * v.s[v.grid.index(i + o)];
    }
    return sum / 65535.0;
  }
  Tissue tissue(Vec3 mm) const {
    const IVec3 i(glm::floor((mm - v.grid.origin_mm) / v.grid.voxel_mm + 0.5));
    return v.grid.contains(i) ? v.tissue[v.grid.index(i)] : Tissue::empty;
  }
  Vec3 slope(Vec3 mm) const {
    const double h = v.grid.voxel_mm;
    const Vec3 dx(h, 0, 0), dy(0, h, 0), dz(0, 0, h);
    return {at(mm + dx) - at(mm - dx), at(mm + dy) - at(mm - dy), at(mm + dz) - at(mm - dz)};
  }
};

Vec3 base_of(Tissue tissue) {
  if (tissue == Tissue::enamel || tissue == kNeighbourEnamel) return {214, 208, 192};
  if (tissue == Tissue::cementum || tissue == kNeighbourDentine) return {190, 152, 102};
  return colour_of(tissue);
}

/// Key light from the upper left, a weak fill from the right; `open` is how much of them reaches the place.
Vec3 lit(Tissue tissue, Vec3 n, double open, Vec3 right, Vec3 up, Vec3 into) {
  const Vec3 key = glm::normalize(-0.60 * right + 0.58 * up - 0.62 * into);
  const Vec3 fill = glm::normalize(0.6 * right + 0.1 * up - 0.8 * into);
  const double diffuse = 0.16 + 0.68 * std::max(0.0, glm::dot(n, key)) + 0.34 * std::max(0.0, glm::dot(n, fill));
  const Vec3 half = glm::normalize(key - into);
  const double gloss = std::pow(std::max(0.0, glm::dot(n, half)), 30.0);
  const bool crown = tissue == Tissue::enamel || tissue == kNeighbourEnamel;
  return glm::min(base_of(tissue) * diffuse * open + Vec3(crown ? 46.0 : 16.0) * gloss * open, Vec3(255.0));
}

Vec3 shade(const Reader& r, Vec3 p, Vec3 right, Vec3 up, Vec3 into) {
  const Vec3 n = -glm::normalize(r.slope(p) + Vec3(1e-12));
  // What stands above the place in its neighbourhood takes light away: fissures and furcations darken.
  double open = 1.0;
  for (const double far : {0.45, 0.8, 1.4}) open -= 0.16 * std::clamp(r.at(p + far * n) * 2.0, 0.0, 1.0);
  for (const double side : {-0.5, 0.5}) {
    open -= 0.07 * std::clamp(r.at(p + 0.6 * glm::normalize(n + side * right)) * 2.0, 0.0, 1.0);
    open -= 0.07 * std::clamp(r.at(p + 0.6 * glm::normalize(n + side * up)) * 2.0, 0.0, 1.0);
  }
  return lit(r.tissue(p - 0.05 * n), n, std::clamp(open, 0.35, 1.0), right, up, into);
}

Picture drawn(const VoxelVolume& volume, Vec3 into, Vec3 up, double scale, const std::function<Vec3(Vec3, Vec3)>& ray) {
  const Grid& g = volume.grid;
  const Vec3 low = g.origin_mm, high = g.centre_mm(g.size - 1), middle = 0.5 * (low + high), extent = high - low;
  const Vec3 right = glm::cross(into, up);
  const int w = static_cast<int>(std::fabs(glm::dot(extent, right)) * scale), h = static_cast<int>(std::fabs(glm::dot(extent, up)) * scale);
  const double depth = std::fabs(glm::dot(extent, into));
  Picture out(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      Vec3 sum(0.0);
      for (int k = 0; k < kFine * kFine; ++k) {
        const double u = (x + (k % kFine + 0.5) / kFine - 0.5 * w) / scale, v = (0.5 * h - y - (k / kFine + 0.5) / kFine) / scale;
        sum += ray(middle + u * right + v * up - 0.5 * depth * into, right);
      }
      for (int c = 0; c < 3; ++c) {
        out.rgb[static_cast<std::size_t>((y * w + x) * 3 + c)] = static_cast<std::uint8_t>(sum[c] / (kFine * kFine) + 0.5);
      }
    }
  }
  return out;
}

void be32(std::vector<std::uint8_t>& out, std::uint32_t v) {
  for (int s = 24; s >= 0; s -= 8) out.push_back(static_cast<std::uint8_t>(v >> s));
}
void chunk(std::vector<std::uint8_t>& out, const char* name, const std::vector<std::uint8_t>& data) {
  be32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t at = out.size();
  out.insert(out.end(), name, name + 4);
  out.insert(out.end(), data.begin(), data.end());
  be32(out, static_cast<std::uint32_t>(crc32(0, out.data() + at, static_cast<uInt>(out.size() - at))));
}

}  // namespace

Picture::Picture(int w, int h) : width(w), height(h), rgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3, 24) {}

void Picture::put(const Picture& from, int x, int y) {
  const int left = x - from.width / 2, top = y - from.height / 2;
  for (int j = std::max(0, -top); j < std::min(from.height, height - top); ++j) {
    for (int i = std::max(0, -left); i < std::min(from.width, width - left); ++i) {
      const std::uint8_t* p = &from.rgb[static_cast<std::size_t>((j * from.width + i) * 3)];
      if (p[0] == 24 && p[1] == 24 && p[2] == 24) continue;
      std::copy(p, p + 3, &rgb[static_cast<std::size_t>(((top + j) * width + left + i) * 3)]);
    }
  }
}

bool Picture::save_png(const std::string& path) const {
  std::vector<std::uint8_t> raw;
  for (int y = 0; y < height; ++y) {
    raw.push_back(0);
    const auto row = rgb.begin() + static_cast<std::ptrdiff_t>(y) * width * 3;
    raw.insert(raw.end(), row, row + width * 3);
  }
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  std::vector<std::uint8_t> packed(size);
  if (compress2(packed.data(), &size, raw.data(), static_cast<uLong>(raw.size()), 9) != Z_OK) return false;
  packed.resize(size);
  std::vector<std::uint8_t> out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}, head;
  be32(head, static_cast<std::uint32_t>(width));
  be32(head, static_cast<std::uint32_t>(height));
  head.insert(head.end(), {8, 2, 0, 0, 0});  // 8 bit, RGB
  chunk(out, "IHDR", head);
  chunk(out, "IDAT", packed);
  chunk(out, "IEND", {});
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  const bool all = std::fwrite(out.data(), 1, out.size(), file) == out.size();
  return std::fclose(file) == 0 && all;
}

Picture view(const VoxelVolume& volume, Vec3 into, Vec3 up, double px_per_mm) {
  const Reader r{volume};
  const double h = volume.grid.voxel_mm;
  const Vec3 extent = h * Vec3(volume.grid.size);
  const double depth = std::fabs(glm::dot(extent, into));
  return drawn(volume, into, up, px_per_mm, [&](Vec3 from, Vec3 right) {
    double before = 0.0;
    for (double t = 0.0; t < depth;) {
      const double s = r.at(from + t * into);
      if (s >= 0.5) {
        const double step = 0.4 * h;
        return shade(r, from + (t - step * (s - 0.5) / std::max(s - before, 1e-6)) * into, right, up, into);
      }
      before = s;
      t += s == 0.0 ? 1.5 * h : 0.4 * h;
    }
    return kGround;
  });
}

Picture view_of_jaw(const Jaw& jaw, double px_per_mm) {
  const Vec3 right(1, 0, 0), up(0, 1, 0), into(0, 0, -1);
  const Grid& g = jaw.tooth.volume.grid;
  Vec3 low = g.origin_mm, high = g.centre_mm(g.size - 1);
  for (const JawSurface& s : jaw.scenery) {
    for (const glm::vec3& p : s.mesh.points_mm) {
      low = glm::min(low, Vec3(p));
      high = glm::max(high, Vec3(p));
    }
  }
  low -= 1.0;
  high += 1.0;
  const int w = static_cast<int>((high.x - low.x) * px_per_mm), h = static_cast<int>((high.y - low.y) * px_per_mm);
  Picture out(w, h);
  std::vector<double> depth(static_cast<std::size_t>(w * h), -1e9);
  for (const JawSurface& s : jaw.scenery) {
    for (std::size_t k = 0; k < s.mesh.triangles.size(); k += 3) {
      Vec3 p[3], n[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t at = s.mesh.triangles[k + i];
        const Vec3 mm(s.mesh.points_mm[at]);
        p[i] = {(mm.x - low.x) * px_per_mm, (high.y - mm.y) * px_per_mm, mm.z};
        n[i] = Vec3(s.mesh.normals[at]);
      }
      const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
      if (std::fabs(area) < 1e-9) continue;
      const Vec3 least = glm::min(glm::min(p[0], p[1]), p[2]), most = glm::max(glm::max(p[0], p[1]), p[2]);
      for (int y = std::max(0, int(least.y)); y <= std::min(h - 1, int(most.y)); ++y) {
        for (int x = std::max(0, int(least.x)); x <= std::min(w - 1, int(most.x)); ++x) {
          const double qx = x + 0.5 - p[0].x, qy = y + 0.5 - p[0].y;
          const double b = (qx * (p[2].y - p[0].y) - qy * (p[2].x - p[0].x)) / area;
          const double c = ((p[1].x - p[0].x) * qy - (p[1].y - p[0].y) * qx) / area, a = 1.0 - b - c;
          double& known = depth[static_cast<std::size_t>(y * w + x)];
          const double z = a * p[0].z + b * p[1].z + c * p[2].z;
          if (a < 0.0 || b < 0.0 || c < 0.0 || z <= known) continue;
          known = z;
          const Vec3 colour = lit(s.mesh.tissue[s.mesh.triangles[k]], glm::normalize(a * n[0] + b * n[1] + c * n[2]), 1.0, right, up, into);
          for (int i = 0; i < 3; ++i) out.rgb[static_cast<std::size_t>((y * w + x) * 3 + i)] = static_cast<std::uint8_t>(colour[i]);
        }
      }
    }
  }
  const Vec3 middle = 0.5 * (g.origin_mm + g.centre_mm(g.size - 1));
  out.put(view(jaw.tooth.volume, into, up, px_per_mm), static_cast<int>((middle.x - low.x) * px_per_mm),
          static_cast<int>((high.y - middle.y) * px_per_mm));
  return out;
}

Picture pulp_section(const VoxelVolume& volume, Vec3 into, Vec3 up, double px_per_mm,
                     const std::function<bool(Vec3)>& keep) {
  const Reader r{volume};
  const Grid& g = volume.grid;
  const int depth = into.x != 0.0 ? 0 : 1, across = 1 - depth;
  struct Cut {
    double sum[2] = {0, 0};
    int count[2] = {0, 0};
    double at[2] = {0, 0};
  };
  std::vector<Cut> cuts(static_cast<std::size_t>(g.size.z));
  for (int z = 0; z < g.size.z; ++z) {
    for (int y = 0; y < g.size.y; ++y) {
      for (int x = 0; x < g.size.x; ++x) {
        const Vec3 p = g.centre_mm({x, y, z});
        if (volume.tissue[g.index({x, y, z})] != Tissue::pulp || !keep(p)) continue;
        Cut& c = cuts[static_cast<std::size_t>(z)];
        c.sum[p[across] > 0.0] += p[depth];
        ++c.count[p[across] > 0.0];
      }
    }
  }
  for (int side = 0; side < 2; ++side) {
    double last = 0.0;
    for (auto c = cuts.rbegin(); c != cuts.rend(); ++c) {  // from the crown down; gaps carry on
      if (c->count[side] > 0) last = c->sum[side] / c->count[side];
      c->at[side] = last;
    }
    for (int z = 0; z < g.size.z; ++z) {  // a gentle line
      double sum = 0.0;
      for (int k = -8; k <= 8; ++k) sum += cuts[static_cast<std::size_t>(std::clamp(z + k, 0, g.size.z - 1))].at[side];
      cuts[static_cast<std::size_t>(z)].sum[side] = sum / 17.0;
    }
  }
  return drawn(volume, into, up, px_per_mm, [&](Vec3 p, Vec3) {
    const int z = static_cast<int>((p.z - g.origin_mm.z) / g.voxel_mm + 0.5);
    const Cut& c = cuts[static_cast<std::size_t>(std::clamp(z, 0, g.size.z - 1))];
    const double f = std::clamp(0.5 + p[across] / 2.0, 0.0, 1.0);
    p[depth] = c.sum[0] + f * (c.sum[1] - c.sum[0]);
    return r.at(p) >= 0.5 ? colour_of(r.tissue(p)) : kGround;
  });
}

}  // namespace cusp::test
