/// What the options of cusp import mean, and what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "scenarios/import/import.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"

namespace cusp::ui {

struct ImportOptions {
  std::vector<std::string> files;
  std::string out, up = "z", hollows, precedence = std::string(kPrecedenceKeys[0]);
  std::vector<std::string> tissues, from, turns;
  double unit_mm = 1.0, scale = 1.0;
  std::optional<double> voxel_mm, mend_mm;
  bool list = false, largest = false;
  JsonOption json;
  std::vector<std::string> typed;  // options, by their names
};

/// The file's axis that is to be up; nullopt: none is called so.
std::optional<UpAxis> up_axis(const std::string& text);

/// Length of a unit of the file as it is to be taken.
double unit_of(const ImportOptions& o);

/// An axis of the specimen, and whether it is turned against the right-hand rule.
struct QuarterTurn {
  int axis = 0, quarters = 1;
};
/// nullopt: one of them is no axis.
std::optional<std::vector<QuarterTurn>> turns_of(const ImportOptions& o);

/// What was typed as an image's tissues, or why it is wrong.
Result<ImageTissues, QString> image_tissues(const ImportOptions& o, UpAxis up);

/// What was typed as the import of meshes, or why it is wrong.
Result<MeshImport, QString> mesh_import(const ImportOptions& o, UpAxis up);

/// Names the first option that changes nothing of what is made, or listed; nullopt: each does.
std::optional<QString> without_effect(const ImportOptions& o);

/// Names a file that would not be read; nullopt: all are.
std::optional<QString> unread_file(const ImportOptions& o);

/// Why the volume would lie under the name of another kind of file; nullopt: it would not.
std::optional<QString> misleading_name(const ImportOptions& o);

/// Whether the volume that is made is a binvox, by its ending.
bool is_binvox(const ImportOptions& o);

}  // namespace cusp::ui
