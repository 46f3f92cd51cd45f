/// The exercise in the editor: values, edits, undo, and the findings that forbid publishing. No widget, file or database.
/// Frame: specimen, z up. Units: millimetres. Thread: GUI.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/scenario.h"
#include "scenarios/format/validate.h"
#include "ui/editor/region_parts.h"
#include "ui/editor/try_outs.h"
#include "ui/modules.h"

namespace cusp::ui {

/// What the editor opens. Versions are immutable: publishing makes the next one.
struct EditorStart {
  Scenario draft;                     // its version is the one that publishing would make
  std::optional<Scenario> published;  // the newest version; nullopt for an exercise that was never published
  std::string folder;                 // of the volume that the draft names
  std::optional<std::string> kept{};  // the draft's JSON in the records; nullopt without a draft there
};

/// A landmark of the exercise by its index, and one of its points.
struct MarkPoint {
  std::size_t mark = 0, point = 0;
  friend bool operator==(const MarkPoint&, const MarkPoint&) = default;
};

class EditorModel : public QObject {
  Q_OBJECT

 public:
  explicit EditorModel(EditorStart start, QObject* parent = nullptr);

  const Scenario& scenario() const { return scenario_; }
  const std::string& folder() const { return folder_; }
  QUndoStack& stack() { return stack_; }

  /// All edits return true if the exercise has the value now, and false if an exercise may not hold it (not finite, out of range,
  /// a name twice); then nothing changes. One edit is one step of undo; edits of one field merge until end_gesture().
  bool take(const Scenario& draft);  // another window's draft, as one step: undo restores this one's
  bool set_title(const std::string& language, const QString& text);     // an empty text removes the language
  bool set_briefing(const std::string& language, const QString& text);
  /// Title and briefing of a language, as one step. False for English, which stays.
  bool remove_language(const std::string& language);
  /// Makes a part of the root's union one of several targets, or titles it; an empty text removes the title, of which English has
  /// another's. False for any other part.
  bool set_target_title(std::size_t part, const std::string& language, const QString& text);
  bool clear_target(std::size_t part);  // none of several targets any more: the criteria that name it go within the same step
  bool set_level(std::optional<Level> level);
  bool set_expected_time_s(double seconds);  // 0: not stated
  enum class OwnAssessment : std::uint8_t { not_asked, asked };
  bool set_own_assessment(OwnAssessment own);
  /// A specimen brings its tissues; the critical ones among them (scenarios/tissues) are protected, and a grown tooth's neighbours. New
  /// pulp brings the rule that opening it fails the attempt, new neighbours that their damage does. What a tissue of a grown tooth had
  /// before it went, within the reach of undo, comes back with it. If the grown specimen shows pulp inside the target (an endodontic
  /// access), set_facts() removes that rule within the same step. If mesial lies on the other side of the new tooth, target and
  /// protected regions are mirrored (tooth_side.h).
  bool set_specimen(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues);
  /// Number, carious lesions, neighbours and seed of a grown tooth. New tissues get the usual figures, the others keep theirs; sides as
  /// in set_specimen. `field` as in set_part.
  bool set_tooth(const SpecimenSource& source, const QString& field);
  /// Landmarks of a tooth from a file. Of a grown one they are empty, and each edit of them returns false.
  bool takes_landmarks() const { return scenario_.specimen.generator.empty(); }
  const SpecimenLandmarks& landmarks() const { return scenario_.specimen.landmarks; }
  /// Those of `proposed`; the ones that are set stay if the tooth's number does. The number may put mesial on the other side: tooth_side.h.
  bool take_proposed(const SpecimenLandmarks& proposed);
  /// The landmark is set then. False for a place beside the tooth (landmark_outside of validate.h).
  bool move_landmark(MarkPoint at, Vec3 mm);
  /// Those of the exercise that lie on another volume too.
  SpecimenLandmarks landmarks_on(const SpecimenFacts& other) const;
  bool accept_landmark(std::size_t mark);
  bool accept_landmarks();
  bool remove_landmark(std::size_t mark);
  /// The point that form and view show; of no account without landmarks. No edit: undo does not bring it back.
  MarkPoint landmark() const;
  void choose_landmark(MarkPoint at);
  /// The part of the target that the edits below change. At the start its first outline. No edit: undo does not bring it back.
  const PartPath& part() const { return part_; }
  void choose_part(const PartPath& path);
  /// The chosen part; the edits of an outline return false if it is none.
  const Region& chosen() const { return *part_at(scenario_.target, part_); }
  bool has_outline() const { return chosen().kind == RegionKind::outline; }
  const Outline& outline() const { return chosen().outline; }
  /// Replaces the chosen part and the parts below it. `field` as in ScenarioEdit.
  bool set_part(const Region& part, const QString& field);
  bool add_part(RegionKind kind);  // beside the chosen one, which it becomes
  bool remove_part();              // false for the root
  bool set_outline(const Outline& outline, const QString& field);       // for handles: the whole outline
  bool set_taper_deg(std::size_t side, double deg);                     // -x, +x, -y, +y
  bool set_shape(const std::string& shape);  // keeps place, size and depth; the bands of the isthmus move with the width
  /// If its floor is the pulpal floor, moves the bands of depth criteria too, so that an exact cut still earns full points; of several
  /// targets those of the whole move with the deepest, the shallowest and the narrowest one.
  bool set_depth_mm(double mm);
  bool set_width_mm(double mm);              // the bands of the isthmus likewise
  bool set_top_mm(double mm);
  bool set_corner_radius_mm(double mm);
  bool set_box_size_mm(double x, double y);  // y is the width: the bands of the isthmus likewise
  bool set_point_mm(std::size_t path, std::size_t point, double x, double y);  // on the floor's middle line
  bool add_point(std::size_t path);        // continues the last segment by its own length
  bool remove_point(std::size_t path, std::size_t point);  // also removes a path of fewer than two points
  bool add_path();                         // outline: a branch from the middle of the first path
  bool set_leeway(double floor_mm, double side_mm);  // the zones of single faces stay
  bool add_criterion(const std::string& metric, const Bands& bands);
  bool remove_criterion(std::size_t index);
  bool set_weight(std::size_t index, double weight);
  bool set_bands(std::size_t index, const Bands& bands);
  bool set_pass(double points);
  enum class Listed : std::uint8_t { no, yes };
  static Listed listed(bool on) noexcept { return on ? Listed::yes : Listed::no; }
  bool set_critical(const std::string& event, Listed in);
  bool add_bur(const Bur& bur);
  bool remove_bur(std::size_t index);
  /// A bur of another size than its catalogue number has gets the number of that size, else a name by its diameter.
  bool set_bur_radius_mm(std::size_t index, double mm);
  bool set_time_limit_s(double seconds);
  bool set_tissue_figures(std::size_t index, double stiffness_n_per_mm, double speed_mm_s);
  bool set_tool_tilt_deg(double deg);  // of the handpiece at rest, towards buccal
  bool set_tool_turn_deg(double deg);  // how far the student may turn it from there; 0: not at all
  /// A key of kPhenomenonKeys, "" for none. Without a handpiece the exercise loses vibration and sound too.
  bool set_handpiece(const std::string& key);
  /// Any other phenomenon. Without heat, overheating fails no attempt.
  bool set_phenomenon(const std::string& key, Listed in);
  /// Ends a drag or a turn of a spin box: the next edit is a new step.
  void end_gesture() { ++gesture_; }

