#include "engine/ensemble/part_rows.hpp"

#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace rift::ensemble {
namespace {

/// Beams that the path does not cross, by their first element, then by their second.
std::vector<int> sound_beams(const RowSource& s) {
  std::vector<char> crossed(s.lattice.beam.size(), 0);
  for (const fracture::Crossing& c : s.met) crossed[c.beam] = 1;
  std::vector<int> sound;
  for (int b = 0; b < static_cast<int>(crossed.size()); ++b)
    if (!crossed[b]) sound.push_back(b);
  std::stable_sort(sound.begin(), sound.end(),
                   [&](int a, int b) { return s.lattice.ends[a] < s.lattice.ends[b]; });
  return sound;
}

template <class Real>
BeamStiffness<Real> stiffness_of_row(const lattice::Beam& b) {
  return {static_cast<Real>(b.axial), static_cast<Real>(b.bending), static_cast<Real>(b.twist)};
}

template <class Real>
void set_form(LinearBeam<Real>& form, const RowSource& s, int beam) {
  const lattice::Beam& b = s.lattice.beam[beam];
  form = {static_cast<Real>(b.axis.x()), static_cast<Real>(b.axis.y()), static_cast<Real>(b.axis.z()),
          static_cast<Real>(2.0 / b.length), stiffness_of_row<Real>(b)};
}

template <class Real>
void set_form(CorotationalBeam<Real>& form, const RowSource& s, int beam) {
  const lattice::Beam& b = s.lattice.beam[beam];
  const auto& [i, j] = s.lattice.ends[beam];
  const Eigen::Vector3d base = s.base[j].head<3>() - s.base[i].head<3>();
  form = {static_cast<Real>(b.axis.x()), static_cast<Real>(b.axis.y()), static_cast<Real>(b.axis.z()),
          static_cast<Real>(b.length),   static_cast<Real>(base.x()),   static_cast<Real>(base.y()),
          static_cast<Real>(base.z()),   stiffness_of_row<Real>(b)};
}

/// Makes the rows of one part, which owns [begin, end).
template <class Real>
class Maker {
 public:
  Maker(const RowSource& source, int begin, int end, int first_ghost_row, int lanes)
      : s_(source), begin_(begin), end_(end), lanes_(lanes) {
    rows_.first_ghost_row = first_ghost_row;
  }

  PartRows<Real> make() {
    choose_sound();
    find_ghosts_and_specials();
    if (s_.kinematics == lattice::Kinematics::linear) {
      make_rows(rows_.linear, rows_.linear_crossing);
      make_contacts(rows_.linear_contact);
      if (lanes_ == 1) make_groups(rows_.linear, rows_.linear_group);
    } else {
      make_rows(rows_.corotational, rows_.corotational_crossing);
      make_contacts(rows_.corotational_contact);
      if (lanes_ == 1) make_groups(rows_.corotational, rows_.corotational_group);
    }
    make_damped();
    make_room();
    return std::move(rows_);
  }

 private:
  bool owns(int element) const { return element >= begin_ && element < end_; }
  const std::array<int, 2>& ends(int beam) const { return s_.lattice.ends[beam]; }

  /// Halo beams first, then the part's own.
  void choose_sound() {
    for (const int b : sound_beams(s_)) {
      const auto& [i, j] = ends(b);
      if (owns(i) || owns(j)) (owns(i) ? own_ : halo_).push_back(b);
    }
    rows_.view.mask =
        static_cast<std::int32_t>(std::bit_ceil(static_cast<unsigned>(longest_reach()) + 1U)) - 1;
  }

  /// How far beyond the first element that still lacks forces the walk reaches: no two of those may share a
  /// slot.
  int longest_reach() const {
    std::vector<int> beams(halo_);
    beams.insert(beams.end(), own_.begin(), own_.end());
    const std::size_t at_once = lanes_ == 1 ? group_size : 1;
    int reach = 0;
    for (std::size_t b = 0; b < beams.size(); b += at_once) {
      const int lacking = std::max(begin_, ends(beams[b])[0]);
      for (std::size_t k = b; k < std::min(b + at_once, beams.size()); ++k)
        for (const int element : ends(beams[k]))
          if (owns(element)) reach = std::max(reach, element - lacking);
    }
    return reach;
  }

