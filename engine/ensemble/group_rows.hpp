#pragma once

#include "engine/ensemble/numbers.hpp"
#include "engine/ensemble/part.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rift::ensemble {

/// Where a beam's loads come from and go to.
struct BeamPlaces {
  std::int32_t i, j, slot_i, slot_j;  // rows of state; slots in the ring
  int first;                          // its first element
};

/// The intact beams of a part for one scenario alone: groups of as many as the kernel takes side by side,
/// each number of a group's beams in a row (BeamGroup). What is missing of the last group is the last beam
/// again, without stiffness.
template <class Beam>
class GroupRows {
  using Real = typename Beam::Number;
  static constexpr int numbers = beam_numbers<Beam>;

 public:
  /// @param[in] size    beams of a group;  @param[in] beams, places  in the order of the walk
  /// @param[in] nobody  a slot where nobody looks;  @param[in] begin, end  elements of the part
  void make(std::size_t size, const std::vector<IntactRow<Beam>>& beams,
            const std::vector<BeamPlaces>& places, std::int32_t nobody, int begin, int end) {
    size_ = size, nobody_ = nobody;
    count_ = std::max<std::size_t>(1, (beams.size() + size - 1) / size);  // elements without beams still move
    rows_.assign(count_ * BeamGroup::rows * size, begin);
    number_.assign(count_ * numbers * size, 0);
    for (std::size_t place = 0; place < count_ * size; ++place) {
      row(place, BeamGroup::slot_i) = row(place, BeamGroup::slot_j) = nobody;
      if (beams.empty())
        number(place, 0) = number(place, 3) = 1;  // a beam that is not there: an axis and a length
      else
        set_beam(place, beams, places);
    }
    for (std::size_t next = size; next <= count_ * size; next += size)
      complete_.push_back(next < beams.size() ? std::clamp(places[next].first, begin, end) : end);
  }

  /// @param[in] dampers  of all beams. Beams without dampers in a group with some have none of any strength,
  /// whose loads nobody reads.
  void make_dampers(const std::vector<Dampers<Real>>& dampers) {
    const auto damped = [](const Dampers<Real>& d) { return d.at_surface >= 0; };
    for (std::size_t g = 0; g < count_; ++g) {
      const std::size_t first = g * size_, last = std::min(first + size_, dampers.size());
      if (std::none_of(dampers.begin() + first, dampers.begin() + last, damped)) {
        dampers_.push_back(-1);
        continue;
      }
      const std::size_t rows = damper_rows_.size(), place = damper_number_.size();
      dampers_.push_back(static_cast<std::int32_t>(rows / (BeamGroup::damper_rows * size_)));
      damper_rows_.resize(rows + BeamGroup::damper_rows * size_, nobody_);
      damper_number_.resize(place + BeamGroup::damper_numbers * size_, 0);
      for (std::size_t k = 0; k < size_; ++k) {
        std::int32_t* to = &damper_rows_[rows + k];
        to[BeamGroup::at_surface * size_] = 0;
        if (first + k >= last || !damped(dampers[first + k])) continue;
        const Dampers<Real>& d = dampers[first + k];
        to[BeamGroup::damper_slot_i * size_] = row(first + k, BeamGroup::slot_i);
        to[BeamGroup::damper_slot_j * size_] = row(first + k, BeamGroup::slot_j);
        to[BeamGroup::at_surface * size_] = d.at_surface;
        Real* strength = &damper_number_[place + k];
        strength[0] = d.axial, strength[size_] = d.twist, strength[2 * size_] = d.bend;
      }
    }
  }

  void set_stiffness(std::size_t place, const BeamStiffness<Real>& k) {
    number(place, numbers - 3) = k.axial;
    number(place, numbers - 2) = k.bending;
    number(place, numbers - 1) = k.twist;
  }

  std::size_t count() const { return count_; }

  void show(BeamView<Beam>& view) const {
    view.groups = static_cast<std::int32_t>(count_), view.group_rows = rows_.data();
    view.group_complete = complete_.data(), view.group_number = number_.data();
    view.group_dampers = dampers_.data(), view.group_damper_rows = damper_rows_.data();
    view.group_damper_number = damper_number_.data();
  }

 private:
  std::int32_t& row(std::size_t place, int which) {
    return rows_[(place / size_ * BeamGroup::rows + which) * size_ + place % size_];
  }
  Real& number(std::size_t place, int which) {
    return number_[(place / size_ * numbers + which) * size_ + place % size_];
  }

  void set_beam(std::size_t place, const std::vector<IntactRow<Beam>>& beams,
                const std::vector<BeamPlaces>& places) {
    const bool missing = place >= beams.size();
    const std::size_t beam = missing ? beams.size() - 1 : place;
    row(place, BeamGroup::i) = places[beam].i, row(place, BeamGroup::j) = places[beam].j;
    const Real* form = reinterpret_cast<const Real*>(&beams[beam].form);
    for (int a = 0; a < numbers; ++a) number(place, a) = form[a];
    if (missing)
      set_stiffness(place, {0, 0, 0});
    else
      row(place, BeamGroup::slot_i) = places[beam].slot_i,
                 row(place, BeamGroup::slot_j) = places[beam].slot_j;
  }

  std::size_t size_ = 1, count_ = 0;
  std::int32_t nobody_ = 0;
  std::vector<std::int32_t> rows_, complete_, dampers_, damper_rows_;
  AlignedVector<Real> number_, damper_number_;
};

}  // namespace rift::ensemble
