/// Every patch in one vertex and one index buffer, so that a frame is one call. A patch keeps its place while it fits,
/// with some space to grow; one that outgrows it moves to a freed place or the end.
/// Thread: the one that holds the context.
#pragma once

#include <epoxy/gl.h>

#include <unordered_map>
#include <vector>

#include "ui/render/baked_patch.h"

namespace cusp::ui {

class MeshBuffers {
 public:
  MeshBuffers();
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  void put(const BakedPatch& patch);
  void clear();

  struct Drawn {
    std::size_t triangles = 0, bricks = 0;
  };
  /// Draws what may be seen: not outside the view, not facing away, not wholly behind the clip plane (a plane of zeros
  /// keeps all).
  Drawn draw(const glm::mat4& clip_from_world, Vec3f eye, glm::vec4 clip_plane);

 private:
  struct Place {
    int brick = -1;           // -1: free
    GLint first_vertex = 0, vertex_room = 0;
    GLint first_index = 0, index_room = 0;
    GLsizei indices = 0;
    Vec3f middle{0.0f}, cone_axis{0.0f};
    float radius = 0, cone_cos = -1;
  };
  std::size_t place_for(const BakedPatch& patch);
  struct Buffer {
    GLuint id = 0;
    std::size_t capacity_bytes = 0;
  };
  void grow(GLenum target, Buffer& buffer, std::size_t used_bytes, std::size_t needed_bytes);
  void describe();

  GLuint array_ = 0;
  Buffer vertices_, indices_;
  GLint vertex_end_ = 0, index_end_ = 0;            // used
  std::vector<Place> places_;
  std::vector<std::size_t> free_;
  std::unordered_map<int, std::size_t> place_of_;   // [brick]
  struct Seen {
    float distance;
    const Place* place;
  };
  std::vector<Seen> seen_;                          // of the frame being drawn, as what follows
  std::vector<GLsizei> counts_;
  std::vector<const void*> offsets_;
  std::vector<GLint> bases_;
};

}  // namespace cusp::ui
