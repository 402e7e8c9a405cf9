#pragma once

namespace rift::viz {

// The two ways in which a drawing program is asked, until its input ends. Both throw NoOpenGl, and
// std::exception with what is wrong with the input or the run.

/// Of films: a job on the first line of the input, then a time [s] a line, each answered with a frame of raw
/// bytes (viz/job.hpp).
void answer_times();

/// Of a picture that is looked at: an order a line (viz/order.hpp).
void answer_orders();

}  // namespace rift::viz
