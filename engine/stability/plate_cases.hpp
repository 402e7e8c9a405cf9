#pragma once

#include "engine/stability/cracked_plate.hpp"
#include "engine/stability/suite.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// What the families share that pack, pull and crack a plate as any run does.
namespace rift::stability {

using Words = std::vector<std::string>;
using Claims = std::vector<Claim>;
using Expectation = std::function<Claims(const Observed&, ensemble::Precision)>;
using Memory = std::shared_ptr<CachedRun>;

/// What is the same but for rounding: 1e-12 in double; in single precision as far as its ratios are known.
inline double rounding(ensemble::Precision precision) {
  return precision == ensemble::Precision::double_precision ? 1e-12 : single_ratio_tolerance;
}

/// A crack of the suite's plate that others are compared with, too.
inline Memory plate(Words overrides, SceneChange scene = {}, PlateChange change = {}) {
  return std::make_shared<CachedRun>([overrides = std::move(overrides), scene = std::move(scene),
                                      change = std::move(change)](ensemble::Precision precision) {
    return crack(overrides, scene, change, precision);
  });
}

/// Adds a case that ends as any run does, and must show what its claims say.
inline void add(Cases& cases, const char* family, std::string name, Memory seen, Expectation claims) {
  cases.push_back(
      {.family = family,
       .name = std::move(name),
       .run = [seen = std::move(seen)](ensemble::Precision precision) { return seen->of(precision); },
       .claims = std::move(claims)});
}

/// Adds a case that must end otherwise. @param[in] names  what its message must name
inline void add(Cases& cases, const char* family, std::string name, CaseEnd expected, std::string names,
                Words overrides, SceneChange scene = {}, PlateChange plate = {}) {
  cases.push_back(
      {.family = family,
       .name = std::move(name),
       .expected = expected,
       .names = std::move(names),
       .run = [overrides = std::move(overrides), scene = std::move(scene), plate = std::move(plate)](
                  ensemble::Precision precision) { return crack(overrides, scene, plate, precision); }});
}

/// A constant velocity of the crack, over c_R.
inline SceneChange at_velocity(double over_cr) {
  return [over_cr](scene::Scene& s) { s.crack.velocity = {{{over_cr, true}, {}}}; };
}

}  // namespace rift::stability
