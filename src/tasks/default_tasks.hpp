// The threads of a world whose user gives none.
#pragma once

#include "tumble/threads.hpp"

namespace tumble {

// `threads` tasks at a time on an arena of oneTBB; one after the other in a library built without oneTBB.
TaskSystem make_default_tasks(int threads);

// The number of threads that make_default_tasks() can use.
int default_thread_count();

}  // namespace tumble
