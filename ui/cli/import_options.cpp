#include "ui/cli/import_options.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "scenarios/import/header_text.h"
#include "scenarios/import/nrrd_image.h"
#include "ui/cli/text.h"

namespace cusp::ui {

namespace {

constexpr double kMeshVoxelMm = 0.1;  // a mesh has no voxel size: a tenth, as the teeth that come with the program

std::optional<PartPrecedence> precedence_named(const std::string& text) {
  for (std::size_t i = 0; i < kPrecedenceKeys.size(); ++i) {
    if (kPrecedenceKeys[i] == text) return static_cast<PartPrecedence>(i);
  }
  return std::nullopt;
}

/// NAME=TISSUE, split at the last "=".
std::optional<std::pair<std::string, Tissue>> pair_of(const std::string& text) {
  const auto split = text.rfind('=');
  const auto tissue = split == std::string::npos ? std::nullopt : tissue_from_key(text.substr(split + 1));
  if (!tissue) return std::nullopt;
  return std::pair(text.substr(0, split), *tissue);
}

QString not_a_pair(const std::string& text) {
  return CliText::tr("%1 is not MESH=TISSUE with a tissue such as enamel, dentine or pulp.").arg(QString::fromStdString(text));
}

constexpr std::array<std::string_view, 2> kOfMeshes = {"--mend-mm", "--precedence"};
constexpr std::array<std::string_view, 3> kOfVolumes = {"--from", "--hollows", "--largest-piece"};
constexpr std::array<std::string_view, 5> kOfBoth = {"--tissue", "--unit-mm", "--scale", "--voxel-mm", "--up"};
/// --list shows lengths in the unit that was typed.
constexpr std::array<std::string_view, 10> kOfMaking = {"--output", "--tissue",  "--from", "--hollows", "--largest-piece",
                                                        "--voxel-mm", "--mend-mm", "--up",   "--turn",    "--precedence"};

std::string ending_of(const std::string& file) { return lower(std::filesystem::path(file).extension().string()); }

}  // namespace

std::optional<UpAxis> up_axis(const std::string& text) {
  for (std::size_t i = 0; i < kUpAxisKeys.size(); ++i) {
    if (kUpAxisKeys[i] == text) return static_cast<UpAxis>(i);
  }
  return std::nullopt;
}

double unit_of(const ImportOptions& o) { return o.unit_mm * o.scale; }

std::optional<std::vector<QuarterTurn>> turns_of(const ImportOptions& o) {
  std::vector<QuarterTurn> out;
  for (const std::string& text : o.turns) {
    const bool back = text.starts_with('-');
    const std::string axis = text.substr(back ? 1 : 0);
    if (axis != "x" && axis != "y" && axis != "z") return std::nullopt;
    out.push_back({axis[0] - 'x', back ? -1 : 1});
  }
  return out;
}

Result<ImageTissues, QString> image_tissues(const ImportOptions& o, UpAxis up) {
  ImageTissues t;
  t.unit_mm = unit_of(o);
  t.voxel_mm = o.voxel_mm;
  t.up = up;
  t.largest_component = o.largest;
  for (const std::string& text : o.tissues) {
    const auto pair = pair_of(text);
    if (!pair) return std::unexpected(not_a_pair(text));
    const auto value = whole_number<std::uint32_t>(pair->first);
    if (!value) return std::unexpected(CliText::tr("%1 is no label of a volume: it takes its number.").arg(QString::fromStdString(pair->first)));
    t.labels.emplace_back(*value, pair->second);
  }
  for (const std::string& text : o.from) {
    const auto split = text.find('=');
    const auto tissue = tissue_from_key(text.substr(0, split));
    const auto value = split == std::string::npos ? std::nullopt : number(text.substr(split + 1));
    if (!tissue || !value) return std::unexpected(CliText::tr("%1 is not TISSUE=VALUE, such as dentine=1200.").arg(QString::fromStdString(text)));
    t.thresholds.emplace_back(*value, *tissue);
  }
  std::ranges::sort(t.thresholds, {}, [](const auto& pair) { return pair.first; });
  if (!o.hollows.empty()) {
    t.hollows = tissue_from_key(o.hollows);
    if (!t.hollows || *t.hollows == Tissue::empty) return std::unexpected(not_a_pair(o.hollows));
  }
  return t;
}

Result<MeshImport, QString> mesh_import(const ImportOptions& o, UpAxis up) {
  MeshImport what;
  what.path = o.files.front();
  what.more.assign(o.files.begin() + 1, o.files.end());
  what.unit_mm = unit_of(o);
  what.voxel_mm = o.voxel_mm.value_or(kMeshVoxelMm);
  what.mend_holes_mm = o.mend_mm;
  what.up = up;
  const auto precedence = precedence_named(o.precedence);
  if (!precedence) return std::unexpected(CliText::tr("%1 is no precedence: innermost or given.").arg(QString::fromStdString(o.precedence)));
  what.precedence = *precedence;
  for (const std::string& text : o.tissues) {
    const auto pair = pair_of(text);
    if (!pair || pair->second == Tissue::empty) return std::unexpected(not_a_pair(text));
    what.tissues.push_back(*pair);
  }
  if (what.tissues.empty())
    return std::unexpected(CliText::tr("--tissue MESH=TISSUE gives the tissue of each mesh; --list names the meshes."));
  return what;
}

std::optional<QString> without_effect(const ImportOptions& o) {
  const FileKind kind = file_kind(o.files.front());
  const bool specimen = kind == FileKind::image && nrrd_is_specimen(o.files.front());
  for (const std::string& option : o.typed) {
    const auto among = [&option](const auto& names) { return std::ranges::find(names, option) != names.end(); };
    const QString name = QString::fromStdString(option);
    if (o.list && among(kOfMaking)) return CliText::tr("%1 has no effect: --list makes nothing.").arg(name);
    if (o.list) continue;
    if (specimen && (among(kOfBoth) || among(kOfVolumes) || among(kOfMeshes)))
      return CliText::tr("%1 has no effect: %2 is a specimen’s volume already. Only --turn changes it.").arg(name, QString::fromStdString(o.files.front()));
    if (kind == FileKind::image && among(kOfMeshes)) return CliText::tr("%1 has no effect on a volume, only on meshes.").arg(name);
    if (kind == FileKind::mesh && among(kOfVolumes)) return CliText::tr("%1 has no effect on meshes, only on a volume.").arg(name);
  }
  return std::nullopt;
}

std::optional<QString> unread_file(const ImportOptions& o) {
  if (o.files.size() < 2 || file_kind(o.files.front()) != FileKind::image) return std::nullopt;
  if (are_slices_of_a_folder({o.files.begin(), o.files.end()})) return std::nullopt;
  return CliText::tr("%1 would not be read: a volume is imported alone.").arg(QString::fromStdString(o.files[1]));
}

std::optional<QString> misleading_name(const ImportOptions& o) {
  std::error_code unknown;
  const bool fits = is_binvox(o) || ending_of(o.out) == ".nrrd" || file_kind(o.out) == FileKind::unknown;
  if (fits || std::filesystem::is_directory(o.out, unknown)) return std::nullopt;
  return CliText::tr("%1 is the name of another kind of file: a volume is written as NRRD, or as binvox by its ending.").arg(QString::fromStdString(o.out));
}

bool is_binvox(const ImportOptions& o) { return ending_of(o.out) == ".binvox"; }

}  // namespace cusp::ui
