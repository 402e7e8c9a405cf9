#include "engine/base/files.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/base/text.hpp"
#include "engine/ensemble/benchmark.hpp"
#include "engine/results/json_input.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/simulation/summary.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/text/table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

struct BenchOptions : SessionOptions {
  std::vector<int> elements{5000, 20000, 80000};
  int runs = 7;
  double seconds = 0.15;
  bool needs = false;
  std::string guard;  // file of recorded ratios
  bool record = false;
};

using Cases = std::vector<ensemble::BenchCase>;

ensemble::BenchCase base_case(int elements, int threads) {
  ensemble::BenchCase c;
  c.instructions = ensemble::instruction_set();
  c.elements = elements;
  c.threads = threads;
  return c;
}

/// For one size and number of threads: one scenario alone, and as many lanes as a register holds. Studies
/// march no more side by side, and kernels of more lanes are several times slower.
void add_kernels(Cases& cases, int elements, int threads) {
  const auto add = [&](const std::string& name, ensemble::Precision precision, int scenarios,
                       const auto& change) {
    ensemble::BenchCase c = base_case(elements, threads);
    c.name = name, c.precision = precision, c.scenarios = scenarios;
    change(c);
    cases.push_back(c);
  };
  using enum ensemble::Precision;
  const auto in_register = [](ensemble::Precision precision) {
    return ensemble::lanes_in_register(precision, ensemble::instruction_set());
  };
  for (const lattice::Kinematics kinematics :
       {lattice::Kinematics::linear, lattice::Kinematics::corotational})
    for (const ensemble::Precision precision : {double_precision, single_precision})
      for (const int lanes : {1, in_register(precision)})
        add(scene::word_of("solver.kinematics", kinematics), precision, lanes,
            [&](ensemble::BenchCase& c) { c.kinematics = kinematics; });
  const std::string linear = scene::word_of("solver.kinematics", lattice::Kinematics::linear);
  for (const auto& [precision, lanes] :
       {std::pair(double_precision, 1), std::pair(single_precision, in_register(single_precision))}) {
    add(linear + ", all beams damped", precision, lanes, [](ensemble::BenchCase& c) { c.damped = 1.0; });
    add(linear + ", energies every step", precision, lanes,
        [](ensemble::BenchCase& c) { c.balanced = true; });
    add(linear + ", cohesive law", precision, lanes, [](ensemble::BenchCase& c) { c.law = true; });
  }
}

Cases kernel_cases(const BenchOptions& options, int threads) {
  Cases cases;
  for (const int elements : options.elements) {
    ensemble::BenchCase plain = base_case(elements, 1);
    plain.name = "plain", plain.plain = true;
    cases.push_back(plain);
    for (const int t : {1, threads})
      if (t == 1 || threads > 1) add_kernels(cases, elements, t);
  }
  return cases;
}

/// What each piece costs when it is in: one scenario in double, and as many in single as a register holds.
Cases needs_cases(const BenchOptions& options, int threads) {
  Cases cases;
  const int elements = options.elements.front();
  for (const int scenarios :
       {1, ensemble::lanes_in_register(ensemble::Precision::single_precision, ensemble::instruction_set())}) {
    const auto add = [&](std::string name, const auto& change) {
      ensemble::BenchCase c = base_case(elements, threads);
      c.name = std::move(name), c.scenarios = scenarios;
      if (scenarios > 1) c.precision = ensemble::Precision::single_precision;
      change(c);
      cases.push_back(c);
    };
    add("bare", [](ensemble::BenchCase&) {});
    add("damping, 5 % of the beams", [](ensemble::BenchCase& c) { c.damped = 0.05; });
    add("damping, all beams", [](ensemble::BenchCase& c) { c.damped = 1.0; });
    add("numerical damping", [](ensemble::BenchCase& c) { c.beta = 0.9; });
    add("energies every step", [](ensemble::BenchCase& c) { c.balanced = true; });
    add("cohesive law", [](ensemble::BenchCase& c) { c.law = true; });
    add("corotational beams",
        [](ensemble::BenchCase& c) { c.kinematics = lattice::Kinematics::corotational; });
  }
  return cases;
}

