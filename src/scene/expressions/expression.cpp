// The public class.
#include "tumble/scene_run.hpp"

#include "scene/expressions/evaluate.hpp"
#include "scene/expressions/program.hpp"

namespace tumble {

struct Expression::Impl {
    scene::Program program;
};

namespace {

scene::Program compile_for(std::string_view text, const Scene& scene, const SceneFrame& frame) {
    const scene::BodyNames bodies(scene);
    const scene::JointNames joints(scene);
    const scene::KnownNames known{scene, bodies, joints};
    return scene::compile(text, &known, frame);
}

}  // namespace

Expression::Expression(std::string_view text, const Scene& scene, const SceneFrame& frame)
    : impl_(std::make_unique<Impl>(Impl{compile_for(text, scene, frame)})) {}
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

Expression::Kind Expression::kind() const noexcept { return impl_->program.kind(); }
double Expression::value(const SceneWorld& built) const { return scene::value_of(impl_->program, built); }
bool Expression::holds(const SceneWorld& built) const { return scene::holds(impl_->program, built); }
double Expression::shortfall(const SceneWorld& built) const { return scene::shortfall_of(impl_->program, built); }
std::string Expression::finding(const SceneWorld& built) const { return scene::finding_of(impl_->program, built); }

}  // namespace tumble
