// The one file that knows assimp.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <new>
#include <string_view>

#include "scenarios/import/header_text.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/limits.h"
#include "scenarios/import/triangle_mesh.h"

namespace cusp::scenarios {
namespace {

using Transform = aiMatrix4x4t<double>;

Transform transform_of(const aiMatrix4x4& m) {
  return {m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4};
}

/// The library turns 3DS from z up to y up, and no other format. This gives a 3DS file's own axes back.
Transform file_of_3ds() { return {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}; }

class Collector {
 public:
  enum class NamesIn : std::uint8_t { meshes, nodes };  // nodes: as in 3DS, whose meshes have numbers
  Collector(const aiScene& scene, std::string file_stem, NamesIn names_in)
      : scene_(scene), file_stem_(std::move(file_stem)), by_node_(names_in == NamesIn::nodes) {}

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
    const aiString &first = by_node_ ? node.mName : from.mName, &second = by_node_ ? from.mName : node.mName;
    TriangleMesh& to = named(utf8_name(first.length > 0 ? first.C_Str() : second.length > 0 ? second.C_Str() : file_stem_));
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
  bool by_node_;
  std::map<std::string, std::size_t> index_;
  std::vector<TriangleMesh> meshes_;
  bool finite_ = true;
};

/// The chosen file alone: what it names besides (materials, pictures, other models) is not opened.
class OneFile : public Assimp::DefaultIOSystem {
 public:
  explicit OneFile(std::string path) : path_(std::move(path)) {}
  bool Exists(const char* file) const override { return file == path_ && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return file == path_ && std::string_view(mode).starts_with('r') ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  std::string path_;
};

/// Whether a PLY file can hold as many elements as its header counts: assimp reserves memory for any number.
bool ply_can_be_true(const std::filesystem::path& path, std::uintmax_t bytes) {
  constexpr int kMostLines = 1000;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  for (int n = 0; n < kMostLines && std::getline(in, line); ++n) {
    while (line.ends_with('\r') || line.ends_with(' ')) line.pop_back();
    if (line == "end_header") return true;
    const auto word = tokens(line);
    if (word.size() != 3 || word[0] != "element") continue;
    const auto count = whole_number<std::uintmax_t>(word[2]);
    if (!count || *count > bytes) return false;  // each takes a byte at the least
  }
  return false;
}

/// assimp passes on a file's own indices, and its later steps use them unchecked.
bool faces_name_their_points(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 0) return false;  // taken for a polygon, and counted as a triangle
      for (unsigned i = 0; i < face.mNumIndices; ++i)
        if (face.mIndices[i] >= mesh.mNumVertices) return false;
    }
  }
  return true;
}

Result<std::vector<TriangleMesh>, ImportFailure> read(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  // Of the forty kinds that the library knows these alone are meshes of parts and nothing more.
  constexpr std::string_view kinds[] = {".stl", ".obj", ".ply", ".3ds", ".off"};
  if (std::ranges::find(kinds, std::string_view(lower(path.extension().string()))) == std::end(kinds))
    return fail(ImportError::unknown_format, name);
  std::error_code ec;
  if (lower(path.extension().string()) == ".ply" && !ply_can_be_true(path, std::filesystem::file_size(path, ec)))
    return fail(ImportError::bad_header, name);
  Assimp::Importer importer;
  importer.SetIOHandler(new OneFile(path.string()));  // the importer's from here on
  // Only positions: normals and texture seams would part the points of one place.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                  aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                  aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS |
                                  aiComponent_MATERIALS);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene && !faces_name_their_points(*scene)) return fail(ImportError::corrupt, name, "a face names no point, or one that is not there");
  if (scene) scene = importer.ApplyPostProcessing(aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType);
  if (!scene || !scene->mRootNode) return fail(ImportError::corrupt, name, importer.GetErrorString());
  const bool is_3ds = lower(path.extension().string()) == ".3ds";
  Collector collector(*scene, path.stem().string(), is_3ds ? Collector::NamesIn::nodes : Collector::NamesIn::meshes);
  collector.visit(*scene->mRootNode, is_3ds ? file_of_3ds() : Transform());
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
  const std::uintmax_t bytes = std::filesystem::file_size(path, ec), allowed = VolumeLimits{}.max_mesh_bytes;
  if (bytes > allowed)
    return fail(ImportError::too_large, name, text_of({LimitKind::file_bytes, static_cast<double>(bytes), static_cast<double>(allowed)}));
  try {
    return read(path);
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, name);
  } catch (const std::exception& e) {
    return fail(ImportError::corrupt, name, e.what());
  }
}

}  // namespace cusp::scenarios
