#include "engine/study/not_made.hpp"

#include <algorithm>
#include <string>

namespace rift::study {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> lines_of(const std::vector<scene::Issue>& issues) {
  std::vector<std::string> lines;
  for (const scene::Issue& issue : issues) lines.push_back(scene::to_text(issue));
  return lines;
}

}  // namespace

void add_not_made(std::vector<NotMade>& all, const std::vector<StudyItem>& items,
                  const std::vector<scene::Issue>& issues) {
  auto known = std::find_if(all.begin(), all.end(),
                            [&](const NotMade& other) { return lines_of(other.issues) == lines_of(issues); });
  if (known == all.end()) known = all.insert(all.end(), NotMade{{}, issues});
  for (const StudyItem& item : items) known->rows.push_back(item.row);
}

Json to_json(const std::vector<NotMade>& not_made, const scene::Preset& preset) {
  Json list = Json::array();
  for (const NotMade& one : not_made) {
    Json axes = Json::object(), why = Json::array();
    for (const int row : one.rows)
      for (const auto& [name, text] : preset.study[row].axes) {
        Json& texts = axes[name];
        if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
      }
    for (const scene::Issue& issue : one.issues) why.push_back(scene::without_place(issue));
    list.push_back({{"rows", one.rows}, {"axes", std::move(axes)}, {"why", std::move(why)}});
  }
  return list;
}

}  // namespace rift::study
