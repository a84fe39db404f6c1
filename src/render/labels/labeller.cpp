// Labels of a frame: the shapes are filled in the order of drawing, then each body's pixels are counted in the mask.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "render/labels/drawn_shapes.hpp"
#include "render/labels/shape_rows.hpp"
#include "render/shapes/outline_mesh.hpp"
#include "render/style/palette.hpp"
#include "render/view/checked_view.hpp"
#include "render/view/clip.hpp"
#include "tumble/recording.hpp"

namespace tumble {
namespace {

using namespace render;

// Spans of the shapes of one body, without overlaps.
void merge(std::vector<RowSpan>& spans) {
    const auto order = [](const RowSpan& span) { return std::pair{span.row, span.first}; };
    std::ranges::sort(spans, {}, order);
    std::size_t kept = 0;
    for (const RowSpan& span : spans) {
        const bool continues = kept > 0 && spans[kept - 1].row == span.row && span.first <= spans[kept - 1].last + 1;
        if (continues)
            spans[kept - 1].last = std::max(spans[kept - 1].last, span.last);
        else
            spans[kept++] = span;
    }
    spans.resize(kept);
}

void add_visible(LabelledBody& body, int row, int column) {
    if (body.visible == 0) body.first_column = body.last_column = column, body.first_row = row;
    ++body.visible;
    body.first_column = std::min(body.first_column, column);
    body.last_column = std::max(body.last_column, column);
    body.last_row = row;
}

// The bodies of a run's world that no scene describes, in the order of ids.
std::vector<BodyId> added_bodies(const SceneWorld& world) {
    std::vector<BodyId> known, added;
    for (const SceneInstance& body : world.bodies) known.push_back(body.id);
    std::ranges::sort(known);
    const std::span<const BodyId> all = world.world.bodies();
    std::set_difference(all.begin(), all.end(), known.begin(), known.end(), std::back_inserter(added));
    return added;
}

// A shape without area as the capsule that its line covers.
Shape with_area(const Shape& shape, const View& view) {
    if (shape.vertex_count() != 2 || shape.radius() > 0.0f) return shape;
    const std::array<Vec2, 2> ends{shape.vertex(0), shape.vertex(1)};
    return Shape::from_raw(ends, static_cast<float>(0.5 * line_width(view) / view.scale));
}

}  // namespace

struct Labeller::Impl {
    int width;
    int height;
    DrawnShapes shapes{};
    ShapeRows rows{};
    FrameLabels labels{};
    std::vector<RowSpan> spans{};
    std::map<BodyLabel, std::vector<RowSpan>> spans_of{};

    void collect(const World& world, const View& view) {
        shapes.clear();
        for (const BodyId body : world.bodies()) shapes.add(world, view, body, std::size_t{body.index} + 1);
    }

    void fill(const World& world, const View& view, bool keeps_spans) {
        Mask& mask = labels.mask;
        mask.width = width;
        mask.height = height;
        mask.labels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
        labels.order.clear();
        for (auto& [label, kept] : spans_of) kept.clear();
        for (const DrawnShape& drawn : shapes.sorted()) {
            spans.clear();
            rows.add(spans, view, world.shape(drawn.shape), world.state(drawn.body).pose, line_width(view));
            for (const RowSpan& span : spans)
                std::fill(pixel(span.row, span.first), pixel(span.row, span.last) + 1, drawn.label);
            if (!keeps_spans || spans.empty()) continue;
            std::vector<RowSpan>& kept = spans_of[drawn.label];
            kept.insert(kept.end(), spans.begin(), spans.end());
            labels.order.push_back({drawn.label, drawn.shape});
        }
    }

    BodyLabel* pixel(int row, int column) {
        return labels.mask.labels.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }

    // Compares the pixels of each body with what they show.
    void count(const World& world) {
        labels.bodies.clear();
        labels.covered.clear();
        std::map<std::pair<BodyLabel, BodyLabel>, std::size_t> covered;
        for (auto& [label, kept] : spans_of) {
            if (kept.empty()) continue;
            merge(kept);
            LabelledBody body{.label = label};
            for (const RowSpan& span : kept) {
                body.pixels += static_cast<std::size_t>(span.last - span.first + 1);
                for (int column = span.first; column <= span.last; ++column) {
                    const BodyLabel shown = *pixel(span.row, column);
                    if (shown == label)
                        add_visible(body, span.row, column);
                    else
                        ++covered[{shown, label}];
                }
            }
            labels.bodies.push_back(body);
        }
        for (const LabelledShape& shape : labels.order)
            std::ranges::lower_bound(labels.bodies, shape.label, {}, &LabelledBody::label)->body =
                world.body(shape.shape);
        for (const auto& [pair, pixels] : covered) labels.covered.push_back({pair.first, pair.second, pixels});
    }
};

Labeller::Labeller(int width, int height)
    : impl_(new Impl{checked_side("width", width), checked_side("height", height)}) {}

Labeller::~Labeller() = default;
Labeller::Labeller(Labeller&&) noexcept = default;
Labeller& Labeller::operator=(Labeller&&) noexcept = default;

const FrameLabels& Labeller::label(const Scene& scene, const SceneWorld& world, const Camera& camera) {
    const View view = checked_view(camera, impl_->width, impl_->height);
    const Palette palette(scene);
    std::vector<Paint> paints;
    impl_->shapes.clear();
    std::size_t label = 0;
    for (const SceneInstance& body : world.bodies) {
        ++label;
        if (!world.world.is_valid(body.id)) continue;
        paints.resize(world.world.shapes(body.id).size());
        palette.paint_body(body.source, 0, paints);
        impl_->shapes.add(world.world, view, body.id, label, paints);
    }
    for (const BodyId body : added_bodies(world)) impl_->shapes.add(world.world, view, body, ++label);
    impl_->fill(world.world, view, true);
    impl_->count(world.world);
    return impl_->labels;
}

const FrameLabels& Labeller::label(const World& world, const Camera& camera) {
    const View view = checked_view(camera, impl_->width, impl_->height);
    impl_->collect(world, view);
    impl_->fill(world, view, true);
    impl_->count(world);
    return impl_->labels;
}

const Mask& Labeller::mask(const World& world, const Camera& camera) {
    const View view = checked_view(camera, impl_->width, impl_->height);
    impl_->collect(world, view);
    impl_->fill(world, view, false);
    return impl_->labels.mask;
}

std::vector<DVec2> frame_outline(const Shape& shape, const Pose& pose, const Camera& camera, int width, int height) {
    const View view = checked_view(camera, width, height);
    std::vector<DVec2> outline = clip_polygon(view, 0.0, pixel_outline(view, with_area(shape, view), pose));
    for (DVec2& point : outline) point = {0.5 * width + point.x, 0.5 * height - point.y};
    return outline;
}

}  // namespace tumble
