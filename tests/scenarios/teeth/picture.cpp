#include "tests/scenarios/teeth/picture.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cusp {
namespace {

constexpr int kFine = 2;  // samples a pixel side
constexpr Vec3 kGround{24, 24, 24};

Vec3 colour_of(Tissue tissue) {
  switch (tissue) {
    case Tissue::enamel: return {235, 238, 247};
    case Tissue::dentine: return {220, 183, 108};
    case Tissue::cementum: return {130, 95, 55};
    case Tissue::pulp: return {192, 55, 52};
    default: return kGround;
  }
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

Vec3 shade(const Reader& r, Vec3 p, Vec3 right, Vec3 up, Vec3 into) {
  const Vec3 n = -glm::normalize(r.slope(p) + Vec3(1e-12));
  const Vec3 key = glm::normalize(-0.60 * right + 0.58 * up - 0.62 * into);
  const Vec3 fill = glm::normalize(0.6 * right + 0.1 * up - 0.8 * into);
  // What stands above the place in its neighbourhood takes light away: fissures and furcations darken.
  double open = 1.0;
  for (const double far : {0.45, 0.8, 1.4}) open -= 0.16 * std::clamp(r.at(p + far * n) * 2.0, 0.0, 1.0);
  for (const double side : {-0.5, 0.5}) {
    open -= 0.07 * std::clamp(r.at(p + 0.6 * glm::normalize(n + side * right)) * 2.0, 0.0, 1.0);
    open -= 0.07 * std::clamp(r.at(p + 0.6 * glm::normalize(n + side * up)) * 2.0, 0.0, 1.0);
  }
  open = std::clamp(open, 0.35, 1.0);
  const double diffuse = 0.16 + 0.68 * std::max(0.0, glm::dot(n, key)) + 0.34 * std::max(0.0, glm::dot(n, fill));
  const Vec3 half = glm::normalize(key - into);
  const double gloss = std::pow(std::max(0.0, glm::dot(n, half)), 30.0);
  const bool crown = r.tissue(p - 0.05 * n) == Tissue::enamel;
  const Vec3 base = crown ? Vec3(214, 208, 192) : Vec3(190, 152, 102);
  return glm::min(base * diffuse * open + Vec3(crown ? 46.0 : 16.0) * gloss * open, Vec3(255.0));
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

}  // namespace cusp
