// Times the steps of many small worlds at once, on one thread and on several.
#pragma once

namespace tumble::tools {

struct WorldsBenchOptions {
    int worlds = 0;   // each of ten bodies
    int steps = 200;  // of each world in each run
    int runs = 3;
    int threads = 0;  // 0: one for each processor
};

struct WorldsBenchResult {
    double serial_rate = 0.0;    // steps of a world in a second of wall-clock time on one thread: median of the runs
    double parallel_rate = 0.0;  // the same on all threads
    double ratio() const { return parallel_rate / serial_rate; }
};

// The two alternate every few steps, so that changes of the machine's speed affect both alike.
WorldsBenchResult bench_worlds(const WorldsBenchOptions& options);

}  // namespace tumble::tools
