#include "python/bindings/reports.hpp"

#include "python/bindings/ids.hpp"

namespace tumble::python {

namespace {

struct ContactEntry {
    std::uint64_t body_a, body_b, shape_a, shape_b;
    double point[2];
    float normal[2];
    float separation, normal_impulse, tangent_impulse;
    std::uint32_t feature;
};

// Of contact_begins and contact_hits.
struct TouchEntry {
    std::uint64_t shape_a, shape_b;
    double point[2];
    float normal[2];
    float approach_speed;
};

struct PairEntry {
    std::uint64_t shape_a, shape_b;
};

struct SensorEntry {
    std::uint64_t sensor, visitor;
};

struct RayEntry {
    bool hit;
    std::uint64_t body, shape;
    double fraction;
    double point[2], normal[2];
};

template <class Entry, class From, class Convert>
py::array_t<Entry> list_to_array(const std::vector<From>& from, Convert&& convert) {
    py::array_t<Entry> array(static_cast<py::ssize_t>(from.size()));
    Entry* out = array.mutable_data();
    for (std::size_t i = 0; i < from.size(); ++i) out[i] = convert(from[i]);
    return array;
}

template <class Touch>
py::array_t<TouchEntry> touches_to_array(const std::vector<Touch>& touches) {
    return list_to_array<TouchEntry>(touches, [](const Touch& touch) {
        return TouchEntry{to_number(touch.shape_a),
                          to_number(touch.shape_b),
                          {touch.point.x, touch.point.y},
                          {touch.normal.x, touch.normal.y},
                          touch.approach_speed};
    });
}

py::array_t<SensorEntry> sensors_to_array(const std::vector<SensorEvent>& events) {
    return list_to_array<SensorEntry>(events, [](const SensorEvent& event) {
        return SensorEntry{to_number(event.sensor), to_number(event.visitor)};
    });
}

template <class IdType>
py::array_t<std::uint64_t> ids_to_array(const std::vector<IdType>& ids) {
    return list_to_array<std::uint64_t>(ids, [](IdType id) { return to_number(id); });
}

}  // namespace

void register_reports() {
    PYBIND11_NUMPY_DTYPE(ContactEntry, body_a, body_b, shape_a, shape_b, point, normal, separation, normal_impulse,
                         tangent_impulse, feature);
    PYBIND11_NUMPY_DTYPE(TouchEntry, shape_a, shape_b, point, normal, approach_speed);
    PYBIND11_NUMPY_DTYPE(PairEntry, shape_a, shape_b);
    PYBIND11_NUMPY_DTYPE(SensorEntry, sensor, visitor);
    PYBIND11_NUMPY_DTYPE(RayEntry, hit, body, shape, fraction, point, normal);
}

py::array to_array(const std::vector<ContactPoint>& contacts) {
    return list_to_array<ContactEntry>(contacts, [](const ContactPoint& contact) {
        return ContactEntry{to_number(contact.body_a),
                            to_number(contact.body_b),
                            to_number(contact.shape_a),
                            to_number(contact.shape_b),
                            {contact.point.x, contact.point.y},
                            {contact.normal.x, contact.normal.y},
                            contact.separation,
                            contact.normal_impulse,
                            contact.tangent_impulse,
                            contact.feature};
    });
}

py::dict to_dict(const StepEvents& events) {
    py::dict dict;
    dict["contact_begins"] = touches_to_array(events.contact_begins);
    dict["contact_hits"] = touches_to_array(events.contact_hits);
    dict["contact_ends"] = list_to_array<PairEntry>(events.contact_ends, [](const ContactEnd& end) {
        return PairEntry{to_number(end.shape_a), to_number(end.shape_b)};
    });
    dict["sensor_begins"] = sensors_to_array(events.sensor_begins);
    dict["sensor_ends"] = sensors_to_array(events.sensor_ends);
    dict["broken_joints"] = ids_to_array(events.broken_joints);
    dict["fell_asleep"] = ids_to_array(events.fell_asleep);
    return dict;
}

py::array cast_rays(const World& world, const double* origins, const double* translations, py::ssize_t count,
                    const QueryFilter& filter) {
    py::array_t<RayEntry> array(count);
    RayEntry* out = array.mutable_data();
    for (py::ssize_t i = 0; i < count; ++i) {
        const auto hit = world.cast_ray({origins[2 * i], origins[2 * i + 1]},
                                        {translations[2 * i], translations[2 * i + 1]}, filter);
        out[i] = {};
        out[i].fraction = 1.0;
        if (hit)
            out[i] = {true,          to_number(hit->body),         to_number(hit->shape),
                      hit->fraction, {hit->point.x, hit->point.y}, {hit->normal.x, hit->normal.y}};
    }
    return array;
}

}  // namespace tumble::python
