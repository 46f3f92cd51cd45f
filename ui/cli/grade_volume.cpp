#include "ui/cli/grade_volume.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <nlohmann/json.hpp>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/grading/grader.h"
#include "scenarios/grading/report_json.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/recover_cut.h"
#include "scenarios/specimens/specimens.h"
#include "ui/cli/load_scenario.h"
#include "ui/cli/outputs.h"
#include "ui/cli/report_files.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

Message describe_mismatch(const Failure<RecoverError>& failure, const QString& file, const Scenario& scenario) {
  const QString detail = QString::fromStdString(failure.detail);
  switch (failure.code) {
    case RecoverError::other_voxel:
      return {CliText::tr("%1 has voxels of %2 mm, the exercise’s specimen of %3 mm.")
                  .arg(file, format_number(detail.toDouble(), 3), format_number(scenario.specimen.voxel_mm, 3)),
              {}};
    case RecoverError::other_frame:
      return {CliText::tr("The voxels of %1 lie between those of the exercise’s specimen: it is in another frame.").arg(file), {}};
    case RecoverError::other_tissue:
      return {CliText::tr("%1 is of another specimen: %2 mm³ of it stand where this exercise’s specimen has no tissue.")
                  .arg(file, format_number(detail.toDouble(), 2)),
              {}};
    case RecoverError::other_surface:
      return {CliText::tr("The surface of %1 is not that of the exercise’s specimen. A volume of labels knows it to half a voxel only: "
                          "give one with distances, as cusp replay --volume writes it.")
                  .arg(file),
              {}};
    case RecoverError::too_much_cut: break;
  }
  return {CliText::tr("In %1 more is cut than a volume of this exercise can keep.").arg(file), {}};
}

/// The volume's own file, which belongs to the content hash.
std::map<std::string, std::vector<std::byte>> files_beside(const LoadedScenario& loaded) {
  const std::string& name = loaded.scenario.specimen.volume;
  if (!loaded.scenario.specimen.generator.empty() || name.empty()) return {};
  std::ifstream in(loaded.folder / name, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto* begin = reinterpret_cast<const std::byte*>(bytes.data());
  return {{name, {begin, begin + bytes.size()}}};
}

std::string report_of(const LoadedScenario& loaded, const Volume& volume, const Grade& grade) {
  ReportHead head;
  head.scenario_id = loaded.scenario.id.text();
  head.scenario_version = loaded.scenario.version;
  head.scenario_hash = content_hash(loaded.scenario, files_beside(loaded)).hex();
  head.state = "finished";
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(volume.hash()));
  head.volume_hash = hash;
  ReportTexts texts;
  texts.label = [](const CriterionGrade& c) { return plain(metric_name(c.id)); };
  texts.reason = [](const CriterionGrade& c) { return plain(reason_text(c)); };
  return report_json(head, grade, texts);
}

}  // namespace

int grade_volume(const GradeVolumeOptions& o, const JsonOption& json) {
  const std::filesystem::path report = o.out.empty() ? std::filesystem::path() : std::filesystem::path(o.out) / "report.json";
  if (const auto no = refuse_outputs({report, json.file})) return failed(*no);
  auto loaded = load_scenario(o.scenario);
  if (!loaded) return failed(loaded.error());
  Scenario& scenario = loaded->scenario;
  if (!o.rubric.empty()) {
    auto rubric = read_rubric(o.rubric, scenario);
    if (!rubric) return failed(rubric.error());
    scenario.rubric = std::move(*rubric);
  }
  const auto prepared = read_nrrd(o.volume);
  if (!prepared) return failed(describe(prepared.error()));
  const auto untouched = make_specimen(scenario.specimen, loaded->folder);
  if (!untouched) return failed(describe(untouched.error()));
  const auto specimen = Specimen::build(*untouched, reading_of(scenario.method));
  const auto volume = recover_cut(specimen, *prepared);
  if (!volume) return failed(describe_mismatch(volume.error(), QString::fromStdString(o.volume), scenario));
  const Grade result = grade(scenario, measure(Reference(scenario, specimen), *volume, Process()));
  const std::string text = report_of(*loaded, *volume, result);
  if (!o.out.empty() && (!writable_folder(o.out) || !write_whole(report, text)))
    return failed(CliText::tr("%1 cannot be written.").arg(QString::fromStdString(report.string())));
  if (!json.write(nlohmann::ordered_json::parse(text))) return kFailed;
  if (json.on_stdout()) return kDone;
  print_grade(result);
  return kDone;
}

}  // namespace cusp::ui
