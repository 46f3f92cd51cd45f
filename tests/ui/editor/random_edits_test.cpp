// Edits of every kind in random order, with undo and redo between them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/ui/editor/class_one.h"
#include "tests/ui/editor/some_landmarks.h"
#include "ui/editor/node_handles.h"
#include "ui/editor/part_handles.h"

namespace cusp::test {
namespace {

/// Values that fit an exercise, and values that do not.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  bool in(std::size_t count) { return below(count) == 0; }  // once in so many
  double mm() {
    constexpr double kOdd[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e9, 1e300, 1.0 / 3.0};
    if (in(25)) return kOdd[below(std::size(kOdd))];
    return std::round(std::uniform_real_distribution<>(-1.0, 6.0)(random_) * 100) / 100;
  }
  Vec3 place() { return {mm(), mm(), mm()}; }
  template <class Range>
  auto one_of(const Range& range) { return range[below(std::size(range))]; }
  QString text() { return in(6) ? QString() : QString(static_cast<int>(below(60)), QChar(static_cast<char16_t>(32 + below(300)))); }

 private:
  std::mt19937 random_;
};

/// False: refused.
using Edit = bool (*)(EditorModel&, Dice&);

const std::shared_ptr<const Specimen>& coarse_tooth() {
  static const auto specimen = [] {
    SpecimenSource source = load_builtin("caries-26")->specimen;
    source.voxel_mm = 0.4;
    return Specimen::build(make_specimen(source, {}).value(), Reading::banded);
  }();
  return specimen;
}

bool drag_a_handle(EditorModel& model, Dice& dice) {
  const Region part = model.chosen();
  if (model.has_outline()) {
    const auto handles = handles_of(part.outline);
    return !handles.empty() && model.set_outline(moved(part.outline, dice.one_of(handles), dice.place()), QStringLiteral("drag"));
  }
  const auto handles = is_node(part.kind) ? handles_of_node(part, node_anchor(part, coarse_tooth())) : handles_of_part(part);
  if (handles.empty()) return true;
  const TargetHandle handle = dice.one_of(handles);
  const bool along = handle.along != Vec3(0.0);
  return model.set_part(moved_part(part, handle, along ? handle.at_mm + dice.mm() * handle.along : handle.at_mm + 0.1 * dice.place()), QStringLiteral("drag"));
}

bool change_a_part(EditorModel& model, Dice& dice) {
  Region part = model.chosen();
  part.from_mm = dice.place();
  if (has_ends(part.kind)) part.to_mm = dice.place();
  part.size_mm = dice.place();
  part.radius_mm = dice.mm();
  return model.set_part(part, QStringLiteral("part"));
}

bool change_a_node(EditorModel& model, Dice& dice) {
  Region part = model.chosen();
  if (!is_node(part.kind)) return true;
  if (part.kind == RegionKind::offset) part.by_mm = dice.mm();
  else part.kind = dice.one_of(std::array{RegionKind::joined, RegionKind::common, RegionKind::difference}), part.rounding_mm = dice.mm();
  return model.set_part(part, QStringLiteral("node"));
}

bool change_the_tooth(EditorModel& model, Dice& dice) {
  SpecimenSource source = model.scenario().specimen;
  source.seed = static_cast<unsigned>(dice.below(5));
  source.around = dice.in(2) ? std::vector<std::string>{"neighbours"} : std::vector<std::string>{};
  source.lesions.clear();
  if (dice.in(2)) source.lesions.push_back({"fissure", "central", dice.mm(), dice.mm(), 0.7});
  return model.set_tooth(source, QStringLiteral("tooth"));
}

bool change_bands(EditorModel& model, Dice& dice) {
  std::array<double, 6> b{};
  for (double& edge : b) edge = dice.mm();
  if (!dice.in(3)) std::ranges::sort(b);
  return model.set_bands(dice.below(8), {b[0], b[1], b[2], b[3], b[4], b[5]});
}

bool move_a_landmark(EditorModel& model, Dice& dice) {
  model.choose_landmark({dice.below(5), dice.below(3)});
  return model.move_landmark({dice.below(5), dice.below(3)}, dice.place());
}

bool take_another_draft(EditorModel& model, Dice& dice) {
  Scenario other = model.scenario();
  other.time_limit_s = 60.0 * static_cast<double>(dice.below(30));
  other.instruments.resize(std::min<std::size_t>(other.instruments.size(), 1 + dice.below(3)));
  return model.take(other);
}

/// Of one of several targets, while there is one.
bool add_a_criterion_of_a_target(EditorModel& model, Dice& dice) {
  const auto targets = named_targets(model.scenario().target);
  if (targets.empty()) return false;
  return model.add_criterion(metric_key(dice.one_of(kMetricKeys).key, dice.one_of(targets)->name), {0, 0, 0, 1, 2, 3});
}

/// Every edit of EditorModel.
constexpr Edit kEdits[] = {
    drag_a_handle, drag_a_handle, drag_a_handle, drag_a_handle, change_a_part, change_a_node, change_the_tooth, change_bands, move_a_landmark,
    take_another_draft, add_a_criterion_of_a_target, add_a_criterion_of_a_target,
    [](EditorModel& m, Dice& d) { return m.set_target_title(d.below(4), d.one_of(std::array{"en", "de", "ar"}), d.text()); },
    [](EditorModel& m, Dice& d) { return m.set_target_title(d.below(4), "en", d.text()); },
    [](EditorModel& m, Dice& d) { return m.clear_target(d.below(4)); },
    [](EditorModel& m, Dice& d) { return m.set_depth_mm(d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_width_mm(d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_top_mm(d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_corner_radius_mm(d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_box_size_mm(d.mm(), d.mm()); },
    [](EditorModel& m, Dice& d) { return m.has_outline() && m.set_point_mm(d.below(3), d.below(4), d.mm(), d.mm()); },
    [](EditorModel& m, Dice& d) { return m.has_outline() && m.add_point(d.below(2)); },
    [](EditorModel& m, Dice& d) { return m.has_outline() && m.remove_point(d.below(2), d.below(4)); },
    [](EditorModel& m, Dice&) { return m.has_outline() && m.add_path(); },
    [](EditorModel& m, Dice& d) { return m.set_shape(d.one_of(std::array{"channel", "outline", "box", "banana"})); },
    [](EditorModel& m, Dice& d) { return m.set_taper_deg(d.below(4), 10 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.add_part(static_cast<RegionKind>(d.below(8))); },
    [](EditorModel& m, Dice&) { return m.remove_part(); },
    [](EditorModel& m, Dice& d) { return m.set_leeway(d.mm(), d.mm()); },
    [](EditorModel& m, Dice& d) { return m.add_criterion(std::string(d.one_of(kMetricKeys).key), {0, 0, 0, 1, 2, 3}); },
    [](EditorModel& m, Dice& d) { return m.remove_criterion(d.below(8)); },
    [](EditorModel& m, Dice& d) { return m.set_weight(d.below(8), 10 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_pass(20 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_critical(std::string(d.one_of(kCriticalKeys)), EditorModel::listed(d.in(2))); },
    [](EditorModel& m, Dice& d) { return m.add_bur(d.one_of(bur_catalogue()).bur); },
    [](EditorModel& m, Dice& d) { return m.remove_bur(d.below(6)); },
    [](EditorModel& m, Dice& d) { return m.set_bur_radius_mm(d.below(6), d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_time_limit_s(100 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_tissue_figures(d.below(6), d.mm(), d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_tool_tilt_deg(20 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_tool_turn_deg(20 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_handpiece(d.one_of(std::array{"", "spindle-turbine", "spindle-slow", "drill"})); },
    [](EditorModel& m, Dice& d) { return m.set_phenomenon(std::string(d.one_of(kPhenomenonKeys)), EditorModel::listed(d.in(2))); },
    [](EditorModel& m, Dice& d) { return m.set_title(d.one_of(std::array{"en", "de", "ar"}), d.text()); },
    [](EditorModel& m, Dice& d) { return m.set_briefing(d.one_of(std::array{"en", "de", "ar"}), d.text()); },
    [](EditorModel& m, Dice& d) { return m.remove_language(d.one_of(std::array{"en", "de", "ar"})); },
    [](EditorModel& m, Dice& d) { return m.set_level(d.in(3) ? std::nullopt : std::optional(static_cast<Level>(d.below(3)))); },
    [](EditorModel& m, Dice& d) { return m.set_expected_time_s(100 * d.mm()); },
    [](EditorModel& m, Dice& d) { return m.set_own_assessment(static_cast<EditorModel::OwnAssessment>(d.below(2))); },
    [](EditorModel& m, Dice& d) { return m.take_proposed(d.in(2) ? some_landmarks() : SpecimenLandmarks{}); },
    [](EditorModel& m, Dice& d) { return m.accept_landmark(d.below(5)); },
    [](EditorModel& m, Dice&) { return m.accept_landmarks(); },
    [](EditorModel& m, Dice& d) { return m.remove_landmark(d.below(5)); },
};

/// The exercise after each step of the undo stack, and checks of a model against them.
class History {
 public:
  explicit History(EditorModel& model) : model_(model), states_{model.scenario()} {}
  void edit(Dice& dice) {
    if (!dice.in(3)) model_.end_gesture();  // else it may merge with the last one
    if (dice.in(4)) {
      const auto parts = parts_of(model_.scenario().target);
      model_.choose_part(dice.one_of(parts));
    }
    const Scenario before = model_.scenario();
    const int index = model_.stack().index(), count = model_.stack().count();
    const bool taken = dice.one_of(kEdits)(model_, dice);
    ASSERT_NE(part_at(model_.scenario().target, model_.part()), nullptr);
    if (!taken) {
      ASSERT_EQ(model_.scenario(), before) << "refused";
      ASSERT_EQ(model_.stack().index(), index);
    }
    refused_ += taken ? 0 : 1;
    if (model_.scenario() == before && model_.stack().index() == index && model_.stack().count() == count) return;
    const auto steps = static_cast<std::size_t>(model_.stack().index());
    ASSERT_LE(steps, static_cast<std::size_t>(index) + 1);
    if (steps < states_.size() && steps < static_cast<std::size_t>(index)) {
      ASSERT_EQ(model_.scenario(), states_[steps]) << "a gesture that came back is no step";
    }
    states_.resize(steps);
    states_.push_back(model_.scenario());
    const auto back = read_scenario(canonical_json(model_.scenario()));
    ASSERT_TRUE(back && *back == model_.scenario()) << "saved and loaded";
  }
  /// Some steps back or forth, each to what stood there.
  void travel(Dice& dice) {
    const bool back = !dice.in(3);
    for (std::size_t left = 1 + dice.below(4); left > 0; --left) {
      back ? model_.stack().undo() : model_.stack().redo();
      compare();
    }
  }
  void undo_all_and_redo() {
    while (model_.stack().canUndo()) {
      model_.stack().undo();
      compare();
    }
    ASSERT_EQ(model_.stack().index(), 0);
    while (model_.stack().canRedo()) {
      model_.stack().redo();
      compare();
    }
    ASSERT_EQ(static_cast<std::size_t>(model_.stack().index()) + 1, states_.size());
  }
  std::size_t steps() const { return states_.size() - 1; }
  int refused() const { return refused_; }

 private:
  void compare() {
    ASSERT_EQ(model_.scenario(), states_[static_cast<std::size_t>(model_.stack().index())]);
    ASSERT_NE(part_at(model_.scenario().target, model_.part()), nullptr);
  }
  EditorModel& model_;
  std::vector<Scenario> states_;
  int refused_ = 0;
};

/// A class II as a tree of shapes, a carious lesion with leaves of voxels, and a tooth from a file with landmarks.
std::vector<EditorStart> starts() {
  EditorStart class_two, caries, from_file = class_one();
  class_two.draft = *load_builtin("class-2-46-mo");
  caries.draft = *load_builtin("caries-26");
  SpecimenSource source;
  source.volume = "tooth.nrrd";
  source.voxel_mm = from_file.draft.specimen.voxel_mm;
  source.landmarks = some_landmarks();
  from_file.draft.specimen = source;
  return {class_two, caries, from_file};
}

/// 200 edits of each exercise; with CUSP_FULL=1 10,000, of which a little less than half are refused, and 2,400 to 2,600 steps stay.
TEST(RandomEdits, save_and_load_equal_and_undo_and_redo_restore_each_state) {
  const int edits = full_run() ? 10'000 : 200;
  unsigned seed = 20;
  for (const EditorStart& start : starts()) {
    ++seed;
    EditorModel model(start);
    History history(model);
    Dice dice(seed);
    int travels = 0;
    for (int i = 0; i < edits; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", edit " + std::to_string(i));
      if (dice.in(8)) history.travel(dice), ++travels;
      history.edit(dice);
      if (HasFatalFailure()) return;
    }
    history.undo_all_and_redo();
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    while (model.stack().canUndo()) model.stack().undo();
    EXPECT_EQ(model.scenario(), start.draft) << "seed " << seed;
    EXPECT_GT(history.steps(), static_cast<std::size_t>(edits) / 10) << "enough of them change the exercise";
    RecordProperty("seed_" + std::to_string(seed), std::to_string(history.steps()) + " steps, " + std::to_string(history.refused()) + " refused, " + std::to_string(travels) + " travels");
  }
}

}  // namespace
}  // namespace cusp::test
