// class World: stepping, bodies, shapes, joints, queries, snapshots. Ids are numbers here; the package has the objects.
#include "tumble/world.hpp"

#include "python/bindings/definitions.hpp"
#include "python/bindings/ids.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/reports.hpp"
#include "python/bindings/world_box.hpp"

namespace tumble::python {

namespace {

using Number = std::uint64_t;
using Class = py::class_<WorldBox, std::shared_ptr<WorldBox>>;

template <class IdType>
std::vector<Number> numbers_of(std::span<const IdType> ids) {
    std::vector<Number> numbers;
    for (const IdType id : ids) numbers.push_back(to_number(id));
    return numbers;
}

BodyId body(Number id) { return to_id<BodyId>(id); }
ShapeId shape(Number id) { return to_id<ShapeId>(id); }
JointId joint(Number id) { return to_id<JointId>(id); }

std::string_view bytes_of(const py::bytes& bytes) { return bytes; }

py::object hit_to_tuple(const std::optional<CastHit>& hit) {
    if (!hit) return py::none();
    return py::make_tuple(to_number(hit->body), to_number(hit->shape), hit->fraction, to_tuple(hit->point),
                          to_tuple(hit->normal), hit->starts_inside);
}

void add_whole(Class& world) {
    world.def(py::init([](const py::dict& def) { return std::make_shared<WorldBox>(World(to_world_def(def))); }))
        .def("step", &WorldBox::step)
        .def("threads", &WorldBox::threads)
        .def("set_threads", &WorldBox::set_threads)
        .def("array", [](WorldBox& box, int quantity) { return box.array(static_cast<Quantity>(quantity)); })
        .def("ids", &WorldBox::ids)
        .def("definition", [](const WorldBox& box) { return to_dict(box.world().def()); })
        .def("set_gravity", [](WorldBox& box, Pair gravity) { box.change().set_gravity(to_vec2(gravity)); })
        .def("step_count", [](const WorldBox& box) { return box.world().step_count(); })
        .def("time", [](const WorldBox& box) { return box.world().time(); })
        .def("state_hash", [](const WorldBox& box) { return box.world().state_hash(); })
        .def("contacts", [](const WorldBox& box) { return to_array(box.world().contacts()); })
        .def("contacts_of", [](const WorldBox& box, Number id) { return to_array(box.world().contacts(body(id))); })
        .def("events", [](const WorldBox& box) { return to_dict(box.world().events()); })
        .def("memory", [](const WorldBox& box) { return box.world().memory().total(); })
        .def("counts",
             [](const WorldBox& box) {
                 const StepCounters& counters = box.world().counters();
                 return py::make_tuple(box.world().bodies().size(), box.world().joints().size(), counters.contacts,
                                       counters.awake_bodies);
             })
        .def("audit", [](const WorldBox& box) { box.world().audit(); })
        .def("save",
             [](const WorldBox& box) {
                 const std::vector<std::byte> bytes = box.world().save();
                 return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
             })
        .def_static("load", [](const py::bytes& snapshot) {
            const std::string_view bytes = bytes_of(snapshot);
            return std::make_shared<WorldBox>(World::load(std::as_bytes(std::span(bytes))));
        });
}

void add_bodies(Class& world) {
    world.def("create_body",
              [](WorldBox& box, const py::dict& def) { return to_number(box.change().create_body(to_body_def(def))); });
    world.def("destroy_body", [](WorldBox& box, Number id) { box.change().destroy_body(body(id)); })
        .def("is_body", [](const WorldBox& box, Number id) { return box.world().is_valid(body(id)); })
        .def("body_definition",
             [](const WorldBox& box, Number id) { return to_dict(box.world().definition(body(id))); })
        .def("state",
             [](const WorldBox& box, Number id) {
                 const BodyState state = box.world().state(body(id));
                 return py::make_tuple(state.pose.position.x, state.pose.position.y, angle(state.pose.rotation),
                                       state.velocity.x, state.velocity.y, state.angular_velocity);
             })
        .def("type", [](const WorldBox& box, Number id) { return static_cast<int>(box.world().type(body(id))); })
        .def("mass",
             [](const WorldBox& box, Number id) {
                 const BodyMass mass = box.world().mass(body(id));
                 return py::make_tuple(mass.mass, to_tuple(mass.center), mass.inertia);
             })
        .def("velocity_at", [](const WorldBox& box, Number id,
                               Pair point) { return to_tuple(box.world().velocity_at(body(id), to_dvec2(point))); })
        .def("set_pose", [](WorldBox& box, Number id, Pair position,
                            double angle) { box.change().set_transform(body(id), to_pose(to_dvec2(position), angle)); })
        .def("set_velocity", [](WorldBox& box, Number id, Pair velocity,
                                float angular) { box.change().set_velocity(body(id), to_vec2(velocity), angular); })
        .def("move_towards",
             [](WorldBox& box, Number id, Pair position, double angle) {
                 box.change().move_towards(body(id), to_pose(to_dvec2(position), angle));
             })
        .def("apply_force",
             [](WorldBox& box, Number id, Pair force, std::optional<Pair> point) {
                 point ? box.change().apply_force(body(id), to_vec2(force), to_dvec2(*point))
                       : box.change().apply_force(body(id), to_vec2(force));
             })
        .def("apply_impulse",
             [](WorldBox& box, Number id, Pair impulse, std::optional<Pair> point) {
                 point ? box.change().apply_impulse(body(id), to_vec2(impulse), to_dvec2(*point))
                       : box.change().apply_impulse(body(id), to_vec2(impulse));
             })
        .def("apply_torque",
             [](WorldBox& box, Number id, float torque) { box.change().apply_torque(body(id), torque); })
        .def("apply_angular_impulse",
             [](WorldBox& box, Number id, float impulse) { box.change().apply_angular_impulse(body(id), impulse); })
        .def("is_awake", [](const WorldBox& box, Number id) { return box.world().is_awake(body(id)); })
        .def("set_awake", [](WorldBox& box, Number id, bool awake) { box.change().set_awake(body(id), awake); })
        .def("set_enabled", [](WorldBox& box, Number id, bool enabled) { box.change().set_enabled(body(id), enabled); })
        .def("set_type",
             [](WorldBox& box, Number id, int type) { box.change().set_type(body(id), static_cast<BodyType>(type)); })
        .def("set_bullet", [](WorldBox& box, Number id, bool bullet) { box.change().set_bullet(body(id), bullet); })
        .def("set_allow_sleep",
             [](WorldBox& box, Number id, bool allowed) { box.change().set_allow_sleep(body(id), allowed); })
        .def("set_allow_fast_rotation",
             [](WorldBox& box, Number id, bool allowed) { box.change().set_allow_fast_rotation(body(id), allowed); })
        .def("set_gravity_scale",
             [](WorldBox& box, Number id, float scale) { box.change().set_gravity_scale(body(id), scale); })
        .def("set_damping", [](WorldBox& box, Number id, float linear,
                               float angular) { box.change().set_damping(body(id), linear, angular); })
        .def("set_locks",
             [](WorldBox& box, Number id, bool x, bool y, bool rotation) {
                 box.change().set_locks(body(id), {x, y, rotation});
             })
        .def("set_mass",
             [](WorldBox& box, Number id, std::optional<std::tuple<double, Pair, double>> mass) {
                 std::optional<BodyMass> own;
                 if (mass)
                     own = BodyMass{static_cast<float>(std::get<0>(*mass)), to_vec2(std::get<1>(*mass)),
                                    static_cast<float>(std::get<2>(*mass))};
                 box.change().set_mass(body(id), own);
             })
        .def("body_user_data", [](const WorldBox& box, Number id) { return box.world().user_data(body(id)); })
        .def("set_body_user_data",
             [](WorldBox& box, Number id, Number data) { box.change().set_user_data(body(id), data); })
        .def("shapes_of", [](const WorldBox& box, Number id) { return numbers_of(box.world().shapes(body(id))); })
        .def("joints_of", [](const WorldBox& box, Number id) { return numbers_of(box.world().joints(body(id))); });
}

void add_parts(Class& world) {
    world
        .def("add_shape",
             [](WorldBox& box, Number id, const Shape& form, const py::dict& def) {
                 return to_number(box.change().add_shape(body(id), to_shape_def(form, def)));
             })
        .def("add_chain",
             [](WorldBox& box, Number id, const Doubles& points, bool loop, bool two_sided, const py::dict& def) {
                 std::vector<Vec2> corners;
                 const auto in = points.unchecked<2>();
                 for (py::ssize_t i = 0; i < in.shape(0); ++i) corners.push_back(to_float({in(i, 0), in(i, 1)}));
                 const std::vector<Shape> segments = make_chain(corners, loop);
                 const std::vector<ChainLink> links = make_chain_links(corners, loop, !two_sided);
                 std::vector<Number> ids;
                 for (std::size_t i = 0; i < segments.size(); ++i) {
                     ShapeDef shape_def = to_shape_def(segments[i], def);
                     shape_def.link = links[i];
                     ids.push_back(to_number(box.change().add_shape(body(id), shape_def)));
                 }
                 return ids;
             })
        .def("remove_shape", [](WorldBox& box, Number id) { box.change().remove_shape(shape(id)); })
        .def("is_shape", [](const WorldBox& box, Number id) { return box.world().is_valid(shape(id)); })
        .def("shape", [](const WorldBox& box, Number id) { return Shape(box.world().shape(shape(id))); })
        .def("shape_body", [](const WorldBox& box, Number id) { return to_number(box.world().body(shape(id))); })
        .def("material", [](const WorldBox& box, Number id) { return to_dict(box.world().material(shape(id))); })
        .def("set_material",
             [](WorldBox& box, Number id, const py::dict& material) {
                 box.change().set_material(shape(id), to_material(material));
             })
        .def("filter", [](const WorldBox& box, Number id) { return to_dict(box.world().filter(shape(id))); })
        .def("set_filter", [](WorldBox& box, Number id,
                              const py::dict& filter) { box.change().set_filter(shape(id), to_filter(filter)); })
        .def("is_sensor", [](const WorldBox& box, Number id) { return box.world().is_sensor(shape(id)); })
        .def("shape_user_data", [](const WorldBox& box, Number id) { return box.world().user_data(shape(id)); })
        .def("set_shape_user_data",
             [](WorldBox& box, Number id, Number data) { box.change().set_user_data(shape(id), data); })
        .def("create_joint",
             [](WorldBox& box, const std::string& kind, const py::dict& def) {
                 return to_number(box.change().create_joint(to_joint_def(kind, def)));
             })
        .def("destroy_joint", [](WorldBox& box, Number id) { box.change().destroy_joint(joint(id)); })
        .def("is_joint", [](const WorldBox& box, Number id) { return box.world().is_valid(joint(id)); })
        .def("joints", [](const WorldBox& box) { return numbers_of(box.world().joints()); })
        .def("joint",
             [](const WorldBox& box, Number id) {
                 const JointDef& def = box.world().joint(joint(id));
                 return py::make_tuple(kind_of(def), to_dict(def));
             })
        .def("change_joint",
             [](WorldBox& box, Number id, const py::dict& members) {
                 JointDef def = box.change().joint(joint(id));
                 change_joint(def, members);
                 box.change().set_joint(joint(id), def);
             })
        .def("set_motor_speed",
             [](WorldBox& box, Number id, float speed) { box.change().set_motor_speed(joint(id), speed); })
        .def("set_target",
             [](WorldBox& box, Number id, Pair target) { box.change().set_target(joint(id), to_dvec2(target)); })
        .def("joint_motion",
             [](const WorldBox& box, Number id) {
                 const JointMotion motion = box.world().joint_motion(joint(id));
                 return py::make_tuple(motion.position, motion.speed);
             })
        .def("reaction",
             [](const WorldBox& box, Number id) {
                 const JointReaction reaction = box.world().reaction(joint(id));
                 return py::make_tuple(to_tuple(reaction.force), reaction.torque);
             })
        .def("joint_anchors",
             [](const WorldBox& box, Number id) -> py::object {
                 const auto anchors = box.world().joint_anchors(joint(id));
                 if (!anchors) return py::none();
                 return py::make_tuple(to_tuple(anchors->a), to_tuple(anchors->b));
             })
        .def("joint_user_data", [](const WorldBox& box, Number id) { return box.world().user_data(joint(id)); })
        .def("set_joint_user_data",
             [](WorldBox& box, Number id, Number data) { box.change().set_user_data(joint(id), data); });
}

void add_queries(Class& world) {
    world
        .def("cast_ray",
             [](const WorldBox& box, Pair origin, Pair translation, const py::dict& filter) {
                 return hit_to_tuple(
                     box.world().cast_ray(to_dvec2(origin), to_dvec2(translation), to_query_filter(filter)));
             })
        .def("cast_ray_all",
             [](const WorldBox& box, Pair origin, Pair translation, const py::dict& filter) {
                 py::list hits;
                 for (const CastHit& hit :
                      box.world().cast_ray_all(to_dvec2(origin), to_dvec2(translation), to_query_filter(filter)))
                     hits.append(hit_to_tuple(std::optional(hit)));
                 return hits;
             })
        .def("cast_rays",
             [](const WorldBox& box, const Doubles& origins, const Doubles& translations, const py::dict& filter) {
                 return cast_rays(box.world(), origins.data(), translations.data(), origins.shape(0),
                                  to_query_filter(filter));
             })
        .def("cast_shape",
             [](const WorldBox& box, const Shape& form, Pair position, double angle, Pair translation,
                const py::dict& filter) {
                 return hit_to_tuple(box.world().cast_shape(form, to_pose(to_dvec2(position), angle),
                                                            to_dvec2(translation), to_query_filter(filter)));
             })
        .def("overlap_shape",
             [](const WorldBox& box, const Shape& form, Pair position, double angle, const py::dict& filter) {
                 const std::vector<ShapeId> found =
                     box.world().overlap_shape(form, to_pose(to_dvec2(position), angle), to_query_filter(filter));
                 return numbers_of(std::span<const ShapeId>(found));
             })
        .def("overlap_box",
             [](const WorldBox& box, Pair lower, Pair upper, const py::dict& filter) {
                 const std::vector<ShapeId> found =
                     box.world().overlap_box(to_dvec2(lower), to_dvec2(upper), to_query_filter(filter));
                 return numbers_of(std::span<const ShapeId>(found));
             })
        .def("closest",
             [](const WorldBox& box, Pair point, double max_distance, const py::dict& filter) -> py::object {
                 const auto hit = box.world().closest(to_dvec2(point), max_distance, to_query_filter(filter));
                 if (!hit) return py::none();
                 return py::make_tuple(to_number(hit->body), to_number(hit->shape), hit->distance, to_tuple(hit->point),
                                       to_tuple(hit->normal));
             })
        .def("distance", [](const WorldBox& box, Number a, Number b) {
            const BodyDistance found = box.world().distance(body(a), body(b));
            return py::make_tuple(found.nearest.distance, to_tuple(found.nearest.point_a),
                                  to_tuple(found.nearest.point_b), to_tuple(found.nearest.normal));
        });
}

}  // namespace

void add_world(py::module_& module) {
    register_reports();
    Class world(module, "World");
    add_whole(world);
    add_bodies(world);
    add_parts(world);
    add_queries(world);
    module.def("step_all", &WorldBox::step_all);
}

}  // namespace tumble::python
