#include "engine/base/clock.hpp"
#include "engine/scene/units.hpp"
#include "studio/view/view_screen.hpp"
#include "studio/view/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rift::studio {
namespace {

double clock_s() { return base::seconds_since(base::Clock::time_point{}); }

/// A whole text as a number.
std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// The name after the present one, round and round.
template <typename Rows>
std::string next_name(const Rows& rows, std::string_view now) {
  auto at = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == now; });
  if (at != rows.end()) ++at;
  return std::string(at == rows.end() ? rows.front().name : at->name);
}

}  // namespace

Navigation ViewScreen::press(const KeyEvent& event) {
  touch();
  if (prompt_.typing()) {
    if (prompt_.press(event) == Prompt::State::entered) take_typed();
    return {};
  }
  if (crosshair_ && move_crosshair(event)) return {};
  if (event.key >= key_click) {
    press_mouse(event);
    return {};
  }
  const Action action = action_of(Where::view, event.key);
  if (action == Action::back) return {Navigation::To::back, nullptr};
  act(action);
  return {};
}

void ViewScreen::act(Action action) {
  (void)(act_on_time(action) || act_on_camera(action) || act_on_look(action) || act_on_files(action));
}

bool ViewScreen::act_on_time(Action action) {
  switch (action) {
    case Action::pause:
      player_.toggle(clock_s());
      return true;
    case Action::step:
      player_.go_to(player_.moment() + 1);
      return true;
    case Action::previous:
      player_.go_to(player_.moment() - 1);
      return true;
    case Action::page_down:
      player_.go_to(player_.moment() + 10);
      return true;
    case Action::page_up:
      player_.go_to(player_.moment() - 10);
      return true;
    case Action::first:
      player_.go_to(0);
      return true;
    case Action::last:
      player_.go_to(static_cast<int>(plan_.times_s.size()) - 1);
      return true;
    case Action::slower:
    case Action::faster:
      player_.change_speed(action == Action::faster ? 1.5 : 1 / 1.5, clock_s());
      message_ = fmt::format("plays {:.3g} moments a second", player_.per_second());
      return true;
    case Action::jump:
      asks_ = Asks::moment;
      prompt_ = Prompt("time (12 us) or tip (30 mm)", "");
      return true;
    default:
      return false;
  }
}

bool ViewScreen::act_on_look(Action action) {
  const viz::Look& look = plan_.job.look;
  switch (action) {
    case Action::next_field:
      next_field();
      return true;
    case Action::next_colours:
      change([&](viz::Request& request) {
        request.colours = next_name(viz::colour_maps(), colours_of(look));
      });
      message_ = "colours: " + plan_.job.look.colours;
      return true;
    case Action::next_range:
      next_range();
      return true;
    case Action::next_beams:
      change([&](viz::Request& request) {
        request.beams = look.beams == viz::Beams::none       ? "crossing"
                        : look.beams == viz::Beams::crossing ? "all"
                                                             : "none";
      });
      return true;
    case Action::show_budget:
      change([&](viz::Request& request) {
        request.chart = viz::word_of(look.chart == viz::Chart::none ? viz::Chart::whole : viz::Chart::none);
      });
      return true;
    case Action::magnify:
      asks_ = Asks::magnification;
      prompt_ = Prompt("magnification of the displacements", fmt::format("{:g}", look.magnification));
      return true;
    case Action::ask:
      crosshair_ = crosshair_ ? std::nullopt : std::optional(middle_of_plate());
      message_ = crosshair_ ? "the arrows move the crosshair, enter asks what is there, i takes it away" : "";
      show_crosshair();
      return true;
    default:
      return false;
  }
}

/// The next field that the runs store.
void ViewScreen::next_field() {
  std::string name = plan_.job.look.field;
  const auto take = [&](viz::Request& request) {
    request.field = name;
    request.range.reset();
    request.colours.reset();
  };
  for (std::size_t k = 0; k < viz::fields().size(); ++k) {
    name = next_name(viz::fields(), name);
    if (change(take)) return;
  }
}

