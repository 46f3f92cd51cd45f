// The one file that knows assimp.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <map>
#include <new>

#include "scenarios/import/triangle_mesh.h"

namespace cusp {
namespace {

using Transform = aiMatrix4x4t<double>;

Transform transform_of(const aiMatrix4x4& m) {
  return {m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4};
}

class Collector {
 public:
  Collector(const aiScene& scene, std::string file_stem) : scene_(scene), file_stem_(std::move(file_stem)) {}

  void visit(const aiNode& node, const Transform& file_from_parent) {
    const Transform file_from_node = file_from_parent * transform_of(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], node, file_from_node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], file_from_node);
  }
  std::vector<TriangleMesh> take() { return std::move(meshes_); }
  bool finite() const noexcept { return finite_; }

 private:
  void add(const aiMesh& from, const aiNode& node, const Transform& file_from_node) {
    if (!(from.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) return;
    TriangleMesh& to = named(from.mName.length > 0   ? from.mName.C_Str()
                             : node.mName.length > 0 ? node.mName.C_Str()
                                                     : file_stem_);
    const auto base = static_cast<std::uint32_t>(to.points.size());
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& v = from.mVertices[i];
      const aiVector3t<double> p = file_from_node * aiVector3t<double>(v.x, v.y, v.z);
      to.points.emplace_back(p.x, p.y, p.z);
      finite_ &= std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices != 3) continue;
      to.triangles.push_back({base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]});
    }
  }
  TriangleMesh& named(const std::string& name) {
    const auto [it, is_new] = index_.try_emplace(name, meshes_.size());
    if (is_new) meshes_.push_back({name, {}, {}});
    return meshes_[it->second];
  }

  const aiScene& scene_;
  std::string file_stem_;
  std::map<std::string, std::size_t> index_;
  std::vector<TriangleMesh> meshes_;
  bool finite_ = true;
};

Result<std::vector<TriangleMesh>, ImportFailure> read(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  Assimp::Importer importer;
  if (!importer.IsExtensionSupported(path.extension().string())) return fail(ImportError::unknown_format, name);
  // Only positions: normals and texture seams would part the points of one place.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                  aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                  aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS |
                                  aiComponent_MATERIALS);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene =
      importer.ReadFile(path.string(), aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType);
  if (!scene || !scene->mRootNode) return fail(ImportError::corrupt, name, importer.GetErrorString());
  Collector collector(*scene, path.stem().string());
  collector.visit(*scene->mRootNode, Transform{});
  if (!collector.finite()) return fail(ImportError::corrupt, name, "coordinates are not numbers");
  std::vector<TriangleMesh> meshes = collector.take();
  for (TriangleMesh& m : meshes) weld(m);
  if (meshes.empty()) return fail(ImportError::no_mesh, name);
  return meshes;
}

}  // namespace

Result<std::vector<TriangleMesh>, ImportFailure> read_meshes(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (!std::filesystem::exists(status)) return fail(ImportError::missing_file, name);
  if (!std::filesystem::is_regular_file(status)) return fail(ImportError::io, name);
  try {
    return read(path);
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, name);
  } catch (const std::exception& e) {
    return fail(ImportError::corrupt, name, e.what());
  }
}

}  // namespace cusp
