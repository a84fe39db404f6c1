#include "python/bindings/world_box.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <list>
#include <set>

#include "python/bindings/ids.hpp"
#include "python/bindings/workers.hpp"

namespace tumble::python {

namespace {

constexpr std::chrono::milliseconds kSignalPause{50};  // between two looks for signals

template <class T>
std::span<T> entries_of(const py::array& array, std::size_t count) {
    return {static_cast<T*>(const_cast<void*>(array.data())), count};
}

}  // namespace

class WorldBox::Stepping {
public:
    explicit Stepping(WorldBox& box) : box_(box) {
        if (box.is_stepping_.exchange(true)) throw InUse("another thread is stepping this world");
        box.is_current_ = {};
    }
    ~Stepping() { box_.is_stepping_ = false; }
    Stepping(const Stepping&) = delete;
    Stepping& operator=(const Stepping&) = delete;

private:
    WorldBox& box_;
};

py::array read_only(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

void WorldBox::require_idle() const {
    if (is_stepping_) throw InUse("another thread is stepping this world");
}

const World& WorldBox::world() const {
    require_idle();
    return run_ ? run_->run.world() : *own_;
}

World& WorldBox::change() {
    require_idle();
    is_current_ = {};
    return run_ ? run_->run.world() : *own_;
}

WatchedRun& WorldBox::run() {
    require_idle();
    if (!run_) throw std::runtime_error("this world has no scene");
    return *run_;
}

void WorldBox::set_threads(int count) {
    require_idle();
    Threads threads = world().def().threads;
    threads.count = count;
    run_ ? run_->run.set_threads(threads) : own_->set_threads(threads);
}

void WorldBox::step_once() {
    if (!run_) return own_->step();
    if (run_->run.is_stopped()) return;
    run_->run.step();
    run_->watch.observe(run_->run.built());
}

void WorldBox::advance(std::int64_t count) {
    const Stepping stepping(*this);
    const py::gil_scoped_release release;
    auto looked = std::chrono::steady_clock::now();
    for (std::int64_t i = 0; i < count; ++i) {
        step_once();
        if (count == 1 || std::chrono::steady_clock::now() - looked < kSignalPause) continue;
        const py::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        looked = std::chrono::steady_clock::now();
    }
}

void WorldBox::step(std::int64_t count) {
    if (count < 0) throw std::invalid_argument("steps must be at least 0, got " + std::to_string(count));
    try {
        advance(count);
    } catch (const InUse&) {
        throw;
    } catch (...) {
        refresh_held();
        throw;
    }
    refresh_held();
}

void WorldBox::step_all(const std::vector<WorldBox*>& boxes, std::int64_t count, int threads) {
    if (count < 0) throw std::invalid_argument("steps must be at least 0, got " + std::to_string(count));
    if (threads < 1) throw std::invalid_argument("threads must be at least 1, got " + std::to_string(threads));
    const std::set<WorldBox*> different(boxes.begin(), boxes.end());
    if (different.size() != boxes.size()) throw std::invalid_argument("a world is there twice");
    if (boxes.empty()) return;
    std::vector<std::exception_ptr> errors(boxes.size());
    {
        std::list<Stepping> stepping;
        for (WorldBox* const box : boxes) stepping.emplace_back(*box);
        const py::gil_scoped_release release;
        Workers workers(std::min(threads, static_cast<int>(boxes.size())));
        workers.run(boxes.size(), 1, [&](const Part& part) {
            try {
                for (std::int64_t k = 0; k < count; ++k) boxes[part.begin]->step_once();
            } catch (...) {
                errors[part.begin] = std::current_exception();
            }
        });
    }
    for (WorldBox* const box : boxes) box->refresh_held();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

void WorldBox::refresh_held() {
    for (std::size_t i = 0; i < kQuantities; ++i)
        if (arrays_[i] && Py_REFCNT(arrays_[i].ptr()) > 1) {
            const std::span<const BodyId> bodies = world().bodies();
            if (!std::equal(bodies.begin(), bodies.end(), listed_.begin(), listed_.end())) return;
            fill(static_cast<Quantity>(i));
        }
}

void WorldBox::fill(Quantity quantity) {
    const std::size_t count = listed_.size();
    bool& is_current = is_current_[static_cast<std::size_t>(quantity)];
    if (count == 0 || is_current) return;
    is_current = true;
    const py::array& array = slot(quantity);
    switch (quantity) {
        case Quantity::position: return world().read_states({.positions = entries_of<DVec2>(array, count)});
        case Quantity::angle: return world().read_states({.angles = entries_of<double>(array, count)});
        case Quantity::velocity: return world().read_states({.velocities = entries_of<Vec2>(array, count)});
        case Quantity::angular_velocity:
            return world().read_states({.angular_velocities = entries_of<float>(array, count)});
    }
}

py::array WorldBox::array(Quantity quantity) {
    const std::span<const BodyId> bodies = world().bodies();
    if (!std::equal(bodies.begin(), bodies.end(), listed_.begin(), listed_.end())) {
        listed_.assign(bodies.begin(), bodies.end());
        arrays_ = {};
        is_current_ = {};
    }
    py::array& kept = slot(quantity);
    if (!kept || kept.size() == 0) {
        const py::ssize_t count = static_cast<py::ssize_t>(listed_.size());
        switch (quantity) {
            case Quantity::position: kept = py::array_t<double>({count, py::ssize_t{2}}); break;
            case Quantity::angle: kept = py::array_t<double>(count); break;
            case Quantity::velocity: kept = py::array_t<float>({count, py::ssize_t{2}}); break;
            case Quantity::angular_velocity: kept = py::array_t<float>(count); break;
        }
        read_only(kept);
    }
    fill(quantity);
    return kept;
}

py::array_t<std::uint64_t> WorldBox::ids() {
    const std::span<const BodyId> bodies = world().bodies();
    py::array_t<std::uint64_t> numbers(static_cast<py::ssize_t>(bodies.size()));
    std::transform(bodies.begin(), bodies.end(), numbers.mutable_data(), [](BodyId id) { return to_number(id); });
    return numbers;
}

}  // namespace tumble::python
