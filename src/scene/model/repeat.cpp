// Grid, pyramid and ring are formulas. Scatter draws random points and keeps those that are far enough from all points
// before (dart throwing); a grid of cells finds the near ones.
#include "scene/model/repeat.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "debug/check.hpp"
#include "scene/format/random.hpp"
#include "scene/model/turn.hpp"

namespace tumble::scene {

namespace {

constexpr int kTriesPerCopy = 1000;
constexpr double kMostCells = 1024.0;  // a side

std::vector<CopyPose> poses(const GridRepeat& grid, const CopyPose& first) {
    std::vector<CopyPose> result;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            result.push_back({first.position + DVec2(column * grid.spacing.x, row * grid.spacing.y), first.angle});
    return result;
}

std::vector<CopyPose> poses(const PyramidRepeat& pyramid, const CopyPose& first) {
    std::vector<CopyPose> result;
    for (int row = 0; row < pyramid.base; ++row)
        for (int column = 0; column < pyramid.base - row; ++column)
            result.push_back({first.position + DVec2((column + 0.5 * row) * pyramid.spacing.x, row * pyramid.spacing.y),
                              first.angle});
    return result;
}

std::vector<CopyPose> poses(const RingRepeat& ring, const CopyPose& center) {
    std::vector<CopyPose> result;
    for (int i = 0; i < ring.count; ++i) {
        const double turn = static_cast<double>(i) / ring.count;
        const SinCos direction = sin_cos(2.0 * kPi * turn);
        result.push_back({center.position + ring.radius * DVec2(direction.cos, direction.sin),
                          center.angle + (ring.turn ? 360.0 * turn : 0.0)});
    }
    return result;
}

// Points in cells at least as wide as the separation, so that only nine cells can contain a point that is too near.
class Separation {
public:
    Separation(DVec2 size, double distance) : distance_(distance) {
        cell_ = std::max({distance, size.x / kMostCells, size.y / kMostCells});
        columns_ = cell_index(size.x) + 1;
        rows_ = cell_index(size.y) + 1;
        if (distance > 0.0) cells_.resize(static_cast<std::size_t>(columns_ * rows_));
    }

    // Adds the point, relative to the lower left corner, unless it is too near to an earlier one.
    bool accept(DVec2 point) {
        if (distance_ <= 0.0) return true;
        const long column = cell_index(point.x), row = cell_index(point.y);
        for (long r = std::max(row - 1, 0L); r <= std::min(row + 1, rows_ - 1); ++r)
            for (long c = std::max(column - 1, 0L); c <= std::min(column + 1, columns_ - 1); ++c)
                for (const DVec2 other : cell(c, r))
                    if (length_sq(point - other) < distance_ * distance_) return false;
        cell(column, row).push_back(point);
        return true;
    }

private:
    long cell_index(double coordinate) const { return cell_ > 0.0 ? static_cast<long>(coordinate / cell_) : 0; }
    std::vector<DVec2>& cell(long column, long row) {
        TUMBLE_CHECK(column >= 0);
        TUMBLE_CHECK(column < columns_);
        TUMBLE_CHECK(row >= 0);
        TUMBLE_CHECK(row < rows_);
        return cells_[static_cast<std::size_t>(row * columns_ + column)];
    }

    double distance_;
    double cell_ = 0.0;
    long columns_ = 1;
    long rows_ = 1;
    std::vector<std::vector<DVec2>> cells_;
};

std::vector<CopyPose> poses(const ScatterRepeat& scatter, const CopyPose& center, Random random) {
    std::vector<CopyPose> result;
    Separation separation(scatter.size, scatter.separation);
    const DVec2 corner = center.position - 0.5 * scatter.size;
    for (int i = 0; i < scatter.count; ++i) {
        DVec2 point;
        int tries = 0;
        do {
            if (++tries > kTriesPerCopy)
                throw std::invalid_argument("found room for only " + std::to_string(i) + " of " +
                                            std::to_string(scatter.count) +
                                            " copies: enlarge 'size' or reduce 'separation'");
            point.x = random.unit() * scatter.size.x;
            point.y = random.unit() * scatter.size.y;
        } while (!separation.accept(point));
        const double turn = random.unit();
        result.push_back({corner + point, center.angle + (scatter.turn ? 360.0 * turn : 0.0)});
    }
    return result;
}

std::vector<CopyPose> pattern(const SceneBody& body, std::uint64_t seed, std::uint64_t stream) {
    const CopyPose first{body.position, body.angle};
    if (!body.repeat) return {first};
    if (const ScatterRepeat* scatter = std::get_if<ScatterRepeat>(&*body.repeat))
        return poses(*scatter, first, Random(seed, stream));
    if (const RingRepeat* ring = std::get_if<RingRepeat>(&*body.repeat)) return poses(*ring, first);
    if (const GridRepeat* grid = std::get_if<GridRepeat>(&*body.repeat)) return poses(*grid, first);
    return poses(std::get<PyramidRepeat>(*body.repeat), first);
}

struct CopyCount {
    std::int64_t operator()(const GridRepeat& grid) const { return std::int64_t{grid.columns} * grid.rows; }
    std::int64_t operator()(const PyramidRepeat& pyramid) const {
        return std::int64_t{pyramid.base} * (std::int64_t{pyramid.base} + 1) / 2;
    }
    std::int64_t operator()(const RingRepeat& ring) const { return ring.count; }
    std::int64_t operator()(const ScatterRepeat& scatter) const { return scatter.count; }
};

}  // namespace

std::int64_t copy_count(const SceneBody& body) { return body.repeat ? std::visit(CopyCount{}, *body.repeat) : 1; }

std::int64_t copy_count(const SceneJoint& joint) {
    return joint.repeat ? std::int64_t{joint.repeat->columns} * joint.repeat->rows : 1;
}

std::vector<CopyPose> copy_poses(const SceneBody& body, std::uint64_t seed, std::uint64_t stream) {
    std::vector<CopyPose> result = pattern(body, seed, stream);
    const double degrees =
        body.repeat ? std::visit([](const auto& repeat) { return repeat.angle; }, *body.repeat) : 0.0;
    if (degrees == 0.0) return result;  // rotating by 0 could change bits
    for (CopyPose& copy : result)
        copy.position = body.position + turned(copy.position - body.position, sin_cos_degrees(degrees));
    return result;
}

}  // namespace tumble::scene