/// All of them, or those before a stop.
std::vector<ensemble::BenchResult> time_all(const Cases& cases, const BenchOptions& options,
                                            Session& session) {
  std::vector<ensemble::BenchResult> results;
  // A lattice of 50,000 elements is made in about the time that it is timed.
  const auto cost_of = [](const ensemble::BenchCase& c) { return 1.0 + c.elements / 5e4; };
  double all = 0.0, done = 0.0;
  for (const ensemble::BenchCase& c : cases) all += cost_of(c);
  for (const ensemble::BenchCase& c : cases) {
    if (!session.progress("bench", done / all)) break;
    results.push_back(ensemble::time_case(c, options.runs, options.seconds));
    done += cost_of(c);
  }
  session.line.clear();
  return results;
}

double share_of_arithmetic(const ensemble::BenchResult& r, const ensemble::MachinePeaks& peaks) {
  const double peak =
      r.of.precision == ensemble::Precision::single_precision ? peaks.flops_single : peaks.flops_double;
  return r.median() * r.flops_per_beam / peak;
}

Json json_of(const ensemble::BenchResult& r, const ensemble::BenchResult& base,
             const ensemble::MachinePeaks& peaks) {
  return {{"kernel", r.of.name},
          {"kinematics", scene::word_of("solver.kinematics", r.of.kinematics)},
          {"precision", scene::word_of("solver.precision", r.of.precision)},
          {"scenarios", r.of.scenarios},
          {"threads", r.of.threads},
          {"elements", r.of.elements},
          {"beams", r.beams},
          {"simd", r.of.plain ? "none" : ensemble::name_of(r.of.instructions)},
          {"beam_steps_per_s", r.median()},
          {"beam_steps_per_s_least", r.beam_steps_per_s.front()},
          {"beam_steps_per_s_most", r.beam_steps_per_s.back()},
          {"element_steps_per_s", r.element_steps_per_s},
          {"step_s", r.step_s},
          {"ratio", r.median() / base.median()},
          {"bytes_per_beam", r.bytes_per_beam},
          {"flops_per_beam", r.flops_per_beam},
          {"share_of_memory", r.median() * r.bytes_per_beam / peaks.memory_bytes_per_s},
          {"share_of_arithmetic", share_of_arithmetic(r, peaks)}};
}

void print_peaks(const ensemble::MachinePeaks& peaks, int threads) {
  base::print("  {} thread{}: memory {:.1f} GB/s, arithmetic {:.0f} GFlop/s double, {:.0f} single\n", threads,
              threads > 1 ? "s" : "", 1e-9 * peaks.memory_bytes_per_s, 1e-9 * peaks.flops_double,
              1e-9 * peaks.flops_single);
}

std::vector<std::string> row_of(const ensemble::BenchResult& r, const ensemble::BenchResult& base,
                                const ensemble::MachinePeaks& peaks) {
  const auto percent = [](double share) { return fmt::format("{:.0f}", 100 * share); };
  return {r.of.name,
          scene::word_of("solver.precision", r.of.precision),
          fmt::format("{}", r.of.scenarios),
          fmt::format("{}", r.of.threads),
          fmt::format("{}", r.of.elements),
          fmt::format("{:.1f}", 1e-6 * r.median()),
          fmt::format("{:.0f}", 1e-6 * r.beam_steps_per_s.front()),
          fmt::format("{:.0f}", 1e-6 * r.beam_steps_per_s.back()),
          fmt::format("{:.1f}", 1e-6 * r.element_steps_per_s),
          fmt::format("{:.2f}", r.median() / base.median()),
          fmt::format("{:.0f}", r.bytes_per_beam),
          percent(r.median() * r.bytes_per_beam / peaks.memory_bytes_per_s),
          percent(share_of_arithmetic(r, peaks))};
}

/// What a row's ratio is against: the plain path on the same lattice, or the bare kernel of as many
/// scenarios.
const ensemble::BenchResult& base_of(const std::vector<ensemble::BenchResult>& all,
                                     const ensemble::BenchResult& r, bool needs) {
  return *std::find_if(all.begin(), all.end(), [&](const ensemble::BenchResult& b) {
    return needs ? b.of.name == "bare" && b.of.scenarios == r.of.scenarios
                 : b.of.plain && b.of.elements == r.of.elements;
  });
}

/// What single precision costs in accuracy: one scene marched in both, the quickstart's plate and crack.
struct PrecisionError {
  std::string kinematics;
  double ratio_double = 0, ratio_single = 0, residual_double = 0, residual_single = 0;
};

