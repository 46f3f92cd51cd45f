#include "ui/editor/editor_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "ui/editor/commands.h"
#include "ui/editor/target_names.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool finite(const Region& region) {
  const Outline& o = region.outline;
  bool all = finite(region.from_mm) && finite(region.to_mm) && finite(region.size_mm) && finite(region.x_axis) && finite(region.z_axis) &&
             finite(o.box_size_mm);
  for (const double v : {region.radius_mm, region.end_radius_mm, region.rounding_mm, region.by_mm, o.width_mm, o.depth_mm, o.top_mm,
                         o.corner_radius_mm, o.taper_deg[0], o.taper_deg[1], o.taper_deg[2], o.taper_deg[3]}) {
    all = all && std::isfinite(v);
  }
  for (const auto& path : o.paths) {
    for (const Vec3& p : path) all = all && finite(p);
  }
  return all && std::ranges::all_of(region.parts, [](const Region& part) { return finite(part); });
}

bool finite(const SpecimenSource& specimen) {
  return std::isfinite(specimen.voxel_mm) && std::ranges::all_of(specimen.lesions, [](const LesionSource& lesion) {
    return std::isfinite(lesion.radius_mm) && std::isfinite(lesion.depth_mm) && std::isfinite(lesion.softness);
  });
}

bool finite(const SpecimenLandmarks& landmarks) {
  return std::ranges::all_of(landmarks.marks, [](const Landmark& mark) {
    return std::ranges::all_of(mark.points_mm, [](Vec3 p) { return finite(p); });
  });
}

/// No landmark changes the voxels.
bool has_same_voxels(const SpecimenSource& a, SpecimenSource b) {
  b.landmarks = a.landmarks;
  return a == b;
}

/// The writer of scenario.json refuses numbers that are not finite.
bool finite(const Scenario& s) {
  bool all = finite(s.target) && finite(s.specimen) && finite(s.specimen.landmarks) && std::isfinite(s.leeway.floor_mm) && std::isfinite(s.leeway.side_mm) && std::isfinite(s.time_limit_s) && std::isfinite(s.expected_time_s) &&
             std::isfinite(s.rubric.pass) && std::isfinite(s.tool_tilt_deg) && std::isfinite(s.tool_turn_deg);
  for (const Criterion& c : s.rubric.criteria) {
    const Bands& b = c.bands;
    for (const double v : {c.weight, b.fail_lo, b.acc_lo, b.ideal_lo, b.ideal_hi, b.acc_hi, b.fail_hi}) {
      all = all && std::isfinite(v);
    }
  }
  for (const Bur& b : s.instruments) {
    for (const double v : {b.radius_mm, b.neck_radius_mm, b.neck_length_mm, b.shank_radius_mm, b.shank_length_mm}) {
      all = all && std::isfinite(v);
    }
  }
  for (const ScenarioTissue& v : s.tissues) {
    all = all && std::isfinite(v.stiffness_n_per_mm) && std::isfinite(v.speed_mm_s);
  }
  return all;
}

constexpr std::string_view kBySize = "Ø ";

/// A name that the author gave stays.
void name_by_size(std::vector<Bur>& burs, std::size_t index) {
  Bur& bur = burs[index];
  const bool of_size = bur.name.starts_with(kBySize);
  if (!of_size && fits_its_number(bur)) return;
  const auto free = [&](std::string_view name) {
    return std::ranges::none_of(burs, [&](const Bur& other) { return &other != &bur && other.name == name; });
  };
  if (const CatalogueBur* same = catalogue_bur_like(bur); same != nullptr && free(same->bur.name)) {
    bur = same->bur;
    return;
  }
  const std::string plain = std::string(kBySize) + QString::number(2 * bur.radius_mm, 'g', 6).toStdString();
  bur.name = plain;
  for (int i = 2; !free(bur.name); ++i) bur.name = plain + " (" + std::to_string(i) + ")";
}

}  // namespace

EditorModel::EditorModel(EditorStart start, QObject* parent)
    : QObject(parent),
      scenario_(std::move(start.draft)),
      published_(std::move(start.published)),
      folder_(std::move(start.folder)),
      part_(first_outline(scenario_.target)),
      grown_from_(scenario_.specimen) {
  check();
}

bool EditorModel::edit(const QString& text, const QString& field, const std::function<void(Scenario&)>& change) {
  Scenario after = scenario_;
  change(after);
  settle_targets(scenario_, after);
  if (after == scenario_) return true;
  if (!finite(after)) return false;
  // The reader of the format decides what an exercise may hold: a draft must open again.
  const auto back = read_scenario(canonical_json(after));
  if (!back || !(*back == after)) return false;
  stack_.push(new ScenarioEdit(scenario_, std::move(after), text, field, gesture_, [this] { after_change(); }));
  return true;
}

