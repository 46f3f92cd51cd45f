// cusp template list, cusp template fit KEY --tooth N [--volume FILE] [--set name=value ...] --out DIR

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/quarter_turn.h"
#include "scenarios/landmarks/propose.h"
#include "scenarios/specimens/taken_codes.h"
#include "scenarios/templates/templates.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

struct TemplateOptions {
  std::string key, volume, out;
  int tooth = 36;
  std::uint64_t seed = 0;
  std::vector<std::string> set;  // name=value
  JsonOption json;
};

/// "depth=1.6".
std::optional<std::pair<std::string, double>> assignment_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + equals + 1, end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return std::pair{text.substr(0, equals), value};
}

nlohmann::ordered_json to_json(const ExerciseTemplate& one) {
  nlohmann::ordered_json out;
  out["key"] = one.key;
  out["name"] = one.name;
  out["about"] = one.about;
  out["parameters"] = nlohmann::ordered_json::array();
  for (const TemplateParameter& p : one.parameters)
    out["parameters"].push_back({{"key", p.key}, {"name", p.name}, {"unit", p.unit}, {"range", {p.least, p.most}}, {"default", p.value}, {"source", p.source}});
  return out;
}

/// With a digit after the decimal sign, two where they are needed.
QString bound_text(double value) {
  const double tenths = value * 10;
  return format_number(value, std::abs(tenths - std::round(tenths)) < 1e-6 ? 1 : 2);
}

/// "0.05 … 0.3 mm", "0 or 1".
QString range_text_of(const TemplateParameter& p) {
  if (p.is_choice()) return CliText::tr("0 or 1");
  return u"%1 … %2 %3"_qs.arg(bound_text(p.least), bound_text(p.most), QString::fromStdString(p.unit)).trimmed();
}

QString describe_fit(const FitFailure& failure, const std::string& key) {
  const QString where = QString::fromStdString(failure.where), detail = QString::fromStdString(failure.detail);
  const auto of = std::ranges::find(exercise_templates(), key, &ExerciseTemplate::key);
  switch (failure.code) {
    case FitError::unknown_template: return CliText::tr("%1 is no template: cusp template list names them.").arg(where);
    case FitError::unsuitable_tooth: return CliText::tr("Tooth %1 is no premolar or molar.").arg(where);
    case FitError::unknown_parameter: return CliText::tr("The template has no parameter %1.").arg(where);
    case FitError::out_of_range:
      if (detail == u"0, 1"_qs) return CliText::tr("%1 has to be 0 or 1.").arg(where);
      return CliText::tr("%1 has to be within %2.")
          .arg(where, range_text_of(*std::ranges::find(of->parameters, failure.where, &TemplateParameter::key)));
    case FitError::unmet_need: return local(std::ranges::find(of->needs, failure.where, &TemplateNeed::key)->text);
    case FitError::missing_landmark:
      if (detail == u"no_room"_qs)
        return CliText::tr("With these values nothing is left of the fissures that the preparation follows. A narrower marginal ridge leaves more.");
      return CliText::tr("The tooth lacks what the template is laid along: %1.").arg(where);
    case FitError::missing_tissue: {
      const auto tissue = scenario_tissue_from_key(failure.where);
      return CliText::tr("The file does not hold what the template needs: %1.").arg(tissue ? tissue_name(*tissue) : where);
    }
    case FitError::turned_tooth: return CliText::tr("The tooth lies %1 degrees off: x has to be mesial or distal, y buccal, z occlusal.").arg(where);
    case FitError::does_not_fit: return CliText::tr("These values make no exercise: %1 (%2).").arg(where, detail);
    case FitError::bad_template: break;
  }
  return CliText::tr("The template is broken at %1 (%2).").arg(where, detail);
}

int list(const JsonOption& json) {
  if (const auto no = refuse_outputs({json.file})) return failed(*no);
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const ExerciseTemplate& one : exercise_templates()) out.push_back(to_json(one));
  if (!json.write(out)) return kFailed;
  if (json.on_stdout()) return kDone;
  for (const ExerciseTemplate& one : exercise_templates()) {
    print_line(one.key + "  " + plain(local(one.about)));
    for (const TemplateParameter& p : one.parameters)
      print_line(plain(u"  %1  %2: %3"_qs.arg(QString::fromStdString(p.key), -11).arg(local(p.name), range_text_of(p))));
  }
  return kDone;
}

constexpr const char* kToothFile = "tooth.nrrd";

/// A tooth from a file, turned by quarters until its sides are those of its frame, and its proposed landmarks.
struct OwnTooth {
  VoxelVolume volume;
  SpecimenLandmarks landmarks;
};

Result<OwnTooth, Message> own_tooth(const std::string& file, int fdi) {
  auto volume = read_nrrd(file);
  if (!volume) return std::unexpected(describe(volume.error()));
  if (const auto refused = refuse_taken_codes(*volume, std::filesystem::path(file).filename().string())) return std::unexpected(describe(*refused));
  auto landmarks = propose_landmarks(*volume, fdi);
  if (!landmarks && landmarks.error().code == ProposeError::unknown_fdi) return std::unexpected(Message{CliText::tr("%1 is no tooth’s number.").arg(fdi), {}});
  if (!landmarks) return std::unexpected(Message{CliText::tr("%1 holds no tooth.").arg(QString::fromStdString(file)), {}});
  const int quarters = static_cast<int>(std::lround(turn_deg(*landmarks).value_or(0.0) / 90.0));
  if (quarters == 0) return OwnTooth{std::move(*volume), std::move(*landmarks)};
  VoxelVolume turned = quarter_turned(*volume, 2, -quarters);
  auto again = propose_landmarks(turned, fdi);
  return OwnTooth{std::move(turned), std::move(again.value())};
}