PrecisionError precision_error(const std::string& kinematics, int threads, const Session& session) {
  PrecisionError error{.kinematics = kinematics};
  for (const std::string precision : {"double", "single"}) {
    const scene::Preset preset = scene::read_preset_text(
        "", "bench",
        {"specimen.elements=5000", "specimen.length=0.1", "specimen.height=0.04", "output.frames=0",
         "output.samples=100", "solver.kinematics=" + kinematics, "solver.precision=" + precision});
    base::Cache cache = session.cache;
    const simulation::Prepared prepared = simulation::prepare(preset, cache);
    const simulation::RunResult result =
        simulation::march(prepared, {.go_on = [&](const simulation::Progress&) { return session.goes_on(); }},
                          {.threads = threads});
    if (result.outcome == simulation::Outcome::stopped) return error;
    const bool single = precision == "single";
    (single ? error.ratio_single : error.ratio_double) =
        simulation::rates_of(prepared, result).plateau.mean.ratio;
    (single ? error.residual_single : error.residual_double) = result.lane[0].worst_residual;
  }
  return error;
}

Json json_of(const PrecisionError& e) {
  return {{"kinematics", e.kinematics},
          {"ratio_double", e.ratio_double},
          {"ratio_single", e.ratio_single},
          {"error_single", e.ratio_single - e.ratio_double},
          {"ledger_residual_double", e.residual_double},
          {"ledger_residual_single", e.residual_single}};
}

void print_precision(const PrecisionError& e) {
  base::print(
      "  single against double, {}: ratio {:.5f} against {:.5f} ({:+.1e}), balance error {:.1e} against "
      "{:.1e}\n",
      e.kinematics, e.ratio_single, e.ratio_double, e.ratio_single - e.ratio_double, e.residual_single,
      e.residual_double);
}

/// The kernels of one thread, the readable step first, counted in processor time.
Cases guarded_cases(const BenchOptions& options) {
  Cases cases{base_case(options.elements.front(), 1)};
  cases.front().name = "plain", cases.front().plain = true;
  add_kernels(cases, options.elements.front(), 1);
  for (ensemble::BenchCase& c : cases) c.processor_time = true;
  return cases;
}

std::string name_of(const ensemble::BenchCase& c) {
  return fmt::format("{}, {}, {}", c.name, scene::word_of("solver.precision", c.precision),
                     base::counted(c.scenarios, "lane"));
}

/// Compares each kernel's ratio to the readable step, both timed by turns in this process, with the recorded
/// one of this processor and instruction set; or records the ratios. Exit 1 where one has lost more than a
/// fifth.
ExitCode guard(const BenchOptions& options) {
  constexpr double least = 0.8;
  const Cases cases = guarded_cases(options);
  const std::vector<std::vector<double>> ratios =
      ensemble::ratios_to_first(cases, options.runs, options.seconds);
  const std::string set =
      fmt::format("{}, {}", base::processor_text(), ensemble::name_of(ensemble::instruction_set()));
  Json file = options.record && !std::filesystem::exists(options.guard)
                  ? Json::object()
                  : results::read_json(base::read_whole_file(options.guard), options.guard);
  Table table{{"kernel", "ratio to plain", "recorded", "of it"}, {}};
  bool slower = false;
  for (std::size_t k = 1; k < cases.size(); ++k) {
    const std::string name = name_of(cases[k]);
    const double ratio = ratios[k][ratios[k].size() / 2];
    if (options.record) file[set][name] = std::round(100 * ratio) / 100;
    const double recorded = file.contains(set) ? file[set].value(name, 0.0) : 0.0;
    const double share = recorded > 0.0 ? ratio / recorded : 1.0;
    slower = slower || share < least;
    table.rows.push_back(
        {name, fmt::format("{:.2f}", ratio), recorded > 0.0 ? fmt::format("{:.2f}", recorded) : "-",
         recorded > 0.0 ? fmt::format("{:.2f}{}", share, share < least ? " slower" : "") : "-"});
  }
  if (options.record) base::write_whole_file(options.guard, base::json_text(file, 2) + "\n");
  base::print_text(heading(version_text(), false) + "\n" + plain_table(table, false));
  base::print("  {}, one thread, {} elements; medians of {}\n", set, cases.front().elements,
              base::counted(options.runs, "round"));
  if (!file.contains(set)) base::print("  nothing is recorded for this processor: nothing is compared\n");
  if (slower) base::message("rift bench: a kernel has lost more than a fifth of its speed against plain\n");
  return slower ? ExitCode::world_failed : ExitCode::done;
}

