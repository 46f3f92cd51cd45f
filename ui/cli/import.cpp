// cusp import FILE... -o VOLUME

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/volume/cut_volume.h"
#include "engine/volume/specimen.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/nrrd_image.h"
#include "scenarios/import/quarter_turn.h"
#include "scenarios/import/worker.h"
#include "scenarios/specimens/taken_codes.h"
#include "ui/cli/import_options.h"
#include "ui/cli/outputs.h"
#include "ui/cli/terminal.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/cli/interrupt.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/text/import_text.h"

namespace cusp::ui {

namespace {

/// Ctrl+C stops the child, and with it the import, within a moment.
class StopOnInterrupt {
 public:
  StopOnInterrupt() { catch_interrupt(); }
  std::stop_token token() { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watch_{[this](const std::stop_token& over) {
    while (!over.stop_requested()) {
      if (interrupted()) source_.request_stop();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }};
};

std::vector<std::filesystem::path> paths_of(const ImportOptions& o) { return {o.files.begin(), o.files.end()}; }

nlohmann::ordered_json json_of(Vec3 v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json json_of(const MeshInfo& m) {
  nlohmann::ordered_json gaps = nlohmann::ordered_json::array();
  for (const MeshGap& gap : m.gaps) gaps.push_back({{"at", json_of(gap.middle())}, {"width", gap.width()}, {"edges", gap.edges}});
  return {{"name", m.name},     {"triangles", m.triangles}, {"low", json_of(m.low)},     {"high", json_of(m.high)},
          {"volume", m.volume}, {"closed", m.closed},       {"oriented", m.oriented}, {"gap_count", m.gap_count}, {"gaps", gaps}};
}

nlohmann::ordered_json json_of(const ImageInfo& i) {
  nlohmann::ordered_json values = nlohmann::ordered_json::array();
  for (const auto& [value, voxels] : i.values) values.push_back({{"value", value}, {"voxels", voxels}});
  return {{"kind", i.specimen ? "specimen" : std::string(kImageKindKeys[static_cast<std::size_t>(i.kind)])},
          {"size", {i.size.x, i.size.y, i.size.z}},
          {"spacing_mm", json_of(i.spacing_mm)},
          {"spacing_known", i.spacing_known},
          {"low", i.low},
          {"high", i.high},
          {"series", i.series},
          {"slices", i.slices},
          {"values", values}};
}

void print_mesh(const MeshInfo& m, double unit_mm) {
  const Vec3 size = (m.high - m.low) * unit_mm;
  const QString mm = QStringLiteral("%1 × %2 × %3").arg(size.x, 0, 'f', 2).arg(size.y, 0, 'f', 2).arg(size.z, 0, 'f', 2);
  const QString state = !m.closed ? CliText::tr("open") : m.oriented ? CliText::tr("closed") : CliText::tr("turned inside out");
  print_line(plain(CliText::tr("%1: %n triangle(s), %2, %3 mm", nullptr, static_cast<int>(m.triangles))
                .arg(QString::fromStdString(m.name), state, mm)));
  for (const MeshGap& gap : m.gaps) {
    const Vec3 at = gap.middle() * unit_mm;
    print_line(plain(QStringLiteral("  ") + CliText::tr("gap of %1 mm at %2, %3, %4 mm")
                          .arg(gap.width() * unit_mm, 0, 'f', 2)
                          .arg(at.x, 0, 'f', 2)
                          .arg(at.y, 0, 'f', 2)
                          .arg(at.z, 0, 'f', 2)));
  }
}

void print_image(const ImageInfo& i) {
  print_line(plain(CliText::tr("%1 × %2 × %3 voxels of %4 × %5 × %6 mm")
                .arg(i.size.x).arg(i.size.y).arg(i.size.z)
                .arg(i.spacing_mm.x, 0, 'g', 4).arg(i.spacing_mm.y, 0, 'g', 4).arg(i.spacing_mm.z, 0, 'g', 4)));
  if (!i.spacing_known) print_line(plain(CliText::tr("The file does not give the size of a voxel; --unit-mm does.")));
  if (i.kind == ImageKind::grey) print_line(plain(CliText::tr("Grey values from %1 to %2").arg(i.low).arg(i.high)));
  for (const auto& [value, voxels] : i.values) {
    print_line(plain(CliText::tr("%1: %n voxel(s)", nullptr, static_cast<int>(voxels)).arg(value)));
  }
}

int list_verb(const ImportOptions& o) {
  StopOnInterrupt stop;
  const auto seen = look_in_child(paths_of(o), {}, show_progress, stop.token());
  end_progress();
  if (!seen) return failed(describe(seen.error()));
  nlohmann::ordered_json json;
  json["meshes"] = nlohmann::ordered_json::array();
  for (const MeshInfo& m : seen->meshes) {
    json["meshes"].push_back(json_of(m));
    if (!o.json.on_stdout()) print_mesh(m, unit_of(o));
  }
  if (seen->image) {
    json["image"] = json_of(*seen->image);
    if (!o.json.on_stdout()) print_image(*seen->image);
  }
  return o.json.write(json) ? kDone : kFailed;
}

/// A label map whose numbers are tissue codes needs no --tissue.
Result<void, ImportFailure> take_codes_as_they_are(const ImportOptions& o, ImageTissues& t, std::stop_token stop) {
  const auto seen = look_in_child(paths_of(o), {}, show_progress, std::move(stop));
  if (!seen) return std::unexpected(seen.error());
  if (!seen->image || seen->image->specimen || seen->image->kind != ImageKind::labels) return {};
  for (const auto& [value, voxels] : seen->image->values) {
    if (!is_tissue_code(value)) return fail(ImportError::bad_tissue, std::to_string(value));
    t.labels.emplace_back(value, static_cast<Tissue>(value));
  }
  return {};
}

struct Done {
  VoxelVolume volume;
  std::vector<ImportRemark> remarks;
};

std::string key_of_code(double code) {
  const auto i = static_cast<std::size_t>(code);
  return i < kTissueKeys.size() ? std::string(kTissueKeys[i]) : std::to_string(i);
}

nlohmann::ordered_json json_of(const ImportRemark& remark) {
  nlohmann::ordered_json out = {{"code", std::string(key_of(remark.code))}, {"subject", remark.subject}, {"numbers", remark.numbers}};
  if (!remark.other.empty()) out["other"] = remark.other;
  return out;
}

/// What was made: where, how large, of what, and which mesh won over which.
nlohmann::ordered_json json_of(const ImportOptions& o, const Done& done, const SolidMeasure& measure) {
  const VoxelVolume& volume = done.volume;
  const SpecimenFacts facts = facts_of(volume);
  nlohmann::ordered_json json;
  json["volume"] = o.out;
  json["size"] = {volume.grid.size.x, volume.grid.size.y, volume.grid.size.z};
  json["voxel_mm"] = volume.grid.voxel_mm;
  json["low_mm"] = json_of(facts.low_mm);
  json["high_mm"] = json_of(facts.high_mm);
  json["tissues"] = nlohmann::ordered_json::array();
  json["mm3"] = nlohmann::ordered_json::object();
  for (const Tissue t : facts.tissues) {
    const std::string key = key_of_code(static_cast<double>(index_of(t)));
    json["tissues"].push_back(key);
    json["mm3"][key] = measure.mm3[index_of(t)];
  }
  json["precedence"] = nlohmann::ordered_json::array();
  json["remarks"] = nlohmann::ordered_json::array();
  for (const ImportRemark& remark : done.remarks) {
    if (remark.code == RemarkCode::precedence)
      json["precedence"].push_back({{"mesh", remark.subject}, {"tissue", key_of_code(remark.numbers.at(1))}});
    json["remarks"].push_back(json_of(remark));
  }
  return json;
}

void print_result(const Done& done, const SolidMeasure& measure) {
  std::vector<ImportRemark> notes = done.remarks;
  std::erase_if(notes, [](const ImportRemark& r) { return r.code == RemarkCode::size_odd; });  // the warning
  for (const QString& line : describe(notes)) print_line(plain(line));
  for (const Tissue t : facts_of(done.volume).tissues)
    print_line(plain(QStringLiteral("%1: %2 mm³").arg(tissue_name(t, done.volume.names)).arg(measure.mm3[index_of(t)], 0, 'f', 1)));
}

int finish(const ImportOptions& o, const Done& done) {
  const VoxelVolume& volume = done.volume;
  if (auto written = is_binvox(o) ? write_binvox(binvox_of(volume), o.out) : write_nrrd(volume, o.out); !written)
    return failed(describe(written.error()));
  const SolidMeasure measure = specimen_solid(*Specimen::build(volume, Reading::banded));
  if (!o.json.write(json_of(o, done, measure))) return kFailed;
  for (const ImportRemark& remark : done.remarks)
    if (remark.code == RemarkCode::size_odd) warn(describe(remark) + u' ' + CliText::tr("--scale takes the factor."));
  if (o.json.on_stdout()) return kDone;
  print_result(done, measure);
  print_line(o.out);
  return kDone;
}

/// What was typed as the import of an image, and the import.
Result<VoxelVolume, ImportFailure> volume_from_image(const ImportOptions& o, ImageTissues tissues, std::stop_token stop,
                                                     std::vector<ImportRemark>& remarks) {
  ImageImport what;
  what.path = o.files.front();
  what.tissues = std::move(tissues);
  if (what.tissues.labels.empty() && what.tissues.thresholds.empty()) {
    if (auto r = take_codes_as_they_are(o, what.tissues, stop); !r) return std::unexpected(r.error());
  }
  return import_image_in_child(what, {}, show_progress, std::move(stop), &remarks);
}

int import_verb(const ImportOptions& o) {
  const std::vector<std::filesystem::path> files = paths_of(o);
  if (const auto no = refuse_outputs({o.out, o.json.file})) return failed(*no);
  if (const auto no = refuse_outputs({o.json.file}, {}, files)) return failed(*no);
  if (const auto vain = without_effect(o)) return wrong_usage(*vain);
  if (o.list) return list_verb(o);
  if (o.out.empty()) return wrong_usage(CliText::tr("-o VOLUME is missing: the file to write."));
  for (const auto wrong : {unread_file, misleading_name})
    if (const auto what = wrong(o)) return wrong_usage(*what);
  // A specimen's volume may be turned in its place: nothing of it is lost.
  if (const auto no = refuse_outputs({o.out}, {}, files); no && !nrrd_is_specimen(files.front())) return failed(*no);
  const auto up = up_axis(o.up);
  if (!up) return wrong_usage(CliText::tr("%1 is no axis: x, y, z, -x, -y or -z.").arg(QString::fromStdString(o.up)));
  const auto turns = turns_of(o);
  if (!turns) return wrong_usage(CliText::tr("--turn takes x, y, z, -x, -y or -z."));
  StopOnInterrupt stop;
  Done done;
  Result<VoxelVolume, ImportFailure> volume;
  if (file_kind(o.files.front()) == FileKind::image) {
    auto tissues = image_tissues(o, *up);
    if (!tissues) return wrong_usage(tissues.error());
    volume = volume_from_image(o, std::move(*tissues), stop.token(), done.remarks);
  } else {
    const auto what = mesh_import(o, *up);
    if (!what) return wrong_usage(what.error());
    volume = import_mesh_in_child(*what, {}, show_progress, stop.token(), &done.remarks);
  }
  end_progress();
  if (!volume) return failed(describe(volume.error()));
  if (const auto refused = refuse_taken_codes(*volume, files.front().filename().string())) return failed(describe(*refused));
  done.volume = std::move(*volume);
  for (const QuarterTurn& turn : *turns) done.volume = quarter_turned(done.volume, turn.axis, turn.quarters);
  return finish(o, done);
}

}  // namespace

void add_import(CLI::App& program, Job& job) {
  auto o = std::make_shared<ImportOptions>();
  CLI::App* verb = program.add_subcommand("import", help(CliText::tr("Make a specimen volume of closed meshes, of a label volume or of a CT series")));
  verb->add_option("FILE", o->files, help(CliText::tr("STL, OBJ, PLY, 3DS, OFF (several are put together), NRRD, MetaImage, NIfTI, binvox, or a folder of DICOM slices")))
      ->required()
      ->check(check_not_empty);
  verb->add_option("-o,--output", o->out, help(CliText::tr("Volume to write (NRRD, or binvox by its ending)")))->type_name("VOLUME")->check(check_file_name);
  verb->add_option("--tissue", o->tissues, help(CliText::tr("What a mesh or a label is made of; once for each to be taken")))
      ->type_name("MESH=TISSUE");
  verb->add_option("--from", o->from, help(CliText::tr("The tissue from a grey value on, up to the next; “empty” leaves out")))
      ->type_name("TISSUE=VALUE");
  verb->add_option("--hollows", o->hollows, help(CliText::tr("What closed hollows of a volume are made of")))->type_name("TISSUE");
  verb->add_flag("--largest-piece", o->largest, help(CliText::tr("Of a volume keep only the largest connected component")));
  verb->add_option("--unit-mm", o->unit_mm, help(CliText::tr("Length of one unit of the file in millimetres")))
      ->check(check_positive)
      ->capture_default_str();
  verb->add_option("--scale", o->scale, help(CliText::tr("Factor on the unit, as 0.1 for a tooth that came in ten times too long")))
      ->check(check_positive)
      ->capture_default_str();
  verb->add_option("--voxel-mm", o->voxel_mm, help(CliText::tr("Edge of a voxel in millimetres; 0.1 for meshes, the file’s own for volumes")))
      ->check(check_positive);
  verb->add_option("--mend-mm", o->mend_mm, help(CliText::tr("Mend meshes, and close holes up to this width in millimetres")))
      ->check(check_not_negative);
  verb->add_option("--up", o->up, help(CliText::tr("The file's axis towards the chewing surface")))->capture_default_str();
  verb->add_option("--turn", o->turns, help(CliText::tr("A quarter turn of what was made about this axis, by the right hand; -x turns back; may be repeated")))
      ->type_name("AXIS")
      ->allow_extra_args(false);
  verb->add_option("--precedence", o->precedence,
                   help(CliText::tr("Which mesh wins where several overlap: the innermost one, or the first --tissue given")))
      ->capture_default_str();
  verb->add_flag("--list", o->list, help(CliText::tr("Only list what the file holds")));
  o->json.add_to(*verb);
  verb->callback([&job, o, verb] {
    for (const CLI::Option* option : verb->parse_order()) o->typed.push_back(option->get_name());
    // A shell completes a folder's name with a slash, behind which a path has no name to report.
    for (std::string& file : o->files)
      while (file.size() > 1 && file.ends_with('/')) file.pop_back();
    job = [o] { return import_verb(*o); };
  });
}

}  // namespace cusp::ui
