// The public class.
#include "tumble/scene_run.hpp"

#include <set>

#include "scene/expressions/evaluate.hpp"
#include "scene/expressions/program.hpp"

namespace tumble {

struct Expression::Impl {
    scene::Program program;
};

namespace {

scene::Program compile_for(std::string_view text, const Scene& scene, const SceneFrame& frame,
                           std::span<const std::string> values) {
    const scene::BodyNames bodies(scene);
    const scene::JointNames joints(scene);
    const scene::KnownNames known{scene, bodies, joints, values};
    return scene::compile(text, &known, frame);
}

}  // namespace

Expression::Expression(std::string_view text, const Scene& scene, const SceneFrame& frame,
                       std::span<const std::string> values)
    : impl_(std::make_unique<Impl>(Impl{compile_for(text, scene, frame, values)})) {}
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

Expression::Kind Expression::kind() const noexcept { return impl_->program.kind(); }
double Expression::value(const SceneWorld& built, std::span<const double> values) const {
    return value(built.world, built, values);
}
double Expression::value(const World& world, const SceneWorld& built, std::span<const double> values) const {
    return scene::value_of(impl_->program, built, world, values);
}
bool Expression::holds(const SceneWorld& built) const { return scene::holds(impl_->program, built); }
double Expression::shortfall(const SceneWorld& built) const { return scene::shortfall_of(impl_->program, built); }
std::string Expression::finding(const SceneWorld& built) const { return scene::finding_of(impl_->program, built); }

std::vector<std::string> names_in_expression(std::string_view text) {
    std::set<std::string> names;
    for (const scene::NameSpan& span : scene::compile(text, nullptr).spans) names.insert(span.name);
    return {names.begin(), names.end()};
}

}  // namespace tumble