  /// Facts of the grown specimen; nullopt while it grows. `pulp_mm`: the outermost voxels of its pulp. With `specimen` the checks
  /// compare the target with its tissues too.
  void set_facts(std::optional<SpecimenFacts> facts, std::vector<Vec3> pulp_mm = {},
                 std::shared_ptr<const Specimen> specimen = nullptr);
  /// Takes what check_attempts() (scenarios/checks) found of this exercise before publishing: an untouched specimen, two token cuts and the
  /// finished target are graded. False if one of the findings is an error. findings() contains them until the next edit.
  bool prove(std::vector<Finding> of_attempts);
  const std::optional<SpecimenFacts>& facts() const { return facts_; }
  /// Of the facts; null until it is grown.
  const std::shared_ptr<const Specimen>& specimen() const { return specimen_; }
  /// The author's own names of its tissues, by code (ui/text/names.h); empty until it is grown.
  const std::map<std::uint8_t, std::string>& tissue_names() const;

  /// Errors first. From validate(), check_regions() and check_texts(). Without facts the checks that need the specimen do not run;
  /// with the pulp's voxels alone only the rule about opening it is checked.
  const std::vector<Finding>& findings() const { return findings_; }
  /// Whether the exercise can be tried out: no error stands but those of prove(), whose cause a try-out shows.
  bool playable() const { return playable_; }
  enum class Standing {
    unchanged,  // equals the published version
    failing,    // a check fails
    unproved,   // the specimen is still growing
    ready,
  };
  Standing standing() const;
  bool publishable() const { return standing() == Standing::ready; }
  bool unchanged() const;
  const std::optional<Scenario>& published() const { return published_; }
  /// The exercise was drilled to its end as `played`: by a try-out, or by the scripted operator of an audit.
  void now_tried(const Scenario& played) { tried_ = played; }
  /// The same, with what was measured. Cuts of the competent and the novice are no try-out.
  void now_tried(TryOut fresh);
  const TryOuts& try_outs() const { return try_outs_; }
  /// Whether it was drilled with the present values. Texts, level, expected time and own assessment are of no account.
  bool tried() const;
  /// Call after publishing. The next edit begins the next version; undo starts empty.
  void now_published(const Scenario& version);

 Q_SIGNALS:
  /// There are new measured values.
  void tried_out();
  /// Another part of the target is chosen.
  void part_chosen();
  /// Another landmark, or another point of it, is chosen.
  void landmark_chosen();
  /// After every edit, undo and redo, and after set_facts().
  void changed();
  /// The exercise has another specimen now. Other landmarks make none.
  void specimen_changed();

 private:
  bool edit(const QString& text, const QString& field, const std::function<void(Scenario&)>& change);
  bool edit_landmarks(const QString& text, const std::function<void(SpecimenLandmarks&)>& change);
  bool edit_outline(const QString& text, const QString& field, const std::function<void(Scenario&, Outline&)>& change);
  void after_change();
  void check();
  void check_pulp();
  bool allow_access();  // true if it removed the pulp's rule of the last step, for the target is an access
  void add(std::vector<Finding> findings);

  Scenario scenario_;
  std::optional<Scenario> published_;
  std::optional<Scenario> tried_;
  TryOuts try_outs_;
  std::string folder_;
  PartPath part_;
  MarkPoint landmark_;         // as chosen; landmark() keeps it within the landmarks
  SpecimenSource grown_from_;  // at the last specimen_changed()
  std::optional<SpecimenFacts> facts_;
  std::vector<Vec3> pulp_mm_;
  std::shared_ptr<const Specimen> specimen_;  // of facts_; may be null
  std::vector<Finding> findings_;
  bool playable_ = false;
  int gesture_ = 0;
  QUndoStack stack_;  // the last member: its commands refer to scenario_
};

/// Points that a landmark can be moved by: the last of a closed line is its first.
std::size_t movable_points(const Landmark& mark) noexcept;

/// Moves every point to the floor.
void settle_on_floor(Outline& target);

}  // namespace cusp::ui
