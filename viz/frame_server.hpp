#pragma once

#include "viz/drawing_program.hpp"
#include "viz/order.hpp"
#include "viz/png.hpp"
#include "viz/shared_frame.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace rift::viz {

/// A drawing program that stays: it is asked for one picture after the other and never for two at once. Of
/// orders that wait the newest wins. Where it ends, the picture is missing and nothing else: it is started
/// again, at most once a second, for the order that is wanted then.
class FrameServer {
 public:
  explicit FrameServer(Gl gl = Gl::any, std::filesystem::path programs = own_folder());

  /// Starts the program before the first order, which it then answers sooner.
  void start();
  /// Asks for a picture in place of one that waits.
  void want(Order order);
  /// Takes the answer that has arrived, if one has, and sends the order that waits. @return whether there is
  /// a new picture
  bool look();
  /// Readable when look() has something to do; -1 where no picture is being drawn.
  [[nodiscard]] int descriptor() const;
  /// Whether a picture is being drawn or waits to be.
  [[nodiscard]] bool busy() const { return sent_ || wanted_; }

  /// The last picture, and what was said of it; empty before the first.
  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] const Answer& answer() const { return answer_; }
  /// The order that it answers.
  [[nodiscard]] const Order& order() const { return answered_; }
  /// Why the last picture is missing; empty where it is there.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  using Clock = std::chrono::steady_clock;
  void begin();
  void send();
  void take();
  void note_end();

  Gl gl_;
  std::filesystem::path programs_;
  SharedFrame shared_;
  std::optional<DrawingProgram> program_;
  Clock::time_point started_{};
  std::optional<Order> sent_, wanted_;
  Image image_;
  Answer answer_;
  Order answered_;
  std::string trouble_;
};

}  // namespace rift::viz
