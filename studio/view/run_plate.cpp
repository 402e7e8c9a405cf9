#include "studio/view/run_plate.hpp"

#include "studio/view/view_layout.hpp"
#include "viz/frame_server.hpp"
#include "viz/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace rift::studio {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto between_looks = std::chrono::milliseconds(250),
               after_failure = std::chrono::milliseconds(1000);

class RunPlate : public PlatePicture {
 public:
  RunPlate(const std::vector<std::filesystem::path>& runs, const std::filesystem::path& programs)
      : server_(viz::Gl::any, programs) {
    request_.runs = runs;
    request_.chart = viz::word_of(viz::Chart::none);  // the panel has its own
    server_.start();
  }

  void look(const Area& place, const PictureRoom& room, const PlateView& view) override {
    if (server_.look()) ++number_, shown_at_ = ordered_at_;
    const std::string field = view.velocity ? "vy" : "uy";
    if (view.lanes != request_.lanes) lanes_.clear();
    const bool other =
        view.lanes != request_.lanes || field != request_.field || view.titles != request_.texts;
    request_.lanes = view.lanes, request_.field = field, request_.texts = view.titles;
    request_.range_of_moment = view.velocity;  // nobody knows before how fast it will be
    place_ = limited(place, room);
    const bool soon = Clock::now() - looked_ < (trouble_.empty() ? between_looks : after_failure);
    if (!other && soon && view.until == until_ && (!plan_ || same(ordered_at_, place_))) return;
    until_ = view.until;
    looked_ = Clock::now();
    if (other) plan_.reset();
    read();
    if (plan_ && !place_.empty()) order(room);
  }

  [[nodiscard]] std::optional<ScreenPicture> picture() const override {
    if (number_ == 0 || place_.empty() || !same(shown_at_, place_)) return {};
    const viz::Image& image = server_.image();
    return ScreenPicture{place_, image.width, image.height, image.rgb, number_};
  }
  [[nodiscard]] int descriptor() const override { return server_.descriptor(); }
  [[nodiscard]] std::string trouble() const override {
    return server_.trouble().empty() ? trouble_ : server_.trouble();
  }

 private:
  /// The run's moments so far; one that has just begun has none yet.
  void read() try {
    std::vector<std::string> notes;
    if (lanes_.empty()) lanes_ = viz::open_lanes(request_, notes);
    for (const viz::Shown& lane : lanes_)
      if (!lane.journal->summary_json()) lane.journal->extend();
    if (std::any_of(lanes_.begin(), lanes_.end(), may_get_frames)) {
      trouble_ = "no frame is stored yet";
      return;
    }
    if (!plan_) plan_ = viz::plan_of(request_, lanes_);
    viz::choose_clock(*plan_, lanes_);
    trouble_.clear();
  } catch (const viz::BadRequest& mistake) {  // of the field, say: the lanes stay open
    trouble_ = mistake.what();
    plan_.reset();
  } catch (const std::exception& error) {
    trouble_ = error.what();
    plan_.reset();
    lanes_.clear();
  }

  static bool may_get_frames(const viz::Shown& lane) {
    return lane.frames().empty() && !lane.journal->summary_json();
  }

  void order(const PictureRoom& room) {
    const auto last = static_cast<double>(plan_->times_s.size() - 1);
    viz::Order order{plan_->job, plan_->times_s[static_cast<std::size_t>(std::lround(until_ * last))], {}};
    const auto size = pixels_for(place_, room, 1);
    order.job.width = size[0], order.job.height = size[1];
    std::string text = viz::to_json(order);
    if (text == ordered_ && same(ordered_at_, place_)) return;
    ordered_ = std::move(text);
    ordered_at_ = place_;
    server_.want(std::move(order));
  }

  viz::Request request_;
  std::vector<viz::Shown> lanes_;
  std::optional<viz::Plan> plan_;
  viz::FrameServer server_;
  Area place_, ordered_at_, shown_at_;
  std::string ordered_, trouble_;
  std::uint64_t number_ = 0;
  double until_ = 1;
  Clock::time_point looked_{};
};

}  // namespace

std::unique_ptr<PlatePicture> plate_of_runs(const std::vector<std::filesystem::path>& runs,
                                            const std::filesystem::path& programs) {
  return std::make_unique<RunPlate>(runs, programs);
}

}  // namespace rift::studio
