#include "studio/slurm/scripts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace rift::studio {
namespace {

/// For a shell, as it is.
std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("-_./,=+:%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string script_head(const SlurmStudy& study, const char* stage, const char* log) {
  std::string text =
      fmt::format("#!/bin/bash\n#SBATCH --job-name={}\n", shell_word("rift-" + study.name + "-" + stage));
  text += fmt::format("#SBATCH --output={}\n", shell_word((study.folder / "slurm" / log).string()));
  text += fmt::format("#SBATCH --open-mode=append\n#SBATCH --requeue\n#SBATCH --time={}\n",
                      slurm_time(study.limit_s));
  if (!study.partition.empty()) text += fmt::format("#SBATCH --partition={}\n", shell_word(study.partition));
  if (!study.extra.empty()) text += fmt::format("#SBATCH {}\n", study.extra);
  return text;
}

/// The command in the background, so that Slurm's signals reach it; where its time ran out, or it was killed,
/// the job is put into the queue again and goes on from the last checkpoint.
std::string script_body(const SlurmStudy& study, const std::string& options) {
  std::string command;
  for (const std::string& word : study.command) command += shell_word(word) + " ";
  return fmt::format(R"(
export RIFT_SIMD={}
{}--out {} --yes --quiet --threads "${{SLURM_CPUS_PER_TASK:-1}}" --budget "{:.0f} s"{} &
rift=$!
trap 'kill -TERM "$rift" 2>/dev/null' TERM INT USR1 USR2
until wait "$rift"; code=$?; ! kill -0 "$rift" 2>/dev/null; do :; done
job=$SLURM_JOB_ID
[ -z "$SLURM_ARRAY_TASK_ID" ] || job=${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID
if [ "$code" = 4 ] || {{ [ "$code" = 137 ] && [ "${{SLURM_RESTART_COUNT:-0}}" -lt 5 ]; }}; then
  scontrol requeue "$job" && sleep 60  # until Slurm ends this script
fi
exit "$code"
)",
                     study.instruction_set, command, shell_word(study.folder.string()),
                     study.limit_s - time_to_stop_s, options);
}

}  // namespace

std::string preparation_script(const SlurmStudy& study) {
  return script_head(study, "prepare", "prepare-%j.log") + script_body(study, " --prepare");
}

std::string tasks_script(const SlurmStudy& study) {
  return script_head(study, "compute", "compute-%A_%a.log") +
         fmt::format("#SBATCH --array=1-{}\n", study.tasks) +
         script_body(study, fmt::format(" --claim --tasks {}", study.tasks));
}

std::string report_script(const SlurmStudy& study) {
  return script_head(study, "report", "report-%j.log") + script_body(study, "");
}

std::string slurm_time(double seconds) {
  const auto all = static_cast<long>(std::ceil(seconds));
  const std::string clock = fmt::format("{:02}:{:02}:{:02}", all / 3600 % 24, all / 60 % 60, all % 60);
  return all < 86400 ? clock : fmt::format("{}-{}", all / 86400, clock);
}

}  // namespace rift::studio