void EditorModel::after_change() {
  if (part_at(scenario_.target, part_) == nullptr) choose_part(part_);
  if (!has_same_voxels(scenario_.specimen, grown_from_)) {
    grown_from_ = scenario_.specimen;
    facts_.reset();
    pulp_mm_.clear();
    specimen_.reset();
    Q_EMIT specimen_changed();
  }
  check();
  Q_EMIT changed();
}

bool EditorModel::unchanged() const {
  if (!published_) return false;
  Scenario same = *published_;
  same.version = scenario_.version;
  return same == scenario_;
}

bool EditorModel::tried() const {
  if (!tried_) return false;
  Scenario same = *tried_;
  same.version = scenario_.version;
  same.title = scenario_.title;
  same.briefing = scenario_.briefing;
  same.level = scenario_.level;
  same.expected_time_s = scenario_.expected_time_s;
  same.self_assessment = scenario_.self_assessment;
  return same == scenario_;
}

void EditorModel::now_tried(TryOut fresh) {
  if (fresh.by == TriedBy::author || fresh.by == TriedBy::reference) tried_ = fresh.played;
  try_outs_.keep(std::move(fresh));
  Q_EMIT tried_out();
}

EditorModel::Standing EditorModel::standing() const {
  if (has_error(findings_)) return Standing::failing;
  if (unchanged()) return Standing::unchanged;
  return facts_ ? Standing::ready : Standing::unproved;
}

void EditorModel::now_published(const Scenario& version) {
  published_ = version;
  stack_.clear();
  scenario_.version = version.version + 1;
  after_change();
}

bool EditorModel::take(const Scenario& draft) {
  if (draft.id != scenario_.id) return false;
  end_gesture();
  const bool taken = edit(tr("The other window’s draft"), u"draft"_qs, [&](Scenario& s) {
    const int version = s.version;
    s = draft;
    s.version = version;
  });
  end_gesture();
  return taken;
}

bool EditorModel::set_title(const std::string& language, const QString& text) {
  return edit(tr("Title"), u"title/"_qs + QString::fromStdString(language), [&](Scenario& s) {
    if (text.isEmpty()) {
      s.title.erase(language);
    } else {
      s.title[language] = text.toStdString();
    }
  });
}

bool EditorModel::set_briefing(const std::string& language, const QString& text) {
  return edit(tr("Briefing"), u"briefing/"_qs + QString::fromStdString(language), [&](Scenario& s) {
    if (text.isEmpty()) {
      s.briefing.erase(language);
    } else {
      s.briefing[language] = text.toStdString();
    }
  });
}

bool EditorModel::remove_language(const std::string& language) {
  end_gesture();
  if (language == "en") return false;
  return edit(tr("Remove a language"), u"language"_qs, [&](Scenario& s) {
    s.title.erase(language);
    s.briefing.erase(language);
    for (Region& part : s.target.parts)
      if (!part.name.empty()) ui::set_target_title(part, s.target, language, {});
  });
}

bool EditorModel::set_target_title(std::size_t part, const std::string& language, const QString& text) {
  if (!can_be_target(scenario_.target, {part})) return false;
  return edit(tr("Name of a target"), u"target_title/%1/%2"_qs.arg(part).arg(QString::fromStdString(language)), [&](Scenario& s) {
    ui::set_target_title(s.target.parts[part], s.target, language, text.toStdString());
  });
}

bool EditorModel::clear_target(std::size_t part) {
  if (!can_be_target(scenario_.target, {part})) return false;
  return edit(tr("Name of a target"), u"clear_target"_qs, [&](Scenario& s) {
    s.target.parts[part].name.clear();
    s.target.parts[part].title.clear();
  });
}

bool EditorModel::set_level(std::optional<Level> level) {
  end_gesture();
  return edit(tr("Level"), u"level"_qs, [&](Scenario& s) { s.level = level; });
}

bool EditorModel::set_own_assessment(OwnAssessment own) {
  return edit(tr("Own assessment"), u"self_assessment"_qs, [&](Scenario& s) { s.self_assessment = own == OwnAssessment::asked; });
}
bool EditorModel::set_expected_time_s(double seconds) {
  return edit(tr("Expected time"), u"expected_time"_qs, [&](Scenario& s) { s.expected_time_s = seconds; });
}

bool EditorModel::set_leeway(double floor_mm, double side_mm) {
  return edit(tr("Tolerance zone"), u"leeway"_qs, [&](Scenario& s) {
    s.leeway.floor_mm = floor_mm;
    s.leeway.side_mm = side_mm;
  });
}

