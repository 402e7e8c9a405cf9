#include "studio/charts/gnuplot.hpp"

#include "engine/base/child_process.hpp"
#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace rift::studio {

namespace fs = std::filesystem;
using base::WorldError;
namespace {

/// gnuplot's message on one line: it repeats the command and points at the fault with a caret, over several
/// lines.
std::string on_one_line(const std::string& said) {
  std::string out;
  for (const char c : said) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

/// Runs gnuplot in the folder. Throws WorldError.
void run_gnuplot(const std::string& outputs, const fs::path& picture, const fs::path& script) try {
  // --default-settings: a user's own ~/.gnuplot does not change the charts of a report.
  base::ChildProcess gnuplot({"gnuplot", "--default-settings", "-e", outputs, script.filename().string()},
                             {.folder = script.parent_path()});
  const base::ChildProcess::End& end = gnuplot.wait();
  if (end.signal != 0)
    throw WorldError("draw", picture, fmt::format("gnuplot was ended by signal {}", end.signal));
  if (end.code != 0)
    throw WorldError("draw", picture,
                     fmt::format("gnuplot on {}: {}", script.string(), on_one_line(gnuplot.said())));
} catch (const base::StartError& none) {
  if (none.error == ENOENT)
    throw WorldError(
        "draw", picture,
        fmt::format("gnuplot is not installed: apt install gnuplot-nox; the data and the script are in {}",
                    script.parent_path().string()));
  throw WorldError("start gnuplot for", picture, base::reason_of(none.error));
}

/// gnuplot does not notice a full disk: a picture must have its end.
void require_end(const fs::path& picture, std::string_view end) {
  const std::string bytes = base::read_whole_file(picture);
  if (bytes.empty()) throw WorldError("draw", picture, "gnuplot wrote an empty file");
  if (bytes.size() < 16 || bytes.find(end, bytes.size() - 16) == std::string::npos)
    throw WorldError("draw", picture, "gnuplot wrote an incomplete file (is the disk full?)");
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace

void run_script(const fs::path& folder, const std::string& name) {
  base::PendingFile svg(folder / (name + ".svg")), png(folder / (name + ".png"));
  const fs::path script = folder / (name + ".gp");
  const std::string outputs = fmt::format("svg = '{}'; png = '{}'", svg.temporary().filename().string(),
                                          png.temporary().filename().string());
  run_gnuplot(outputs, folder / (name + ".svg"), script);
  require_end(svg.temporary(), "</svg>");
  require_end(png.temporary(), "IEND");
  svg.commit();
  png.commit();
}

std::string inline_svg(std::string_view svg, const std::string& name, const std::string& title) {
  std::string out;
  std::size_t at = svg.find("<svg");
  while (at < svg.size()) {
    const std::size_t tag = std::min(svg.find('<', at), svg.size());
    out += svg.substr(at, tag - at);
    const std::size_t end = std::min(svg.find('>', tag), svg.size() - 1) + 1;
    if (tag == svg.size()) break;
    std::string text(svg.substr(tag, end - tag));
    for (const std::string before : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
      replace_all(text, before, before + name + "_");
    if (text.starts_with("<svg"))
      text.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", html_escape(title)));
    at = text == "<title>" ? svg.find("</title>", end) + 8 : end;
    if (text != "<title>") out += text;
  }
  return out;
}

}  // namespace rift::studio
