#include "studio/view/view_screen.hpp"

#include "engine/base/clock.hpp"
#include "engine/results/records.hpp"
#include "studio/screen/plate.hpp"
#include "studio/view/camera.hpp"
#include "studio/view/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rift::studio {
namespace {

constexpr double shown_within_s = 0.1;  // a picture while something moves
constexpr auto rests_after = std::chrono::milliseconds(300);
constexpr auto between_looks_at_runs = std::chrono::seconds(1);

double now_s() { return base::seconds_since(base::Clock::time_point{}); }

/// So that all moments last about eight seconds, as in films.
double usual_rate(std::size_t moments) { return std::clamp(static_cast<double>(moments) / 8.0, 5.0, 30.0); }

/// The largest of a few shares that is no larger: pictures of few sizes, each of which the drawing program
/// keeps.
double one_of_few(double share) {
  for (const double one : {1.0, 0.7, 0.5, 0.35})
    if (one <= share) return one;
  return 0.25;
}

/// Light and dark in turn, so that it is seen on any colour.
void draw_crosshair(std::vector<std::uint8_t>& rgb, int width, int height, const std::array<double, 2>& at) {
  const int column = std::min(width - 1, static_cast<int>(at[0] * width));
  const int row = std::min(height - 1, static_cast<int>((1 - at[1]) * height));
  const auto dot = [&](int x, int y, int along) {
    const std::uint8_t grey = along / 4 % 2 == 0 ? 0 : 255;
    std::fill_n(rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + x), 3, grey);
  };
  for (int x = 0; x < width; ++x) dot(x, row, x);
  for (int y = 0; y < height; ++y) dot(column, y, y);
}

}  // namespace

ViewScreen::ViewScreen(viz::Request request, viz::Gl gl, std::filesystem::path program)
    : request_(std::move(request)),
      server_(gl, program.parent_path()),
      jobs_(std::move(program)),
      player_(1, 1) {
  std::vector<std::string> notes;
  shown_ = viz::open_lanes(request_, notes);
  if (!notes.empty()) message_ = notes.front();
  server_.start();
  plan_ = viz::plan_of(request_, shown_);
  asked_chart_ = request_.chart;
  if (!asked_chart_ && plan_.job.look.chart == viz::Chart::growing) {  // which is for films
    plan_.job.look.chart = viz::Chart::whole;
    request_.chart = viz::word_of(viz::Chart::whole);
  }
  player_ = Player(static_cast<int>(plan_.times_s.size()), usual_rate(plan_.times_s.size()));
  if (!all_ended()) player_.go_to(static_cast<int>(plan_.times_s.size()) - 1);  // and follows the runs
}

bool ViewScreen::all_ended() const {
  return std::all_of(shown_.begin(), shown_.end(),
                     [](const viz::Shown& pane) { return pane.journal->summary_json().has_value(); });
}

void ViewScreen::take_room(const PictureRoom& room) {
  room_ = room;
  if (!has_room_ && room.symbols) {  // texts could not be read
    const std::string said = message_;
    const bool can = change([this](viz::Request& request) {
      request.texts = false;
      request.chart = asked_chart_.value_or(viz::word_of(viz::Chart::none));
    });
    if (can) message_ = said;
  }
  if (!has_room_ && !room.pictures)
    message_ = "this terminal gets no pictures: the plate is in cells, by vertical displacement";
  has_room_ = true;
}

int ViewScreen::patience_ms() const {
  constexpr int waits_to_be_sent_ms = 5;
  if (player_.playing() && room_.shown != number_) return waits_to_be_sent_ms;
  if (player_.playing()) return std::clamp(static_cast<int>(std::ceil(1e3 * player_.due_in(now_s()))), 1, 50);
  return Clock::now() - touched_ < rests_after ? 20 : 95;
}

Navigation ViewScreen::look() {
  take_news();
  player_.look(now_s());
  if (Clock::now() - followed_ > between_looks_at_runs) follow_runs();
  if (layout_.picture.empty() || !has_room_ || !room_.pictures) return {};
  order();
  return {};
}

void ViewScreen::take_news() {
  if (const std::string news = jobs_.report_ended(); !news.empty()) message_ = news;
  if (server_.look()) take_picture();
  if (!server_.trouble().empty()) message_ = server_.trouble();
}

/// A picture that only came with an answer is there already.
void ViewScreen::take_picture() {
  const viz::Answer& answer = server_.answer();
  if (server_.order().asked) take_answer();
  viz::Order order = server_.order();
  order.asked.reset();
  const std::string text = viz::to_json(order);
  image_for_ = ordered_for_;
  if (text == shown_order_) return;
  shown_order_ = text;
  const auto all = pixels_for(image_for_, room_, 1);
  const bool whole = answer.width == all[0] && answer.height == all[1];
  if (whole) drawn_s_ = answer.seconds;
  moves_ = !whole || moves_now();
  show_crosshair();
}

void ViewScreen::show_crosshair() {
  const viz::Image& image = server_.image();
  if (image.rgb.empty()) return;
  pixels_ = image.rgb;
  if (crosshair_) draw_crosshair(pixels_, image.width, image.height, *crosshair_);
  ++number_;
}