  void find_ghosts_and_specials() {
    std::vector<int> ghost, special;
    const auto see = [&](int beam, bool extra) {
      const auto& e = ends(beam);
      if (!owns(e[0]) && !owns(e[1])) return;
      for (const int element : e) {
        if (!owns(element))
          ghost.push_back(element);
        else if (extra)
          special.push_back(element);
      }
    };
    for (const int b : halo_) see(b, false);
    for (const int b : own_) see(b, false);
    for (const fracture::Crossing& c : s_.met) see(c.beam, true);
    for (const lattice::DampedBeam& d : s_.damped)
      for (const auto& [element, other] : {std::pair{d.i, d.j}, std::pair{d.j, d.i}}) {
        if (owns(element))
          special.push_back(element);
        else if (owns(other))
          ghost.push_back(element);
      }
    const auto sort_unique = [](std::vector<int>& v) {
      std::sort(v.begin(), v.end());
      v.erase(std::unique(v.begin(), v.end()), v.end());
    };
    sort_unique(ghost), sort_unique(special);
    rows_.ghost = ghost;
    rows_.special.assign(special.begin(), special.end());
  }

  std::int32_t row(int element) const {
    if (owns(element)) return element;
    const auto at = std::lower_bound(rows_.ghost.begin(), rows_.ghost.end(), element);
    return rows_.first_ghost_row + static_cast<std::int32_t>(at - rows_.ghost.begin());
  }

  std::int32_t extra(int element) const {
    if (!owns(element)) return -1;
    const auto at = std::lower_bound(rows_.special.begin(), rows_.special.end(), element);
    return static_cast<std::int32_t>(at - rows_.special.begin());
  }

  /// One past the ring is for forces on others' elements: nobody looks there.
  std::int32_t slot(int element) const {
    return owns(element) ? element & rows_.view.mask : rows_.view.mask + 1;
  }

  template <class Row, class CrossingRows>
  void make_rows(std::vector<Row>& rows, CrossingRows& crossing) {
    const auto add = [&](int b) {
      Row r{row(ends(b)[1]), slot(ends(b)[1]), {}};
      set_form(r.form, s_, b);
      rows.push_back(r);
    };
    for (const int b : halo_) rows_.halo_i.push_back(row(ends(b)[0])), add(b);
    rows_.first.assign(end_ - begin_ + 1, 0);
    for (const int b : own_) ++rows_.first[ends(b)[0] - begin_ + 1], add(b);
    std::partial_sum(rows_.first.begin(), rows_.first.end(), rows_.first.begin());
    for (int k = 0; k < static_cast<int>(s_.met.size()); ++k) {
      const auto& [i, j] = ends(s_.met[k].beam);
      if (!owns(i) && !owns(j)) continue;
      auto& c = crossing.emplace_back();
      c.k = k, c.i = row(i), c.j = row(j), c.extra_i = extra(i), c.extra_j = extra(j);
      set_form(c.form, s_, s_.met[k].beam);
      if (s_.notched[k] || s_.kinematics == lattice::Kinematics::corotational) continue;
      const lattice::BeamLoads base =
          lattice::loads_of(s_.lattice.beam[s_.met[k].beam], s_.base[i], s_.base[j]);
      for (int a = 0; a < 3; ++a) {
        c.base[a] = static_cast<Real>(base.force_i[a]);
        c.base[3 + a] = static_cast<Real>(base.moment_i[a]);
        c.base[6 + a] = static_cast<Real>(base.moment_j[a]);
      }
    }
  }

  /// A notch is a cut of some width: its faces do not touch.
  template <class ContactRows>
  void make_contacts(ContactRows& contacts) {
    for (int k = 0; k < static_cast<int>(s_.normal.size()); ++k) {
      const int beam = s_.met[k].beam;
      const auto& [i, j] = ends(beam);
      if (s_.notched[k] || (!owns(i) && !owns(j))) continue;
      auto& c = contacts.emplace_back();
      c.k = k, c.i = row(i), c.j = row(j), c.extra_i = extra(i), c.extra_j = extra(j);
      set_form(c.form, s_, beam);
      for (int a = 0; a < 2; ++a) c.normal[a] = static_cast<Real>(s_.normal[k][a]);
      if (s_.kinematics == lattice::Kinematics::corotational) continue;
      const Eigen::Vector3d base = fracture::face_gap(s_.lattice.beam[beam], s_.base[i], s_.base[j]);
      for (int a = 0; a < 3; ++a) c.gap[a] = static_cast<Real>(base[a]);
    }
  }

