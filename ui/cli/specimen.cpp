// cusp specimen KIND [--fdi N --seed N --voxel-mm X] -o VOLUME

#include "scenarios/specimens/specimens.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/volume/specimen.h"
#include "scenarios/format/keys.h"
#include "scenarios/import/nrrd.h"
#include "ui/cli/outputs.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

struct SpecimenOptions {
  SpecimenSource source;
  bool neighbours = false, gingiva = false, bone = false;
  std::vector<std::string> lesions;  // KIND:SITE:RADIUS:DEPTH:SOFTNESS
  std::string out;
  JsonOption json;
  std::vector<std::string> typed;  // options, by their names
};

/// "fissure:central:0.8:1.0:0.7"; numbers may be left out from the end. Nothing when it is not of that form.
std::optional<LesionSource> lesion_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') parts.emplace_back();
    else parts.back() += c;
  }
  if (parts.size() < 2 || parts.size() > 5) return std::nullopt;
  if (std::ranges::find(kLesionKeys, parts[0]) == kLesionKeys.end() || parts[1].empty()) return std::nullopt;
  LesionSource out;
  out.kind = parts[0];
  out.site = parts[1];
  double* const numbers[] = {&out.radius_mm, &out.depth_mm, &out.softness};
  for (std::size_t i = 2; i < parts.size(); ++i) {
    const char* const end = parts[i].data() + parts[i].size();
    const auto [rest, error] = std::from_chars(parts[i].data(), end, *numbers[i - 2]);
    if (error != std::errc() || rest != end) return std::nullopt;
  }
  // The bounds of the format, so that what grows here can stand in an exercise.
  const bool fits = out.radius_mm >= 0.2 && out.radius_mm <= 4 && out.depth_mm >= 0 && out.depth_mm <= 5 &&
                    out.softness >= 0 && out.softness <= 1;
  return fits ? std::optional(out) : std::nullopt;
}

constexpr std::array<std::string_view, 7> kOfTeeth = {"--fdi", "--seed", "--typodont", "--neighbours", "--gingiva", "--bone", "--lesion"};

/// Names the first option that this kind of specimen does not have; nullopt: it has all.
std::optional<QString> foreign_option(const SpecimenOptions& o) {
  const bool tooth = o.source.generator == "tooth", of_one_size = o.source.generator == "paper-block";
  for (const std::string& option : o.typed) {
    const QString name = QString::fromStdString(option);
    if ((!tooth && std::ranges::find(kOfTeeth, option) != kOfTeeth.end()) || (of_one_size && option == "--voxel-mm"))
      return CliText::tr("%1 has no effect on %2.").arg(name, QString::fromStdString(o.source.generator));
    if (o.source.typodont && option == "--lesion") return CliText::tr("%1 has no effect on a tooth of plastic: it has no carious lesion.").arg(name);
  }
  return std::nullopt;
}

int specimen_verb(const SpecimenOptions& options) {
  SpecimenOptions o = options;
  if (const auto vain = foreign_option(o)) return wrong_usage(*vain);
  if (const auto no = refuse_outputs({o.out, o.json.file})) return failed(*no);
  if (o.neighbours) o.source.around.emplace_back("neighbours");
  if (o.gingiva) o.source.around.emplace_back("gingiva");
  if (o.bone) o.source.around.emplace_back("bone");
  for (const std::string& text : o.lesions) o.source.lesions.push_back(lesion_of(text).value());
  auto volume = make_specimen(o.source, {});
  if (!volume) return failed(describe(volume.error()));
  if (auto written = write_nrrd(*volume, o.out); !written) return failed(describe(written.error()));
  nlohmann::ordered_json json;
  json["volume"] = o.out;
  json["size"] = {volume->grid.size.x, volume->grid.size.y, volume->grid.size.z};
  json["voxel_mm"] = volume->grid.voxel_mm;
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) print_line(o.out);
  return kDone;
}

}  // namespace

void add_specimen(CLI::App& program, Job& job) {
  auto o = std::make_shared<SpecimenOptions>();
  o->source.fdi = 36;
  CLI::App* verb = program.add_subcommand("specimen", help(CliText::tr("Grow a specimen and write its volume")));
  verb->add_option("KIND", o->source.generator, help(CliText::tr("tooth, block, layered-block or paper-block")))
      ->required()
      ->check(CLI::IsMember({"tooth", "block", "layered-block", "paper-block"}));
  verb->add_option("--fdi", o->source.fdi, help(CliText::tr("Tooth number, 11 to 48")))->transform(decimal)->capture_default_str();
  verb->add_option("--seed", o->source.seed, help(CliText::tr("Natural variation; 0 = the average tooth")))->transform(decimal)->check(check_whole)->capture_default_str();
  verb->add_option("--voxel-mm", o->source.voxel_mm, help(CliText::tr("Edge of a voxel in millimetres")))
      ->check(check_positive)
      ->capture_default_str();
  verb->add_flag("--typodont", o->source.typodont, help(CliText::tr("A tooth of plastic, as in a training model")));
  verb->add_flag("--neighbours", o->neighbours, help(CliText::tr("With the teeth that touch it")));
  verb->add_flag("--gingiva", o->gingiva, help(CliText::tr("With the gingiva about it")));
  verb->add_flag("--bone", o->bone, help(CliText::tr("With the bone and the ligament about its roots")));
  verb->add_option("--lesion", o->lesions,
                   help(CliText::tr("Carious lesion: fissure, proximal or root, then its place, radius and depth in millimetres, and "
                                     "softness from 0 to 1")))
      ->type_name("KIND:SITE:RADIUS:DEPTH:SOFTNESS")
      ->check([](const std::string& text) { return lesion_of(text) ? std::string() : text; });
  verb->add_option("-o,--output", o->out, help(CliText::tr("Volume to write (NRRD)")))->type_name("VOLUME")->required()->check(check_file_name);
  o->json.add_to(*verb);
  verb->callback([&job, o, verb] {
    for (const CLI::Option* option : verb->parse_order()) o->typed.push_back(option->get_name());
    job = [o] { return specimen_verb(*o); };
  });
}

}  // namespace cusp::ui
