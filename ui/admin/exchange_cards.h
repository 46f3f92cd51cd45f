/// The two steps before a file of another station is read: comparing its key, and what the file carries. Thread: GUI.
#pragma once

#include "storage/exchange/exchange.h"
#include "ui/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

/// A sentence that wraps, in an ink of make_label().
QLabel* make_note(const QString& text, const char* ink = "text2");

/// A key to be compared, and as what it is or would be known.
struct KeyToTrust {
  PublicKey key{};
  std::optional<KeyRole> known{};  // nullopt: nobody has made it known
  KeyRole offered = KeyRole::station;
  QString name{};
};

class TrustCard : public Card {
  Q_OBJECT

 public:
  explicit TrustCard(const KeyToTrust& asked);

 Q_SIGNALS:
  void agreed(KeyRole role, const QString& name);
  void left();

 private:
  QWidget* make_choices(const KeyToTrust& asked);
  QWidget* make_acts(const KeyToTrust& asked);
  void show_role();

  Segments* role_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* brings_ = nullptr;
};

class FileCard : public Card {
  Q_OBJECT

 public:
  /// `from`: the name of its station. `file`: the path.
  struct Shown {
    ExchangeLook look;
    QString from, file;
  };
  explicit FileCard(const Shown& shown);

 Q_SIGNALS:
  void agreed();
  void left();

 private:
  QString follows(const ExchangeLook& look) const;
};

}  // namespace cusp::ui
