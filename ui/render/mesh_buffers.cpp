#include "ui/render/mesh_buffers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cusp::ui {
namespace {

constexpr GLint kSpareVertices = 16, kSpareIndices = 96;  // spare for growth while a cut makes a patch rougher
// Vertex normals are smoother than the triangles that they shade.
constexpr float kFaceMargin = 0.30f;  // radians

GLint rounded_up(std::size_t n, GLint spare) { return static_cast<GLint>((n + n / 4 + static_cast<std::size_t>(spare)) / 8 * 8); }

}  // namespace

MeshBuffers::MeshBuffers() {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_.id);
  glGenBuffers(1, &indices_.id);
}

MeshBuffers::~MeshBuffers() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_.id);
  glDeleteBuffers(1, &indices_.id);
}

void MeshBuffers::clear() {
  places_.clear();
  free_.clear();
  place_of_.clear();
  vertex_end_ = index_end_ = 0;
}

void MeshBuffers::describe() {
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id);
  constexpr GLsizei kStride = sizeof(PackedVertex);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  for (GLuint i = 0; i < 5; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(PackedVertex, position_mm)));
  glVertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, kStride, at(offsetof(PackedVertex, normal)));
  glVertexAttribIPointer(2, 4, GL_UNSIGNED_BYTE, kStride, at(offsetof(PackedVertex, tissue)));
  glVertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(PackedVertex, value)));
  glVertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(PackedVertex, colour)));
}

void MeshBuffers::grow(GLenum target, Buffer& buffer, std::size_t used_bytes, std::size_t needed_bytes) {
  if (needed_bytes <= buffer.capacity_bytes) return;
  const std::size_t bigger = std::max({needed_bytes, 2 * buffer.capacity_bytes, std::size_t{1} << 20});
  GLuint fresh = 0;
  glGenBuffers(1, &fresh);
  glBindVertexArray(0);
  glBindBuffer(target, fresh);
  glBufferData(target, static_cast<GLsizeiptr>(bigger), nullptr, GL_DYNAMIC_DRAW);
  if (used_bytes > 0) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, target, 0, 0, static_cast<GLsizeiptr>(used_bytes));
  }
  glDeleteBuffers(1, &buffer.id);
  buffer = {fresh, bigger};
  describe();
}

std::size_t MeshBuffers::place_for(const BakedPatch& patch) {
  const auto vertices = static_cast<GLint>(patch.vertices.size());
  const auto indices = static_cast<GLint>(patch.indices.size());
  const auto fits = [&](const Place& p) { return p.vertex_room >= vertices && p.index_room >= indices; };
  if (const auto it = place_of_.find(patch.brick); it != place_of_.end()) {
    if (fits(places_[it->second])) return it->second;
    places_[it->second].brick = -1;
    free_.push_back(it->second);
    place_of_.erase(it);
  }
  for (std::size_t i = 0; i < free_.size(); ++i) {
    // Not one that is far too large: small patches would use up the large places.
    if (!fits(places_[free_[i]]) || places_[free_[i]].vertex_room > 3 * vertices + 64) continue;
    const std::size_t at = free_[i];
    free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(i));
    place_of_[patch.brick] = at;
    return at;
  }
  Place fresh;
  fresh.first_vertex = vertex_end_;
  fresh.vertex_room = rounded_up(patch.vertices.size(), kSpareVertices);
  fresh.first_index = index_end_;
  fresh.index_room = rounded_up(patch.indices.size(), kSpareIndices);
  grow(GL_ARRAY_BUFFER, vertices_, static_cast<std::size_t>(vertex_end_) * sizeof(PackedVertex),
       static_cast<std::size_t>(vertex_end_ + fresh.vertex_room) * sizeof(PackedVertex));
  grow(GL_ELEMENT_ARRAY_BUFFER, indices_, static_cast<std::size_t>(index_end_) * sizeof(std::uint16_t),
       static_cast<std::size_t>(index_end_ + fresh.index_room) * sizeof(std::uint16_t));
  vertex_end_ += fresh.vertex_room;
  index_end_ += fresh.index_room;
  places_.push_back(fresh);
  place_of_[patch.brick] = places_.size() - 1;
  return places_.size() - 1;
}

void MeshBuffers::put(const BakedPatch& patch) {
  if (patch.indices.empty()) {
    if (const auto it = place_of_.find(patch.brick); it != place_of_.end()) {
      places_[it->second].brick = -1;
      free_.push_back(it->second);
      place_of_.erase(it);
    }
    return;
  }
  Place& place = places_[place_for(patch)];
  place.brick = patch.brick;
  place.indices = static_cast<GLsizei>(patch.indices.size());
  place.middle = 0.5f * (patch.low_mm + patch.high_mm);
  place.radius = 0.5f * glm::length(patch.high_mm - patch.low_mm);
  place.cone_axis = patch.cone_axis;
  place.cone_cos = patch.cone_cos;
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id);
  glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(place.first_vertex) * static_cast<GLintptr>(sizeof(PackedVertex)),
                  static_cast<GLsizeiptr>(patch.vertices.size() * sizeof(PackedVertex)), patch.vertices.data());
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLintptr>(place.first_index) * static_cast<GLintptr>(sizeof(std::uint16_t)),
                  static_cast<GLsizeiptr>(patch.indices.size() * sizeof(std::uint16_t)), patch.indices.data());
}

MeshBuffers::Drawn MeshBuffers::draw(const glm::mat4& clip_from_world, Vec3f eye, glm::vec4 clip_plane) {
  Drawn drawn;
  if (places_.empty()) return drawn;
  // The view's planes in the specimen frame, pointing in.
  const glm::mat4 rows = glm::transpose(clip_from_world);
  std::array<glm::vec4, 5> planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
                                     clip_plane};
  for (glm::vec4& p : planes) {
    const float size = glm::length(Vec3f(p));
    if (size > 1e-12f) p /= size;
  }
  seen_.clear();
  for (const Place& place : places_) {
    if (place.brick < 0) continue;
    bool inside = true;
    for (const glm::vec4& p : planes) inside = inside && glm::dot(Vec3f(p), place.middle) + p.w >= -place.radius;
    if (!inside) continue;
    const Vec3f from_eye = place.middle - eye;
    const float distance = glm::length(from_eye);
    if (distance > place.radius && place.cone_cos > 0.0f) {
      const float turned = std::acos(std::clamp(glm::dot(from_eye, place.cone_axis) / distance, -1.0f, 1.0f));
      const float spread = std::acos(std::min(place.cone_cos, 1.0f)) + std::asin(place.radius / distance) + kFaceMargin;
      if (turned + spread < 1.5707963f) continue;
    }
    seen_.push_back({distance, &place});
    drawn.triangles += static_cast<std::size_t>(place.indices) / 3;
    ++drawn.bricks;
  }
  if (seen_.empty()) return drawn;
  // Near ones first: what they hide is then never shaded.
  std::sort(seen_.begin(), seen_.end(), [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
  counts_.clear();
  offsets_.clear();
  bases_.clear();
  for (const Seen& seen : seen_) {
    counts_.push_back(seen.place->indices);
    offsets_.push_back(
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(seen.place->first_index) * sizeof(std::uint16_t)));
    bases_.push_back(seen.place->first_vertex);
  }
  glBindVertexArray(array_);
  glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_SHORT, offsets_.data(),
                                static_cast<GLsizei>(counts_.size()), bases_.data());
  return drawn;
}

}  // namespace cusp::ui