ExitCode bench(const BenchOptions& options) {
  if (!options.guard.empty()) return guard(options);
  const int threads = base::threads_or_all_cpus(options.threads);
  Session session("rift bench", options);
  const ensemble::MachinePeaks alone = ensemble::machine_peaks(ensemble::instruction_set(), 1),
                               together = ensemble::machine_peaks(ensemble::instruction_set(), threads);
  const auto peaks_of = [&](const ensemble::BenchResult& r) { return r.of.threads == 1 ? alone : together; };
  const std::vector<ensemble::BenchResult> results = time_all(
      options.needs ? needs_cases(options, threads) : kernel_cases(options, threads), options, session);
  std::vector<PrecisionError> errors;
  if (!options.needs)
    for (const char* kinematics : {"linear", "corotational"})
      if (session.goes_on()) errors.push_back(precision_error(kinematics, threads, session));
  if (!session.goes_on()) {
    session.message("stopped; no result was stored");
    return session.stopped();
  }
  Json precision = Json::array(), rows = Json::array();
  for (const PrecisionError& e : errors) precision.push_back(json_of(e));
  for (const ensemble::BenchResult& r : results)
    rows.push_back(json_of(r, base_of(results, r, options.needs), peaks_of(r)));
  const Json machine{{"threads", threads},
                     {"memory_bytes_per_s", together.memory_bytes_per_s},
                     {"flops_double", together.flops_double},
                     {"flops_single", together.flops_single},
                     {"simd", ensemble::name_of(ensemble::instruction_set())}};
  session.print_result(Json{{"machine", machine}, {"rows", rows}, {"precision", precision}}, [&] {
    base::print_text(heading(version_text(), session.color()) + "\n");
    print_peaks(alone, 1);
    if (threads > 1) print_peaks(together, threads);
    Table table{{"kernel", "precision", "L", "T", "N", "M beam-steps/s", "least", "most", "M element-steps/s",
                 options.needs ? "over bare" : "over plain", "B/beam", "memory %", "flops %"},
                {}};
    for (const ensemble::BenchResult& r : results)
      table.rows.push_back(row_of(r, base_of(results, r, options.needs), peaks_of(r)));
    base::print_text(plain_table(table, session.color()));
    base::print(
        "  L scenarios side by side, T threads, N elements; whole steps, medians of {} of {:g} s.\n  \"over "
        "{}\" is the speed over that of the {} kernel. B/beam: least memory traffic per beam and scenario.\n "
        " memory %, flops %: of the peaks measured on this machine.\n",
        base::counted(options.runs, "repetition"), options.seconds, options.needs ? "bare" : "plain",
        options.needs ? "bare" : "plain");
    for (const PrecisionError& e : errors) print_precision(e);
  });
  return ExitCode::done;
}

}  // namespace

void add_bench(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("bench", "Element-steps/s and beam-steps/s of the kernels on this machine");
  const auto options = std::make_shared<BenchOptions>();
  command.add_option("--elements", options->elements, "Numbers of elements, such as 5000,20000,80000,320000")
      ->delimiter(',')
      ->check(CLI::Range(1000, 2'000'000));
  command
      .add_option(
          "--threads", options->threads,
          "Number of threads compared with one thread (default: one per CPU that this process may use)")
      ->check(CLI::Range(1, 1024));
  command.add_option("--runs", options->runs, "Repetitions of each measurement")->check(CLI::Range(1, 1000));
  command.add_option("--seconds", options->seconds, "Duration of a repetition [s]")
      ->check(CLI::Range(0.001, 100.0));
  command.add_flag("--needs", options->needs,
                   "Cost of each part that a scene may leave out (damping, corotational beams, ...)");
  CLI::Option* guard = command
                           .add_option("--guard", options->guard,
                                       "Compares each kernel's ratio to plain with those recorded in this "
                                       "file: exit 1 where one has lost a fifth")
                           ->type_name("FILE");
  command.add_flag("--record", options->record, "Records the ratios of this instruction set in that file")
      ->needs(guard);
  command.add_flag("-j,--json", options->json, "The result as JSON on stdout");
  add_quiet(command, *options);
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace rift::studio
