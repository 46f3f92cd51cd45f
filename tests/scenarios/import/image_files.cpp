#include "tests/scenarios/import/image_files.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace cusp::test {
namespace {

void u16(std::string& out, unsigned v) {
  out += static_cast<char>(v & 0xff);
  out += static_cast<char>(v >> 8 & 0xff);
}
void u32(std::string& out, std::uint32_t v) {
  u16(out, v & 0xffff);
  u16(out, v >> 16);
}
void f32(std::string& out, double v) { u32(out, std::bit_cast<std::uint32_t>(static_cast<float>(v))); }

std::string decimal(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.8g", v);
  return buffer;
}

/// One element of explicit VR, padded to an even length.
std::string element(unsigned group, unsigned number, const char* vr, std::string value) {
  const bool is_text = std::strcmp(vr, "OW") != 0 && std::strcmp(vr, "US") != 0 && std::strcmp(vr, "UL") != 0 && std::strcmp(vr, "OB") != 0;
  if (value.size() % 2 != 0) value += is_text && std::strcmp(vr, "UI") != 0 ? ' ' : '\0';
  std::string out;
  u16(out, group);
  u16(out, number);
  out += vr;
  if (std::strcmp(vr, "OW") == 0 || std::strcmp(vr, "OB") == 0) {
    u16(out, 0);
    u32(out, static_cast<std::uint32_t>(value.size()));
  } else {
    u16(out, static_cast<unsigned>(value.size()));
  }
  return out + value;
}
std::string short_value(unsigned v) {
  std::string out;
  u16(out, v);
  return out;
}

/// One packed picture: an empty table of offsets, then the frame.
std::string packed_pixels(const std::string& frame) {
  std::string out;
  u16(out, 0x7fe0);
  u16(out, 0x10);
  out += std::string("OB\0\0", 4);
  u32(out, 0xffffffff);
  const auto item = [&](unsigned number, const std::string& body) {
    u16(out, 0xfffe);
    u16(out, number);
    u32(out, static_cast<std::uint32_t>(body.size()));
    out += body;
  };
  item(0xe000, {});
  item(0xe000, frame);
  item(0xe0dd, {});
  return out;
}

std::string chunk(unsigned id, const std::string& body) {
  std::string out;
  u16(out, id);
  u32(out, static_cast<std::uint32_t>(body.size() + 6));
  return out + body;
}

}  // namespace

std::vector<std::int16_t> values_of(IVec3 size, const std::function<int(IVec3)>& value) {
  std::vector<std::int16_t> out;
  IVec3 v;
  for (v.z = 0; v.z < size.z; ++v.z)
    for (v.y = 0; v.y < size.y; ++v.y)
      for (v.x = 0; v.x < size.x; ++v.x) out.push_back(static_cast<std::int16_t>(value(v)));
  return out;
}

std::string bytes_of(const std::vector<std::int16_t>& values) {
  std::string out;
  for (const std::int16_t v : values) u16(out, static_cast<std::uint16_t>(v));
  return out;
}

std::string nifti_file(const NiftiWish& w) {
  std::string h(352, '\0');
  const auto put16 = [&](std::size_t at, int v) {
    std::string s;
    u16(s, static_cast<unsigned>(v));
    h.replace(at, 2, s);
  };
  const auto put_float = [&](std::size_t at, double v) {
    std::string s;
    f32(s, v);
    h.replace(at, 4, s);
  };
  std::string s;
  u32(s, 348);
  h.replace(0, 4, s);
  const int dim[8] = {3, w.size.x, w.size.y, w.size.z, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 8; ++i) put16(40 + 2 * i, dim[i]);
  put16(70, 4);   // DT_INT16
  put16(72, 16);  // bits
  const double pixdim[4] = {1.0, w.spacing_mm.x, w.spacing_mm.y, w.spacing_mm.z};
  for (std::size_t i = 0; i < 4; ++i) put_float(76 + 4 * i, pixdim[i]);
  put_float(108, 352.0);
  put_float(112, static_cast<double>(w.slope));
  put_float(116, static_cast<double>(w.intercept));
  h[123] = static_cast<char>(w.units);
  if (w.affine != std::array<float, 12>{}) {
    put16(254, 1);
    for (std::size_t i = 0; i < 12; ++i) put_float(280 + 4 * i, static_cast<double>(w.affine[i]));
  }
  h.replace(344, 4, std::string("n+1\0", 4));
  return h + bytes_of(w.values);
}

