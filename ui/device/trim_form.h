/// How the grip of one Falcon leads the bur, and how strong it is: where it stands when an attempt begins, how much of the
/// hand's way the bur goes, which button is the clutch, and the force's correction. Every change can be taken back; what
/// it does is shown live under the hand. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>

#include "device/falcon/profile.h"
#include "ui/modules.h"

class QVBoxLayout;

namespace cusp::ui {

/// The part of a profile that people set by hand.
struct FalconTrim {
  Vec3 centre_m = falcon::kMiddleM;
  double scale = FalconProfile{}.scale;
  std::uint8_t clutch = FalconButtons{}.clutch;
  double force_gain = 1.0;
  friend bool operator==(const FalconTrim&, const FalconTrim&) = default;
};
FalconTrim trim_of(const FalconProfile& profile);
void put_trim(const FalconTrim& trim, FalconProfile& profile);

class TrimForm : public QWidget {
  Q_OBJECT

 public:
  explicit TrimForm(QWidget* parent = nullptr);
  ~TrimForm() override;

  /// Of another device: the steps that could be taken back are of the one before, and go.
  void set_trim(const FalconTrim& trim);
  const FalconTrim& trim() const;
  /// Where the grip of a homed Falcon is now, and where these numbers put the bur.
  void show_grip(const FalconView& view);
  /// Before homing nothing is known of the grip's place.
  void hide_grip();

 public Q_SLOTS:
  void undo();
  void reset();

 Q_SIGNALS:
  /// By the user, undo() or reset().
  void changed(const FalconTrim& trim);

 private:
  void make_place(QVBoxLayout* column);
  void make_start(QVBoxLayout* column);
  void make_ratios(QVBoxLayout* column);
  void connect_fields();
  void set(const FalconTrim& trim, int field);
  void fill();

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
