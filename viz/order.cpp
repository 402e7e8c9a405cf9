#include "viz/order.hpp"

#include "engine/base/text.hpp"
#include "engine/results/json_input.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace rift::viz {

std::string to_json(const Order& order) {
  nlohmann::json json{{"job", to_json(order.job)}, {"time_s", order.time_s}};
  if (order.asked) json["asked"] = *order.asked;
  return base::json_text(json);
}

Order order_from_json(std::string_view text) {
  try {
    const auto json = results::json_or_discarded<nlohmann::json>(text);
    Order order{job_from_json(json.at("job").get<std::string>()), json.at("time_s").get<double>(), {}};
    if (json.contains("asked")) order.asked = json.at("asked").get<std::array<double, 2>>();
    return order;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace rift::viz
