// Distances of shapes: single queries with their proof, traces, and batches over arrays.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "python/bindings/convert.hpp"
#include "python/bindings/module.hpp"
#include "tumble/distance.hpp"
#include "tumble/drawing.hpp"

namespace tumble::python {

namespace {

// One entry of the array of a batch.
struct BatchEntry {
    double distance, lower, upper;
    double point_a[2], point_b[2], normal[2];
    std::uint8_t status;
    std::uint16_t iterations;
};

// [n, 3] with the angle or [n, 4] with cosine and sine; one row serves all queries.
class Poses {
public:
    explicit Poses(const Doubles& array) : data_(array.data()), rows_(array.shape(0)), columns_(array.shape(1)) {}
    Pose operator[](py::ssize_t i) const {
        const double* row = data_ + (rows_ == 1 ? 0 : i) * columns_;
        const Rotation rotation =
            columns_ == 4 ? Rotation{static_cast<float>(row[2]), static_cast<float>(row[3])} : make_rotation(row[2]);
        return {{row[0], row[1]}, rotation};
    }

private:
    const double* data_;
    py::ssize_t rows_, columns_;
};

// The shapes of one side of a batch: one for all queries, or one for each. It refers to the Python objects, which a
// sequence may make on the fly and another thread may remove from a list.
class Shapes {
public:
    Shapes(const py::object& shapes, const char* name, py::ssize_t count)
        : held_(py::isinstance<Shape>(shapes) ? py::make_tuple(shapes) : py::tuple(shapes)) {
        py::detail::make_caster<Shape> caster;  // of all, as finding the type takes longer than a cast
        for (const py::handle shape : held_) {
            if (!caster.load(shape, false))
                throw py::type_error(std::string(name) + " must be a Shape or Shapes, got " +
                                     py::repr(shape).cast<std::string>());
            shapes_.push_back(static_cast<const Shape*>(caster));
        }
        if (held_.size() != 1 && static_cast<py::ssize_t>(held_.size()) != count)
            throw py::value_error(std::string(name) + " must have 1 or " + std::to_string(count) + " shapes, got " +
                                  std::to_string(held_.size()));
    }
    const Shape* operator[](py::ssize_t i) const {
        return shapes_[shapes_.size() == 1 ? 0 : static_cast<std::size_t>(i)];
    }

private:
    py::tuple held_;
    std::vector<const Shape*> shapes_;
};

void store(const DistanceResult& from, BatchEntry& to) {
    to = {from.distance,
          from.lower,
          from.upper,
          {from.point_a.x, from.point_a.y},
          {from.point_b.x, from.point_b.y},
          {from.normal.x, from.normal.y},
          static_cast<std::uint8_t>(from.status),
          from.iterations};
}

py::array_t<BatchEntry> query_batch(const py::object& shapes_a, const Doubles& poses_a, const py::object& shapes_b,
                                    const Doubles& poses_b, py::ssize_t count) {
    const Shapes a(shapes_a, "a", count), b(shapes_b, "b", count);
    py::array_t<BatchEntry> results(count);
    BatchEntry* out = results.mutable_data();
    const Poses at_a(poses_a), at_b(poses_b);
    const py::gil_scoped_release release;
    constexpr std::size_t kChunk = 256;
    std::array<PosedPair, kChunk> pairs;
    std::array<DistanceResult, kChunk> answers;
    for (py::ssize_t begin = 0; begin < count; begin += kChunk) {
        const std::size_t size = std::min<std::size_t>(kChunk, static_cast<std::size_t>(count - begin));
        for (std::size_t k = 0; k < size; ++k) {
            const py::ssize_t i = begin + static_cast<py::ssize_t>(k);
            pairs[k] = {a[i], at_a[i], b[i], at_b[i]};
        }
        distance_batch(std::span(pairs).first(size), std::span(answers).first(size));
        for (std::size_t k = 0; k < size; ++k) store(answers[k], out[begin + static_cast<py::ssize_t>(k)]);
    }
    return results;
}

py::dict certificate_dict(const Certificate& certificate) {
    py::list pairs;
    for (std::size_t i = 0; i < certificate.pair_count; ++i)
        pairs.append(py::make_tuple(certificate.pairs[i].a, certificate.pairs[i].b));
    py::dict dict;
    dict["direction"] = to_tuple(certificate.direction);
    dict["pairs"] = pairs;
    dict["cores_overlap"] = certificate.cores_overlap;
    return dict;
}

py::dict result_dict(const DistanceResult& result) {
    py::dict dict;
    dict["distance"] = result.distance;
    dict["lower"] = result.lower;
    dict["upper"] = result.upper;
    dict["point_a"] = to_tuple(result.point_a);
    dict["point_b"] = to_tuple(result.point_b);
    dict["normal"] = to_tuple(result.normal);
    dict["status"] = std::string(to_string(result.status));
    dict["iterations"] = result.iterations;
    dict["certificate"] = certificate_dict(result.certificate);
    return dict;
}

py::dict trace_of(const Shape& a, Pair position_a, double angle_a, const Shape& b, Pair position_b, double angle_b) {
    const Pose at_a = to_pose(to_dvec2(position_a), angle_a), at_b = to_pose(to_dvec2(position_b), angle_b);
    const DistanceTrace trace = trace_distance(a, at_a, b, at_b);
    py::list steps;
    for (const TraceStep& step : trace.steps) {
        py::list simplex;
        for (std::size_t i = 0; i < step.count; ++i) simplex.append(to_tuple(step.vertices[i]));
        py::dict entry;
        entry["simplex"] = simplex;
        entry["closest"] = to_tuple(step.closest);
        entry["direction"] = to_tuple(step.direction);
        entry["support"] = to_tuple(step.support_vertex);
        entry["lower"] = step.lower;
        entry["upper"] = step.upper;
        steps.append(entry);
    }
    py::dict dict;
    dict["steps"] = steps;
    dict["result"] = result_dict(trace.result);
    dict["svg"] = to_svg(draw_trace(a, at_a, b, at_b, trace));
    return dict;
}

}  // namespace

void add_distance(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(BatchEntry, distance, lower, upper, point_a, point_b, normal, status, iterations);
    module.def("distance",
               [](const Shape& a, Pair position_a, double angle_a, const Shape& b, Pair position_b, double angle_b) {
                   return result_dict(
                       distance(a, to_pose(to_dvec2(position_a), angle_a), b, to_pose(to_dvec2(position_b), angle_b)));
               });
    module.def("trace_distance", trace_of);
    module.def("distance_batch", query_batch);
}

}  // namespace tumble::python
