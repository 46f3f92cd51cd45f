// The only file with Boost. Everything runs on the thread that calls wait(): no thread of Boost's own.
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>

#include "device/inverse/inverse_port.h"
#include "device/inverse/service_probe.h"

namespace cusp::device {

namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using inverse::LinkEvent;
using inverse::LinkTime;

constexpr std::chrono::milliseconds kLongestProbe{200};
constexpr std::size_t kMostQueued = 8;  // messages that nobody takes: the other side stands still

class BeastLink final : public inverse::InverseLink {
 public:
  explicit BeastLink(const inverse::ServiceAddress& address) : address_(address) {}
  ~BeastLink() override { close(); }

  LinkTime now() const noexcept override { return std::chrono::steady_clock::now(); }

  void open() override {
    close();
    line_ = std::make_shared<Line>(context_);
    const auto line = line_;
    const tcp::endpoint there(asio::ip::address_v4::loopback(), address_.port);
    line->stream.next_layer().async_connect(there, [this, line](boost::system::error_code error) {
      if (line != line_) return;
      if (error) return queue(LinkEvent::Kind::refused);
      boost::system::error_code ignored;
      line->stream.next_layer().set_option(tcp::no_delay(true), ignored);
      line->stream.read_message_max(inverse::kMostBytes);
      line->stream.async_handshake("localhost:" + std::to_string(address_.port), "/",
                                   [this, line](boost::system::error_code refused) {
                                     if (line != line_) return;
                                     if (refused) return queue(LinkEvent::Kind::refused);
                                     line->open = true;
                                     line->stream.text(true);
                                     queue(LinkEvent::Kind::opened);
                                     read(line);
                                   });
    });
  }

  void send(std::string text) override {
    if (!line_ || !line_->open || line_->out.size() >= kMostQueued) return;
    line_->out.push_back(std::move(text));
    if (line_->out.size() == 1) write(line_);
  }

  LinkEvent wait(LinkTime until) override {
    try {
      while (events_.empty()) {
        context_.restart();
        if (context_.run_one_until(until) == 0) {
          if (now() >= until) return {};
          // Nothing is under way: there is nothing to wait for but the time.
          asio::steady_timer timer(context_, until);
          timer.async_wait([](boost::system::error_code) {});
          context_.restart();
          context_.run_one_until(until);
        }
        if (events_.empty() && now() >= until) return {};
      }
    } catch (const std::exception&) {
      close();
      return {LinkEvent::Kind::closed, {}};
    }
    given_ = std::move(events_.front());
    events_.pop_front();
    return {given_.kind, given_.text};
  }

  void close() noexcept override {
    if (!line_) return;
    boost::system::error_code ignored;
    line_->stream.next_layer().shutdown(tcp::socket::shutdown_both, ignored);
    line_->stream.next_layer().close(ignored);
    line_.reset();  // its handlers see that they are of a line that is gone
    events_.clear();
  }

 private:
  struct Event {
    LinkEvent::Kind kind = LinkEvent::Kind::time;
    std::string text;
  };
  struct Line {
    explicit Line(asio::io_context& context) : stream(context) {}
    websocket::stream<tcp::socket> stream;
    boost::beast::flat_buffer in;
    std::deque<std::string> out;
    bool open = false;
  };

  void queue(LinkEvent::Kind kind, std::string text = {}) {
    if (line_ && kind != LinkEvent::Kind::message && kind != LinkEvent::Kind::opened) line_->open = false;
    events_.push_back({kind, std::move(text)});
  }

  void read(const std::shared_ptr<Line>& line) {
    line->stream.async_read(line->in, [this, line](boost::system::error_code error, std::size_t) {
      if (line != line_) return;
      if (error) return queue(LinkEvent::Kind::closed);
      queue(LinkEvent::Kind::message, boost::beast::buffers_to_string(line->in.data()));
      line->in.consume(line->in.size());
      read(line);
    });
  }

  void write(const std::shared_ptr<Line>& line) {
    line->stream.async_write(asio::buffer(line->out.front()), [this, line](boost::system::error_code error, std::size_t) {
      if (line != line_) return;
      if (error) return queue(LinkEvent::Kind::closed);
      line->out.pop_front();
      if (!line->out.empty()) write(line);
    });
  }

  inverse::ServiceAddress address_;
  asio::io_context context_{1};
  std::shared_ptr<Line> line_;
  std::deque<Event> events_;
  Event given_;
};

}  // namespace

bool inverse::service_listens(const ServiceAddress& address) noexcept {
  try {
    bool listens = false;
    asio::io_context context;
    tcp::socket socket(context);
    socket.async_connect({asio::ip::address_v4::loopback(), address.port},
                         [&listens](boost::system::error_code error) { listens = !error; });
    context.run_for(kLongestProbe);
    return listens;
  } catch (const std::exception&) {
    return false;
  }
}

std::unique_ptr<InversePort> make_inverse_port(const InverseSettings& settings) {
  return std::make_unique<InversePort>(std::make_unique<BeastLink>(settings.service), settings);
}

}  // namespace cusp::device