void ViewScreen::next_range() {
  const viz::Look& look = plan_.job.look;
  if (!look.range_of_moment && !request_.range) {
    change([](viz::Request& request) { request.range_of_moment = true; });
    message_ = "range: of each moment";
  } else if (look.range_of_moment) {
    const double unit = viz::find_field(look.field)->unit_in_si;
    const auto& range = server_.answer().range;
    asks_ = Asks::range;
    prompt_ = Prompt("range from,to; empty for all moments",
                     fmt::format("{:.4g},{:.4g}", range[0] / unit, range[1] / unit));
  } else {
    change([](viz::Request& request) { request.range.reset(); });
    message_ = "range: of all moments";
  }
}

/// Plans the picture again with something changed; what cannot be is said and left as it was.
bool ViewScreen::change(const std::function<void(viz::Request&)>& what) {
  const viz::Request before = request_;
  what(request_);
  try {
    plan_ = viz::plan_of(request_, shown_);
    message_.clear();
    return true;
  } catch (const std::exception& error) {
    message_ = error.what();
  }
  request_ = before;
  return false;
}

void ViewScreen::take_typed() {
  const std::string text = prompt_.text();
  if (asks_ == Asks::moment) return jump(text);
  if (asks_ == Asks::magnification) {
    const auto number = number_of(text);
    if (!number || *number < 0 || *number > 1000) {
      message_ = fmt::format("magnification '{}': expected a number from 0 to 1000", text);
      return;
    }
    change([&](viz::Request& request) { request.magnification = *number; });
    return;
  }
  const std::size_t comma = text.find(',');
  if (text.empty()) {
    change([](viz::Request& r) { r.range_of_moment = false, r.range.reset(); });
    return;
  }
  const auto low = number_of(std::string_view(text).substr(0, comma));
  const auto high =
      comma == std::string::npos ? std::nullopt : number_of(std::string_view(text).substr(comma + 1));
  if (!low || !high || !(*low < *high)) {
    message_ = fmt::format("range '{}': expected two ascending numbers such as 0,2", text);
    return;
  }
  change([&](viz::Request& r) { r.range_of_moment = false, r.range = std::array{*low, *high}; });
}

void ViewScreen::jump(const std::string& text) {
  const auto time = scene::read_quantity(text, scene::Dimension::time);
  const auto tip = scene::read_quantity(text, scene::Dimension::length);
  if (!time.value && !tip.value) {
    message_ = fmt::format("'{}' is neither a time such as 12 us nor a tip position such as 30 mm", text);
    return;
  }
  const std::vector<double>& rows = time.value ? plan_.times_s : plan_.tips_m;
  const double wanted = time.value ? *time.value : *tip.value;
  const auto after = std::upper_bound(rows.begin(), rows.end(), wanted * (1 + 1e-12));
  player_.go_to(static_cast<int>(after - rows.begin()) - 1);
}

/// What is written to a file has texts that can be read there.
viz::Job ViewScreen::saved_job() const {
  viz::Job job = job_of_size(1);
  if (!room_.symbols && room_.pictures) return job;
  job.look.texts = true;
  job.width = 1280, job.height = 720;
  return job;
}

std::vector<std::string> ViewScreen::command_of_picture() const {
  std::vector<std::string> words = render_arguments(saved_job(), request_.lanes);
  const auto last = static_cast<double>(plan_.times_s.size() - 1);
  words.insert(words.end(), {"--at", fmt::format("{:.8g}", last > 0 ? player_.moment() / last : 0.0)});
  return words;
}

bool ViewScreen::act_on_files(Action action) {
  const std::filesystem::path run = plan_.job.panes.front().run;
  switch (action) {
    case Action::frame: {
      std::vector<std::string> words = command_of_picture();
      words.insert(words.end(), {"--picture", jobs_.free_file(run, "view", ".png").string(), "--quiet"});
      message_ = jobs_.start(words, "picture");
      return true;
    }
    case Action::film: {
      std::vector<std::string> words = render_arguments(saved_job(), request_.lanes);
      words.insert(words.end(), {"--film", jobs_.free_file(run, "view", ".mp4").string(), "--quiet"});
      message_ = jobs_.start(words, "film");
      return true;
    }
    case Action::show_command: {
      std::vector<std::string> words = command_of_picture();
      words.insert(words.begin(), "rift");
      message_ = shell_line(words);
      const bool is_new = commands_ != nullptr && (commands_->empty() || commands_->back() != message_);
      if (is_new) commands_->push_back(message_);
      return true;
    }
    default:
      return false;
  }
}

}  // namespace rift::studio
