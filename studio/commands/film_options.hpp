#pragma once

#include "viz/plan.hpp"
#include "viz/record.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <string>

namespace rift::studio {

/// How a film looks, as options say it; what is not said is as the run's preset has it.
struct FilmOptions {
  viz::Wish wish;
  std::string size = "1280x720", range, gl = "auto";
  bool no_chart = false;
  double fps = 0;  // 0: so that a film lasts about eight seconds
};

/// --field, --size, --camera, ... @param several_lanes  whether lanes can be chosen
void add_film_options(CLI::App& command, FilmOptions& options);

/// The wish with its size and range read, and what was changed of it, for the user. Throws viz::BadWish.
std::vector<std::string> read_wish(FilmOptions& options);

viz::Gl gl_of(const FilmOptions& options);

/// Frames a second of a film of `frames`.
double rate_of(const FilmOptions& options, std::size_t frames);

}  // namespace rift::studio
