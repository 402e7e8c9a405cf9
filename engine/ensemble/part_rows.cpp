#include "engine/ensemble/part_rows.hpp"

#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <type_traits>
#include <utility>

namespace rift::ensemble {
namespace {

/// Beams that nothing damages, by their first element, then by their second.
std::vector<int> intact_beams(const RowSource& s) {
  std::vector<char> damageable(s.lattice.beam.size(), 0);
  for (const fracture::DamageableBeam& d : s.damageable) damageable[d.beam] = 1;
  std::vector<int> intact;
  for (int b = 0; b < static_cast<int>(damageable.size()); ++b)
    if (!damageable[b]) intact.push_back(b);
  std::stable_sort(intact.begin(), intact.end(),
                   [&](int a, int b) { return s.lattice.ends[a] < s.lattice.ends[b]; });
  return intact;
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

/// The rows of one part, which owns [begin, end), and their kernels.
template <class Beam>
class PartOf final : public Part {
  using Real = typename Beam::Number;
  static constexpr bool linear = std::is_same_v<Beam, LinearBeam<Real>>;

 public:
  PartOf(const RowSource& s, int begin, int end, int first_row)
      : Part(s.options.precision),
        begin_(begin),
        end_(end),
        kernel_(kernel_for<Beam>(s.options.instructions, s.lanes)) {
    first_ghost_row = first_row;
    choose_intact(s);
    find_ghosts_and_extras(s);
    make_intact(s);
    make_damageable(s);
    if (s.options.contact) make_contacts(s);
    if (s.lanes == 1) make_groups(s);
    make_damped(s);
    make_room(s);
  }

  void advance(StateArrays& state, const StepConstants& constants, bool balanced) override {
    (balanced ? kernel_.advance_with_balance : kernel_.advance)(view_of(state), constants);
  }

  void evaluate_energies(StateArrays& state, const StepConstants& constants, double* velocities) override {
    BeamView<Beam> view = view_of(state);
    view.velocity = velocities;
    view.slip_after = nullptr;
    kernel_.evaluate_energies(view, constants);
  }

 private:
  bool owns(int element) const { return element >= begin_ && element < end_; }

  /// Halo beams first, then the part's own.
  void choose_intact(const RowSource& s) {
    std::vector<int> own;
    for (const int b : intact_beams(s)) {
      const auto& [i, j] = s.lattice.ends[b];
      if (owns(i) || owns(j)) (owns(i) ? own : beams_).push_back(b);
    }
    halo_ = beams_.size();
    beams_.insert(beams_.end(), own.begin(), own.end());
    mask_ = static_cast<std::int32_t>(std::bit_ceil(static_cast<unsigned>(longest_reach(s)) + 1U)) - 1;
  }

  /// How far beyond the first element that still lacks forces the walk reaches: no two of those may share a
  /// slot.
  int longest_reach(const RowSource& s) const {
    const std::size_t at_once = s.lanes == 1 ? group_size : 1;
    int reach = 0;
    for (std::size_t b = 0; b < beams_.size(); b += at_once) {
      const int lacking = std::max(begin_, s.lattice.ends[beams_[b]][0]);
      for (std::size_t k = b; k < std::min(b + at_once, beams_.size()); ++k)
        for (const int element : s.lattice.ends[beams_[k]])
          if (owns(element)) reach = std::max(reach, element - lacking);
    }
    return reach;
  }

  void find_ghosts_and_extras(const RowSource& s) {
    std::vector<int> extra;
    const auto see = [&](int i, int j, bool loads) {
      for (const auto& [element, other] : {std::pair{i, j}, std::pair{j, i}}) {
        if (owns(element) && loads)
          extra.push_back(element);
        else if (!owns(element) && owns(other))
          ghost.push_back(element);
      }
    };
    for (const int b : beams_) see(s.lattice.ends[b][0], s.lattice.ends[b][1], false);
    for (const fracture::DamageableBeam& d : s.damageable)
      see(s.lattice.ends[d.beam][0], s.lattice.ends[d.beam][1], true);
    for (const lattice::DampedBeam& d : s.damped) see(d.i, d.j, true);
    for (std::vector<int>* list : {&ghost, &extra}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    extra_element.assign(extra.begin(), extra.end());
  }

  std::int32_t row(int element) const {
    if (owns(element)) return element;
    const auto at = std::lower_bound(ghost.begin(), ghost.end(), element);
    return first_ghost_row + static_cast<std::int32_t>(at - ghost.begin());
  }

  std::int32_t extra(int element) const {
    if (!owns(element)) return -1;
    const auto at = std::lower_bound(extra_element.begin(), extra_element.end(), element);
    return static_cast<std::int32_t>(at - extra_element.begin());
  }

  /// One past the ring is for forces on others' elements: nobody looks there.
  std::int32_t slot(int element) const { return owns(element) ? element & mask_ : mask_ + 1; }

  void make_intact(const RowSource& s) {
    first_.assign(end_ - begin_ + 1, 0);
    for (std::size_t b = 0; b < beams_.size(); ++b) {
      const auto& [i, j] = s.lattice.ends[beams_[b]];
      if (b < halo_)
        halo_i_.push_back(row(i));
      else
        ++first_[i - begin_ + 1];
      intact_.push_back({row(j), slot(j), {}});
      set_form(intact_.back().form, s, beams_[b]);
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  /// Appends the row of a damageable beam whose element is the part's; none where neither is.
  template <class Row>
  Row* add_row(std::vector<Row>& rows, const RowSource& s, int k) const {
    const auto& [i, j] = s.lattice.ends[s.damageable[k].beam];
    if (!owns(i) && !owns(j)) return nullptr;
    Row& r = rows.emplace_back();
    r.k = k, r.i = row(i), r.j = row(j), r.extra_i = extra(i), r.extra_j = extra(j);
    set_form(r.form, s, s.damageable[k].beam);
    return &r;
  }

  void make_damageable(const RowSource& s) {
    for (int k = 0; k < static_cast<int>(s.damageable.size()); ++k) {
      DamageableRow<Beam>* r = add_row(damageable_, s, k);
      if (!r || s.damageable[k].absent || !linear) continue;
      const int beam = s.damageable[k].beam;
      const auto& [i, j] = s.lattice.ends[beam];
      const lattice::BeamLoads base = lattice::loads_of(s.lattice.beam[beam], s.base[i], s.base[j]);
      for (int a = 0; a < 3; ++a) {
        r->base[a] = static_cast<Real>(base.force_i[a]);
        r->base[3 + a] = static_cast<Real>(base.moment_i[a]);
        r->base[6 + a] = static_cast<Real>(base.moment_j[a]);
      }
    }
  }

  /// A notch is a cut of some width: its faces do not touch.
  void make_contacts(const RowSource& s) {
    for (int k = 0; k < static_cast<int>(s.damageable.size()); ++k) {
      if (s.damageable[k].absent) continue;
      ContactRow<Beam>* r = add_row(contact_row_, s, k);
      if (!r) continue;
      for (int a = 0; a < 2; ++a) r->normal[a] = static_cast<Real>(s.damageable[k].normal[a]);
      if (!linear) continue;
      const int beam = s.damageable[k].beam;
      const auto& [i, j] = s.lattice.ends[beam];
      const Eigen::Vector3d base = fracture::face_gap(s.lattice.beam[beam], s.base[i], s.base[j]);
      for (int a = 0; a < 3; ++a) r->gap[a] = static_cast<Real>(base[a]);
    }
  }

  void make_groups(const RowSource& s) {
    constexpr int numbers = beam_numbers<Beam>;
    for (std::size_t b = 0; b < beams_.size(); b += group_size) {
      BeamGroup<Beam> g{};
      for (std::size_t k = 0; k < group_size; ++k) {
        // What is missing of the last four is the last beam again, without stiffness.
        const std::size_t at = std::min(b + k, beams_.size() - 1);
        const bool missing = b + k >= beams_.size();
        const auto& [i, j] = s.lattice.ends[beams_[at]];
        g.i[k] = row(i), g.j[k] = row(j);
        g.slot_i[k] = missing ? mask_ + 1 : slot(i), g.slot_j[k] = missing ? mask_ + 1 : slot(j);
        const Real* number = reinterpret_cast<const Real*>(&intact_[at].form);
        for (int a = 0; a < numbers; ++a) g.number[a][k] = missing && a >= numbers - 3 ? Real(0) : number[a];
      }
      const std::size_t next = b + group_size;
      g.complete = next < beams_.size() ? std::clamp(s.lattice.ends[beams_[next]][0], begin_, end_) : end_;
      group_.push_back(g);
    }
    if (!group_.empty()) return;
    BeamGroup<Beam> g{};  // elements without intact beams still move
    for (int k = 0; k < group_size; ++k)
      g.i[k] = g.j[k] = begin_, g.slot_i[k] = g.slot_j[k] = mask_ + 1, g.number[0][k] = g.number[3][k] = 1;
    g.complete = end_;
    group_.push_back(g);
  }

  void make_damped(const RowSource& s) {
    for (const lattice::DampedBeam& d : s.damped) {
      if (!owns(d.i) && !owns(d.j)) continue;
      damped_.push_back({row(d.i), row(d.j), extra(d.i), extra(d.j), d.crossing, d.at_surface ? 1 : 0,
                         static_cast<Real>(d.axis.x()), static_cast<Real>(d.axis.y()),
                         static_cast<Real>(d.axis.z()), static_cast<Real>(d.axial),
                         static_cast<Real>(d.twist), static_cast<Real>(d.bend)});
    }
  }

  void make_room(const RowSource& s) {
    const std::size_t row = 6UL * s.lanes, extras = extra_element.size() * row;
    ring_.assign((mask_ + 2) * row, 0);
    extra_.assign(extras, 0);
    if (!s.damped.empty()) damping_ = extra_, damping_before.resize(extras);
    if (s.options.contact) contact_ = extra_, contact_before.resize(extras);
    const std::size_t chunks = (end_ - begin_ + chunk_size - 1) / chunk_size;
    account.assign(chunks * accounts * s.lanes, 0.0);
    beams_ = {};
  }

  BeamView<Beam> view_of(StateArrays& state) {
    const auto count = [](const auto& rows) { return static_cast<std::int32_t>(rows.size()); };
    BeamView<Beam> w{};
    w.begin = begin_, w.end = end_;
    w.q = state.q.data<Real>(), w.v = state.v.data<Real>(), w.rate = state.rate.data<Real>();
    w.ring = ring_.data(), w.mask = mask_;
    w.per_mass = state.per_mass.data<Real>(), w.mass = state.mass.data();
    w.top = state.top.data(), w.base = state.base.data();
    w.extras = count(extra_element), w.extra_element = extra_element.data(), w.extra = extra_.data();
    w.damping = damping_.data(), w.damping_before = damping_before.data<Real>();
    w.contact = contact_.data(), w.contact_before = contact_before.data<Real>();
    w.factor = state.factor.data<Real>();
    w.slip = state.slip.data<Real>(), w.slip_after = state.slip_after.data<Real>();
    w.in_contact = state.in_contact.data<Real>(), w.friction = state.friction.data<Real>();
    w.damped_beams = count(damped_), w.damped = damped_.data();
    w.alpha_at_surface = state.alpha_at_surface.data<Real>();
    w.alpha_elsewhere = state.alpha_elsewhere.data<Real>();
    w.account = account.data();
    w.halo = count(halo_i_), w.halo_i = halo_i_.data(), w.first = first_.data(), w.intact = intact_.data();
    w.groups = count(group_), w.group = group_.data();
    w.damageable_beams = count(damageable_), w.damageable = damageable_.data();
    w.contacts = count(contact_row_), w.contact_row = contact_row_.data();
    return w;
  }

  const int begin_, end_;
  const Kernel<Beam> kernel_;
  std::vector<int> beams_;  // intact ones, while the rows are made
  std::size_t halo_ = 0;    // of them
  std::int32_t mask_ = 0;
  std::vector<std::int32_t> halo_i_, first_;
  std::vector<IntactRow<Beam>> intact_;
  AlignedVector<BeamGroup<Beam>> group_;
  std::vector<DamageableRow<Beam>> damageable_;
  std::vector<ContactRow<Beam>> contact_row_;
  std::vector<DampedRow<Real>> damped_;
  AlignedVector<Real> ring_, extra_, damping_, contact_;  // null where empty
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

std::unique_ptr<Part> make_part(const RowSource& source, int begin, int end, int first_ghost_row) {
  const auto make = [&]<class Beam>(Beam) -> std::unique_ptr<Part> {
    return std::make_unique<PartOf<Beam>>(source, begin, end, first_ghost_row);
  };
  const bool in_double = source.options.precision == Precision::double_precision;
  if (source.options.kinematics == lattice::Kinematics::linear)
    return in_double ? make(LinearBeam<double>{}) : make(LinearBeam<float>{});
  return in_double ? make(CorotationalBeam<double>{}) : make(CorotationalBeam<float>{});
}

}  // namespace rift::ensemble
