// A step that has reached its working size allocates nothing: every call of operator new is counted.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/worlds.hpp"

namespace {

std::atomic<long> allocations = 0;  // other tests have threads

void* allocate(std::size_t size, std::size_t alignment) {
    ++allocations;
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    if (void* memory = std::aligned_alloc(alignment, rounded)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept try {
    return operator new(size);
} catch (const std::bad_alloc&) {
    return nullptr;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace tumble;
using namespace tumble::test;

TEST_CASE("a settled step does not allocate") {
    for (const JointSolver joints : {JointSolver::iterative, JointSolver::direct}) {
        WorldDef def;
        def.joints = joints;
        World world(def);
        add_pyramid(world, 10);
        const BodyId pivot = add_static(world, {20.0, 20.0}, make_circle(0.1f));
        const BodyId bob = add_dynamic(world, {22.0, 20.0}, make_circle(0.5f));
        world.create_joint(RevoluteJointDef{.body_a = pivot, .body_b = bob, .anchor_b = {-2.0f, 0.0f}});
        run(world, 120);
        const long before = allocations;
        run(world, 60);
        CHECK(allocations == before);
        CHECK(before > 0);
    }
}
