#pragma once

#include "engine/ensemble/instruction_set.hpp"
#include "engine/lattice/lattice.hpp"

#include <string>
#include <vector>

namespace rift::ensemble {

/// A plate of two layers, five times as long as high, in columns across it, with three beams an element: the
/// shape of the lattice that a run marches on, without the wait for a packing. All in SI, of the paper's
/// material.
lattice::Lattice bench_lattice(int elements);

/// What this machine can do at most, measured now with the same threads.
struct MachinePeaks {
  double memory_bytes_per_s =
      0;  // a[k] = b[k] + s c[k] over arrays beyond any cache, as the loop's data flow
  double flops_double = 0, flops_single = 0;  // multiply-adds in registers
};
MachinePeaks machine_peaks(InstructionSet instructions, int threads);

/// One thing to time.
struct BenchCase {
  std::string name;
  lattice::Kinematics kinematics = lattice::Kinematics::linear;
  Precision precision = Precision::double_precision;
  int scenarios = 1, threads = 1, elements = 20000;
  InstructionSet instructions = InstructionSet::baseline;
  bool plain = false;  // the readable step (reference::PlainSimulation): what the others are measured against
  double damped = 0;   // share of the beams that are damped
  double beta = 1;
  bool balanced = false;        // with a look at the energies after every step
  bool law = false;             // every beam has a cohesive law and is far below its strength
  bool processor_time = false;  // counted, of all threads, in place of the time that passes
};

/// How fast it went: whole steps with integration.
struct BenchResult {
  BenchCase of;
  std::size_t beams = 0;
  double step_s = 0;                              // median
  std::vector<double> beam_steps_per_s;           // of each run, ascending
  double element_steps_per_s = 0;                 // median
  double bytes_per_beam = 0, flops_per_beam = 0;  // a beam and a lane: compulsory traffic, arithmetic
  double median() const { return beam_steps_per_s[beam_steps_per_s.size() / 2]; }
};

/// @param[in] runs  each of at least `seconds`
BenchResult time_case(const BenchCase& bench, int runs, double seconds);

/// Times kernels of one number of elements by turns, so that whatever else the machine does meets them alike.
/// @return of each case its speeds over that of the first one of the same round, ascending
std::vector<std::vector<double>> ratios_to_first(const std::vector<BenchCase>& cases, int rounds,
                                                 double seconds);

}  // namespace rift::ensemble
