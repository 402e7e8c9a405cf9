#include "engine/ensemble/part_rows.hpp"

#include "engine/ensemble/group_rows.hpp"
#include "engine/ensemble/watched_beams.hpp"
#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <numeric>
#include <type_traits>
#include <utility>

namespace rift::ensemble {
namespace {

/// Beams that nothing damages, or all but the absent ones where beams break by themselves; by their first
/// element, then by their second.
std::vector<int> intact_beams(const RowSource& s) {
  std::vector<char> damageable(s.lattice.beam.size(), 0);
  for (const fracture::DamageableBeam& d : s.damageable) damageable[d.beam] = d.absent || !s.options.breaking;
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
        lanes_(s.lanes),
        breaking_(s.options.breaking),
        kernel_(kernel_for<Beam>(s.options.instructions, s.lanes, s.options.breaking)) {
    first_ghost_row = first_row;
    strained_ =
        std::any_of(s.base.begin(), s.base.end(), [](const lattice::Vector6& q) { return !q.isZero(0.0); });
    choose_intact(s);
    find_ghosts_and_extras(s);
    make_intact(s);
    make_damageable(s);
    make_loaded(s);
    if (s.options.contact) make_contacts(s);
    if (s.lanes == 1) make_groups(s);
    if (breaking_) make_breaking(s);
    make_damped(s);
    make_room(s);
  }

  void find_means(StateArrays& state, const StepConstants& constants) override {
    if (kernel_.find_means) kernel_.find_means(view_of(state), constants);
  }

  void add_beam_energies(StateArrays& state, const StepConstants& constants) override {
    BeamView<Beam> view = view_of(state);
    view.velocity = state.velocity.data();
    if (kernel_.add_beam_energies) kernel_.add_beam_energies(view, constants);
  }

  void advance(StateArrays& state, const StepConstants& constants) override {
    (constants.balanced ? kernel_.advance_with_balance : kernel_.advance)(view_of(state), constants);
  }

  void evaluate_energies(StateArrays& state, const StepConstants& constants, double* velocities) override {
    next_damping_before.resize(damping_before.size());
    next_contact_before.resize(contact_before.size());
    BeamView<Beam> view = view_of(state);
    view.velocity = velocities;
    view.next_q = state.next_q.data<Real>(), view.next_v = state.next_v.data<Real>();
    view.next_rate = state.next_rate.data<Real>();
    view.next_damping_before = next_damping_before.data<Real>();
    view.next_contact_before = next_contact_before.data<Real>();
    kernel_.evaluate_energies(view, constants);
  }

  /// For one scenario the groups hold the stiffnesses that are left: no load more in the walk.
  void set_left(int k, int lane, double left, double watch_above) override {
    const std::int32_t place = watched_.place_of(k);
    if (place < 0) return;
    watched_.set(place, lane, left, watch_above);
    if (lanes_ == 1) {
      const BeamStiffness<Real>& whole = intact_[place].form.stiffness;
      const auto s = static_cast<Real>(left);
      groups_.set_stiffness(place, {whole.axial * s, whole.bending * s, whole.twist * s});
    }
    if (left == 1.0 || row_of_.empty()) return;
    const auto at = std::lower_bound(softened_.begin(), softened_.end(), row_of_[k]);
    if (at == softened_.end() || *at != row_of_[k]) softened_.insert(at, row_of_[k]);
  }

  void add_watched(int lane, std::vector<int>& k) const override { watched_.add_noted(lane, halo_, k); }

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
    const std::size_t at_once = s.lanes == 1 ? kernel_.group_size : 1;
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
    const auto see = [&](int i, int j, std::vector<std::int32_t>* loaded) {
      for (const auto& [element, other] : {std::pair{i, j}, std::pair{j, i}}) {
        if (owns(element) && loaded)
          loaded->push_back(element);
        else if (!owns(element) && owns(other))
          ghost.push_back(element);
      }
    };
    for (const int b : beams_) see(s.lattice.ends[b][0], s.lattice.ends[b][1], nullptr);
    for (const fracture::DamageableBeam& d : s.damageable)
      if (!breaking_ || strained_) see(s.lattice.ends[d.beam][0], s.lattice.ends[d.beam][1], &extra_element);
    for (const lattice::DampedBeam& d : s.damped) see(d.i, d.j, &damped_element);
    for (int i = begin_; i < end_ && !s.outside.empty(); ++i)
      if (!s.outside[i].isZero(0.0)) extra_element.push_back(i);
    for (auto* list : {&ghost, &extra_element, &damped_element}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
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

  /// Of beams that break by themselves nothing but the loads of a strained base state.
  void make_damageable(const RowSource& s) {
    if (breaking_ && !strained_) return;
    row_of_.assign(breaking_ ? s.damageable.size() : 0, -1);
    for (int k = 0; k < static_cast<int>(s.damageable.size()); ++k) {
      if (breaking_ && s.damageable[k].absent) continue;
      DamageableRow<Beam>* r = add_row(damageable_, s, k);
      if (r && breaking_) row_of_[k] = static_cast<std::int32_t>(damageable_.size()) - 1;
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

  void make_loaded(const RowSource& s) {
    for (int i = begin_; i < end_ && !s.outside.empty(); ++i) {
      if (s.outside[i].isZero(0.0)) continue;
      LoadedRow<Real>& row = loaded_.emplace_back();
      row.extra = extra(i);
      for (int c = 0; c < 6; ++c) row.load[c] = static_cast<Real>(s.outside[i][c]);
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
    std::vector<BeamPlaces> places;
    for (const int beam : beams_) {
      const auto& [i, j] = s.lattice.ends[beam];
      places.push_back({row(i), row(j), slot(i), slot(j), i});
    }
    groups_.make(kernel_.group_size, intact_, places, mask_ + 1, begin_, end_);
  }

  void make_breaking(const RowSource& s) {
    std::vector<int> k_of_beam(s.lattice.beam.size(), -1);
    for (int k = 0; k < static_cast<int>(s.damageable.size()); ++k) k_of_beam[s.damageable[k].beam] = k;
    std::vector<std::int32_t> k_of_place;
    for (const int beam : beams_) k_of_place.push_back(k_of_beam[beam]);
    watched_.make(std::move(k_of_place), s.damageable.size(), lanes_, lanes_ == 1 ? kernel_.group_size : 0);
  }

  /// The place of an intact beam among the part's.
  std::size_t place_of(const RowSource& s, int i, int j) const {
    const auto first = beams_.begin() + static_cast<std::ptrdiff_t>(owns(i) ? halo_ : 0),
               last = owns(i) ? beams_.end() : beams_.begin() + static_cast<std::ptrdiff_t>(halo_);
    const auto at = std::lower_bound(first, last, std::array{i, j},
                                     [&](int b, const auto& ends) { return s.lattice.ends[b] < ends; });
    assert(at != last && s.lattice.ends[*at] == (std::array{i, j}));
    return at - beams_.begin();
  }

  void make_damped(const RowSource& s) {
    if (s.damped.empty()) return;
    dampers_.assign(beams_.size(), {0, 0, 0, -1});
    for (const lattice::DampedBeam& d : s.damped) {
      if (!owns(d.i) && !owns(d.j)) continue;
      const auto axial = static_cast<Real>(d.axial), twist = static_cast<Real>(d.twist),
                 bend = static_cast<Real>(d.bend);
      if (d.crossing < 0)
        dampers_[place_of(s, d.i, d.j)] = {axial, twist, bend, d.at_surface ? 1 : 0};
      else
        damped_.push_back({row(d.i), row(d.j), extra(d.i), extra(d.j), d.crossing, d.at_surface ? 1 : 0,
                           static_cast<Real>(d.axis.x()), static_cast<Real>(d.axis.y()),
                           static_cast<Real>(d.axis.z()), axial, twist, bend});
    }
    if (s.lanes == 1) groups_.make_dampers(dampers_);
  }

  void make_room(const RowSource& s) {
    const std::size_t row = 6UL * s.lanes, extras = extra_element.size() * row;
    const std::size_t ring = (mask_ + 2) * (s.lanes == 1 ? BeamGroup::ring_row : row);
    ring_.assign(ring, 0);
    extra_.assign(extras, 0);
    if (!s.damped.empty()) {
      damping_ring_ = ring_, damping_ = extra_;
      damping_before.resize(damped_element.size() * row);
    }
    if (s.options.contact) contact_ = extra_, contact_before.resize(extras);
    const std::size_t chunks = (end_ - begin_ + chunk_size - 1) / chunk_size;
    account.assign(chunks * accounts * s.lanes, 0.0);
    beams_ = {};
  }

  BeamView<Beam> view_of(StateArrays& state) {
    const auto count = [](const auto& rows) { return static_cast<std::int32_t>(rows.size()); };
    BeamView<Beam> w{};
    w.begin = begin_, w.end = end_;
    w.q = w.next_q = state.q.data<Real>(), w.v = w.next_v = state.v.data<Real>();
    w.rate = w.next_rate = state.rate.data<Real>();
    w.mean_q = state.mean_q.data<Real>();
    w.ring = ring_.data(), w.mask = mask_;
    w.per_mass = state.per_mass.data<Real>(), w.mass = state.mass.data();
    w.top = state.top.data(), w.base = state.base.data();
    w.extras = count(extra_element), w.extra_element = extra_element.data(), w.extra = extra_.data();
    w.contact = contact_.data();
    w.contact_before = w.next_contact_before = contact_before.data<Real>();
    w.loaded_elements = count(loaded_), w.loaded = loaded_.data(), w.load = state.load.data<Real>();
    w.factor = state.factor.data<Real>();
    w.slip = state.slip.data<Real>(), w.slip_after = state.slip_after.data<Real>();
    w.in_contact = state.in_contact.data<Real>(), w.friction = state.friction.data<Real>();
    w.damped_elements = count(damped_element), w.damped_element = damped_element.data();
    w.damping_ring = damping_ring_.data(), w.dampers = dampers_.data();
    w.damping_before = w.next_damping_before = damping_before.data<Real>();
    w.damped_beams = count(damped_), w.damped = damped_.data(), w.damping = damping_.data();
    w.alpha_at_surface = state.alpha_at_surface.data<Real>();
    w.alpha_elsewhere = state.alpha_elsewhere.data<Real>();
    watched_.show(w);
    w.account = account.data();
    w.halo = count(halo_i_), w.halo_i = halo_i_.data(), w.first = first_.data(), w.intact = intact_.data();
    groups_.show(w);
    w.damageable_beams = count(damageable_), w.damageable = damageable_.data();
    w.softened_beams = count(softened_), w.softened = softened_.data();
    w.contacts = count(contact_row_), w.contact_row = contact_row_.data();
    return w;
  }

  const int begin_, end_, lanes_;
  const bool breaking_;
  bool strained_ = false;  // whether the base state is
  const Kernel<Beam> kernel_;
  std::vector<int> beams_;  // intact ones, while the rows are made
  std::size_t halo_ = 0;    // of them
  std::int32_t mask_ = 0;
  std::vector<std::int32_t> halo_i_, first_;
  std::vector<IntactRow<Beam>> intact_;
  GroupRows<Beam> groups_;              // of one scenario alone
  std::vector<Dampers<Real>> dampers_;  // of the intact beams; none where nothing is damped
  std::vector<DamageableRow<Beam>> damageable_;
  std::vector<LoadedRow<Real>> loaded_;
  std::vector<ContactRow<Beam>> contact_row_;
  std::vector<DampedRow<Real>> damped_;
  // Where beams break by themselves:
  WatchedBeams<Real> watched_;
  std::vector<std::int32_t> row_of_;    // of a damageable beam, or -1; none without a strained base state
  std::vector<std::int32_t> softened_;  // of damageable_, ascending: less than all was left of them
  AlignedVector<Real> ring_, damping_ring_, extra_, damping_, contact_;  // null where empty
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