std::string dicom_file(const DicomWish& w) {
  const auto triple = [](Vec3 v) { return decimal(v.x) + "\\" + decimal(v.y) + "\\" + decimal(v.z); };
  std::string orientation;
  for (std::size_t i = 0; i < 6; ++i) orientation += (i == 0 ? "" : "\\") + decimal(w.orientation[i]);
  const auto padding = [](unsigned number, const std::optional<int>& value) {
    return value ? element(0x28, number, "SS", short_value(static_cast<unsigned>(*value))) : std::string();
  };
  const std::string instance = w.series + "." + std::to_string(w.number);
  std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2") +
                     element(2, 3, "UI", instance) + element(2, 0x10, "UI", w.transfer) + element(2, 0x12, "UI", "1.2.3.4");
  std::string length;
  u32(length, static_cast<std::uint32_t>(meta.size()));
  std::string set = element(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(8, 0x18, "UI", instance) +
                    element(8, 0x60, "CS", "CT") + element(0x10, 0x10, "PN", w.patient) + element(0x18, 0x50, "DS", decimal(w.thickness_mm)) +
                    (w.between_mm ? element(0x18, 0x88, "DS", decimal(*w.between_mm)) : std::string()) + element(0x20, 0xe, "UI", w.series) + element(0x20, 0x13, "IS", std::to_string(w.number));
  if (w.placed) set += element(0x20, 0x32, "DS", triple(w.position)) + element(0x20, 0x37, "DS", orientation);
  if (w.location_mm) set += element(0x20, 0x1041, "DS", decimal(*w.location_mm));
  set += element(0x28, 2, "US", short_value(1)) + element(0x28, 4, "CS", "MONOCHROME2") +
         element(0x28, 0x10, "US", short_value(static_cast<unsigned>(w.rows))) +
         element(0x28, 0x11, "US", short_value(static_cast<unsigned>(w.columns))) +
         element(0x28, 0x30, "DS", decimal(w.down_mm) + "\\" + decimal(w.across_mm)) + element(0x28, 0x100, "US", short_value(16)) +
         element(0x28, 0x101, "US", short_value(16)) + element(0x28, 0x102, "US", short_value(15)) +
         element(0x28, 0x103, "US", short_value(1)) + padding(0x120, w.padding) + padding(0x121, w.padding_limit) +
         element(0x28, 0x1052, "DS", decimal(w.intercept)) +
         element(0x28, 0x1053, "DS", decimal(w.slope)) +
         (w.frame.empty() ? element(0x7fe0, 0x10, "OW", bytes_of(w.values)) : packed_pixels(w.frame));
  return std::string(128, '\0') + "DICM" + element(2, 0, "UL", length) + meta + set;
}

std::string binary_stl(const Mesh& mesh) {
  std::string out = "made for a test";
  out.resize(80, ' ');
  u32(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) f32(out, 0.0);
    for (const int p : t)
      for (int i = 0; i < 3; ++i) f32(out, mesh.points[static_cast<std::size_t>(p)][i]);
    u16(out, 0);
  }
  return out;
}

std::string ply_file(const Mesh& mesh, PlyData data) {
  const bool binary = data == PlyData::binary;
  std::string out = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") + " 1.0\nelement vertex " +
                    std::to_string(mesh.points.size()) + "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.points) {
    for (int i = 0; i < 3; ++i) {
      if (binary) f32(out, p[i]);
      else out += decimal(p[i]) + (i < 2 ? " " : "\n");
    }
  }
  for (const auto& t : mesh.triangles) {
    out += binary ? std::string(1, '\3') : std::string("3");
    for (const int p : t) {
      if (binary) u32(out, static_cast<std::uint32_t>(p));
      else out += " " + std::to_string(p);
    }
    if (!binary) out += "\n";
  }
  return out;
}

std::string three_ds_file(const std::vector<Mesh>& meshes, const ThreeDsWish& wish) {
  std::string objects;
  for (const Mesh& mesh : meshes) {
    std::string points, faces, own_axes;
    u16(points, static_cast<unsigned>(mesh.points.size()));
    for (const Vec3& p : mesh.points)
      for (int i = 0; i < 3; ++i) f32(points, p[i]);
    u16(faces, static_cast<unsigned>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
      for (const int p : t) u16(faces, static_cast<unsigned>(p));
      u16(faces, 7);
    }
    // Where the object's x, y and z lie, and its origin.
    const std::array<Vec3, 3> axes = wish.quarter_about_z ? std::array{Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1)}
                                                          : std::array{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (const Vec3& row : {axes[0], axes[1], axes[2], wish.origin})
      for (int i = 0; i < 3; ++i) f32(own_axes, row[i]);
    objects += chunk(0x4000, mesh.name + '\0' + chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces) + chunk(0x4160, own_axes)));
  }
  if (!wish.tree) return chunk(0x4d4d, chunk(0x3d3d, objects));
  const auto track = [](unsigned id, const std::vector<double>& values) {
    std::string body(10, '\0');  // flags, unused
    u32(body, 1);                // one key
    u32(body, 0);                // at frame 0
    u16(body, 0);                // without ease
    for (const double v : values) f32(body, v);
    return chunk(id, body);
  };
  std::string nodes;
  for (const Mesh& mesh : meshes) {
    std::string header = mesh.name + '\0', pivot;
    u16(header, 0);
    u16(header, 0);
    u16(header, 0xffff);
    for (int i = 0; i < 3; ++i) f32(pivot, 0.0);
    // An angle and its axis; 3DS turns the other way round.
    nodes += chunk(0xb002, chunk(0xb010, header) + chunk(0xb013, pivot) + track(0xb020, {wish.origin.x, wish.origin.y, wish.origin.z}) +
                               track(0xb021, {wish.quarter_about_z ? 1.5707963267948966 : 0.0, 0, 0, -1}) + track(0xb022, {1, 1, 1}));
  }
  return chunk(0x4d4d, chunk(0x3d3d, objects) + chunk(0xb000, nodes));
}

namespace {

std::string stored_blocks(const std::string& bytes) {
  std::string out;
  for (std::size_t at = 0; at < bytes.size() || at == 0;) {
    const std::size_t n = std::min<std::size_t>(bytes.size() - at, 65535);
    out += at + n >= bytes.size() ? '\1' : '\0';
    u16(out, static_cast<unsigned>(n));
    u16(out, static_cast<unsigned>(~n & 0xffff));
    out += bytes.substr(at, n);
    at += std::max<std::size_t>(n, 1);
  }
  return out;
}

}  // namespace

std::string gzip_stored(const std::string& bytes) {
  std::string out("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
  out += stored_blocks(bytes);
  std::uint32_t crc = ~0u;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  u32(out, ~crc);
  u32(out, static_cast<std::uint32_t>(bytes.size()));
  return out;
}

std::string zlib_stored(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::string out = std::string("\x78\x01", 2) + stored_blocks(bytes), sum;
  u32(sum, b << 16 | a);
  out.append(sum.rbegin(), sum.rend());
  return out;
}

}  // namespace cusp::test