/// The kinds of the landmarks that were proposed.
nlohmann::ordered_json proposed_json(const SpecimenLandmarks& landmarks) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Landmark& mark : landmarks.marks) out.push_back(mark.name.empty() ? std::string(key_of(mark.kind)) : std::string(key_of(mark.kind)) + " " + mark.name);
  return out;
}

/// Whether a file stands there that no template would make again: an author's work, or something else that is not ours to replace.
bool is_work(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return false;
  const auto there = read_scenario_file(file);
  if (!there || !there->made_with || there->specimen.generator != "tooth") return true;
  const auto made = fit_template({.key = there->made_with->key,
                                  .fdi = there->specimen.fdi,
                                  .seed = there->specimen.seed,
                                  .values = there->made_with->values,
                                  .id = there->id});
  return !made || *made != *there;
}

int fit(const TemplateOptions& o) {
  const std::filesystem::path file = std::filesystem::path(o.out) / "scenario.json", tooth_file = std::filesystem::path(o.out) / kToothFile;
  if (const auto no = refuse_outputs({file, tooth_file, o.json.file}, {}, {o.volume})) return failed(*no);
  FitRequest request;
  request.key = o.key;
  request.fdi = o.tooth;
  request.seed = o.seed;
  request.id = ScenarioId::make();
  for (const std::string& text : o.set) {
    const auto [name, value] = assignment_of(text).value();
    if (!request.values.emplace(name, value).second) return wrong_usage(CliText::tr("%1 is set twice.").arg(QString::fromStdString(name)));
  }
  std::optional<OwnTooth> own;
  if (!o.volume.empty()) {
    auto read = own_tooth(o.volume, o.tooth);
    if (!read) return failed(read.error());
    own = std::move(*read);
    request.imported = ImportedTooth{kToothFile, own->volume.grid.voxel_mm, facts_of(own->volume).tissues, own->landmarks};
  }
  const auto scenario = fit_template(request);
  if (!scenario) return failed(describe_fit(scenario.error(), o.key));
  if (is_work(file))
    return failed(Message{CliText::tr("%1 is there already, and somebody may have edited it.").arg(QString::fromStdString(file.string())),
                          CliText::tr("Nothing was written. Give another folder.")});
  if (const auto fits = writable_folder(o.out); !fits) return failed(nothing_written_to(o.out, fits.error().detail));
  nlohmann::ordered_json json = {{"scenario", file.string()}, {"id", scenario->id.text()}};
  if (own) {
    if (auto written = write_nrrd(own->volume, tooth_file); !written) return failed(describe(written.error()));
    json["volume"] = tooth_file.string();
    json["proposed"] = proposed_json(own->landmarks);
  }
  // After its volume.
  if (const auto written = write_whole(file, write_scenario(*scenario)); !written) return failed(cannot_write(file, written.error().detail));
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) print_line(file.string());
  return kDone;
}

}  // namespace

void add_template(CLI::App& program, Job& job) {
  auto o = std::make_shared<TemplateOptions>();
  CLI::App* verb = program.add_subcommand("template", help(CliText::tr("Exercises from templates: a preparation fitted to a tooth by its landmarks")));
  verb->require_subcommand(1);
  CLI::App* listed = verb->add_subcommand("list", help(CliText::tr("The templates, and the parameters of each")));
  o->json.add_to(*listed);
  listed->callback([&job, o] { job = [o] { return list(o->json); }; });
  CLI::App* fitted = verb->add_subcommand("fit", help(CliText::tr("Write the exercise of a template on a tooth: scenario.json in DIR")));
  fitted->add_option("KEY", o->key, help(CliText::tr("The template's key")))->required();
  fitted->add_option("--tooth", o->tooth, help(CliText::tr("FDI number of a premolar or molar")))->required()->transform(decimal);
  CLI::Option* seed = fitted->add_option("--seed", o->seed, help(CliText::tr("Natural variation; 0 = the average tooth")))->transform(decimal)->check(check_whole)->capture_default_str();
  fitted->add_option("--volume", o->volume, help(CliText::tr("A tooth of your own (NRRD), its landmarks proposed; it is copied to DIR")))
      ->type_name("FILE")
      ->check(check_not_empty)
      ->excludes(seed);
  fitted->add_option("--set", o->set, help(CliText::tr("A parameter's value; may be given many times")))
      ->type_name("NAME=VALUE")
      ->check([](const std::string& text) { return assignment_of(text) ? std::string() : text; });
  fitted->add_option("--out", o->out, help(CliText::tr("Folder for scenario.json")))->type_name("DIR")->required()->check(check_not_empty);
  o->json.add_to(*fitted);
  fitted->callback([&job, o] { job = [o] { return fit(*o); }; });
}

}  // namespace cusp::ui
