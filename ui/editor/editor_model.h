/// The exercise that an instructor is working on: its values, every edit of them, undo, and what stands against
/// publishing it. No widget, no file, no database. Frame: specimen, z up. Millimetres. GUI thread.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/scenario.h"
#include "scenarios/format/validate.h"
#include "ui/modules.h"

namespace cusp::ui {

/// What the editor began from. Versions are immutable: what is published from here is the next one.
struct EditorStart {
  Scenario draft;                     // its version is the one that would be published
  std::optional<Scenario> published;  // the newest version; nullopt for an exercise that was never published
  std::string folder;                 // where a volume lies that the draft names
  std::optional<std::string> kept{};  // the draft's JSON as the records held it; nullopt: no draft was kept yet
};

class EditorModel : public QObject {
  Q_OBJECT

 public:
  explicit EditorModel(EditorStart start, QObject* parent = nullptr);

  const Scenario& scenario() const { return scenario_; }
  const std::string& folder() const { return folder_; }
  QUndoStack& stack() { return stack_; }

  /// All edits: true when the value was taken (also when it was there already), false when an exercise may not hold it
  /// (not a number, out of its range, a name twice): then nothing changes. One edit is one step of undo; edits of one
  /// field merge until end_gesture().
  bool take(const Scenario& draft);  // another window's draft of this exercise, as one step: undo brings this one's back
  bool set_title(const std::string& language, const QString& text);     // empty: takes the language away
  bool set_briefing(const std::string& language, const QString& text);
  /// Other tissues come with another specimen; critical ones (scenarios/tissues) stay protected where there are any.
  /// Where pulp comes in, opening it fails the attempt from then on. If the grown specimen shows that the target holds
  /// pulp, as an endodontic access does, set_facts() takes that rule back within the same step.
  bool set_specimen(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues);
  /// A grown tooth otherwise: its carious lesions, what stands about it, its seed. Tissues that it has more begin with the usual
  /// figures, those that it keeps keep theirs. `field` as in set_target.
  bool set_tooth(const SpecimenSource& source, const QString& field);
  bool set_target(const Target& target, const QString& field);          // handles: everything of the target at once
  bool set_shape(const std::string& shape);                             // keeps place, size and depth
  /// Bands of depth criteria move with the depth, so that meeting the target still earns the points.
  bool set_depth_mm(double mm);
  bool set_width_mm(double mm);
  bool set_top_mm(double mm);
  bool set_corner_radius_mm(double mm);
  bool set_box_size_mm(double x, double y);
  bool set_point_mm(std::size_t path, std::size_t point, double x, double y);  // of the floor's middle line
  bool add_point(std::size_t path);        // beyond the last one, as far again as the last step
  bool remove_point(std::size_t path, std::size_t point);  // a path below two points goes as a whole
  bool add_path();                         // outline: a branch from the middle of the first path
  bool set_leeway(const Leeway& leeway);
  bool add_criterion(const std::string& metric, const Bands& bands);
  bool remove_criterion(std::size_t index);
  bool set_weight(std::size_t index, double weight);
  bool set_bands(std::size_t index, const Bands& bands);
  bool set_pass(double points);
  bool set_critical(const std::string& event, bool on);
  bool add_bur(const Bur& bur);
  bool remove_bur(std::size_t index);
  bool set_bur_radius_mm(std::size_t index, double mm);
  bool set_time_limit_s(double seconds);
  bool set_tissue_figures(std::size_t index, double stiffness_n_per_mm, double speed_mm_s);
  /// A key of kPhenomenonKeys; "" for none. Without a handpiece vibration and sound go too.
  bool set_handpiece(const std::string& key);
  /// Any other phenomenon. Without heat, overheating fails no attempt.
  bool set_phenomenon(const std::string& key, bool on);
  /// The value of a spin box or a handle has come to rest: the next edit is a step of its own.
  void end_gesture() { ++gesture_; }

  /// Known once the specimen has been grown; nullopt while it is not. `pulp_mm`: the outermost voxels of its pulp.
  /// With the specimen itself the target is held against its tissues too.
  void set_facts(std::optional<SpecimenFacts> facts, std::vector<Vec3> pulp_mm = {},
                 std::shared_ptr<const Specimen> specimen = nullptr);
  /// Grades an untouched specimen and two token cuts (scenarios/checks): some tenths of a second, before publishing. False
  /// where one of them earns or passes: findings() says so until the next edit.
  bool prove();
  const std::optional<SpecimenFacts>& facts() const { return facts_; }

  /// Errors first: those of validate(), of check_regions() and of check_texts(). Without facts the checks that need the
  /// specimen are left out; with the pulp's voxels alone its opening is held against the rule only.
  const std::vector<Finding>& findings() const { return findings_; }
  enum class Standing {
    unchanged,  // equals what is published
    failing,    // a check fails
    unproved,   // the specimen is not there yet to be checked against
    ready,
  };
  Standing standing() const;
  bool publishable() const { return standing() == Standing::ready; }
  bool unchanged() const;
  const std::optional<Scenario>& published() const { return published_; }
  /// After publishing: the version that is there now; the next edit begins the next one. Undo begins anew.
  void now_published(const Scenario& version);

 Q_SIGNALS:
  /// After every edit, undo and redo, and when facts come.
  void changed();
  /// Another specimen is meant than before.
  void specimen_changed();

 private:
  bool edit(const QString& text, const QString& field, const std::function<void(Scenario&)>& change);
  void after_change();
  void check();
  void check_pulp();
  bool allow_access();  // true: the last step brought the pulp's rule, the target is an access, and the rule is gone
  void add(std::vector<Finding> findings);

  Scenario scenario_;
  std::optional<Scenario> published_;
  std::string folder_;
  SpecimenSource grown_from_;  // what specimen_changed() told last
  std::optional<SpecimenFacts> facts_;
  std::vector<Vec3> pulp_mm_;
  std::shared_ptr<const Specimen> specimen_;  // what facts_ are of; may be null
  std::vector<Finding> findings_;
  int gesture_ = 0;
  QUndoStack stack_;  // last: its commands refer to scenario_
};

/// Puts every point on the floor.
void settle_on_floor(Target& target);

}  // namespace cusp::ui
