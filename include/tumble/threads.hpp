// The threads that make the steps of a world.
#pragma once

#include <functional>

namespace tumble {

// Calls task(i) once for each i from 0 to count - 1, in any order and on any threads, and returns when all calls have
// returned. The calls should run at the same time, but need not: a task never waits for one that has not started.
using TaskSystem = std::function<void(int count, const std::function<void(int)>& task)>;

// How many threads make a step. A world makes the same steps with any of them, bit for bit: a snapshot, a state hash
// and the events of a step do not depend on threads.
struct Threads {
    // 1: the calling thread alone. 0: one for each processor that the process may use. oneTBB gives the threads, never
    // more than there were processors when the process first used it; a library that was built without oneTBB makes all
    // steps on the calling thread.
    int count = 1;

    // Threads of the caller in place of those of oneTBB. Called several times in a step.
    TaskSystem tasks{};

    // A step on fewer awake bodies, contacts and joints than this in all runs on the calling thread alone, which is
    // faster there. 0: every step uses the threads.
    int least_work = 2000;
};

}  // namespace tumble