void ViewScreen::take_answer() {
  asked_.reset();
  asking_ = false;
  picked_.push_back(server_.answer().picked);
  if (picked_.size() > 2) picked_.erase(picked_.begin());
  message_ = text_of(picked_.back());
  const bool two = picked_.size() == 2 && picked_[0].kind != viz::Picked::Kind::nothing &&
                   picked_[1].kind != viz::Picked::Kind::nothing;
  if (two) message_ += "   " + distance_between(picked_[0], picked_[1]);
}

/// What runs that go on have stored since.
void ViewScreen::follow_runs() try {
  followed_ = Clock::now();
  std::size_t before = plan_.times_s.size();
  for (const viz::Shown& pane : shown_)
    if (!pane.journal->summary_json()) {
      pane.journal->extend();
      if (pane.journal->summary_json()) ordered_.clear();  // its release rate is known from now on
    }
  viz::choose_clock(plan_, shown_);
  if (plan_.times_s.size() != before) player_.grow(static_cast<int>(plan_.times_s.size()));
} catch (const std::exception& error) {
  message_ = error.what();
}

bool ViewScreen::moves_now() const {
  return (player_.playing() || Clock::now() - touched_ < rests_after) && !asked_;
}

double ViewScreen::share_now() const {
  return moves_now() ? one_of_few(share_while_moving(layout_.picture, room_, drawn_s_, shown_within_s)) : 1.0;
}

viz::Job ViewScreen::job_of_size(double share) const {
  viz::Job job = plan_.job;
  const auto size = pixels_for(layout_.picture, room_, share);
  job.width = size[0], job.height = size[1];
  return job;
}

/// Asks for the picture that should be there now. While the terminal still takes one and the next waits, none
/// of a moment that will be over is drawn.
void ViewScreen::order() {
  if (player_.playing() && room_.shown != number_ && picture()) return;
  const bool moves = moves_now();
  viz::Order order{job_of_size(share_now()), plan_.times_s[static_cast<std::size_t>(player_.moment())], {}};
  const std::string text = viz::to_json(order);
  const bool asks = asked_ && !asking_;
  if (text == ordered_ && same(ordered_for_, layout_.picture) && !asks) {
    if (!moves && room_.rough && !server_.busy()) show_at_rest();
    return;
  }
  if (asked_) order.asked = {(*asked_)[0] * order.job.width, (*asked_)[1] * order.job.height};
  asking_ = asked_.has_value();
  ordered_ = text;
  ordered_for_ = layout_.picture;
  server_.want(std::move(order));
}

/// The picture that is there was sent roughly, and stays.
void ViewScreen::show_at_rest() {
  if (!moves_) return;
  moves_ = false;
  show_crosshair();
}

std::optional<ScreenPicture> ViewScreen::picture() const {
  const Area& place = layout_.picture;
  if (number_ == 0 || place.empty() || !same(image_for_, place)) return {};
  return ScreenPicture{place, server_.image().width, server_.image().height, pixels_, number_, moves_};
}

void ViewScreen::draw(Canvas& canvas, Glyphs glyphs) {
  width_ = canvas.width(), height_ = canvas.height();
  layout_ = view_layout(width_, height_, room_);
  if (draw_too_small(canvas)) return;
  if (has_room_ && !room_.pictures) draw_cells(canvas, glyphs);
  const double rayleigh = shown_.front().header.value("rayleigh_speed_m_s", 0.0);
  viz::Answer answer = server_.answer();
  const auto moment = static_cast<std::size_t>(player_.moment());
  if (answer.width == 0) {  // nothing was drawn yet
    answer.pane[0].since_start_s = plan_.times_s[moment];
    answer.pane[0].tip_m = plan_.tips_m[moment];
    answer.range = plan_.job.look.range;
  }
  canvas.text(layout_.numbers.x, layout_.numbers.y,
              numbers_of(answer, plan_.job.look, player_.moment(), static_cast<int>(plan_.times_s.size()),
                         all_ended(), rayleigh),
              {Ink::plain, true}, layout_.numbers.width);
  draw_paragraph(canvas, layout_.message, message_, {});
  if (prompt_.typing())
    prompt_.draw(canvas, layout_.foot);
  else
    canvas.text(layout_.foot.x, layout_.foot.y, foot_of(Where::view, layout_.foot.width), {Ink::dim},
                layout_.foot.width);
}

/// What a terminal without pictures gets: vertical displacement or velocity of the first lane.
void ViewScreen::draw_cells(Canvas& canvas, Glyphs glyphs) try {
  const viz::Shown& pane = shown_.front();
  const auto at = std::min(static_cast<std::size_t>(player_.moment()), pane.frames().size() - 1);
  if (cells_moment_ != static_cast<int>(at)) cells_frame_ = pane.journal->frame(pane.frames()[at]);
  cells_moment_ = static_cast<int>(at);
  const auto tips = results::tips_at(pane.header, cells_frame_->tip_m);
  draw_plate(canvas, layout_.picture, pane.journal->geometry(), cells_frame_->displacement,
             {.length = pane.header.value("length_m", 0.0),
              .height = pane.header.value("height_m", 0.0),
              .pulled = pane.header.value("displacement_m", 0.0),
              .tips = tips},
             glyphs);
} catch (const std::exception& error) {
  message_ = error.what();
}

}  // namespace rift::studio
