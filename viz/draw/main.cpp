#include "engine/base/console.hpp"
#include "viz/draw/answering.hpp"
#include "viz/draw/offscreen.hpp"
#include "viz/order.hpp"

#include <new>
#include <stdexcept>
#include <string_view>

/// Draws what is ordered, by one of two ways of asking (viz/draw/answering.hpp). A process of its own, so
/// that what goes wrong in OpenGL never takes a run with it.
namespace {

constexpr int failed = 1, no_opengl = 3;

}  // namespace

int main(int count, char** words) try {
  const bool serves = count == 2 && std::string_view(words[1]) == rift::viz::serve_option;
  rift::base::secure_standard_streams();
  serves ? rift::viz::answer_orders() : rift::viz::answer_times();
  return 0;
} catch (const rift::viz::NoOpenGl& error) {
  rift::base::message("{}\n", error.what());
  return no_opengl;
} catch (const std::bad_alloc&) {
  rift::base::message_text("not enough memory for such a frame\n");
  return failed;
} catch (const std::exception& error) {
  rift::base::message("{}\n", error.what());
  return failed;
}
