#include "dynamics/continuous/contact_lists.hpp"

#include <algorithm>

#include "debug/check.hpp"

namespace tumble {

namespace {

// Calls visit(solver body, index of contact) for each end of a contact at a body that moves.
template <class Visitor>
void for_each_end(const Simulation& simulation, Visitor&& visit) {
    const std::vector<Contact>& contacts = simulation.contacts.all();
    for (std::uint32_t i = 0; i < contacts.size(); ++i) {
        if (contacts[i].kind != ContactKind::solid || contacts[i].manifold.point_count == 0) continue;
        for (const std::uint32_t body : {contacts[i].body_a, contacts[i].body_b}) {
            const std::uint32_t solver_body = simulation.bodies.frames[body].solver_body;
            if (solver_body != kStaticSolverBody) visit(solver_body, i);
        }
    }
}

void list_contacts(Simulation& simulation) {
    ContactLists& lists = simulation.scratch->ordered_impacts.contact_lists;
    lists.first.assign(simulation.bodies.solver_bodies.size() + 2, 0);
    for_each_end(simulation, [&](std::uint32_t body, std::uint32_t) { ++lists.first[body + 2]; });
    for (std::size_t i = 2; i < lists.first.size(); ++i) lists.first[i] += lists.first[i - 1];
    lists.contacts.resize(lists.first.back());
    for_each_end(simulation, [&](std::uint32_t body, std::uint32_t contact) {
        lists.contacts[lists.first[body + 1]++] = {simulation.contacts.all()[contact].shapes, contact};
    });
    TUMBLE_CHECK(lists.first[lists.first.size() - 2] == lists.contacts.size());
}

}  // namespace

std::span<const BodyContact> contacts_of(Simulation& simulation, std::uint32_t body) {
    ContactLists& lists = simulation.scratch->ordered_impacts.contact_lists;
    if (lists.first.empty()) list_contacts(simulation);
    const std::uint32_t solver_body = simulation.bodies.frames[body].solver_body;
    if (solver_body + 1 >= lists.first.size()) return {};
    const std::uint32_t first = lists.first[solver_body], last = lists.first[solver_body + 1];
    TUMBLE_CHECK(first <= last);
    TUMBLE_CHECK(last <= lists.contacts.size());
    return {lists.contacts.data() + first, last - first};
}

Contact* find_contact(Simulation& simulation, std::uint32_t body, ProxyPair shapes) {
    const std::span<const BodyContact> contacts = contacts_of(simulation, body);
    const auto found = std::find_if(contacts.begin(), contacts.end(),
                                    [&](const BodyContact& contact) { return contact.shapes == shapes; });
    if (found == contacts.end()) return nullptr;
    Contact& contact = simulation.contacts.all()[found->index];
    TUMBLE_CHECK(contact.shapes.a == shapes.a);
    TUMBLE_CHECK(contact.shapes.b == shapes.b);
    return &contact;
}

void clear_contact_lists(Simulation& simulation) { simulation.scratch->ordered_impacts.contact_lists.first.clear(); }

}  // namespace tumble
