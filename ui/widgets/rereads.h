/// A page that reads the records anew in place, and so keeps what is chosen on it: filters, order, row. Thread: GUI.
#pragma once

namespace cusp::ui {

class Rereads {
 public:
  /// When a page that lay over it is closed. False: its filters lack something, and it is made anew.
  virtual bool read_again() = 0;

 protected:
  ~Rereads() = default;
};

}  // namespace cusp::ui
