// SPDX-License-Identifier: GPL-3.0-or-later
// Formats that we do not read ourselves, by the Open Asset Import Library where the program was built with
// it.
#include "io/readers.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#ifdef REEBQUAD_WITH_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <sstream>
#endif

namespace CGAL {
namespace Reeb_quadrangulation {

#ifdef REEBQUAD_WITH_ASSIMP

namespace {

// Formats of surfaces that are in use, and that the library reads without a second file beside them.
constexpr const char* wanted = "3mf 3ds ac amf ase blend dae dxf fbx lwo ms3d wrl x x3d zgl";

} // namespace

std::string other_mesh_formats() {
  const Assimp::Importer importer;
  std::istringstream words(wanted);
  std::string list;
  for (std::string extension; words >> extension;)
    if (importer.IsExtensionSupported("." + extension)) list += (list.empty() ? "" : " ") + extension;
  return list;
}

Result<Polygon_soup> parse_by_assimp(const char* data, std::size_t size, const std::string& extension,
                                     Notes& notes) {
  const std::string name = "A ." + extension + " file";
  Assimp::Importer importer;
  // Points and lines go, and all meshes are put to where the nodes place them.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFileFromMemory(
      data, size, aiProcess_PreTransformVertices | aiProcess_SortByPType, extension.c_str());
  if (!scene)
    return make_error(Error_code::malformed_file, name + " is not understood: " + importer.GetErrorString());
  Polygon_soup soup;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const std::int64_t first = soup.number_of_points();
    if (first + std::int64_t(mesh.mNumVertices) > largest_count)
      return make_error(Error_code::malformed_file, name + " has more than 2147483646 points.");
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      soup.points.emplace_back(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (std::int64_t(soup.corner.size()) + face.mNumIndices > largest_count)
        return make_error(Error_code::malformed_file, name + " has more than 2147483646 corners.");
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices)
          return make_error(Error_code::malformed_file, name + " has a face whose point does not exist.");
        soup.corner.push_back(int(first + face.mIndices[k]));
      }
      soup.close_polygon();
    }
  }
  notes.push_back("read by Assimp; coordinates have the precision of float");
  return soup;
}

#else

std::string other_mesh_formats() {
  return {};
}

Result<Polygon_soup> parse_by_assimp(const char*, std::size_t, const std::string& extension, Notes&) {
  return make_error(Error_code::unsupported_format,
                    "A ." + extension + " file is read only if the program is built with Assimp.");
}

#endif

} // namespace Reeb_quadrangulation
} // namespace CGAL
