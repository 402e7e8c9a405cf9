#pragma once

#include <functional>
#include <vector>

namespace rift::calibration {

/// Told the fraction done in [0, 1]; answers false to give up (throws Interrupted then).
using CalibrationProgress = std::function<bool(double)>;

/// Tasks that know nothing of each other, shared out to threads, the largest first: each is done by one
/// thread from beginning to end. The first that throws ends the rest; its exception leaves.
/// @param[in] work     of each task, in any unit
/// @param[in] threads  0 for one per available CPU
/// @param[in] task     k, the thread's number from 0, and whom to tell the fraction of the task that is done
void side_by_side(
    const std::vector<double>& work, int threads, const CalibrationProgress& progress,
    const std::function<void(std::size_t k, int thread, const CalibrationProgress& tell)>& task);

}  // namespace rift::calibration
