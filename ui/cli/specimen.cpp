// cusp specimen KIND [--fdi N --seed N --voxel-mm X] -o VOLUME

#include "scenarios/specimens.h"

#include <nlohmann/json.hpp>

#include "engine/volume/specimen.h"
#include "scenarios/import/nrrd.h"
#include "ui/cli/verb.h"
#include "ui/cli/words.h"

namespace cusp {

namespace {

struct SpecimenOptions {
  SpecimenSource source;
  std::string out;
  JsonOption json;
};

int specimen_verb(const SpecimenOptions& o) {
  auto volume = make_specimen(o.source, {});
  if (!volume) return failed(tell(volume.error()));
  if (auto written = write_nrrd(*volume, o.out); !written) return failed(tell(written.error()));
  nlohmann::ordered_json json;
  json["volume"] = o.out;
  json["size"] = {volume->grid.size.x, volume->grid.size.y, volume->grid.size.z};
  json["voxel_mm"] = volume->grid.voxel_mm;
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) say(o.out);
  return kDone;
}

}  // namespace

void add_specimen(CLI::App& program, Job& job) {
  auto o = std::make_shared<SpecimenOptions>();
  o->source.fdi = 36;
  CLI::App* verb = program.add_subcommand("specimen", help(CliWords::tr("Grow a specimen and write its volume")));
  verb->add_option("KIND", o->source.generator, help(CliWords::tr("tooth, block, layered-block or paper-block")))
      ->required()
      ->check(CLI::IsMember({"tooth", "block", "layered-block", "paper-block"}));
  verb->add_option("--fdi", o->source.fdi, help(CliWords::tr("Tooth number, 11 to 48")))->capture_default_str();
  verb->add_option("--seed", o->source.seed, help(CliWords::tr("Natural variation; 0 = the average tooth")))->capture_default_str();
  verb->add_option("--voxel-mm", o->source.voxel_mm, help(CliWords::tr("Edge of a voxel in millimetres")))
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("-o,--output", o->out, help(CliWords::tr("Volume to write (NRRD)")))->type_name("VOLUME")->required();
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return specimen_verb(*o); }; });
}

}  // namespace cusp
