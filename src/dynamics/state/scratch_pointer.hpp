// Where the stages of a step find their scratch memory: in the world's own, which is made when it is first needed, or
// in memory that the caller of the step lends.
#pragma once

#include <memory>

#include "debug/check.hpp"
#include "dynamics/state/step_scratch.hpp"

namespace tumble {

class ScratchPointer {
public:
    ScratchPointer() = default;
    ScratchPointer(const ScratchPointer&) = delete;
    ScratchPointer& operator=(const ScratchPointer&) = delete;

    StepScratch* operator->() {
        if (!used_) use_own();
        return used_;
    }
    const StepScratch* operator->() const {
        TUMBLE_CHECK(used_);
        return used_;
    }

    void use_own() {
        if (!own_) own_ = std::make_unique<StepScratch>();
        used_ = own_.get();
    }
    const StepScratch* own() const { return own_.get(); }  // null if the world has none

private:
    friend class ScratchLoan;
    std::unique_ptr<StepScratch> own_;
    StepScratch* used_ = nullptr;
};

// While it lives, a step works in the memory of the caller.
class ScratchLoan {
public:
    ScratchLoan(ScratchPointer& pointer, StepScratch& memory) : pointer_(pointer) { pointer.used_ = &memory; }
    ~ScratchLoan() { pointer_.used_ = pointer_.own_.get(); }
    ScratchLoan(const ScratchLoan&) = delete;
    ScratchLoan& operator=(const ScratchLoan&) = delete;

private:
    ScratchPointer& pointer_;
};

}  // namespace tumble