  template <class Rows, class Groups>
  void make_groups(const Rows& rows, Groups& groups) {
    using Group = typename Groups::value_type;
    constexpr int numbers = sizeof(Group::number) / sizeof(Group::number[0]);
    std::vector<int> beams(halo_);
    beams.insert(beams.end(), own_.begin(), own_.end());
    for (std::size_t b = 0; b < beams.size(); b += group_size) {
      Group g{};
      for (std::size_t k = 0; k < group_size; ++k) {
        // What is missing of the last four is the last beam again, without stiffness.
        const std::size_t at = std::min(b + k, beams.size() - 1);
        const bool missing = b + k >= beams.size();
        const auto& [i, j] = ends(beams[at]);
        g.i[k] = row(i), g.j[k] = row(j);
        g.slot_i[k] = missing ? rows_.view.mask + 1 : slot(i),
        g.slot_j[k] = missing ? rows_.view.mask + 1 : slot(j);
        const Real* number = reinterpret_cast<const Real*>(&rows[at].form);
        for (int a = 0; a < numbers; ++a) g.number[a][k] = missing && a >= numbers - 3 ? Real(0) : number[a];
      }
      const std::size_t next = b + group_size;
      g.complete = next < beams.size() ? std::max(begin_, std::min(end_, ends(beams[next])[0])) : end_;
      groups.push_back(g);
    }
    if (groups.empty()) {  // elements without sound beams still move
      Group g{};
      for (int k = 0; k < group_size; ++k)
        g.i[k] = g.j[k] = begin_, g.slot_i[k] = g.slot_j[k] = rows_.view.mask + 1,
        g.number[0][k] = g.number[3][k] = 1;
      g.complete = end_;
      groups.push_back(g);
    }
  }

  void make_damped() {
    for (const lattice::DampedBeam& d : s_.damped) {
      if (!owns(d.i) && !owns(d.j)) continue;
      rows_.damped.push_back({row(d.i), row(d.j), extra(d.i), extra(d.j), d.crossing, d.at_surface ? 1 : 0,
                              static_cast<Real>(d.axis.x()), static_cast<Real>(d.axis.y()),
                              static_cast<Real>(d.axis.z()), static_cast<Real>(d.axial),
                              static_cast<Real>(d.twist), static_cast<Real>(d.bend)});
    }
  }

  void make_room() {
    const std::size_t row = 6UL * lanes_, specials = rows_.special.size();
    rows_.ring.assign((rows_.view.mask + 2) * row, 0);
    rows_.extra.assign(specials * row, 0);
    if (!s_.damped.empty()) rows_.damping = rows_.damping_before = rows_.extra;
    if (!s_.normal.empty()) rows_.contact = rows_.contact_before = rows_.extra;
    const std::size_t chunks = (end_ - begin_ + chunk_size - 1) / chunk_size;
    rows_.account.assign(chunks * accounts * lanes_, 0.0);
  }

  const RowSource& s_;
  const int begin_, end_, lanes_;
  std::vector<int> halo_, own_;  // sound beams
  PartRows<Real> rows_;
};

}  // namespace

std::vector<int> cut_evenly(const lattice::Lattice& lattice, int parts) {
  const int n = static_cast<int>(lattice.centre.size());
  const int chunks = std::max(1, (n + chunk_size - 1) / chunk_size);
  std::vector<double> work(chunks, 0.0);
  for (int i = 0; i < n; ++i) work[i / chunk_size] += 1.0;
  for (const auto& [i, j] : lattice.ends) work[i / chunk_size] += 1.0;
  std::partial_sum(work.begin(), work.end(), work.begin());
  parts = std::min(parts, chunks);
  std::vector<int> begin{0};
  for (int p = 1; p < parts; ++p) {
    const double share = work.back() * p / parts;
    int chunk = 0;
    while (chunk < chunks - 1 && work[chunk] < share - 0.5 * (work[chunk] - (chunk ? work[chunk - 1] : 0.0)))
      ++chunk;
    begin.push_back(
        std::clamp((chunk + 1) * chunk_size, begin.back() + chunk_size, (chunks - parts + p) * chunk_size));
  }
  begin.push_back(n);
  return begin;
}

template <class Real>
PartRows<Real> rows_of_part(const RowSource& source, int begin, int end, int first_ghost_row, int lanes) {
  return Maker<Real>(source, begin, end, first_ghost_row, lanes).make();
}

template PartRows<double> rows_of_part<double>(const RowSource&, int, int, int, int);
template PartRows<float> rows_of_part<float>(const RowSource&, int, int, int, int);

}  // namespace rift::ensemble
