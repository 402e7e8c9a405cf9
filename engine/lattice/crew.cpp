#include "engine/lattice/crew.hpp"

#include <algorithm>
#include <cstdint>

namespace rift {
namespace {

int count_hands(int hands, int most) {
  if (hands <= 0) hands = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(hands, 1, std::max(1, most));
}

}  // namespace

Crew::Crew(int hands, int most) : hands_(count_hands(hands, most)), start_(hands_), end_(hands_) {
  for (int hand = 1; hand < hands_; ++hand)
    helpers_.emplace_back([this, hand] {
      for (start_.arrive_and_wait(); task_ != nullptr; start_.arrive_and_wait()) {
        work(hand);
        end_.arrive_and_wait();
      }
    });
}

Crew::~Crew() {
  task_ = nullptr;
  start_.arrive_and_wait();
}

void Crew::run(int tasks, const std::function<void(int)>& task) {
  tasks_ = tasks;
  task_ = &task;
  start_.arrive_and_wait();
  work(0);
  end_.arrive_and_wait();
}

void Crew::work(int hand) const {
  const auto share = [&](int h) { return static_cast<int>(std::int64_t{tasks_} * h / hands_); };
  for (int k = share(hand); k < share(hand + 1); ++k) (*task_)(k);
}

}  // namespace rift
