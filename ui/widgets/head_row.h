/// A title with buttons at its end; where the width does not hold both, the buttons stand in lines of their own below it. Or buttons
/// alone, in as many lines as the width needs. Thread: GUI.
#pragma once

#include <QLayout>
#include <cstdint>
#include <memory>
#include <vector>

namespace cusp::ui {

/// The first item is the title, unless all are buttons. Every other item keeps its own size and moves to the next line where none is
/// left.
class HeadRow : public QLayout {
 public:
  enum class Kind : std::uint8_t { titled, buttons };
  using QLayout::QLayout;
  explicit HeadRow(Kind kind) : kind_(kind) {}
  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  struct Line {
    std::vector<QLayoutItem*> items;
    QSize size;  // with the gaps between them
  };
  /// The lines of the width; first the title, alone if the buttons do not fit beside it.
  std::vector<Line> lines(int width) const;
  void add(Line& line, QLayoutItem* item) const;
  Kind kind_ = Kind::titled;
  std::vector<std::unique_ptr<QLayoutItem>> items_;
};

}  // namespace cusp::ui
