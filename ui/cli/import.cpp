// cusp import FILE -o VOLUME

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/volume/specimen.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/worker.h"
#include "ui/cli/verb.h"
#include "ui/cli/words.h"

namespace cusp {

namespace {

struct ImportOptions {
  std::string file, out, up = "z";
  std::vector<std::string> tissues;
  double unit_mm = 1.0, voxel_mm = 0.1;
  bool list = false;
  JsonOption json;
};

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int) { interrupted = 1; }

/// Ctrl+C stops the child, and with it the import, within a moment.
class StopOnInterrupt {
 public:
  StopOnInterrupt() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
  }
  std::stop_token token() { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watch_{[this](const std::stop_token& over) {
    while (!over.stop_requested()) {
      if (interrupted) source_.request_stop();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }};
};

std::optional<UpAxis> up_axis(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, UpAxis>, 6> axes = {{{"z", UpAxis::z},
                                                                        {"y", UpAxis::y},
                                                                        {"x", UpAxis::x},
                                                                        {"-z", UpAxis::minus_z},
                                                                        {"-y", UpAxis::minus_y},
                                                                        {"-x", UpAxis::minus_x}}};
  for (const auto& [key, axis] : axes) {
    if (key == text) return axis;
  }
  return std::nullopt;
}

int list_verb(const ImportOptions& o) {
  StopOnInterrupt stop;
  auto meshes = list_meshes_in_child(o.file, {}, stop.token());
  if (!meshes) return failed(tell(meshes.error()));
  nlohmann::ordered_json json;
  json["meshes"] = nlohmann::ordered_json::array();
  for (const MeshInfo& m : *meshes) {
    json["meshes"].push_back({{"name", m.name},
                              {"triangles", m.triangles},
                              {"low", {m.low.x, m.low.y, m.low.z}},
                              {"high", {m.high.x, m.high.y, m.high.z}},
                              {"volume", m.volume},
                              {"closed", m.closed},
                              {"oriented", m.oriented}});
    if (!o.json.on_stdout()) {
      say(plain(CliWords::tr("%1: %n triangle(s), %2", nullptr, static_cast<int>(m.triangles))
                    .arg(QString::fromStdString(m.name), m.closed ? CliWords::tr("closed") : CliWords::tr("open"))));
    }
  }
  return o.json.write(json) ? kDone : kFailed;
}

int import_verb(const ImportOptions& o) {
  if (o.list) return list_verb(o);
  if (o.out.empty()) return wrong_usage(CliWords::tr("Say with -o where the volume is to be written."));
  std::string ending = std::filesystem::path(o.file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::expected<VoxelVolume, ImportFailure> volume;
  if (ending == ".nrrd") {
    volume = read_nrrd(o.file);
  } else {
    MeshImport what;
    what.path = o.file;
    what.unit_mm = o.unit_mm;
    what.voxel_mm = o.voxel_mm;
    const auto up = up_axis(o.up);
    if (!up) return wrong_usage(CliWords::tr("%1 is no axis: x, y, z, -x, -y or -z.").arg(QString::fromStdString(o.up)));
    what.up = *up;
    for (const std::string& pair : o.tissues) {
      const auto split = pair.rfind('=');
      const auto tissue = split == std::string::npos ? std::nullopt : tissue_from_key(pair.substr(split + 1));
      if (!tissue || *tissue == Tissue::empty) {
        return wrong_usage(CliWords::tr("%1 is not MESH=TISSUE with a tissue such as enamel, dentine or pulp.")
                               .arg(QString::fromStdString(pair)));
      }
      what.tissues.emplace_back(pair.substr(0, split), *tissue);
    }
    if (what.tissues.empty()) {
      return wrong_usage(CliWords::tr("Say with --tissue MESH=TISSUE what each mesh is made of; --list names the meshes."));
    }
    StopOnInterrupt stop;
    volume = import_mesh_in_child(what, {}, {}, stop.token());
  }
  if (!volume) return failed(tell(volume.error()));
  if (auto written = write_nrrd(*volume, o.out); !written) return failed(tell(written.error()));

  const SpecimenFacts facts = facts_of(*volume);
  nlohmann::ordered_json json;
  json["volume"] = o.out;
  json["size"] = {volume->grid.size.x, volume->grid.size.y, volume->grid.size.z};
  json["voxel_mm"] = volume->grid.voxel_mm;
  json["low_mm"] = {facts.low_mm.x, facts.low_mm.y, facts.low_mm.z};
  json["high_mm"] = {facts.high_mm.x, facts.high_mm.y, facts.high_mm.z};
  json["tissues"] = nlohmann::ordered_json::array();
  for (const Tissue t : facts.tissues) {
    const auto code = index_of(t);
    json["tissues"].push_back(code < kTissueKeys.size() ? std::string(kTissueKeys[code]) : std::to_string(code));
  }
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) say(o.out);
  return kDone;
}

}  // namespace

void add_import(CLI::App& program, Job& job) {
  auto o = std::make_shared<ImportOptions>();
  CLI::App* verb = program.add_subcommand("import", help(CliWords::tr("Make a specimen volume of closed meshes or of a label volume")));
  verb->add_option("FILE", o->file, help(CliWords::tr("OBJ, STL, PLY … or NRRD")))->required();
  verb->add_option("-o,--output", o->out, help(CliWords::tr("Volume to write (NRRD)")))->type_name("VOLUME");
  verb->add_option("--tissue", o->tissues, help(CliWords::tr("What a mesh is made of; once for each mesh to be taken")))
      ->type_name("MESH=TISSUE");
  verb->add_option("--unit-mm", o->unit_mm, help(CliWords::tr("Length of one unit of the file in millimetres")))
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--voxel-mm", o->voxel_mm, help(CliWords::tr("Edge of a voxel in millimetres")))
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--up", o->up, help(CliWords::tr("The file's axis towards the chewing surface")))->capture_default_str();
  verb->add_flag("--list", o->list, help(CliWords::tr("Only name the meshes of the file")));
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return import_verb(*o); }; });
}

}  // namespace cusp
