#include "ui/editor/editor_model.h"

#include <algorithm>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "ui/editor/commands.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

constexpr double kNewSegmentMm = 1.0;  // length of a branch, about that of a fissure's arm
constexpr double kLeastNewWidthMm = 0.5, kLeastNewLengthMm = 2.0;  // of a shape after set_shape()

/// Rounds to 0.1 µm, so that sums of steps print short.
double tidy(double mm) { return std::round(mm * 1e4) / 1e4; }
Vec3 tidy(Vec3 v) { return {tidy(v.x), tidy(v.y), tidy(v.z)}; }

/// Bounding rectangle of all points.
void bounds(const Outline& target, Vec3& low, Vec3& high) {
  low = high = target.paths.front().front();
  for (const auto& path : target.paths) {
    for (const Vec3& p : path) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
}

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The writer of scenario.json refuses numbers that are not finite.
bool finite(const Scenario& s) {
  const Outline& t = s.target.outline;
  bool all = std::isfinite(t.width_mm) && std::isfinite(t.depth_mm) && std::isfinite(t.top_mm) &&
             std::isfinite(t.corner_radius_mm) && finite(t.box_size_mm) && std::isfinite(s.leeway.floor_mm) &&
             std::isfinite(s.leeway.side_mm) && std::isfinite(s.time_limit_s) && std::isfinite(s.rubric.pass) &&
             std::isfinite(s.specimen.voxel_mm);
  for (const auto& path : t.paths) {
    for (const Vec3& p : path) all = all && finite(p);
  }
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

}  // namespace

void settle_on_floor(Outline& target) {
  const double floor = tidy(target.top_mm - target.depth_mm);
  for (auto& path : target.paths) {
    for (Vec3& p : path) p = tidy(Vec3(p.x, p.y, floor));
  }
}

EditorModel::EditorModel(EditorStart start, QObject* parent)
    : QObject(parent),
      scenario_(std::move(start.draft)),
      published_(std::move(start.published)),
      folder_(std::move(start.folder)),
      grown_from_(scenario_.specimen) {
  check();
}

bool EditorModel::edit(const QString& text, const QString& field, const std::function<void(Scenario&)>& change) {
  Scenario after = scenario_;
  change(after);
  if (after == scenario_) return true;
  if (!finite(after)) return false;
  // The reader of the format decides what an exercise may hold: a draft must open again.
  const auto back = read_scenario(canonical_json(after));
  if (!back || !(*back == after)) return false;
  stack_.push(new ScenarioEdit(scenario_, std::move(after), text, field, gesture_, [this] { after_change(); }));
  return true;
}

void EditorModel::after_change() {
  if (!(scenario_.specimen == grown_from_)) {
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

bool EditorModel::set_target(const Outline& target, const QString& field) {
  if (!has_drawn_target()) return false;
  return edit(tr("Target"), field, [&](Scenario& s) { s.target.outline = target; });
}

bool EditorModel::set_shape(const std::string& shape) {
  if (!has_drawn_target()) return false;
  end_gesture();
  return edit(tr("Shape"), u"shape"_qs, [&](Scenario& s) {
    Outline& t = s.target.outline;
    if (t.shape == shape || t.paths.empty() || t.paths.front().empty()) return;
    Vec3 low, high;
    bounds(t, low, high);
    const Vec3 middle = tidy((low + high) / 2.0);
    if (shape == "box") {
      const double w = std::max(t.width_mm, kLeastNewWidthMm);
      t.box_size_mm = tidy(Vec3(high.x - low.x + w, high.y - low.y + w, 0));
      t.paths = {{middle}};
    } else {
      if (t.shape == "box") {
        const double wide = t.box_size_mm.x, high_y = t.box_size_mm.y;
        t.width_mm = tidy(std::max(std::min(wide, high_y), kLeastNewWidthMm));
        const double half = std::max(std::max(wide, high_y) - t.width_mm, kLeastNewLengthMm) / 2;
        const Vec3 along = wide >= high_y ? Vec3(half, 0, 0) : Vec3(0, half, 0);
        t.paths = {{tidy(middle - along), tidy(middle + along)}};
      } else if (shape == "channel") {
        t.paths = {{t.paths.front().front(), t.paths.front().back()}};
      }
      t.box_size_mm = Vec3(0.0);
    }
    t.shape = shape;
    settle_on_floor(t);
  });
}

bool EditorModel::set_depth_mm(double mm) {
  if (!has_drawn_target()) return false;
  return edit(tr("Depth"), u"depth"_qs, [&](Scenario& s) {
    const double by = mm - s.target.outline.depth_mm;
    s.target.outline.depth_mm = mm;
    settle_on_floor(s.target.outline);
    if (!std::isfinite(by)) return;
    for (Criterion& c : s.rubric.criteria) {
      if (!c.metric.starts_with("depth_")) continue;
      Bands& b = c.bands;
      // A side with three equal edges is open and has no bands to move.
      if (b.fail_lo != b.ideal_lo || b.acc_lo != b.ideal_lo) {
        for (double* edge : {&b.fail_lo, &b.acc_lo, &b.ideal_lo}) *edge = tidy(*edge + by);
      }
      if (b.fail_hi != b.ideal_hi || b.acc_hi != b.ideal_hi) {
        for (double* edge : {&b.ideal_hi, &b.acc_hi, &b.fail_hi}) *edge = tidy(*edge + by);
      }
    }
  });
}

bool EditorModel::set_width_mm(double mm) {
  if (!has_drawn_target()) return false;
  return edit(tr("Width"), u"width"_qs, [&](Scenario& s) { s.target.outline.width_mm = mm; });
}

bool EditorModel::set_top_mm(double mm) {
  if (!has_drawn_target()) return false;
  return edit(tr("Height"), u"top"_qs, [&](Scenario& s) {
    s.target.outline.top_mm = mm;
    settle_on_floor(s.target.outline);
  });
}

bool EditorModel::set_corner_radius_mm(double mm) {
  if (!has_drawn_target()) return false;
  return edit(tr("Corner radius"), u"corner"_qs, [&](Scenario& s) { s.target.outline.corner_radius_mm = mm; });
}

bool EditorModel::set_box_size_mm(double x, double y) {
  if (!has_drawn_target() || !(x > 0) || !(y > 0)) return false;
  return edit(tr("Size"), u"size"_qs, [&](Scenario& s) { s.target.outline.box_size_mm = {x, y, 0}; });
}

bool EditorModel::set_point_mm(std::size_t path, std::size_t point, double x, double y) {
  if (path >= scenario_.target.outline.paths.size() || point >= scenario_.target.outline.paths[path].size()) return false;
  return edit(tr("Point"), u"point/%1/%2"_qs.arg(path).arg(point), [&](Scenario& s) {
    Vec3& p = s.target.outline.paths[path][point];
    p = Vec3(x, y, p.z);
  });
}

bool EditorModel::add_point(std::size_t path) {
  if (path >= scenario_.target.outline.paths.size() || scenario_.target.outline.shape != "outline") return false;
  end_gesture();
  return edit(tr("Add a point"), u"points"_qs, [&](Scenario& s) {
    auto& points = s.target.outline.paths[path];
    const Vec3 last = points.back();
    const Vec3 step = points.size() > 1 ? last - points[points.size() - 2] : Vec3(kNewSegmentMm, 0, 0);
    points.push_back(tidy(last + step));
  });
}

bool EditorModel::remove_point(std::size_t path, std::size_t point) {
  const auto& paths = scenario_.target.outline.paths;
  if (path >= paths.size() || point >= paths[path].size() || scenario_.target.outline.shape != "outline") return false;
  if (paths.size() == 1 && paths[0].size() <= 2) return false;  // the target keeps one segment
  end_gesture();
  return edit(tr("Remove a point"), u"points"_qs, [&](Scenario& s) {
    auto& points = s.target.outline.paths[path];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(point));
    if (points.size() < 2) s.target.outline.paths.erase(s.target.outline.paths.begin() + static_cast<std::ptrdiff_t>(path));
  });
}

bool EditorModel::add_path() {
  const Outline& t = scenario_.target.outline;
  if (t.shape != "outline" || t.paths.empty() || t.paths.front().empty()) return false;
  end_gesture();
  return edit(tr("Add a branch"), u"points"_qs, [&](Scenario& s) {
    const auto& first = s.target.outline.paths.front();
    const Vec3 root = first[first.size() / 2];
    s.target.outline.paths.push_back({root, tidy(root + Vec3(0, kNewSegmentMm, 0))});
  });
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

bool EditorModel::set_critical(const std::string& event, bool on) {
  end_gesture();
  return edit(tr("What fails the attempt"), u"critical"_qs, [&](Scenario& s) {
    std::erase(s.rubric.critical, event);
    if (!on) return;
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
  return edit(tr("Bur"), u"bur/%1"_qs.arg(index), [&](Scenario& s) { s.instruments[index].radius_mm = mm; });
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

bool EditorModel::set_phenomenon(const std::string& key, bool on) {
  end_gesture();
  return edit(tr("Handpiece"), u"phenomenon"_qs, [&](Scenario& s) {
    std::erase(s.phenomena, key);
    if (on) s.phenomena.push_back(key);
    if (key == "heat" && !on) std::erase(s.rubric.critical, "dry_cutting");
  });
}

}  // namespace cusp::ui