bool EditorModel::add_criterion(const std::string& metric, const Bands& bands) {
  end_gesture();
  return edit(tr("Add a criterion"), u"criteria"_qs,
              [&](Scenario& s) { s.rubric.criteria.push_back({metric, 10, bands}); });
}

bool EditorModel::remove_criterion(std::size_t index) {
  if (index >= scenario_.rubric.criteria.size()) return false;
  end_gesture();
  return edit(tr("Remove a criterion"), u"criteria"_qs, [&](Scenario& s) {
    s.rubric.criteria.erase(s.rubric.criteria.begin() + static_cast<std::ptrdiff_t>(index));
  });
}

bool EditorModel::set_weight(std::size_t index, double weight) {
  if (index >= scenario_.rubric.criteria.size()) return false;
  return edit(tr("Points"), u"weight/%1"_qs.arg(index),
              [&](Scenario& s) { s.rubric.criteria[index].weight = weight; });
}

bool EditorModel::set_bands(std::size_t index, const Bands& bands) {
  if (index >= scenario_.rubric.criteria.size()) return false;
  return edit(tr("Bands"), u"bands/%1"_qs.arg(index), [&](Scenario& s) { s.rubric.criteria[index].bands = bands; });
}

bool EditorModel::set_pass(double points) {
  return edit(tr("Pass mark"), u"pass"_qs, [&](Scenario& s) { s.rubric.pass = points; });
}

bool EditorModel::set_critical(const std::string& event, Listed in) {
  end_gesture();
  return edit(tr("What fails the attempt"), u"critical"_qs, [&](Scenario& s) {
    std::erase(s.rubric.critical, event);
    if (in == Listed::no) return;
    s.rubric.critical.push_back(event);
    if (event == "pulp_exposure" && !is_protected(s, Tissue::pulp)) {
      s.protected_parts.push_back(Tissue::pulp);
    }
  });
}

bool EditorModel::add_bur(const Bur& bur) {
  end_gesture();
  return edit(tr("Add a bur"), u"burs"_qs, [&](Scenario& s) { s.instruments.push_back(bur); });
}

bool EditorModel::remove_bur(std::size_t index) {
  if (index >= scenario_.instruments.size()) return false;
  end_gesture();
  return edit(tr("Remove a bur"), u"burs"_qs, [&](Scenario& s) {
    s.instruments.erase(s.instruments.begin() + static_cast<std::ptrdiff_t>(index));
  });
}

bool EditorModel::set_bur_radius_mm(std::size_t index, double mm) {
  if (index >= scenario_.instruments.size() || !scenario_.instruments[index].head.ball()) return false;
  return edit(tr("Bur"), u"bur/%1"_qs.arg(index), [&](Scenario& s) {
    s.instruments[index].radius_mm = mm;
    name_by_size(s.instruments, index);
  });
}

bool EditorModel::set_time_limit_s(double seconds) {
  return edit(tr("Time limit"), u"time"_qs, [&](Scenario& s) { s.time_limit_s = seconds; });
}

bool EditorModel::set_tissue_figures(std::size_t index, double stiffness_n_per_mm, double speed_mm_s) {
  if (index >= scenario_.tissues.size()) return false;
  return edit(tr("Tissue"), u"tissue/%1"_qs.arg(index), [&](Scenario& s) {
    s.tissues[index].stiffness_n_per_mm = stiffness_n_per_mm;
    s.tissues[index].speed_mm_s = speed_mm_s;
  });
}

bool EditorModel::set_tool_tilt_deg(double deg) {
  return edit(tr("Tilt of the handpiece"), u"tool_tilt"_qs, [&](Scenario& s) { s.tool_tilt_deg = deg; });
}

bool EditorModel::set_tool_turn_deg(double deg) {
  return edit(tr("Turn of the handpiece"), u"tool_turn"_qs, [&](Scenario& s) { s.tool_turn_deg = deg; });
}

bool EditorModel::set_handpiece(const std::string& key) {
  end_gesture();
  return edit(tr("Handpiece"), u"handpiece"_qs, [&](Scenario& s) {
    std::erase_if(s.phenomena, [](const std::string& k) { return k.starts_with("spindle-"); });
    if (key.empty()) {
      std::erase_if(s.phenomena, [](const std::string& k) { return k == "vibration" || k == "sound"; });
    } else {
      s.phenomena.insert(s.phenomena.begin(), key);
    }
  });
}

bool EditorModel::set_phenomenon(const std::string& key, Listed in) {
  end_gesture();
  return edit(tr("Handpiece"), u"phenomenon"_qs, [&](Scenario& s) {
    std::erase(s.phenomena, key);
    if (in == Listed::yes) s.phenomena.push_back(key);
    if (key == "heat" && in == Listed::no) std::erase(s.rubric.critical, "dry_cutting");
  });
}

}  // namespace cusp::ui
