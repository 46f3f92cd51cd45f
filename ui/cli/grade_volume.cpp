#include "ui/cli/grade_volume.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>

#include <nlohmann/json.hpp>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/grading/grader.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/recover_cut.h"
#include "scenarios/operators/fast_cut.h"
#include "scenarios/operators/fault_cut.h"
#include "ui/cli/load_scenario.h"
#include "ui/cli/outputs.h"
#include "ui/cli/report_files.h"
#include "ui/cli/terminal.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/session/file_bytes.h"
#include "ui/session/scene_builder.h"
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

using FilesBeside = std::map<std::string, std::vector<std::byte>>;

/// The volume's own file, which belongs to the content hash.
Result<FilesBeside, Message> files_beside(const LoadedScenario& loaded) {
  const std::string& name = loaded.scenario.specimen.volume;
  if (!loaded.scenario.specimen.generator.empty() || name.empty()) return FilesBeside{};
  auto bytes = bytes_of(loaded.folder / name);
  if (!bytes) return std::unexpected(describe(import_failure_of(bytes.error())));
  FilesBeside out;
  out[name] = std::move(*bytes);
  return out;
}

std::filesystem::path report_of(const std::string& folder) { return std::filesystem::path(folder) / "report.json"; }

std::string report_of(const LoadedScenario& loaded, const FilesBeside& beside, const SessionResult& result) {
  ReportHead head;
  head.scenario_id = loaded.scenario.id.text();
  head.scenario_version = loaded.scenario.version;
  head.scenario_hash = content_hash(loaded.scenario, beside).hex();
  head.operator_name = result.operator_name;
  head.state = "finished";
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(result.volume_hash));
  head.volume_hash = hash;
  return report_json(head, result.grade, report_texts(result));
}

Result<Volume, Message> volume_of_file(const std::string& file, const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  const auto prepared = read_nrrd(file);
  if (!prepared) return std::unexpected(describe(prepared.error()));
  auto volume = recover_cut(std::move(specimen), *prepared);
  if (!volume) return std::unexpected(describe_mismatch(volume.error(), QString::fromStdString(file), scenario));
  return std::move(*volume);
}

/// What an operator's cut leaves, and how long it worked dry.
struct Cut {
  Volume volume;
  double dry_s = 0;
};

Result<Cut, Message> cut_of(const FaultCut& cut, std::shared_ptr<const Specimen> specimen) {
  Cut out{Volume(std::move(specimen)), cut.dry_s};
  if (!cut_along(cut, out.volume)) return std::unexpected(Message{CliText::tr("More is cut than a volume of this exercise can keep."), {}});
  return out;
}

Result<Cut, Message> cut_of_operator(const std::string& name, const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  const auto fault = sized_fault_by_name(name);
  const Message cannot{CliText::tr("This exercise cannot have the fault %1: it has nothing to make it on.").arg(QString::fromStdString(name)), {}};
  if (name == "pulp" && std::ranges::find(scenario.tissues, Tissue::pulp, &ScenarioTissue::tissue) == scenario.tissues.end())
    return std::unexpected(cannot);
  const auto plan = plan_by_name(fault ? "reference" : name, scenario, *specimen);
  if (!plan || plan->strokes.empty()) return std::unexpected(Message{no_plan_text(scenario), {}});
  if (!fault) return cut_of({{{*plan, scenario.instruments[plan->bur]}}, 0.0}, std::move(specimen));
  const auto faulty = fault_cut(*fault, scenario, *specimen, *plan);
  if (!faulty) return std::unexpected(cannot);
  return cut_of(*faulty, std::move(specimen));
}

Result<Cut, Message> cut_of_file(const std::string& file, const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  auto volume = volume_of_file(file, scenario, std::move(specimen));
  if (!volume) return std::unexpected(std::move(volume.error()));
  return Cut{std::move(*volume), 0.0};
}

}  // namespace

int grade_volume(const GradeVolumeOptions& o, const JsonOption& json) {
  const bool cuts = !o.operator_name.empty();
  std::vector<std::filesystem::path> outputs = {json.file};
  if (!o.out.empty()) std::ranges::copy(report_files_in(o.out), std::back_inserter(outputs));
  std::vector<std::filesystem::path> inputs = scenario_files(o.scenario);
  inputs.emplace_back(o.rubric);
  inputs.emplace_back(o.volume);
  if (const auto no = refuse_outputs(outputs, {}, inputs)) return failed(*no);
  auto loaded = load_scenario(o.scenario);
  if (!loaded) return failed(loaded.error());
  Scenario& scenario = loaded->scenario;
  if (!o.rubric.empty()) {
    auto rubric = read_rubric(o.rubric, scenario);
    if (!rubric) return failed(rubric.error());
    scenario.rubric = std::move(*rubric);
  }
  auto specimen = build_specimen(scenario, loaded->folder);
  if (!specimen) return failed(describe(specimen.error()));
  const auto beside = files_beside(*loaded);
  if (!beside) return failed(beside.error());
  auto cut = cuts ? cut_of_operator(o.operator_name, scenario, *specimen) : cut_of_file(o.volume, scenario, *specimen);
  if (!cut) return failed(cut.error());
  SessionResult result;
  result.scenario = scenario;
  result.operator_name = o.operator_name;
  result.volume = std::make_shared<const Volume>(std::move(cut->volume));
  result.volume_hash = result.volume->hash();
  result.measures = measure(Reference(scenario, *specimen), *result.volume, Process::lasting(cut->dry_s, cut->dry_s), show_progress);
  end_progress();
  result.grade = grade(scenario, result.measures);
  const std::string text = report_of(*loaded, *beside, result);
  if (!o.out.empty()) {
    if (const auto fits = writable_folder(o.out); !fits) return failed(nothing_written_to(o.out, fits.error().detail));
    if (const auto done = write_whole(report_of(o.out), text); !done) return failed(cannot_write(report_of(o.out), done.error().detail));
    if (auto written = write_paper(o.out, gather_report(result, nullptr, nullptr)); !written) return failed(written.error());
  }
  if (!json.write(nlohmann::ordered_json::parse(text))) return kFailed;
  if (json.on_stdout()) return kDone;
  print_grade(result);
  return kDone;
}

}  // namespace cusp::ui
