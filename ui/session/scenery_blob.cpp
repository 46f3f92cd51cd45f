#include "ui/session/scenery_blob.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace cusp::ui {
namespace {

// Numbers as this machine has them: the bytes stay on it, for the build that wrote them.
static_assert(std::endian::native == std::endian::little);
constexpr std::uint64_t kMostSurfaces = 64;

template <class T>
void put(std::vector<std::byte>& out, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(std::span(&value, 1));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

template <class T>
void put_all(std::vector<std::byte>& out, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  put(out, static_cast<std::uint64_t>(values.size()));
  const auto bytes = std::as_bytes(std::span(values));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

class SceneryReader {
 public:
  explicit SceneryReader(std::span<const std::byte> bytes) : left_(bytes) {}
  template <class T>
  T one() {
    T out{};
    copy(&out, 1, sizeof(T));
    return out;
  }
  template <class T>
  std::vector<T> all() {
    const auto count = one<std::uint64_t>();
    std::vector<T> out(count <= left_.size() / sizeof(T) ? static_cast<std::size_t>(count) : 0);
    good_ = good_ && out.size() == count;
    copy(out.data(), out.size(), sizeof(T));
    return out;
  }
  bool good() const { return good_; }
  bool at_end() const { return good_ && left_.empty(); }

 private:
  void copy(void* to, std::size_t count, std::size_t size) {
    good_ = good_ && left_.size() >= count * size;
    if (!good_ || count == 0) return;
    std::memcpy(to, left_.data(), count * size);
    left_ = left_.subspan(count * size);
  }
  std::span<const std::byte> left_;
  bool good_ = true;
};

bool is_mesh(const SceneryMesh& mesh) {
  const std::size_t points = mesh.points_mm.size();
  return mesh.normals.size() == points && mesh.tissue.size() == points && mesh.ambient.size() == points &&
         mesh.triangles.size() % 3 == 0 && mesh.seen <= mesh.triangles.size() &&
         std::ranges::all_of(mesh.triangles, [points](std::uint32_t at) { return at < points; }) &&
         std::ranges::all_of(mesh.tissue, [](Tissue t) { return index_of(t) < kTissueCodes; }) && index_of(mesh.within) < kTissueCodes;
}

}  // namespace

std::vector<std::byte> scenery_bytes(const std::vector<JawSurface>& scenery) {
  std::vector<std::byte> out;
  put(out, static_cast<std::uint64_t>(scenery.size()));
  for (const JawSurface& one : scenery) {
    put(out, one.fdi);
    put(out, static_cast<std::uint64_t>(one.mesh.seen));
    put(out, one.mesh.within);
    put_all(out, one.mesh.points_mm);
    put_all(out, one.mesh.normals);
    put_all(out, one.mesh.tissue);
    put_all(out, one.mesh.ambient);
    put_all(out, one.mesh.triangles);
  }
  return out;
}

std::optional<std::vector<JawSurface>> scenery_from_bytes(std::span<const std::byte> bytes) {
  SceneryReader in(bytes);
  const auto count = in.one<std::uint64_t>();
  if (count > kMostSurfaces) return std::nullopt;
  std::vector<JawSurface> out(static_cast<std::size_t>(count));
  for (JawSurface& one : out) {
    one.fdi = in.one<int>();
    one.mesh.seen = static_cast<std::size_t>(in.one<std::uint64_t>());
    one.mesh.within = in.one<Tissue>();
    one.mesh.points_mm = in.all<glm::vec3>();
    one.mesh.normals = in.all<glm::vec3>();
    one.mesh.tissue = in.all<Tissue>();
    one.mesh.ambient = in.all<std::uint8_t>();
    one.mesh.triangles = in.all<std::uint32_t>();
    if (!in.good() || !is_mesh(one.mesh)) return std::nullopt;
  }
  if (!in.at_end()) return std::nullopt;
  return out;
}

}  // namespace cusp::ui
