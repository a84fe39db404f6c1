// The memory that a step works in.
//
// World::step() works in memory of the world's own, which the world keeps for its next step. A program that steps
// thousands of small worlds one after the other can lend them one StepMemory for each thread instead: a world is then
// half as large, and more worlds stay in the cache. Results do not depend on what it holds, so that any worlds may
// use it in any order. Two steps must not use it at the same time.
#pragma once

#include <memory>

namespace tumble {

struct StepScratch;

class StepMemory {
public:
    StepMemory();  // empty; a step makes it as large as its world needs
    ~StepMemory();
    StepMemory(StepMemory&&) noexcept;
    StepMemory& operator=(StepMemory&&) noexcept;

private:
    friend class World;
    std::unique_ptr<StepScratch> scratch_;
};

}  // namespace tumble
